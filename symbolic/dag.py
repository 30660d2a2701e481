"""Walking SymPy expressions as what they are, directed acyclic graphs: each shared node once.

The points of a de Casteljau scheme share their subexpressions. SymPy's own traversals see a tree
and visit the shared parts 2^n times; a memo keyed by identity visits each of them once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

import sympy as sp


def all_arguments(node: sp.Basic) -> tuple[sp.Basic, ...]:
    """Return what a node is built from; the default of `postorder`."""
    return node.args


def postorder(
    roots: Iterable[sp.Basic],
    arguments: Callable[[sp.Basic], tuple[sp.Basic, ...]] = all_arguments,
) -> Iterator[sp.Basic]:
    """Yield every distinct node below the roots once, arguments before the nodes that use them.

    Nodes are told apart by identity; the caller keeps the roots alive meanwhile. A reader that
    treats some nodes as leaves passes its own `arguments`.

    >>> x = sp.Symbol("x")
    >>> [str(node) for node in postorder([x + 1])]
    ['1', 'x', 'x + 1']
    """
    seen: set[int] = set()
    stack = [(root, False) for root in reversed(list(roots))]
    while stack:
        node, arguments_done = stack.pop()
        if id(node) in seen:
            continue
        below = () if arguments_done else arguments(node)
        if not below:
            seen.add(id(node))
            yield node
        else:
            stack.append((node, True))
            stack.extend((argument, False) for argument in reversed(below))


def symbols_in(expressions: Iterable[sp.Basic]) -> set[sp.Symbol]:
    """Return all symbols that occur, each shared node looked at once (`free_symbols` sees a tree).

    >>> x, y = sp.symbols("x y")
    >>> symbols_in([x + 1, 2 * x]) == {x}
    True
    """
    return {node for node in postorder(expressions) if node.is_Symbol}


def substitute(
    expressions: Iterable[sp.Expr], replacements: Mapping[sp.Symbol, sp.Expr]
) -> list[sp.Expr]:
    """Replace symbols in several expressions, keeping what they share shared.

    >>> x, y = sp.symbols("x y")
    >>> substitute([x + 1, (x + 1)*x], {x: y})
    [y + 1, y*(y + 1)]
    """
    return transformed(
        expressions, lambda old, new: replacements.get(old, new) if old.is_Symbol else new
    )


def transformed(
    expressions: Iterable[sp.Expr], change: Callable[[sp.Basic, sp.Basic], sp.Basic]
) -> list[sp.Expr]:
    """Rebuild several expressions from the leaves up; `change(old, new)` becomes the new node.

    It is given every node as it was, and as it is with its changed arguments. What expressions
    share stays shared, and what does not change stays the very same object.

    >>> x = sp.Symbol("x")
    >>> transformed([x**2 + 1], lambda old, new: new + 1 if old.is_Integer else new)
    [x**3 + 2]
    """
    roots = list(expressions)
    new: dict[int, sp.Basic] = {}
    for node in postorder(roots):
        arguments = [new[id(argument)] for argument in node.args]
        same = all(a is b for a, b in zip(arguments, node.args, strict=True))
        new[id(node)] = change(node, node if same else node.func(*arguments))
    return [new[id(root)] for root in roots]

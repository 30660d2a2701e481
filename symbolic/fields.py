"""The smallest field that holds some exact expressions, and their elements in it.

Algorithms that add and multiply many numbers do it with elements of a field (QQ, an algebraic field
such as QQ(sqrt(2)), or rational functions of the symbols) and turn only their results into
expressions: a thousand times faster than SymPy's expressions, and zero is always seen as zero.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import prod
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from .dag import postorder
from .errors import BadValue, shown
from .radicals import coprime_orders, is_radical, roots_of

HIGHEST_ALGEBRAIC_DEGREE = 8


def common_field(expressions: Iterable[sp.Expr]) -> tuple[Domain, list[Any]]:
    """Return the smallest field that holds all the expressions, and their elements.

    Symbols are free; radicals of rationals are algebraic numbers, or, where their field would have
    a degree above 8, free generators too: what holds for these holds for the numbers.
    `field.to_sympy(element)` leads back.

    Raises
    ------
    BadValue
        For functions, powers with symbols in the exponent, and division by zero.

    Examples
    --------
    >>> a = sp.Symbol("a")
    >>> common_field([sp.Integer(2), sp.Rational(1, 3)])[0]
    QQ
    >>> field, (x, y) = common_field([1 / (1 + a), sp.sqrt(2)])
    >>> field.to_sympy(x * y**2)
    2/(a + 1)
    """
    listed = list(expressions)
    if all(e.is_Rational for e in listed):
        return sp.QQ, [sp.QQ.from_sympy(e) for e in listed]
    nodes = list(postorder(listed, operands))
    for node in nodes:
        if not (node.is_Rational or node.is_Symbol or operands(node) or is_radical(node)):
            raise BadValue(
                "numbers, roots and symbols, added, multiplied and divided",
                shown(node),
                "Put a symbol in its place.",
            )
    symbols = sorted({node for node in nodes if node.is_Symbol}, key=str)
    found = coprime_orders(node for node in nodes if is_radical(node))
    field, roots = _field(tuple(symbols), tuple(found.items()))
    values: dict[int, Any] = {}
    try:
        for node in nodes:
            values[id(node)] = _element(node, [values[id(o)] for o in operands(node)], field, roots)
    except ZeroDivisionError:
        raise BadValue("finite numbers", "a division by zero", "Leave such values out.") from None
    return field, [values[id(e)] for e in listed]


def operands(node: sp.Basic) -> tuple[sp.Basic, ...]:
    """Return what a field adds, multiplies or divides to get this node; nothing for its leaves."""
    if node.is_Add or node.is_Mul:
        return node.args
    if node.is_Pow and node.exp.is_Integer:
        return (node.base,)
    return ()


def _degree(orders: Iterable[tuple[int, int]]) -> int:
    """Return the degree of independent roots together, or a bound where -1 is among the bases."""
    return prod(n if base > 0 else int(sp.totient(2 * n)) for base, n in orders)


@lru_cache(maxsize=256)
def _field(
    symbols: tuple[sp.Symbol, ...], orders: tuple[tuple[int, int], ...]
) -> tuple[Domain, dict[int, tuple[int, Any]]]:
    """Return the field, and for every base the order of its root and the root in the field."""
    roots = [sp.Pow(base, sp.Rational(1, n)) for base, n in orders]
    numbers: Any = sp.QQ
    if _degree(orders) > HIGHEST_ALGEBRAIC_DEGREE:
        field = numbers.frac_field(*symbols, *roots)
        elements = field.gens[len(symbols) :]
    else:
        numbers = numbers.algebraic_field(*roots) if roots else numbers
        field = numbers.frac_field(*symbols) if symbols else numbers
        elements = [field.convert_from(numbers.from_sympy(root), numbers) for root in roots]
    return field, {base: (n, e) for (base, n), e in zip(orders, elements, strict=True)}


def _element(
    node: sp.Basic, below: list[Any], field: Domain, roots: dict[int, tuple[int, Any]]
) -> Any:
    if node.is_Add and below:
        return sum(below[1:], below[0])
    if node.is_Mul and below:
        return prod(below[1:], start=below[0])
    if below:
        exponent = int(node.exp)
        if exponent < 0 and not below[0]:
            raise ZeroDivisionError
        return below[0] ** exponent
    if not is_radical(node):
        return field.from_sympy(node)
    rational, powers = roots_of(node, roots)
    element = field.from_sympy(rational)
    for base, exponent in powers.items():
        order, root = roots[base]
        element *= root ** int(exponent * order)
    return element

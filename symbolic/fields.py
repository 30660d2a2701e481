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
from .radicals import coprime_orders, is_nested_root, is_radical, roots_of

HIGHEST_ALGEBRAIC_DEGREE = 8


def common_field(expressions: Iterable[sp.Expr]) -> tuple[Domain, list[Any]]:
    """Return the smallest field that holds all the expressions, and their elements.

    Symbols are free; radicals of rationals are algebraic numbers, or, where their field would have
    a degree above 8, free generators too: what holds for these holds for the numbers. Nested roots,
    as in sqrt(2 + sqrt(2)), are algebraic numbers of degree at most 8 together with the others.
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
        if not (node.is_Rational or node.is_Symbol or operands(node) or _is_root(node)):
            raise BadValue(
                "numbers, roots and symbols, added, multiplied and divided",
                shown(node),
                "Put a symbol in its place.",
            )
    symbols = sorted({node for node in nodes if node.is_Symbol}, key=str)
    nested = sorted({_first_power(n) for n in nodes if is_nested_root(n)}, key=str)
    inside = [node for node in postorder(nested) if is_radical(node)]
    orders = coprime_orders([*(node for node in nodes if is_radical(node)), *inside])
    field, roots = _field(tuple(symbols), tuple(orders.items()), tuple(nested))
    values: dict[int, Any] = {}
    try:
        for node in nodes:
            values[id(node)] = _element(node, [values[id(o)] for o in operands(node)], field, roots)
    except ZeroDivisionError:
        raise BadValue("finite numbers", "a division by zero", "Leave such values out.") from None
    return field, [values[id(e)] for e in listed]


def _first_power(nested: sp.Basic) -> sp.Expr:
    """Return the root of which a nested root such as (2 + sqrt(2))**(-3/2) is a power."""
    return sp.Pow(nested.base, sp.Rational(1, nested.exp.q))


def _is_root(node: sp.Basic) -> bool:
    return is_radical(node) or is_nested_root(node)


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
    symbols: tuple[sp.Symbol, ...],
    orders: tuple[tuple[int, int], ...],
    nested: tuple[sp.Expr, ...],
) -> tuple[Domain, dict[Any, tuple[int, Any]]]:
    """Return the field; and its roots with their orders, by their bases or, if nested, as such."""
    roots = [sp.Pow(base, sp.Rational(1, n)) for base, n in orders]
    keys = [base for base, _ in orders] + list(nested)
    powers = [n for _, n in orders] + [1] * len(nested)
    numbers: Any = sp.QQ
    if _degree(orders) * prod(int(root.exp.q) for root in nested) > HIGHEST_ALGEBRAIC_DEGREE:
        _refuse_nested(nested)
        field = numbers.frac_field(*symbols, *roots)
        elements = field.gens[len(symbols) :]
    else:
        numbers = numbers.algebraic_field(*roots, *nested) if roots else numbers
        field = numbers.frac_field(*symbols) if symbols else numbers
        elements = [field.convert_from(numbers.from_sympy(x), numbers) for x in (*roots, *nested)]
    return field, dict(zip(keys, zip(powers, elements, strict=True), strict=True))


def _refuse_nested(nested: tuple[sp.Expr, ...]) -> None:
    if nested:
        raise BadValue(
            f"nested roots from a field of degree at most {HIGHEST_ALGEBRAIC_DEGREE}",
            shown(nested[0]),
            "Put a symbol in its place.",
        )


def _element(
    node: sp.Basic, below: list[Any], field: Domain, roots: dict[Any, tuple[int, Any]]
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
    if is_nested_root(node):
        return roots[_first_power(node)][1] ** int(node.exp.p)
    if not is_radical(node):
        return field.from_sympy(node)
    rational, powers = roots_of(node, (base for base in roots if isinstance(base, int)))
    element = field.from_sympy(rational)
    for base, exponent in powers.items():
        order, root = roots[base]
        element *= root ** int(exponent * order)
    return element

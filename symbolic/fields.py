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
from .radicals import is_radical, orders, prime_roots

HIGHEST_ALGEBRAIC_DEGREE = 8


def common_field(expressions: Iterable[sp.Expr]) -> tuple[Domain, list[Any]]:
    """Return the smallest field that holds all the expressions, and their elements.

    Symbols are free; radicals of rationals are algebraic numbers, or, where their field would have
    a degree above 8, the roots of primes in them are free generators too: what holds for these
    holds for the numbers. `field.to_sympy(element)` leads back.

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
    degrees = orders(node for node in nodes if is_radical(node))
    field, roots = _field(tuple(symbols), tuple(degrees.items()))
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


def degree_of_roots(degrees: Iterable[tuple[int, int]]) -> int:
    """Return the degree that roots of primes have together, or a bound if there are roots of -1."""
    return prod(n if prime > 0 else int(sp.totient(2 * n)) for prime, n in degrees)


@lru_cache(maxsize=256)
def _field(
    symbols: tuple[sp.Symbol, ...], degrees: tuple[tuple[int, int], ...]
) -> tuple[Domain, dict[int, tuple[int, Any]]]:
    """Return the field, and for every prime the order of its root and the root in the field."""
    field: Any = sp.QQ
    roots = [sp.Pow(prime, sp.Rational(1, n)) for prime, n in degrees]
    if degree_of_roots(degrees) > HIGHEST_ALGEBRAIC_DEGREE:
        field = field.frac_field(*symbols, *roots)
    else:
        if roots:
            field = field.algebraic_field(*roots)
        numbers = field
        if symbols:
            field = field.frac_field(*symbols)
        elements = [field.convert_from(numbers.from_sympy(root), numbers) for root in roots]
        return field, {p: (n, e) for (p, n), e in zip(degrees, elements, strict=True)}
    elements = field.gens[len(symbols) :]
    return field, {p: (n, e) for (p, n), e in zip(degrees, elements, strict=True)}


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
    rational, powers = prime_roots(node)
    element = field.from_sympy(rational)
    for prime, exponent in powers.items():
        order, root = roots[prime]
        element *= root ** int(exponent * order)
    return element

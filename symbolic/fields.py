"""The smallest field that holds some exact expressions, and their elements in it.

Algorithms that add and multiply many numbers do it with elements of a field (QQ, an algebraic field
such as QQ(sqrt(2)), or rational functions of the symbols) and turn only their results into
expressions: a thousand times faster than SymPy's expressions, and zero is always seen as zero.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import prod
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from .dag import postorder
from .errors import BadValue, shown

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
    generators: dict[sp.Expr, None] = {}
    radicals: dict[sp.Expr, None] = {}
    for node in postorder(listed, _operands):
        if is_radical(node):
            radicals[node] = None
        elif node.is_Symbol:
            generators[node] = None
        elif not (node.is_Rational or _operands(node)):
            raise BadValue(
                "numbers, roots and symbols, added, multiplied and divided",
                shown(node),
                "Put a symbol in its place.",
            )
    field: Any = sp.QQ
    if prod(2 if r is sp.I else int(r.exp.q) for r in radicals) > HIGHEST_ALGEBRAIC_DEGREE:
        generators |= radicals
    elif radicals:
        field = sp.QQ.algebraic_field(*radicals)
    if generators:
        field = field.frac_field(*sorted(generators, key=str))
    try:
        return field, [field.from_sympy(e) for e in listed]
    except ZeroDivisionError:
        raise BadValue("finite numbers", "a division by zero", "Leave such values out.") from None


def is_radical(node: sp.Basic) -> bool:
    """Tell whether an expression is a root of a rational number, such as sqrt(2) or I."""
    if node is sp.I:
        return True
    return bool(
        node.is_Pow and node.base.is_Rational and node.base and node.exp.is_Rational
    ) and not (node.exp.is_Integer)


def _operands(node: sp.Basic) -> tuple[sp.Basic, ...]:
    if node.is_Add or node.is_Mul:
        return node.args
    if node.is_Pow and node.exp.is_Integer:
        return (node.base,)
    return ()

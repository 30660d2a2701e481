"""Polynomials in one variable as lists of coefficients in a field, highest power first.

`sympy.polys.densearith` and `densetools` (dup_add, dup_mul, dup_eval, ...) compute with such lists.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from typing import Any

import sympy as sp
from sympy.polys.densearith import dup_add, dup_mul, dup_pow
from sympy.polys.domains.domain import Domain

from .dag import postorder, symbols_in
from .errors import BadValue, shown
from .fields import common_field, operands

Coefficients = list[Any]


def polynomials(
    expressions: Iterable[sp.Expr], variable: sp.Symbol
) -> tuple[Domain, list[Coefficients]]:
    """Return expressions as coefficients in one field; zero is the empty list.

    Raises
    ------
    BadValue
        If one is not a polynomial in the variable, or not made of numbers, roots and symbols.

    Examples
    --------
    >>> t, a = sp.symbols("t a")
    >>> field, (p, zero) = polynomials([(t + a)*t - 2, sp.S.Zero], t)
    >>> p, zero
    ([1, a, -2], [])
    """
    listed = list(expressions)
    nodes = list(postorder(listed, operands))
    varies: dict[int, bool] = {}
    for node in nodes:
        below = operands(node)
        varies[id(node)] = (
            any(varies[id(o)] for o in below) if below else variable in symbols_in([node])
        )
    inner = [o for node in nodes if varies[id(node)] for o in operands(node)]
    constants = [node for node in (*listed, *inner) if not varies[id(node)]]
    field, elements = common_field(constants)
    values: dict[int, Coefficients] = {
        id(node): [element] if element else []
        for node, element in zip(constants, elements, strict=True)
    }
    for node in nodes:
        if varies[id(node)]:
            below_values = [values[id(o)] for o in operands(node)]
            values[id(node)] = _coefficients(node, below_values, variable, field)
    return field, [values[id(e)] for e in listed]


def expression(coefficients: Sequence[Any], field: Domain, variable: sp.Expr) -> sp.Expr:
    """Return the polynomial as an expression, a sum of powers of the variable.

    >>> expression([sp.QQ(1, 2), sp.QQ(0), sp.QQ(3)], sp.QQ, sp.Symbol("t"))
    t**2/2 + 3
    """
    highest = len(coefficients) - 1
    return sp.Add(
        *(field.to_sympy(c) * variable ** (highest - k) for k, c in enumerate(coefficients) if c)
    )


def _coefficients(
    node: sp.Basic, below: list[Coefficients], variable: sp.Symbol, field: Domain
) -> Coefficients:
    if node == variable:
        return [field.one, field.zero]
    if node.is_Add:
        return reduce(lambda a, b: list(dup_add(a, b, field)), below)
    if node.is_Mul:
        return reduce(lambda a, b: list(dup_mul(a, b, field)), below)
    if below and node.exp > 0:
        return list(dup_pow(below[0], int(node.exp), field))
    raise BadValue(
        f"a polynomial in {variable}", shown(node), "Rational curves have rooms of their own."
    )

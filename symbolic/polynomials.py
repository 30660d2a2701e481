"""Polynomials in one variable as lists of coefficients in a field, highest power first.

`sympy.polys.densearith` and `densetools` (dup_add, dup_mul, dup_eval, ...) compute with such lists.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from .errors import BadValue, shown
from .fields import common_field

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
    found = [_coefficients(e, variable) for e in expressions]
    field, elements = common_field(c for row in found for c in row)
    rest = iter(elements)
    return field, [_stripped([next(rest) for _ in row]) for row in found]


def expression(coefficients: Sequence[Any], field: Domain, variable: sp.Expr) -> sp.Expr:
    """Return the polynomial as an expression, a sum of powers of the variable.

    >>> expression([sp.QQ(1, 2), sp.QQ(0), sp.QQ(3)], sp.QQ, sp.Symbol("t"))
    t**2/2 + 3
    """
    highest = len(coefficients) - 1
    return sp.Add(
        *(field.to_sympy(c) * variable ** (highest - k) for k, c in enumerate(coefficients) if c)
    )


def _coefficients(given: sp.Expr, variable: sp.Symbol) -> list[sp.Expr]:
    if variable not in given.free_symbols:
        return [given]
    try:
        return list(sp.Poly(given, variable).all_coeffs())
    except sp.PolynomialError:
        raise BadValue(
            f"a polynomial in {variable}", shown(given), "Rational curves have rooms of their own."
        ) from None


def _stripped(row: Coefficients) -> Coefficients:
    first = next((i for i, c in enumerate(row) if c), len(row))
    return row[first:]

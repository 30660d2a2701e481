"""What a curve can be asked to satisfy: values and derivatives at exact parameters."""

from __future__ import annotations

from dataclasses import dataclass
from math import perm
from typing import Any

import sympy as sp

from ..errors import BadValue, shown
from ..exact import whole_number
from .parameters import parameter_from


@dataclass(frozen=True)
class Condition:
    """The derivative of some order of a curve c at one parameter; order 0 is the value."""

    at: sp.Expr
    order: int

    def row(self, degree: int) -> list[sp.Expr]:
        """Return the condition as a row over the coefficients of t^n, ..., t, 1.

        >>> value(2).row(2), derivative(2).row(2)
        ([4, 2, 1], [4, 1, 0])
        """
        return row_of_powers(self.at, self.order, degree, sp.S.Zero, sp.S.One)

    def of(self, expression: sp.Expr, parameter: sp.Symbol) -> sp.Expr:
        """Return the condition applied to an expression, unevaluated, so that it can be read."""
        inner = sp.Derivative(expression, (parameter, self.order)) if self.order else expression
        return sp.Subs(inner, parameter, self.at)

    def __str__(self) -> str:
        primes = "'" * self.order if self.order < 4 else f"^({self.order})"
        return f"c{primes}({self.at})"


def value(at: Any) -> Condition:
    """Return the condition "the curve's point at this parameter".

    >>> print(value(0))
    c(0)
    """
    return Condition(parameter_from(at), 0)


def derivative(at: Any, order: int = 1) -> Condition:
    """Return the condition "the curve's derivative at this parameter".

    >>> print(derivative(1, order=2))
    c''(1)
    """
    whole = whole_number(order)
    if whole is None or whole < 1:
        raise BadValue(
            "a derivative of order 1, 2, 3, ...", shown(order), "For order 0 use value(at)."
        )
    return Condition(parameter_from(at), whole)


def row_of_powers(at: Any, order: int, degree: int, zero: Any, one: Any) -> list[Any]:
    """Return the derivatives of some order of t^n, ..., t, 1 at a parameter.

    For t^k it is k!/(k-r)! a^(k-r). The parameter, zero and one are elements of one field.

    >>> row_of_powers(3, 1, 2, zero=0, one=1)
    [6, 1, 0]
    """
    power, row = one, [zero] * min(order, degree + 1)
    for k in range(order, degree + 1):
        row.append(perm(k, order) * power)
        power = power * at
    return row[::-1]

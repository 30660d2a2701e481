"""What a curve can be asked to satisfy: values and derivatives at exact parameters."""

from __future__ import annotations

from dataclasses import dataclass
from math import perm
from typing import Any

import sympy as sp

from ..dag import postorder
from ..errors import BadValue, shown
from ..exact import PARAMETER, by_name, exact, whole_number


@dataclass(frozen=True)
class Condition:
    """The derivative of some order of a curve c at one parameter; order 0 is the value."""

    at: sp.Expr
    order: int

    def row(self, degree: int, at: Any = None) -> list[Any]:
        """Return the condition as a row over the coefficients of t^n, ..., t, 1.

        The k-th power contributes k!/(k-r)! a^(k-r) to the r-th derivative at a. With `at`, the
        parameter a as an element of a field, the row consists of such elements.

        >>> value(2).row(2), derivative(2).row(2)
        ([4, 2, 1], [4, 1, 0])
        """
        a = self.at if at is None else at
        power = a * 0 + 1
        row = [a * 0] * min(self.order, degree + 1)
        for k in range(self.order, degree + 1):
            row.append(perm(k, self.order) * power)
            power = power * a
        return row[::-1]

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
    return Condition(_parameter(at), 0)


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
    return Condition(_parameter(at), whole)


def _parameter(at: Any) -> sp.Expr:
    """Read a parameter of numbers, roots and symbols: of these, zero can be told for certain."""
    expression = by_name(exact(at))
    functions = [node for node in postorder([expression]) if node.is_Function or node is sp.pi]
    if functions or PARAMETER in expression.free_symbols:
        raise BadValue(
            "a parameter made of numbers, roots and other symbols than t",
            shown(at),
            "Use a rational number or a symbol such as a.",
        )
    return expression

"""Conditions at a joint: what its order of continuity asks of the next segment's control points."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import comb, perm
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..bases.bezier import bernstein
from ..exact import PARAMETER
from ..fields import common_field
from ..proofs.derivation import Derivation, Step
from .connection import Rows, chain_rows


@dataclass(frozen=True, eq=False, repr=False)
class JointConditions:
    r"""The conditions of order 0 to k at a joint of two Bezier segments of degree n.

    `parametric_continuity` and `geometric_continuity` return one.

    Attributes
    ----------
    degree, order : int
        n and k.
    betas : tuple of Expr
        The derivatives of this segment's parameter by the next one's, at the joint.

    Examples
    --------
    >>> from symbolic import parametric_continuity
    >>> print(parametric_continuity(3, 2))
    Q0 = P3
    -Q0 + Q1 = -P2 + P3
    Q0 - 2*Q1 + Q2 = P1 - 2*P2 + P3
    """

    degree: int
    order: int
    betas: tuple[sp.Expr, ...]
    derive: Callable[[JointConditions], Derivation]

    @property
    def given(self) -> tuple[sp.Symbol, ...]:
        """The control points P0, ..., Pn of this segment."""
        return tuple(sp.symbols(f"P0:{self.degree + 1}"))

    @property
    def next(self) -> tuple[sp.Symbol, ...]:
        """The control points Q0, ..., Qn of the next segment."""
        return tuple(sp.symbols(f"Q0:{self.degree + 1}"))

    @cached_property
    def conditions(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """Pairs left = right for the orders 0 to k: a difference of Qs, and what it equals.

        The j-th difference of Q0, ..., Qj is q^(j)(0) times (n-j)!/n!.
        """
        field, rows = self._differences
        ends = [difference(self.given[self.degree - i :]) for i in range(self.order + 1)]
        return tuple(
            (difference(self.next[: j + 1]), combination(map(field.to_sympy, row), ends))
            for j, row in enumerate(rows)
        )

    @cached_property
    def points(self) -> tuple[sp.Expr, ...]:
        """The control points Q0, ..., Qk in terms of P0, ..., Pn."""
        field, rows = self._differences
        return tuple(
            combination(map(field.to_sympy, _by_points(_summed(rows, j, field), field)),
                        self.given[::-1])
            for j in range(self.order + 1)
        )  # fmt: skip

    @cached_property
    def derivation(self) -> Derivation:
        """How the conditions come about; `.verify()` checks every step."""
        return self.derive(self)

    @cached_property
    def _differences(self) -> tuple[Domain, Rows]:
        """Row j: the j-th difference of the Qs in terms of the differences of the last Ps."""
        field, betas = common_field(self.betas)
        rows = [
            [m / field(perm(self.degree - i, j - i)) if i else m for i, m in enumerate(row)]
            for j, row in enumerate(chain_rows(betas, field))
        ]
        return field, rows

    def __reduce__(self) -> tuple[type, tuple[Any, ...]]:
        return type(self), (self.degree, self.order, self.betas, self.derive)  # without fields

    def __str__(self) -> str:
        return "\n".join(f"{left} = {right}" for left, right in self.conditions)

    def __repr__(self) -> str:
        return str(self)


def derivative_steps(joint: JointConditions) -> list[Step]:
    """Return the steps from derivatives at the joint to differences of control points."""
    n = joint.degree
    this, following = combination(joint.given, bernstein(n)), combination(joint.next, bernstein(n))
    steps = []
    for j in range(joint.order + 1):
        factor = sp.Integer(perm(n, j))
        what = f"derivative {j}" if j else "the point"
        last = combination([factor], [difference(joint.given[n - j :])])
        first = combination([factor], [difference(joint.next[: j + 1])])
        steps += [
            Step(derivative_at(this, j, 1), last, f"{what} where this segment ends"),
            Step(derivative_at(following, j, 0), first, f"{what} where the next one begins"),
        ]
    return steps


def derivative_at(curve: sp.Expr, order: int, at: int) -> sp.Expr:
    """Return a derivative at a parameter, unevaluated.

    >>> derivative_at(PARAMETER**2, 1, 0)
    Subs(Derivative(t**2, t), t, 0)
    """
    inner = sp.Derivative(curve, (PARAMETER, order)) if order else curve
    return sp.Subs(inner, PARAMETER, sp.Integer(at))


def solution_steps(joint: JointConditions) -> list[Step]:
    """Return the steps that the control points found satisfy every condition."""
    return [
        Step(difference(joint.points[: j + 1]), right, f"the points found satisfy {left} = {right}")
        for j, (left, right) in enumerate(joint.conditions)
        if j
    ]


def difference(points: Sequence[sp.Expr]) -> sp.Expr:
    """Return the highest difference of some points, a sum with binomial coefficients.

    >>> difference(sp.symbols("a b c"))
    a - 2*b + c
    """
    j = len(points) - 1
    weights = [sp.Integer((-1) ** (j - m) * comb(j, m)) for m in range(j + 1)]
    return combination(weights, points)


def combination(coefficients: Iterable[sp.Expr], terms: Sequence[sp.Expr]) -> sp.Expr:
    """Return a sum of coefficients times terms, with terms that are sums kept together.

    >>> a, b = sp.symbols("a b")
    >>> combination([sp.Integer(2), sp.S.One], [a + b, b])
    b + 2*(a + b)
    """
    return sp.Add(
        *(sp.Mul(c, term, evaluate=c == 1 or not (c.is_Rational and term.is_Add))
          for c, term in zip(coefficients, terms, strict=False) if c != 0)
    )  # fmt: skip


def _summed(rows: Rows, j: int, field: Domain) -> list[Any]:
    """Point j is the sum of C(j, m) times the m-th difference: the row that this gives."""
    return [
        sum((field(comb(j, m)) * rows[m][i] for m in range(i, j + 1)), field.zero)
        for i in range(j + 1)
    ]


def _by_points(row: Sequence[Any], field: Domain) -> list[Any]:
    """Go from coefficients of the differences of the last Ps to those of Pn, P_(n-1), ..."""
    return [
        sum((field((-1) ** m * comb(i, m)) * row[i] for i in range(m, len(row))), field.zero)
        for m in range(len(row))
    ]

"""The order of contact of two curves at a joint: how far a change of parameter can go.

G^k asks for a series phi(u) = phi_1 u + phi_2 u^2 + ..., phi_1 > 0, such that p(1 + phi(u)) and
q(u) agree up to u^k. Where p'(1) is not zero, phi_j follows from the terms of order j: they must
differ from what the lower phi give by a multiple of p'(1). So the order is found exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sympy.polys.domains.domain import Domain

from .connection import Rows, next_powers
from .segments import Vector


def reparametrization(
    p: Sequence[Vector], q: Sequence[Vector], field: Domain, highest: int, degree: int
) -> list[Any]:
    """Return phi_1, ..., phi_k for the largest k <= highest for which they exist.

    Parameters
    ----------
    p, q : Taylor coefficients of order 0 to `highest` at the joint, p[1] not zero
    degree : int
        The Taylor coefficients of p beyond it are zero.

    Examples
    --------
    >>> from sympy import QQ
    >>> p = [[QQ(0), QQ(0)], [QQ(1), QQ(0)], [QQ(0), QQ(1)]]   # (u, u^2)
    >>> q = [[QQ(0), QQ(0)], [QQ(2), QQ(0)], [QQ(3), QQ(4)]]   # (2u + 3u^2, 4u^2)
    >>> [int(c) for c in reparametrization(p, q, QQ, 2, 2)]
    [2, 3]
    """
    phi = [field.zero]
    powers: Rows = [[field.one]]
    for j in range(1, highest + 1):
        phi.append(field.zero)
        row = next_powers(powers, phi, field, degree)
        rest = [
            target - sum((row[i] * p[i][x] for i in range(2, len(row))), field.zero)
            for x, target in enumerate(q[j])
        ]
        factor = multiple(rest, p[1], field)
        if factor is None:
            return phi[1:-1]
        phi[j] = row[1] = factor
        powers.append(row)
    return phi[1:]


def multiple(vector: Vector, of: Vector, field: Domain) -> Any | None:
    """Return c with vector = c * of, of not zero; None if there is none."""
    pivot = next(x for x, entry in enumerate(of) if entry)
    factor = vector[pivot] / of[pivot]
    if any(a - factor * b for a, b in zip(vector, of, strict=True)):
        return None
    return factor


def first_not_zero(series: Sequence[Vector]) -> int | None:
    """Return the order of the first derivative that is not zero, None for a point."""
    return next((j for j, vector in enumerate(series) if j and any(vector)), None)

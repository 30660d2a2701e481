"""Hermite curves: positions and derivatives given at both ends."""

from __future__ import annotations

from functools import lru_cache

from ..errors import BadValue, shown
from ..exact import whole_number
from .basis import Basis
from .constraints import derivative, value
from .from_constraints import basis_from


def hermite(n: int = 3) -> Basis:
    r"""Return the Hermite basis of odd degree n, with G = (P0, P1, T0, T1, A0, A1, ...).

    The curve has the position P, tangent T, acceleration A, ... up to order (n - 1)/2 given at
    t = 0 (entries with index 0) and t = 1. For n = 3 the blending functions are
    2t^3 - 3t^2 + 1, -2t^3 + 3t^2, t^3 - 2t^2 + t and t^3 - t^2.

    Books disagree on the order of G: another common one is (P0, T0, T1, P1).

    Raises
    ------
    BadValue
        If n is not an odd positive integer.

    Examples
    --------
    >>> hermite(3).derivation.is_proved
    True
    >>> print(*hermite(5).geometry)
    P0 P1 T0 T1 A0 A1
    """
    degree = whole_number(n)
    if degree is None or degree < 1 or degree % 2 == 0:
        raise BadValue(
            "an odd degree 1, 3, 5, ...",
            shown(n),
            "Each end brings equally many constraints, so the degree is odd.",
        )
    return _hermite(degree)


@lru_cache(maxsize=32)
def _hermite(n: int) -> Basis:
    orders = range((n + 1) // 2)
    constraints = [derivative(at, r) if r else value(at) for r in orders for at in (0, 1)]
    return basis_from(constraints, name=f"Hermite basis of degree {n}")

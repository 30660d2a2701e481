"""Bezier curves: the Bernstein basis."""

from __future__ import annotations

from functools import lru_cache
from math import comb

import sympy as sp

from ..exact import PARAMETER
from ..exact_matrix import dense
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .basis import Basis, Geometry
from .degree import degree_from


def bezier(n: int) -> Basis:
    r"""Return the Bernstein basis of degree n >= 1, with G = (P0, ..., Pn).

    B_i^n(t) = C(n, i) t^i (1 - t)^(n-i); the coefficient of t^k in it is
    (-1)^(k-i) C(n, k) C(k, i).

    Raises
    ------
    BadValue
        If n is not a positive integer.

    Examples
    --------
    >>> bezier(2).functions
    (t**2 - 2*t + 1, -2*t**2 + 2*t, t**2)
    >>> bezier(3).derivation.is_proved
    True
    """
    return _bezier(degree_from(n, 1))


@lru_cache(maxsize=64)
def _bezier(n: int) -> Basis:
    rows = [
        [(-1) ** (k + i) * comb(n, k) * comb(k, i) for i in range(n + 1)] for k in range(n, -1, -1)
    ]
    geometry = tuple(Geometry(symbol, "point") for symbol in sp.symbols(f"P0:{n + 1}"))
    return Basis(f"Bernstein basis of degree {n}", geometry, dense(rows), _derivation)


def bernstein(n: int) -> tuple[sp.Expr, ...]:
    """Return the Bernstein polynomials of degree n >= 0 in product form, C(n, i) t^i (1 - t)^(n-i).

    >>> bernstein(2)
    ((1 - t)**2, 2*t*(1 - t), t**2)
    """
    t, n = PARAMETER, degree_from(n, 0)
    return tuple(sp.binomial(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1))


def _derivation(basis: Basis) -> Derivation:
    t, n = basis.parameter, basis.degree
    points = [entry.symbol for entry in basis.geometry]

    def b(i: int, r: int) -> sp.Expr:
        """Return b_i^r as a combination of control points with Bernstein weights."""
        return sp.Add(*(w * p for w, p in zip(bernstein(r), points[i:], strict=False)))

    levels = [
        Step(
            plus(times(1 - t, b(0, r - 1)),
                   times(t, b(1, r - 1))),
            b(0, r),
            f"level {r} of de Casteljau: (1 - t) and t times two points of level {r - 1}",
        )
        for r in range(2, n + 1)
    ]  # fmt: skip
    functions = sp.ImmutableMatrix([bernstein(n)])
    row = sp.ImmutableMatrix([basis.powers])
    return Derivation(
        f"{basis.name}: from de Casteljau to the matrix",
        (
            *levels,
            Step(functions, times(row, basis.matrix),
                 "the weights of the control points, collected by powers of t"),
            Step(plus(*bernstein(n)), sp.S.One,
                 "the weights sum to one, so the curve moves along with its control points"),
        ), "Farin, Curves and Surfaces for CAGD, chapters 4 and 5",
    )  # fmt: skip

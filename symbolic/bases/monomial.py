"""The monomial basis: a curve by the coefficients of 1, t, t^2, ..."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from ..exact_matrix import dense
from ..proofs.derivation import Derivation, Step
from ..written import times
from .basis import Basis, Geometry
from .constraints import derivative, value
from .degree import degree_from


def monomial(n: int) -> Basis:
    r"""Return the monomial basis of degree n >= 1, with G = (a0, a1, ..., an).

    c(t) = a0 + a1 t + ... + an t^n. The coefficient a0 = c(0) is a point of the curve, the others
    are vectors: a_k is the k-th derivative at t = 0 divided by k!, which says little about the
    shape away from 0. That is why other bases are used to design curves.

    Raises
    ------
    BadValue
        If n is not a positive integer.

    Examples
    --------
    >>> monomial(2).functions
    (1, t, t**2)
    >>> print(*monomial(2).geometry)
    a0 a1 a2
    """
    return _monomial(degree_from(n, 1))


@lru_cache(maxsize=64)
def _monomial(n: int) -> Basis:
    rows = [[int(i == k) for i in range(n + 1)] for k in range(n, -1, -1)]
    geometry = tuple(
        Geometry(symbol, "vector" if k else "point")
        for k, symbol in enumerate(sp.symbols(f"a0:{n + 1}"))
    )
    return Basis(f"monomial basis of degree {n}", geometry, dense(rows), _derivation)


def _derivation(basis: Basis) -> Derivation:
    coefficients = [entry.symbol for entry in basis.geometry]
    powers = sp.ImmutableMatrix([basis.powers])
    curve = sp.Add(*(a * p for a, p in zip(coefficients, reversed(basis.powers), strict=True)))
    return Derivation(
        f"{basis.name}: from powers to the matrix",
        (
            *(Step((derivative(0, k) if k else value(0)).of(curve, basis.parameter),
                   sp.factorial(k) * a, f"Taylor: {a} is this divided by {k}!")
              for k, a in enumerate(coefficients)),
            Step(times(powers, basis.matrix),
                 sp.ImmutableMatrix([basis.functions]),
                 "the matrix turns t^n, ..., t, 1 round, into the order of a0, ..., an"),
        ), "Farin, Curves and Surfaces for CAGD",
    )  # fmt: skip

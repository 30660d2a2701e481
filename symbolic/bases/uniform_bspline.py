"""Uniform B-splines: one segment over integer knots, as a basis of its n + 1 control points."""

from __future__ import annotations

from functools import lru_cache
from math import factorial

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from ..exact import PARAMETER
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .basis import Basis, Geometry
from .constraints import Condition
from .degree import degree_from


def uniform_bspline(n: int = 3) -> Basis:
    r"""Return the basis of a uniform B-spline segment of degree n >= 1, with G = (P0, ..., Pn).

    The knots are integers, and t in [0, 1] runs from one knot to the next. With N_0^0 = 1,
    N_i^r(t) = ((t + r - i) N_{i-1}^{r-1}(t) + (i + 1 - t) N_i^{r-1}(t)) / r, where N_i^r belongs
    to the i-th of the r + 1 control points that a segment of degree r has. The next segment takes
    P1, ..., P_{n+1}, and joins with n - 1 continuous derivatives.

    Raises
    ------
    BadValue
        If n is not a positive integer.

    Notes
    -----
    Cox 1972 and de Boor 1972: their recursion for the knots j - i, ..., in local coordinates.

    Examples
    --------
    >>> 6 * uniform_bspline().matrix
    Matrix([
    [-1,  3, -3, 1],
    [ 3, -6,  3, 0],
    [-3,  0,  3, 0],
    [ 1,  4,  1, 0]])
    >>> uniform_bspline(2).derivation.is_proved
    True
    """
    return _uniform_bspline(degree_from(n, 1))


@lru_cache(maxsize=32)
def _uniform_bspline(n: int) -> Basis:
    columns = _level(n)
    size, scale = n + 1, factorial(n)
    flat = [sp.QQ(columns[j][k], scale) for k in range(n, -1, -1) for j in range(size)]
    geometry = tuple(Geometry(symbol, "point") for symbol in sp.symbols(f"P0:{size}"))
    matrix = DomainMatrix.from_list_flat(flat, (size, size), sp.QQ).to_dense()
    return Basis(f"uniform B-spline basis of degree {n}", geometry, matrix, _derivation)


def _level(r: int) -> list[list[int]]:
    """Return r! N_0^r, ..., r! N_r^r as integer coefficients of 1, t, ..., t^r.

    >>> _level(2)
    [[1, -2, 1], [1, 2, -2], [0, 0, 1]]
    """
    if r == 0:
        return [[1]]
    below = _level(r - 1)
    level = []
    for i in range(r + 1):
        left = below[i - 1] if i > 0 else [0] * r  # times (r - i + t)
        right = below[i] if i < r else [0] * r  # times (i + 1 - t)
        constant = [(r - i) * a + (i + 1) * b for a, b in zip(left, right, strict=True)]
        raised = [a - b for a, b in zip(left, right, strict=True)]
        level.append([a + b for a, b in zip([*constant, 0], [0, *raised], strict=True)])
    return level


def _functions(r: int) -> list[sp.Expr]:
    scale = factorial(r)
    return [sp.Add(*(sp.Rational(c, scale) * PARAMETER**k for k, c in enumerate(column)))
            for column in _level(r)]  # fmt: skip


def _recursion(r: int) -> list[sp.Expr]:
    """Return the functions of level r as the recursion writes them, from those of level r - 1."""
    below = _functions(r - 1)
    t = PARAMETER
    return [
        plus(*(times((t + r - i) / r, below[i - 1]) for _ in range(i > 0)),
               *(times((i + 1 - t) / r, below[i]) for _ in range(i < r)))
        for i in range(r + 1)
    ]  # fmt: skip


def _derivation(basis: Basis) -> Derivation:
    n = basis.degree
    row, m = sp.ImmutableMatrix([basis.powers]), basis.matrix
    levels = [
        Step(sp.ImmutableMatrix([_recursion(r)]), sp.ImmutableMatrix([_functions(r)]),
             f"level {r} of the triangle of Cox and de Boor: each function from two of "
             f"level {r - 1}, times (t + {r} - i)/{r} and (i + 1 - t)/{r}")
        for r in range(1, n + 1)
    ]  # fmt: skip
    points = sp.symbols(f"P0:{n + 2}")
    first, second = sp.ImmutableMatrix(points[:-1]), sp.ImmutableMatrix(points[1:])
    end, start = (sp.ImmutableMatrix([Condition(sp.Integer(at), r).row(n) for r in range(n)])
                  for at in (1, 0))  # fmt: skip
    jump = [(-1) ** (n + 1 - i) * sp.binomial(n + 1, i) * p for i, p in enumerate(points)]
    highest = factorial(n) * m.row(0)
    return Derivation(
        f"{basis.name}: from Cox and de Boor to the matrix",
        (
            *levels,
            Step(times(row, m), sp.ImmutableMatrix([_functions(n)]),
                 "the last level, collected by powers of t, is the matrix"),
            Step(plus(*_functions(n)), sp.S.One,
                 "the functions sum to one, so the curve moves along with its control points"),
            Step(times(end, m, first),
                 times(start, m, second),
                 f"derivatives 0 ... {n - 1} at the end of a segment and at the start of the next"),
            Step(plus((highest * second)[0], times(-1, (highest * first)[0])), sp.Add(*jump),
                 f"derivative {n} jumps by a difference of order {n + 1} of the control points"),
        ), "Cox 1972; de Boor 1972",
    )  # fmt: skip

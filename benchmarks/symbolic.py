"""How fast the exact core is, side by side with SymPy's own tools and with FLINT, in one run.

Every row first checks that both sides give the same result, then times them in turn. A second
table repeats the run without FLINT, in a process of its own. Ratios above 1: we are faster.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from statistics import median
from typing import NamedTuple

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from symbolic import (
    BSpline,
    bezier,
    blossom,
    geometric_continuity,
    hermite,
    interpolating_spline,
    parametric_continuity,
    uniform_bspline,
)
from symbolic.bases import bezier as bezier_module
from symbolic.bases import hermite as hermite_module
from symbolic.bases import uniform_bspline as uniform_module
from symbolic.exact_matrix import inverse, to_matrix

t = sp.Symbol("t")
FLINT = sp.external.gmpy.GROUND_TYPES == "flint"


class Row(NamedTuple):
    """One task: what we do, and what others do for the same result."""

    name: str
    ours: Callable[[], object]
    peers: dict[str, Callable[[], object]]


def milliseconds(work: Callable[[], object], seconds: float = 0.4) -> float:
    """Return the median time of as many runs as fit, at least one."""
    times: list[float] = []
    end = time.perf_counter() + seconds
    while not times or (time.perf_counter() < end and len(times) < 200):
        start = time.perf_counter()
        work()
        times.append(1e3 * (time.perf_counter() - start))
    return median(times)


def inverse_row(name: str, matrix: sp.ImmutableMatrix) -> Row:
    """Return the row of one matrix inverted, by everybody from his own kind of matrix."""
    ours = DomainMatrix.from_Matrix(matrix).to_field().to_dense()
    mutable = matrix.as_mutable()
    assert to_matrix(inverse(ours)) == mutable.inv()
    peers = {"Matrix.inv": mutable.inv, "LUsolve": partial(mutable.LUsolve, sp.eye(matrix.rows))}
    if FLINT:
        import flint

        entries = [flint.fmpq(int(x.p), int(x.q)) for x in matrix]
        peers["FLINT"] = flint.fmpq_mat(*matrix.shape, entries).inv
    return Row(f"{name}: the inverse alone", partial(inverse, ours), peers)


def basis_row(name: str, forget: Callable[[], None], make: Callable[[], object],
              matrix: sp.ImmutableMatrix) -> Row:  # fmt: skip
    """Return the row of a whole basis, from nothing, against the inversion it is derived from."""

    def ours() -> object:
        forget()
        return make()

    return Row(f"{name}: the whole basis", ours, {"Matrix.inv": matrix.as_mutable().inv})


def bases() -> list[Row]:
    """Return the rows of bases; constraints are what their matrices are the inverses of."""
    families = [
        ("Hermite 7", hermite_module._hermite.cache_clear, partial(hermite, 7)),
        ("Hermite 21", hermite_module._hermite.cache_clear, partial(hermite, 21)),
        ("Bernstein 25", bezier_module._bezier.cache_clear, partial(bezier, 25)),
        ("uniform B-spline 15", uniform_module._uniform_bspline.cache_clear,
         partial(uniform_bspline, 15)),
    ]  # fmt: skip
    rows = []
    for name, forget, make in families:
        constraints = to_matrix(make().coefficients.inv())
        rows += [inverse_row(name, constraints), basis_row(name, forget, make, constraints)]
    return rows


def bspline_functions() -> Row:
    """Return the row of all B-splines of degree 3 over 20 knots, cold."""
    knots = list(range(20))
    ours = BSpline(knots, 3).to_piecewise()
    theirs = sp.bspline_basis_set(3, knots, t)
    at = sp.Rational(13, 2)
    assert [f.subs(t, at) for f in ours] == [f.subs(t, at) for f in theirs]

    def sympys() -> object:
        sp.core.cache.clear_cache()
        return sp.bspline_basis_set(3, knots, t)

    return Row("B-splines, degree 3, 20 knots", lambda: BSpline(knots, 3).functions,
               {"bspline_basis_set": sympys})  # fmt: skip


def blossom_row() -> Row:
    """Return the row of one value of a blossom of degree 16, against the sum over all subsets."""
    f, arguments = blossom(sum(t**k for k in range(17))), [sp.Rational(k, 17) for k in range(16)]

    def over_subsets() -> object:
        elementary = [sp.S.One] + [sp.S.Zero] * 16
        for bits in range(1, 2**16):
            chosen = [u for i, u in enumerate(arguments) if bits >> i & 1]
            elementary[len(chosen)] += sp.Mul(*chosen)
        return sp.Add(*(e / sp.binomial(16, k) for k, e in enumerate(elementary)))

    assert f(*arguments) == over_subsets()
    return Row("blossom of degree 16, one value", lambda: f(*arguments),
               {"sum over subsets": over_subsets})  # fmt: skip


def spline_row() -> Row:
    """Return the row of a cubic spline through 100 points (SymPy's has not-a-knot ends)."""
    values = [(7 * i * i) % 23 for i in range(100)]
    points = [[v] for v in values]
    theirs = sp.interpolating_spline(3, t, list(range(100)), values)
    at = sp.Rational(101, 2)
    same = interpolating_spline(points, ends="not-a-knot").pieces[50].coordinates[0]
    assert same.subs(t, at) == theirs.subs(t, at)
    return Row("natural spline through 100 points", lambda: interpolating_spline(points),
               {"interpolating_spline":
                lambda: sp.interpolating_spline(3, t, list(range(100)), values)})  # fmt: skip


def span_row() -> Row:
    """Return the row of the matrix of one cubic span with symbolic knots."""
    knots = sp.symbols("u0:8")

    def by_recursion() -> object:
        level = [sp.S.One if i == 3 else sp.S.Zero for i in range(7)]
        for p in range(1, 4):
            level = [(t - knots[i]) / (knots[i + p] - knots[i]) * level[i]
                     + (knots[i + p + 1] - t) / (knots[i + p + 1] - knots[i + 1]) * level[i + 1]
                     for i in range(7 - p)]  # fmt: skip
        u = knots[3] + (knots[4] - knots[3]) * t
        local = [sp.Poly(sp.together(f.subs(t, u)), t) for f in level]
        return sp.Matrix(4, 4, lambda i, j: sp.cancel(local[j].coeff_monomial(t ** (3 - i))))

    def ours() -> object:
        return BSpline(knots, 3).span_matrix(3)

    assert (ours() - by_recursion()).applyfunc(sp.cancel) == sp.zeros(4)
    return Row("span matrix, symbolic knots", ours, {"Poly and cancel": by_recursion})


def continuity_rows() -> list[Row]:
    """Return the rows of the conditions for C^6 and G^3, which no peer has."""
    r, betas = sp.Symbol("r"), sp.symbols("beta1:4")
    return [
        Row("conditions for C^6, degree 6", lambda: parametric_continuity(6, 6, r).points, {}),
        Row("conditions for G^3, degree 6", lambda: geometric_continuity(6, 3, betas).points, {}),
    ]


def main() -> None:
    """Print a line a task, then the same without FLINT."""
    rows = [*bases(), bspline_functions(), blossom_row(), spline_row(), span_row(),
            *continuity_rows()]  # fmt: skip
    print(f"with {sp.external.gmpy.GROUND_TYPES} numbers; ms, and ratio of the peer to ours")
    for row in rows:
        ours = milliseconds(row.ours)
        told = [f"{name} {(ms := milliseconds(work)):.4g} ({ms / ours:.3g}x)"
                for name, work in row.peers.items()]  # fmt: skip
        print(f"{row.name:36} {ours:9.4g}   {', '.join(told)}", flush=True)
    if FLINT:
        environment = os.environ | {"SYMPY_GROUND_TYPES": "python"}
        subprocess.run([sys.executable, "-m", "benchmarks.symbolic"], env=environment, check=True)


if __name__ == "__main__":
    main()

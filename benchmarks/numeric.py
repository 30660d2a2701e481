"""The numeric kernels for curves side by side with other packages, in one run.

Every way is first checked against exact values, then all of them are timed in turn; medians, in
ms. `python -m benchmarks.numeric --picture FILE` draws the ratios as well.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from numeric import Curve
from symbolic import NURBS, BSpline, circle, de_casteljau

from . import peers
from .geometry import geometry_rows
from .limits import limits
from .picture import draw
from .timing import Row, Work, medians

POINTS = 10**6
SLOW = {"geomdl": 500, "splines": 250}  # a part of the points is timed, and the time scaled up
NOT_A_PEER = "NumPy by hand"  # a few lines for this one case: what is possible, not what is offered


class Told(NamedTuple):
    """A row's times in ms."""

    name: str
    times: dict[str, float]
    at_most: float | None

    @property
    def ratio(self) -> float:
        """Our time divided by that of the fastest peer; nan without one."""
        others = [ms for who, ms in self.times.items() if who not in ("ours", NOT_A_PEER)]
        return self.times["ours"] / min(others) if others else float("nan")


def evaluation_row(
    name: str,
    ways: dict[str, peers.Evaluate | None],
    t: np.ndarray,
    exact: Callable[[Fraction], Sequence[Any]],
    at_most: float | None = None,
) -> Row:
    """Return the row of one curve at parameters t, after checking every way on some of them."""
    some = t[:: max(len(t) // 16, 1)][:16].copy()
    expected = np.array([[float(x) for x in exact(Fraction(u))] for u in some.tolist()])
    works: dict[str, Work] = {}
    factors = {}
    for who, evaluate in ways.items():
        if evaluate is None:
            continue
        found = np.asarray(evaluate(some))
        found = found if found.shape == expected.shape else found.T
        assert np.abs(found - expected).max() < 1e-12, (name, who)
        part = np.ascontiguousarray(t[:: SLOW.get(who, 1)])
        works[who] = lambda evaluate=evaluate, part=part: evaluate(part)
        factors[who] = len(t) / len(part)
    return Row(name, works, factors, at_most)


def bezier_rows(t: np.ndarray, rng: np.random.Generator) -> list[Row]:
    """Return the rows of one Bezier segment, of degree 3 and 12."""
    ends = np.array([0.0, 1.0])
    rows = []
    for degree, at_most in ((3, 0.4), (12, None)):
        points = rng.random((degree + 1, 2))
        knots = np.repeat(ends, degree + 1)
        ways = {
            "ours": Curve.from_bezier(points),
            "bezier": peers.bezier_curve(points),
            "SciPy PPoly": peers.scipy_ppoly(points[None], ends) if degree == 3 else None,
            "SciPy BSpline": peers.scipy_bspline(points, knots, degree),
            "splipy": peers.splipy_curve(points, knots, degree),
            "geomdl": peers.geomdl_curve(points, knots, degree),
            "splines": peers.splines_curve(points[None], ends) if degree == 3 else None,
            NOT_A_PEER: peers.by_hand(points) if degree == 3 else None,
        }
        name = "one cubic Bezier" if degree == 3 else f"one Bezier of degree {degree}"

        def exact(u: Fraction, points: np.ndarray = points) -> Any:
            return de_casteljau(_fractions(points), u)[-1][0]

        rows.append(evaluation_row(name, ways, t, exact, at_most))
    return rows


def segment_rows(t: np.ndarray, rng: np.random.Generator) -> list[Row]:
    """Return the rows of 1000 cubic segments over unequal breaks."""
    segments, breaks = rng.random((1000, 4, 2)), np.linspace(0, 1, 1001)
    breaks[1:-1] += rng.uniform(-0.0004, 0.0004, 999)

    def exact(u: Fraction) -> Any:
        i = min(int(np.searchsorted(breaks, float(u), side="right")) - 1, 999)
        a, b = (Fraction(x) for x in breaks[i : i + 2].tolist())
        return de_casteljau(_fractions(segments[i]), (u - a) / (b - a))[-1][0]

    ways = {
        "ours": Curve.from_bezier(segments, breaks),
        "SciPy PPoly": peers.scipy_ppoly(segments, breaks),
    }
    return [
        evaluation_row("1000 cubic segments, sorted t", ways, np.sort(t), exact, 0.9),
        evaluation_row("1000 cubic segments, unsorted t", ways, t, exact, 0.25),
    ]


def bspline_rows(t: np.ndarray, rng: np.random.Generator) -> list[Row]:
    """Return the rows of a cubic B-spline over 100 unequal knots."""
    inner = np.sort(rng.random(92))
    knots = np.concatenate([np.zeros(4), inner, np.ones(4)])
    points = rng.random((96, 2))
    spline = BSpline(_fractions(knots[None])[0], 3)
    rows = _fractions(points)

    def exact(u: Fraction) -> Any:
        return spline.de_boor(rows, u)[-1][0]

    ways = {
        "ours": Curve.from_bspline(points, knots, 3),
        "SciPy BSpline": peers.scipy_bspline(points, knots, 3),
        "splipy": peers.splipy_curve(points, knots, 3),
        "geomdl": peers.geomdl_curve(points, knots, 3),
    }
    return [
        evaluation_row("B-spline, 100 knots, sorted t", ways, np.sort(t), exact, 0.4),
        evaluation_row("B-spline, 100 knots, unsorted t", ways, t, exact, 0.2),
    ]


def circle_rows(t: np.ndarray) -> list[Row]:
    """Return the rows of the NURBS circle of four quarters."""
    w = 0.5**0.5
    points = np.array(
        [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]], float
    )
    weights = np.array([1, w] * 4 + [1])
    knots = np.repeat([0, 0.25, 0.5, 0.75, 1], [3, 2, 2, 2, 3])
    homogeneous = np.column_stack([points * weights[:, None], weights])
    exact_circle: NURBS = circle()
    ways = {
        "ours": Curve.from_bspline(points, knots, 2, weights),
        "SciPy by hand": peers.scipy_nurbs(homogeneous, knots, 2),
        "splipy": peers.splipy_curve(homogeneous, knots, 2, rational=True),
        "nurbspy": peers.nurbspy_curve(points, weights, knots, 2),
        "geomdl": peers.geomdl_curve(points, knots, 2, weights),
    }

    def exact(u: Fraction) -> Any:
        return exact_circle.de_boor(u).points[-1][0]

    return [
        evaluation_row("NURBS circle, sorted t", ways, np.sort(t), exact, 0.6),
        evaluation_row("NURBS circle, unsorted t", ways, t, exact, 0.6),
    ]


def _fractions(rows: np.ndarray) -> list[list[Fraction]]:
    return [[Fraction(x) for x in row] for row in rows.tolist()]


def rows(points: int) -> list[Row]:
    """Return all rows, for this number of parameters."""
    rng = np.random.default_rng(0)
    t = rng.random(points)
    return [
        *bezier_rows(t, rng),
        *segment_rows(t, rng),
        *bspline_rows(t, rng),
        *circle_rows(t),
        *geometry_rows(max(points // 1000, 1), rng),
    ]


def tell(row: Row, seconds: float) -> Told:
    """Return the times of a row."""
    times = medians(row.works, seconds)
    scaled = {who: ms * row.factors.get(who, 1) for who, ms in times.items()}
    return Told(row.name, scaled, row.at_most)


def table(told: Sequence[Told]) -> str:
    """Return the rows as a table in Markdown."""
    lines = ["| work | ours, ms | others, ms | ratio | aim |", "| --- | --- | --- | --- | --- |"]
    for row in told:
        others = sorted((ms, who) for who, ms in row.times.items() if who != "ours")
        listed = ", ".join(f"{who} {ms:.4g}" for ms, who in others) or "none"
        ratio = "" if np.isnan(row.ratio) else f"{row.ratio:.2g}"
        aim = "" if row.at_most is None else f"{row.at_most:g}"
        lines.append(f"| {row.name} | {row.times['ours']:.3g} | {listed} | {ratio} | {aim} |")
    return "\n".join(lines)


def main() -> None:
    """Print the table and the limits."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--points", type=int, default=POINTS, help="parameters a row")
    parser.add_argument("--seconds", type=float, default=1.5, help="for every way of a row")
    parser.add_argument("--picture", help="file for a picture of the ratios, such as a.png")
    options = parser.parse_args()
    told = [tell(row, options.seconds) for row in rows(options.points)]
    print(table(told), end="\n\n")
    for line in limits(options.points):
        print(line, flush=True)
    if options.picture:
        draw([(row.name, row.times) for row in told], options.picture)


if __name__ == "__main__":
    main()

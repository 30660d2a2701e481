"""Knot insertion: Boehm's algorithm step by step, each point with its blossom label."""

from __future__ import annotations

from typing import Any

import sympy as sp

from symbolic import BSpline, de_casteljau

from ..figure import Figure
from ..scene import Scene
from .bspline import POINTS, de_boor_levels
from .control_points import so_many_points

KNOTS = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]
DEGREE, SPAN = 3, 4  # the new knot lies in [u_4, u_5] = [1, 2]
STEPS = (
    "A cubic B-spline over 0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4. Every control point is f of 3 knots.",
    "t inserted once: three new points replace two old ones; the curve stays.",
    "Inserted twice: f(1, t, t) and f(t, t, 2).",
    "Three times: f(t, t, t) is the point of the curve, and the polygon touches it there.",
    "Every inner knot three times: the Bezier points of all four spans.",
)


def knot_insertion(points: Any = POINTS, t: Any = 1.5) -> Figure:
    """Explore Boehm's knot insertion: the old and the new polygon, and on to the Bezier points.

    Parameters
    ----------
    points : rows, shape (7, 2)
    t : number in [1, 2], the new knot

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, or not seven.

    Examples
    --------
    >>> fig = knot_insertion()
    >>> len(fig.scene["steps"])
    5
    """
    rows = so_many_points(points, 7, "seven control points", "They go with eleven knots.")
    scene = Scene(
        "Knot insertion",
        "A cubic B-spline curve, its control polygon, and the polygon after a knot t between 1 and "
        "2 is inserted once, twice and three times; last, the Bezier points of every span.",
    )
    labels = [_label(*KNOTS[i + 1 : i + 4]) for i in range(7)]
    d = scene.points(rows, name="d", labels=labels)
    knot = scene.slider("t", 1, 2, value=t, snap=0.125)
    scene.steps(STEPS)
    u, bezier = sp.Symbol("u"), BSpline(KNOTS, DEGREE).to_bezier(d)
    segments = [de_casteljau(segment.points, u)[-1][0] for segment in bezier]
    scene.curve(segments, (u, 0, 1), samples=33, width=3)
    scene.polyline(d, color="muted")
    levels = de_boor_levels(d, KNOTS, SPAN, knot)
    for k in range(1, DEGREE + 1):
        _inserted(scene, d, levels, k)
    all_points = [point for segment in bezier for point in segment.points]
    scene.polyline(all_points, pieces=[4] * 4, since=4)
    scene.dots(all_points, ["construction"] * 16, since=4)
    _ask(scene, levels)
    return Figure(scene)


def _label(*arguments: Any) -> str:
    return f"f({','.join(map(str, arguments))})"


def _inserted(scene: Scene, d: Any, levels: Any, k: int) -> None:
    """Draw the polygon with t inserted k times: the border of de Boor's triangle."""
    first, last = SPAN - DEGREE, SPAN
    left = [levels[r][0] for r in range(k)]
    right = [levels[r][-1] for r in range(k - 1, -1, -1)]
    polygon = [*d[:first], *left, *levels[k], *right, *d[last + 1 :]]
    scene.polyline(polygon, color="accent", width=3, since=k, until=k)
    knots = KNOTS[first + k + 1 :]
    labels = [_label(*knots[j : j + DEGREE - k], *("t" * k)) for j in range(len(levels[k]))]
    scene.dots(levels[k], ["curve" if k == DEGREE else "accent"] * len(labels), labels,
               radius=5, since=k, until=3)  # fmt: skip


def _ask(scene: Scene, levels: Any) -> None:
    _, old, next_old, _ = levels[0]

    def between(share: Any) -> list[Any]:
        return [(1 - share) * x + share * y for x, y in zip(old, next_old, strict=True)]

    t = sp.Symbol("t")
    scene.question(
        "Before you step on: where will f(1,2,t) stand, between f(0,1,2) and f(1,2,3)? "
        "Type (x, y).", levels[1][1], until=0,
        mistakes={"That divides the leg as t divides [1, 2]; it must be as t divides [0, 3].":
                      between(t - 1),
                  "The wrong way round: f(1,2,0) belongs to t = 0, f(1,2,3) to t = 3.":
                      between((3 - t) / 3),
                  "That divides the leg as t divides the whole domain [0, 4].": between(t / 4)},
        hint="Not yet. f is affine in its last argument: at 0 it is f(0,1,2), at 3 f(1,2,3).",
    )  # fmt: skip
    scene.question(
        "And f(t,t,t) for the t as it stands? Type (x, y).", levels[3][0], since=1, until=2,
        mistakes={"That is f(1,t,t): go on from it to f(2,t,t).": levels[2][0]},
        hint="Not yet. It divides f(1,t,t), f(2,t,t) as t divides [1, 2].",
    )  # fmt: skip
    scene.question(
        "How many knots must be inserted until every inner knot is threefold?", 6, since=3,
        mistakes={"That is only one of the three inner knots.": 2,
                  "Each is there once already.": 9},
        hint="Not yet. Each inner knot, 1, 2 and 3, is there once.",
    )  # fmt: skip

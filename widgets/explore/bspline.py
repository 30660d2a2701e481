"""Cubic B-splines over draggable knots: basis functions, active span, de Boor's triangle."""

from __future__ import annotations

from typing import Any

import sympy as sp

from numeric import quotient_or_zero as ratio

from ..figure import Figure
from ..scene import Scene
from .control_points import so_many_points

POINTS = ((0, 0), (0.5, 3), (2.5, 4), (4, 1), (6, 0), (7.5, 3), (9, 1))
KNOTS = (1, 2, 3)
END = 4
DEGREE = 3
# A parameter at the very end of the domain would lie in no half-open span.
INSIDE = 1 - sp.Rational(1, 2**40)
STEPS = (
    "Seven control points and the knots 0, 0, 0, 0, u_4, u_5, u_6, 4, 4, 4, 4. Drag the knots.",
    "The active span decides: four control points take part. De Boor, first level: d_i^1.",
    "Second level: d_i^2.",
    "Third level: d_i^3 is the point c(t).",
)


def bspline(points: Any = POINTS, t: Any = 2.5) -> Figure:
    """Explore a cubic B-spline curve: drag control points and knots, and step through de Boor.

    Knots that are dragged past each other stay together: a knot's multiplicity grows instead.

    Parameters
    ----------
    points : rows, shape (7, 2)
    t : number in [0, 4]

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, or not seven.

    Examples
    --------
    >>> fig = bspline()
    >>> sorted(fig.values)
    ['d', 'step', 't', 'u']
    """
    rows = so_many_points(points, 7, "seven control points", "Three inner knots go with them.")
    scene = Scene(
        "B-spline and its knots",
        "A cubic B-spline curve with seven control points, its basis functions over three "
        "draggable inner knots, and the points of de Boor's algorithm at t.",
    )
    d = scene.points(rows, name="d")
    basis = scene.view(
        "basis", (-0.3, END + 0.3), (-0.42, 1.05), title="Basis functions N_i^3 and knots"
    )
    handles = scene.points([(u, -0.12 * (1 + i % 3)) for i, u in enumerate(KNOTS)], name="u",
                           labels=["u_4", "u_5", "u_6"], colors=["construction"] * 3, snap=0.125,
                           view=basis, along="x")  # fmt: skip
    slider = scene.slider("t", 0, END, value=t, snap=0.0625)
    scene.steps(STEPS, first=3)
    knots = _knots(handles)
    u = sp.Symbol("u at")
    functions = _functions(knots, u * INSIDE)
    scene.polyline(d)
    scene.curve(_combined(functions, d), (u, 0, END), samples=257, width=3)
    for i, function in enumerate(functions):
        scene.curve((u, function), (u, 0, END), samples=257, color=i, view=basis)
    _triangle(scene, d, knots, slider * INSIDE)
    now = _functions(knots, slider * INSIDE)
    for i, function in enumerate(now):
        scene.dots([(slider, function)], [i], radius=3, view=basis)
    scene.weights(now, [f"N_{i}^3" for i in range(7)], title="Share of every control point in c(t)")
    scene.readout("c(t)", _combined(now, d))
    _ask(scene)
    return Figure(scene)


def _knots(handles: Any) -> list[Any]:
    """Return all knots; the inner ones never fall, and stay in the domain."""
    inner: list[Any] = []
    for x, _ in handles:
        inner.append(sp.Min(sp.Max(x, inner[-1] if inner else 0), END))
    return [0] * (DEGREE + 1) + inner + [END] * (DEGREE + 1)


def _indicator(knots: list[Any], i: int, u: Any) -> Any:
    """Return 1 on [u_i, u_{i+1}), else 0."""
    return sp.Heaviside(u - knots[i], 1) - sp.Heaviside(u - knots[i + 1], 1)


def _functions(knots: list[Any], u: Any) -> list[Any]:
    """Return the basis functions by the Cox-de Boor recurrence, with 0/0 = 0."""
    level = [_indicator(knots, i, u) for i in range(len(knots) - 1)]
    for p in range(1, DEGREE + 1):
        level = [
            ratio(u - knots[i], knots[i + p] - knots[i]) * level[i]
            + ratio(knots[i + p + 1] - u, knots[i + p + 1] - knots[i + 1]) * level[i + 1]
            for i in range(len(level) - 1)
        ]
    return level


def _combined(functions: list[Any], points: Any) -> list[Any]:
    return [
        sum(f * x for f, x in zip(functions, xs, strict=True)) for xs in zip(*points, strict=True)
    ]


def _triangle(scene: Scene, d: Any, knots: list[Any], u: Any) -> None:
    """Draw de Boor's points of the active span: those of every span, where it is the active one."""
    spans = range(DEGREE, len(d))
    levels = [de_boor_levels(d, knots, s, u) for s in spans]
    active = [_indicator(knots, s, u) for s in spans]
    for r in range(1, DEGREE + 1):
        points = [
            _combined(active, [level[r][j] for level in levels]) for j in range(DEGREE + 1 - r)
        ]
        if len(points) > 1:
            scene.polyline(points, since=r)
        last = r == DEGREE
        scene.dots(points, ["curve" if last else "construction"] * len(points),
                   ["c(t)"] if last else None, radius=6 if last else 4, since=r)  # fmt: skip


def de_boor_levels(d: Any, knots: list[Any], span: int, u: Any) -> list[list[list[Any]]]:
    """Return the levels of de Boor's triangle for u in [knots[span], knots[span + 1]]."""
    levels = [[list(d[span - DEGREE + j]) for j in range(DEGREE + 1)]]
    for r in range(1, DEGREE + 1):
        level = []
        for j in range(DEGREE + 1 - r):
            low, high = knots[span - DEGREE + j + r], knots[span + j + 1]
            a = ratio(u - low, high - low)
            one, other = levels[-1][j], levels[-1][j + 1]
            level.append([(1 - a) * x + a * y for x, y in zip(one, other, strict=True)])
        levels.append(level)
    return levels


def _ask(scene: Scene) -> None:
    scene.question(
        "For the knots 0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4: between which knots is N_2^3 not zero? "
        "Type two numbers.", [0, 3], until=0,
        mistakes={"That is one span; a cubic basis function lives on four.": [2, 3],
                  "N_2^3 starts at u_2 and ends at u_6; the first knot is u_0.": [0, 2]},
        hint="Not yet. N_i^p lives on [u_i, u_{i+p+1}].",
    )  # fmt: skip
    scene.question(
        "Drag u_4 onto u_5. How often is the curve now continuously differentiable there?", 1,
        since=1, until=1,
        mistakes={"That is right for a simple knot: degree 3 minus multiplicity 1.": 2,
                  "The degree stays 3. Only the continuity drops, by one.": 0},
        hint="Not yet. Degree minus multiplicity.",
    )  # fmt: skip
    scene.question(
        "How many control points move c(t) at a t inside a span?", 4, since=2,
        mistakes={"That is the degree. One more takes part.": 3,
                  "Local control: far control points do not move it.": 7},
        hint="Not yet. Look at the shares of the control points.",
    )  # fmt: skip

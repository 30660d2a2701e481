"""Rational quadratics: weights, the conic they make, and its projection to the line w = 1."""

from __future__ import annotations

from typing import Any

import sympy as sp

from symbolic import bernstein, de_casteljau

from ..figure import Figure
from ..scene import Scene
from .control_points import so_many_points, unit_parameter

CONIC = ((6, 0), (4, 4), (1, 1))
STEPS = (
    "The curve sum w_i B_i^2(t) P_i / w(t), with w(t) = sum w_i B_i^2(t).",
    "Seen along y: control points w_i (P_i, 1), a plain Bezier curve, and rays to w = 1.",
    "An ellipse while w_1^2 < w_0 w_2, a parabola where they are equal, beyond it a hyperbola.",
)
Homogeneous = list[tuple[Any, Any, Any]]


def rational(points: Any = CONIC, t: Any = 0.5) -> Figure:
    """Explore rational quadratic Bezier curves: drag points and weights, and see the projection.

    Parameters
    ----------
    points : rows, shape (3, 2)
    t : number in [0, 1]

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, or not three.

    Examples
    --------
    >>> fig = rational()
    >>> sorted(fig.values)
    ['P', 'step', 't', 'w0', 'w1', 'w2']
    """
    rows = so_many_points(points, 3, "three control points", "A conic has degree 2.")
    scene = Scene(
        "Rational quadratics and conics",
        "A rational quadratic Bezier curve with its weights, and beside it the curve of "
        "homogeneous points seen along y, projected from the origin to the line w = 1.",
    )
    scene.steps(STEPS)
    p = scene.points(rows, name="P")
    weights = [
        scene.slider(f"w{i}", 0, 4, value=w, snap=0.125, label=f"w_{i}")
        for i, w in enumerate((1, 2, 1))
    ]
    parameter = scene.slider("t", 0, 1, value=unit_parameter(t))
    lifted = [(w * x, w * y, w) for w, (x, y) in zip(weights, p, strict=True)]
    _plane(scene, p, lifted, parameter)
    _side(scene, rows, p, lifted, parameter)
    functions = [f.subs(sp.Symbol("t"), parameter) for f in bernstein(2)]
    total = sum(w * f for w, f in zip(weights, functions, strict=True))
    shares = [w * f / total for w, f in zip(weights, functions, strict=True)]
    scene.weights(shares, ["P_0", "P_1", "P_2"], title="Share of every control point in c(t)")
    scene.statement("A parabola, w_1^2 = w_0 w_2", weights[1] ** 2 - weights[0] * weights[2])
    scene.readout("c(t)", _projected(_point(lifted, parameter)))
    _ask(scene, p, weights, lifted)
    return Figure(scene)


def _point(lifted: Homogeneous, t: Any) -> Any:
    return de_casteljau(lifted, t)[-1][0]


def _projected(point: Any) -> list[Any]:
    x, y, w = point
    return [x / w, y / w]


def _plane(scene: Scene, p: Any, lifted: Homogeneous, t: sp.Symbol) -> None:
    scene.polyline(p)
    scene.curve(de_casteljau(p, t)[-1][0], t, color="muted", width=2, dashed=True)
    scene.curve(_projected(_point(lifted, t)), t, width=3)
    scene.dots([_projected(_point(lifted, t))], ["curve"], ["c(t)"], radius=6)


def _side(scene: Scene, rows: Any, p: Any, lifted: Homogeneous, t: sp.Symbol) -> None:
    """Draw x and w: the homogeneous curve, and how rays from the origin take it to w = 1."""
    low, high = 2 * min(0, *rows[:, 0]), 2 * max(0, *rows[:, 0])
    room = (high - low or 1) / 12
    xs = low - room, high + room
    side = scene.view("side", xs, (-0.25, 2.5), title="x and w, seen along y")
    seen = [(x, w) for x, _, w in lifted]
    x, _, w = _point(lifted, t)
    look: dict[str, Any] = {"view": side}
    scene.polyline([(x, 1) for x in xs], color="muted", **look)
    scene.polyline(seen, **look)
    scene.curve((x, w), t, color="construction", width=3, **look)
    for i, point in enumerate(seen):
        scene.polyline([(0, 0), point], color=i, width=1, dashed=True, **look)
    scene.dots([*seen, *((x_i, 1) for x_i, _ in p)], [0, 1, 2, 0, 1, 2], radius=4, **look)
    scene.polyline([(0, 0), (x, w), (x / w, 1)], color="accent", **look)
    scene.dots([(x, w), (x / w, 1)], ["construction", "curve"], radius=5, **look)


def _ask(scene: Scene, p: Any, weights: Any, lifted: Homogeneous) -> None:
    half, t = sp.Rational(1, 2), sp.Symbol("t")
    scene.question(
        "Where is c(1/2) with the weights as they stand? Type (x, y).",
        _projected(_point(lifted, half)), until=0,
        mistakes={"That is the point for equal weights.": de_casteljau(p, half)[-1][0],
                  "Divide by w(1/2), the sum of the weighted Bernstein values.":
                      list(_point(lifted, half)[:2])},
        hint="Not yet. Average w_i P_i and w_i with 1/4, 1/2, 1/4, and divide.",
    )  # fmt: skip
    scene.question(
        "Write the denominator w(t) for w_0, w_1, w_2 = 1, 3, 2.",
        _denominator((1, 3, 2)), [t], since=1, until=1,
        mistakes={"B_1^2 = 2t(1 - t): the 2 is missing.": (1 - t) ** 2 + 3 * t * (1 - t) + 2 * t**2,
                  "t and 1 - t change places: that is w(1 - t).":
                      _denominator((2, 3, 1))},
        hint="Not yet. w(t) = sum w_i B_i^2(t).",
    )  # fmt: skip
    scene.question(
        "A quarter of a circle has P_0 = (4, 0), P_1 = (4, 4), P_2 = (0, 4), w_0 = w_2 = 1. "
        "What is w_1^2?", half, since=2,
        mistakes={"That is w_1, roughly; asked is its square.": sp.Rational(7, 10),
                  "That is a parabola.": sp.Integer(1)},
        hint="Not yet. c(1/2) must be 4 from the origin; or: w_1 is the cosine of 45 degrees.",
    )  # fmt: skip


def _denominator(weights: tuple[int, int, int]) -> sp.Expr:
    return sum((w * f for w, f in zip(weights, bernstein(2), strict=True)), sp.S.Zero)

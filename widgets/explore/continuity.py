"""Continuity of two Bezier segments: parametric and geometric, told exactly while one drags."""

from __future__ import annotations

from typing import Any

import sympy as sp

from symbolic import JointConditions, a_frame, de_casteljau, hodograph
from symbolic import geometric_continuity as geometric
from symbolic import parametric_continuity as parametric
from symbolic.dag import substitute

from ..figure import Figure
from ..scene import Scene
from .control_points import cubic_points

LEFT = ((0, 0), (1, 3), (3, 4), (5, 3))
RIGHT = ((5, 3), (6, 2.5), (8, 3), (9, 5))
STEPS = (
    "Two segments P and Q. Do they meet, C^0?",
    "First derivatives at the joint, by the common parameter: equal for C^1, parallel for G^1.",
    "Curvature combs: they meet in one tooth for G^2.",
    "The A-frame: at a C^1 joint, C^2 is d^- = d^+.",
)
TEETH = 12
Point = tuple[Any, Any]


def continuity(left: Any = LEFT, right: Any = RIGHT) -> Figure:
    """Explore how two cubic segments join: C^0, C^1, C^2, G^1, G^2, and what each asks for.

    The ratio r is the length of the right parameter interval by that of the left one; beta_1 and
    beta_2 are the shape parameters of geometric continuity. Every verdict is exact.

    Parameters
    ----------
    left, right : rows, shape (4, 2)

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, or not four.

    Examples
    --------
    >>> fig = continuity()
    >>> sorted(fig.values)
    ['P', 'Q', 'beta1', 'beta2', 'r', 'step']
    """
    scene = Scene(
        "Continuity of two segments",
        "Two cubic Bezier segments with control points P and Q, their derivatives, curvature "
        "combs and A-frame at the joint, and which continuity holds.",
    )
    p = scene.points(cubic_points(left), name="P", colors=range(4))
    q = scene.points(cubic_points(right), name="Q", colors=range(4, 8))
    r = scene.slider("r", 0.25, 4, value=1, snap=0.125)
    betas = (scene.slider("beta1", 0.25, 4, value=0.5, snap=0.125, label="β_1"),
             scene.slider("beta2", -4, 4, value=0, snap=0.25, label="β_2"))  # fmt: skip
    scene.steps(STEPS, first=1)
    t = sp.Symbol("t")
    for points, color in ((p, "curve"), (q, "accent")):
        scene.polyline(points)
        scene.curve(de_casteljau(points, t)[-1][0], (t, 0, 1), color=color, width=3)
        _comb(scene, points, t)
    _derivatives(scene, p, q, r)
    frame = a_frame(p, q, r)
    for points, end, label in ((p[1:3], frame[0], "d^-"), (q[1:3], frame[1], "d^+")):
        inner = points[-1] if label == "d^-" else points[0]
        scene.polyline([inner, end], dashed=True, color="muted", since=3)
        scene.dots([end], ["construction"], [label], since=3)
    _verdicts(scene, p, q, r, betas)
    _ask(scene, p, r)
    return Figure(scene)


def _comb(scene: Scene, points: list[Point], t: sp.Symbol) -> None:
    """Draw c - 2 kappa n, with kappa n = (x'y'' - y'x'')/|c'|^4 (-y', x'): it needs no root."""
    (x, y), (dx, dy), (ddx, ddy) = (
        de_casteljau(rows, t)[-1][0]
        for rows in (points, hodograph(points), hodograph(hodograph(points)))
    )
    bend = 2 * (dx * ddy - dy * ddx) / (dx * dx + dy * dy) ** 2
    tip = x + dy * bend, y - dx * bend  # outwards, away from the centre of curvature
    scene.curve(tip, (t, 0, 1), color="construction", width=1, since=2, until=2)
    at = [sp.Rational(k, TEETH) for k in range(TEETH + 1)]
    teeth = [tuple(substitute([*end], {t: u})) for u in at for end in ((x, y), tip)]
    scene.polyline(teeth, color="construction", width=1, pieces=[2] * len(at), since=2, until=2)


def _derivatives(scene: Scene, p: list[Point], q: list[Point], r: sp.Symbol) -> None:
    """Draw a third of both derivatives at the joint, by the parameter of the left segment."""
    ends = hodograph(p)[-1], hodograph(q)[0]
    arrows = [
        [joint, [c + d / (3 * scale) for c, d in zip(joint, end, strict=True)]]
        for joint, end, scale in ((p[-1], ends[0], 1), (q[0], ends[1], r))
    ]
    for arrow, color, width in zip(arrows, (3, 4), (5, 2), strict=True):
        scene.arrows([arrow], color=color, width=width, since=1, until=1)


def _residuals(joint: JointConditions, order: int, p: list[Point], q: list[Point]) -> list[Any]:
    """Return the difference of both sides of a condition, for x and y."""
    left, right = joint.conditions[order]
    names = {f"P{i}": point for i, point in enumerate(p)}
    names |= {f"Q{i}": point for i, point in enumerate(q)}
    symbols = [s for s in (left - right).free_symbols if s.name in names]
    return [
        substitute([left - right], {s: names[s.name][axis] for s in symbols})[0] for axis in (0, 1)
    ]


def _verdicts(scene: Scene, p: Any, q: Any, r: Any, betas: Any) -> None:
    c, g = parametric(3, 2, r), geometric(3, 2, betas)
    for joint, name, orders in ((c, "C", (0, 1, 2)), (g, "G", (1, 2))):
        for order in orders:
            scene.statement(f"{name}^{order}", _residuals(joint, order, p, q))


def _ask(scene: Scene, p: list[Point], r: sp.Symbol) -> None:
    names = {f"P{i}": point for i, point in enumerate(p)}

    def next_point(order: int, ratio: Any) -> list[Any]:
        point = parametric(3, 2, ratio).points[order]
        symbols = [s for s in point.free_symbols if s.name in names]
        return [substitute([point], {s: names[s.name][k] for s in symbols})[0] for k in (0, 1)]

    scene.question(
        "Where must Q_1 stand for C^1? Type (x, y).", next_point(1, r), until=1,
        mistakes={
            "That is right for equal intervals only; that of Q is r times as long.":
                next_point(1, 1),
            "That would be for an interval of length 1/r: the leg grows with its own interval.":
                next_point(1, 1 / r),
        },
        hint="Not yet. P_2, P_3 = Q_0 and Q_1 lie on a line, and the legs are as the intervals.",
    )  # fmt: skip
    scene.question(
        "And Q_2 for C^2? Type (x, y).", next_point(2, r), since=2,
        mistakes={"That is right for equal intervals only.": next_point(2, 1)},
        hint="Not yet. With Q_1 as C^1 wants it: prolong P_1 P_2 by r times its length to d; "
        "Q_2 is r times as far beyond Q_1 as d is before it, on their line.",
    )  # fmt: skip

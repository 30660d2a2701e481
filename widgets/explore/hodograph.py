"""The hodograph of a cubic: its derivative as a curve, and what it tells about shape."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import sympy as sp

from symbolic import de_casteljau
from symbolic import hodograph as derivative_points

from ..figure import Figure
from ..scene import Scene
from .control_points import cubic_points, unit_parameter

CUBIC = ((0, 0), (5, 5), (2, 4), (8, 1))
STEPS = (
    "The legs of the control polygon are vectors, b_{i+1} - b_i.",
    "From one origin, three times as long: d_i = 3 (b_{i+1} - b_i) are the control points of c'.",
    "c'(t) has the direction of the tangent, and the speed as its length; a third of it at c(t).",
    "c''(t) bends the curve: the osculating circle has κ = (x'y'' - y'x'') / |c'|^3.",
    "An inflection: c'' is parallel to c', seen from the origin the hodograph turns back. "
    "A cusp: the hodograph passes through the origin.",
)
_LEGS = (4, 5, 6)  # colours of the d_i; 0 to 3 are the control points
_CURVATURE, _SPECIAL = 3, 4  # steps
Point = tuple[Any, Any]


def hodograph(points: Any = CUBIC, t: Any = Fraction(7, 16)) -> Figure:
    """Explore the derivative of a cubic: tangent, speed, curvature, inflections and cusps.

    Parameters
    ----------
    points : rows, shape (4, 2)
    t : number in [0, 1]

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, or not four.

    Examples
    --------
    >>> fig = hodograph()
    >>> sorted(fig.values)
    ['b', 'step', 't']
    """
    rows = cubic_points(points)
    scene = Scene(
        "The hodograph of a cubic",
        "A cubic Bezier curve with the tangent and the osculating circle at t, and beside it its "
        "hodograph, the curve of its derivatives, drawn from the origin.",
    )
    b = scene.points(rows, name="b")
    parameter = scene.slider("t", 0, 1, value=unit_parameter(t))
    scene.steps(STEPS, first=1)
    d = derivative_points(b)
    at_t = [de_casteljau(p, parameter)[-1][0] for p in (b, d, derivative_points(d))]
    x, y = _ranges(rows)
    side = scene.view("hodograph", x, y, title="The hodograph c'", equal=True)
    scene.polyline(b)
    scene.curve(at_t[0], parameter, width=3)
    for i, color in enumerate(_LEGS):
        scene.arrows([b[i : i + 2]], color=color, until=1)
        scene.arrows([[(0, 0), d[i]]], color=color, view=side, since=1, until=2)
    scene.polyline(d, view=side, since=1)
    scene.curve(at_t[1], parameter, width=3, view=side, since=1)
    scene.dots([(0, 0), *d], ["construction", *_LEGS], ["0", "d_0", "d_1", "d_2"], view=side,
               since=1)  # fmt: skip
    _draw_circle(scene, *at_t)
    _draw_special(scene, b, d, side)
    _draw_vectors(scene, at_t, side)
    _tell(scene, at_t)
    _ask(scene, b, d)
    return Figure(scene)


def _ranges(rows: np.ndarray) -> tuple[Any, ...]:
    """Return ranges for the hodograph with room to drag: a control point moves it threefold."""
    d = np.concatenate([[[0, 0]], 3 * np.diff(rows, axis=0)])
    low, high = d.min(axis=0), d.max(axis=0)
    extent = float((high - low).max()) or 1.0
    return tuple((a - extent / 5, b + extent / 5) for a, b in zip(low, high, strict=True))


def cross(one: Any, other: Any) -> sp.Expr:
    """Return x'y'' - y'x''."""
    return one[0] * other[1] - one[1] * other[0]


def _draw_circle(scene: Scene, c: Any, v: Any, a: Any) -> None:
    """Draw the osculating circle, without a root, so that it becomes the tangent where kappa = 0.

    The point at the distance |v| s along the tangent is projected to it from the point opposite
    to c; s = u / (1 - u^2) covers the whole circle.
    """
    square, turn, u = v[0] ** 2 + v[1] ** 2, cross(v, a), sp.Symbol("u")
    bend, far = turn / square, 1 - u**2  # far = 0: the point opposite to c
    along = u / (far**2 + (bend * u / 2) ** 2)
    around = [(c[0] + along * (far * v[0] - bend * u / 2 * v[1])),
              (c[1] + along * (far * v[1] + bend * u / 2 * v[0]))]  # fmt: skip
    centre = c[0] - v[1] * square / turn, c[1] + v[0] * square / turn
    look: dict[str, Any] = {"since": _CURVATURE, "until": _CURVATURE}
    scene.curve(around, (u, -1, 1), color="accent", **look)
    scene.polyline([c, centre], color="accent", width=1, dashed=True, **look)
    scene.dots([centre], ["accent"], radius=3, **look)


def _draw_vectors(scene: Scene, at_t: Any, side: int) -> None:
    c, v, a = at_t
    tip = [p + q / 3 for p, q in zip(c, v, strict=True)]
    half = [p + q / 2 for p, q in zip(v, a, strict=True)]
    scene.arrows([[c, tip]], color="curve", width=3, since=2)
    scene.dots([c], ["curve"], ["c(t)"], radius=6)
    scene.arrows([[(0, 0), v]], color="curve", width=3, view=side, since=2)
    scene.arrows([[v, half]], color="accent", view=side, since=_CURVATURE, until=_CURVATURE)
    scene.dots([half], ["accent"], ["c' + c''/2"], view=side, since=_CURVATURE, until=_CURVATURE)
    scene.dots([v], ["curve"], ["c'(t)"], radius=6, view=side, since=1)


def _draw_special(scene: Scene, b: Any, d: Any, side: int) -> None:
    """Mark the inflections: c' x c'' is quadratic, with the Bernstein coefficients e_0, e_1, e_2.

    With s = t/(1 - t) it is e_0 + 2 e_1 s + e_2 s^2. Dividing by a step hides what is no
    inflection: s < 0 is outside of the curve, and a double zero is a cusp.
    """
    ends = [_turn(d, sp.Rational(k, 2)) for k in range(3)]
    e = ends[0], 2 * ends[1] - (ends[0] + ends[2]) / 2, ends[2]
    square = e[1] ** 2 - e[0] * e[2]
    for sign in (1, -1):
        s = -(e[1] + sign * sp.sqrt(square)) / e[2]
        t = (
            s
            / (1 + s)
            / sp.Heaviside(s, 1, evaluate=False)
            / (1 - sp.Heaviside(-square, 1, evaluate=False))
        )
        point, v = (de_casteljau(p, t)[-1][0] for p in (b, d))
        scene.polyline([(0, 0), v], color="accent", dashed=True, view=side, since=_SPECIAL)
        for where, view in ((point, 0), (v, side)):
            scene.dots([where], ["accent"], ["inflection"], radius=6, view=view, since=_SPECIAL)


def _turn(d: Any, t: Any) -> sp.Expr:
    return cross(*(de_casteljau(p, t)[-1][0] for p in (d, derivative_points(d))))


def _tell(scene: Scene, at_t: Any) -> None:
    _, v, a = at_t
    speed = sp.sqrt(v[0] ** 2 + v[1] ** 2)
    scene.readout("c'(t)", list(v))
    scene.readout("speed |c'(t)|", speed)
    scene.readout("curvature κ(t)", cross(v, a) / speed**3)
    scene.statement("c'(t) = 0", list(v), since=_SPECIAL)
    scene.statement("c'(t) parallel to c''(t)", cross(v, a), since=_SPECIAL)


def _ask(scene: Scene, b: Any, d: Any) -> None:
    legs = [[q - p for p, q in zip(*leg, strict=True)] for leg in zip(b, b[1:], strict=False)]
    scene.question(
        "Before you look: write the control points of the hodograph, (x, y), (x, y), (x, y).",
        d, until=0,
        mistakes={
            "Those are the legs; the degree 3 is missing as a factor.": legs,
            "The factor is the degree 3, not the number of points.":
                [[4 * x for x in leg] for leg in legs],
            "All are reversed: the later point minus the earlier one.":
                [[-x for x in point] for point in d],
        },
        hint="Not yet. d_i = 3 (b_{i+1} - b_i), for i = 0, 1, 2.",
    )  # fmt: skip
    _ask_for_b3(scene, "c'(1) = 0", b, (0, 0, 1), since=1, until=2, mistakes={
        "That makes c''(1) zero: the second difference at the end.": (0, -1, 2),
        "That closes the curve.": (1, 0, 0),
    }, hint="Not yet. c'(1) is the last control point of the hodograph.")  # fmt: skip
    _ask_for_b3(scene, "the curve has a cusp at t = 1/2", b, (1, 1, -1), since=3, mistakes={
        "That makes c''(1/2) zero; asked is c'(1/2).": (-1, 1, 1),
        "That makes c'(1) zero, at the end.": (0, 0, 1),
        "That would be right if d_1 counted as much as d_0 and d_2: it counts twice.": (1, 0, 0),
    }, hint="Not yet. c'(1/2) = (d_0 + 2 d_1 + d_2) / 4 must be zero. Then drag it!")  # fmt: skip


def _ask_for_b3(scene: Scene, goal: str, b: Any, row: Any, mistakes: Any, **more: Any) -> None:
    """Ask for b_3 as a combination of b_0, b_1, b_2; mistakes are other combinations."""

    def combined(row: Any) -> list[Any]:
        return [sum(w * p[axis] for w, p in zip(row, b, strict=False)) for axis in (0, 1)]

    scene.question(f"Where must b_3 be so that {goal}? Type (x, y).", combined(row),
                   mistakes={text: combined(wrong) for text, wrong in mistakes.items()},
                   **more)  # fmt: skip

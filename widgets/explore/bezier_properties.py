"""What every Bezier curve has: one property a step, told by its Bernstein functions."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from numeric import quotient_or_zero
from symbolic import bernstein, de_casteljau
from symbolic.dag import substitute

from ..extent import snap_for
from ..figure import Figure
from ..scene import Scene
from .control_points import cubic_points, unit_parameter

CUBIC = ((0, 1), (2, 5), (5, 0), (8, 4))
HULL, LINE, AFFINE, SYMMETRY, PRECISION, LOCAL = range(6)
STEPS = (
    "Convex hull: the shares B_i^3(t) are not negative, with sum 1, so c(t) is a weighted mean.",
    "Variation diminishing: no line crosses the curve more often than the polygon. "
    "Drag L_0 L_1 and try.",
    "Affine invariance: Φ of the curve (thin) is the curve of the points Φ(b_i) (wide).",
    "Symmetry: B_i^3(t) = B_{3-i}^3(1 - t), so with b_3, b_2, b_1, b_0 the curve is run backwards.",
    "Linear precision: sum i/3 B_i^3(t) = t, so points on a line, evenly spaced, give it evenly.",
    "Pseudo-local control: with q for b_1 the point c(t) moves by B_1^3(t) (q - b_1), "
    "most of all at t = 1/3.",
)
n = 3
x = sp.Symbol("t")


def bezier_properties(points: Any = CUBIC, t: Any = Fraction(3, 8)) -> Figure:
    """Explore the properties of Bezier curves on a cubic, each beside the Bernstein functions.

    Convex hull, variation diminishing with a line to drag, affine invariance with a frame to
    drag, symmetry, linear precision, and pseudo-local control with a point to drag.

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
    >>> fig = bezier_properties()
    >>> sorted(fig.values)
    ['F', 'L', 'b', 'q', 'step', 't']
    """
    rows = cubic_points(points)
    scene = Scene(
        "Properties of Bezier curves",
        "A cubic Bezier curve with its control polygon, and beside it the four Bernstein "
        "functions; every step shows one property in both.",
    )
    scene.steps(STEPS)
    b = scene.points(rows, name="b")
    parameter = scene.slider("t", 0, 1, value=unit_parameter(t))
    side = scene.view("functions", (-0.06, 1.06), (-0.06, 1.12), title="Bernstein functions B_i^3")
    _draw_functions(scene, parameter, side)
    _draw_hull(scene, b, parameter)
    _draw_line(scene, rows, b)
    frame, axes = _draw_image(scene, rows, b, parameter)
    _draw_reversed(scene, b, parameter, side)
    _draw_chord(scene, b, parameter, side)
    _draw_move(scene, rows, b, parameter, side)
    _ask(scene, b, frame, axes)
    return Figure(scene)


def point_at(b: Any, t: Any) -> list[Any]:
    """Return the point of a curve."""
    return list(de_casteljau(b, t)[-1][0])


def mixed(p: Any, q: Any, share: Any) -> list[Any]:
    """Return p + share (q - p)."""
    return [a + share * (c - a) for a, c in zip(p, q, strict=True)]


def functions(t: Any) -> list[Any]:
    """Return the Bernstein functions at t."""
    return substitute(list(bernstein(n)), {x: t})


def _draw_functions(scene: Scene, t: sp.Symbol, side: int) -> None:
    for i, value in enumerate(functions(t)):
        scene.curve((t, value), t, color=i, width=2, view=side)
    scene.polyline([(t, 0), (t, 1)], color="curve", width=1, view=side)
    scene.dots([(t, value) for value in functions(t)], range(n + 1), view=side)


def _draw_hull(scene: Scene, b: Any, t: sp.Symbol) -> None:
    scene.hull(b, until=HULL)
    scene.polyline(b)
    scene.curve(point_at(b, t), t, width=3)
    scene.dots([point_at(b, t)], ["curve"], ["c(t)"], radius=6)
    scene.readout("c(t)", point_at(b, t))


def _draw_line(scene: Scene, rows: Any, b: Any) -> None:
    low, high = rows.min(axis=0), rows.max(axis=0)
    middle = (low[1] + high[1]) / 2
    p, q = _more_points(
        scene, "L", rows, [[low[0], middle], [high[0], middle]], ["accent"] * 2, LINE
    )
    scene.polyline([mixed(p, q, -50), mixed(p, q, 51)], color="accent", since=LINE, until=LINE)
    # Twice the areas of the triangles L_0 L_1 b_i: the distances of b_i from the line, scaled.
    sides = [(q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) for x, y in b]
    for label, count in (("polygon", changes(sides)), ("curve", crossings(sides))):
        scene.readout(f"crossings of the line with the {label}", count, since=LINE, until=LINE)


def changes(values: Any) -> sp.Expr:
    """Return how often the sign changes in a sequence; zero counts as positive."""
    signs = [_unasked(sp.Heaviside, value, 1) for value in values]
    return sum(((s - t) ** 2 for s, t in pairwise(signs)), sp.S.Zero)


def _unasked(function: Any, *arguments: Any) -> sp.Expr:
    """Return a function's value as it is written: SymPy takes minutes to find no simpler one."""
    return function(*map(sp.sympify, arguments), evaluate=False)


def crossings(values: Any) -> sp.Expr:
    """Return how often the sign of a cubic with these Bernstein coefficients changes in [0, 1].

    Between its turning points a cubic is monotone. They are the zeros of a t^2 + b t + c, q/a and
    c/q, also for a = 0; a turning point that is none does no harm.
    """
    e = [q - p for p, q in pairwise(values)]
    a, b, c = e[0] - 2 * e[1] + e[2], 2 * (e[1] - e[0]), e[0]
    root = sp.sqrt(_unasked(sp.Max, b**2 - 4 * a * c, 0))
    q = -(b + (2 * _unasked(sp.Heaviside, b, 1) - 1) * root) / 2
    turns = [
        _unasked(sp.Min, _unasked(sp.Max, quotient_or_zero(*pair), 0), 1)
        for pair in ((q, a), (c, q))
    ]
    inner = [de_casteljau([[v] for v in values], t)[-1][0][0]
             for t in (_unasked(sp.Min, *turns), _unasked(sp.Max, *turns))]  # fmt: skip
    return changes([values[0], *inner, values[-1]])


def _draw_image(scene: Scene, rows: Any, b: Any, t: sp.Symbol) -> Any:
    """Draw Φ(x, y) = F_0 + x/u (F_1 - F_0) + y/u (F_2 - F_0), and return the frame and u."""
    unit = 32 * snap_for(rows)
    corner = rows.min(axis=0) + [unit / 4, -unit]
    ends = [corner, corner + [0.75 * unit, unit / 4], corner + [-unit / 8, unit / 2]]
    frame = _more_points(scene, "F", rows, ends, ["accent", 4, 5], AFFINE)
    axes = sp.Rational(unit)
    look: dict[str, Any] = {"since": AFFINE, "until": AFFINE}
    for corners, width in (([(0, 0), (axes, 0), (0, axes)], 1), (frame, 2)):
        for end, color in zip(corners[1:], (4, 5), strict=True):
            scene.arrows([[corners[0], end]], color=color, width=width, **look)
    images, image = [mapped(p, frame, axes) for p in b], mapped(point_at(b, t), frame, axes)
    scene.polyline(images, **look)
    scene.curve(point_at(images, t), t, color="muted", width=7, **look)
    scene.curve(image, t, width=2, **look)
    scene.dots(images, range(n + 1), radius=5, **look)
    scene.dots([image], ["curve"], ["Φ(c(t))"], radius=6, **look)
    apart = [p - q for p, q in zip(image, point_at(images, t), strict=True)]
    scene.statement("Φ(c(t)) on the curve of Φ(b_i)", apart, **look)
    return frame, axes


def mapped(point: Any, frame: Any, axes: Any) -> list[Any]:
    """Return the image under the affine map that takes axes of this length to a frame."""
    origin, *ends = frame
    return [
        origin[k] + sum(c * (end[k] - origin[k]) for c, end in zip(point, ends, strict=True)) / axes
        for k in (0, 1)
    ]


def _draw_reversed(scene: Scene, b: Any, t: sp.Symbol, side: int) -> None:
    look: dict[str, Any] = {"since": SYMMETRY, "until": SYMMETRY}
    scene.dots([point_at(b[::-1], t)], ["accent"], ["c(1 - t)"], radius=6, **look)
    scene.polyline([(1 - t, 0), (1 - t, 1)], color="accent", width=1, view=side, **look)
    for i, value in enumerate(functions(t)):
        pair = [(t, value), (1 - t, value)]
        scene.polyline(pair, color=n - i, dashed=True, width=1, view=side, **look)
        scene.dots(pair[1:], [n - i], view=side, **look)


def _draw_chord(scene: Scene, b: Any, t: sp.Symbol, side: int) -> None:
    look: dict[str, Any] = {"since": PRECISION, "until": PRECISION}
    even = [mixed(b[0], b[-1], sp.Rational(i, n)) for i in range(n + 1)]
    mean = sum((sp.Rational(i, n) * f for i, f in enumerate(functions(t))), sp.S.Zero)
    scene.curve(point_at(even, t), t, color="accent", width=3, **look)
    scene.dots(even[1:-1], range(1, n), ["1/3", "2/3"], radius=5, **look)
    scene.dots([point_at(even, t)], ["accent"], ["t"], radius=6, **look)
    scene.curve((t, mean), t, color="accent", width=3, view=side, **look)
    scene.dots([(t, mean)], ["accent"], ["t"], radius=6, view=side, **look)


def _draw_move(scene: Scene, rows: Any, b: Any, t: sp.Symbol, side: int) -> None:
    look: dict[str, Any] = {"since": LOCAL, "until": LOCAL}
    place = rows[1] + snap_for(rows) * np.array([20, 12])
    (q,) = _more_points(scene, "q", rows, [place], [1], LOCAL, ["q"])
    moved = [b[0], q, *b[2:]]
    scene.arrows([[b[1], q]], color=1, **look)
    scene.curve(point_at(moved, t), t, color=1, **look)
    at = [sp.Rational(k, 12) for k in range(1, 12)]
    ways = [point_at(points, u) for u in at for points in (b, moved)]
    scene.polyline(ways, color=1, width=1, pieces=[2] * len(at), **look)
    scene.curve((t, functions(t)[1]), t, color=1, width=5, view=side, **look)
    tops = [(u, functions(u)[i]) for i, u in enumerate(sp.Rational(i, n) for i in range(n + 1))]
    scene.dots(tops, range(n + 1), ["0", "1/3", "2/3", "1"], radius=6, view=side, **look)


def _more_points(scene: Scene, name: str, rows: Any, places: Any, colors: Any, step: int,
                 labels: Any = None) -> Any:  # fmt: skip
    """Add points of one step, where points of the curve's extent snap, so that they are exact."""
    snap = snap_for(rows)
    return scene.points(np.round(np.array(places) / snap) * snap, name, labels, colors, snap,
                        since=step, until=step)  # fmt: skip


def _ask(scene: Scene, b: Any, frame: Any, axes: Any) -> None:
    def ask(step: int, prompt: str, answer: Any, mistakes: Any, hint: str, typed: Any = ()) -> None:
        scene.question(prompt, answer, typed, mistakes, f"Not yet. {hint}", step, step)

    at, half = functions(sp.Rational(3, 2)), sp.Rational(1, 2)
    ask(HULL, "Outside of [0, 1] the hull no longer holds the curve. What is B_2^3(3/2)?", at[2],
        {"1 - t is negative there.": -at[2], "That is B_1^3(3/2).": at[1],
         "The factor 3 is missing.": at[2] / 3}, "B_2^3(t) = 3 t^2 (1 - t).")  # fmt: skip
    ask(LINE, "A line crosses the polygon three times. How often may it cross the curve? Type "
        "both numbers, the smaller first.", [1, 3],
        {"The ends of the curve are on different sides: the number is odd.": [2, 3],
         "With no crossing, both ends of the curve would be on one side.": [0, 3]},
        "At most as often as the polygon; and on which sides are b_0 and b_3?")  # fmt: skip
    middle = point_at(b, half)
    image = mapped(middle, frame, axes)
    ask(AFFINE, "Where does Φ take c(1/2)? Type (x, y).", image,
        {"That is c(1/2) itself.": middle, "Add the origin F_0 of the frame.":
         [p - q for p, q in zip(image, frame[0], strict=True)]},
        f"F_0 + x/{axes} (F_1 - F_0) + y/{axes} (F_2 - F_0), with c(1/2) = (x, y).")  # fmt: skip
    shares = bernstein(n)
    ask(SYMMETRY, "Write B_1^3(1 - t) in t.", shares[2],
        {"That is B_1^3(t): write 1 - t for t.": shares[1],
         "The factor 3 is missing.": shares[2] / 3},
        "Exchange t and 1 - t in 3 t (1 - t)^2.", [x])  # fmt: skip
    ask(PRECISION, "The control points have y = 2, 4, 6, 8. Write y(t).",
        point_at([[y] for y in (2, 4, 6, 8)], x)[0],
        {"That is the step from one point to the next; t = 1 must give 8.": 2 + 2 * x,
         "At t = 0 it must be 2.": 6 * x, "Right at t = 1 only.": 8 * x},
        "A cubic whose control points are evenly spaced is linear.", [x])  # fmt: skip
    third = sp.Rational(1, 3)
    ask(LOCAL, "How large is the largest share that b_2 ever has?", functions(2 * third)[2],
        {"That is where it has it.": 2 * third, "It is never all of c(t).": sp.S.One,
         "At t = 1/2 it is not largest.": functions(half)[2]},
        "Its share is B_2^3(t) = 3 t^2 (1 - t), and B_2^3 is largest at t = 2/3.")  # fmt: skip

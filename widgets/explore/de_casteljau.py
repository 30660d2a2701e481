"""De Casteljau's construction, one linear interpolation a step."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from symbolic import bernstein
from symbolic import de_casteljau as levels_of
from symbolic.dag import substitute

from ..figure import Figure
from ..scene import Scene
from .control_points import control_points, unit_parameter

CUBIC = ((0, 0), (1, 4), (5, 5), (8, 1))


def de_casteljau(points: Any = CUBIC, t: Any = Fraction(3, 8), step: int | None = None) -> Figure:
    """Explore de Casteljau's algorithm: drag points, scrub t, step one interpolation at a time.

    Linked by colour: the control points, the triangular scheme (each entry shows its share of
    every control point) and the row of Bernstein weights.

    Parameters
    ----------
    points : rows, shape (n + 1, 2)
        Control points of a curve of degree 1 to 8.
    t : number in [0, 1]
    step : int, optional
        Interpolations done at first, 0 to n(n + 1)/2; by default all of them.

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, too few or too many.

    Examples
    --------
    >>> fig = de_casteljau([[0, 0], [2, 3], [4, 0]], t=0.5)
    >>> sorted(fig.values)
    ['b', 'step', 't']
    """
    rows = control_points(points)
    n = len(rows) - 1
    scene = Scene(
        "De Casteljau's construction",
        f"A Bezier curve of degree {n} with its control polygon, and the points that repeated "
        "linear interpolation at t makes of it.",
    )
    b = scene.points(rows, name="b")
    parameter = scene.slider("t", 0, 1, value=unit_parameter(t))
    levels = levels_of(b, parameter)
    lerps = [(r, i) for r in range(1, n + 1) for i in range(n + 1 - r)]
    at = {entry: k for k, entry in enumerate(lerps, 1)}
    scene.steps(_captions(lerps, n), first=len(lerps) if step is None else step)

    _draw_curve(scene, levels[-1][0], parameter)
    scene.polyline(b)
    for r, i in lerps:
        _draw_lerp(scene, levels, r, i, at)
    _link_panels(scene, levels, at)
    scene.readout("c(t)", levels[-1][0])
    _ask(scene, b)
    return Figure(scene)


def _draw_curve(scene: Scene, point: Any, t: sp.Symbol) -> None:
    """Draw the whole curve pale, and the part up to t strong: the point runs along it."""
    u = sp.Symbol("u")
    scene.curve(point, t, color="muted", width=3)
    scene.curve(substitute(point, {t: t * u}), (u, 0, 1), width=3)


def _draw_lerp(scene: Scene, levels: Any, r: int, i: int, at: dict[tuple[int, int], int]) -> None:
    k = at[r, i]
    ends = levels[r - 1][i : i + 2]
    scene.polyline(ends, color="accent", width=4, since=k, until=k)  # the leg that is divided now
    if i:
        scene.polyline(levels[r][i - 1 : i + 1], since=k)
    last = r == len(levels) - 1
    scene.dots([levels[r][i]], ["curve" if last else "construction"], [label(i, r)],
               radius=6 if last else 4, since=k)  # fmt: skip


def _link_panels(scene: Scene, levels: Any, at: dict[tuple[int, int], int]) -> None:
    n = len(levels) - 1
    entries = [(r, i) for r, level in enumerate(levels) for i in range(len(level))]
    weights = [bernstein(r) for r in range(n + 1)]
    shares = [[0] * i + list(weights[r]) + [0] * (n - r - i) for r, i in entries]
    labels = [label(i, r) for r, i in entries]
    scene.scheme(levels, labels, [at.get(entry, 0) for entry in entries], shares)
    scene.weights(list(weights[n]), [f"B_{i}^{n}" for i in range(n + 1)],
                  title="Share of every control point in c(t)")  # fmt: skip


def _ask(scene: Scene, b: Any) -> None:
    """Ask for the point at a quarter, with what is mostly answered instead."""
    quarter = sp.Rational(1, 4)
    first, last = b[0], b[-1]
    mistakes = {
        "That is c(3/4): the share of the left end of a leg is 1 - t.": _point(b, 1 - quarter),
        "That is the mean of all control points.":
            [sum(xs) / len(b) for xs in zip(*b, strict=True)],
        "That is a quarter of the way along the chord from the first point to the last.":
            [p + quarter * (q - p) for p, q in zip(first, last, strict=True)],
        "That is the first step only. Go on until one point is left.":
            [p + quarter * (q - p) for p, q in zip(first, b[1], strict=True)],
    }  # fmt: skip
    right = _point(b, quarter)
    apart = {text: wrong for text, wrong in mistakes.items() if not _alike(wrong, right)}
    scene.question("Predict before you look: where is c(1/4)? Type (x, y).", right, mistakes=apart,
                   hint="Not yet. Divide every leg at a quarter of its length, then the new "
                   "legs, until one point is left.")  # fmt: skip


def _point(b: Any, t: Any) -> Any:
    return levels_of(b, t)[-1][0]


def _alike(one: Any, other: Any) -> bool:
    return all(sp.expand(p - q) == 0 for p, q in zip(one, other, strict=True))


def _captions(lerps: list[tuple[int, int]], n: int) -> list[str]:
    captions = [f"The control polygon b_0, ..., b_{n}. Step forward to interpolate."]
    for r, i in lerps:
        left, right = (label(i, r - 1), label(i + 1, r - 1)) if r > 1 else (f"b_{i}", f"b_{i + 1}")
        captions.append(f"{label(i, r)} = (1 - t) {left} + t {right}")
    captions[-1] += ", the point c(t) of the curve"
    return captions


def label(i: int, r: int) -> str:
    """Return the name of a point of the scheme.

    >>> label(0, 2)
    'b_0^2'
    """
    return f"b_{i}^{r}" if r else f"b_{i}"

"""Subdivision: one control polygon becomes two, then four, and approaches the curve."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from symbolic import de_casteljau, subdivide
from symbolic.errors import BadValue, shown
from symbolic.exact import whole_number

from ..figure import Figure
from ..scene import Scene
from .control_points import control_points, unit_parameter
from .de_casteljau import CUBIC

_LEFT, _RIGHT = 0, 1  # colours of the two parts
_DEEPEST = 6  # 64 polygons: beyond, they cannot be told from the curve


def subdivision(points: Any = CUBIC, t: Any = Fraction(1, 2), depth: int | None = None) -> Figure:
    """Explore subdivision: the left and right control polygons at t, split again at every step.

    Parameters
    ----------
    points : rows, shape (n + 1, 2)
        Control points of a curve of degree 1 to 8.
    t : number in [0, 1]
        Where every part is split, in its own parameter.
    depth : int, optional
        How often the parts are split, 2^depth polygons; by default 4, above degree 4 it is 3.

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, too few or too many.

    Examples
    --------
    >>> fig = subdivision([[0, 0], [2, 3], [4, 0]])
    >>> len(fig.scene["steps"])
    5
    """
    rows = control_points(points)
    depth = (4 if len(rows) <= 5 else 3) if depth is None else depth
    if whole_number(depth) not in range(_DEEPEST + 1):
        raise BadValue(
            f"a depth from 0 to {_DEEPEST}", shown(depth), "Each split doubles the polygons."
        )
    scene = Scene(
        "Subdivision",
        f"A Bezier curve of degree {len(rows) - 1} and the control polygons of its parts after "
        "repeated splitting at t; they approach the curve.",
    )
    b = scene.points(rows, name="b")
    parameter = scene.slider("t", 0, 1, value=unit_parameter(t))
    scene.steps(_captions(depth), first=min(1, depth))
    scene.curve(de_casteljau(b, parameter)[-1][0], parameter, color="muted", width=4)
    scene.polyline(b, color="construction", dashed=True)
    parts: list[Any] = [b]
    for k in range(1, depth + 1):
        parts = [half for part in parts for half in subdivide(part, parameter)]
        _draw_parts(scene, parts, k)
    scene.readout("c(t)", de_casteljau(b, parameter)[-1][0])
    return Figure(scene)


def _draw_parts(scene: Scene, parts: list[Any], k: int) -> None:
    """Draw left parts in one colour and right parts in another, and where they join."""
    size = len(parts[0])
    for side in (_LEFT, _RIGHT):
        chosen = parts[side::2]
        polygon = [point for part in chosen for point in part]
        scene.polyline(polygon, color=side, pieces=[size] * len(chosen), since=k, until=k)
        inner = [point for part in chosen for point in part[1:-1]]
        if inner:
            scene.dots(inner, [side] * len(inner), radius=3, since=k, until=k)
    joints = [part[-1] for part in parts[:-1]]
    scene.dots(joints, ["curve"] * len(joints), radius=4, since=k, until=k)


def _captions(depth: int) -> list[str]:
    counts = [
        f"{2**k} control polygons after {k} split{'s' * (k > 1)}" for k in range(1, depth + 1)
    ]
    return ["The control polygon", *counts]

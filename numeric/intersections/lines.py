"""Intersections of a curve with a line in the plane: roots of one polynomial for each segment."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symbolic.errors import BadValue, shown

from ..bernstein.evaluation import values_at
from ..bernstein.form import derivative
from ..bernstein.roots import EPSILON, roots
from ..points import real_array
from .curves import Intersections
from .places import Places
from .segments import points_at
from .track import Track, runs

if TYPE_CHECKING:
    from ..curve import Curve

NOISE = 8 * EPSILON  # of the numbers a height is computed from
LONGEST = 1e-6  # part of a segment that an end on the line may be moved by, within rounding
TANGENT = 1e-6  # slope of a curve that touches the line with its end
JOINED = 1e-9


def intersect_line(curve: Curve, point: Any, direction: Any) -> Intersections:
    """Return all points where the curve meets the line point + s direction, for all real s.

    With the line's normal n, they are the roots of n . (c - point): of n . (N - w point) for a
    rational curve N/w, whose Bernstein coefficients are read off the control points.

    Parameters
    ----------
    point, direction : two numbers each; the direction is not zero

    Returns
    -------
    Intersections
        With s, the parameters on the line. A segment that lies in the line is told in `shared`.

    Raises
    ------
    BadValue, BadType
        For a curve that is not in the plane, and a point or direction that is not two finite
        numbers.

    Examples
    --------
    >>> from numeric import Curve
    >>> arch = Curve.from_bezier([[0, 0], [1, 2], [2, 0]])
    >>> found = arch.intersect_line([0, 0.75], [1, 0])
    >>> found.t, found.s
    (array([0.25, 0.75]), array([0.5, 1.5]))
    """
    if curve.dim != 2:
        raise BadValue(
            "a curve in the plane", f"one in {curve.dim}D", "Project it with Curve.transform."
        )
    start, along = _two_numbers(point, "a point"), _two_numbers(direction, "a direction")
    largest = np.abs(along).max()
    if not largest:
        raise BadValue("a direction that is not zero", shown(direction), "Such as [1, 0].")
    normal = np.array([-along[1], along[0]]) / largest
    normal /= np.hypot(*normal)
    rows = curve.rows[..., :2]
    w = curve.rows[..., 2:] if curve.rational else np.ones((1, 1, 1))
    heights = (rows - w * start) @ normal
    noise = NOISE * (np.abs(rows).max(axis=(1, 2)) + np.abs(w * start).max(axis=(1, 2)))
    k, u, error, transversal = _places(heights, noise)
    track = Track.of(curve)
    k, u = track.once(k, u, error)
    at = track.along(k, u)
    error = error + np.spacing(at)
    places = Places(np.zeros_like(k), np.stack([at, 0 * at]), np.stack([error, error]), transversal)
    kept = places.kept()
    t = track.parameters(k, u)
    kept = kept[np.argsort(t[kept])]
    t, k, u = t[kept], k[kept], u[kept]
    points = points_at(curve.rows[k], u, 2)

    def on_line(points: np.ndarray) -> np.ndarray:
        return (points - start) @ (along / largest) / ((along / largest) ** 2).sum() / largest

    inside = np.flatnonzero((np.abs(heights) <= noise[:, None]).all(axis=1))
    s = on_line(curve.points[inside][:, [0, -1]])
    first, last = runs(np.stack([track.first[inside, None] + [0, 1], s], axis=2), JOINED)
    ends = [track.parameters(inside[first], np.zeros(len(first))),
            track.parameters(inside[last], np.ones(len(last)))]  # fmt: skip
    shared = np.stack([np.stack(ends, axis=1), np.stack([s[first, 0], s[last, 1]], axis=1)], axis=2)
    return Intersections(
        t, on_line(points), points, np.abs((points - start) @ normal),
        transversal[kept], shared,
    )  # fmt: skip


def _places(heights: np.ndarray, noise: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return (segment, u, error of u, transversal) where heights (m, n + 1) above the line vanish.

    Ends that are on the line within rounding count. Segments that lie in the line have none.
    """
    found = roots(heights, noise)
    size = np.abs(heights).max(axis=1)
    n = heights.shape[1] - 1
    parts = [(found.row, found.u, np.zeros(len(found.u)), found.simple), _touching(heights, noise)]
    for end, inner in ((0, min(1, n)), (n, max(n - 1, 0))):
        row = np.flatnonzero((np.abs(heights[:, end]) <= noise) & (size > noise))
        slope = n * np.abs(heights[row, inner] - heights[row, end])
        error = noise[row] / np.maximum(slope, noise[row] / LONGEST)
        u = np.full(len(row), float(end > 0))
        parts.append((row, u, error, slope > TANGENT * size[row]))
    return tuple(np.concatenate(column) for column in zip(*parts, strict=True))


def _touching(heights: np.ndarray, noise: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return the places where the height is extreme, and zero within rounding."""
    slopes = derivative(heights)
    found = roots(slopes, 2 * heights.shape[1] * noise)
    values = values_at(heights[found.row, :, None], found.u)[:, 0]
    touch = np.abs(values) <= noise[found.row]
    row, u = found.row[touch], found.u[touch]
    bend = values_at(derivative(slopes)[row, :, None], u)[:, 0]
    error = np.sqrt(2 * noise[row] / np.maximum(np.abs(bend), 2 * noise[row] / LONGEST**2))
    return row, u, error, np.zeros(len(row), bool)


def _two_numbers(value: Any, what: str) -> np.ndarray:
    array = real_array(value, what)
    if array.shape != (2,) or not np.isfinite(array).all():
        raise BadValue(f"two finite numbers as {what}", shown(value), "Such as [1, 0].")
    return array

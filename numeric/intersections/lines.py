"""Intersections of a curve with a line in the plane: roots of one polynomial for each segment."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symbolic.errors import BadValue, shown

from ..bernstein.balance import balanced
from ..bernstein.evaluation import values_at
from ..bernstein.form import derivative
from ..bernstein.roots import EPSILON, roots
from ..points import real_array
from .balance import unbalanced
from .curves import Intersections
from .pieces import points_at
from .places import Places
from .shared import SHORT
from .track import Track, runs, without_joints

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
        With s, the parameters on the line. Arcs that lie in the line are told in `shared`, and not
        among the points.

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
    (even,), c = balanced(curve.rows[None], 2)
    rows, w = even[..., :2], even[..., 2:] if curve.rational else np.ones((1, 1, 1))
    heights = (rows - w * start) @ normal
    noise = NOISE * (np.abs(rows).max(axis=(1, 2)) + np.abs(w * start).max(axis=(1, 2)))
    track = Track.of(curve)
    flat = (np.abs(heights) <= noise[:, None]).all(axis=1)
    inside = np.flatnonzero(flat & (track.lengths > 0))
    standing = np.intersect1d(np.flatnonzero(flat & (track.lengths == 0)), without_joints(curve))
    found = Places.all_of([_places(heights, noise), _at_starts(standing)])
    k, u, t, transversal = _once(track, unbalanced(found, c), inside)
    points = points_at(curve.rows[k], u, 2)
    s_of_ends = _along(curve.points[inside][:, [0, -1]] - start, along)
    return Intersections(
        t, _along(points - start, along), points, np.abs((points - start) @ normal),
        transversal, _shared(track, inside, s_of_ends),
    )  # fmt: skip


def _along(vectors: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """Return how many times `direction` fits into vectors along it."""
    largest = np.abs(direction).max()
    unit = direction / largest
    along: np.ndarray = vectors @ unit / (unit @ unit) / largest
    return along


def _shared(track: Track, segment: np.ndarray, s: np.ndarray) -> np.ndarray:
    """Return (t, s) at both ends of segments in the line, those that continue each other as one."""
    along = s / (np.abs(s).max(initial=0) or 1)
    first, last = runs(np.stack([track.first[segment, None] + [0, 1], along], axis=2), JOINED)
    starts = track.parameters(segment[first], np.zeros(len(first)))
    ends = track.parameters(segment[last], np.ones(len(last)))
    return np.stack(
        [np.stack([starts, s[first, 0]], axis=1), np.stack([ends, s[last, 1]], axis=1)], axis=1
    )


def _once(track: Track, found: Places, inside: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return (segment, u, t, transversal) of every place once, in order.

    Places at the ends of segments inside the line are left out.
    """
    k, u = track.once(found.pair, found.at[0], found.error[0])
    at = track.along(k, u)
    error = np.stack([found.error[0] + np.spacing(at)] * 2)
    kept = Places(np.zeros_like(k), np.stack([at, 0 * at]), error, found.transversal).kept()
    at = at[kept]
    before = np.where((at < SHORT) & track.closed, track.length, at) - SHORT
    kept = kept[~np.isin(np.floor([before, at + SHORT]), track.first[inside]).any(axis=0)]
    t = track.parameters(k, u)
    kept = kept[np.argsort(t[kept])]
    return k[kept], u[kept], t[kept], found.transversal[kept]


def _at_starts(segment: np.ndarray) -> Places:
    """Return places at the starts of segments that are points on the line."""
    zero = np.zeros((1, len(segment)))
    return Places(segment, zero, zero, np.zeros(len(segment), bool))


def _places(heights: np.ndarray, noise: np.ndarray) -> Places:
    """Return the places where heights (m, n + 1) above the line vanish, `pair` is the segment.

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
    row, u, error, crossing = (np.concatenate(column) for column in zip(*parts, strict=True))
    return Places(row, u[None], error[None], crossing)


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

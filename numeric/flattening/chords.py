"""How many chords of equal parameter length keep within a tolerance of a Bezier segment.

A chord over a parameter interval of length h differs from a curve c by at most h^2/8 max |c''|,
and |c''| by at most n (n - 1) times the largest second difference of the control points (Wang's
bound; G. Farin, *Curves and Surfaces for CAGD*, section 6.7). Two things make it sharper.

Only what is across the chord counts. If all edges of the control polygon are within an angle
phi < 90 degrees of an axis, then so are all chords, every point of the curve lies beside a point
of its chord, and of c'' = along + across the axis at most |across| + |along| sin(phi) is across any
chord.

A rational curve N/w with positive weights differs from the chord L, interpolated in homogeneous
coordinates, by (E_N - L E_w)/w, where E = (E_N, E_w) is the error of that interpolation. So with N
taken relative to a point o, its c'' is replaced by (N'' - (L - o) w'')/w, and L is no farther from
o than the control points are.
"""

from __future__ import annotations

import numpy as np

ROUNDING = 8 * float(np.finfo(float).eps)  # of a curve of size 1: edges that are none
TURNING = 0.3  # of the chords of a segment that turns by a right angle, a halving may save


def chords(rows: np.ndarray, rational: bool, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Return a number of chords for every segment, from 1 on, and how many halving it may save.

    The first is proved; the second is an estimate, from how uneven the second differences are.

    Parameters
    ----------
    rows : array, shape (n + 1, columns, m)
        Of moderate size; weights are positive. Segments stand last, where arrays are long.
    """
    n, count = len(rows) - 1, rows.shape[2]
    if n < 2:
        return np.ones(count), np.zeros(count)
    points = rows
    if rational:
        w = rows[:, -1:]
        points = rows[:, :-1] / w
        points = points - (points.min(axis=0) + points.max(axis=0)) / 2
        rows = w * points
    axis = points[-1] - points[0]
    length = np.sqrt(_squares(axis[None])[0])
    axis = axis / np.where(length == 0, 1, length)
    sine = _widest_angle(np.diff(points, axis=0), axis)
    sizes = _across(_second_differences(rows), axis, sine)
    size = sizes.max(axis=0)
    even = np.sqrt(sizes).mean(axis=0) / np.sqrt(np.where(size == 0, 1, size))
    if rational:
        bend = np.abs(_second_differences(w)).max(axis=(0, 1))
        size = (size + bend * _across(points, axis, sine).max(axis=0)) / w.min(axis=(0, 1))
    number = np.maximum(np.ceil(np.sqrt(n * (n - 1) / 8 / tolerance * size)), 1)
    return number, number * np.maximum(1 - even, np.where(sine < 0.9, 0, TURNING))


def _second_differences(rows: np.ndarray) -> np.ndarray:
    return rows[2:] - 2 * rows[1:-1] + rows[:-2]


def _widest_angle(edges: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Return the sine of the widest angle of edges and axis, infinity from 90 degrees on."""
    along, across = _parts(edges, axis)
    lengths = np.hypot(along, across)
    none = lengths <= ROUNDING
    sine = np.where(none, 0, across / np.where(none, 1, lengths)).max(axis=0)
    return np.where(((along > 0) | none).all(axis=0), sine, np.inf)


def _across(vectors: np.ndarray, axis: np.ndarray, sine: np.ndarray) -> np.ndarray:
    """Return how long every vector may be, seen along any chord."""
    along, across = _parts(vectors, axis)
    with np.errstate(invalid="ignore"):  # 0 times infinity: not less than the whole
        return np.fmin(np.hypot(along, across), across + np.abs(along) * sine)


def _parts(vectors: np.ndarray, axis: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the components along the axis, and the lengths of what is across it."""
    along = sum(vectors[:, k] * axis[k] for k in range(len(axis)))
    return along, np.sqrt(_squares(vectors - along[:, None] * axis))


def _squares(vectors: np.ndarray) -> np.ndarray:
    total = vectors[:, 0] ** 2
    for k in range(1, vectors.shape[1]):
        total += vectors[:, k] ** 2
    return total

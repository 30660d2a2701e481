"""How many chords keep within a tolerance of a Bezier segment: equal ones of each quarter of it.

A chord over a parameter interval of length h differs from a curve c by at most h^2/8 max |c''|,
and |c''| by at most n (n - 1) times the largest second difference of the control points (Wang's
bound; G. Farin, *Curves and Surfaces for CAGD*, section 6.7). Three things make it sharper.

The differences are the Bernstein coefficients of c''/(n (n - 1)). Cut into quarters, which is
cheaper than to cut c, they tell how much less some quarters bend than others.

Only what is across the chord counts. If all edges of the control polygon are within an angle
phi <= 45 degrees of an axis, then so are all chords and tangents; no two of them are more than 90
degrees apart, so every point of the curve lies beside a point of its chord; and of c'' = along +
across the axis at most |across| + |along| sin(phi) is across any chord.

A rational curve N/w with positive weights differs from the chord L, interpolated in homogeneous
coordinates, by (E_N - L E_w)/w, where E = (E_N, E_w) is the error of that interpolation. So with N
taken relative to a point o, its c'' is replaced by (N'' - (L - o) w'')/w, and L is no farther from
o than the control points are.
"""

from __future__ import annotations

import numpy as np

from ..bernstein.form import split

ROUNDING = 8 * float(np.finfo(float).eps)  # of a curve of size 1: edges that are none
TURNING = 0.3  # of its chords halving may save, if a segment turns 30 degrees from its axis
QUARTERS = 4


def chords(rows: np.ndarray, rational: bool, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Return a number of chords for every quarter, and how many of a segment halving may save.

    Numbers (k, 0, 0, 0) stand for k chords of the whole, where that takes no more of them. They
    are proved; what may be saved is an estimate.

    Parameters
    ----------
    rows : array, shape (n + 1, columns, m)
        Of moderate size; weights are positive. Segments stand last, where arrays are long.

    Returns
    -------
    arrays, shapes (4, m) and (m,)
    """
    n, count = len(rows) - 1, rows.shape[2]
    if n < 2:
        return _of_the_whole(np.ones(count)), np.zeros(count)
    points = rows
    if rational:
        w = rows[:, -1:]
        points = rows[:, :-1] / w
        points = points - (points.min(axis=0) + points.max(axis=0)) / 2
        w = w / w.max(axis=0)
        rows = np.concatenate([w * points, w], axis=1)
    axis = points[-1] - points[0]
    length = np.sqrt(_squares(axis[None])[0])
    axis = axis / np.where(length == 0, 1, length)
    sine = _widest_angle(np.diff(points, axis=0), axis)
    bends = rows[2:] - 2 * rows[1:-1] + rows[:-2]
    if n > 2:
        bends = _quarters(bends)
    sizes = _across(bends[:, : len(axis)], axis, sine)
    if rational:
        reach = _across(points, axis, sine).max(axis=0)
        sizes = (sizes + np.abs(bends[:, -1]) * reach) / w.min(axis=0)
    roots = np.sqrt(n * (n - 1) / 8 / tolerance * sizes).reshape(-1, n - 1, count)
    most = roots.max(axis=1)
    whole = np.maximum(np.ceil(most.max(axis=0)), 1)
    numbers = _of_the_whole(whole)
    if n > 2:
        quarters = np.maximum(np.ceil(most / QUARTERS), 1)
        numbers = np.where(quarters.sum(axis=0) < whole, quarters, numbers)
    uneven = (most - roots.mean(axis=1)).mean(axis=0)
    total = numbers.sum(axis=0)
    saved = np.maximum(uneven, TURNING * total * np.minimum(2 * sine, 1))
    if rational:  # away from the lightest point
        saved = np.maximum(saved, total * (1 - np.sqrt(w.min(axis=0) / w[:, 0]).mean(axis=0)))
    return numbers, saved


def _of_the_whole(numbers: np.ndarray) -> np.ndarray:
    out = np.zeros((QUARTERS, len(numbers)))
    out[0] = numbers
    return out


def _quarters(rows: np.ndarray) -> np.ndarray:
    """Return the Bernstein coefficients (k, columns, m) on all quarters, (4 k, columns, m)."""
    parts = rows[None]
    for _ in range(2):
        parts = np.stack(split(parts), axis=1).reshape(2 * len(parts), *rows.shape)
    return parts.reshape(QUARTERS * len(rows), *rows.shape[1:])


def _widest_angle(edges: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Return the sine of the widest angle of edges and axis, infinity above 45 degrees."""
    along, across = _parts(edges, axis)
    lengths = np.sqrt(along**2 + across**2)
    none = lengths <= ROUNDING
    sine = np.where(none, 0, across / np.where(none, 1, lengths)).max(axis=0)
    narrow = ((along >= across) | none).all(axis=0)
    return np.where(narrow, sine, np.inf)


def _across(vectors: np.ndarray, axis: np.ndarray, sine: np.ndarray) -> np.ndarray:
    """Return how long every vector may be, seen along any chord."""
    along, across = _parts(vectors, axis)
    with np.errstate(invalid="ignore"):  # 0 times infinity: not less than the whole
        return np.fmin(np.sqrt(along**2 + across**2), across + np.abs(along) * sine)


def _parts(vectors: np.ndarray, axis: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the components along the axis, and the lengths of what is across it."""
    along = sum(vectors[:, k] * axis[k] for k in range(len(axis)))
    return along, np.sqrt(_squares(vectors - along[:, None] * axis))


def _squares(vectors: np.ndarray) -> np.ndarray:
    total = vectors[:, 0] ** 2
    for k in range(1, vectors.shape[1]):
        total += vectors[:, k] ** 2
    return total

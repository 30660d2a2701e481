"""Pairs of pieces of two curves: cut, and left out where the pieces cannot meet.

Arrays hold both sides of k pairs: rows have shape (2, k, n + 1, columns).
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ..bernstein.evaluation import values_at
from ..bernstein.form import part

NOISE = 2.0**-48  # of the size of a pair: rounding errors of places, generously


class Pairs(NamedTuple):
    """Pairs of pieces that may meet, all of one width.

    Attributes
    ----------
    rows : array, shape (2, k, n + 1, columns)
    origin : array, shape (k,)
        Which pair of segments they are pieces of.
    start : array, shape (2, k)
        Parameters in [0, 1] on these; the pieces end at start + width.
    width : float
    """

    rows: np.ndarray
    origin: np.ndarray
    start: np.ndarray
    width: float

    def chosen(self, which: np.ndarray) -> Pairs:
        """Return some of the pairs."""
        return Pairs(self.rows[:, which], self.origin[which], self.start[:, which], self.width)


def plain(rows: np.ndarray, dim: int) -> np.ndarray:
    """Return control points (..., dim), NaN for a piece whose weights are not all positive.

    Such a piece may leave the hull of its control points; comparisons with NaN leave nothing out.
    """
    if rows.shape[-1] == dim:
        return rows
    w = rows[..., dim:]
    positive = (w > 0).all(axis=-2, keepdims=True)
    return np.where(positive, rows[..., :dim] / np.where(w == 0, 1, w), np.nan)


def points_at(rows: np.ndarray, u: np.ndarray, dim: int) -> np.ndarray:
    """Return the point of every row (k, n + 1, columns) at its own u."""
    values = values_at(rows, u)
    return values if values.shape[1] == dim else values[:, :dim] / values[:, dim:]


def cut(pairs: Pairs, parts: int, dim: int) -> Pairs:
    """Cut both pieces of every pair, and return the pairs of parts that may meet.

    Those are left out whose boxes are apart: boxes along the axes, and then boxes along and
    across the chord of either part.
    """
    count, columns = pairs.rows.shape[2:]
    rows = _matrix(count - 1, parts) @ pairs.rows
    rows = rows.reshape(2, -1, parts, count, columns)
    points = plain(rows, dim)
    low, high = points.min(axis=3), points.max(axis=3) + NOISE
    apart = (low[0][:, :, None] > high[1][:, None]) | (low[1][:, None] > high[0][:, :, None])
    pair, one, other = np.nonzero(~apart.any(axis=3))
    width = pairs.width / parts
    found = Pairs(
        np.stack([rows[0, pair, one], rows[1, pair, other]]),
        pairs.origin[pair],
        pairs.start[:, pair] + width * np.stack([one, other]),
        width,
    )
    return found.chosen(~_apart(plain(found.rows, dim)))


def _apart(points: np.ndarray) -> np.ndarray:
    """Return which pairs are apart along or across the chord of one of them."""
    chords = points[:, :, -1] - points[:, :, 0]
    with np.errstate(invalid="ignore"):
        chords /= np.sqrt((chords**2).sum(axis=2, keepdims=True))
    both = np.concatenate(points, axis=1) - points[0, :, :1]  # (k, 2 n + 2, dim)
    directions = chords.transpose(1, 0, 2)
    if points.shape[3] == 2:
        across = np.stack([-directions[..., 1], directions[..., 0]], axis=2)
        directions = np.concatenate([directions, across], axis=1)
    along = both @ directions.transpose(0, 2, 1)
    along = along.reshape(len(both), 2, points.shape[2], directions.shape[1])
    low, high = along.min(axis=2), along.max(axis=2)
    return (low > high[:, ::-1] + NOISE).any(axis=(1, 2))


def meet_once(points: np.ndarray) -> np.ndarray:
    """Return which pairs meet at most once, shown by their directions.

    If all edges of a control polygon are within an angle phi of its chord, so are the chords
    between any two points of the curve. Pieces that met twice would have such a chord in common;
    so they do not where the angle of their chords is larger than both phi together (Sederberg and
    Meyers, *Loop detection in surface patch intersections*, CAGD 5, 1988).
    """
    edges = points[:, :, 1:] - points[:, :, :-1]
    chords = points[:, :, -1:] - points[:, :, :1]
    none = (np.abs(edges) <= NOISE * 2**-4).all(axis=3)
    angles = np.where(none, 0, _angles(edges, chords)).max(axis=2)
    between = _angles(chords[0], chords[1])[:, 0]
    between = np.minimum(between, np.pi - between)
    with np.errstate(invalid="ignore"):
        once: np.ndarray = between > angles.sum(axis=0) + 1e-15
    return once & (angles < np.pi / 2).all(axis=0)


def _angles(vectors: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Return the angles between vectors and axis, small ones too with all their digits."""
    with np.errstate(invalid="ignore", divide="ignore"):
        axis = axis / np.sqrt((axis**2).sum(axis=-1, keepdims=True))
    along = (vectors * axis).sum(axis=-1, keepdims=True)
    across = vectors - along * axis
    return np.arctan2(np.sqrt((across**2).sum(axis=-1)), along[..., 0])


@lru_cache(maxsize=64)
def _matrix(degree: int, parts: int) -> np.ndarray:
    """Return the matrix from control points to those of equal parts, one below the other."""
    identity = np.repeat(np.eye(degree + 1)[None], parts, axis=0)
    ends = np.arange(parts + 1) / parts
    matrix = part(identity, ends[:-1], ends[1:]).reshape(-1, degree + 1)
    matrix.flags.writeable = False
    return matrix

"""Curves of any size at size one, where squares and products neither overflow nor vanish."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..bernstein.balance import balanced
from ..bernstein.evaluation import values_at

if TYPE_CHECKING:
    from ..curve import Curve


class Unit(NamedTuple):
    """A curve moved and scaled: its point p stands at p / scale - start.

    Attributes
    ----------
    rows : array, shape of the curve's rows
        Coordinates and weights of size 1; the first point is the origin.
    start : array, shape (dim,)
    scale : float
        A power of two, so that scaling rounds nothing.
    """

    rows: np.ndarray
    start: np.ndarray
    scale: float


def unit(curve: Curve) -> Unit:
    """Return the curve at size one, starting at the origin."""
    points, powers = _scaled(curve.rows[..., : curve.dim])
    if not curve.rational:
        start = points[0, 0].copy()
        return Unit(points - start, start, float(np.ldexp(1.0, powers)))
    weights, lower = _scaled(curve.rows[..., curve.dim :])
    start = points[0, 0] / weights[0, 0]
    rows = np.concatenate([points - weights * start, weights], axis=2)
    return Unit(rows, start, float(np.ldexp(1.0, powers - lower)))


def _scaled(array: np.ndarray) -> tuple[np.ndarray, int]:
    power = int(np.frexp(np.abs(array).max())[1]) - 1
    return np.ldexp(array, -power), power


def row_scales(rows: np.ndarray) -> np.ndarray:
    """Return for every row the power of two next to its largest entry from below, shape (m,).

    >>> row_scales(np.array([[3.0, -5.0], [0.0, 0.0]])).tolist()
    [4.0, 0.5]
    """
    size = np.abs(rows).max(axis=tuple(range(1, rows.ndim)))
    return np.ldexp(1.0, np.frexp(size)[1] - 1)  # twice as much may be infinite


def even(curve: Curve) -> tuple[Unit, np.ndarray]:
    """Return the curve at size one, its segments balanced, with their c: `before` leads back."""
    whole = unit(curve)
    rows, c = balanced(whole.rows, curve.dim)
    return whole._replace(rows=rows), c


def parameters(curve: Curve, segment: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Return the curve's parameters at the places u in [0, 1] of segments; ends are exact."""
    a, b = curve.breaks[segment], curve.breaks[segment + 1]
    return np.where(u == 1, b, np.minimum(a + u * (b - a), b))


def at_places(curve: Curve, segment: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Return the points (k, dim) at the places u in [0, 1] of segments, by the Bernstein form."""
    return plain(values_at(curve.rows[segment], u), curve.dim)


def plain(rows: np.ndarray, dim: int) -> np.ndarray:
    """Return points (..., dim) of rows that may be homogeneous: divided by their last column."""
    return rows if rows.shape[-1] == dim else rows[..., :dim] / rows[..., dim:]

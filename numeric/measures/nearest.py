"""The nearest point of a curve: the least of all local ones, which are roots of polynomials."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from symbolic.errors import BadValue, shown

from ..bernstein import form
from ..bernstein.balance import before
from ..bernstein.evaluation import values_at
from ..bernstein.roots import EPSILON, roots
from ..points import real_array
from .candidates import Tree, candidates, tree
from .scale import at_places, even, parameters, row_scales

if TYPE_CHECKING:
    from ..curve import Curve

CHUNK = 4096  # pairs of a point and a segment, solved at a time
SAME = 16 * EPSILON  # distances count as equal within it, relative to the numbers they come from


class Nearest(NamedTuple):
    """The nearest points of a curve to points of shape (..., dim).

    Attributes
    ----------
    t : array, shape (...)
        Parameters.
    points : array, shape (..., dim)
    distance : array, shape (...)
    """

    t: np.ndarray
    points: np.ndarray
    distance: np.ndarray


def nearest(curve: Curve, points: Any) -> Nearest:
    """Return the points of the curve that are nearest to given points, of all its segments.

    On a segment the distance is least at an end or where (c - p) . c' = 0, a polynomial of
    degree 2n - 1 for a polynomial curve. All its roots are compared, so no start is needed and
    none is missed. Segments are left out whose boxes are farther away than the curve is known
    to be.

    Parameters
    ----------
    points : one point (dim,), or any shape (..., dim)

    Returns
    -------
    Nearest
        t, points and distance. Of several nearest points, equally far within rounding, the one
        with the smallest parameter. Where segments do not meet at a break, both their ends count.

    Raises
    ------
    BadValue, BadType
        For points of another dimension, NaN and infinity.

    Examples
    --------
    >>> from numeric import Curve
    >>> found = Curve.from_bezier([[-1, 1], [0, -1], [1, 1]]).nearest([[0, -3], [1, 2]])
    >>> found.t, found.distance
    (array([0.5, 1. ]), array([3., 1.]))
    """
    given = real_array(points, "points")
    if given.ndim == 0 or given.shape[-1] != curve.dim:
        raise BadValue(
            f"points of dimension {curve.dim}", f"shape {given.shape}",
            f"Give (..., {curve.dim}) coordinates.",
        )  # fmt: skip
    if not np.isfinite(given).all():
        raise BadValue("finite coordinates", shown(points), "Leave such points out.")
    flat, shape = given.reshape(-1, curve.dim), given.shape[:-1]
    found = Nearest(np.empty(len(flat)), np.empty(flat.shape), np.empty(len(flat)))
    whole, c = even(curve)
    with np.errstate(over="ignore"):  # very distant points compare as infinitely far
        moved = flat / whole.scale - whole.start
        below = tree(whole.rows, curve.dim, len(flat))
        for point, piece in candidates(below.levels, moved):
            point, piece, u, distance = _least(below, moved, point, piece)
            segment, u = below.segment[piece], below.start[piece] + below.width * u
            u = before(u, c[segment])
            found.t[point] = parameters(curve, segment, u)
            found.points[point] = at_places(curve, segment, u)
            found.distance[point] = distance * whole.scale
    return Nearest(
        found.t.reshape(shape), found.points.reshape(given.shape), found.distance.reshape(shape)
    )


def _least(
    below: Tree, points: np.ndarray, point: np.ndarray, piece: np.ndarray
) -> tuple[np.ndarray, ...]:
    """Return (point, piece, u, distance) of the nearest one of each point's local ones."""
    local = []
    for first in range(0, len(point), CHUNK):
        pairs = slice(first, first + CHUNK)
        local.append(local_nearest(below.rows, points, point[pairs], piece[pairs]))
    point, piece, u, distance, blur = (
        np.concatenate(column) for column in zip(*local, strict=True)
    )
    names, name = np.unique(point, return_inverse=True)
    least = np.full(len(names), np.inf)
    np.minimum.at(least, name, distance)
    near = np.flatnonzero(distance <= least[name] + blur)
    along = below.segment[piece[near]] + below.start[piece[near]] + below.width * u[near]
    near = near[np.lexsort((along, point[near]))]
    near = near[np.diff(point[near], prepend=-1) > 0]
    return point[near], piece[near], u[near], distance[near]


def local_nearest(
    rows: np.ndarray, points: np.ndarray, point: np.ndarray, piece: np.ndarray
) -> tuple[np.ndarray, ...]:
    """Return (point, piece, u, distance, its rounding error) where pairs are locally nearest.

    With c - p = M/w half the derivative of the square of the distance, times w^3, is
    M . M' w - |M|^2 w'. Ends of pieces count only if the distance grows from there.
    """
    rows, p, dim = rows[piece], points[point], points.shape[1]
    if rows.shape[2] > dim:  # a common factor of a piece's weights is no matter
        rows = rows / row_scales(rows[..., dim:])[:, None, None]
    w = rows[..., dim:] if rows.shape[2] > dim else None
    apart = rows[..., :dim] - p[:, None] * (1 if w is None else w)
    scale = row_scales(apart)
    apart /= scale[:, None, None]
    size = np.abs(p).max(axis=1) + np.abs(rows).max(axis=(1, 2))
    slope = form.derivative(apart)
    f = form.product(apart, slope).sum(axis=2)
    steep = np.abs(slope).max(axis=(1, 2))
    if w is not None:
        turn = form.derivative(w[..., 0])
        f = form.product(f, w[..., 0]) - form.product(form.product(apart, apart).sum(axis=2), turn)
        f *= np.sign(w[:, 0])  # as w^3 has it
        steep = steep * np.abs(w).max(axis=(1, 2)) + np.abs(turn).max(axis=1)
    noise = SAME * (size / scale) * steep
    inner = roots(f, noise)
    first, last = np.flatnonzero(f[:, 0] >= -noise), np.flatnonzero(f[:, -1] <= noise)
    pair = np.concatenate([inner.row, first, last])
    u = np.concatenate([inner.u, np.zeros(len(first)), np.ones(len(last))])
    m = values_at(apart[pair], u)
    error = SAME * size[pair]
    if w is not None:
        below = np.abs(values_at(w[pair], u))
        m, error = m / below, error / below[:, 0]
    distance = np.sqrt(np.einsum("ij,ij->i", m, m)) * scale[pair]
    return point[pair], piece[pair], u, distance, error

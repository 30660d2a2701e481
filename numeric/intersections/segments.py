"""All intersections of many pairs of Bezier segments."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from symbolic.errors import BadValue

from ..bernstein.balance import balanced
from ..bernstein.form import elevate
from ..curves.making import read_segments
from .balance import unbalanced, unbalanced_arcs
from .pieces import points_at
from .places import Places
from .shared import Shared
from .subdivision import subdivided
from .touching import are_points, places_of_points

BATCH = 2048  # pairs of cubic segments at a time; of degree n, with n^2 in proportion


class SegmentIntersections(NamedTuple):
    """Where pairs of segments meet, sorted by pair and by parameter on the first one.

    Attributes
    ----------
    pair : array, shape (k,)
        The number of the pair.
    u, v : arrays, shape (k,)
        Parameters in [0, 1] on the first and the second segment.
    points : array, shape (k, dim)
        On the first one.
    distance : array, shape (k,)
        From there to the point of the second one: a rounding error at crossings.
    transversal : array of bool, shape (k,)
        Whether the tangents differ there. Otherwise the segments touch, or one has a cusp; at an
        angle of less than about 1e-6, rounding may hide which.
    shared_pair : array, shape (l,)
    shared : array, shape (l, 2, 2)
        Arcs that both segments of a pair have in common, within rounding: from (u, v) to (u, v).
        They may be cut at cusps, and are at folds.
    """

    pair: np.ndarray
    u: np.ndarray
    v: np.ndarray
    points: np.ndarray
    distance: np.ndarray
    transversal: np.ndarray
    shared_pair: np.ndarray
    shared: np.ndarray


def intersect_segments(first: Any, second: Any) -> SegmentIntersections:
    """Return all intersections of m pairs of polynomial Bezier segments.

    Parameters
    ----------
    first, second : arrays, shape (m, n + 1, dim)
        Control points, with dim 2 or more; the degrees of the two may differ.

    Returns
    -------
    SegmentIntersections

    Raises
    ------
    BadValue, BadType
        For other shapes, or coordinates that are not finite.

    Notes
    -----
    Every intersection where the tangents differ is found, unless the segments run alongside each
    other closer than about 1e-7 of their size there. Where they touch, the place with the least
    distance is told if that is below 1e-13 of their size.

    Examples
    --------
    >>> arch, line = [[0, 0], [1, 2], [2, 0]], [[0, 0.5], [2, 0.5]]
    >>> intersect_segments([arch], [line]).points.round(6)
    array([[0.292893, 0.5     ],
           [1.707107, 0.5     ]])
    """
    rows = [read_segments(segments) for segments in (first, second)]
    if len(rows[0]) != len(rows[1]) or rows[0].shape[2] != rows[1].shape[2]:
        raise BadValue(
            "as many first as second segments, of one dimension",
            f"shapes {rows[0].shape} and {rows[1].shape}",
            "Repeat a segment that is to meet several.",
        )
    return intersect_rows(rows[0], rows[1], rows[0].shape[2])


def intersect_rows(first: np.ndarray, second: np.ndarray, dim: int) -> SegmentIntersections:
    """Return all intersections of pairs of rows, both homogeneous if they have a column more."""
    places, arcs = places_and_arcs(first, second, (np.arange(len(first)),) * 2, dim)
    places = places.chosen(np.lexsort((places.at[1], places.at[0], places.pair)))
    points, others = (points_at(rows[places.pair], at, dim)
                      for rows, at in zip((first, second), places.at, strict=True))  # fmt: skip
    return SegmentIntersections(
        places.pair, places.at[0], places.at[1], points, lengths(points - others),
        places.transversal, arcs.pair, arcs.ends(),
    )  # fmt: skip


def places_and_arcs(
    first: np.ndarray, second: np.ndarray, pairs: tuple[np.ndarray, np.ndarray], dim: int
) -> tuple[Places, Shared]:
    """Return where pairs (i, j) of rows meet, each place once, and the arcs they share."""
    if dim < 2:
        raise BadValue("curves in the plane or in space", "curves on a line", "Add a coordinate.")
    degree = max(first.shape[1], second.shape[1], 2) - 1
    sides = [elevate(rows, degree + 1 - rows.shape[1]) for rows in (first, second)]
    places, arcs = [Places.none()], [Shared.none()]
    size = max(1, 9 * BATCH // max(3, degree) ** 2)
    for start in range(0, len(pairs[0]), size):
        chosen = zip(sides, pairs, strict=True)
        batch = np.stack([rows[k[start : start + size]] for rows, k in chosen])
        batch, c = balanced(batch, dim)
        batch = moderate(batch, dim)
        point = are_points(batch, dim)
        moving = np.flatnonzero(~point.any(axis=0))
        if len(moving) < len(point[0]):
            found = places_of_points(batch, point, dim)
            places.append(found._replace(pair=start + found.pair))
        found, more = subdivided(batch[:, moving], dim)
        found, more = unbalanced(found, c[:, moving]), unbalanced_arcs(more, c[:, moving])
        places.append(found._replace(pair=start + moving[found.pair]))
        arcs.append(more._replace(pair=start + moving[more.pair]))
    return Places.all_of(places), Shared.all_of(arcs)


def moderate(rows: np.ndarray, dim: int) -> np.ndarray:
    """Return pairs of rows (2, m, n + 1, columns) moved and scaled, by pair, to size 1."""
    points, w = rows[..., :dim], rows[..., dim:]
    if w.shape[3]:
        largest = np.abs(w).max(axis=2, keepdims=True) * np.sign(w[:, :, :1])
        largest[largest == 0] = 1
        points, w = points / largest, w / largest
    power = np.frexp(np.abs(points).max(axis=(0, 2, 3)))[1]
    points = np.ldexp(points, -power[:, None, None])
    if not w.shape[3]:
        return points - points[:1, :, :1]
    return np.concatenate([points - points[:1, :, :1] / w[:1, :, :1] * w, w], axis=3)


def lengths(vectors: np.ndarray) -> np.ndarray:
    """Return the lengths of vectors (k, dim), also where their squares would overflow or vanish."""
    size = np.abs(vectors).max(axis=1, keepdims=True)
    size = np.where(size == 0, 1, size)
    return np.sqrt(((vectors / size) ** 2).sum(axis=1)) * size[:, 0]

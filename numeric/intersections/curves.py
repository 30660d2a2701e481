"""Intersections of two curves of any number of segments."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from symbolic.errors import BadType, BadValue, shown

from ..curves.pieces import MEETING
from ..measures.boxes import control_boxes
from ..measures.scale import parameters
from .near import meeting
from .places import Places
from .segments import lengths, places_and_arcs, points_at
from .shared import SHORT, Shared

if TYPE_CHECKING:
    from ..curve import Curve

SLACK = 1e-13  # of the size of both curves: pieces so close may touch


class Intersections(NamedTuple):
    """Where a curve meets another one or a line, sorted by the parameter on the first.

    Attributes
    ----------
    t, s : arrays, shape (k,)
        Parameters on the curve, and on the other one.
    points : array, shape (k, dim)
        On the curve.
    distance : array, shape (k,)
        From there to the other curve's point: a rounding error at crossings.
    transversal : array of bool, shape (k,)
        Whether the tangents differ there. Otherwise the curves touch, or one has a cusp.
    shared : array, shape (l, 2, 2)
        Arcs that both have in common, within rounding: from (t, s) to (t, s).
    """

    t: np.ndarray
    s: np.ndarray
    points: np.ndarray
    distance: np.ndarray
    transversal: np.ndarray
    shared: np.ndarray


def intersect(curve: Curve, other: Curve) -> Intersections:
    """Return all points where the curve meets another one.

    Every intersection where the tangents differ is found, unless the curves run alongside each
    other closer than about 1e-8 of their size there. Where they touch, the place with the least
    distance is told, if that is below 1e-13 of the segments' size. Ends count. A closed curve's
    start and end are one place.

    Parameters
    ----------
    other : Curve
        Of the same dimension, 2 or more.

    Returns
    -------
    Intersections
        With t and s, points, distance, transversal; arcs in common are in `shared`, and not
        among the points.

    Raises
    ------
    BadType, BadValue
        For what is not a curve, or one of another dimension.

    Notes
    -----
    Subdivision leaves out pieces whose boxes are apart, along the axes or along and across their
    chords, and solves by Newton's method for pieces that meet at most once, as their directions
    show (Sederberg and Meyers, 1988).

    Examples
    --------
    >>> from numeric import Curve
    >>> arch = Curve.from_bezier([[0, 0], [1, 2], [2, 0]])
    >>> found = arch.intersect(Curve.from_bezier([[0, 0], [2, 1]]))
    >>> found.t, found.points
    (array([0.  , 0.75]), array([[0.  , 0.  ],
           [1.5 , 0.75]]))
    """
    if not hasattr(other, "with_rows"):
        raise BadType("a Curve", shown(other), "Make one with a method Curve.from_...")
    if other.dim != curve.dim or curve.dim < 2:
        raise BadValue(
            "two curves of one dimension, 2 or more", f"dimensions {curve.dim} and {other.dim}",
            "Add the coordinates that are missing, with Curve.transform.",
        )  # fmt: skip
    dim = curve.dim
    first, second = curve.rows, other.rows
    if curve.rational != other.rational:
        first, second = curve.homogeneous, other.homogeneous
    i, j = _near(curve, other)
    found, arcs = places_and_arcs(first, second, (i, j), dim)
    places = Places(
        np.zeros(len(found.pair), np.intp),
        found.at + [i[found.pair], j[found.pair]],
        found.error,
        found.transversal,
    )
    samples = arcs.samples + np.stack([i[arcs.pair], j[arcs.pair]], axis=1)[:, :, None]
    for side, c in enumerate((curve, other)):
        places = at_one_seam(places, side, c)
    places = _off_arcs(places, Shared(i[arcs.pair], samples), curve, other).single()
    places = places.chosen(np.lexsort((places.at[1], places.at[0])))
    (k, u), (m, v) = (
        segment_and_u(at, len(c)) for at, c in zip(places.at, (curve, other), strict=True)
    )
    points = points_at(curve.rows[k], u, dim)
    distance = lengths(points - points_at(other.rows[m], v, dim))
    shared = joined(samples[:, :, [0, -1]].transpose(0, 2, 1), SHORT)
    for side, c in enumerate((curve, other)):
        ends = parameters(c, *segment_and_u(shared[..., side].ravel(), len(c)))
        shared[..., side] = ends.reshape(-1, 2)
    return Intersections(
        parameters(curve, k, u), parameters(other, m, v), points, distance,
        places.transversal, shared,
    )  # fmt: skip


def _near(curve: Curve, other: Curve) -> tuple[np.ndarray, np.ndarray]:
    """Return the pairs of segments whose boxes meet; segments that are joints are left out."""
    slack = SLACK * max(np.abs(c.points).max() for c in (curve, other))
    first, second = _without_joints(curve), _without_joints(other)
    low, high = control_boxes(curve.rows[first], curve.dim)
    there = control_boxes(other.rows[second], other.dim)
    i, j = meeting((low - slack, high + slack), there)
    return first[i], second[j]


def _without_joints(curve: Curve) -> np.ndarray:
    """Return the numbers of segments, without those that are the end of the one before.

    Nor those that are the start of the one after: all their points are found on others.
    """
    points = curve.points
    point = (points == points[:, :1]).all(axis=(1, 2))
    if not point.any():
        return np.arange(len(points))
    joined = (points[1:, 0] == points[:-1, -1]).all(axis=1)
    moving = np.flatnonzero(~point)
    number = np.arange(len(points))
    after = np.append(moving, len(points))[np.searchsorted(moving, number)]
    gaps = np.append(0, np.cumsum(~joined))  # two segments hang together if they have as many
    leads = (after < len(points)) & (gaps[np.minimum(after, len(points) - 1)] == gaps)
    return number[~point | ~(np.append(False, joined) | leads)]


def segment_and_u(at: np.ndarray, segments: int) -> tuple[np.ndarray, np.ndarray]:
    """Return segment and u in [0, 1] of places counted in segments."""
    segment = np.minimum(at.astype(np.intp), segments - 1)
    return segment, at - segment


def at_one_seam(places: Places, side: int, curve: Curve) -> Places:
    """Return places with the end of a closed curve told as its start."""
    if not _is_closed(curve):
        return places
    at = places.at.copy()
    at[side, at[side] >= len(curve) - np.minimum(places.error[side], SHORT)] = 0
    return places._replace(at=at)


def _is_closed(curve: Curve) -> bool:
    points = curve.points
    return bool(np.abs(points[-1, -1] - points[0, 0]).max() <= MEETING * np.abs(points).max())


def _off_arcs(places: Places, arcs: Shared, curve: Curve, other: Curve) -> Places:
    """Return the places that do not lie on arcs, whose `pair` is the segment of `curve`.

    An arc may end at the end of a closed curve, which places tell as its start.
    """
    if not len(arcs.pair):
        return places
    arcs = Shared.all_of([arcs])
    on = np.zeros(len(places.pair), bool)
    turns = [(0, len(c)) if _is_closed(c) else (0,) for c in (curve, other)]
    for turn in product(*turns):
        at = places.at + np.array(turn)[:, None]
        for beside in (-SHORT, SHORT):
            segment = np.floor(at[0] + beside).astype(np.intp)
            on |= arcs.beside(places._replace(pair=segment, at=at))
    return places.chosen(~on)


def joined(ends: np.ndarray, near: float) -> np.ndarray:
    """Return both ends of all arcs (l, 2, 2), those that continue each other as one."""
    if not len(ends):
        return ends
    ends = ends[np.lexsort((ends[:, 0, 1], ends[:, 0, 0]))]
    apart = (np.abs(ends[1:, 0] - ends[:-1, 1]) > near).any(axis=1)
    first = np.flatnonzero(np.append(True, apart))
    last = np.append(first[1:], len(ends)) - 1
    return np.stack([ends[first, 0], ends[last, 1]], axis=1)

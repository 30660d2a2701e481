"""Intersections of two curves of any number of segments."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from symbolic.errors import BadType, BadValue, shown

from ..measures.boxes import control_boxes
from .near import meeting
from .pieces import points_at
from .places import Places
from .segments import lengths, places_and_arcs
from .shared import SHORT, Shared
from .track import Track, runs, without_joints

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
        Whether the tangents differ there. Otherwise the curves touch, or one has a cusp; at an
        angle of less than about 1e-6, rounding may hide which.
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
    other closer than about 1e-7 of their size there. Where they touch, the place with the least
    distance is told, if that is below 1e-13 of the size: the largest coordinate of both segments.
    Ends count. A closed curve's start and end are one place, and so are the parameters at which a
    curve stands still.

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

    An arc in common is found by its ends, where one of the segments ends or turns back. Of curves
    that halt more than forty times where they meet, arcs that end at a halt are not told; a place
    on them is, as touching. Where a curve of several segments runs over the same points more than
    once, its arcs may be told segment by segment.

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
    tracks = Track.of(curve), Track.of(other)
    there = [
        track.once(number[found.pair], u, error)
        for track, number, u, error in zip(tracks, (i, j), found.at, found.error, strict=True)
    ]
    at = np.stack([track.along(*place) for track, place in zip(tracks, there, strict=True)])
    places = Places(np.zeros_like(found.pair), at, found.error + np.spacing(at), found.transversal)
    numbers = np.stack([i[arcs.pair], j[arcs.pair]])
    starts = np.stack([track.first[k] for track, k in zip(tracks, numbers, strict=True)], axis=1)
    samples = arcs.samples + starts[:, :, None]
    kept = np.flatnonzero(~_on_arcs(places, numbers[0], samples, tracks))
    kept = kept[places.chosen(kept).kept()]
    t, s = (track.parameters(*place) for track, place in zip(tracks, there, strict=True))
    kept = kept[np.lexsort((s[kept], t[kept]))]
    (k, u), (m, v) = ((segment[kept], u[kept]) for segment, u in there)
    points = points_at(curve.rows[k], u, dim)
    return Intersections(
        t[kept], s[kept], points,
        lengths(points - points_at(other.rows[m], v, dim)), places.transversal[kept],
        _shared(tracks, numbers, arcs.ends(), samples),
    )  # fmt: skip


def _shared(
    tracks: tuple[Track, Track], numbers: np.ndarray, ends: np.ndarray, samples: np.ndarray
) -> np.ndarray:
    """Return the parameters at both ends of all arcs, those that continue each other as one."""
    first, last = runs(samples[:, :, [0, -1]].transpose(0, 2, 1), SHORT)
    shared = [
        [
            track.parameters(number[arc], ends[arc, end, side])
            for end, arc in ((0, first), (1, last))
        ]
        for side, (track, number) in enumerate(zip(tracks, numbers, strict=True))
    ]
    return np.moveaxis(np.array(shared), (0, 1, 2), (2, 1, 0))


def _near(curve: Curve, other: Curve) -> tuple[np.ndarray, np.ndarray]:
    """Return the pairs of segments whose boxes meet; segments that are joints are left out."""
    slack = SLACK * max(np.abs(c.points).max() for c in (curve, other))
    first, second = without_joints(curve), without_joints(other)
    low, high = control_boxes(curve.rows[first], curve.dim)
    there = control_boxes(other.rows[second], other.dim)
    i, j = meeting((low - slack, high + slack), there)
    return first[i], second[j]


def _on_arcs(
    places: Places, segment: np.ndarray, samples: np.ndarray, tracks: tuple[Track, Track]
) -> np.ndarray:
    """Return which places lie on arcs: those on `segment` of the first curve.

    An arc may end at the end of a closed curve, which places tell as its start.
    """
    on = np.zeros(len(places.pair), bool)
    if not len(samples):
        return on
    arcs = Shared.all_of([Shared(tracks[0].first[segment], samples)])
    for turn in product(*((0, track.length) if track.closed else (0,) for track in tracks)):
        at = places.at + np.array(turn)[:, None]
        for beside in (-SHORT, SHORT):
            start = np.floor(at[0] + beside).astype(np.intp)
            on |= arcs.beside(places._replace(pair=start, at=at))
    return on

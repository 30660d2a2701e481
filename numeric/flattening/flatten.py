"""Adaptive flattening: halvings where a curve bends unevenly, then equal parts of each piece."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from symbolic.errors import BadValue, shown

from ..bernstein.form import split
from ..curves.pieces import MEETING
from ..points import real_number
from ..tape.runner import CHUNK
from .chords import QUARTERS, ROUNDING, chords

if TYPE_CHECKING:
    from ..curve import Curve

EPSILON = float(np.finfo(float).eps)
WORTH = 60  # chords: evaluating them takes longer than a halving
DEEPEST = 48  # halvings, at a cusp or where weights almost vanish
BLOCK = 2048  # segments, whose pieces fit in the cache
MOST_PIECES = 1 << 15  # of a block
MOST_POINTS = 10**8


class Pieces(NamedTuple):
    """Parts of segments, each to be cut into equal chords: parameters and numbers of chords."""

    segment: np.ndarray
    start: np.ndarray
    width: np.ndarray
    chords: np.ndarray


def flatten(curve: Curve, tolerance: Any) -> np.ndarray:
    """Return the vertices of a polyline along the curve that stays within a tolerance of it.

    Every point of the curve is within the tolerance of the chord between its neighbours on the
    polyline, and every point of that chord within it of the curve (a proved bound, not an
    estimate, up to rounding). Both ends of every segment are vertices; where two segments do not
    meet, both sides of the gap are.

    Parameters
    ----------
    tolerance : number > 0
        A distance. One below rounding, 2e-15 of the largest coordinate, is taken as that.

    Returns
    -------
    array, shape (k, dim)

    Raises
    ------
    BadValue
        For a tolerance that is not positive, or takes more than 10^8 points.

    Notes
    -----
    Parameters are no closer than 1e-15 of the largest break. A curve that bends between two of
    them, by weights as 1 and 1e-16 or a short segment far from 0, is not resolved there.

    Examples
    --------
    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2], [2, 0]]).flatten(0.25)
    array([[0., 0.],
           [1., 1.],
           [2., 0.]])
    """
    t, ends, last = _vertices(curve, tolerance)
    out = curve(t).T
    out[:, ends] = curve.points[last, -1].T
    return out.T


def flat_parameters(curve: Curve, tolerance: Any) -> np.ndarray:
    """Return the parameters of the vertices of `flatten`; at a gap, its parameter twice.

    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2], [2, 0]], (0, 2)).flat_parameters(0.1)
    array([0. , 0.5, 1. , 1.5, 2. ])
    """
    return _vertices(curve, tolerance)[0]


def _vertices(curve: Curve, tolerance: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return all parameters, which of them are ends of a segment, and of which segments."""
    number = real_number(tolerance, "a tolerance")
    if number <= 0:
        raise BadValue("a tolerance > 0, a distance", shown(tolerance), "Such as 0.01.")
    pieces = _pieces(curve, number)
    points = curve.points
    size = np.abs(points).max()
    gaps = np.abs(points[1:, 0] - points[:-1, -1]).max(axis=1, initial=0) > MEETING * size
    last = np.append(pieces.segment[1:] > pieces.segment[:-1], True)
    last[last] = np.append(gaps, True)
    counts = pieces.chords.astype(np.int64)
    counts[last] += 1
    stops = np.append(0, np.cumsum(counts))
    if stops[-1] > MOST_POINTS:
        raise BadValue(
            f"a tolerance that takes at most {MOST_POINTS:g} points",
            f"{number:g}, which takes {stops[-1]:g}",
            "Flatten with a larger tolerance, or the curve in parts.",
        )
    t = _spaced(pieces.start, pieces.width / pieces.chords, stops)
    ends, segments = stops[1:][last] - 1, pieces.segment[last]
    t[ends] = curve.breaks[segments + 1]
    return t, ends, segments


def _spaced(start: np.ndarray, step: np.ndarray, stops: np.ndarray) -> np.ndarray:
    """Return start, start + step, ... of every piece i, from place stops[i] to stops[i + 1]."""
    out = np.empty(stops[-1])
    before, counts = stops[:-1].astype(float), np.diff(stops)
    first = 0
    while first < len(counts):  # as many pieces at once as fit in the cache
        last = max(first + 1, int(np.searchsorted(stops, stops[first] + CHUNK, side="right")) - 1)
        held = slice(first, last)
        own, part = counts[held], np.arange(stops[first], stops[last], dtype=float)
        part -= np.repeat(before[held], own)
        part *= np.repeat(step[held], own)
        np.add(part, np.repeat(start[held], own), out=out[stops[first] : stops[last]])
        first = last
    return out


def _pieces(curve: Curve, tolerance: float) -> Pieces:
    """Return all pieces in order."""
    rows, size = _moderate(curve)
    relative = max(tolerance / size if size else 1.0, ROUNDING)
    blocks = [
        _halved(rows[..., first : first + BLOCK], curve.rational, relative, first)
        for first in range(0, len(curve), BLOCK)
    ]
    segment, start, width, count = (np.concatenate(column) for column in zip(*blocks, strict=True))
    lengths, breaks = np.diff(curve.breaks)[segment], curve.breaks[segment]
    start, width = breaks + start * lengths, width * lengths
    finest = width / (4 * EPSILON * np.abs(curve.breaks).max())
    pieces = Pieces(segment, start, width, np.clip(np.floor(finest), 1, count))
    apart = start < np.append(start[1:], curve.breaks[-1])
    return pieces if apart.all() else Pieces(*(column[apart] for column in pieces))


def _halved(rows: np.ndarray, rational: bool, tolerance: float, first: int) -> Pieces:
    """Halve segments, numbered from `first` on, where that may save chords."""
    segment = np.arange(first, first + rows.shape[2])
    start, width = np.zeros(len(segment)), 1.0
    done = []
    for depth in range(DEEPEST + 1):
        count, saved = _chords(rows, rational, tolerance)
        enough = (saved <= WORTH) | (depth == DEEPEST)
        if len(segment) > MOST_PIECES:
            enough |= saved < np.inf
        done.append(_in_quarters(segment[enough], start[enough], width, count[:, enough]))
        going_on = np.flatnonzero(~enough)
        if not len(going_on):
            break
        width /= 2
        segment, start = np.tile(segment[going_on], 2), np.tile(start[going_on], 2)
        start[len(going_on) :] += width
        halves = split(np.moveaxis(rows.take(going_on, axis=-1), -1, 0))
        rows = np.concatenate([np.moveaxis(half, 0, -1) for half in halves], axis=-1)
    if len(done) == 1:
        return done[0]
    pieces = Pieces(*(np.concatenate(column) for column in zip(*done, strict=True)))
    order = np.lexsort((pieces.start, pieces.segment))
    return Pieces(*(column[order] for column in pieces))


def _in_quarters(segment: np.ndarray, start: np.ndarray, width: float, count: np.ndarray) -> Pieces:
    """Return the quarters of pieces of one width, or a whole piece where it stands for all."""
    own, quarter = np.nonzero(count.T)
    widths = np.where(count[1] == 0, width, width / QUARTERS)[own]
    return Pieces(segment[own], start[own] + quarter * widths, widths, count.T[own, quarter])


def _chords(rows: np.ndarray, rational: bool, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Return `chords`; a piece whose weights are not all positive is to be halved."""
    if not rational or (rows[:, -1] > 0).all():
        return chords(rows, rational, tolerance)
    count, saved = np.ones((QUARTERS, rows.shape[2])), np.full(rows.shape[2], np.inf)
    positive = np.flatnonzero((rows[:, -1] > 0).all(axis=0))
    if len(positive):
        count[:, positive], saved[positive] = chords(rows[..., positive], rational, tolerance)
    return count, saved


def _moderate(curve: Curve) -> tuple[np.ndarray, float]:
    """Return rows (n + 1, columns, segments) of moderate size, and the size of the points.

    Points are divided by the largest coordinate, weights by the largest of their segment.
    """
    size = float(np.abs(curve.points).max())
    rows = np.ascontiguousarray(np.moveaxis(curve.rows, 0, -1))
    if curve.rational:
        w = rows[:, -1:]
        rows = rows / (np.abs(w).max(axis=0) * np.sign(w[0]))
        rows[:, :-1] /= size or 1.0
        return rows, size
    return rows / (size or 1.0), size

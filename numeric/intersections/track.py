"""Places along a whole curve: which segment, where on it, and which places are one."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..curves.pieces import MEETING
from ..measures.scale import parameters
from .places import SAME
from .shared import SHORT

if TYPE_CHECKING:
    from ..curve import Curve


class Track(NamedTuple):
    """A curve's segments in a row: each has the length 1, or 0 if the curve stands still on it.

    Attributes
    ----------
    curve : Curve
    first : array, shape (segments,)
        Where each starts: after the segments before it, and 1 for every gap between them.
    lengths : array, shape (segments,)
    closed : bool
        Whether the end of the last segment is the start of the first one.
    """

    curve: Curve
    first: np.ndarray
    lengths: np.ndarray
    closed: bool

    @classmethod
    def of(cls, curve: Curve) -> Track:
        """Return the track of a curve."""
        points = curve.points
        start, end = points[:, 0], points[:, -1]
        gaps = np.abs(start - np.roll(end, 1, axis=0)).max(axis=1) > MEETING * np.abs(points).max()
        gaps, closed = np.append(0, gaps[1:]), not gaps[0]
        lengths = (~standing(curve)).astype(np.intp)
        return cls(curve, np.cumsum(np.append(0, lengths[:-1]) + gaps), lengths, closed)

    @property
    def length(self) -> int:
        """The length of all segments and gaps."""
        return int(self.first[-1] + self.lengths[-1])

    def along(self, segment: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return how far along the track places are."""
        return self.first[segment] + self.lengths[segment] * u

    def once(
        self, segment: np.ndarray, u: np.ndarray, error: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return segment and u with the end of a closed curve told as its start."""
        seam = self.along(segment, u) >= self.length - np.clip(error, SAME, SHORT)
        seam &= self.closed
        return np.where(seam, 0, segment), np.where(seam, 0, u)

    def parameters(self, segment: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the curve's parameters; the end of a segment before a gap is just before it."""
        t = parameters(self.curve, segment, u)
        after = np.append(self.first, self.length)[segment + 1]
        before_gap = after > self.first[segment] + self.lengths[segment]
        before_gap &= t >= self.curve.breaks[segment + 1]
        return np.where(before_gap, np.nextafter(t, self.curve.breaks[0]), t)


def standing(curve: Curve) -> np.ndarray:
    """Return on which segments the curve stands still: all control points are one, if rounded."""
    points = curve.points
    noise = 4 * np.spacing(np.abs(points[:, :1])) * curve.rational  # points are w x / w
    still: np.ndarray = (np.abs(points - points[:, :1]) <= noise).all(axis=(1, 2))
    return still


def without_joints(curve: Curve) -> np.ndarray:
    """Return the numbers of segments, without those that are the end of the one before.

    Nor those that are the start of the one after: all their points are found on others.
    """
    points, point = curve.points, standing(curve)
    if not point.any():
        return np.arange(len(points))
    joined = (points[1:, 0] == points[:-1, -1]).all(axis=1)
    moving = np.flatnonzero(~point)
    number = np.arange(len(points))
    after = np.append(moving, len(points))[np.searchsorted(moving, number)]
    gaps = np.append(0, np.cumsum(~joined))  # two segments hang together if they have as many
    leads = (after < len(points)) & (gaps[np.minimum(after, len(points) - 1)] == gaps)
    return number[~point | ~(np.append(False, joined) | leads)]


def runs(ends: np.ndarray, near: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the first and the last one of arcs that continue each other.

    Arcs run from ends[:, 0] to ends[:, 1], places (t, s) on two tracks. Where a curve turns back,
    its arc ends.

    >>> ends = np.array([[[1.0, 3.0], [2.0, 4.0]], [[0.0, 2.0], [1.0, 3.0]]])
    >>> [k.tolist() for k in runs(ends, 1e-6)]
    [[1], [0]]
    """
    order = np.lexsort((ends[:, 0, 1], ends[:, 0, 0]))
    sorted_ = ends[order]
    apart = (np.abs(sorted_[1:, 0] - sorted_[:-1, 1]) > near).any(axis=1)
    forward = sorted_[:, 1, 1] > sorted_[:, 0, 1]
    apart |= forward[1:] != forward[:-1]
    first = np.flatnonzero(np.append(True, apart)[: len(ends)])
    last = np.append(first[1:], len(ends))[: len(first)] - 1
    return order[first], order[last]

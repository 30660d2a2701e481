"""Places along a whole curve: which segment, where on it, and which places are one."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..curves.pieces import MEETING
from ..measures.scale import parameters
from .shared import SHORT

if TYPE_CHECKING:
    from ..curve import Curve


class Track(NamedTuple):
    """A curve's segments in a row, each of length 1.

    Attributes
    ----------
    curve : Curve
    first : array, shape (segments,)
        Where each starts: at its number, and 1 farther for every gap before it.
    closed : bool
        Whether the end of the last segment is the start of the first one.
    """

    curve: Curve
    first: np.ndarray
    closed: bool

    @classmethod
    def of(cls, curve: Curve) -> Track:
        """Return the track of a curve."""
        points = curve.points
        start, end = points[:, 0], points[:, -1]
        gaps = np.abs(start - np.roll(end, 1, axis=0)).max(axis=1) > MEETING * np.abs(points).max()
        gaps, closed = np.append(0, gaps[1:]), not gaps[0]
        return cls(curve, np.arange(len(points)) + np.cumsum(gaps), closed)

    @property
    def length(self) -> int:
        """The length of all segments and gaps."""
        return int(self.first[-1]) + 1

    def along(self, segment: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return how far along the track places are."""
        return self.first[segment] + u

    def once(
        self, segment: np.ndarray, u: np.ndarray, error: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return segment and u with the end of a closed curve told as its start."""
        seam = (segment == len(self.first) - 1) & (u >= 1 - np.minimum(error, SHORT))
        seam &= self.closed
        return np.where(seam, 0, segment), np.where(seam, 0, u)

    def parameters(self, segment: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the curve's parameters; the end of a segment before a gap is just before it."""
        t = parameters(self.curve, segment, u)
        after = np.append(self.first, self.length)[segment + 1]
        before_gap = (t >= self.curve.breaks[segment + 1]) & (after > self.first[segment] + 1)
        return np.where(before_gap, np.nextafter(t, self.curve.breaks[0]), t)


def runs(ends: np.ndarray, near: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the first and the last one of arcs that continue each other.

    Arcs run from ends[:, 0] to ends[:, 1], places (t, s) on two tracks.

    >>> ends = np.array([[[1.0, 3.0], [2.0, 4.0]], [[0.0, 2.0], [1.0, 3.0]]])
    >>> [k.tolist() for k in runs(ends, 1e-6)]
    [[1], [0]]
    """
    order = np.lexsort((ends[:, 0, 1], ends[:, 0, 0]))
    sorted_ = ends[order]
    apart = (np.abs(sorted_[1:, 0] - sorted_[:-1, 1]) > near).any(axis=1)
    first = np.flatnonzero(np.append(True, apart)[: len(ends)])
    last = np.append(first[1:], len(ends))[: len(first)] - 1
    return order[first], order[last]

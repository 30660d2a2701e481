"""Which segment a parameter belongs to: a table of equal buckets over unequal spans."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

BUCKETS = 16  # a span
LEAST_BUCKETS = 1 << 11
MOST_BUCKETS = 1 << 19  # more fall out of the cache
STEPS = 4  # from segment to segment inside a bucket, before searching

Gather = Callable[[np.ndarray, np.ndarray], Any]


class Workspace(NamedTuple):
    """Arrays that are used chunk after chunk: new ones cost more than what is done with them."""

    numbers: np.ndarray
    buckets: np.ndarray
    segments: np.ndarray

    @classmethod
    def of(cls, size: int) -> Workspace:
        """Make one for chunks of at most this size."""
        return cls(np.empty(size), np.empty(size, np.intp), np.empty(size, np.intp))


@dataclass(frozen=True)
class Spans:
    """Increasing breaks, and for every bucket the first segment that may hold its parameters.

    Segment i lives on [breaks[i], breaks[i + 1]), the last one on its end as well.
    """

    breaks: np.ndarray
    ends: np.ndarray  # of the segments, of the last one infinity
    first: np.ndarray
    per_unit: float

    @classmethod
    def over(cls, breaks: np.ndarray) -> Spans:
        """Make the table for breaks.

        A bucket's number never falls as t grows, rounded or not: no parameter of a bucket is
        below a break of an earlier one.
        """
        segments = len(breaks) - 1
        count = min(max(BUCKETS * segments, LEAST_BUCKETS), MOST_BUCKETS) if segments > 1 else 1
        with np.errstate(over="ignore"):
            per_unit = float(count / (breaks[-1] - breaks[0]))
        if not np.isfinite(per_unit):  # a domain shorter than 1e-302: all in one bucket
            per_unit = 0.0
        buckets = ((breaks[:-1] - breaks[0]) * per_unit).astype(np.intp)
        first = np.maximum(np.searchsorted(buckets, np.arange(count)) - 1, 0)
        return cls(breaks, np.append(breaks[1:-1], np.inf), first, per_unit)

    def locate(self, t: np.ndarray, work: Workspace) -> tuple[bool, Gather]:
        """Return whether all t belong to one segment, and how to gather what belongs to them.

        `gather(row, into)` returns the entry of `row` for the segment of every t, in the array
        `into` where that is faster, or one number for all. A t outside the domain belongs to the
        first or last segment.
        """
        if len(self.breaks) == 2:
            return True, lambda row, into: row[0]
        low, high = (self._search(end) for end in (t[0], t[-1]))
        if 8 * (high - low) > len(t) or not (t[1:] >= t[:-1]).all():
            segment = self.segment(t, work)
            return False, lambda row, into: row.take(segment, None, into, "clip")
        if low == high:
            return True, lambda row, into: row[low]
        held, cuts = slice(low, high + 1), np.zeros(high - low + 2, np.intp)
        cuts[1:-1], cuts[-1] = t.searchsorted(self.breaks[low + 1 : high + 1]), len(t)
        counts = cuts[1:] - cuts[:-1]
        return False, lambda row, into: np.repeat(row[held], counts)

    def segment(self, t: np.ndarray, work: Workspace | None = None) -> np.ndarray:
        """Return the index of the segment of every t, in `work.segments` if that is given."""
        work = work or Workspace.of(len(t))
        numbers, buckets, segment = (array[: len(t)] for array in work)
        np.subtract(t, self.breaks[0], out=numbers)
        numbers *= self.per_unit
        # Whatever the number of its bucket, no t is left behind: not one too large for an index
        # (it becomes negative, and is clipped to the first), nor NaN.
        np.copyto(buckets, numbers, casting="unsafe")
        self.first.take(buckets, out=segment, mode="clip")  # "raise" would write to a copy
        self.ends.take(segment, out=numbers, mode="clip")
        ahead = np.flatnonzero(t >= numbers)
        for _ in range(STEPS):
            if not len(ahead):
                break
            segment[ahead] += 1
            ahead = ahead[t[ahead] >= self.ends.take(segment[ahead], mode="clip")]
        segment[ahead] = np.searchsorted(self.breaks[1:-1], t[ahead], side="right")
        return segment

    def _search(self, t: float) -> int:
        found = int(self.breaks.searchsorted(t, side="right")) - 1
        return min(max(found, 0), len(self.breaks) - 2)

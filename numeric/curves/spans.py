"""Which segment a parameter belongs to: a table of equal buckets over unequal spans."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

# Buckets a span: twice as many are not faster for 1000 spans and fall out of the cache for more.
BUCKETS = 8
MOST_BUCKETS = 1 << 20
STEPS = 4  # from segment to segment inside a bucket, before searching


@dataclass(frozen=True)
class Spans:
    """Increasing breaks, and for every bucket the first segment that may hold its parameters.

    Segment i lives on [breaks[i], breaks[i + 1]), the last one on its end as well.
    """

    breaks: np.ndarray
    first: np.ndarray
    per_unit: float

    @classmethod
    def over(cls, breaks: np.ndarray) -> Spans:
        """Make the table for breaks.

        A bucket's number never falls as t grows, rounded or not: no parameter of a bucket is
        below a break of an earlier one.
        """  # fmt: skip
        segments = len(breaks) - 1
        count = min(BUCKETS * segments, MOST_BUCKETS) if segments > 1 else 1
        with np.errstate(over="ignore"):
            per_unit = float(count / (breaks[-1] - breaks[0]))
        if not np.isfinite(per_unit):  # a domain shorter than 1e-302: all in one bucket
            per_unit = 0.0
        buckets = ((breaks[:-1] - breaks[0]) * per_unit).astype(np.intp)
        first = np.maximum(np.searchsorted(buckets, np.arange(count)) - 1, 0)
        return cls(breaks, first, per_unit)

    def locate(self, t: np.ndarray) -> tuple[np.ndarray, Callable[[np.ndarray], Any]]:
        """Return t - start of its segment, and how to gather a value of every segment.

        A t outside the domain belongs to the first or last segment.
        """
        breaks = self.breaks
        if len(breaks) == 2:
            return t - breaks[0], lambda row: row[0]
        low, high = (self._search(end) for end in (t[0], t[-1]))
        if 8 * (high - low) <= len(t) and (t[1:] >= t[:-1]).all():
            if low == high:
                return t - breaks[low], lambda row: row[low]
            cuts = np.searchsorted(t, breaks[low + 1 : high + 1])
            counts = np.diff(cuts, prepend=0, append=len(t))
            held = slice(low, high + 1)
            return t - np.repeat(breaks[held], counts), lambda row: np.repeat(row[held], counts)
        segment = self.segment(t)
        return t - breaks.take(segment), partial(np.take, indices=segment)

    def segment(self, t: np.ndarray) -> np.ndarray:
        """Return the index of the segment of every t."""
        scaled = t - self.breaks[0]
        scaled *= self.per_unit
        # Whatever the number of its bucket, no t is left behind: not one too large for an index
        # (it becomes negative, and is clipped to the first), nor NaN.
        segment = self.first.take(scaled.astype(np.intp), mode="clip")
        ends = self.breaks[1:]
        ahead = np.flatnonzero(t >= ends.take(segment))
        for _ in range(STEPS):
            if not len(ahead):
                break
            segment[ahead] += 1
            ahead = ahead[t[ahead] >= ends.take(segment[ahead], mode="clip")]
            ahead = ahead[segment[ahead] < len(ends)]
        segment[ahead] = np.searchsorted(self.breaks, t[ahead], side="right") - 1
        return np.minimum(segment, len(ends) - 1, out=segment)

    def _search(self, t: float) -> int:
        found = int(np.searchsorted(self.breaks, t, side="right")) - 1
        return min(max(found, 0), len(self.breaks) - 2)

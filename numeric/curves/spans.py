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
    lengths: np.ndarray
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
        buckets = _bucket(breaks[:-1], breaks[0], per_unit, count)
        first = np.maximum(np.searchsorted(buckets, np.arange(count)) - 1, 0)
        return cls(breaks, np.diff(breaks), first, per_unit)

    def locate(self, t: np.ndarray) -> tuple[np.ndarray, Callable[[np.ndarray], Any]]:
        """Return local parameters u in [0, 1], and how to gather a value of every segment.

        t outside the domain belongs to the polynomial of the first or last segment.
        """
        breaks, lengths = self.breaks, self.lengths
        if len(lengths) == 1:
            return (t - breaks[0]) / lengths[0], lambda row: row[0]
        low, high = (self._search(end) for end in (t[0], t[-1]))
        if 8 * (high - low) <= len(t) and (t[1:] >= t[:-1]).all():
            if low == high:
                return (t - breaks[low]) / lengths[low], lambda row: row[low]
            cuts = np.searchsorted(t, breaks[low + 1 : high + 1])
            counts = np.diff(cuts, prepend=0, append=len(t))
            held = slice(low, high + 1)
            u = t - np.repeat(breaks[held], counts)
            u /= np.repeat(lengths[held], counts)
            return u, lambda row: np.repeat(row[held], counts)
        segment = self.segment(t)
        u = t - breaks.take(segment)
        u /= lengths.take(segment)
        return u, partial(np.take, indices=segment)

    def segment(self, t: np.ndarray) -> np.ndarray:
        """Return the index of the segment of every t."""
        segment = self.first.take(_bucket(t, self.breaks[0], self.per_unit, len(self.first)))
        ends = self.breaks[1:]
        ahead = np.flatnonzero(t >= ends.take(segment))
        for _ in range(STEPS):
            if not len(ahead):
                break
            segment[ahead] += 1
            ahead = ahead[segment[ahead] < len(ends)]
            ahead = ahead[t[ahead] >= ends.take(segment[ahead])]
        segment[ahead] = np.searchsorted(self.breaks, t[ahead], side="right") - 1
        return np.minimum(segment, len(ends) - 1)

    def _search(self, t: float) -> int:
        found = int(np.searchsorted(self.breaks, t, side="right")) - 1
        return min(max(found, 0), len(self.lengths) - 1)


def _bucket(t: np.ndarray, start: float, per_unit: float, count: int) -> np.ndarray:
    scaled = (t - start) * per_unit
    np.fmax(scaled, 0, out=scaled)  # NaN as well
    np.minimum(scaled, count - 1, out=scaled)
    return scaled.astype(np.intp)

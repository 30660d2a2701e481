"""Arcs that pairs of segments have in common: what lies along one, and what ends where."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .pieces import Pairs, plain
from .places import Places

SAMPLES = 17
SHORT = 2.0**-20  # parameters closer than this are no arc


class Shared(NamedTuple):
    """Arcs that pairs of segments share.

    Attributes
    ----------
    pair : array, shape (l,)
        Increasing.
    samples : array, shape (l, 2, SAMPLES)
        Parameters of the same points on both segments, equally spaced on the first.
    """

    pair: np.ndarray
    samples: np.ndarray

    @classmethod
    def none(cls) -> Shared:
        """Return no arcs."""
        return cls(np.empty(0, np.intp), np.empty((0, 2, SAMPLES)))

    @classmethod
    def all_of(cls, parts: list[Shared]) -> Shared:
        """Return the arcs of all parts, in the order of their pairs."""
        pair, samples = (np.concatenate(column) for column in zip(*parts, strict=True))
        order = np.argsort(pair, kind="stable")
        return cls(pair[order], samples[order])

    def longest(self) -> Shared:
        """Return the arcs without those that are parts of others."""
        order = np.lexsort((self.samples[:, 0, 0] - self.samples[:, 0, -1], self.pair))
        arcs, keep = Shared(self.pair[order], self.samples[order]), np.ones(len(order), bool)
        i, j = in_pairs(arcs.pair)
        keep[j[arcs.within(j, i)]] = False
        return Shared(arcs.pair[keep], arcs.samples[keep])

    def ends(self) -> np.ndarray:
        """Return (u, v) of the start and of the end of every arc, shape (l, 2, 2)."""
        return np.moveaxis(self.samples[:, :, [0, -1]], 1, 2)

    def hold(self, pairs: Pairs, dim: int) -> np.ndarray:
        """Return which pairs of pieces meet only because they lie along an arc.

        Such pieces, next to each other on the arc, have no other point in common if both go the
        same way along some axis: then the arc cannot come back to where it was.
        """
        held = np.zeros(len(pairs.origin), bool)
        middle, width = pairs.start + pairs.width / 2, pairs.width
        for which, arc in self._arcs_of(pairs.origin):
            expected, slope, bend = self.on_arc(arc, middle[0, which])
            near = np.abs(middle[1, which] - expected) <= width * (1 + np.abs(slope)) / 2 + bend
            start, end = self.samples[arc, 0, 0], self.samples[arc, 0, -1]
            near &= (middle[0, which] >= start - width) & (middle[0, which] <= end + width)
            which, turn = which[near], np.sign(slope[near])
            held[which[_one_way(plain(pairs.rows[:, which], dim), turn)]] = True
        return held

    def beside(self, places: Places) -> np.ndarray:
        """Return which places lie on an arc.

        Where they touch at a cusp or fold of the arc, the place is known badly, and v goes with the
        square root of u: linear interpolation is wrong by more than second differences tell.
        """
        on = np.zeros(len(places.pair), bool)
        for which, arc in self._arcs_of(places.pair):
            u, v = places.at[:, which]
            expected, slope, bend = self.on_arc(arc, u)
            start, end = self.samples[arc, 0, 0], self.samples[arc, 0, -1]
            inside = (u >= start - SHORT) & (u <= end + SHORT)
            error = places.error[1, which] + np.abs(slope) * places.error[0, which]
            bend = np.where(places.transversal[which], bend, 2 * bend + error)
            on[which] |= inside & (np.abs(v - expected) <= bend + SHORT)
        return on

    def within(self, arc: np.ndarray, other: np.ndarray) -> np.ndarray:
        """Return which arcs, by number, are parts of others: both of their ends are on them."""
        inside = np.ones(len(arc), bool)
        for end in (0, -1):
            u, v = self.samples[arc, :, end].T
            expected, _, bend = self.on_arc(other, u)
            start, stop = self.samples[other, 0, 0], self.samples[other, 0, -1]
            inside &= (u >= start - SHORT) & (u <= stop + SHORT)
            inside &= np.abs(v - expected) <= bend + SHORT
        return inside

    def _arcs_of(self, pair: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Yield (numbers of entries of `pair`, an arc for each) until all arcs have been named."""
        if not len(self.pair):
            return
        first = np.searchsorted(self.pair, pair, side="left")
        last = np.searchsorted(self.pair, pair, side="right")
        for k in range(int((last - first).max(initial=0))):
            which = np.flatnonzero(first + k < last)
            yield which, first[which] + k

    def on_arc(self, arc: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the parameter on the second segment, its slope by u, and how wrong it may be."""
        samples = self.samples[arc]
        start, end = samples[:, 0, 0], samples[:, 0, -1]
        place = np.clip((u - start) / (end - start), 0, 1) * (SAMPLES - 1)
        i = np.minimum(place.astype(np.intp), SAMPLES - 2)
        low, high = (samples[np.arange(len(arc)), 1, i + step] for step in (0, 1))
        slope = (high - low) * (SAMPLES - 1) / (end - start)
        bend = np.abs(np.diff(samples[:, 1], 2, axis=1)).max(axis=1) / 8  # of linear interpolation
        return low + (place - i) * (high - low), slope, 2 * bend


def _one_way(points: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Return which pairs of control polygons go along one axis; the second one turned, if -1."""
    points = np.stack([points[0], turn[:, None, None] * points[1]])
    edges = points[:, :, 1:] - points[:, :, :-1]
    chords = points[:, :, -1] - points[:, :, 0]
    with np.errstate(invalid="ignore", divide="ignore"):
        axis = (chords / np.sqrt((chords**2).sum(axis=2, keepdims=True))).sum(axis=0)
    forward: np.ndarray = ((edges * axis[:, None]).sum(axis=3) > 0).all(axis=(0, 2))
    return forward


def in_pairs(pair: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return all (i, j), i < j, with equal entries, which stand together.

    >>> [k.tolist() for k in in_pairs(np.array([4, 4, 7, 7, 7]))]
    [[0, 2, 3, 2], [1, 3, 4, 4]]
    """
    parts = [(np.empty(0, np.intp), np.empty(0, np.intp))]
    for step in range(1, len(pair)):
        i = np.flatnonzero(pair[step:] == pair[:-step])
        if not len(i):
            break
        parts.append((i, i + step))
    i, j = (np.concatenate(column) for column in zip(*parts, strict=True))
    return i, j

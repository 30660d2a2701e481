"""Arcs that two segments have in common.

Two polynomial or rational segments that coincide on an arc are parts of one algebraic curve. So an
arc they share ends only where one of them ends: at places where an end of either lies on the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..measures.nearest import local_nearest
from .pieces import Pairs, plain, points_at
from .places import Places

SAMPLES = 17
ON = 2.0**-42  # a distance, of size 1, that counts as none
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

    def of_others(self, pairs: np.ndarray) -> Shared:
        """Return the arcs of other pairs than these."""
        others = ~np.isin(self.pair, pairs)
        return Shared(self.pair[others], self.samples[others])

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
            near = np.abs(middle[1, which] - expected) <= width * (1 + slope) / 2 + bend
            start, end = self.samples[arc, 0, 0], self.samples[arc, 0, -1]
            near &= (middle[0, which] >= start - width) & (middle[0, which] <= end + width)
            which, turn = which[near], np.sign(slope[near])
            held[which[_one_way(plain(pairs.rows[:, which], dim), turn)]] = True
        return held

    def beside(self, places: Places) -> np.ndarray:
        """Return which places lie on an arc."""
        on = np.zeros(len(places.pair), bool)
        for which, arc in self._arcs_of(places.pair):
            u, v = places.at[:, which]
            expected, _, bend = self.on_arc(arc, u)
            start, end = self.samples[arc, 0, 0], self.samples[arc, 0, -1]
            inside = (u >= start - SHORT) & (u <= end + SHORT)
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


def evident_arcs(rows: np.ndarray, dim: int) -> Shared:
    """Return arcs of pairs (2, m, n + 1, columns) that have both ends in common, if they share any.

    Segments with the same control points, in either order, need not be compared.
    """
    pairs = same_ends(rows, dim)
    if not len(pairs):
        return Shared.none()
    first, second = rows[:, pairs]
    equal = (first == second).all(axis=(1, 2))
    turned = (first == second[:, ::-1]).all(axis=(1, 2)) & ~equal
    u = np.linspace(0, 1, SAMPLES)
    samples = np.repeat([[u, u], [u, u[::-1]]], [equal.sum(), turned.sum()], axis=0)
    evident = Shared(np.concatenate([pairs[equal], pairs[turned]]), samples)
    return Shared.all_of([evident, shared_arcs(rows, pairs[~(equal | turned)], dim)])


def same_ends(rows: np.ndarray, dim: int) -> np.ndarray:
    """Return which pairs (2, m, n + 1, columns) have both ends in common: they may be one arc."""
    first, second = plain(rows[:, :, [0, -1]], dim)
    parallel = np.abs(first - second).max(axis=(1, 2)) <= ON
    opposite = np.abs(first - second[:, ::-1]).max(axis=(1, 2)) <= ON
    return np.flatnonzero(parallel | opposite)


def shared_arcs(rows: np.ndarray, pairs: np.ndarray, dim: int) -> Shared:
    """Return the arcs that pairs of segments, chosen from rows (2, m, n + 1, columns), share."""
    if not len(pairs):
        return Shared.none()
    pair, u, v = _ends_on_the_other(rows, pairs, dim)
    i, j = _in_pairs(pair)
    arc = (u[j] - u[i] > SHORT) & (np.abs(v[i] - v[j]) > SHORT)
    i, j = i[arc], j[arc]
    samples = np.stack([np.linspace(u[i], u[j], SAMPLES, axis=1)] * 2, axis=1)
    found = _same_points(rows, pair[i], samples, v[i], v[j], dim)
    pair, samples = pair[i][found], samples[found]
    longest = np.lexsort((samples[:, 0, 0] - samples[:, 0, -1], pair))
    pair, samples = pair[longest], samples[longest]
    arcs, keep = Shared(pair, samples), np.ones(len(pair), bool)
    i, j = _in_pairs(pair)
    keep[j[arcs.within(j, i)]] = False
    return Shared(pair[keep], samples[keep])


def _in_pairs(pair: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return all (i, j), i < j, with equal entries, which stand together.

    >>> [k.tolist() for k in _in_pairs(np.array([4, 4, 7, 7, 7]))]
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


def _ends_on_the_other(
    rows: np.ndarray, pairs: np.ndarray, dim: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return (pair, u, v) wherever an end of one segment lies on the other one."""
    parts = []
    for side in (0, 1):
        for end in (0, 1):
            point = rows[side, pairs, -end]
            point = point[:, :dim] / point[:, dim:] if point.shape[1] > dim else point
            which, place = _on(rows[1 - side, pairs], point, np.arange(len(pairs)))
            own = np.full(len(which), float(end))
            parts.append((pairs[which], *((place, own) if side else (own, place))))
    pair, u, v = (np.concatenate(column) for column in zip(*parts, strict=True))
    order = np.lexsort((v, u, pair))
    return pair[order], u[order], v[order]


def _same_points(
    rows: np.ndarray, pair: np.ndarray, samples: np.ndarray, v_start: np.ndarray,
    v_end: np.ndarray, dim: int,
) -> np.ndarray:  # fmt: skip
    """Fill in the parameters on the second segment, and return which arcs are shared."""
    count = len(pair)
    inner = samples[:, 0].ravel()
    points = points_at(np.repeat(rows[0, pair], SAMPLES, axis=0), inner, dim)
    which, v = _on(rows[1, pair], points, np.repeat(np.arange(count), SAMPLES))
    low, high = np.minimum(v_start, v_end), np.maximum(v_start, v_end)
    arc = which // SAMPLES
    inside = (v >= low[arc] - SHORT) & (v <= high[arc] + SHORT)
    # Of several places the one nearest to equal spacing: a crossing of the arc with itself.
    expected = np.linspace(v_start, v_end, SAMPLES, axis=1).ravel()
    order = np.lexsort((-np.abs(v - expected[which]), inside))
    found = np.full(count * SAMPLES, np.nan)
    found[which[order]] = np.where(inside, v, np.nan)[order]
    place = found.reshape(count, SAMPLES)
    place[:, 0], place[:, -1] = v_start, v_end
    samples[:, 1] = place
    steps = np.diff(place, axis=1) * np.sign(v_end - v_start)[:, None]
    return np.flatnonzero((steps > 0).all(axis=1))


def _on(rows: np.ndarray, points: np.ndarray, piece: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (point, u) wherever a point lies on the segment with its number."""
    point, _, u, distance, _ = local_nearest(rows, points, np.arange(len(points)), piece)
    on = distance <= ON
    return point[on], u[on]

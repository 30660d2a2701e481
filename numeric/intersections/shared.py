"""Arcs that two segments have in common.

Two polynomial or rational segments that coincide on an arc are parts of one algebraic curve. So an
arc they share ends only where one of them ends: at places where an end of either lies on the other.
"""

from __future__ import annotations

from itertools import combinations
from typing import NamedTuple

import numpy as np

from ..bernstein.evaluation import values_at
from ..measures.nearest import local_nearest
from .pieces import Pairs

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

    def joined(self, others: Shared, shift: int = 0) -> Shared:
        """Return these and others, whose pairs are counted from `shift` on."""
        if not len(others.pair):
            return self
        return Shared(
            np.concatenate([self.pair, others.pair + shift]),
            np.concatenate([self.samples, others.samples]),
        )

    def ends(self) -> np.ndarray:
        """Return (u, v) of the start and of the end of every arc, shape (l, 2, 2)."""
        return np.moveaxis(self.samples[:, :, [0, -1]], 1, 2)

    def hold(self, pairs: Pairs) -> np.ndarray:
        """Return which pairs of pieces are open because they lie along an arc."""
        held = np.zeros(len(pairs.origin), bool)
        first = np.searchsorted(self.pair, pairs.origin, side="left")
        last = np.searchsorted(self.pair, pairs.origin, side="right")
        middle = pairs.start + pairs.width / 2
        for k in range(int((last - first).max(initial=0))):
            which = np.flatnonzero(first + k < last)
            samples = self.samples[first[which] + k]
            u, v = middle[:, which]
            start, end = samples[:, 0, 0], samples[:, 0, -1]
            place = np.clip((u - start) / (end - start), 0, 1) * (SAMPLES - 1)
            i = np.minimum(place.astype(np.intp), SAMPLES - 2)
            low, high = (samples[np.arange(len(which)), 1, i + step] for step in (0, 1))
            expected = low + (place - i) * (high - low)
            slope = np.abs(high - low) * (SAMPLES - 1) / (end - start)
            near = np.abs(v - expected) <= 2 * pairs.width * (1 + slope)
            beside = (u >= start - 2 * pairs.width) & (u <= end + 2 * pairs.width)
            held[which] |= near & beside
        return held


def shared_arcs(rows: np.ndarray, pairs: np.ndarray, dim: int) -> Shared:
    """Return the arcs that pairs of segments, chosen from rows (2, m, n + 1, columns), share."""
    pair, u, v = _ends_on_the_other(rows, pairs, dim)
    both = [
        (i, j)
        for own in np.split(np.arange(len(pair)), np.flatnonzero(np.diff(pair)) + 1)
        for i, j in combinations(own, 2)
        if abs(u[i] - u[j]) > SHORT and abs(v[i] - v[j]) > SHORT
    ]
    if not both:
        return Shared.none()
    i, j = np.array(both).T
    i, j = np.where(u[i] < u[j], i, j), np.where(u[i] < u[j], j, i)
    samples = np.stack([np.linspace(u[i], u[j], SAMPLES, axis=1)] * 2, axis=1)
    found = _same_points(rows, pair[i], samples, v[i], v[j], dim)
    pair, samples = pair[i][found], samples[found]
    longest = np.lexsort((samples[:, 0, 0] - samples[:, 0, -1], pair))
    pair, samples = pair[longest], samples[longest]
    kept: list[int] = []
    for k in range(len(pair)):  # without those that are parts of others
        if not any(
            pair[k] == pair[other] and _within(samples[k], samples[other]) for other in kept
        ):
            kept.append(k)
    return Shared(pair[kept], samples[kept])


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
    points = values_at(np.repeat(rows[0, pair], SAMPLES, axis=0), inner)
    points = points[:, :dim] / points[:, dim:] if points.shape[1] > dim else points
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


def _within(inner: np.ndarray, outer: np.ndarray) -> bool:
    low, high = outer.min(axis=1) - SHORT, outer.max(axis=1) + SHORT
    return bool(((inner.min(axis=1) >= low) & (inner.max(axis=1) <= high)).all())

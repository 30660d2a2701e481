"""Places where pairs of segments meet, and which of them are one and the same."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

SAME = 2.0**-46  # parameters in [0, 1] closer than this are one, whatever their errors


class Places(NamedTuple):
    """Parameters on pairs of segments where these meet.

    Attributes
    ----------
    pair : array, shape (k,)
    at, error : arrays, shape (2, k)
        Parameters in [0, 1] on both segments, and how far off they may be.
    transversal : array of bool, shape (k,)
    """

    pair: np.ndarray
    at: np.ndarray
    error: np.ndarray
    transversal: np.ndarray

    @classmethod
    def none(cls) -> Places:
        """Return no places."""
        return cls(np.empty(0, np.intp), np.empty((2, 0)), np.empty((2, 0)), np.empty(0, bool))

    def chosen(self, which: np.ndarray) -> Places:
        """Return some of the places."""
        return Places(
            self.pair[which], self.at[:, which], self.error[:, which], self.transversal[which]
        )

    @classmethod
    def all_of(cls, parts: list[Places]) -> Places:
        """Return the places of all parts."""
        parts = [part for part in parts if len(part.pair)] or parts[:1]
        if len(parts) == 1:
            return parts[0]
        return cls(*(np.concatenate(column, axis=-1) for column in zip(*parts, strict=True)))

    def single(self) -> Places:
        """Return every place once: those found from two sides of a cut are equal within errors."""
        return self.chosen(self.kept()) if len(self.pair) > 1 else self

    def kept(self) -> np.ndarray:
        """Return one of equal places: one that touches, or else the one with the least error."""
        group = clusters(self.pair, self.at, self.error + SAME / 2)
        best = np.lexsort((self.error.sum(axis=0), self.transversal, group))
        return best[np.diff(group[best], prepend=-1) > 0]

    def without(self, others: Places, reach: np.ndarray) -> Places:
        """Return the places that are no nearer than `reach`, one for each, to any of others."""
        if not len(self.pair) or not len(others.pair):
            return self
        keep = np.ones(len(self.pair), bool)
        first = np.searchsorted(others.pair, self.pair, side="left")
        last = np.searchsorted(others.pair, self.pair, side="right")
        for k in range(int((last - first).max(initial=0))):
            which = np.flatnonzero(first + k < last)
            apart = np.abs(self.at[:, which] - others.at[:, first[which] + k])
            keep[which[(apart <= reach[which]).all(axis=0)]] = False
        return self.chosen(keep)


def clusters(pair: np.ndarray, at: np.ndarray, reach: np.ndarray) -> np.ndarray:
    """Return the cluster, from 0 on, of every place: they hang together within their reach.

    Places of a cluster are neighbours in the order of either parameter, and of one pair. Clusters
    along the first parameter are divided along the second one, and those along the first again.

    >>> at = np.array([[0.1, 0.1, 0.9], [0.2, 0.8, 0.2]])
    >>> clusters(np.zeros(3, int), at, np.full(at.shape, 1e-9)).tolist()
    [0, 1, 2]
    """
    cluster = pair
    for side in (0, 1, 0):
        order = np.lexsort((at[side], cluster))
        near, kind = at[side, order], cluster[order]
        gap = np.diff(near) > reach[side, order[1:]] + reach[side, order[:-1]]
        cluster = np.empty(len(pair), np.intp)
        cluster[order] = np.cumsum(np.append(0, gap | (np.diff(kind) != 0)))[: len(pair)]
    return cluster

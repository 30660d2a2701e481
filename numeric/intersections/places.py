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

    def joined(self, others: Places, shift: int = 0) -> Places:
        """Return these and others, whose pairs are counted from `shift` on."""
        if not len(others.pair):
            return self
        return Places(
            np.concatenate([self.pair, others.pair + shift]),
            np.concatenate([self.at, others.at], axis=1),
            np.concatenate([self.error, others.error], axis=1),
            np.concatenate([self.transversal, others.transversal]),
        )

    def single(self) -> Places:
        """Return every place once: those found from two sides of a cut are equal within errors.

        Of equal ones a touching place is kept, or else the one with the least error. They are
        looked for among neighbours in the order of either parameter, as one parameter may belong
        to several places.
        """
        if len(self.pair) < 2:
            return self
        places = self
        for keys in ((1, 0), (0, 1)):
            order = np.lexsort((places.at[keys[0]], places.at[keys[1]], places.pair))
            places = places.chosen(order)
            near = np.abs(places.at[:, 1:] - places.at[:, :-1])
            reach = places.error[:, 1:] + places.error[:, :-1] + SAME
            equal = (near <= reach).all(axis=0) & (places.pair[1:] == places.pair[:-1])
            if not equal.any():
                continue
            group = np.cumsum(np.append(True, ~equal))
            best = np.lexsort((places.error.sum(axis=0), places.transversal, group))
            places = places.chosen(best[np.diff(group[best], prepend=0) > 0])
        return places

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

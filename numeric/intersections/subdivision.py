"""Subdivision of pairs of segments, which ends where a pair cannot meet or meets only once.

What is still open when pieces are as small as the square root of rounding touches, or has a cusp
there. Pairs that stay open along a whole arc have it in common, or run alongside each other.
"""

from __future__ import annotations

import numpy as np

from .arcs import evident_arcs, shared_arcs
from .newton import Solved, crossings
from .pieces import Pairs, cut, meet_once, plain
from .places import Places
from .shared import Shared
from .touching import alongside, nearest_of_clusters, touching_places

FIRST, PARTS = 8, 4  # parts of a segment at first, and of a piece from then on
SMALLEST = 2.0**-27  # pieces of this width: whether they touch or cross is told no more
CROWDED = 64  # open pairs for every degree: more have an arc in common, or very nearly
MOST = 1 << 12  # open pairs of one pair of segments
TOGETHER = 16  # pairs of segments that may have so many
LARGE = 1 << 17  # control points of open pairs to be cut at a time, if of several segments


def subdivided(rows: np.ndarray, dim: int) -> tuple[Places, Shared]:
    """Return where rows (2, m, n + 1, columns) of size 1 meet, and the arcs they share."""
    arcs = evident_arcs(rows, dim)
    whole = Pairs(rows, np.arange(rows.shape[1]), np.zeros(rows.shape[:2]), 1.0)
    crossing, open_, crowds = _cut_down(whole, dim, CROWDED * max(rows.shape[2] - 1, 1), arcs)
    touching = nearest_of_clusters(rows, open_, dim)
    if crowds:
        origins = np.unique(np.concatenate([pairs.origin for pairs in crowds]))
        arcs = Shared.all_of([arcs, shared_arcs(rows, origins, dim)]).longest()
    while crowds:
        pairs = crowds.pop()
        pairs = pairs.chosen(~arcs.hold(pairs, dim))
        beside = alongside(rows, pairs, dim)
        touching += nearest_of_clusters(rows, [pairs.chosen(beside)], dim)
        pairs = pairs.chosen(~beside)
        origins = np.unique(pairs.origin)
        for first in range(0, len(origins), TOGETHER):  # not more: they may become many
            few = origins[first : first + TOGETHER]
            own = pairs.chosen((pairs.origin >= few[0]) & (pairs.origin <= few[-1]))
            more, open_, stuck = _cut_down(own, dim, MOST, arcs)
            crossing += more
            touching += nearest_of_clusters(rows, open_ + stuck, dim)
    met = Places.all_of(crossing).single()
    touch = touching_places(rows, touching, dim)
    touch = touch.without(met, touch.error.max(axis=0, initial=0))
    places = Places.all_of([met, touch])
    return places.chosen(~arcs.beside(places)), arcs


def _cut_down(
    pairs: Pairs, dim: int, limit: int, arcs: Shared
) -> tuple[list[Places], list[Pairs], list[Pairs]]:
    """Return crossings, what is open at last, and all of what is open where that is too much.

    Large numbers of pairs are divided, by the segments they are pieces of.
    """
    crossing, open_, crowds = [Places.none()], [], []
    todo = [pairs]
    while todo:
        pairs = todo.pop()
        if not len(pairs.origin) or pairs.width <= SMALLEST:
            open_.append(pairs)
            continue
        if pairs.rows[0, :, :, 0].size > LARGE and pairs.origin[0] < pairs.origin[-1]:
            first = pairs.origin <= (pairs.origin[0] + pairs.origin[-1]) // 2
            todo += [pairs.chosen(~first), pairs.chosen(first)]
            continue
        pairs = cut(pairs, FIRST if pairs.width == 1 else PARTS, dim)
        if len(arcs.pair):
            pairs = pairs.chosen(~arcs.hold(pairs, dim))
        once = np.flatnonzero(meet_once(plain(pairs.rows, dim)))
        if len(once):
            met, solved = crossings(pairs.rows[:, once], pairs.width, dim)
            crossing.append(_on_segments(pairs.chosen(once[met]), solved))
            pairs = pairs.chosen(np.delete(np.arange(len(pairs.origin)), once[met]))
        crowded = np.bincount(pairs.origin, minlength=1)[pairs.origin] > limit
        if crowded.any():
            crowds.append(pairs.chosen(crowded))
            pairs = pairs.chosen(~crowded)
        todo.append(pairs)
    return crossing, open_, crowds


def _on_segments(pairs: Pairs, solved: Solved) -> Places:
    at = pairs.start + pairs.width * solved.at
    error = np.maximum(pairs.width * solved.error, 2.0**-52)
    return Places(pairs.origin, at, error, solved.transversal)

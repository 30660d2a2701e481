"""Subdivision of pairs of segments, which ends where a pair cannot meet or meets only once.

What is still open when pieces are as small as the square root of rounding touches, or has a cusp
there. Pairs that stay open along a whole arc have it in common.
"""

from __future__ import annotations

import numpy as np

from .newton import Solved, crossings, point_and_slopes, touching
from .pieces import Pairs, cut, meet_once, plain
from .places import Places
from .shared import Shared, shared_arcs

FIRST, PARTS = 8, 4  # parts of a segment at first, and of a piece from then on
SMALLEST = 2.0**-27  # pieces of this width: whether they touch or cross is told no more
CROWDED = 64  # open pairs for every degree: more have an arc in common, or very nearly
MOST = 1 << 13  # open pairs of one pair of segments
TOUCH = 2.0**-43  # a distance, of size 1, that counts as none
TANGENT = 1e-6  # the sine of an angle between tangents that counts as none


def subdivided(rows: np.ndarray, dim: int) -> tuple[Places, Shared]:
    """Return where rows (2, m, n + 1, columns) of size 1 meet, and the arcs they share."""
    whole = Pairs(rows, np.arange(rows.shape[1]), np.zeros(rows.shape[:2]), 1.0)
    crossing, open_, crowds = _cut_down(whole, dim, CROWDED * max(rows.shape[2] - 1, 1))
    arcs = Shared.none()
    if crowds:
        origins = np.unique(np.concatenate([pairs.origin for pairs in crowds]))
        arcs = shared_arcs(rows, origins, dim)
    for pairs in crowds:
        pairs = pairs.chosen(~arcs.hold(pairs))
        for origin in np.unique(pairs.origin):  # each by itself: they may become many
            own = pairs.chosen(pairs.origin == origin)
            more, rest, stuck = _cut_down(own, dim, MOST, arcs)
            crossing, open_ = crossing.joined(more), open_ + rest + stuck
    crossing = crossing.single()
    touch = Places.none()
    for pairs in open_:
        touch = touch.joined(_touching(rows, pairs, dim))
    touch = touch.single()
    return crossing.joined(touch.without(crossing, touch.error.max(axis=0))), arcs


def _cut_down(
    pairs: Pairs, dim: int, limit: int, arcs: Shared | None = None
) -> tuple[Places, list[Pairs], list[Pairs]]:
    """Return crossings, what is open at last, and all of what is open where that is too much."""
    crossing, crowds = Places.none(), []
    while len(pairs.origin) and pairs.width > SMALLEST:
        pairs = cut(pairs, FIRST if pairs.width == 1 else PARTS, dim)
        if arcs is not None:
            pairs = pairs.chosen(~arcs.hold(pairs))
        once = np.flatnonzero(meet_once(plain(pairs.rows, dim)))
        if len(once):
            met, solved = crossings(pairs.rows[:, once], dim)
            crossing = crossing.joined(_on_segments(pairs.chosen(once[met]), solved))
            pairs = pairs.chosen(np.delete(np.arange(len(pairs.origin)), once[met]))
        crowded = np.bincount(pairs.origin, minlength=1)[pairs.origin] > limit
        if crowded.any():
            crowds.append(pairs.chosen(crowded))
            pairs = pairs.chosen(~crowded)
    return crossing, [pairs], crowds


def _on_segments(pairs: Pairs, solved: Solved) -> Places:
    at = pairs.start + pairs.width * solved.at
    error = np.maximum(pairs.width * solved.error, 2.0**-52)
    return Places(pairs.origin, at, error, np.ones(len(pairs.origin), bool))


def _touching(rows: np.ndarray, pairs: Pairs, dim: int) -> Places:
    """Return the nearest places of what is open at last, once for pieces that hang together."""
    if not len(pairs.origin):
        return Places.none()
    middle = pairs.start + pairs.width / 2
    cluster = np.zeros(len(pairs.origin), np.intp)
    for side in (0, 1, 0):
        order = np.lexsort((middle[side], cluster, pairs.origin))
        gap = np.abs(np.diff(middle[side, order])) > 1.5 * pairs.width
        gap |= (np.diff(cluster[order]) != 0) | (np.diff(pairs.origin[order]) != 0)
        cluster[order] = np.cumsum(np.append(0, gap))
    _, index = np.unique(cluster, return_inverse=True)
    first = np.unique(index, return_index=True)[1]
    low, high = np.full((2, len(first)), 1.0), np.zeros((2, len(first)))
    for side in (0, 1):
        np.minimum.at(low[side], index, pairs.start[side])
        np.maximum.at(high[side], index, pairs.start[side] + pairs.width)
    origin = pairs.origin[first]
    start, reach = (low + high) / 2, (high - low) / 2 + 4 * pairs.width
    solved = touching(rows[:, origin], dim, start, reach)
    touch = np.flatnonzero(solved.distance <= TOUCH)
    at, origin = solved.at[:, touch], origin[touch]
    columns = np.moveaxis(rows[:, origin], (2, 3), (0, 1))
    slopes = point_and_slopes(columns, at, dim)[1]
    sizes = np.sqrt((slopes**2).sum(axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = (slopes[:, 0] * slopes[:, 1]).sum(axis=0) / sizes.prod(axis=0)
        transversal = np.sqrt(1 - np.minimum(cosine**2, 1)) > TANGENT
    return Places(origin, at, reach[:, touch], transversal)

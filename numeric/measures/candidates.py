"""Which pieces may hold the nearest points: a tree of boxes, descended for many points at once.

The leaves are the boxes of pieces of segments, sorted along a curve that fills space (Morton, *A
computer oriented geodetic data base*, IBM, 1966); a node's box holds those of `FAN` nodes below it
that follow each other. A node is left out where its box is farther away than some point of the
curve that is known already.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..bernstein import form
from ..bernstein.evaluation import values_at
from .boxes import control_boxes
from .scale import plain

HALVINGS = 3  # of a piece, or of a row of nodes, from one level of the tree to the next
FAN = 2**HALVINGS
MOST_PIECES = 1 << 18  # of segments that are cut; more segments stay whole
FEW = 1 << 12  # pieces cost less than a point saves by them
MOST_CUTS = 2  # of a segment, into FAN pieces and again
POINTS = 4096  # descended at a time
MOST_PAIRS = 1 << 17  # of a point and a node; with more of them, half the points at a time
SLACK = 1e-14  # relative error of a bound, generously


class Level(NamedTuple):
    """Boxes of the nodes of one level, and points of the curve in each, (known, nodes, dim)."""

    low: np.ndarray
    high: np.ndarray
    known: np.ndarray


class Tree(NamedTuple):
    """Levels from the root to the leaves, and what these are.

    Leaf i is the part from u = start[i] to start[i] + width of a segment, with its own rows.
    """

    levels: list[Level]
    rows: np.ndarray
    segment: np.ndarray
    start: np.ndarray
    width: float


def tree(rows: np.ndarray, dim: int, points: int) -> Tree:
    """Return the tree over segments with these rows, in which so many points are looked for."""
    segments = len(rows)
    for _ in range(MOST_CUTS):
        if len(rows) * FAN > min(MOST_PIECES, FEW + 128 * points):
            break
        for _ in range(HALVINGS):
            rows = np.stack(form.split(rows), axis=1).reshape(-1, *rows.shape[1:])
    low, high = control_boxes(rows, dim)
    order = _along_space(low, high)
    rows, low, high = rows[order], low[order], high[order]
    slack = SLACK * np.maximum(np.abs(low), np.abs(high))
    known = [plain(values_at(rows, np.full(len(rows), u)), dim) for u in (0.0, 0.5, 1.0)]
    levels = [Level(low - slack, high + slack, np.stack(known))]
    while len(levels[0].low) > 1:
        below = levels[0]
        first = np.arange(0, len(below.low), FAN)
        box = np.minimum.reduceat(below.low, first), np.maximum.reduceat(below.high, first)
        levels.insert(0, Level(*box, below.known[:1, first]))
    segment, part = np.divmod(order, len(rows) // segments)
    width = segments / len(rows)
    return Tree(levels, rows, segment, part * width, width)


def _along_space(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Return the order of boxes by the bits of their centres' coordinates, taken in turn."""
    with np.errstate(invalid="ignore"):
        centre = np.nan_to_num((low + high) / 2)
    centre -= centre.min(axis=0)
    dim = centre.shape[1]
    bits = max(1, min(16, 62 // dim))
    whole = (centre * ((2**bits - 1) / max(float(centre.max()), 1e-300))).astype(np.int64)
    code = np.zeros(len(low), np.int64)
    for bit in range(bits):
        for axis in range(min(dim, 62)):
            code |= ((whole[:, axis] >> bit) & 1) << (bit * dim + axis)
    return np.argsort(code, kind="stable")


def candidates(levels: list[Level], points: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield (point, leaf) pairs, by index, among which the nearest points of all points are.

    All pairs of a point come at once. At most `MOST_PAIRS` pairs are in memory, unless a single
    point has more.
    """
    waiting = [
        np.arange(first, min(first + POINTS, len(points)))
        for first in range(0, len(points), POINTS)
    ]
    while waiting:
        chosen = waiting.pop()
        pairs = _descend(levels, points[chosen])
        if pairs is None:
            waiting += np.array_split(chosen, 2)
        else:
            yield chosen[pairs[0]], pairs[1]


def _descend(levels: list[Level], points: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the pairs, or None where they are too many for several points at once."""
    point, node = np.arange(len(points)), np.zeros(len(points), np.intp)
    nearest = np.full(len(points), np.inf)
    for depth, level in enumerate(levels):
        if depth:
            node = (node[:, None] * FAN + np.arange(FAN)).ravel()
            point = np.repeat(point, FAN)
            there = node < len(level.low)
            point, node = point[there], node[there]
        if len(node) > MOST_PAIRS and len(points) > 1:
            return None
        p = points[point]
        for known in level.known:
            np.minimum.at(nearest, point, _square(p - known[node]))
        gap = np.maximum(np.maximum(level.low[node] - p, p - level.high[node]), 0)
        near = _square(gap) <= nearest[point] * (1 + SLACK)
        point, node = point[near], node[near]
    return point, node


def _square(vectors: np.ndarray) -> np.ndarray:
    total: np.ndarray = np.einsum("ij,ij->i", vectors, vectors)
    return total

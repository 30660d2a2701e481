"""Which boxes meet, out of two long lists: by way of the boxes around runs of neighbours."""

from __future__ import annotations

import numpy as np

RUN = 32  # boxes in a row: consecutive segments lie together
MOST = 1 << 20  # boxes compared at a time

Boxes = tuple[np.ndarray, np.ndarray]  # least and greatest coordinates, (m, dim) each


def meeting(first: Boxes, second: Boxes) -> tuple[np.ndarray, np.ndarray]:
    """Return all pairs (i, j) of boxes that meet.

    >>> low = np.array([[0.0, 0.0], [4.0, 0.0]])
    >>> [k.tolist() for k in meeting((low, low + 2), (low + 1, low + 3))]
    [[0, 1], [0, 1]]
    """
    one, two = _all_pairs(_runs(first), _runs(second))
    inside = np.arange(RUN)
    parts = [(np.empty(0, np.intp), np.empty(0, np.intp))]
    step = MOST // RUN**2
    for start in range(0, len(one), step):
        part = slice(start, start + step)
        i, j = np.broadcast_arrays(
            one[part, None, None] * RUN + inside[:, None], two[part, None, None] * RUN + inside
        )
        there = (i < len(first[0])) & (j < len(second[0]))
        i, j = i[there], j[there]
        meet = (first[0][i] <= second[1][j]) & (second[0][j] <= first[1][i])
        both = meet.all(axis=1)
        parts.append((i[both], j[both]))
    i, j = (np.concatenate(column) for column in zip(*parts, strict=True))
    return i, j


def _runs(boxes: Boxes) -> Boxes:
    start = np.arange(0, len(boxes[0]), RUN)
    return np.minimum.reduceat(boxes[0], start), np.maximum.reduceat(boxes[1], start)


def _all_pairs(first: Boxes, second: Boxes) -> tuple[np.ndarray, np.ndarray]:
    """Return all pairs of boxes that meet, comparing every one with every other."""
    parts = []
    step = max(1, MOST // len(second[0]))
    for start in range(0, len(first[0]), step):
        low, high = (side[start : start + step, None] for side in first)
        i, j = np.nonzero(((low <= second[1]) & (second[0] <= high)).all(axis=2))
        parts.append((i + start, j))
    i, j = (np.concatenate(column) for column in zip(*parts, strict=True))
    return i, j

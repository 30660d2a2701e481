"""The speed |c'(u)| of segments, and its integral by Gauss's rule on parts small enough.

The speed is the root of a polynomial, or of a quotient: smooth but for cusps, where the rule
gains little and parts are halved until they no longer count.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..bernstein import form
from ..bernstein.evaluation import values_at
from .scale import unit

if TYPE_CHECKING:
    from ..curve import Curve

NODES = 12  # of Gauss's rule: exact up to degree 23
DEEPEST = 52  # halvings: the resolution of a float in [0, 1]
ROUNDING = 16 * float(np.finfo(float).eps)
CHUNK = 2048  # segments at a time: their speeds fit in the cache


class Stretches(NamedTuple):
    """Parts [start, start + width] of segments in order, short enough for one Gauss rule each."""

    segment: np.ndarray
    start: np.ndarray
    width: np.ndarray
    length: np.ndarray


class Speed(NamedTuple):
    """What the speed is computed from: coefficients (m, d + 1, columns) on every segment.

    For a polynomial curve they are those of c'(u); for a rational one of N, w, N' and w'. The
    curve has been divided by `scale`.
    """

    rows: np.ndarray
    rational: bool
    scale: float

    def of(self, columns: np.ndarray) -> np.ndarray:
        """Return the speed from values of the columns, which stand along axis 0."""
        if self.rational:
            half = len(columns) // 2
            w, dw = columns[half - 1], columns[-1]
            columns = (columns[half:-1] - columns[: half - 1] * (dw / w)) / w
        speed: np.ndarray = np.sqrt(np.einsum("i...,i...->...", columns, columns))
        return speed

    def at(self, segment: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the speeds at places u in [0, 1] of segments."""
        return self.of(values_at(self.rows[segment], u).T)

    def integrals(self, rows: np.ndarray) -> np.ndarray:
        """Return the integral of the speed over [0, 1] for each of the rows, by Gauss's rule."""
        basis, weights = _gauss(rows.shape[1] - 1)
        return weights @ self.of(basis @ rows.transpose(2, 1, 0))


def speed(curve: Curve) -> Speed:
    """Return the speed of a curve's segments by their own parameter u in [0, 1]."""
    rows, _, scale = unit(curve)
    slopes = form.derivative(rows)
    if not curve.rational:
        return Speed(slopes, False, scale)
    raised = form.elevate(slopes, rows.shape[1] - slopes.shape[1])
    return Speed(np.concatenate([rows, raised], axis=2), True, scale)


def stretches(speeds: Speed, tolerance: float) -> Stretches:
    """Return parts of the segments whose lengths are right to tolerance times the segment's.

    The error is estimated by the difference to the rule on both halves.
    """
    found = []
    for first in range(0, len(speeds.rows), CHUNK):
        found += _halved(speeds, slice(first, first + CHUNK), tolerance)
    segment, start, width, length = (np.concatenate(column) for column in zip(*found, strict=True))
    order = np.lexsort((start, segment))
    return Stretches(segment[order], start[order], width[order], length[order])


def _halved(speeds: Speed, chosen: slice, tolerance: float) -> list[tuple[np.ndarray, ...]]:
    """Return (segment, start, width, length) of the parts, depth by depth."""
    rows = speeds.rows[chosen]
    segment, start = np.arange(len(speeds.rows))[chosen], np.zeros(len(rows))
    whole = speeds.integrals(rows)
    allowed = tolerance * whole  # halved with the part: the parts' errors sum up to it
    found: list[tuple[np.ndarray, ...]] = []
    for depth in range(DEEPEST + 1):
        width = 0.5**depth
        halves = np.concatenate(form.split(rows))
        both = speeds.integrals(halves).reshape(2, -1) / 2
        length = both.sum(axis=0)
        open_ = np.abs(whole - length) > np.maximum(allowed, ROUNDING * length)
        if depth == DEEPEST:
            open_[:] = False
        done = ~open_
        full = np.full(int(done.sum()), width)
        found.append((segment[done], start[done], full, width * length[done]))
        if not open_.any():
            break
        rows = halves[np.tile(open_, 2)]
        whole = 2 * both[:, open_].ravel()
        allowed = np.tile(allowed[open_], 2)
        segment = np.tile(segment[open_], 2)
        start = np.concatenate([start[open_], start[open_] + width / 2])
    return found


@lru_cache(maxsize=64)
def _gauss(degree: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the Bernstein basis at the nodes, (NODES, degree + 1), and the weights on [0, 1]."""
    nodes, weights = gauss_rule()
    count = degree + 1
    polynomials = np.tile(np.eye(count), (NODES, 1))[..., None]
    return values_at(polynomials, np.repeat(nodes, count)).reshape(NODES, count), weights


@lru_cache(maxsize=1)
def gauss_rule() -> tuple[np.ndarray, np.ndarray]:
    """Return nodes and weights on [0, 1]."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    return (nodes + 1) / 2, weights / 2

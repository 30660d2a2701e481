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
from .scale import even

if TYPE_CHECKING:
    from ..curve import Curve

NODES = 12  # of Gauss's rule: exact up to degree 23
DEEPEST = 52  # halvings: the resolution of a float in [0, 1]
ROUNDING = 16 * float(np.finfo(float).eps)
CAUTION = 1 / 8  # errors are estimates
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
    curve has been divided by `scale`, and balanced by c, as `even` does it.
    """

    rows: np.ndarray
    rational: bool
    scale: float
    c: np.ndarray

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

    def means(self, rows: np.ndarray) -> np.ndarray:
        """Return the mean speed over [0, 1] for each of the rows, by Gauss's rule."""
        basis, weights = _gauss(rows.shape[1] - 1)
        mean: np.ndarray = weights @ self.of(basis @ rows.transpose(2, 1, 0))
        return mean

    def noise(self, rows: np.ndarray) -> np.ndarray:
        """Return the mean rounding error of the speed: N' - N w'/w cancels where the curve rests.

        The curve is of size 1, so that the error is some roundings of w'/w.
        """
        if not self.rational:
            return np.zeros(len(rows))
        half = rows.shape[2] // 2
        basis, weights = _gauss(rows.shape[1] - 1)
        w, dw = basis @ rows[..., [half - 1, -1]].transpose(2, 1, 0)
        mean: np.ndarray = weights @ np.abs(dw / w)
        return ROUNDING * mean

    def bound_if_vanishing(self, rows: np.ndarray) -> np.ndarray:
        """Return a bound of the mean speed where the velocity may vanish, elsewhere 0.

        It vanishes nowhere inside where its coefficients all point ahead, to their mean's side
        (Sederberg and Meyers, *Loop detection in surface patch intersections*, CAGD 5, 1988).
        """
        v, least = rows, np.ones(len(rows))
        if self.rational:  # v = (N' w - N w') / w^2
            half = rows.shape[2] // 2
            w, dw = rows[..., half - 1 : half], rows[..., -1:]
            v = form.product(rows[..., half:-1], w) - form.product(rows[..., : half - 1], dw)
            one_sign = np.abs(np.sign(w).sum(axis=(1, 2))) == w.shape[1]
            least = np.where(one_sign, np.abs(w).min(axis=(1, 2)), 0)
        ahead = (np.einsum("mik,mk->mi", v, v.mean(axis=1)) >= 0).all(axis=1)
        most = np.sqrt(np.einsum("mik,mik->mi", v, v)).mean(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(ahead, 0, most / least**2)


def speed(curve: Curve) -> Speed:
    """Return the speed of a curve's segments by their balanced parameter u in [0, 1]."""
    (rows, _, scale), c = even(curve)
    slopes = form.derivative(rows)
    if not curve.rational:
        return Speed(slopes, False, scale, c)
    raised = form.elevate(slopes, rows.shape[1] - slopes.shape[1])
    return Speed(np.concatenate([rows, raised], axis=2), True, scale, c)


def stretches(speeds: Speed, tolerance: float) -> Stretches:
    """Return parts of the segments whose lengths are right to tolerance times the segment's.

    The error is estimated by the difference to the rule on both halves. Where the speed has a
    kink that may hide between the nodes, it is bounded by all that the part can be long.
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
    whole = speeds.means(rows)
    allowed = CAUTION * tolerance * whole  # times the part's width: errors sum up to it
    found: list[tuple[np.ndarray, ...]] = []
    for depth in range(DEEPEST + 1):
        width = 0.5**depth
        halves = np.concatenate(form.split(rows))
        both = speeds.means(halves).reshape(2, -1)
        mean = both.sum(axis=0) / 2
        allowed = np.maximum(allowed, speeds.noise(rows))
        open_ = np.abs(whole - mean) > np.maximum(allowed, ROUNDING * mean)
        open_ |= speeds.bound_if_vanishing(rows) > allowed
        if depth == DEEPEST:
            open_[:] = False
        done = ~open_
        full = np.full(int(done.sum()), width)
        found.append((segment[done], start[done], full, width * mean[done]))
        if not open_.any():
            break
        rows = halves[np.tile(open_, 2)]
        whole = both[:, open_].ravel()
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

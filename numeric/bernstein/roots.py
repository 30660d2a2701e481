"""All real roots in [0, 1] of many polynomials at once, by their Bernstein coefficients.

A polynomial has no more roots in an interval than its coefficients there change sign (Descartes'
rule in Bernstein form; Lane and Riesenfeld, *Bounds on a polynomial*, BIT 21, 1981). Intervals
are halved until one change is left, which encloses a simple root, or the coefficients are no
larger than their own rounding errors, which is where a multiple root cannot be told from none.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .evaluation import values_at
from .form import derivative, elevate, split

DEEPEST = 52  # halvings: the resolution of a float in [0, 1]
EPSILON = float(np.finfo(float).eps)


class Roots(NamedTuple):
    """Roots u of polynomials, sorted by the row of the polynomial and by u.

    `simple` tells which ones the polynomial crosses; the others it touches, within rounding, or
    they are several roots closer together than rounding can tell.
    """

    row: np.ndarray
    u: np.ndarray
    simple: np.ndarray


class _Found:
    """Roots as they turn up: row, u, how far off u may be, and whether the sign changes there."""

    def __init__(self) -> None:
        self.parts: list[tuple[np.ndarray, ...]] = []

    def add(self, row: np.ndarray, u: np.ndarray, radius: float, simple: np.ndarray | bool) -> None:
        if len(row):
            self.parts.append((row, u, np.full(len(row), radius), np.full(len(row), simple)))

    def sorted(self) -> Roots:
        """Return the roots in order; those that may be the same one, within rounding, once."""
        if not self.parts:
            return Roots(np.empty(0, np.intp), np.empty(0), np.empty(0, bool))
        row, u, radius, simple = (
            np.concatenate(column) for column in zip(*self.parts, strict=True)
        )
        order = np.lexsort((u, row))
        row, u, radius, simple = row[order], u[order], radius[order], simple[order]
        apart = (np.diff(row) > 0) | (np.diff(u) > 2 * (radius[1:] + radius[:-1]))
        first = np.flatnonzero(np.append(True, apart))
        last = np.append(first[1:], len(row)) - 1
        middle = np.where(first == last, u[first], (u[first] + u[last]) / 2)
        return Roots(row[first], middle, simple[first] & (first == last))


def roots(coefficients: np.ndarray, noise: np.ndarray | None = None) -> Roots:
    """Return all real roots in [0, 1] of polynomials of one degree.

    Parameters
    ----------
    coefficients : array, shape (m, n + 1)
        Bernstein coefficients of m polynomials. Those that are zero, within noise, have no roots.
    noise : array, shape (m,), optional
        How large the error of a coefficient may be; by default n + 1 roundings of the largest.

    Examples
    --------
    >>> roots(np.array([[-1.0, 1.0, -0.5], [1.0, 2.0, 3.0]])).u.round(6)
    array([0.369398, 0.773459])
    """
    f = np.asarray(coefficients, float)
    power = np.frexp(np.abs(f).max(axis=1))[1]
    f = np.ldexp(f, -power[:, None])  # of size 1: no product overflows or vanishes
    size = np.abs(f).max(axis=1)
    own = f.shape[1] * EPSILON * size
    noise = own if noise is None else np.maximum(np.ldexp(noise, -power), own)
    found = _Found()
    row = np.flatnonzero(size > noise)
    f, noise = f[row], noise[row]
    start = np.zeros(len(row))
    _add_ends(found, row, f)
    for depth in range(DEEPEST + 1):
        width = 0.5**depth
        changes = _sign_changes(f)
        one = changes == 1
        if one.any():
            found.add(row[one], start[one] + width * _enclosed(f[one]), 0.0, True)
        blurred = ~one & ((np.abs(f).max(axis=1) <= noise) | ((depth == DEEPEST) & (changes > 1)))
        found.add(row[blurred], start[blurred] + width / 2, width / 2, False)
        open_ = (changes > 1) & ~blurred
        if not open_.any():
            break
        row, noise, start = row[open_], noise[open_], start[open_]
        left, right = split(f[open_])
        half = width / 2
        middle = right[:, 0] == 0  # a root that both halves share
        simple = (left[:, -2] * right[:, 1] < 0)[middle]
        found.add(row[middle], start[middle] + half, 0.0, simple)
        f = np.concatenate([left, right])
        row, noise = np.tile(row, 2), np.tile(noise, 2)
        start = np.concatenate([start, start + half])
    return found.sorted()


def _add_ends(found: _Found, row: np.ndarray, f: np.ndarray) -> None:
    for u, value, inner in ((0.0, f[:, 0], f[:, 1:2]), (1.0, f[:, -1], f[:, -2:-1])):
        zero = value == 0
        found.add(row[zero], np.full(int(zero.sum()), u), 0.0, (inner != 0).any(axis=1)[zero])


def _sign_changes(f: np.ndarray) -> np.ndarray:
    """Return how often consecutive coefficients of every row differ in sign, zeros left out."""
    signs = np.sign(f)
    if not signs.all():
        for i in range(1, signs.shape[1]):  # a zero takes the sign before it
            signs[:, i] = np.where(signs[:, i] == 0, signs[:, i - 1], signs[:, i])
    changed: np.ndarray = (signs[:, 1:] * signs[:, :-1] < 0).sum(axis=1)
    return changed


def _enclosed(f: np.ndarray) -> np.ndarray:
    """Return the only root of every row in (0, 1), by Newton's method.

    Its bracket is halved instead where a step leaves it, or is not half as long as the step
    before the last (Brent's and Dekker's safeguard): at most two steps a bit.
    """
    rows = np.concatenate([f[:, :, None], elevate(derivative(f))[:, :, None]], axis=2)
    first = np.sign(f[np.arange(len(f)), (f != 0).argmax(axis=1)])
    u = _secant(f)
    low, high = np.zeros(len(f)), np.ones(len(f))
    last, before = np.ones(len(f)), np.ones(len(f))
    busy = np.arange(len(f))
    for _ in range(4 * DEEPEST):
        at, a, b = u[busy], low[busy], high[busy]
        value, slope = values_at(rows[busy], at).T
        below = np.sign(value) == first[busy]
        a, b = np.where(below, at, a), np.where(below, b, at)
        with np.errstate(all="ignore"):
            newton = at - value / slope
            length = np.abs(newton - at)
        settled = (value == 0) | (length <= EPSILON * at) | (b - a <= EPSILON * b)
        step = np.where(
            (newton > a) & (newton < b) & (2 * length < before[busy]), newton, (a + b) / 2
        )
        step = np.where(settled, at, step)
        u[busy], low[busy], high[busy] = step, a, b
        before[busy], last[busy] = last[busy], np.abs(step - at)
        busy = busy[~settled]
        if not len(busy):
            break
    return u


def _secant(f: np.ndarray) -> np.ndarray:
    """Return where the control polygon's chord crosses zero, kept off the ends."""
    with np.errstate(all="ignore"):
        u = f[:, 0] / (f[:, 0] - f[:, -1])
    return np.clip(np.where(np.isfinite(u), u, 0.5), 1 / 64, 63 / 64)

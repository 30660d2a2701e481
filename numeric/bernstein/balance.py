"""Rational segments in even parameters: those that differ much in speed are taken by another u.

With the weights w_i c^i the same points belong to other parameters: u/(1 - u) is c times what it
was (Patterson, *Projective transformations of the parameter of a Bernstein-Bezier curve*, ACM
Transactions on Graphics 4, 1985). With a power of two for c, nothing is rounded.
"""

from __future__ import annotations

import numpy as np


def balanced(rows: np.ndarray, dim: int) -> tuple[np.ndarray, np.ndarray]:
    """Return rows (..., n + 1, columns) with end weights of one size, and c, shape (...).

    The largest weight keeps its size; c is 1 where that brings weights no nearer to each other.

    >>> rows, c = balanced(np.array([[0.0, 0.25], [2.0, 4.0]]), 1)
    >>> rows.tolist(), float(c)
    ([[0.0, 4.0], [2.0, 4.0]], 0.0625)
    """
    n = rows.shape[-2] - 1
    if rows.shape[-1] == dim or not n:
        return rows, np.ones(rows.shape[:-2])
    size = np.frexp(rows[..., dim])[1].astype(np.intp)
    there = rows[..., dim] != 0
    first, last = size[..., 0], size[..., -1]
    power = np.rint((first - last) / n).astype(np.intp)
    powers = power[..., None] * np.arange(n + 1)
    better = _spread(size + powers, there) < _spread(size, there)
    power = np.where(better & there[..., 0] & there[..., -1], power, 0)
    powers = power[..., None] * np.arange(n + 1)
    powers += (_most(size, there) - _most(size + powers, there))[..., None]
    return np.ldexp(rows, powers[..., None]), np.ldexp(1.0, power)


def _most(size: np.ndarray, there: np.ndarray) -> np.ndarray:
    most: np.ndarray = np.where(there, size, -9999).max(axis=-1)
    return most


def _spread(size: np.ndarray, there: np.ndarray) -> np.ndarray:
    return _most(size, there) + _most(-size, there)


def before(u: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return the parameters that places u of balanced rows had."""
    found: np.ndarray = c * u / (1 - u + c * u)
    return found

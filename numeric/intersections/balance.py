"""Rational segments in even parameters: those that differ much in speed are taken by another u.

With the weights w_i c^i the same points belong to other parameters: u/(1 - u) is c times what it
was (Patterson, *Projective transformations of the parameter of a Bernstein-Bezier curve*, ACM
Transactions on Graphics 4, 1985). With a power of two for c, nothing is rounded.
"""

from __future__ import annotations

import numpy as np

from .places import Places
from .shared import SAMPLES, Shared


def balanced(rows: np.ndarray, dim: int) -> tuple[np.ndarray, np.ndarray]:
    """Return rows (2, m, n + 1, columns) with end weights of one size, and c, shape (2, m)."""
    n = rows.shape[2] - 1
    if rows.shape[3] == dim or not n:
        return rows, np.ones(rows.shape[:2])
    ends = np.abs(rows[:, :, [0, -1], dim])
    power = np.frexp(ends)[1]
    power = np.where((ends > 0).all(axis=2), np.rint((power[..., 0] - power[..., 1]) / n), 0)
    power = power.astype(np.intp)
    powers = power[..., None] * np.arange(n + 1) - np.maximum(n * power, 0)[..., None]
    return np.ldexp(rows, powers[..., None]), np.ldexp(1.0, power)


def unbalanced(places: Places, c: np.ndarray) -> Places:
    """Return places with their parameters of before."""
    c = c[:, places.pair]
    slope = c / (1 - places.at + c * places.at) ** 2
    return places._replace(at=_before(places.at, c), error=places.error * slope)


def unbalanced_arcs(arcs: Shared, c: np.ndarray) -> Shared:
    """Return arcs with their parameters of before, again equally spaced on the first segment."""
    c = c[:, arcs.pair]
    if (c == 1).all():
        return arcs
    ends = _before(arcs.samples[:, :, [0, -1]], c.T[..., None])
    u = np.linspace(ends[:, 0, 0], ends[:, 0, 1], SAMPLES, axis=1)
    number = np.repeat(np.arange(len(arcs.pair)), SAMPLES)
    v = arcs.on_arc(number, _before(u, 1 / c[0, :, None]).ravel())[0].reshape(u.shape)
    v = _before(v, c[1, :, None])
    v[:, 0], v[:, -1] = ends[:, 1].T
    return arcs._replace(samples=np.stack([u, v], axis=1))


def _before(u: np.ndarray, c: np.ndarray) -> np.ndarray:
    before: np.ndarray = c * u / (1 - u + c * u)
    return before

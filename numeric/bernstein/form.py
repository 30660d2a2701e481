"""Polynomials of one degree by their Bernstein coefficients on [0, 1], many rows at once.

Coefficients stand along axis 1: shape (m, n + 1) for m polynomials, (m, n + 1, dim) for m curves.
Only affine combinations and products of them are taken, never powers of u: their errors do not
grow with the degree as those of the power form do (Farouki and Rajan, *On the numerical condition
of polynomials in Bernstein form*, CAGD 4, 1987).
"""

from __future__ import annotations

from functools import lru_cache
from math import comb
from typing import Any

import numpy as np

from symbolic import bezier


def split(rows: np.ndarray, u: Any = 0.5) -> tuple[np.ndarray, np.ndarray]:
    """Return the coefficients of the parts on [0, u] and [u, 1], by de Casteljau's algorithm.

    Parameters
    ----------
    rows : array, shape (m, n + 1, ...)
    u : number, or one for each of the m rows

    Examples
    --------
    >>> left, right = split(np.array([[0.0, 2.0, 0.0]]))
    >>> left.tolist(), right.tolist()
    ([[0.0, 1.0, 1.0]], [[1.0, 1.0, 0.0]])
    """
    u = along_rows(u, rows)
    v = 1 - u
    left, right = np.empty_like(rows), rows.copy()
    left[:, 0] = rows[:, 0]
    for r in range(1, rows.shape[1]):
        right[:, :-r] = v * right[:, :-r] + u * right[:, 1 : right.shape[1] - r + 1]
        left[:, r] = right[:, 0]
    return left, right


def part(rows: np.ndarray, start: Any, end: Any) -> np.ndarray:
    """Return the coefficients on [start, end], numbers or one of each for every row.

    They are the blossom's values b(start, ..., start, end, ..., end): the part from `start` on is
    cut once more, at (end - start)/(1 - start).

    >>> part(np.array([[0.0, 2.0, 0.0]]), 0.5, 1.0).tolist()
    [[1.0, 1.0, 0.0]]
    """
    start, end = np.asarray(start, float), np.asarray(end, float)
    upper = split(rows, start)[1]
    rest = 1 - start
    return split(upper, (end - start) / np.where(rest == 0, 1, rest))[0]


def derivative(rows: np.ndarray) -> np.ndarray:
    """Return the n coefficients n (c_{i+1} - c_i) of the derivative; of a constant, one zero.

    >>> derivative(np.array([[0.0, 2.0, 0.0]])).tolist()
    [[4.0, -4.0]]
    """
    n = rows.shape[1] - 1
    return n * np.diff(rows, axis=1) if n else np.zeros_like(rows)


def product(f: np.ndarray, g: np.ndarray) -> np.ndarray:
    """Return the n + k + 1 coefficients of f g, for arrays that broadcast except along axis 1.

    c_l = sum over i + j = l of C(n, i) C(k, j) / C(n + k, l) f_i g_j.

    >>> product(np.array([[0.0, 1.0]]), np.array([[0.0, 1.0]])).tolist()
    [[0.0, 0.0, 1.0]]
    """
    n, k = f.shape[1] - 1, g.shape[1] - 1
    weights = _product_weights(n, k)
    tail = np.broadcast_shapes(f[:, 0].shape, g[:, 0].shape)
    out = np.zeros((tail[0], n + k + 1, *tail[1:]))
    for i in range(n + 1):
        weight = weights[i].reshape(k + 1, *(1,) * (out.ndim - 2))
        out[:, i : i + k + 1] += f[:, i : i + 1] * (weight * g)
    return out


def elevate(rows: np.ndarray, by: int = 1) -> np.ndarray:
    """Return the coefficients of the same polynomials written with degree n + by.

    They are those of the product with the constant 1.

    >>> elevate(np.array([[0.0, 2.0]])).tolist()
    [[0.0, 1.0, 2.0]]
    """
    if not by:
        return rows
    return product(rows, np.ones((1, by + 1) + (1,) * (rows.ndim - 2)))


def to_powers(rows: np.ndarray) -> np.ndarray:
    """Return the coefficients of 1, u, ..., u^n.

    >>> to_powers(np.array([[0.0, 2.0, 0.0]])).tolist()
    [[0.0, 4.0, -4.0]]
    """
    return np.moveaxis(np.tensordot(_power_matrix(rows.shape[1] - 1), rows, (1, 1)), 0, 1)


def from_powers(rows: np.ndarray) -> np.ndarray:
    """Return the Bernstein coefficients of the polynomials sum a_k u^k.

    >>> from_powers(np.array([[0.0, 4.0, -4.0]])).tolist()
    [[0.0, 2.0, 0.0]]
    """
    return np.moveaxis(np.tensordot(_bernstein_matrix(rows.shape[1] - 1), rows, (1, 1)), 0, 1)


def along_rows(values: Any, rows: np.ndarray) -> np.ndarray:
    """Return a number, or one per row, in a shape that multiplies whole rows."""
    values = np.asarray(values, float)
    return values.reshape(-1, *(1,) * (rows.ndim - 1)) if values.ndim else values


@lru_cache(maxsize=256)
def _product_weights(n: int, k: int) -> np.ndarray:
    weights = np.array(
        [[comb(n, i) * comb(k, j) / comb(n + k, i + j) for j in range(k + 1)] for i in range(n + 1)]
    )
    weights.flags.writeable = False
    return weights


@lru_cache(maxsize=64)
def _power_matrix(n: int) -> np.ndarray:
    """Return the derived basis matrix: powers = matrix @ Bernstein coefficients."""
    if n == 0:
        return np.ones((1, 1))
    return np.array(bezier(n).matrix_as(powers="ascending").tolist(), dtype=float)


@lru_cache(maxsize=64)
def _bernstein_matrix(n: int) -> np.ndarray:
    if n == 0:
        return np.ones((1, 1))
    return np.array(bezier(n).matrix_as(powers="ascending").inv().tolist(), dtype=float)

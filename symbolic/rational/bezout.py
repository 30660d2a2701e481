"""Bezout's matrix of two polynomials: its determinant vanishes where they have a common root."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import combinations
from typing import Any

from sympy.polys.matrices import DomainMatrix

Triple = tuple[Any, Any, Any]


def bezout_matrix(forms: Sequence[Sequence[Any]], entry: Callable[[Triple], Any]) -> list[list]:
    r"""Return Bezout's matrix of x W - X and y W - Y, polynomials in t of formal degree n.

    With f = x W - X and g = y W - Y, f(t) g(s) - f(s) g(t) = (t - s) sum b_ij t^i s^j. The brackets
    f_i g_j - f_j g_i have no term x y, so every entry is linear: it is a x + b y + c.

    Parameters
    ----------
    forms : X, Y, W, lowest power first, n + 1 coefficients each
    entry : makes an entry out of (a, b, c)

    Notes
    -----
    Sederberg, Anderson and Goldman, *Implicit representation of parametric curves and surfaces*,
    1984; Cayley's form of the matrix.
    """
    x, y, w = forms
    n = len(w) - 1
    zero = w[0] - w[0]

    def bracket(i: int, j: int) -> Triple:
        return (w[j] * y[i] - w[i] * y[j], w[i] * x[j] - w[j] * x[i], x[i] * y[j] - x[j] * y[i])

    def sum_of_brackets(i: int, j: int) -> Triple:
        a = b = c = zero
        for k in range(min(i, n - 1 - j) + 1):
            more = bracket(j + 1 + k, i - k)
            a, b, c = a + more[0], b + more[1], c + more[2]
        return a, b, c

    upper = {(i, j): entry(sum_of_brackets(i, j)) for i in range(n) for j in range(i, n)}
    return [[upper[min(i, j), max(i, j)] for j in range(n)] for i in range(n)]


def determinant(rows: Sequence[Sequence[Any]], ring: Any) -> Any:
    """Return the determinant of a square matrix over a polynomial ring.

    Bareiss' algorithm divides, which is slow where coefficients have symbols; there the minors of
    the last 1, 2, ... rows are computed, each once.
    """
    size = len(rows)
    if ring.domain.is_PolynomialRing:
        minors: dict[tuple[int, ...], Any] = {(): ring.one}
        for k in range(1, size + 1):
            minors = {
                columns: _expanded(rows[size - k], columns, minors, ring)
                for columns in combinations(range(size), k)
            }
        return minors[tuple(range(size))]
    return DomainMatrix([list(row) for row in rows], (size, size), ring.to_domain()).det()


def _expanded(
    row: Sequence[Any], columns: tuple[int, ...], minors: Mapping[tuple[int, ...], Any], ring: Any
) -> Any:
    """Expand a determinant along its first row, given the minors below it."""
    total = ring.zero
    for k, column in enumerate(columns):
        if row[column]:
            term = row[column] * minors[columns[:k] + columns[k + 1 :]]
            total = total - term if k % 2 else total + term
    return total

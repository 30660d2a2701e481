"""Raising the degree of a Bezier curve without changing it, and lowering it as well as can be."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from ..errors import BadValue, shown
from ..exact import Point, control_points, whole_number
from ..exact_matrix import dense, product, to_matrix


def elevate_degree(points: Any, by: int = 1) -> tuple[Point, ...]:
    r"""Return control points of a higher degree for the same Bezier curve.

    One degree up: c_i = i/(n + 1) b_{i-1} + (1 - i/(n + 1)) b_i, i = 0 ... n + 1.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
    by : int >= 0

    Raises
    ------
    BadValue
        If `by` is negative.

    Notes
    -----
    Farin, *Curves and Surfaces for CAGD*, section 6.1.

    Examples
    --------
    >>> elevate_degree([[0, 0], [4, 8], [8, 0]])
    ((0, 0), (8/3, 16/3), (16/3, 16/3), (8, 0))
    """
    rows = control_points(points)
    times = whole_number(by)
    if times is None or times < 0:
        raise BadValue("a number of degrees 0, 1, 2, ...", shown(by), "To lower: reduce_degree.")
    for _ in range(times):
        rows = _elevated(rows)
    return rows


@dataclass(frozen=True)
class Reduction:
    """A curve of one degree less, and what it costs.

    Attributes
    ----------
    points : tuple of rows, shape (n, dim)
    squared_error : Expr
        The integral of the squared distance between both curves over [0, 1]; 0 if nothing is lost.
    """

    points: tuple[Point, ...]
    squared_error: sp.Expr


def reduce_degree(points: Any) -> Reduction:
    r"""Return the curve of one degree less that keeps both end points and is closest in L2.

    The inner points solve the normal equations of |E c - b|^2 in the Gram matrix of the Bernstein
    polynomials, G_ij = C(n, i) C(n, j) / ((2n + 1) C(2n, i + j)), where E raises the degree.

    Parameters
    ----------
    points : rows, shape (n + 1, dim), n >= 2

    Raises
    ------
    BadValue
        For degree 0 or 1: a line through both its end points cannot be reduced.

    Notes
    -----
    Eck, *Least squares degree reduction of Bezier curves*, 1995.

    Examples
    --------
    >>> reduce_degree([[0], [0], [0], [1]])
    Reduction(points=((0,), (-1/4,), (1,)), squared_error=1/840)
    >>> reduce_degree(elevate_degree([[0, 0], [1, 2], [3, 0]])).squared_error
    0
    """
    rows = control_points(points)
    n = len(rows) - 1
    if n < 2:
        raise BadValue(
            "a curve of degree 2 or more",
            f"one of degree {n}",
            "Both ends are kept, so a line is as low as it gets.",
        )
    ends_only = [rows[0], *[[0] * len(rows[0])] * (n - 2), rows[n]]
    gram = dense([[_inner_product(n, i, j) for j in range(n + 1)] for i in range(n + 1)])
    inner = dense(elevate_degree(sp.eye(n).tolist()))[:, 1 : n - 1]
    middle: list[list[sp.Expr]] = []
    if n > 2:
        weighted = product(inner.transpose(), gram)
        wanted = product(weighted, dense(_differences(rows, elevate_degree(ends_only))))
        middle = to_matrix(product(product(weighted, inner).inv(), wanted)).tolist()
    lower = (rows[0], *map(tuple, middle), rows[n])
    rest = dense(_differences(rows, elevate_degree(lower)))
    return Reduction(lower, to_matrix(product(rest.transpose(), product(gram, rest))).trace())


def _differences(left: tuple[Point, ...], right: tuple[Point, ...]) -> list[list[sp.Expr]]:
    return [[a - b for a, b in zip(p, q, strict=True)] for p, q in zip(left, right, strict=True)]


def _elevated(rows: tuple[Point, ...]) -> tuple[Point, ...]:
    n = len(rows)
    shares = [sp.Rational(i, n) for i in range(n + 1)]
    before, after = (rows[0], *rows), (*rows, rows[-1])
    return tuple(
        tuple(s * a + (1 - s) * b for a, b in zip(left, right, strict=True))
        for s, left, right in zip(shares, before, after, strict=True)
    )


def _inner_product(n: int, i: int, j: int) -> sp.Rational:
    """Return the integral of B_i^n B_j^n over [0, 1]."""
    return sp.Rational(
        sp.binomial(n, i) * sp.binomial(n, j), (2 * n + 1) * sp.binomial(2 * n, i + j)
    )

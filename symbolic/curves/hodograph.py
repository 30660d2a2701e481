"""Derivatives and integrals of Bezier curves, as Bezier curves."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..errors import BadValue, shown
from ..exact import Point, control_points, whole_number
from ..parameter_interval import read_interval


def hodograph(points: Any, order: int = 1, interval: Any = (0, 1)) -> tuple[Point, ...]:
    r"""Return the control points of the derivative curve of a Bezier curve.

    d/dt of degree n has the points n (b_{i+1} - b_i) / (s - r), i = 0 ... n - 1; the derivative of
    order k has n!/(n-k)! times the k-th differences, over (s - r)^k.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
    order : int >= 0
        Beyond the degree the derivative is the zero vector, one point.
    interval : (r, s)
        Over which the curve is parametrized.

    Raises
    ------
    BadValue
        For a negative order, or an interval of length zero.

    Notes
    -----
    Farin, *Curves and Surfaces for CAGD*, section 5.3.

    Examples
    --------
    >>> hodograph([[0, 0], [1, 2], [3, 0], [4, 0]])
    ((3, 6), (6, -6), (3, 0))
    >>> hodograph([[0, 0], [1, 2], [3, 0], [4, 0]], order=3, interval=(0, 2))
    ((-3/2, 9/2),)
    """
    rows = control_points(points)
    times = whole_number(order)
    if times is None or times < 0:
        raise BadValue("an order 0, 1, 2, ...", shown(order), "1 is the velocity.")
    start, end = read_interval(interval)
    for _ in range(times):
        n = len(rows) - 1
        if n == 0:
            return (tuple(sp.S.Zero for _ in rows[0]),)
        factor = n / (end - start)
        rows = tuple(
            tuple(factor * (b - a) for a, b in zip(left, right, strict=True))
            for left, right in zip(rows, rows[1:], strict=False)
        )
    return rows


def antiderivative(points: Any, interval: Any = (0, 1)) -> tuple[Point, ...]:
    r"""Return the control points of the integral of a Bezier curve, starting at zero.

    Point i + 1 is the sum of the first i + 1 points, times (s - r)/(n + 1). The last one is the
    integral over the whole interval: its length times the mean of the control points.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
    interval : (r, s)

    Raises
    ------
    BadValue
        For an interval of length zero.

    Examples
    --------
    >>> antiderivative([[0], [3], [6]])
    ((0,), (0,), (1,), (3,))
    """
    rows = control_points(points)
    start, end = read_interval(interval)
    factor = (end - start) / sp.Integer(len(rows))
    sums = [tuple(sp.S.Zero for _ in rows[0])]
    for row in rows:
        sums.append(tuple(a + b for a, b in zip(sums[-1], row, strict=True)))
    return tuple(tuple(factor * a for a in row) for row in sums)

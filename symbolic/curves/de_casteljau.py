"""De Casteljau's algorithm: a Bezier curve by repeated linear interpolation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from ..errors import BadType, BadValue, shown
from ..exact import Point, as_list, exact, exact_points
from ..parameter_interval import read_interval

Levels = tuple[tuple[Point, ...], ...]


def de_casteljau(points: Any, t: Any) -> Levels:
    r"""Return all intermediate points of de Casteljau's algorithm; levels[r][i] is b_i^r.

    b_i^0 are the control points, and b_i^r = (1 - t) b_i^{r-1} + t b_{i+1}^{r-1}. The point
    of the curve is b_0^n. Symbolic results stay unexpanded and share their subexpressions.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
        Control points, numbers or SymPy expressions; see `exact_points`.
    t : number or SymPy expression

    Returns
    -------
    tuple of levels
        Level r has n + 1 - r points; together n(n + 1)/2 interpolations.

    Raises
    ------
    BadValue, BadType, NotExact
        For points or a parameter that cannot be read exactly.

    Notes
    -----
    P. de Casteljau, Citroen, 1959; Farin, *Curves and Surfaces for CAGD*, chapter 4.

    Examples
    --------
    >>> from sympy import Rational
    >>> levels = de_casteljau([[0, 1], [1, 1], [0, 2]], Rational(1, 2))
    >>> levels[1]
    ((1/2, 1), (1/2, 3/2))
    >>> levels[-1][0]
    (1/2, 5/4)
    """
    rows, t = exact_points(points), exact(t)
    return _levels(rows, [t] * (len(rows) - 1))


def polar_levels(points: Any, arguments: Any, interval: Any = (0, 1)) -> Levels:
    r"""Return the levels of de Casteljau's algorithm with another parameter at every level.

    b_i^j = ((s - u_j) b_i^{j-1} + (u_j - r) b_{i+1}^{j-1}) / (s - r). The last point is the value
    f(u_1, ..., u_n) of the blossom of the Bezier curve over [r, s], whatever the order of the
    arguments; fewer than n arguments give the first levels only.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
    arguments : list of at most n numbers or expressions
    interval : (r, s)
        Over which the points are control points.

    Raises
    ------
    BadValue
        For more arguments than the degree, or an interval of length zero.

    Notes
    -----
    L. Ramshaw, *Blossoming: a connect-the-dots approach to splines*, 1987.

    Examples
    --------
    >>> polar_levels([[0, 0], [1, 2], [2, 0]], [0, 1])[-1]
    ((1, 2),)
    """
    rows = exact_points(points)
    given = as_list(arguments)
    if given is None:
        raise BadType("a list of arguments", shown(arguments), "Write [u1, u2, u3].")
    listed = [exact(u) for u in given]
    if len(listed) > len(rows) - 1:
        raise BadValue(
            f"at most {len(rows) - 1} arguments for {len(rows)} control points",
            f"{len(listed)}",
            "A polynomial of degree n has a blossom of n arguments.",
        )
    start, end = read_interval(interval)
    return _levels(rows, [(u - start) / (end - start) for u in listed])


def subdivide(points: Any, t: Any) -> tuple[tuple[Point, ...], tuple[Point, ...]]:
    r"""Split a Bezier curve at t into the control points of its left and right part.

    They are the two outer edges of de Casteljau's triangle: b_0^0, b_0^1, ..., b_0^n and
    b_0^n, b_1^{n-1}, ..., b_n^0. The left part runs over [0, t], the right one over [t, 1].

    Parameters
    ----------
    points, t : as in `de_casteljau`

    Raises
    ------
    BadValue, BadType, NotExact
        As in `de_casteljau`.

    Examples
    --------
    >>> from sympy import Rational
    >>> left, right = subdivide([[0, 0], [2, 2], [4, 0]], Rational(1, 2))
    >>> left, right
    (((0, 0), (1, 1), (2, 1)), ((2, 1), (3, 1), (4, 0)))
    """
    levels = de_casteljau(points, t)
    return tuple(level[0] for level in levels), tuple(level[-1] for level in reversed(levels))


def restrict(points: Any, start: Any, end: Any) -> tuple[Point, ...]:
    r"""Return the control points of the same curve over another interval, [start, end].

    Point i is the blossom value f(start, ..., start, end, ..., end) with i times `end`. The
    interval may reach beyond [0, 1] (the curve is extrapolated), or run backwards.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
    start, end : numbers or SymPy expressions

    Raises
    ------
    BadValue, BadType, NotExact
        As in `de_casteljau`.

    Examples
    --------
    >>> restrict([[0, 0], [2, 2], [4, 0]], 1, 2)
    ((4, 0), (6, -2), (8, -8))
    >>> restrict([[0, 0], [2, 2], [4, 0]], 1, 0)
    ((4, 0), (2, 2), (0, 0))
    """
    towards_start = de_casteljau(points, start)
    end = exact(end)
    return tuple(
        _levels(level, [end] * (len(level) - 1))[-1][0] for level in reversed(towards_start)
    )


def _levels(points: Sequence[Point], weights: Sequence[sp.Expr]) -> Levels:
    """Interpolate with one weight a level, from the control points on."""
    levels = [tuple(points)]
    for w in weights:
        v = 1 - w
        levels.append(
            tuple(
                tuple(v * a + w * b for a, b in zip(left, right, strict=True))
                for left, right in zip(levels[-1], levels[-1][1:], strict=False)
            )
        )
    return tuple(levels)

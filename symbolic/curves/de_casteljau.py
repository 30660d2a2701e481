"""De Casteljau's algorithm: a Bezier curve by repeated linear interpolation."""

from __future__ import annotations

from typing import Any

from ..exact import Point, exact, exact_points

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
    levels = [exact_points(points)]
    t = exact(t)
    s = 1 - t
    while len(levels[-1]) > 1:
        below = levels[-1]
        levels.append(
            tuple(
                tuple(s * a + t * b for a, b in zip(left, right, strict=True))
                for left, right in zip(below, below[1:], strict=False)
            )
        )
    return tuple(levels)


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

"""From polynomials to Bezier control points; the way back is `bezier(n).curve(points)`."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..blossoms.blossom import blossom
from ..exact import Point, as_list
from ..parameter_interval import read_interval


def polynomial_to_bezier(
    exprs: Any, t: sp.Symbol | None = None, interval: Any = (0, 1)
) -> tuple[Point, ...]:
    r"""Return the Bezier control points of a polynomial curve over an interval [r, s].

    Point i is the blossom value f(r, ..., r, s, ..., s) with i times s.

    Parameters
    ----------
    exprs : list of polynomials in t, one per coordinate; or a single polynomial
    t : Symbol, optional
        The variable; by default t.
    interval : (r, s)

    Returns
    -------
    rows, shape (n + 1, dim), with n the highest degree of a coordinate

    Raises
    ------
    BadValue
        If an expression is not a polynomial in t, or the interval is a single point.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> polynomial_to_bezier([t, t**2], t)
    ((0, 0), (1/2, 0), (1, 1))
    >>> polynomial_to_bezier([t, t**2], t, interval=(1, 3))
    ((1, 1), (2, 3), (3, 9))
    """
    listed = as_list(exprs)
    return blossom(listed if listed is not None else [exprs], t).control_points(
        *read_interval(interval)
    )

"""Knots for a non-uniform Catmull-Rom segment, from the distances of its control points."""

from __future__ import annotations

from itertools import accumulate, pairwise
from typing import Any

import sympy as sp

from ..errors import BadValue, shown
from ..exact import Point, exact, exact_points


def chord_knots(points: Any, alpha: Any) -> tuple[sp.Expr, ...]:
    r"""Return knots t_0 = 0, t_{i+1} = t_i + |P_{i+1} - P_i|^alpha, exactly; roots stay roots.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
        Control points with numbers as coordinates.
    alpha : rational number in [0, 1]
        0 gives uniform knots, 1/2 centripetal ones, 1 chordal ones.

    Raises
    ------
    BadValue
        For another alpha, imaginary coordinates, and where alpha > 0 for symbolic ones and for
        coincident neighbours.
    BadType, NotExact
        For points or numbers that cannot be read exactly.

    Notes
    -----
    E. T. Y. Lee, "Choosing nodes in parametric curve interpolation", 1989 (centripetal);
    Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.

    Examples
    --------
    >>> chord_knots([[0, 0], [3, 4], [3, 5], [4, 6]], sp.Rational(1, 2))
    (0, sqrt(5), 1 + sqrt(5), 1 + 2**(1/4) + sqrt(5))
    """
    rows, power = exact_points(points), exact(alpha)
    if not (power.is_Rational and 0 <= power <= 1):
        raise BadValue(
            "a rational alpha between 0 and 1", shown(alpha), "Rational(1, 2) is centripetal."
        )
    gaps = [_gap(a, b, power, i) for i, (a, b) in enumerate(pairwise(rows))]
    return tuple(accumulate(gaps, initial=sp.S.Zero))


def _gap(left: Point, right: Point, power: sp.Rational, i: int) -> sp.Expr:
    if any(x.is_real is False for x in (*left, *right)):
        raise BadValue(
            "real coordinates", f"{left} and {right}", "Give real and imaginary part as x and y."
        )
    squared = sp.Add(*((b - a) ** 2 for a, b in zip(left, right, strict=True)))
    squared = squared if squared.is_Rational else sp.expand(squared)
    if power == 0:
        return sp.S.One
    if not squared.is_Rational:
        raise BadValue(
            "points at rational distances squared",
            f"the distance of P{i} and P{i + 1}: the root of {shown(squared)}",
            "Give the knots as symbols: catmull_rom(symbols('t0:4')).",
        )
    if squared == 0:
        raise BadValue(
            "neighbouring points that differ",
            f"P{i} = P{i + 1} = {left}",
            "Leave one of them out, or use alpha = 0.",
        )
    return sp.Pow(squared, power / 2)

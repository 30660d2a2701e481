"""The full circle as an exact NURBS curve."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..errors import BadValue, shown
from ..exact import whole_number
from ..real_numbers import real
from ..signs import sign
from .arcs import plane_point
from .nurbs import NURBS

_SEGMENTS = (3, 4, 6, 12)  # whose sines and cosines are sums of simple square roots


def circle(center: Any = (0, 0), radius: Any = 1, segments: int = 4) -> NURBS:
    r"""Return a circle of 3, 4, 6 or 12 arcs of degree 2, counterclockwise from angle 0.

    Every other control point is on the circle and has weight 1; between them are the corners of
    the regular polygon around the circle, of weight cos(pi/segments): the square of 9 points has
    sqrt(2)/2, the triangle of 7 points 1/2. The inner knots i/segments are double.

    Parameters
    ----------
    center : two coordinates
    radius : number > 0, or a symbol
    segments : 3, 4, 6 or 12

    Raises
    ------
    BadValue
        For other numbers of segments, and a radius that is not positive.

    Notes
    -----
    Piegl and Tiller, *A menagerie of rational B-spline circles*, 1989.

    Examples
    --------
    >>> circle().points[:4], circle().weights[:4]
    (((1, 0), (1, 1), (0, 1), (-1, 1)), (1, sqrt(2)/2, 1, sqrt(2)/2))
    >>> circle(segments=3).weights
    (1, 1/2, 1, 1/2, 1, 1/2, 1)
    """
    n = whole_number(segments)
    if n not in _SEGMENTS:
        raise BadValue(
            "3, 4, 6 or 12 segments",
            shown(segments),
            "Their sines and cosines are exact; for others put arcs of your own together.",
        )
    r = real(radius, "radius")
    if sign(r) in (0, -1):
        raise BadValue("a positive radius", shown(radius), "Use a number such as 1.")
    x, y = plane_point(center)
    weight = sp.cos(sp.pi / n)
    points, weights = [], []
    for k in range(2 * n + 1):
        angle, reach = sp.pi * k / n, r if k % 2 == 0 else sp.radsimp(1 / weight) * r
        points.append([sp.expand(m + reach * f(angle))
                       for m, f in ((x, sp.cos), (y, sp.sin))])  # fmt: skip
        weights.append(sp.S.One if k % 2 == 0 else weight)
    inner = [sp.Rational(k, n) for k in range(1, n) for _ in range(2)]
    return NURBS([0, 0, 0, *inner, 1, 1, 1], 2, points, weights)

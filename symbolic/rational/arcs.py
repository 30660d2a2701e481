"""Circular arcs as exact rational quadratic curves."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, Point, control_points
from ..fields import common_field
from ..proofs.derivation import Derivation, Step
from ..real_numbers import real
from ..signs import sign
from ..written import plus
from .homogeneous import decidable_field, quotient
from .rational_bezier import RationalBezier


def arc(cosine: Any, center: Any = (0, 0), radius: Any = 1) -> RationalBezier:
    r"""Return the arc counterclockwise from angle 0, its opening angle given by the cosine.

    With C the cosine, the middle control point has the weight sqrt((1 + C)/2), the cosine of half
    the angle; see `arc_between`.

    Parameters
    ----------
    cosine : rational number or one with square roots, -1 < cosine < 1
    center : two coordinates
    radius : positive number; a symbol is taken to be

    Raises
    ------
    BadValue
        For a cosine out of range, a radius that is not positive, and a sine with roots of too high
        a degree together.

    Examples
    --------
    >>> arc(sp.Rational(1, 2))
    RationalBezier(points=((1, 0), (1, sqrt(3)/3), (1/2, sqrt(3)/2)), weights=(1, sqrt(3)/2, 1))
    """
    c, r = real(cosine, "cosine"), real(radius, "radius")
    if sign(1 - c) != 1 or sign(1 + c) != 1:
        raise BadValue(
            "the cosine of an angle between 0 and 180 degrees, a number between -1 and 1",
            shown(cosine),
            "Put longer arcs together from shorter ones.",
        )
    if sign(r) in (-1, 0):
        raise BadValue("a positive radius", shown(radius), "Use a number such as 1.")
    sine = _root(1 - c**2)
    if sine is None:
        raise BadValue(
            "a cosine whose sine is made of rational numbers and a few roots",
            shown(cosine),
            "Angles like 30, 45, 60 and 90 degrees, and all rational cosines, are exact.",
        )
    x, y = plane_point(center)
    tangent = r * quotient(sine, 1 + c)  # the tangent of half the angle, times r
    points = ((x + r, y), (x + r, y + tangent), (x + r * c, y + r * sine))
    return RationalBezier(points, _weights(c))


def arc_between(start: Any, end: Any, center: Any = (0, 0)) -> RationalBezier:
    r"""Return the shorter arc of a circle from one point to another.

    With C the cosine of the opening angle, the middle control point is m + (a + b)/(1 + C), where
    the tangents meet, for the center m and the radii a and b. The weights are
    (1, sqrt((1 + C)/2), 1); where this root is no simple one, (2, 1 + C, 1 + C), which give the
    same arc without a root.

    Parameters
    ----------
    start, end, center : two coordinates each, the ends equally far from the center

    Raises
    ------
    BadValue
        For points that are the same, opposite, or not on one circle about the center.

    Notes
    -----
    Piegl and Tiller, *The NURBS Book*, section 7.3. Half a circle needs a control point at
    infinity: ``RationalBezier([[1, 0], [0, 1], [-1, 0]], [1, 0, 1])``.

    Examples
    --------
    >>> arc_between([1, 0], [0, 1])
    RationalBezier(points=((1, 0), (1, 1), (0, 1)), weights=(1, sqrt(2)/2, 1))
    >>> arc_between([5, 0], [3, 4]).weights
    (1, 2*sqrt(5)/5, 1)
    """
    (p, q), (x, y) = (plane_point(start), plane_point(end)), plane_point(center)
    field, (px, py, qx, qy, mx, my) = decidable_field([*p, *q, x, y])
    ax, ay, bx, by = px - mx, py - my, qx - mx, qy - my
    squared = ax * ax + ay * ay
    if squared != bx * bx + by * by:
        raise BadValue(
            "two points equally far from the center",
            f"squared distances {field.to_sympy(squared)} and {field.to_sympy(bx**2 + by**2)}",
            "Move one of them, or the center.",
        )
    if ax * by == ay * bx:
        raise BadValue(
            "two points that are neither the same nor opposite each other",
            f"{shown(p)} and {shown(q)}",
            "Put the circle together from arcs of less than 180 degrees.",
        )
    cosine = (ax * bx + ay * by) / squared
    corner = (mx + (ax + bx) / (1 + cosine), my + (ay + by) / (1 + cosine))
    points = (p, tuple(map(field.to_sympy, corner)), q)
    return RationalBezier(points, _weights(field.to_sympy(cosine)))


def on_circle(curve: RationalBezier, center: Any = (0, 0), radius: Any = 1) -> Derivation:
    """Return the derivation that a plane curve lies on a circle.

    Its step (X - m_x W)^2 + (Y - m_y W)^2 = r^2 W^2 is an identity of polynomials, over an
    algebraic field where there are roots. It is refuted for a curve that leaves the circle.

    Examples
    --------
    >>> on_circle(arc_between([1, 0], [0, 1])).is_proved
    True
    """
    if not isinstance(curve, RationalBezier):
        raise BadType(
            "a RationalBezier",
            shown(curve),
            "Of a NURBS curve take the pieces: nurbs.to_bezier().",
        )
    if len(curve.points[0]) != 2:
        raise BadValue("a curve in the plane", f"{len(curve.points[0])} coordinates", "Project it.")
    mx, my = plane_point(center)
    r = real(radius, "radius")
    if PARAMETER in r.free_symbols:
        raise BadValue("a radius without the parameter t", shown(radius), "Use another symbol.")
    (x, y), w = curve.fractions
    left = plus((x - mx * w) ** 2, (y - my * w) ** 2)
    c = curve.curve()
    quotients = plus((c[0] - mx) ** 2, (c[1] - my) ** 2)
    return Derivation(
        f"A rational curve on the circle of radius {r}",
        (
            Step(left, r**2 * w**2, "numerators and denominator multiplied out"),
            Step(quotients, r**2, "divided by the squared denominator: the equation of the circle"),
        ),
        "Piegl and Tiller, The NURBS Book, section 7.3",
    )


def plane_point(value: Any) -> Point:
    """Read one point of the plane."""
    (row,) = control_points([value])
    if len(row) != 2:
        raise BadValue("a point in the plane", shown(row), "Give two coordinates.")
    return tuple(real(x, "coordinates") for x in row)


def _weights(cosine: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    half = _root((1 + cosine) / 2)
    return (sp.S(2), 1 + cosine, 1 + cosine) if half is None else (sp.S.One, half, sp.S.One)


def _root(number: sp.Expr) -> sp.Expr | None:
    """Return the square root of a number, if it is a sum of simple roots."""
    root = sp.sqrtdenest(sp.sqrt(sp.expand(number)))
    try:
        common_field([root])
    except BadValue:
        return None
    return root

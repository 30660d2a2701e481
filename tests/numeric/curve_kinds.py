"""Curves of every kind with their exact values, for laws that all of them obey."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

import sympy as sp

from numeric import Curve
from symbolic import (
    NURBS,
    BSpline,
    RationalBezier,
    circle,
    de_casteljau,
    hermite,
    interpolating_spline,
)

t = sp.Symbol("t")


class Kind(NamedTuple):
    """A curve and its exact point at a rational parameter."""

    curve: Curve
    exact: Callable[[Fraction], Sequence]


def rows(count, dim, seed=1):
    """Return fractions that are exact as floats, and no two alike."""
    return [
        [Fraction((seed + 7 * i * i + 11 * k * (i + 1)) % 97 - 48, 16) for k in range(dim)]
        for i in range(count)
    ]


def bezier_kind(degree, dim):
    points = rows(degree + 1, dim)
    return Kind(Curve.from_bezier(points, (-1, 3)),
                lambda u: de_casteljau(points, (u + 1) / 4)[-1][0])  # fmt: skip


def bspline_kind(knots, degree, dim):
    points = rows(len(knots) - degree - 1, dim)
    spline = BSpline(knots, degree)
    return Kind(
        Curve.from_bspline(points, knots, degree), lambda u: spline.de_boor(points, u)[-1][0]
    )


def nurbs_kind(knots, degree, dim):
    points = rows(len(knots) - degree - 1, dim)
    weights = [Fraction(1 + (3 * i) % 5, 2) for i in range(len(points))]
    nurbs = NURBS(knots, degree, points, weights)
    return Kind(Curve.from_bspline(points, knots, degree, weights),
                lambda u: nurbs.de_boor(u).points[-1][0])  # fmt: skip


def expression_kind(expressions, domain):
    return Kind(Curve.from_expressions(expressions, t, domain),
                lambda u: [e.subs(t, sp.Rational(u)) for e in expressions])  # fmt: skip


def interpolation_kind():
    spline = interpolating_spline(rows(5, 2), [0, 1, 2, 4, 5])

    def exact(u):
        pieces = spline.pieces
        piece = next((p for p in pieces if u < p.end), pieces[-1])
        return [e.subs(t, sp.Rational(u)) for e in piece.coordinates]

    return Kind(Curve.from_interpolation(spline), exact)


def rational_kind():
    curve = RationalBezier(rows(4, 2), [1, 3, Fraction(1, 2), 2])
    return Kind(Curve.from_nurbs(curve), lambda u: curve.de_casteljau(u).points[-1][0])


DOUBLE = [0, 0, 0, 0, 1, 2, 2, 3, 5, 5, 5, 5]
KINDS = {
    **{f"Bezier of degree {n} in {dim}D": bezier_kind(n, dim)
       for n, dim in ((1, 1), (2, 2), (3, 3), (5, 4), (7, 2), (8, 2), (13, 1), (25, 2))},
    "B-spline, double knot": bspline_kind(DOUBLE, 3, 2),
    "B-spline, not clamped": bspline_kind([0, 1, 3, 4, 6, 7, 8, 10], 2, 3),
    "B-spline, gap in an inner knot": bspline_kind([0, 0, 1, 1, 2, 2], 1, 2),
    "B-spline of degree 0": bspline_kind([0, 1, 2, 4], 0, 2),
    "NURBS, double knot": nurbs_kind(DOUBLE, 3, 3),
    "circle": Kind(Curve.from_nurbs(circle()), lambda u: circle().de_boor(u).points[-1][0]),
    "rational Bezier": rational_kind(),
    "interpolating spline": interpolation_kind(),
    "Hermite": Kind(Curve.from_basis(hermite(5), rows(6, 2)),
                    lambda u: [e.subs(t, sp.Rational(u)) for e in hermite(5).curve(rows(6, 2))]),
    "polynomials": expression_kind([t**4 - t, 2 * t, sp.Integer(3)], (-2, 2)),
    "rational functions": expression_kind([t / (1 + t**2), 1 / (1 + t**2)], (0, 2)),
}  # fmt: skip

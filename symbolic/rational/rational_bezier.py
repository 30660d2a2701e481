"""Rational Bezier curves: Bezier curves in homogeneous coordinates, seen from the origin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from ..bases.bezier import bezier
from ..curves.de_casteljau import de_casteljau, subdivide
from ..curves.degree import elevate_degree
from ..errors import BadValue, shown
from ..exact import Point, by_name, exact, exact_points
from ..real_numbers import real
from ..signs import sign
from .homogeneous import (
    RationalLevels,
    lifted,
    projected,
    projected_levels,
    quotient,
    read_weighted,
    warn_of_hull,
)


@dataclass(frozen=True)
class RationalBezier:
    r"""The curve sum w_i p_i B_i^n(t) / sum w_i B_i^n(t), t in [0, 1].

    Parameters
    ----------
    points : rows, shape (n + 1, dim), n >= 1
        Numbers, roots and symbols other than t. A point of weight zero lies at infinity: its row
        is then a vector v, and contributes v B_i^n to the numerator.
    weights : n + 1 numbers or expressions
        The first and last are not zero.

    Raises
    ------
    BadValue, BadType, NotExact
        For points and weights that cannot be read, or do not make a curve; see `read_weighted`.

    Warns
    -----
    HullWarning
        Where the weights are not all of one sign: the convex hull property is lost.

    Notes
    -----
    Farin, *Algorithms for rational Bezier curves*, CAD 15, 1983.

    Examples
    --------
    A quarter circle. (With weights 1, 0, 1 the points [1, 0], [-1, 0] and the vector [0, 1] between
    them make a half circle.)

    >>> RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 2]).curve()
    ((1 - t**2)/(t**2 + 1), 2*t/(t**2 + 1))
    """

    points: tuple[Point, ...]
    weights: tuple[sp.Expr, ...]

    def __post_init__(self) -> None:
        points, weights = read_weighted(self.points, self.weights)
        if len(points) < 2:
            raise BadValue("at least two control points", "one", "One point is no curve.")
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "weights", weights)
        warn_of_hull(weights, stacklevel=3)  # the caller of the constructor

    @classmethod
    def from_homogeneous(cls, rows: Any) -> RationalBezier:
        """Return the curve with homogeneous control points (w x, w y, ..., w).

        Rows are the Bernstein coefficients of numerators and denominator; a last entry 0 makes
        the rest a vector.

        Parameters
        ----------
        rows : shape (n + 1, dim + 1)

        Examples
        --------
        1 - t^2, 2t and 1 + t^2 have the Bernstein coefficients (1, 1, 0), (0, 1, 2), (1, 1, 2):

        >>> RationalBezier.from_homogeneous([[1, 0, 1], [1, 1, 1], [0, 2, 2]])
        RationalBezier(points=((1, 0), (1, 1), (0, 1)), weights=(1, 1, 2))
        """
        read = exact_points(rows)
        if len(read[0]) < 2:
            raise BadValue(
                "rows of one or more coordinates and a weight",
                f"rows of {len(read[0])}",
                "Append the weight to every row.",
            )
        return cls(*projected(read))

    @property
    def degree(self) -> int:
        """The degree n."""
        return len(self.points) - 1

    @property
    def homogeneous(self) -> tuple[Point, ...]:
        """The rows (w x, w y, ..., w), shape (n + 1, dim + 1); (v, 0) for a vector v."""
        return lifted(self.points, self.weights)

    @property
    def fractions(self) -> tuple[tuple[sp.Expr, ...], sp.Expr]:
        """The numerators and their common denominator, polynomials in t."""
        *numerators, denominator = bezier(self.degree).curve(self.homogeneous)
        return tuple(numerators), denominator

    def curve(self) -> tuple[sp.Expr, ...]:
        """Return the curve, one quotient of polynomials in t per coordinate.

        With equal weights it is the polynomial curve.
        """
        numerators, denominator = self.fractions
        return tuple(numerator / denominator for numerator in numerators)

    def de_casteljau(self, t: Any) -> RationalLevels:
        r"""Return all intermediate points and weights; the curve's point is points[n][0].

        w_i^r = (1 - t) w_i^{r-1} + t w_{i+1}^{r-1}, and b_i^r is the mean of b_i^{r-1} and
        b_{i+1}^{r-1} with the weights (1 - t) w_i^{r-1} and t w_{i+1}^{r-1}: the homogeneous
        points of de Casteljau's algorithm, each projected. A point of weight zero is a vector.

        Parameters
        ----------
        t : number or expression
            With symbols, the results stay unexpanded.

        Examples
        --------
        >>> arc = RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 2])
        >>> levels = arc.de_casteljau(sp.Rational(1, 2))
        >>> levels.points[1], levels.weights[1]
        (((1, 1/2), (1/3, 1)), (1, 3/2))
        >>> levels.points[2]
        ((3/5, 4/5),)
        """
        return projected_levels(de_casteljau(self.homogeneous, _read(t)))

    def subdivide(self, t: Any) -> tuple[RationalBezier, RationalBezier]:
        """Split the curve at t: the left part is over [0, t], the right one over [t, 1].

        Raises
        ------
        BadValue
            If the curve is at infinity for this t.

        Examples
        --------
        >>> arc = RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 2])
        >>> left, right = arc.subdivide(sp.Rational(1, 2))
        >>> left
        RationalBezier(points=((1, 0), (1, 1/2), (3/5, 4/5)), weights=(1, 1, 5/4))
        """
        left, right = subdivide(self.homogeneous, _read(t))
        if sign(left[-1][-1]) == 0:
            raise BadValue(
                "a parameter at which the curve has a point",
                f"t = {shown(t)}, where it is at infinity",
                "Subdivide elsewhere.",
            )
        return RationalBezier.from_homogeneous(left), RationalBezier.from_homogeneous(right)

    def end_derivatives(self) -> tuple[Point, Point]:
        """Return c'(0) = n w_1/w_0 (p_1 - p_0) and c'(1) = n w_{n-1}/w_n (p_n - p_{n-1}).

        >>> RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 2]).end_derivatives()
        ((0, 2), (-1, 0))
        """
        rows, n = self.homogeneous, self.degree

        def towards(end: int, inner: int) -> list[sp.Expr]:
            *h, w = rows[inner]
            p, w_end = self.points[end], self.weights[end]
            return [n * (a - w * b) / w_end for a, b in zip(h, p, strict=True)]

        return tuple(towards(0, 1)), tuple(-x for x in towards(n, n - 1))

    def reparametrized(self, c: Any) -> RationalBezier:
        r"""Return the same curve with weights c^i w_i, for c other than zero.

        Its point at t is the point of this curve at c t/(1 - t + c t). A negative c gives the
        complementary part of the curve, through infinity or around the ellipse.

        Examples
        --------
        >>> arc = RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 2])
        >>> arc.reparametrized(sp.sqrt(2)/2).weights
        (1, sqrt(2)/2, 1)
        """
        factor = real(c, "factor")
        if sign(factor) == 0:
            raise BadValue("a factor other than zero", "0", "c = 1 leaves the curve as it is.")
        weights = [factor**i * w for i, w in enumerate(self.weights)]
        points = [  # a point at infinity is a vector, and takes the factor itself
            tuple(factor**i * x for x in row) if w == 0 else row
            for i, (row, w) in enumerate(zip(self.points, self.weights, strict=True))
        ]
        return RationalBezier(tuple(points), tuple(weights))

    def standard_form(self) -> RationalBezier:
        """Return the same curve with first and last weight 1, reparametrized.

        c^n = w_0/w_n with c > 0; then all weights are divided by w_0.

        Raises
        ------
        BadValue
            If the end weights have different signs, or c is no number made of simple roots.

        Examples
        --------
        >>> RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 2]).standard_form().weights
        (1, sqrt(2)/2, 1)
        """
        ratio = quotient(self.weights[0], self.weights[-1])
        if sign(ratio) != 1:
            raise BadValue(
                "end weights that are numbers of one sign",
                f"{self.weights[0]} and {self.weights[-1]}",
                "Otherwise the curve runs through infinity between its ends.",
            )
        scale = 1 / self.weights[0]
        try:
            same = self.reparametrized(sp.sqrtdenest(sp.root(ratio, self.degree)))
            rows = [tuple(quotient(x, self.weights[0]) for x in row) for row in same.homogeneous]
        except BadValue:
            raise BadValue(
                f"end weights whose ratio has an exact root of order {self.degree}",
                f"the ratio {shown(ratio)}",
                f"Divide by the first weight, {shown(scale)}, and keep the parameter.",
            ) from None
        return RationalBezier.from_homogeneous(rows)

    def elevate_degree(self, by: int = 1) -> RationalBezier:
        """Return the same curve, its homogeneous control points raised by some degrees.

        >>> RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 2]).elevate_degree().weights
        (1, 1, 4/3, 2)
        """
        return RationalBezier.from_homogeneous(elevate_degree(self.homogeneous, by))


def _read(value: Any) -> sp.Expr:
    return by_name(exact(value))

"""NURBS: B-spline curves in homogeneous coordinates, seen from the origin."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from ..exact import Point
from ..proofs.derivation import Derivation, Step
from ..splines.conversion import Segment, segments, to_bezier
from ..splines.cox_de_boor import basis_functions
from ..splines.de_boor import de_boor
from ..splines.insertion import insert
from ..splines.knots import KnotVector
from ..splines.weights import read_points
from ..written import plus
from .homogeneous import (
    RationalLevels,
    lifted,
    projected,
    projected_levels,
    read_weighted,
    warn_of_hull,
)
from .rational_bezier import RationalBezier


@dataclass(frozen=True, init=False, repr=False)
class NURBS:
    r"""The curve sum w_i p_i N_i(t) / sum w_i N_i(t) with the B-spline functions N_i.

    Parameters
    ----------
    knots : list of exact numbers or expressions, or a KnotVector
    degree : int
    points : rows, shape (len(knots) - degree - 1, dim)
        A point of weight zero is given as a vector, as in `RationalBezier`.
    weights : one per point
        The first and last are not zero.

    Raises
    ------
    BadValue, BadType, NotExact
        As in `KnotVector` and `RationalBezier`; and for another number of points than the knots
        ask for.

    Warns
    -----
    HullWarning
        Where the weights are not all of one sign: the convex hull property is lost.

    Notes
    -----
    Piegl and Tiller, *The NURBS Book*, chapter 4. With equal weights it is the B-spline curve.

    Examples
    --------
    >>> half = NURBS([0, 0, 0, 1, 1, 2, 2, 2], 2,
    ...              [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]], [2, 1, 1, 1, 2])
    >>> half.curve()[0].coordinates
    ((2 - 2*t)/(t**2 - 2*t + 2), (-t**2 + 2*t)/(t**2 - 2*t + 2))
    >>> half.de_boor(sp.Rational(1, 2)).points[-1]
    ((4/5, 3/5),)
    """

    knots: KnotVector
    points: tuple[Point, ...]
    weights: tuple[sp.Expr, ...]

    def __init__(self, knots: Any, degree: Any, points: Any, weights: Any) -> None:
        vector = KnotVector(knots.knots if isinstance(knots, KnotVector) else knots, degree)
        rows, numbers = read_weighted(points, weights)
        object.__setattr__(self, "knots", vector)
        object.__setattr__(self, "points", read_points(vector, rows))
        object.__setattr__(self, "weights", numbers)
        warn_of_hull(numbers, stacklevel=2)  # the caller of the constructor

    @property
    def degree(self) -> int:
        """The degree of every piece."""
        return self.knots.degree

    @property
    def homogeneous(self) -> tuple[Point, ...]:
        """The rows (w x, w y, ..., w), one per control point; (v, 0) for a vector v."""
        return lifted(self.points, self.weights)

    def curve(self) -> tuple[Segment, ...]:
        """Return the curve on every span, one quotient of polynomials in t per coordinate."""
        pieces = segments(self.knots, self.homogeneous)
        return tuple(
            Segment(start, end, tuple(x / coordinates[-1] for x in coordinates[:-1]))
            for start, end, coordinates in pieces
        )

    def de_boor(self, t: Any, span: Any = None) -> RationalLevels:
        """Return de Boor's intermediate points and weights; points[degree][0] is the curve's point.

        They are the homogeneous points of de Boor's algorithm, each projected.

        Parameters
        ----------
        t, span : as for a B-spline: any expression, if the index of a span is given

        Raises
        ------
        OutsideDomain, BadValue
            For t outside the domain, or a span left open by symbols.
        """
        return projected_levels(de_boor(self.knots, self.homogeneous, t, span))

    def insert(self, t: Any, times: int = 1) -> NURBS:
        """Return the same curve with a knot inserted: Boehm's points in homogeneous coordinates.

        >>> arc = NURBS([0, 0, 0, 1, 1, 1], 2, [[1, 0], [1, 1], [0, 1]], [1, 1, 2])
        >>> arc.insert(sp.Rational(1, 2)).points
        ((1, 0), (1, 1/2), (1/3, 1), (0, 1))
        """
        knots, rows = insert(self.knots, self.homogeneous, t, times)
        return NURBS(knots, self.degree, *projected(rows))

    def to_bezier(self) -> tuple[RationalBezier, ...]:
        """Return the rational Bezier curve of every span, each over [0, 1], in order.

        >>> arc = NURBS([0, 0, 0, 1, 1, 1], 2, [[1, 0], [1, 1], [0, 1]], [1, 1, 2])
        >>> arc.to_bezier()
        (RationalBezier(points=((1, 0), (1, 1), (0, 1)), weights=(1, 1, 2)),)
        """
        pieces = to_bezier(self.knots, self.homogeneous)
        return tuple(RationalBezier.from_homogeneous(piece.points) for piece in pieces)

    @cached_property
    def derivation(self) -> Derivation:
        """The curve as the projection of a B-spline one dimension up, span by span."""
        functions = basis_functions(self.knots)
        steps = []
        curves = zip(self.knots.spans, self.curve(), strict=True)
        for j, (start, end, coordinates) in curves:
            on_span = [
                next((piece.polynomial for piece in pieces if piece.span == j), sp.S.Zero)
                for pieces in functions[j - self.degree : j + 1]
            ]
            rows = self.homogeneous[j - self.degree : j + 1]
            *numerators, w = (
                plus(*(n * x for n, x in zip(on_span, column, strict=True) if n * x != 0))
                for column in zip(*rows, strict=True)
            )
            steps.append(
                Step([x / w for x in numerators], list(coordinates),
                     f"on [{start}, {end}]: sums of w_i p_i N_i over the sum of w_i N_i; the "
                     "B-spline with the points (w x, w y, ..., w), divided by its last coordinate")
            )  # fmt: skip
        source = "Piegl and Tiller, The NURBS Book, chapter 4"
        return Derivation("A NURBS curve as a projection", tuple(steps), source)

    def __repr__(self) -> str:
        return f"<NURBS of degree {self.degree}: {len(self.points)} control points>"

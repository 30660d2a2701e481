"""B-splines of one knot vector: the noun that the algorithms of this room hang on."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from ..bases.basis import Basis
from ..blossoms.blossom import Blossom, blossom
from ..errors import BadValue, shown
from ..exact import PARAMETER, Point, whole_number
from ..proofs.derivation import Derivation, Step
from ..written import plus
from . import calculus, conversion, cox_de_boor, discretization, insertion, multiplicity
from . import de_boor as evaluation
from .knots import KnotVector
from .weights import read_points


@dataclass(frozen=True, init=False, repr=False)
class BSpline:
    r"""The B-splines of degree p over a knot vector, and the curves c(t) = sum_i P_i N_{i,p}(t).

    Parameters
    ----------
    knots : list of exact numbers or expressions, or a KnotVector
    degree : int
        Not needed with a KnotVector.

    Raises
    ------
    BadValue, BadType, NotExact
        As in `KnotVector`.

    Examples
    --------
    >>> spline = BSpline([0, 0, 0, 1, 2, 2, 2], 2)
    >>> spline.functions[1]
    (-3*t**2/2 + 2*t on [0, 1), t**2/2 - 2*t + 2 on [1, 2))
    >>> spline.curve([[0, 0], [1, 2], [3, 2], [4, 0]])[0]
    Segment(start=0, end=1, coordinates=(2*t, -2*t**2 + 4*t))
    """

    knots: KnotVector

    def __init__(self, knots: Any, degree: Any = None) -> None:
        if not isinstance(knots, KnotVector):
            knots = KnotVector(knots, degree)
        elif degree is not None and whole_number(degree) != knots.degree:
            raise BadValue(
                f"degree {knots.degree}, that of the knot vector", shown(degree), "Leave it out."
            )
        object.__setattr__(self, "knots", knots)

    @property
    def degree(self) -> int:
        """The degree p; the order is p + 1."""
        return self.knots.degree

    @property
    def point_count(self) -> int:
        """The number of basis functions and control points."""
        return self.knots.point_count

    @cached_property
    def functions(self) -> tuple[cox_de_boor.Pieces, ...]:
        """The basis functions N_{0,p}, N_{1,p}, ..., each one polynomial per span of its support.

        A piece unpacks as (start, end, polynomial).
        """
        return cox_de_boor.basis_functions(self.knots)

    def to_piecewise(self, i: int | None = None) -> Any:
        """Return basis function i as a Piecewise in t, or all of them as a tuple.

        Spans are half-open, the domain's last one and the last of all are closed.

        Examples
        --------
        >>> BSpline([0, 1, 2, 3], 1).to_piecewise(0)
        Piecewise((t, (0 <= t) & (t < 1)), (2 - t, (1 <= t) & (t <= 2)), (0, True))
        """
        if i is None:
            return tuple(cox_de_boor.piecewise(self.knots, pieces) for pieces in self.functions)
        index = cox_de_boor.function_index(self.knots, i)
        return cox_de_boor.piecewise(self.knots, self.functions[index])

    def triangle(self, span: int) -> cox_de_boor.Triangle:
        """Return the triangle of Cox and de Boor on a span, with the weights of its recursion."""
        return cox_de_boor.triangle(self.knots, span)

    def curve(self, points: Any) -> tuple[conversion.Segment, ...]:
        """Return the exact curve: (start, end, coordinates) for every non-empty span."""
        return conversion.segments(self.knots, points)

    def de_boor(self, points: Any, t: Any, span: int | None = None) -> evaluation.Levels:
        """Return all points of de Boor's algorithm; see `de_boor` in this room."""
        return evaluation.de_boor(self.knots, points, t, span)

    def labels(self, span: int, t: Any = evaluation.PARAMETER) -> evaluation.Labels:
        """Return the blossom arguments of every point of de Boor's triangle."""
        return evaluation.labels(self.knots, span, t)

    def point_names(self, span: int) -> tuple[tuple[sp.Symbol, ...], ...]:
        """Return symbols d_i^r that name the points of de Boor's triangle."""
        return evaluation.point_names(self.knots, span)

    def blossom(self, points: Any, span: int) -> Blossom:
        """Return the blossom of the curve's polynomial on a span; call it with p arguments.

        Consecutive knots u_{i+1}, ..., u_{i+p} around the span give back the control point i.

        Examples
        --------
        >>> spline = BSpline([0, 0, 0, 1, 2, 2, 2], 2)
        >>> spline.blossom([[0], [1], [3], [4]], 2)(0, 1)
        (1,)
        """
        self.knots.interval(span)
        segment = conversion.segment(self.knots, int(span), read_points(self.knots, points))
        return blossom(segment.coordinates, PARAMETER, self.degree)

    def span_basis(self, span: int) -> Basis:
        """Return one span as a `Basis` over [0, 1] with G = (P_{j-p}, ..., P_j)."""
        return conversion.span_basis(self.knots, span)

    def span_matrix(self, span: int) -> sp.ImmutableMatrix:
        """Return the basis matrix of a span: local t in [0, 1], layout T M G, descending powers.

        Examples
        --------
        >>> BSpline(range(6), 2).span_matrix(2)
        Matrix([
        [1/2,  -1, 1/2],
        [ -1,   1,   0],
        [1/2, 1/2,   0]])
        """
        return self.span_basis(span).matrix

    def insert(
        self, points: Any, t: Any, times: int = 1, span: Any = None
    ) -> tuple[BSpline, tuple[Point, ...]]:
        """Insert a knot (Boehm); return the spline and the control points of the same curve."""
        return _spline(*insertion.insert(self.knots, points, t, times, span))

    def refine(self, points: Any, new_knots: Any) -> tuple[BSpline, tuple[Point, ...]]:
        """Insert many knots at once (Oslo); return the spline and the points of the same curve."""
        return _spline(*insertion.refine(self.knots, points, new_knots))

    def refinement_matrix(self, new_knots: Any) -> sp.ImmutableSparseMatrix:
        """Return the exact matrix that makes the refined control points from these."""
        return insertion.refinement_matrix(self.knots, new_knots)

    def to_bezier(self, points: Any) -> tuple[conversion.BezierSegment, ...]:
        """Return the Bezier segments (start, end, points) of all non-empty spans."""
        return conversion.to_bezier(self.knots, points)

    def derivative(self, points: Any, order: int = 1) -> tuple[BSpline, tuple[Point, ...]]:
        """Return the derivative as a spline of lower degree with its control points."""
        return _spline(*calculus.derivative(self.knots, points, order))

    def antiderivative(self, points: Any) -> tuple[BSpline, tuple[Point, ...]]:
        """Return the integral from the domain's start, a spline of degree p + 1."""
        return _spline(*calculus.antiderivative(self.knots, points))

    def integral(self, points: Any, start: Any = None, end: Any = None) -> Point:
        """Return the exact integral of the curve over [start, end], by default the domain."""
        return calculus.definite_integral(self.knots, points, start, end)

    def jumps(self, t: Any) -> sp.ImmutableSparseMatrix:
        """Return how the derivatives of orders 0, ..., p jump at a knot; see `jumps`."""
        return multiplicity.jumps(self.knots, t)

    def bezier_matrix(self) -> sp.ImmutableSparseMatrix:
        """Return B with v = B p, the Bezier points of all spans."""
        return discretization.bezier_matrix(self.knots)

    def discretization_matrix(self, m: int) -> sp.ImmutableSparseMatrix:
        """Return A with q = A p, m + 1 samples on every span."""
        return discretization.discretization_matrix(self.knots, m)

    def bernstein_matrix(self, m: int) -> sp.ImmutableSparseMatrix:
        """Return A with q = A v, the same samples from the Bezier points of all spans."""
        return discretization.bernstein_matrix(self.knots, m)

    @cached_property
    def derivation(self) -> Derivation:
        """The recursion on the middle span, the partition of unity there, and every joint.

        >>> BSpline([0, 0, 0, 1, 2, 2, 2], 2).derivation.is_proved
        True
        """
        span = self.knots.spans[len(self.knots.spans) // 2]
        levels = self.triangle(span).levels
        steps = cox_de_boor.triangle_steps(levels)
        if self.degree:
            last = [entry.polynomial for entry in levels[-1]]
            whole = plus(*last)
            steps.append(Step(whole, sp.S.One, "the functions on the span sum to one"))
        for j in self.knots.spans[1:]:
            steps.extend(multiplicity.continuity_derivation(self.knots, self.knots.knots[j]).steps)
        return Derivation(f"B-splines of degree {self.degree} over {self._knots_in_words()}",
                          tuple(steps),
                          "de Boor, A Practical Guide to Splines, chapter IX")  # fmt: skip

    def insertion_derivation(self, t: Any, span: Any = None) -> Derivation:
        """Return Boehm's insertion of t, point by point."""
        return insertion.insertion_derivation(self.knots, t, span)

    def de_boor_derivation(self, span: int) -> Derivation:
        """Return de Boor's algorithm on a span, with the blossom value of every point."""
        return evaluation.de_boor_derivation(self.knots, span)

    def derivative_derivation(self, span: int) -> Derivation:
        """Return the rule for the derivatives of the basis functions on a span."""
        return calculus.derivative_derivation(self.knots, span)

    def continuity_derivation(self, t: Any) -> Derivation:
        """Return what the multiplicity of a knot leaves of continuity."""
        return multiplicity.continuity_derivation(self.knots, t)

    def discretization_derivation(self, m: int) -> Derivation:
        """Return q = A v = A B p with m + 1 samples on every span."""
        return discretization.discretization_derivation(self.knots, m)

    def _knots_in_words(self) -> str:
        return ", ".join(map(str, self.knots.knots))

    def __reduce__(self) -> tuple[type, tuple[Any, ...]]:
        return type(self), (self.knots,)

    def __repr__(self) -> str:
        return f"<BSpline of degree {self.degree} over {self._knots_in_words()}>"

    def _repr_latex_(self) -> str:
        terms = rf"\sum_{{i=0}}^{{{self.point_count - 1}}} \mathbf P_i N_{{i,{self.degree}}}(t)"
        knots = sp.latex(sp.Tuple(*self.knots.knots))
        return rf"$\displaystyle \mathbf c(t) = {terms}, \quad \mathbf u = {knots}$"


def _spline(knots: KnotVector, points: tuple[Point, ...]) -> tuple[BSpline, tuple[Point, ...]]:
    return BSpline(knots), points

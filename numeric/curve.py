"""Piecewise polynomial and rational curves on float64 arrays."""

from __future__ import annotations

from functools import cached_property, partial
from typing import Any

import numpy as np
import sympy as sp

from symbolic import NURBS, Basis, RationalBezier
from symbolic.errors import BadType, BadValue, OutsideDomain, shown

from .bernstein.roots import roots
from .curves import derivatives, making, pieces
from .curves.evaluation import Table, coefficient_table, evaluate
from .curves.spans import Spans
from .flattening import flatten
from .intersections import curves, lines
from .measures import arc_length, boxes, curvature, inflections, length, nearest
from .points import real_array


class Curve:
    """A curve of one or several Bezier segments of one degree, polynomial or rational.

    Make one with a method `from_...`; call it to evaluate. At a break between two segments that
    do not meet, the later one counts.

    Attributes
    ----------
    rows : array, shape (segments, degree + 1, columns)
        Bernstein coefficients of every segment: control points, or for a rational curve their
        homogeneous rows (w x, w y, ..., w).
    breaks : array, shape (segments + 1,)
        Increasing parameters; segment i lives on [breaks[i], breaks[i + 1]].
    rational : bool

    Examples
    --------
    >>> curve = Curve.from_bezier([[0, 0], [1, 2], [2, 0]])
    >>> curve([0, 0.5, 1])
    array([[0., 0.],
           [1., 1.],
           [2., 0.]])
    """

    def __init__(self, rows: np.ndarray, breaks: np.ndarray, rational: bool = False) -> None:
        self.rows, self.breaks, self.rational = rows, breaks, rational
        for array in (rows, breaks):  # tables are made of them only once
            array.flags.writeable = False
        if rational:
            _refuse_poles(rows[..., -1], breaks)

    @classmethod
    def from_bezier(cls, points: Any, domain: Any = (0, 1), weights: Any = None) -> Curve:
        """Make a curve from the control points of one segment, or of several of one degree.

        Parameters
        ----------
        points : rows (n + 1, dim), or (segments, n + 1, dim)
        domain : (start, end), divided equally among the segments, or all segments + 1 breaks
        weights : numbers (n + 1) or (segments, n + 1), optional
            They make the curve rational. A point of weight 0 is taken as a vector.

        Raises
        ------
        BadValue, BadType
            For points as in `float_points`, breaks that do not increase, and weights whose
            weight function vanishes in the domain.

        Examples
        --------
        A quarter of a circle.

        >>> arc = Curve.from_bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2])
        >>> arc(0.5)
        array([0.6, 0.8])
        """
        segments = making.read_segments(points)
        breaks = making.read_breaks(domain, len(segments))
        if weights is None:
            return cls(segments, breaks)
        numbers = real_array(weights, "weights")
        if numbers.ndim == 1 and len(segments) == 1:
            numbers = numbers[None]
        return cls(making.with_weights(segments, numbers), breaks, True)

    @classmethod
    def from_basis(cls, basis: Basis, geometry: Any, domain: Any = (0, 1)) -> Curve:
        """Make a one-segment curve from a basis and its geometry vector, rows (len(G), dim).

        Examples
        --------
        >>> from symbolic import hermite
        >>> Curve.from_basis(hermite(), [[0, 0], [1, 0], [0, 3], [0, -3]])(0.5)
        array([0.5 , 0.75])
        """
        return cls.from_bezier(making.basis_points(basis, geometry), domain)

    @classmethod
    def from_bspline(
        cls, points: Any, knots: Any, degree: int | None = None, weights: Any = None
    ) -> Curve:
        """Make the B-spline curve of control points (n, dim) over n + degree + 1 knots.

        Parameters
        ----------
        points : rows (n, dim)
        knots : numbers that do not decrease, or a `symbolic.KnotVector` or `symbolic.BSpline`
        degree : int
            Not needed with a knot vector of `symbolic`.
        weights : n numbers, optional
            They make it a NURBS curve.

        Raises
        ------
        BadValue, BadType
            For another number of knots, knots that decrease, an empty domain, and weights as in
            `from_bezier`.

        Notes
        -----
        The domain is [knots[degree], knots[n]]; empty spans have no segment.

        Examples
        --------
        >>> curve = Curve.from_bspline([[0, 0], [1, 2], [3, 2], [4, 0]], [0, 0, 0, 1, 2, 2, 2], 2)
        >>> curve
        <Curve: 2 segments of degree 2 in 2D on [0, 2]>
        >>> curve(1)
        array([2., 2.])
        """
        rows, breaks = making.bspline_rows(points, knots, degree, weights)
        return cls(rows, breaks, weights is not None)

    @classmethod
    def from_nurbs(cls, curve: Any) -> Curve:
        """Make a curve of an exact `symbolic.NURBS` or `symbolic.RationalBezier`.

        >>> from symbolic import circle
        >>> Curve.from_nurbs(circle())
        <Curve: 4 rational segments of degree 2 in 2D on [0, 1]>
        """
        if isinstance(curve, NURBS):
            return cls.from_bspline(curve.points, curve.knots, weights=curve.weights)
        if isinstance(curve, RationalBezier):
            return cls.from_bezier(curve.points, weights=curve.weights)
        raise BadType(
            "a NURBS or RationalBezier of symbolic", shown(curve),
            "Numbers go to from_bspline or from_bezier, with weights.",
        )  # fmt: skip

    @classmethod
    def from_interpolation(cls, spline: Any) -> Curve:
        """Make a curve of an exact `symbolic.InterpolatingSpline`, over its knots.

        >>> from symbolic import interpolating_spline
        >>> spline = interpolating_spline([[0, 0], [1, 1], [2, 0]], [0, 1, 2])
        >>> Curve.from_interpolation(spline)(0.5)
        array([0.5   , 0.6875])
        """
        if not hasattr(spline, "bezier_points"):
            raise BadType(
                "what interpolating_spline returns", shown(spline),
                "Write Curve.from_interpolation(interpolating_spline(points, knots)).",
            )  # fmt: skip
        return cls.from_bezier(spline.bezier_points, spline.knots)

    @classmethod
    def from_expressions(cls, expressions: Any, t: Any = None, domain: Any = (0, 1)) -> Curve:
        """Make a curve from rational functions of t, one per coordinate, or from exact segments.

        The change to Bezier form on the domain is exact; only its result is rounded.

        Parameters
        ----------
        expressions : list of polynomials in t or quotients of them
            Or the segments (start, end, coordinates) that `symbolic.BSpline.curve` and
            `symbolic.NURBS.curve` return; these have a domain of their own.
        t : Symbol
            By default t.
        domain : (start, end)

        Raises
        ------
        BadValue
            If an expression is no rational function of t with real numbers as coefficients, has a
            pole in the domain, or segments do not follow each other.

        Examples
        --------
        >>> t = sp.Symbol("t")
        >>> Curve.from_expressions([t, t**2], t).points
        array([[[0. , 0. ],
                [0.5, 0. ],
                [1. , 1. ]]])
        """
        t = sp.Symbol("t") if t is None else t
        found = making.read_expressions(expressions, t, domain)
        rows, rational = making.common_rows([(rows[None], kind) for rows, kind, _ in found])
        ends = [end for _, _, end in found]
        breaks = [ends[0][0], *(end for _, end in ends)]
        return cls(rows, making.read_breaks(breaks, len(rows)), rational)

    @property
    def points(self) -> np.ndarray:
        """The control points (segments, degree + 1, dim); the vector where a weight is zero."""
        if not self.rational:
            return self.rows
        w = self.rows[..., -1:]
        return self.rows[..., :-1] / np.where(w == 0, 1, w)

    @property
    def weights(self) -> np.ndarray | None:
        """The weights (segments, degree + 1) of a rational curve, None of a polynomial one."""
        return self.rows[..., -1] if self.rational else None

    @property
    def homogeneous(self) -> np.ndarray:
        """The rows (w x, w y, ..., w), shape (segments, degree + 1, dim + 1)."""
        if self.rational:
            return self.rows
        return np.concatenate([self.rows, np.ones((*self.rows.shape[:2], 1))], axis=2)

    @property
    def degree(self) -> int:
        """The degree n of every segment."""
        return int(self.rows.shape[1]) - 1

    @property
    def dim(self) -> int:
        """The number of coordinates of a point."""
        return int(self.rows.shape[2]) - self.rational

    @property
    def domain(self) -> tuple[float, float]:
        """The first and the last parameter; both belong to the domain."""
        return float(self.breaks[0]), float(self.breaks[-1])

    @cached_property
    def spans(self) -> Spans:
        """Which segment a parameter belongs to."""
        return Spans.over(self.breaks)

    @cached_property
    def _table(self) -> Table:
        return coefficient_table(self.rows, self.breaks, self.rational)

    def __len__(self) -> int:
        """Return the number of segments."""
        return len(self.rows)

    def __call__(self, t: Any, extrapolate: bool = False) -> np.ndarray:
        """Return the points of the curve at parameters t.

        Parameters
        ----------
        t : number or array of any shape
            NaN gives a point of NaN, and so does infinity.
        extrapolate : bool
            Whether a t outside the domain belongs to the first or last segment's polynomial,
            or is an error.

        Returns
        -------
        array, shape t.shape + (dim,)
            One coordinate of all points is contiguous in memory.

        Raises
        ------
        OutsideDomain
            If some t is outside the domain, unless it may extrapolate.
        """
        t = real_array(t, "parameters")
        check = partial(self._inside, extrapolate=extrapolate)
        out = evaluate(self._table, self.rational, self.spans, t.ravel(), check)
        return out.T.reshape((*t.shape, len(out)))

    def _inside(self, t: np.ndarray, extrapolate: bool) -> np.ndarray:
        start, end = self.domain
        if t.min() >= start and t.max() <= end:
            return t
        finite = np.isfinite(t)
        outside = finite & ((t < start) | (t > end))
        if outside.any() and not extrapolate:
            raise OutsideDomain(
                f"parameters in [{start:g}, {end:g}]",
                f"{t[outside][0]}",
                "Both ends belong to it. Points and derivatives take extrapolate=True.",
            )
        return np.where(finite, t, np.nan)

    def with_rows(self, rows: np.ndarray, breaks: np.ndarray) -> Curve:
        """Return a curve of the same kind from rows of Bernstein coefficients."""
        return type(self)(rows, breaks, self.rational)

    # What can be done with a curve stands in the rooms below, as functions of a curve.
    split = pieces.split
    restrict = pieces.restrict
    join = staticmethod(pieces.join)
    reverse = pieces.reverse
    transform = pieces.transform
    reparametrize = pieces.reparametrize
    elevate = pieces.elevate
    derivative = derivatives.derivative
    derivatives = derivatives.derivatives
    flat_parameters = flatten.flat_parameters
    flatten = flatten.flatten
    bounding_box = boxes.bounding_box
    length = length.length
    parameter_at_length = arc_length.parameter_at_length
    parameters_by_arc_length = arc_length.parameters_by_arc_length
    curvature = curvature.curvature
    inflections = inflections.inflections
    nearest = nearest.nearest

    intersect = curves.intersect
    intersect_line = lines.intersect_line

    def __repr__(self) -> str:
        start, end = self.domain
        kind = "rational " if self.rational else ""
        plural = "s" if len(self) > 1 else ""
        return (
            f"<Curve: {len(self)} {kind}segment{plural} of degree {self.degree} in {self.dim}D "
            f"on [{start:g}, {end:g}]>"
        )


def _refuse_poles(weights: np.ndarray, breaks: np.ndarray) -> None:
    """Raise unless no segment's weight function has a zero; weights of one sign have none."""
    if not (weights != 0).any(axis=1).all():
        raise BadValue("weights that are not all zero", "a segment of zeros", "Weights 1 do.")
    mixed = np.flatnonzero((weights.min(axis=1) <= 0) & (weights.max(axis=1) >= 0))
    found = roots(weights[mixed])
    if len(found.u):
        i = mixed[found.row[0]]
        at = breaks[i] + found.u[0] * (breaks[i + 1] - breaks[i])
        raise BadValue(
            "a weight function without zeros in the domain",
            f"one that vanishes at t = {at:g}",
            "The curve has a point at infinity there: change the weights or the domain.",
        )

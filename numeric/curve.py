"""Piecewise polynomial curves on float64 arrays, evaluated for any number of parameters at once."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp

from symbolic import Basis, bezier
from symbolic.errors import BadType, BadValue, OutsideDomain, shown
from symbolic.exact import as_list, exact

from .points import float_points, real_array

# Largest error against exact values, relative to the largest control point, over random and
# alternating control points: degree 3 1e-15, 5 6e-15, 7 5e-14, 8 2e-13, 12 2e-11, 20 5e-8. The
# Bernstein form stays near 1e-15 at every degree, and costs a few times more.
# `python -m benchmarks.horner_degree` measures it.
HORNER_DEGREE = 7


class Curve:
    """A polynomial curve of one or several Bezier segments of one degree.

    Make one with `from_bezier`, `from_basis` or `from_expressions`; call it to evaluate.

    Attributes
    ----------
    points : array, shape (segments, degree + 1, dim)
        Bezier control points of every segment.
    breaks : array, shape (segments + 1,)
        Increasing parameters; segment i lives on [breaks[i], breaks[i + 1]].

    Examples
    --------
    >>> curve = Curve.from_bezier([[0, 0], [1, 2], [2, 0]])
    >>> curve([0, 0.5, 1])
    array([[0., 0.],
           [1., 1.],
           [2., 0.]])
    """

    def __init__(self, points: np.ndarray, breaks: np.ndarray) -> None:
        self.points = points
        self.breaks = breaks
        for array in (points, breaks):  # the table of powers is made of them only once
            array.flags.writeable = False

    @classmethod
    def from_bezier(cls, points: Any, domain: Any = (0, 1)) -> Curve:
        """Make a curve from the control points of one segment, or of several of one degree.

        Parameters
        ----------
        points : rows (n + 1, dim), or (segments, n + 1, dim)
        domain : (start, end), divided equally among the segments, or all segments + 1 breaks

        Raises
        ------
        BadValue, BadType
            For points as in `float_points`, or breaks that do not increase.
        """
        segments = _segments(points)
        return cls(segments, _breaks(domain, len(segments)))

    @classmethod
    def from_basis(cls, basis: Basis, geometry: Any, domain: Any = (0, 1)) -> Curve:
        """Make a one-segment curve from a basis and its geometry vector, rows (len(G), dim).

        Examples
        --------
        >>> from symbolic import hermite
        >>> Curve.from_basis(hermite(), [[0, 0], [1, 0], [0, 3], [0, -3]])(0.5)
        array([0.5 , 0.75])
        """
        rows = float_points(geometry)
        basis.require_rows(len(rows))
        if basis.matrix.free_symbols:
            raise BadValue(
                "a basis without parameters", f"{basis.name} in {basis.matrix.free_symbols}",
                "Substitute numbers for them in the constraints.",
            )  # fmt: skip
        conversion = basis.to(bezier(basis.degree))
        return cls.from_bezier(np.array(conversion.tolist(), dtype=float) @ rows, domain)

    @classmethod
    def from_expressions(cls, expressions: Any, t: sp.Symbol, domain: Any = (0, 1)) -> Curve:
        """Make a one-segment curve from one polynomial in t per coordinate.

        The change to Bezier form on the domain is exact; only its result is rounded.

        Raises
        ------
        BadValue
            If an expression is not a polynomial in t with real numbers as coefficients.

        Examples
        --------
        >>> t = sp.Symbol("t")
        >>> Curve.from_expressions([t, t**2], t).points
        array([[[0. , 0. ],
                [0.5, 0. ],
                [1. , 1. ]]])
        """
        name = t.name if isinstance(t, sp.Symbol) else t
        coordinates = as_list(expressions)
        if not coordinates or not isinstance(t, sp.Symbol):
            raise BadType(
                "a list of polynomials and their symbol", shown((expressions, name)),
                "Write Curve.from_expressions([t, t**2], t).",
            )  # fmt: skip
        breaks = _breaks(domain, 1)
        start, end = (sp.Rational(float(b)) for b in breaks)
        local = [_polynomial(e, t).compose(sp.Poly(start + (end - start) * t, t))
                 for e in coordinates]  # fmt: skip
        degree = max(1, *(p.degree() for p in local))
        powers = [[p.coeff_monomial(t**k) for p in local] for k in range(degree, -1, -1)]
        points = bezier(degree).matrix.inv() * sp.Matrix(powers)
        return cls.from_bezier(np.array(points.tolist(), dtype=float), breaks)

    @property
    def degree(self) -> int:
        """The degree n of every segment."""
        return int(self.points.shape[1]) - 1

    @property
    def domain(self) -> tuple[float, float]:
        """The first and the last parameter; both belong to the domain."""
        return float(self.breaks[0]), float(self.breaks[-1])

    def __call__(self, t: Any) -> np.ndarray:
        """Return the points of the curve at parameters t.

        Parameters
        ----------
        t : number or array of any shape, inside the domain

        Returns
        -------
        array, shape t.shape + (dim,)

        Raises
        ------
        OutsideDomain
            If some t is outside the domain, or not a number.

        Notes
        -----
        Horner's rule up to degree `HORNER_DEGREE`; above it the Bernstein form, whose error does
        not grow with the degree (Volk and Schumaker, CAGD 1986).
        """
        t = real_array(t, "parameters")
        self._refuse_outside(t)
        flat = t.ravel()
        segment, local = self._locate(flat)
        evaluate = _horner if self.degree <= HORNER_DEGREE else _bernstein
        table = self._powers if self.degree <= HORNER_DEGREE else self.points
        out = np.empty((table.shape[2], len(flat)))
        for d, row in enumerate(out):
            coefficients = table[:, :, d].T
            row[:] = evaluate(
                [c[0] if segment is None else c[segment] for c in coefficients], local
            )
        return out.T.reshape((*t.shape, len(out)))

    def derivative(self) -> Curve:
        """Return the derivative by the curve's parameter, a curve of degree n - 1 (hodograph).

        c'(t) has the control points n (P_{i+1} - P_i) / h on a segment of length h.

        Examples
        --------
        >>> Curve.from_bezier([[0, 0], [1, 2], [2, 0]], domain=(0, 2)).derivative()(0)
        array([1., 2.])
        """
        lengths = np.diff(self.breaks)[:, None, None]
        if self.degree == 0:
            return Curve(np.zeros_like(self.points), self.breaks)
        return Curve(self.degree * np.diff(self.points, axis=1) / lengths, self.breaks)

    @cached_property
    def _powers(self) -> np.ndarray:
        """Coefficients of 1, u, ..., u^n on every segment, u in [0, 1]."""
        if self.degree == 0:
            return self.points
        matrix = np.array(bezier(self.degree).matrix_as(powers="ascending").tolist(), dtype=float)
        return matrix @ self.points

    def _locate(self, t: np.ndarray) -> tuple[np.ndarray | None, np.ndarray]:
        if len(self.points) == 1:
            return None, (t - self.breaks[0]) / (self.breaks[1] - self.breaks[0])
        segment = np.searchsorted(self.breaks, t, side="right") - 1
        segment = np.minimum(segment, len(self.points) - 1)
        start = self.breaks[segment]
        return segment, (t - start) / (self.breaks[segment + 1] - start)

    def _refuse_outside(self, t: np.ndarray) -> None:
        start, end = self.domain
        inside = (t >= start) & (t <= end)
        if not inside.all():
            raise OutsideDomain(
                f"parameters in [{start:g}, {end:g}]",
                f"{t[~inside].flat[0]}",
                "Both ends belong to the domain; restrict t to it.",
            )

    def __repr__(self) -> str:
        segments, _, dim = self.points.shape
        start, end = self.domain
        plural = "s" if segments > 1 else ""
        return (
            f"<Curve: {segments} segment{plural} of degree {self.degree} in {dim}D "
            f"on [{start:g}, {end:g}]>"
        )


def _horner(coefficients: list[Any], u: np.ndarray) -> np.ndarray:
    result = np.broadcast_to(coefficients[-1], u.shape).copy()
    for coefficient in coefficients[-2::-1]:
        result *= u
        result += coefficient
    return result


def _bernstein(points: list[Any], u: np.ndarray) -> np.ndarray:
    """Sum C(n, i) u^i (1 - u)^(n - i) P_i in O(n), multiplying by 1 - u along the way."""
    n, v = len(points) - 1, 1 - u
    result, power, binomial = v * points[0], np.ones_like(u), 1.0
    for i in range(1, n):
        power *= u
        binomial *= (n - i + 1) / i
        result += binomial * power * points[i]
        result *= v
    return result + power * u * points[n]


def _segments(points: Any) -> np.ndarray:
    depth = np.ndim(points) if isinstance(points, np.ndarray) else _depth(points)
    if depth != 3:
        return float_points(points)[None]
    if not len(points):
        raise BadValue("at least one segment", "none", "Give control points.")
    segments = [float_points(segment) for segment in points]
    if len({segment.shape for segment in segments}) > 1:
        raise BadValue(
            "segments of one degree and dimension",
            " and ".join(sorted({str(segment.shape) for segment in segments})),
            "Elevate the degree of the shorter ones.",
        )
    return np.stack(segments)


def _depth(points: Any) -> int:
    depth = 0
    while isinstance(points, list | tuple | np.ndarray | sp.MatrixBase) and len(points):
        depth += 2 if isinstance(points, sp.MatrixBase) else 1
        points = 0 if isinstance(points, sp.MatrixBase) else points[0]
    return depth


def _breaks(domain: Any, segments: int) -> np.ndarray:
    ends = real_array(domain, "breaks")
    if ends.ndim != 1 or len(ends) < 2 or not np.isfinite(ends).all():
        raise BadValue("(start, end)", shown(domain), "Give two finite numbers.")
    breaks = np.linspace(ends[0], ends[1], segments + 1) if len(ends) == 2 else ends
    if len(breaks) != segments + 1 or not (np.diff(breaks) > 0).all():
        raise BadValue(
            f"(start, end) or {segments + 1} increasing breaks",
            shown(domain),
            "The domain runs from a smaller to a larger parameter.",
        )
    return breaks


def _polynomial(expression: Any, t: sp.Symbol) -> sp.Poly:
    expression = expression if isinstance(expression, sp.Expr) else exact(expression)
    same = {s: t for s in expression.free_symbols if s.name == t.name}  # matched by name
    polynomial = expression.xreplace(same).as_poly(t)
    if polynomial is None or not all(c.is_number and c.is_real for c in polynomial.coeffs()):
        raise BadValue(
            f"polynomials in {t} with numbers as coefficients",
            shown(expression),
            "Substitute values for the other symbols first.",
        )
    return polynomial

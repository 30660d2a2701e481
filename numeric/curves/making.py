"""Reading curves of every kind as rows of Bernstein coefficients, segment by segment.

What these functions return are rows (m, n + 1, dim), or homogeneous rows (w x, w y, ..., w) with
one column more, and m + 1 increasing breaks.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any
from warnings import catch_warnings, simplefilter

import numpy as np
import sympy as sp

from symbolic import Basis, BSpline, KnotVector, bezier, polynomial_to_bezier, rational_to_bezier
from symbolic.errors import BadType, BadValue, shown
from symbolic.exact import as_list, exact

from ..bernstein.form import elevate
from ..points import float_points, real_array

Rows = tuple[np.ndarray, np.ndarray]

USUAL_POWER = 100  # of two; squares of such weights, and points times them, are far from the limits


def read_segments(points: Any) -> np.ndarray:
    """Return the control points of one segment, or of several of one degree, (m, n + 1, dim)."""
    depth = np.ndim(points) if isinstance(points, np.ndarray) else _depth(points)
    if depth != 3:
        return float_points(points)[None]
    if not len(points):
        raise BadValue("at least one segment", "none", "Give control points.")
    if isinstance(points, np.ndarray) and points.dtype.kind in "iuf":
        return float_points(points.reshape(-1, points.shape[2])).reshape(points.shape)
    segments = [float_points(segment) for segment in points]
    if len({segment.shape for segment in segments}) > 1:
        raise BadValue(
            "segments of one degree and dimension",
            " and ".join(sorted({str(segment.shape) for segment in segments})),
            "Elevate the degree of the shorter ones, or join curves.",
        )
    return np.stack(segments)


def read_breaks(domain: Any, segments: int) -> np.ndarray:
    """Return segments + 1 increasing breaks, from both ends or all of them."""
    ends = real_array(domain, "breaks")
    if ends.ndim != 1 or len(ends) < 2 or not np.isfinite(ends).all():
        raise BadValue("(start, end)", shown(domain), "Give two finite numbers.")
    breaks = np.linspace(ends[0], ends[1], segments + 1) if len(ends) == 2 else ends.copy()
    if len(breaks) != segments + 1 or not (np.diff(breaks) > 0).all():
        raise BadValue(
            f"(start, end) or {segments + 1} increasing breaks",
            shown(domain),
            "The domain runs from a smaller to a larger parameter.",
        )
    with np.errstate(over="ignore"):
        if not np.isfinite(breaks[-1] - breaks[0]):
            raise BadValue("a domain of finite length", shown(domain), "Scale it down.")
    return breaks


def with_weights(points: np.ndarray, weights: Any) -> np.ndarray:
    """Return homogeneous rows of points (..., n + 1, dim) and their weights (..., n + 1).

    The row of a weight 0 is (v, 0): its point is taken as a vector v. A common factor of weights
    that are all very large or very small is dropped, as `factor_power` tells.
    """
    numbers = real_array(weights, "weights")
    if numbers.shape != points.shape[:-1]:
        raise BadValue(
            f"one weight for every control point, shape {points.shape[:-1]}",
            f"shape {numbers.shape}",
            "A weight of 1 leaves a point as it is.",
        )
    if not np.isfinite(numbers).all():
        raise BadValue("finite weights", f"{numbers[~np.isfinite(numbers)][0]}", "Mend it.")
    power = factor_power(numbers)
    scaled = np.ldexp(numbers, -power)[..., None]
    with np.errstate(over="ignore"):
        vectors = np.ldexp(points, -power[..., None])
        return finite_rows(
            np.concatenate([np.where(scaled == 0, vectors, scaled * points), scaled], axis=-1)
        )


def factor_power(weights: np.ndarray) -> np.ndarray:
    """Return k for every row of weights (..., n + 1), shape (..., 1): they may be divided by 2^k.

    That changes no point and rounds nothing. k is 0 for weights of usual size, and otherwise
    makes the largest at most 1: products with the others then neither overflow nor vanish.
    """
    power = np.frexp(np.abs(weights).max(axis=-1, keepdims=True))[1]
    return np.where(np.abs(power) > USUAL_POWER, power, 0)


def finite_rows(rows: np.ndarray) -> np.ndarray:
    """Return rows of coefficients, or raise if one of them is too large for a float."""
    if not np.isfinite(rows).all():
        raise BadValue(
            "coefficients that floats can hold", "some beyond 1.8e308",
            "Scale the points down, or the domain up.",
        )  # fmt: skip
    return rows


def basis_points(basis: Basis, geometry: Any) -> np.ndarray:
    """Return the Bezier points (n + 1, dim) of a basis and its geometry vector."""
    if not isinstance(basis, Basis):
        raise BadType("a Basis of symbolic", shown(basis), "Such as hermite().")
    rows = float_points(geometry)
    basis.require_rows(len(rows))
    if basis.matrix.free_symbols:
        raise BadValue(
            "a basis without parameters", f"{basis.name} in {basis.matrix.free_symbols}",
            "Substitute numbers for them in the constraints.",
        )  # fmt: skip
    with np.errstate(over="ignore", invalid="ignore"):
        return finite_rows(np.array(basis.to(bezier(basis.degree)).tolist(), dtype=float) @ rows)


def bspline_rows(points: Any, knots: Any, degree: Any, weights: Any = None) -> Rows:
    """Return the Bezier points of every non-empty span of a B-spline curve, and the breaks.

    Point i of a span [a, b] is the blossom b(a, ..., a, b, ..., b) with i times b, by de Boor's
    algorithm with these arguments, for all spans at once; `symbolic.BSpline.to_bezier` is exact.
    """
    rows = float_points(points)
    if weights is not None:
        rows = with_weights(rows, weights)
    u, p = read_knots(knots, degree, len(rows))
    spans = np.flatnonzero(np.diff(u[p : len(rows) + 1]) > 0) + p
    if not len(spans):
        raise BadValue(
            f"a domain from knot {p} to knot {len(rows)} that is not empty",
            f"both at {u[p]:g}",
            "Give increasing knots in between.",
        )
    start, end = u[spans], u[spans + 1]
    local = rows[spans[:, None] + np.arange(-p, 1)]
    bezier_points = np.empty_like(local)
    for i in range(p + 1):
        level = local
        for r, argument in enumerate([start] * (p - i) + [end] * i, 1):
            k = spans[:, None] + np.arange(-p + r, 1)
            left, right = u[k], u[k + p + 1 - r]
            alpha = ((argument[:, None] - left) / (right - left))[..., None]
            level = (1 - alpha) * level[:, :-1] + alpha * level[:, 1:]
        bezier_points[:, i] = level[:, 0]
    return bezier_points, np.append(start, end[-1])


def read_knots(knots: Any, degree: Any, count: int) -> tuple[np.ndarray, int]:
    """Return a knot vector of floats for `count` control points, and its degree."""
    if isinstance(knots, BSpline):
        knots = knots.knots
    if isinstance(knots, KnotVector):
        if degree is not None and degree != knots.degree:
            raise BadValue(f"degree {knots.degree}, that of the knots", shown(degree), "Omit it.")
        degree, knots = knots.degree, knots.knots
    if isinstance(degree, bool) or not isinstance(degree, int | np.integer) or degree < 0:
        raise BadValue("the degree, a whole number from 0 on", shown(degree), "Cubics have 3.")
    u = real_array(knots, "knots")
    if u.ndim != 1 or len(u) != count + degree + 1:
        raise BadValue(
            f"{count} control points + degree {degree} + 1 = {count + degree + 1} knots",
            f"shape {u.shape}",
            "Every control point has degree + 2 knots under its function.",
        )
    infinite = np.flatnonzero(~np.isfinite(u))
    if len(infinite):
        raise BadValue("finite knots", f"{u[infinite[0]]} as knot {infinite[0]}", "Mend it.")
    falls = np.flatnonzero(np.diff(u) < 0)
    if len(falls):
        raise BadValue(
            "knots that do not decrease", f"{u[falls[0]]:g} before {u[falls[0] + 1]:g}",
            "Sort them; a knot may be repeated.",
        )  # fmt: skip
    with np.errstate(over="ignore"):
        if not np.isfinite(u[-1] - u[0]):
            raise BadValue("knots over a finite length", f"{u[0]:g} to {u[-1]:g}", "Scale them.")
    return u, int(degree)


def read_expressions(
    expressions: Any, t: Any, domain: Any
) -> list[tuple[np.ndarray, bool, tuple[float, float]]]:
    """Return (rows, whether homogeneous, (start, end)) of every segment of exact expressions."""
    listed = as_list(expressions) or []
    if listed and all(isinstance(entry, tuple) and len(entry) == 3 for entry in listed):
        exact_ends = [(exact(start), exact(end)) for start, end, _ in listed]
        coordinates = [entry[2] for entry in listed]
        if any(a[1] != b[0] for a, b in pairwise(exact_ends)):
            raise BadValue(
                "segments that follow each other", shown(exact_ends), "Sort them; leave no gap."
            )
    else:
        exact_ends = [tuple(sp.Rational(float(b)) for b in read_breaks(domain, 1))]
        coordinates = [expressions]
    return [
        (*_expression_rows(axes, t, *ends), (float(ends[0]), float(ends[1])))
        for axes, ends in zip(coordinates, exact_ends, strict=True)
    ]


def _expression_rows(coordinates: Any, t: Any, start: Any, end: Any) -> tuple[np.ndarray, bool]:
    """Return the rows (n + 1, columns) of rational functions of t on [start, end].

    The change to Bezier form is exact; only its result is rounded. The second value tells
    whether the rows are homogeneous.
    """
    matrix = isinstance(coordinates, sp.MatrixBase)
    listed = list(coordinates) if matrix else as_list(coordinates)
    if not listed or not isinstance(t, sp.Symbol):
        raise BadType(
            "a list of polynomials and their symbol", shown((coordinates, t)),
            "Write Curve.from_expressions([t, t**2], t).",
        )  # fmt: skip
    expressions = [_in_symbol(e, t) for e in listed]
    if all(e.is_polynomial(t) for e in expressions):
        rows = polynomial_to_bezier(expressions, t, (start, end))
        return float_points(rows), False
    local = [e.xreplace({t: start + (end - start) * t}) for e in expressions]
    with catch_warnings():
        simplefilter("ignore")  # weights of both signs are no matter here
        curve = rational_to_bezier(local, t)
    return with_weights(float_points(curve.points), curve.weights), True


def common_rows(pieces: Sequence[tuple[np.ndarray, bool]]) -> tuple[np.ndarray, bool]:
    """Return the rows of several pieces, (m, n + 1, columns) each, at one degree and of one kind.

    Polynomial pieces get the weight 1 where any other is rational.
    """
    rational = any(kind for _, kind in pieces)
    degree = max(rows.shape[1] for rows, _ in pieces)
    raised = []
    for rows, kind in pieces:
        if rational and not kind:
            rows = np.concatenate([rows, np.ones((*rows.shape[:2], 1))], axis=2)
        raised.append(elevate(rows, degree - rows.shape[1]))
    if len({rows.shape[2] for rows in raised}) > 1:
        dims = " and ".join(str(rows.shape[2] - rational) for rows in raised)
        raise BadValue("pieces of one dimension", dims, "Add the coordinates that are missing.")
    return np.concatenate(raised), rational


def _in_symbol(expression: Any, t: sp.Symbol) -> sp.Expr:
    """Return an expression with t by name, and floats as the rationals they are."""
    if not isinstance(expression, sp.Expr):
        expression = sp.Rational(expression) if isinstance(expression, float) else exact(expression)
    same = {s: t for s in expression.free_symbols if s.name == t.name}
    floats = {f: sp.Rational(f) for f in expression.atoms(sp.Float)}
    expression = expression.xreplace(same | floats)
    if (
        not expression.is_rational_function(t)
        or expression.free_symbols - {t}
        or expression.has(sp.I, sp.zoo, sp.nan, sp.oo)
    ):
        raise BadValue(
            f"polynomials in {t} with numbers as coefficients, or quotients of them",
            shown(expression),
            "Substitute values for the other symbols first.",
        )
    return expression


def _depth(points: Any) -> int:
    depth = 0
    while isinstance(points, list | tuple | np.ndarray | sp.MatrixBase) and len(points):
        depth += 2 if isinstance(points, sp.MatrixBase) else 1
        points = 0 if isinstance(points, sp.MatrixBase) else points[0]
    return depth

"""From B-splines to Bezier segments, power form and basis matrices, span by span."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from ..bases.basis import Basis, Geometry
from ..exact import PARAMETER, Point
from ..proofs.derivation import Derivation, Step
from ..written import times
from .cox_de_boor import local_triangle, triangle_steps
from .knots import KnotVector
from .weights import Row, blossom_weights, combined, control_symbols, power_rows, read_points


class Segment(NamedTuple):
    """A curve on one span: its ends, and one polynomial in t per coordinate."""

    start: sp.Expr
    end: sp.Expr
    coordinates: tuple[sp.Expr, ...]


class BezierSegment(NamedTuple):
    """A curve on one span: its ends, and its Bezier control points over [start, end]."""

    start: sp.Expr
    end: sp.Expr
    points: tuple[Point, ...]


def segments(knots: KnotVector, points: Any) -> tuple[Segment, ...]:
    """Return the curve with these control points, one tuple of polynomials per span."""
    rows = read_points(knots, points)
    return tuple(segment(knots, j, rows) for j in knots.spans)


def segment(knots: KnotVector, span: int, rows: Sequence[Point]) -> Segment:
    """Return the curve on one span, for control points that have been read."""
    field, p = knots.field, knots.degree
    powers = power_rows(knots, span, p, field.zero, field.one)
    coefficients = combined(knots, powers, rows)
    polynomials = tuple(
        sp.Add(*(c[axis] * PARAMETER ** (p - k) for k, c in enumerate(coefficients)))
        for axis in range(len(rows[0]))
    )
    return Segment(*knots.interval(span), polynomials)


def bezier_rows(knots: KnotVector, span: int) -> list[Row]:
    """Return the rows that make the Bezier points of a span: f(u_j, ..., u_j, u_{j+1}, ...)."""
    a, b = knots.elements[span], knots.elements[span + 1]
    p = knots.degree
    return [
        (
            span - p,
            blossom_weights(
                knots.elements, span, [(a, True)] * (p - i) + [(b, True)] * i, knots.field
            ),
        )
        for i in range(p + 1)
    ]


def to_bezier(knots: KnotVector, points: Any) -> tuple[BezierSegment, ...]:
    """Return the Bezier segments of every non-empty span, for any knots, also not clamped ones."""
    rows = read_points(knots, points)
    return tuple(
        BezierSegment(*knots.interval(j), combined(knots, bezier_rows(knots, j), rows))
        for j in knots.spans
    )


def span_basis(knots: KnotVector, span: Any) -> Basis:
    """Return the segment on a span as a basis over [0, 1], with G = (P_{j-p}, ..., P_j).

    The global parameter is u_j + t (u_{j+1} - u_j).

    Notes
    -----
    Qin, *General matrix representations for B-splines*, 2000; here read off blossom values.
    """
    start, end = knots.interval(span)
    j, p, u = int(span), knots.degree, knots.elements
    rows = power_rows(knots, j, p, u[j], u[j + 1] - u[j])
    flat = [w for _, weights in rows for w in weights]
    matrix = DomainMatrix.from_list_flat(flat, (p + 1, p + 1), knots.field).to_dense()
    geometry = tuple(Geometry(P, "point") for P in control_symbols(knots)[j - p : j + 1])
    name = f"B-spline of degree {p} on [{start}, {end}]"
    return Basis(name, geometry, matrix, partial(_derivation, knots=knots, span=j))


def _derivation(basis: Basis, knots: KnotVector, span: int) -> Derivation:
    levels = local_triangle(knots, span).levels
    last = sp.ImmutableMatrix([[entry.polynomial for entry in levels[-1]]])
    size = basis.degree + 1
    constant = sp.ImmutableMatrix([0] * basis.degree + [1])
    return Derivation(
        f"{basis.name}: from Cox and de Boor to the matrix",
        (
            *triangle_steps(levels),
            Step(times(sp.ImmutableMatrix([basis.powers]), basis.matrix), last,
                 "the last level, collected by powers of t, is the basis matrix"),
            Step(times(basis.matrix, sp.ImmutableMatrix([1] * size)), constant,
                 "the functions sum to one: the curve moves along with its control points"),
        ),
        "Qin, General matrix representations for B-splines, 2000",
    )  # fmt: skip

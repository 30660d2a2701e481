"""Conics as rational Bezier curves of degree 2: the weights tell which conic it is."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import sympy as sp
from sympy.polys.densearith import dup_add, dup_mul_ground, dup_sqr, dup_sub

from ..bases.bezier import bernstein
from ..errors import BadValue, shown
from ..exact import PARAMETER, Point, exact_points
from ..exact_matrix import dense, solution, to_matrix
from ..fields import common_field
from ..polynomials import polynomials
from ..proofs.derivation import Derivation, Step
from ..signs import sign
from ..written import plus, times
from .homogeneous import decidable_field, quotient
from .rational_bezier import RationalBezier

_KINDS: dict[int | None, Literal["ellipse", "parabola", "hyperbola"]] = {
    -1: "ellipse", 0: "parabola", 1: "hyperbola",
}  # fmt: skip


_SOURCE = "Farin, Curves and Surfaces for CAGD, chapter 12; Lee 1987"


@dataclass(frozen=True)
class Conic:
    """Which conic a rational quadratic curve is a part of.

    Attributes
    ----------
    kind : "ellipse", "parabola", "hyperbola", "line" or "point"
    discriminant : Expr
        w_1^2 - w_0 w_2: negative for an ellipse, zero for a parabola, positive for a hyperbola.
    shape_factor : Expr
        w_1^2/(w_0 w_2), which no reparametrization changes.
    center : row of coordinates, or None
        None for parabolas, lines and points.
    is_circle : bool
    """

    kind: Literal["ellipse", "parabola", "hyperbola", "line", "point"]
    discriminant: sp.Expr
    shape_factor: sp.Expr
    center: Point | None
    is_circle: bool
    curve: RationalBezier

    @property
    def radius_squared(self) -> sp.Expr | None:
        """The squared radius of a circle; None for everything else."""
        return (
            _squared_distance(self.curve, self.center) if self.center and self.is_circle else None
        )

    @cached_property
    def derivation(self) -> Derivation:
        """Why it is this conic, step by step."""
        steps = _degenerate(self) if self.kind in ("line", "point") else _proper(self)
        name = "circle" if self.is_circle else self.kind
        return Derivation(f"Three points and their weights make a {name}", tuple(steps), _SOURCE)


def conic_type(points: Any, weights: Any) -> Conic:
    r"""Return which conic a rational quadratic Bezier curve lies on.

    Its points at infinity are the zeros of sum w_i B_i^2(t), whose discriminant is
    4 (w_1^2 - w_0 w_2); three points on a line give a line. Symbols in the points stand for points
    in general position.

    Parameters
    ----------
    points : three rows
    weights : three numbers
        A weight w_1 = 0 makes the middle row a vector.

    Raises
    ------
    BadValue
        For other than three points, and symbols in the weights that leave the sign of
        w_1^2 - w_0 w_2 open.

    Notes
    -----
    Farin, *Curves and Surfaces for CAGD*, chapter 12; Lee, *The rational Bezier representation for
    conics*, 1987.

    Examples
    --------
    >>> arc = conic_type([[1, 0], [1, 1], [0, 1]], [1, 1, 2])
    >>> arc.kind, arc.is_circle, arc.center
    ('ellipse', True, (0, 0))
    >>> conic_type([[0, 0], [1, 2], [3, 0]], [1, 1, 1]).kind
    'parabola'
    """
    curve = RationalBezier(points, weights)
    if curve.degree != 2:
        raise BadValue(
            "three control points", f"{curve.degree + 1}", "A conic has a curve of degree 2."
        )
    field, (w0, w1, w2, *_) = decidable_field([*curve.weights, *sum(curve.points, ())])
    discriminant, shape = map(field.to_sympy, (w1 * w1 - w0 * w2, w1 * w1 / (w0 * w2)))
    rank = dense(curve.homogeneous).rank()
    if rank < 3:
        kind: Any = "line" if rank == 2 else "point"
        return Conic(kind, discriminant, shape, None, False, curve)
    where = sign(discriminant)
    if where is None:
        raise BadValue(
            "weights that decide the sign of w1^2 - w0 w2",
            shown(discriminant),
            "Put numbers in place of the symbols.",
        )
    center = _center(curve) if where else None
    return Conic(_KINDS[where], discriminant, shape, center, _is_circle(curve, center), curve)


def conic_through(start: Any, corner: Any, end: Any, point: Any) -> RationalBezier:
    r"""Return the conic from start to end with the tangents to the corner, through a point.

    If the point is a start + b corner + c end with a + b + c = 1, the weights are
    (1, b/(2 sqrt(a c)), 1). A point on the median gives the shoulder point, at t = 1/2.

    Parameters
    ----------
    start, corner, end, point : coordinates in the plane

    Raises
    ------
    BadValue
        If the three points are on a line, or the fourth is not inside their triangle.

    Notes
    -----
    Farin, *Curves and Surfaces for CAGD*, chapter 12.

    Examples
    --------
    >>> conic_through([1, 0], [1, 1], [0, 1], [sp.Rational(3, 5), sp.Rational(4, 5)]).weights
    (1, sqrt(2)/2, 1)
    """
    rows = exact_points([start, corner, end, point])
    lifted = dense([(*row, 1) for row in rows]).transpose()
    found = solution(lifted[:, :3], lifted[:, 3:])
    shares = [] if found is None else to_matrix(found).flat()
    if [sign(share) for share in shares] != [1, 1, 1]:
        raise BadValue(
            "a triangle, and a point inside it",
            shown(rows),
            "A conic with these tangents runs inside the triangle of start, corner and end.",
        )
    a, b, c = shares
    middle = quotient(b, 2 * sp.sqrtdenest(sp.sqrt(sp.radsimp(a * c))))
    return RationalBezier(rows[:3], (1, middle, 1))


def _center(curve: RationalBezier) -> Point:
    """The pole of the line at infinity: (2 w_1 (w_1 p_1) - w_0 w_2 (p_0 + p_2)) / (2 D)."""
    rows = curve.homogeneous
    size = len(rows[0])
    field, elements = common_field([entry for row in rows for entry in row])
    (*h0, w0), (*h1, w1), (*h2, w2) = (elements[i : i + size] for i in (0, size, 2 * size))
    return tuple(
        field.to_sympy((2 * w1 * b - w2 * a - w0 * c) / (2 * (w1 * w1 - w0 * w2)))
        for a, b, c in zip(h0, h1, h2, strict=True)
    )


def _is_circle(curve: RationalBezier, center: Point | None) -> bool:
    if center is None:
        return False
    (*numerators, radius_squared), denominator = _radial(curve, center)
    parts = (*numerators, denominator, radius_squared)
    field, found = polynomials(parts, PARAMETER)
    *coordinates, w, r2 = found
    left: list[Any] = []
    for p in coordinates:
        left = dup_add(left, dup_sqr(p, field), field)
    right = dup_mul_ground(dup_sqr(w, field), r2[0], field) if r2 else []
    return not dup_sub(left, right, field)


def _radial(curve: RationalBezier, center: Point) -> tuple[tuple[sp.Expr, ...], sp.Expr]:
    """Return X - m_x W, Y - m_y W, ... and the squared radius; and W."""
    numerators, w = curve.fractions
    radial = (x - m * w for x, m in zip(numerators, center, strict=True))
    return (*radial, _squared_distance(curve, center)), w


def _squared_distance(curve: RationalBezier, center: Point) -> sp.Expr:
    size = len(center)
    field, elements = common_field([*curve.points[0], *center])
    pairs = zip(elements[:size], elements[size:], strict=True)
    return field.to_sympy(sum(((a - b) ** 2 for a, b in pairs), field.zero))


def _proper(conic: Conic) -> list[Step]:
    w0, w1, w2 = conic.curve.weights
    numerators, w = conic.curve.fractions
    shares = [weight * b for weight, b in zip((w0, w1, w2), bernstein(2), strict=True)]
    a, b, c = w0 - 2 * w1 + w2, 2 * w1 - 2 * w0, w0
    disc = plus(sp.Pow(b, 2, evaluate=False), times(-4, a, c))
    signs = {
        "ellipse": "negative: none of the conic's points is at infinity",
        "parabola": "zero: one of the conic's points is at infinity",
        "hyperbola": "positive: two of the conic's points are at infinity",
    }
    steps = [
        Step(sp.Add(*shares), w, "the denominator; where it is zero, the curve is at infinity"),
        Step(disc, 4 * conic.discriminant,
             f"its discriminant is {signs[conic.kind]}"),
    ]  # fmt: skip
    if w1 != 0:
        steps.append(
            Step(sp.Pow(shares[1], 2, evaluate=False),
                 times(4 * conic.shape_factor, shares[0], shares[2]),
                 "in barycentric coordinates of the control points: a quadratic equation")
        )  # fmt: skip
    if conic.is_circle and conic.center:
        (*radial, radius_squared), _ = _radial(conic.curve, conic.center)
        steps.append(
            Step(plus(*(p**2 for p in radial)), radius_squared * w**2,
                 f"times W^2: all points have one distance from the center {conic.center}")
        )  # fmt: skip
    return steps


def _degenerate(conic: Conic) -> list[Step]:
    rows = dense(conic.curve.homogeneous)
    combinations = to_matrix(rows.transpose().nullspace())
    homogeneous = sp.ImmutableMatrix(conic.curve.homogeneous)
    zero = sp.ImmutableMatrix.zeros(combinations.rows, homogeneous.cols)
    because = "the homogeneous control points are dependent: " + (
        "the curve stays on a line" if conic.kind == "line" else "all are one point"
    )
    return [Step(times(combinations, homogeneous), zero, because)]

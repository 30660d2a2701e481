"""Ends of uniform B-spline curves: multiple end points, phantom vertices, closed curves.

Repeated control points are no repeated knots: the curve keeps its degree and its C^(p-1) joints,
and only where its tangent vanishes can it show a corner.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from ..bases.constraints import Condition
from ..bases.degree import degree_from
from ..bases.uniform_bspline import uniform_bspline
from ..errors import BadValue, shown
from ..exact import PARAMETER, Point, control_points, whole_number
from ..proofs.derivation import Derivation, Step

_SOURCE = "Farin, Curves and Surfaces for CAGD"


def repeat_ends(points: Any, times: int = 3) -> tuple[Point, ...]:
    r"""Return control points with the first and the last one repeated.

    A uniform cubic with double ends starts at (5 P0 + P1)/6, tangent to the line P0 P1; with
    triple ends it starts at P0 along the straight segment P0 + (P1 - P0) t^3/6.

    Parameters
    ----------
    points : rows
    times : 1 (as given), 2 (double end points), 3 (triple), ...

    Examples
    --------
    >>> repeat_ends([[0], [1], [2]], 2)
    ((0,), (0,), (1,), (2,), (2,))
    """
    rows, count = control_points(points), whole_number(times)
    if count is None or count < 1:
        raise BadValue("a number of times 1, 2, 3, ...", shown(times), "2 makes end points double.")
    if len(rows) == 1:
        return rows * count
    return (rows[0],) * count + rows[1:-1] + (rows[-1],) * count


def phantom_ends(points: Any) -> tuple[Point, ...]:
    r"""Return control points with a phantom vertex 2 P0 - P1 before them, and one after them.

    The uniform cubic then interpolates its end points, where its second derivative vanishes.

    Raises
    ------
    BadValue
        For fewer than two points.

    Notes
    -----
    Bartels, Beatty, Barsky, *An Introduction to Splines*, 1987, on end conditions.

    Examples
    --------
    >>> phantom_ends([[0], [1], [3]])
    ((-1,), (0,), (1,), (3,), (5,))
    """
    rows = control_points(points)
    if len(rows) < 2:
        raise BadValue("at least two control points", f"{len(rows)}", "Add points.")
    before, after = _mirrored(rows[0], rows[1]), _mirrored(rows[-1], rows[-2])
    return (before, *rows, after)


def wrap_points(points: Any, degree: int = 3) -> tuple[Point, ...]:
    """Return control points of a closed uniform curve: the first `degree` follow the last.

    Raises
    ------
    BadValue
        For fewer points than degree, or no degree.

    Examples
    --------
    >>> wrap_points([[0, 0], [1, 0], [0, 1]], 2)
    ((0, 0), (1, 0), (0, 1), (0, 0), (1, 0))
    """
    rows, p = control_points(points), degree_from(degree, 0)
    if len(rows) < max(p, 1):
        raise BadValue(
            f"at least {p} control points for a closed curve of degree {p}",
            f"{len(rows)}",
            "Add points.",
        )
    return rows + rows[:p]


def multiple_vertex_derivation() -> Derivation:
    """Return what double and triple vertices do to the uniform cubic, at its ends and inside.

    Examples
    --------
    >>> multiple_vertex_derivation().is_proved
    True
    """
    t = PARAMETER
    p0, p1, p2 = sp.symbols("P0:3")
    double, triple = _uniform((p0, p0, p1, p2)), _uniform((p0, p0, p0, p1))
    before, after = _uniform((p0, p1, p1, p1)), _uniform((p1, p1, p1, p2))
    inside = [
        Step(_at(before, r, 1), _at(after, r, 0),
             f"order {r} agrees on both sides of a triple vertex: still C^2, unlike a triple knot")
        for r in range(3)
    ]  # fmt: skip
    return Derivation(
        "Multiple vertices of the uniform cubic B-spline",
        (
            Step(_at(double, 0, 0), (5 * p0 + p1) / 6, "a double end point: the start"),
            Step(_at(double, 1, 0), (p1 - p0) / 2, "the tangent there, along the first leg"),
            Step(triple, p0 + (p1 - p0) * t**3 / 6, "a triple end point: a straight segment"),
            *inside,
            Step(sp.Derivative(after, t), (p2 - p1) * t**2 / 2,
                 "the tangent vanishes at t = 0: a corner is possible"),
        ), _SOURCE,
    )  # fmt: skip


def phantom_derivation() -> Derivation:
    """Return that phantom vertices make the uniform cubic start at P0, as a natural spline does.

    Examples
    --------
    >>> phantom_derivation().is_proved
    True
    """
    p0, p1, p2 = sp.symbols("P0:3")
    free = sp.Symbol("V")
    start = _at(_uniform((free, p0, p1, p2)), 0, 0)
    first = 2 * p0 - p1
    curve = _uniform((first, p0, p1, p2))
    bend = _at(_uniform((free, p0, p1, p2)), 2, 0)
    return Derivation(
        "Phantom vertices of the uniform cubic B-spline",
        (
            Step(start, (free + 4 * p0 + p1) / 6, "the start of a curve with the first vertex V"),
            Step(sp.Subs((free + 4 * p0 + p1) / 6, free, first), p0,
                 "with the phantom vertex V = 2 P0 - P1 it starts at P0"),
            Step(_at(curve, 1, 0), p1 - p0, "the tangent is the first leg"),
            Step(bend, free - 2 * p0 + p1, "the second derivative there, with any V"),
            Step(sp.Subs(free + p1, free, first), 2 * p0, "with this V it is V + P1 - 2 P0 = 0"),
        ),
        "Bartels, Beatty, Barsky, An Introduction to Splines, 1987",
    )  # fmt: skip


def closed_derivation(count: int = 4, degree: int = 3) -> Derivation:
    """Return that wrapped control points close a uniform curve as smoothly as its other joints.

    Raises
    ------
    BadValue
        If count is not a whole number, or below the degree.

    Examples
    --------
    >>> closed_derivation(4, 2).is_proved
    True
    """
    degree = degree_from(degree, 1)  # constant pieces do not join
    number = whole_number(count)
    if number is None or number < degree:
        raise BadValue(
            f"a number of control points {degree}, {degree + 1}, ... for degree {degree}",
            shown(count),
            "A closed curve needs as many as its degree.",
        )
    points = sp.symbols(f"P0:{number}")
    wrapped = [row[0] for row in wrap_points([[point] for point in points], degree)]
    first, last = _uniform(wrapped[: degree + 1]), _uniform(wrapped[-degree - 1 :])
    return Derivation(
        f"A closed uniform B-spline curve of degree {degree} with {number} points",
        tuple(
            Step(
                _at(last, r, 1),
                _at(first, r, 0),
                f"order {r} at the end and at the start",
            )
            for r in range(degree)
        ),
        _SOURCE,
    )


def _mirrored(end: Point, inner: Point) -> Point:
    return tuple(2 * a - b for a, b in zip(end, inner, strict=True))


def _uniform(points: Sequence[sp.Expr]) -> sp.Expr:
    """Return one segment of the uniform B-spline in the local parameter t in [0, 1]."""
    functions = uniform_bspline(len(points) - 1).functions
    return sp.Add(*(f * point for f, point in zip(functions, points, strict=True)))


def _at(curve: sp.Expr, order: int, at: int) -> sp.Expr:
    return Condition(sp.Integer(at), order).of(curve, PARAMETER)

"""Derivatives and integrals of B-spline curves, as B-spline curves."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..bases.degree import degree_from
from ..errors import BadValue, shown
from ..exact import PARAMETER, Point, by_name, exact, whole_number
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .cox_de_boor import triangle
from .de_boor import de_boor
from .knots import KnotVector
from .weights import Row, blossom_weights, combined, field_of_numbers, read_points


def derivative(
    knots: KnotVector, points: Any, order: int = 1
) -> tuple[KnotVector, tuple[Point, ...]]:
    r"""Return knots and control points of the derivative, a spline of degree p - order.

    Its points are p (P_{i+1} - P_i) / (u_{i+p+1} - u_{i+1}) over the knots u_1, ..., u_{m-1}. At a
    knot of multiplicity p + 1 the curve may jump; there the function over an empty interval and one
    knot are left out, and the derivative is that of the two sides. Beyond the degree it is zero.

    Raises
    ------
    BadValue
        For a negative order, or another number of points.

    Notes
    -----
    de Boor, *A Practical Guide to Splines*, chapter X.

    Examples
    --------
    >>> knots, points = derivative(KnotVector([0, 0, 0, 1, 2, 2, 2], 2), [[0], [1], [3], [4]])
    >>> knots.knots, points
    ((0, 0, 1, 2, 2), ((2,), (2,), (2,)))
    """
    rows = read_points(knots, points)
    times = whole_number(order)
    if times is None or times < 0:
        raise BadValue("an order 0, 1, 2, ...", shown(order), "1 is the velocity.")
    for _ in range(times):
        if knots.degree == 0:
            return knots, tuple(tuple(sp.S.Zero for _ in row) for row in rows)
        knots, rows = _derived(knots, rows)
    return knots, rows


def _derived(knots: KnotVector, points: tuple[Point, ...]) -> tuple[KnotVector, tuple[Point, ...]]:
    p, u, field = knots.degree, knots.elements, knots.field
    kept = list(knots.knots[1:-1])
    weights: list[Row] = []
    for i in range(knots.point_count - 2, -1, -1):  # from the right, so that indices stay valid
        length = u[i + p + 1] - u[i + 1]
        if length:
            factor = field(p) / length
            weights.insert(0, (i, [-factor, factor]))
        else:
            del kept[i]
    return KnotVector(kept, p - 1), combined(knots, weights, points)


def antiderivative(knots: KnotVector, points: Any) -> tuple[KnotVector, tuple[Point, ...]]:
    r"""Return knots and control points of the integral from the domain's start, of degree p + 1.

    The knots get one more at both ends. Point i + 1 is point i plus P_i (u_{i+p+1} - u_i)/(p + 1);
    all are shifted so that the integral vanishes where the domain begins.

    Examples
    --------
    >>> knots, points = antiderivative(KnotVector([0, 0, 1, 1], 1), [[0], [2]])
    >>> knots.knots, points
    ((0, 0, 0, 1, 1, 1), ((0,), (0,), (1,)))
    """
    rows = read_points(knots, points)
    p, u, field = knots.degree, knots.elements, knots.field
    lengths = [(u[i + p + 1] - u[i]) / field(p + 1) for i in range(knots.point_count)]
    wider = KnotVector((knots.knots[0], *knots.knots, knots.knots[-1]), p + 1)
    start = wider.elements[p + 1]
    # The value at the start, in terms of the sums; which are in terms of the points.
    at_start = blossom_weights(wider.elements, wider.spans[0], [(start, True)] * (p + 1), field)
    first = wider.spans[0] - p - 1
    totals = [
        sum((w for q, w in enumerate(at_start, first) if q > i), field.zero)
        for i in range(knots.point_count)
    ]
    sums: list[Row] = [
        (0, [((field.one if i < q else field.zero) - totals[i]) * length
             for i, length in enumerate(lengths)])
        for q in range(wider.point_count)
    ]  # fmt: skip
    return wider, combined(knots, sums, rows)


def definite_integral(knots: KnotVector, points: Any, start: Any = None, end: Any = None) -> Point:
    """Return the integral of the curve over [start, end], by default over the whole domain.

    Raises
    ------
    OutsideDomain
        If an end lies outside the domain.

    Examples
    --------
    >>> definite_integral(KnotVector([0, 0, 1, 2, 2], 1), [[0], [1], [0]])
    (1,)
    """
    wider, rows = antiderivative(knots, points)
    ends = [
        knots.domain[k] if given is None else by_name(exact(given))
        for k, given in enumerate((start, end))
    ]
    below, above = (_value(wider, rows, at) for at in ends)
    return tuple(b - a for a, b in zip(below, above, strict=True))


def _value(knots: KnotVector, points: tuple[Point, ...], at: sp.Expr) -> Point:
    """Return a curve's point, as a combination of control points where the field holds `at`."""
    span, known = knots.span(at), field_of_numbers([*knots.knots, at])
    if known is None or known[0] != knots.field:
        return tuple(map(_normal, de_boor(knots, points, at)[-1][0]))
    weights = blossom_weights(knots.elements, span, [(known[1][-1], True)] * knots.degree, known[0])
    return combined(knots, [(span - knots.degree, weights)], points)[0]


def _normal(number: sp.Expr) -> sp.Expr:
    """Return a number in its normal form, if it has one; expressions with symbols stay as is."""
    known = None if number.is_Rational or number.free_symbols else field_of_numbers([number])
    return number if known is None else known[0].to_sympy(known[1][0])


def derivative_derivation(knots: KnotVector, span: Any) -> Derivation:
    """Return, on one span, that N_i,p' = p (N_i,p-1/(u_{i+p}-u_i) - N_i+1,p-1/(u_{i+p+1}-u_{i+1})).

    Collected by control points, this is the rule for the points of the derivative.

    Examples
    --------
    >>> derivative_derivation(KnotVector([0, 0, 0, 1, 2, 2, 2], 2), 2).is_proved
    True
    """
    p, u = degree_from(knots.degree, 1), knots.knots
    levels = triangle(knots, span).levels
    lower = {entry.index: entry.polynomial for entry in levels[p - 1]}
    steps = []
    for entry in levels[p]:
        i = entry.index
        terms = []
        if i in lower:
            terms.append(times(p / (u[i + p] - u[i]), lower[i]))
        if i + 1 in lower:
            terms.append(times(-p / (u[i + p + 1] - u[i + 1]), lower[i + 1]))
        right = plus(*terms) if len(terms) > 1 else terms[0]
        steps.append(
            Step(sp.Derivative(entry.polynomial, PARAMETER), right,
                 f"the derivative of {entry.name} from the functions of degree {p - 1}")
        )  # fmt: skip
    return Derivation(
        f"Derivatives of the basis functions of degree {p}",
        tuple(steps),
        "de Boor, A Practical Guide to Splines, chapter X",
    )

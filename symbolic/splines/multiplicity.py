"""What a knot's multiplicity leaves of continuity: which derivatives may jump there."""

from __future__ import annotations

from math import factorial
from typing import Any

import sympy as sp

from ..bases.constraints import Condition
from ..errors import BadValue
from ..exact import PARAMETER, by_name, exact
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .conversion import segment
from .knots import KnotVector
from .weights import Row, as_matrix, control_symbols, power_rows


def joint(knots: KnotVector, t: Any) -> tuple[int, int]:
    """Return the spans left and right of a knot inside the domain.

    Raises
    ------
    BadValue
        If t is no knot, or an end of the domain.
    """
    at = by_name(exact(t))
    inside = [(i, j) for i, j in zip(knots.spans, knots.spans[1:], strict=False)]
    found = [(i, j) for i, j in inside if knots.knots[j] == at]
    if not found:
        raise BadValue(
            f"a knot inside the domain: {', '.join(str(knots.knots[j]) for _, j in inside)}",
            str(at),
            "Elsewhere the spline is one polynomial.",
        )
    return found[0]


def jumps(knots: KnotVector, t: Any) -> sp.ImmutableSparseMatrix:
    """Return how the derivatives of orders 0, ..., p jump at a knot, as a matrix times the points.

    Row r is the right minus the left derivative of order r. The rows 0, ..., p - m are zero for a
    knot of multiplicity m, the next one is not.

    Examples
    --------
    >>> jumps(KnotVector([0, 0, 0, 1, 2, 2, 2], 2), 1)
    Matrix([
    [ 0, 0,  0, 0],
    [ 0, 0,  0, 0],
    [-2, 4, -4, 2]])
    """
    left, right = joint(knots, t)
    p, field, at = knots.degree, knots.field, knots.elements[right]
    sides = [power_rows(knots, j, p, at, field.one) for j in (left, right)]
    rows: list[Row] = []
    for r in range(p + 1):
        row = [field.zero] * knots.point_count
        for side, factor in zip(sides, (-factorial(r), factorial(r)), strict=True):
            first, weights = side[p - r]
            for i, w in enumerate(weights, first):
                row[i] += field(factor) * w
        rows.append((0, row))
    return as_matrix(field, rows, knots.point_count)


def continuity_derivation(knots: KnotVector, at: Any) -> Derivation:
    """Return that the curve is C^(p - m) at a knot of multiplicity m, for all control points.

    The last step shows the jump of the next derivative: zero only for special control points. A
    multiple knot lowers the continuity, never the degree.

    Examples
    --------
    >>> continuity_derivation(KnotVector([0, 0, 0, 1, 1, 2, 2, 2], 2), 1).title
    'The knot 1 of multiplicity 2 in degree 2: C^0'
    """
    left, right = joint(knots, at)
    t, p, at = PARAMETER, knots.degree, knots.knots[right]
    points = control_symbols(knots)
    rows = [(point,) for point in points]
    before, after = (segment(knots, j, rows).coordinates[0] for j in (left, right))
    order = int(knots.continuity(at))
    steps = [
        Step(Condition(at, r).of(after, t), Condition(at, r).of(before, t),
             f"the same {_ordinal(r)} right and left of {at}")
        for r in range(order + 1)
    ]  # fmt: skip
    difference = plus(after, times(-1, before))
    jump = jumps(knots, at)[order + 1, :]
    steps.append(
        Step(Condition(at, order + 1).of(difference, t),
             sp.Add(*(w * P for w, P in zip(jump, points, strict=True))),
             f"the {_ordinal(order + 1)} jumps by a combination of control points that is not "
             "zero in general")
    )  # fmt: skip
    m = knots.multiplicity(at)
    return Derivation(
        f"The knot {at} of multiplicity {m} in degree {p}: C^{order}",
        tuple(steps),
        "de Boor, A Practical Guide to Splines, chapter IX",
    )


def _ordinal(order: int) -> str:
    return "value" if order == 0 else f"derivative of order {order}"

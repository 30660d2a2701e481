"""The weights with which control points make a value of a B-spline's blossom: the room's core.

Everything else reads off them. All arguments t give the basis functions, knots give the rows of
knot insertion, the ends of a span give Bezier points, directions give derivatives and powers.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import count
from math import comb
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..errors import BadValue
from ..exact import Point, control_points
from ..fields import common_field
from .factored import Factored, as_polynomials
from .knots import KnotVector

Argument = tuple[Any, bool]
"""An element of the field, and whether it is a parameter (True) or a difference of two (False)."""

Row = tuple[int, Sequence[Any]]
"""The index of the first control point, and the weights from there on."""


def blossom_weights(
    knots: Sequence[Any], span: int, arguments: Sequence[Argument], field: Domain
) -> list[Any]:
    r"""Return the weights of the points span - p, ..., span in f(arguments), p = len(arguments).

    With x the r-th argument, N_i^{r-1} hands (u_{i+r} - x)/(u_{i+r} - u_i) of itself to its left
    neighbour and (x - u_i)/(u_{i+r} - u_i) to its own index: the recursion of Cox and de Boor with
    different arguments on its levels. On a non-empty span no denominator is zero. For a direction
    (Ramshaw's homogeneous blossom) the constant parts drop out.

    Outside the domain only the weights of points that exist are meaningful.

    >>> u = [sp.QQ(k) for k in range(4)]
    >>> print(*blossom_weights(u, 1, [(sp.QQ(3, 2), True)], sp.QQ))
    1/2 1/2
    """
    parameters = [x for x, _ in arguments]
    polynomials = as_polynomials([*knots, *parameters], field)
    one, zero = field.one, field.zero
    if polynomials is not None:
        ring = polynomials[0].ring
        one, zero = Factored(ring.one, Counter()), Factored(ring.zero, Counter())
        knots, parameters = polynomials[: len(knots)], polynomials[len(knots) :]
    row = [one]
    last = len(knots) - 1
    for r, (x, (_, is_parameter)) in enumerate(zip(parameters, arguments, strict=True), 1):
        new = [zero] * (r + 1)
        for k, weight in enumerate(row):
            i = span - r + 1 + k
            if i < 0 or i + r > last or not weight:
                continue
            share = weight / (knots[i + r] - knots[i])
            if is_parameter:
                new[k] += share * (knots[i + r] - x)
                new[k + 1] += share * (x - knots[i])
            else:
                new[k] += share * -x
                new[k + 1] += share * x
        row = new
    return row if polynomials is None else [weight.in_field(field) for weight in row]


def power_rows(
    knots: KnotVector, span: int, degree: int, origin: Any, unit: Any, fixed: Sequence[Any] = ()
) -> list[Row]:
    """Return the coefficients of s^n, ..., s, 1 in f(x, ..., x, fixed), x = origin + unit * s.

    There are `degree` times x, without fixed arguments the curve itself. The coefficient of s^k is
    C(n, k) f(origin, ..., origin, unit, ..., unit, fixed), with k times the direction.
    """
    field = knots.field
    last = [(x, True) for x in fixed]
    rows: list[Row] = []
    for k in range(degree, -1, -1):
        directions = [(unit, False)] * k
        if k:  # f is linear in a direction, so that it can take the factor
            directions[0] = (unit * field(comb(degree, k)), False)
        arguments = directions + [(origin, True)] * (degree - k) + last
        weights = blossom_weights(knots.elements, span, arguments, field)
        rows.append((span - len(arguments), weights))
    return rows


def combined(knots: KnotVector, rows: Sequence[Row], points: Sequence[Point]) -> tuple[Point, ...]:
    """Return one combination of the points for every row of weights.

    Numbers are combined in a field; points with symbols, or with numbers such as pi of which no
    field is known, stay unexpanded.
    """
    coordinates = [c for point in points for c in point]
    weights = [w for _, row in rows for w in row]
    known = None
    if not any(c.free_symbols for c in coordinates):
        known = field_of_numbers([*knots.knots, *coordinates])
    if known is None:
        return tuple(_symbolic(knots.field, row, points) for row in rows)
    field, elements = known
    if field != knots.field:
        weights = [field.from_sympy(knots.field.to_sympy(w)) for w in weights]
    dim, values = len(points[0]), elements[len(knots.knots) :]
    rest = iter(weights)
    results = []
    for first, row in rows:
        sums = [field.zero] * dim
        for i in range(first, first + len(row)):
            weight = next(rest)
            if weight:
                for axis in range(dim):
                    sums[axis] += weight * values[i * dim + axis]
        results.append(tuple(map(field.to_sympy, sums)))
    return tuple(results)


def field_of_numbers(expressions: Sequence[sp.Expr]) -> tuple[Domain, list[Any]] | None:
    """Return the common field of some expressions; None where none is known, as with pi."""
    try:
        return common_field(expressions)
    except BadValue:
        return None


def _symbolic(field: Domain, row: Row, points: Sequence[Point]) -> Point:
    first, weights = row
    terms = [(field.to_sympy(w), points[first + i]) for i, w in enumerate(weights) if w]
    return tuple(sp.Add(*(w * point[axis] for w, point in terms)) for axis in range(len(points[0])))


def read_points(knots: KnotVector, points: Any) -> tuple[Point, ...]:
    """Return control points as exact rows, one for every basis function.

    Raises
    ------
    BadValue
        For another number of points than the knots ask for, or points that contain t.
    """
    rows = control_points(points)
    if len(rows) != knots.point_count:
        raise BadValue(
            f"{knots.point_count} control points for {len(knots.knots)} knots of degree "
            f"{knots.degree}",
            f"{len(rows)}",
            "There are as many knots as control points, and degree + 1 more.",
        )
    return rows


def control_symbols(knots: KnotVector) -> tuple[sp.Symbol, ...]:
    """Return symbols P0, P1, ... for the control points, other than those among the knots."""
    used = {str(s) for knot in knots.knots for s in knot.free_symbols}
    letters = (letter * k for k in count(1) for letter in "PQD")
    letter = next(x for x in letters if not any(name.startswith(x) for name in used))
    return tuple(sp.symbols(f"{letter}0:{knots.point_count}"))


def as_matrix(field: Domain, rows: Sequence[Row], columns: int) -> sp.ImmutableSparseMatrix:
    """Return rows of weights as an exact sparse matrix with so many columns."""
    entries = {
        (r, i): field.to_sympy(w)
        for r, (first, weights) in enumerate(rows)
        for i, w in enumerate(weights, first)
        if w
    }
    return sp.ImmutableSparseMatrix(len(rows), columns, entries)

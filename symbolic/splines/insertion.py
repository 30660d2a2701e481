"""Knot insertion: the same curve with more knots and more control points (Boehm, Oslo)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from ..errors import BadType, shown
from ..exact import Point, as_list, whole_number
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .cox_de_boor import basis_functions
from .knots import KnotVector
from .weights import Row, as_matrix, blossom_weights, combined, control_symbols, read_points


def insert(
    knots: KnotVector, points: Any, t: Any, times: int = 1, span: Any = None
) -> tuple[KnotVector, tuple[Point, ...]]:
    r"""Insert a knot, and return the new knots and control points of the same curve.

    With u_k <= t < u_{k+1} the new points are (1 - a_i) P_{i-1} + a_i P_i, where a_i is 1 up to
    i = k - p, (t - u_i)/(u_{i+p} - u_i) up to k, and 0 from there on (Boehm 1980). A symbol t whose
    place is not known is taken to lie inside the span given.

    Raises
    ------
    OutsideDomain, BadValue
        For t outside the domain, a place that symbols leave open, or more than degree + 1 times.

    Examples
    --------
    >>> knots, points = insert(KnotVector([0, 0, 0, 2, 2, 2], 2), [[0, 0], [2, 4], [4, 0]], 1)
    >>> knots.knots, points
    ((0, 0, 0, 1, 2, 2, 2), ((0, 0), (1, 2), (3, 2), (4, 0)))
    """
    rows = read_points(knots, points)
    count = whole_number(times)
    knots.insert(t, times, span)  # refuses what cannot be inserted before anything is computed
    for _ in range(count or 0):
        refined = knots.insert(t, 1, span)
        rows = combined(refined, _boehm_rows(knots, refined, knots.place_of(t, span)), rows)
        knots, span = refined, None  # t is a knot now
    return knots, rows


def _boehm_rows(knots: KnotVector, refined: KnotVector, k: int) -> list[Row]:
    """Return the weights of Boehm's new points, with u_k <= t < u_{k+1}; refined has t at k + 1."""
    p, field = knots.degree, refined.field
    u, t = refined.elements[: k + 1] + refined.elements[k + 2 :], refined.elements[k + 1]
    rows: list[Row] = []
    for i in range(refined.point_count):
        if i <= k - p:
            rows.append((i, [field.one]))
        elif i > k or t == u[i]:  # t has been a knot already: the ratio is zero
            rows.append((i - 1, [field.one]))
        else:
            a = (t - u[i]) / (u[i + p] - u[i])
            rows.append((i - 1, [field.one - a, a]))
    return rows


def refined_knots(knots: KnotVector, new_knots: Any) -> KnotVector:
    """Return the knot vector with all the new knots inserted."""
    listed = as_list(new_knots)
    if listed is None:
        raise BadType("a list of new knots", shown(new_knots), "Write [Rational(1, 2)].")
    for t in listed:
        knots = knots.insert(t)
    return knots


def refinement_rows(knots: KnotVector, refined: KnotVector) -> list[Row]:
    r"""Return the weights of all new points at once: Q_i = f(v_{i+1}, ..., v_{i+p}).

    The v are the refined knots, and f is the blossom of the old curve on any of its spans inside
    [v_i, v_{i+p+1}]. These are the discrete B-splines of the Oslo algorithm.
    """
    element = dict(zip(refined.knots, refined.elements, strict=True))
    old = [element[u] for u in knots.knots]
    p, v = knots.degree, refined.elements
    rows: list[Row] = []
    for i in range(refined.point_count):
        inside = next(j for j in refined.all_spans if i <= j <= i + p)
        passed = set(refined.knots[: inside + 1])
        span = sum(1 for u in knots.knots if u in passed) - 1
        arguments = [(x, True) for x in v[i + 1 : i + p + 1]]
        weights = blossom_weights(old, span, arguments, refined.field)
        first, last = max(span - p, 0), min(span, knots.point_count - 1)
        rows.append((first, weights[first - span + p : last + 1 - span + p]))
    return rows


def refine(knots: KnotVector, points: Any, new_knots: Any) -> tuple[KnotVector, tuple[Point, ...]]:
    """Insert many knots at once, and return the new knots and control points of the same curve.

    Raises
    ------
    OutsideDomain, BadValue
        As in `insert`.

    Notes
    -----
    Cohen, Lyche, Riesenfeld, *Discrete B-splines and subdivision techniques*, 1980.

    Examples
    --------
    >>> knots, points = refine(KnotVector([0, 0, 2, 2], 1), [[0], [4]], [1, 1])
    >>> knots.knots, points
    ((0, 0, 1, 1, 2, 2), ((0,), (2,), (2,), (4,)))
    """
    rows, refined = read_points(knots, points), refined_knots(knots, new_knots)
    return refined, combined(refined, refinement_rows(knots, refined), rows)


def refinement_matrix(knots: KnotVector, new_knots: Any) -> sp.ImmutableSparseMatrix:
    """Return the matrix that makes the refined control points: at most p + 1 entries a row.

    Examples
    --------
    >>> refinement_matrix(KnotVector([0, 0, 0, 2, 2, 2], 2), [1])
    Matrix([
    [  1,   0,   0],
    [1/2, 1/2,   0],
    [  0, 1/2, 1/2],
    [  0,   0,   1]])
    """
    refined = refined_knots(knots, new_knots)
    return as_matrix(refined.field, refinement_rows(knots, refined), knots.point_count)


def insertion_derivation(knots: KnotVector, t: Any, span: Any = None) -> Derivation:
    """Return Boehm's insertion of t as steps: each new point, and that the curve stays the same.

    Examples
    --------
    >>> insertion_derivation(KnotVector([0, 0, 0, 2, 2, 2], 2), 1).is_proved
    True
    """
    refined, k = knots.insert(t, 1, span), knots.place_of(t, span)
    p, u, at = knots.degree, knots.knots, refined.knots[k + 1]
    points = control_symbols(knots)
    oslo = refinement_rows(knots, refined)
    steps = []
    for i in range(k - p + 1, min(k, knots.point_count - 1) + 1):
        blossom_value = _written(refined, oslo[i], points)
        arguments = ", ".join(map(str, refined.knots[i + 1 : i + p + 1]))
        ratio = (at - u[i]) / (u[i + p] - u[i])
        leg = times(ratio, points[i] - points[i - 1])
        steps.append(
            Step(plus(points[i - 1], leg), blossom_value,
                 f"the new point {i}: t = {at} divides [{u[i]}, {u[i + p]}]; it is the blossom "
                 f"value f({arguments})")
        )  # fmt: skip
    new_points = [_written(refined, row, points) for row in oslo]
    for j in refined.spans:
        if at in refined.interval(j):
            before, after = _on_span(knots, j if j <= k else j - 1), _on_span(refined, j)
            steps.append(
                Step(_product(after, new_points), _product(before, points),
                     f"the same curve on [{refined.knots[j]}, {refined.knots[j + 1]}]")
            )  # fmt: skip
    return Derivation(
        f"Insertion of the knot {at}",
        tuple(steps),
        "Boehm, Inserting new knots into B-spline curves, 1980",
    )


def _written(knots: KnotVector, row: Row, points: Sequence[sp.Symbol]) -> sp.Expr:
    return combined(knots, [row], [(point,) for point in points])[0][0]


def _on_span(knots: KnotVector, span: int) -> list[sp.Expr]:
    """Return all basis functions as polynomials on a span."""
    return [
        next((piece.polynomial for piece in pieces if piece.span == span), sp.S.Zero)
        for pieces in basis_functions(knots)
    ]


def _product(functions: Sequence[sp.Expr], points: Sequence[sp.Expr]) -> sp.MatMul:
    return times(sp.ImmutableMatrix([functions]), sp.ImmutableMatrix(points))

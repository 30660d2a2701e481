"""Rendering by matrices: samples q = A v = A B p of a B-spline curve, with exact sparse entries."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..bases.bezier import bernstein
from ..errors import BadValue, shown
from ..exact import PARAMETER, whole_number
from ..proofs.derivation import Derivation, Step
from ..written import times
from .conversion import bezier_rows
from .knots import KnotVector
from .weights import Row, as_matrix, blossom_weights


def bezier_matrix(knots: KnotVector) -> sp.ImmutableSparseMatrix:
    """Return B with v = B p: the Bezier points of all non-empty spans, p + 1 rows for each.

    For uniform cubic knots and n + 1 control points it has 4 (n - 2) rows and n + 1 columns.

    Examples
    --------
    >>> bezier_matrix(KnotVector(range(8), 3)) * 6
    Matrix([
    [1, 4, 1, 0],
    [0, 4, 2, 0],
    [0, 2, 4, 0],
    [0, 1, 4, 1]])
    """
    rows = [row for j in knots.spans for row in bezier_rows(knots, j)]
    return as_matrix(knots.field, rows, knots.point_count)


def discretization_matrix(knots: KnotVector, m: int) -> sp.ImmutableSparseMatrix:
    r"""Return the matrix of samples q = A p, A_ij = N_j(v_i), with m + 1 samples on every span.

    Neighbouring spans share one sample, the later span counts. With n + 1 control points, order
    k and simple knots A has m (n + 2 - k) + 1 rows; since only k functions live on a span, each
    row has at most k entries that are not zero.

    Raises
    ------
    BadValue
        If m is not a positive integer.

    Examples
    --------
    >>> discretization_matrix(KnotVector([0, 0, 1, 2, 2], 1), 2)
    Matrix([
    [  1,   0,   0],
    [1/2, 1/2,   0],
    [  0,   1,   0],
    [  0, 1/2, 1/2],
    [  0,   0,   1]])
    """
    count, field, p = _samples(m), knots.field, knots.degree
    rows: list[Row] = []
    for j in knots.spans:
        a, b = knots.elements[j], knots.elements[j + 1]
        for s in range(count + (j == knots.spans[-1])):
            at = a + (b - a) * field.from_sympy(sp.Rational(s, count))
            rows.append((j - p, blossom_weights(knots.elements, j, [(at, True)] * p, field)))
    return as_matrix(field, rows, knots.point_count)


def bernstein_matrix(knots: KnotVector, m: int) -> sp.ImmutableSparseMatrix:
    """Return A with q = A v: block diagonal, the Bernstein polynomials of degree p at i/m.

    Every span contributes m rows, the last one m + 1, as in `discretization_matrix`.
    """
    count, p = _samples(m), knots.degree
    table = [
        [f.subs(PARAMETER, sp.Rational(s, count)) for f in bernstein(p)] for s in range(count + 1)
    ]
    entries = {
        (block * count + s, block * (p + 1) + i): weight
        for block in range(len(knots.spans))
        for s in range(count + (block == len(knots.spans) - 1))
        for i, weight in enumerate(table[s])
        if weight
    }
    blocks = len(knots.spans)
    return sp.ImmutableSparseMatrix(count * blocks + 1, (p + 1) * blocks, entries)


def discretization_derivation(knots: KnotVector, m: int) -> Derivation:
    """Return that sampling the Bezier segments samples the B-spline: A B is the samples' matrix.

    Examples
    --------
    >>> discretization_derivation(KnotVector(range(9), 3), 2).is_proved
    True
    """
    samples, whole = bernstein_matrix(knots, m), discretization_matrix(knots, m)
    ones = sp.ImmutableMatrix([1] * whole.cols)
    return Derivation(
        f"Rendering with {m + 1} samples on each of {len(knots.spans)} spans",
        (
            Step(times(samples, bezier_matrix(knots)), whole,
                 "Bernstein samples times Bezier points: q = A v and v = B p, so q = A B p"),
            Step(times(whole, ones), sp.ImmutableMatrix([1] * whole.rows),
                 "each row sums to one: samples move along with the control points"),
        ), "Farin, Curves and Surfaces for CAGD",
    )  # fmt: skip


def _samples(m: Any) -> int:
    count = whole_number(m)
    if count is None or count < 1:
        raise BadValue("a number of steps 1, 2, ... per span", shown(m), "m gives m + 1 samples.")
    return count

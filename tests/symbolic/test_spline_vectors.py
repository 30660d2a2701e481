"""Exact vectors of the course on B-splines, by their ids; misprinted ones are refuted as printed.

The order k is degree + 1; there are n + 1 control points.
"""

import pytest
import sympy as sp
from sympy import Rational as R
from sympy import symbols

from symbolic import (
    BSpline,
    KnotVector,
    Refuted,
    bernstein,
    clamped_knots,
    multiple_vertex_derivation,
    prove,
    repeat_ends,
    uniform_bspline,
    uniform_knots,
)

t, u, n, k, m, i = symbols("t u n k m i")
p0, p1, p2, p3 = symbols("p0:4")
QUADRATIC = BSpline(range(7), 2)


def pieces_of(spline, index):
    return [[a, b, f.subs(t, u)] for a, b, f in spline.functions[index]]


def test_S10_a_uniform_cubic_has_n_minus_2_bezier_segments():
    for last in range(3, 9):
        spline = BSpline(uniform_knots(last + 1, 3))
        points = [[j] for j in range(last + 1)]
        assert len(spline.to_bezier(points)) == last - 2
        assert spline.bezier_matrix().shape == (4 * (last - 2), last + 1)
        assert spline.bezier_matrix().rows - 1 == 4 * (last - 3) + 3


def test_S11_a_double_end_point():
    x, dx = _start_of(repeat_ends([[p0], [p1], [p2]], 2))
    assert prove(x, (5 * p0 + p1) / 6) and prove(dx, (p1 - p0) / 2)


def test_S12_a_triple_end_point():
    spline = BSpline(uniform_knots(5, 3))
    segment = spline.curve([[p0], [p0], [p0], [p1], [p2]])[0].coordinates[0]
    assert prove(segment.subs(t, u + 3), p0 + (p1 - p0) * u**3 / 6)


def _start_of(rows):
    spline = BSpline(uniform_knots(len(rows), 3))
    segment = spline.curve(rows)[0].coordinates[0]
    return segment.subs(t, 3), sp.diff(segment, t).subs(t, 3)


DOUBLE = [0, 0, 1, R(3, 2), 3, 3, 5, 6, 8]


@pytest.mark.parametrize(("order", "knots"), [
    (1, []), (2, range(9)), (2, [0, 1, R(3, 2), 5]), (3, range(9)), (3, DOUBLE), (4, DOUBLE),
])  # fmt: skip
def test_S20_the_recursion_of_order_k(knots, order):
    """B_{i,k} = (u-u_i)/(u_{i+k-1}-u_i) B_{i,k-1} + (u_{i+k}-u)/(u_{i+k}-u_{i+1}) B_{i+1,k-1}."""
    if order == 1:
        assert [f[0].polynomial for f in BSpline([0, 1, 3, 4], 0).functions] == [1, 1, 1]
        return
    high, low = BSpline(knots, order - 1), BSpline(knots, order - 2)
    for index, pieces in enumerate(high.functions):
        for piece in pieces:
            expected = 0
            for j, weight in (
                (index, (t - knots[index], knots[index + order - 1] - knots[index])),
                (index + 1, (knots[index + order] - t, knots[index + order] - knots[index + 1])),
            ):
                below = [q.polynomial for q in low.functions[j] if q.span == piece.span]
                expected += weight[0] / weight[1] * below[0] if below else 0
            assert prove(expected, piece.polynomial)


def test_S20_agrees_with_sympy():
    theirs = sp.bspline_basis_set(3, [0, 1, R(3, 2), 3, 4, 6, 7, 8], t)
    mine = BSpline([0, 1, R(3, 2), 3, 4, 6, 7, 8], 3).to_piecewise()
    for a, b in zip(mine, theirs, strict=True):
        assert prove(a, b)
        wrong = prove(a, b + sp.Piecewise((1, sp.Eq(t, 3)), (0, True)))
        assert isinstance(wrong, Refuted) and list(wrong.witness.values()) == [3]


def test_S25_the_functions_sum_to_one_on_the_domain_and_only_there():
    spline = BSpline([0, 1, 2, 2, 3, 5, 6], 2)
    inside = sp.And(spline.knots.domain[0] <= t, t <= spline.knots.domain[1])
    total = sp.Piecewise((sum(spline.to_piecewise()), inside), (1, True))
    assert prove(total, 1)
    assert isinstance(prove(sum(spline.to_piecewise()), 1), Refuted)


LINEAR = [
    [[0, 1, u], [1, 2, 2 - u]],
    [[1, 2, u - 1], [2, 3, 3 - u]],
    [[2, 3, u - 2], [3, 4, 4 - u]],
]


@pytest.mark.parametrize("index", [0, 1, 2])
def test_S21_linear_functions_over_the_knots_0_to_4(index):
    assert prove(pieces_of(BSpline(range(5), 1), index), LINEAR[index])


def _quadratic(i):
    return [
        [i, i + 1, (u - i) ** 2 / 2],
        [i + 1, i + 2, (u - i) * (i + 2 - u) / 2 + (u - i - 1) * (i + 3 - u) / 2],
        [i + 2, i + 3, (i + 3 - u) ** 2 / 2],
    ]


@pytest.mark.parametrize(("vector", "index"), [("S22", 0), ("S23", 1), ("S24", 2), ("S24", 3)])
def test_S22_S23_S24_quadratic_functions_over_the_knots_0_to_6(vector, index):
    assert prove(pieces_of(QUADRATIC, index), _quadratic(index))


def test_S23_as_printed_lacks_a_piece():
    """The printed function is zero on [1, 2): it starts with a jump, and the sum is not one."""
    printed = _quadratic(1)[1:]
    assert len(printed) != len(pieces_of(QUADRATIC, 1))
    on_first_span = pieces_of(QUADRATIC, 1)[0][2]
    assert isinstance(prove(0, on_first_span), Refuted)


COUNTS = {
    "control_points": n + 1, "knots": n + k + 1, "knot_intervals": n + k, "degree": k - 1,
    "spans_in_domain": n - k + 2, "points_per_span": k, "spans_per_point_max": k,
    "knots_per_function": k + 1, "intervals_per_function": k, "continuity": k - 2,
    "knots_outside_each_side": k - 1,
}  # fmt: skip


@pytest.mark.parametrize("name", COUNTS)
def test_S25_S26_counts_over_simple_knots(name):
    for order in range(1, 6):
        for last in range(order - 1, order + 4):
            counts = uniform_knots(last + 1, order - 1).counts()
            assert counts[name] == COUNTS[name].subs({n: last, k: order})


def test_S25_the_domain():
    knots = uniform_knots(6, 3)  # n = 5, k = 4
    assert knots.domain == (knots.knots[3], knots.knots[6])
    spline = BSpline(knots)
    assert all(prove(sum(basis.functions), 1) for basis in map(spline.span_basis, knots.spans))
    assert len({j for pieces in spline.functions for j in [len(pieces)]}) == 1


def test_S26_as_printed_is_refuted():
    """Not the first k knots lie outside the domain: u_{k-1} is its end."""
    counts = uniform_knots(6, 3).counts()
    assert isinstance(prove(k, COUNTS["knots_outside_each_side"]), Refuted)
    assert counts["knots_outside_each_side"] != counts["order"]


def test_S27_the_support_of_a_function():
    spline = BSpline(range(10), 3)  # knots are their indices, k = 4
    for index, pieces in enumerate(spline.functions):
        assert (pieces[0].start, pieces[-1].end) == (index, index + 4)
    as_printed, right = (k, i + k), (i, i + k)
    assert isinstance(prove(as_printed, right), Refuted)


def test_S28_the_triangle_over_eight_knots():
    counts = KnotVector(range(8), 3).counts()
    assert [counts[f"functions_of_order_{r}"] for r in (1, 2, 3, 4)] == [7, 6, 5, 4]
    assert [len(BSpline(range(8), r - 1).functions) for r in (1, 2, 3, 4)] == [7, 6, 5, 4]
    assert [len(level) for level in BSpline(range(8), 3).triangle(3).levels] == [1, 2, 3, 4]


@pytest.mark.parametrize("order", [2, 3, 4, 5])
def test_S29_bezier_is_a_special_case(order):
    functions = BSpline([0] * order + [1] * order, order - 1).functions
    assert prove([pieces[0].polynomial for pieces in functions], bernstein(order - 1))
    assert clamped_knots(order, order - 1).knots == (0,) * order + (1,) * order


@pytest.mark.parametrize(("last", "order", "steps"), [(3, 4, 1), (5, 4, 3), (6, 3, 2), (4, 2, 5)])
def test_S30_S31_samples_and_entries_of_the_discretization(last, order, steps):
    spline = BSpline(uniform_knots(last + 1, order - 1))
    matrix = spline.discretization_matrix(steps)
    assert matrix.shape == (steps * (last + 2 - order) + 1, last + 1)
    assert max(sum(1 for w in matrix.row(r) if w) for r in range(matrix.rows)) <= order
    assert isinstance(prove(m * (n + 2 - k) + 1, 1), Refuted)  # as printed, "=1"


def test_S31_sparsity_is_no_matter_of_many_samples():
    """A row has at most k entries of n + 1, however few samples there are."""
    matrix = BSpline(uniform_knots(20, 3)).discretization_matrix(1)
    assert matrix.rows < matrix.cols
    assert max(sum(1 for w in matrix.row(r) if w) for r in range(matrix.rows)) <= 4


def test_S32_rendering_factors_through_the_bezier_points():
    spline = BSpline(uniform_knots(6, 3))  # n = 5
    B, A = spline.bezier_matrix(), spline.bernstein_matrix(3)
    block = sp.Matrix([[1, 4, 1, 0], [0, 4, 2, 0], [0, 2, 4, 0], [0, 1, 4, 1]]) / 6
    for j in range(3):
        assert B[4 * j : 4 * j + 4, j : j + 4] == block
    assert spline.discretization_matrix(3) == A * B
    assert isinstance(prove(A * B, A * B * 0), Refuted)
    assert spline.discretization_derivation(3).is_proved


def test_S34_multiple_and_collinear_vertices():
    def joint(*points):
        segment = uniform_bspline().curve([[x] for x in (*points, p3)])[0]
        return [sp.diff(segment, t, r).subs(t, 0) for r in range(3)]

    assert prove(joint(p1, p1, p2)[0], (5 * p1 + p2) / 6)
    assert prove(joint(p1, p1, p1)[0], p1)
    assert multiple_vertex_derivation().is_proved
    a, b, s = symbols("a b s")  # three points a, a + b, a + s b of a line
    value, tangent, second = joint(a, a + b, a + s * b)
    for vector in (value - a, tangent, second):
        assert prove(sp.diff(vector, b) * b, vector)  # a multiple of the line's direction

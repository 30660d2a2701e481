"""Joints of two segments: the course's vectors (ids K), laws of conditions and of verdicts."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Rational as R

from symbolic import (
    BadType,
    BadValue,
    NotExact,
    Refuted,
    Undecided,
    a_frame,
    bezier,
    connection_matrix,
    continuity_at,
    elevate_degree,
    geometric_continuity,
    joint_properties,
    parametric_continuity,
    prove,
    subdivide,
)

t, r, a = sp.symbols("t r a")
P = P0, P1, P2, P3 = sp.symbols("P0:4")
Q = Q0, Q1, Q2, Q3 = sp.symbols("Q0:4")
B1, B2, B3 = sp.symbols("b1:4")

few = settings(max_examples=10, deadline=None)
numbers = st.fractions(min_value=-4, max_value=4, max_denominator=5)
positives = st.fractions(min_value=Fraction(1, 4), max_value=3, max_denominator=4)
vectors = st.tuples(numbers, numbers)


def vanishing(joint):
    return [right - left for left, right in joint.conditions]


def filled(expressions, rows):
    """Control points given as expressions in P0, P1, ..., for rows of numbers."""
    symbols = sp.symbols(f"P0:{len(rows)}")
    columns = [dict(zip(symbols, column, strict=True)) for column in sp.Matrix(rows).T.tolist()]
    return [[e.subs(values) for values in columns] for e in expressions]


# ---- vectors ------------------------------------------------------------------------------------

VECTORS = {
    "K01 C0": (vanishing(parametric_continuity(3, 1))[0], P3 - Q0),
    "K01 C1": (vanishing(parametric_continuity(3, 1))[1], (P3 - P2) - (Q1 - Q0)),
    "K02 G1, the next segment's alpha": (
        vanishing(geometric_continuity(3, 1, [1 / a]))[1] * a, (P3 - P2) - a*(Q1 - Q0)),
    "K03 C2": (vanishing(parametric_continuity(3, 2))[2], (P3 - 2*P2 + P1) - (Q2 - 2*Q1 + Q0)),
    "K04 d-": (a_frame([[p] for p in P], [[q] for q in Q])[0], [2*P2 - P1]),
    "K04 d+": (a_frame([[p] for p in P], [[q] for q in Q])[1], [2*Q1 - Q2]),
    "K13 unequal intervals": (
        vanishing(parametric_continuity(3, 1, r))[1] / r, (P3 - P2) - (Q1 - Q0) / r),
}  # fmt: skip


@pytest.mark.parametrize("name", VECTORS)
def test_vector_is_proved(name):
    ours, printed = VECTORS[name]
    assert prove(ours, printed)


def test_k01_as_printed_the_legs_are_sums():
    """Lost minus signs; and identical legs need equal intervals."""
    assert isinstance(prove(parametric_continuity(3, 1).points[1], P3 + P3 + P2), Refuted)
    assert isinstance(prove(parametric_continuity(3, 1, 2).points[1], P3 + (P3 - P2)), Refuted)


@pytest.mark.parametrize("degree", range(2, 6))
def test_k04_a_c1_joint_is_c2_exactly_if_the_a_frame_closes(degree):
    joint = parametric_continuity(degree, 1, r)
    free = [*joint.points, *sp.symbols(f"Q2:{degree + 1}")]
    minus, plus = a_frame([[p] for p in joint.given], [[q] for q in free], r)
    second = vanishing(parametric_continuity(degree, 2, r))[2].subs(
        dict(zip(joint.next, joint.points, strict=False))
    )
    assert prove((plus[0] - minus[0]) * r, second)


@pytest.mark.parametrize("degree", range(1, 6))
def test_k05_derivatives_agree_up_to_the_order(degree):
    for k in range(degree + 1):
        joint = parametric_continuity(degree, k)
        rows = [[q] for q in [*joint.points, *joint.next[k + 1 :]]]
        (before,), (after,) = (
            bezier(degree).curve([[p] for p in joint.given]),
            bezier(degree).curve(rows),
        )
        for j in range(degree + 1):
            same = prove(sp.diff(before, t, j).subs(t, 1), sp.diff(after, t, j).subs(t, 0))
            assert bool(same) == (j <= k)


LEFT = [[0, 0], [1, 3], [3, 3], [4, 2]]  # ends along (1, -1)
K06 = {
    "in line and as long": ([5, 1], 1, 1),
    "in line and longer": ([7, -1], 0, 1),
    "in line on the wrong side": ([3, 3], 0, 0),
    "not in line": ([5, 2], 0, 0),
}


@pytest.mark.parametrize("name", K06)
def test_k02_k06_k07_in_line_is_g1_and_only_equal_legs_are_c1(name):
    point, parametric, geometric = K06[name]
    joint = continuity_at(LEFT, [[4, 2], point, [9, 1], [9, 5]])
    assert (joint.parametric, joint.geometric) == (parametric, geometric)
    before, after = joint.tangents
    assert bool(prove(before, after)) == (geometric == 1)  # K07: unit tangents
    assert joint.derivation.is_proved


def test_k02_a_negative_alpha_is_a_fold():
    with pytest.raises(BadValue, match="positive beta1"):
        geometric_continuity(3, 1, [-1])
    joint = continuity_at(LEFT, [[4, 2], [3, 3], [9, 1], [9, 5]])
    assert "opposite" in str(joint)


def test_k08_a_cusp_is_c_infinity_but_not_g1():
    joint = continuity_at(((t - 1) ** 2, (t - 1) ** 3), (t**2, t**3))
    assert (joint.parametric, joint.geometric, joint.geometric_at_least) == (sp.oo, 0, 0)
    assert joint.tangents == ((-1, 0), (1, 0))
    assert "C^1 says nothing about the direction" in str(joint)
    assert joint.derivation.is_proved


def test_k09_order_zero_needs_no_direction():
    for point in ([4, 2], [5, 2]):
        joint = continuity_at(LEFT, [point, [0, 0]])
        assert (joint.parametric == -1) == (joint.geometric == -1) == (point == [5, 2])


def test_k11_a_quadratic_has_a_constant_second_derivative():
    curve = bezier(2).curve([[P0], [P1], [P2]])[0]
    assert prove(sp.diff(curve, t, 2), 2 * (P0 - 2 * P1 + P2))


@pytest.mark.parametrize("degree", range(1, 6))
def test_a_joint_of_the_order_of_the_degree_leaves_one_polynomial(degree):
    joint = parametric_continuity(degree, degree, r)
    verdict = continuity_at([[p] for p in joint.given], [[q] for q in joint.points], r)
    assert verdict.parametric == verdict.geometric == sp.oo
    assert joint.derivation.is_proved


@pytest.mark.parametrize("degree", range(2, 6))
def test_what_is_said_of_joints_is_proved(degree):
    for name, derivation in joint_properties(degree).items():
        assert derivation.is_proved, name


# ---- conditions ---------------------------------------------------------------------------------


@pytest.mark.parametrize("degree", range(1, 7))
def test_derivations_are_proved_and_ck_is_gk_with_betas_ratio_and_zeros(degree):
    for k in range(degree + 1):
        parametric = parametric_continuity(degree, k, r)
        geometric = geometric_continuity(degree, k, ([r] + [0] * k)[:k])
        assert parametric.points == geometric.points
        assert parametric.conditions == geometric.conditions
    assert geometric_continuity(degree, min(degree, 3), (B1, B2, B3)[:degree]).derivation.is_proved


@given(positives, st.lists(numbers, min_size=3, max_size=3))
@few
def test_connection_matrix_is_the_chain_rule(first, rest):
    """Against polynomials differentiated: entry (j, i) is derivative j of (phi - 1)^i / i!."""
    betas = [sp.Rational(b.numerator, b.denominator) for b in (first, *rest)]
    phi = sum(b * t**j / sp.factorial(j) for j, b in enumerate(betas, 1))
    matrix = connection_matrix(4, [first, *rest])
    for i in range(5):
        power = sp.Poly(phi**i / sp.factorial(i), t)
        assert list(matrix[:, i]) == [
            power.coeff_monomial(t**j) * sp.factorial(j) for j in range(5)
        ]


def test_connection_matrix_of_barsky_and_derose():
    b = sp.symbols("b1:5")
    assert connection_matrix(0, ()) == sp.eye(1)
    assert list(connection_matrix(4, b).row(4)) == [
        0, b[3], 4 * b[0] * b[2] + 3 * b[1] ** 2, 6 * b[0] ** 2 * b[1], b[0] ** 4,
    ]  # fmt: skip


# ---- verdicts -----------------------------------------------------------------------------------


@st.composite
def segments(draw, lowest=1, highest=5, dim=2):
    """Control points of a plane segment that ends with a direction."""
    coordinates = st.tuples(*[numbers] * dim)
    points = draw(st.lists(coordinates, min_size=lowest + 1, max_size=highest + 1))
    assume(points[-1] != points[-2])
    return points


def extended(points, joint, off):
    """The next segment with exactly the conditions of `joint`: the point after them is moved."""
    n, k = joint.degree, joint.order
    beyond = geometric_continuity(n, k + 1, (*joint.betas, 0 if k else 1))
    rows = filled(beyond.points, points)
    rows[-1] = [c + d for c, d in zip(rows[-1], off, strict=True)]
    return rows + [[i, i * i] for i in range(n - k - 1)]


@given(segments(), positives, st.lists(numbers, min_size=4, max_size=4), st.data())
@few
def test_the_geometric_order_is_the_one_built(points, first, rest, data):
    n = len(points) - 1
    k = data.draw(st.integers(0, n - 1))
    betas = [first, *rest][:k]
    along = [b - c for b, c in zip(points[-1], points[-2], strict=True)]
    right = extended(points, geometric_continuity(n, k, betas), (-along[1], along[0]))
    verdict = continuity_at(points, right)
    assert verdict.geometric == verdict.geometric_at_least == k
    assert list(verdict.betas) == [sp.Rational(b.numerator, b.denominator) for b in betas]
    assert verdict.parametric <= k
    assert verdict.derivation.is_proved


@given(segments(), positives, vectors, st.data())
@few
def test_the_parametric_order_is_the_one_built(points, ratio, off, data):
    assume(any(off))
    n = len(points) - 1
    k = data.draw(st.integers(0, n - 1))
    right = extended(points, parametric_continuity(n, k, ratio), off)
    off_by_ratio = k == 0 and ratio != 1  # the extension to order 1 was that of ratio 1
    assume(not off_by_ratio)
    verdict = continuity_at(points, right, ratio)
    assert verdict.parametric == k
    assert [any(row) for row in verdict.residuals[: k + 2]] == [False] * (k + 1) + [True]
    assert verdict.geometric_at_least >= k


@given(segments(highest=4), st.fractions(Fraction(1, 5), Fraction(4, 5), max_denominator=5))
@few
def test_the_parts_of_one_curve_are_one_curve(points, at):
    left, right = subdivide(points, at)
    ratio = (1 - at) / at
    assume(left[-1] != left[-2])
    for a_side, b_side in ((left, right), (elevate_degree(left), right),
                           (left, elevate_degree(right))):  # fmt: skip
        verdict = continuity_at(a_side, b_side, ratio)
        assert verdict.parametric == verdict.geometric == sp.oo
    assert continuity_at(left, right, ratio).derivation.is_proved
    assert continuity_at(left, right, ratio + 1).geometric == sp.oo  # whatever the intervals


@given(segments(), positives, numbers, positives)
@few
def test_affine_maps_and_reversed_travel_change_no_order(points, first, second, ratio):
    n = len(points) - 1
    k = min(n - 1, 2)
    along = [b - c for b, c in zip(points[-1], points[-2], strict=True)]
    joint = geometric_continuity(n, k, [first, second][:k])
    right = extended(points, joint, (-along[1], along[0]))
    verdict = continuity_at(points, right, ratio)
    moved = [[[2 * x - y + 1, x + 3 * y - 2] for x, y in side] for side in (points, right)]
    backwards = continuity_at(right[::-1], points[::-1], 1 / ratio)
    for other in (continuity_at(*moved, ratio), backwards):
        assert (other.parametric, other.geometric) == (verdict.parametric, verdict.geometric)


def ends(points, at):
    curve = sp.Matrix(bezier(len(points) - 1).curve(points))
    return [curve.diff(t, j).subs(t, at) for j in (1, 2, 3)]


def curvature(first, second):
    """The curvature vector of Frenet's formulas, without roots."""
    length = first.dot(first)
    return (second * length - first * first.dot(second)) / length**2


@given(segments(lowest=3, highest=3, dim=3), positives, st.tuples(numbers, numbers, numbers))
@few
def test_g2_is_equal_curvature_and_g3_equal_torsion_besides(points, first, rest):
    """An oracle that knows no betas."""
    beta2, beta3, off = rest
    right = filled(geometric_continuity(3, 3, [first, beta2, beta3]).points, points)
    p, q = ends(points, 1), ends(right, 0)
    assert curvature(*p[:2]) == curvature(*q[:2])
    cross = p[0].cross(p[1])
    if any(cross):
        other = q[0].cross(q[1])
        torsions = [cross.dot(p[2]) / cross.dot(cross), other.dot(q[2]) / other.dot(other)]
        assert torsions[0] == torsions[1]
    assert continuity_at(points, right).geometric_at_least >= 3
    right[2][0] += off
    assert (continuity_at(points, right).geometric_at_least >= 2) == (
        curvature(*p[:2]) == curvature(*ends(right, 0)[:2])
    )


def test_a_joint_on_one_curve_with_another_parameter_is_g_infinity():
    parabola = ((t - 1), (t - 1) ** 2)
    faster = t + t**2
    joint = continuity_at(parabola, (faster, faster**2))
    assert (joint.parametric, joint.geometric) == (1, sp.oo)
    assert joint.betas[:2] == (1, 2)
    arcs = ((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)), (
        -2 * t / (1 + t**2), (1 - t**2) / (1 + t**2)
    )  # fmt: skip
    circle = continuity_at(*arcs)
    assert (circle.parametric, circle.geometric) == (0, sp.oo)
    assert circle.derivation.is_proved
    almost = continuity_at(parabola, (t, t**2 + t**5))
    assert (almost.parametric, almost.geometric) == (4, 4)


def test_contact_of_a_circle_and_its_osculating_parabola():
    circle = ((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2))
    assert continuity_at(circle, (-t, 1 - t**2 / 2)).geometric == 3
    assert continuity_at(circle, (-t, 1 - t**2)).geometric == 1
    assert continuity_at(circle, (-t, sp.S.One)).geometric == 1


def test_roots_are_exact():
    s = sp.sqrt(2)
    left = [[0, 0], [1, s], [2, 2 * s]]
    joint = continuity_at(left, [[2, 2 * s], [2 + s, 2 * s + 2], [9, 1]])
    assert (joint.parametric, joint.geometric, joint.betas) == (0, 1, (s,))
    assert continuity_at(left, [[2, 2 * s], [2 + s, 2 * s + R(20001, 10000)]]).geometric == 0
    assert joint.derivation.is_proved


def test_symbols_give_the_orders_of_general_values():
    x, y = sp.symbols("x y")
    left = [[0, 0], [x, y]]
    assert continuity_at(left, [[x, y], [2 * x, 2 * y]]).parametric == sp.oo
    assert continuity_at(left, [[x, y], [x + r * x, y + r * y]], r).geometric == sp.oo
    unknown = continuity_at(left, [[x, y], [x + r * x, y + r * y]])
    assert isinstance(unknown.geometric, Undecided)
    assert "sign of r" in str(unknown)
    p = sp.Symbol("r", positive=True)
    assert continuity_at(left, [[x, y], [x + p * x, y + p * y]]).geometric == sp.oo
    assert continuity_at(left, [[x, y], [x - p * x, y - p * y]]).geometric == 0
    for first in ([x, y], [1, y]):
        assert "special ones" in str(continuity_at(left, [first, [1, 1]]))


def test_contact_with_symbols_is_followed_only_so_far():
    x = sp.Symbol("x")
    faster = t + t**3
    joint = continuity_at((t - 1, x * (t - 1) ** 2), (faster, x * faster**2))
    assert isinstance(joint.geometric, Undecided)
    assert joint.geometric_at_least == 8
    assert joint.derivation.is_proved


SINGULAR = {
    "a left end that stops": ([[0, 0], [1, 1], [1, 1]], [[1, 1], [2, 2]], 1),
    "a right start that stops": ([[0, 0], [1, 1]], [[1, 1], [1, 1], [2, 2]], 1),
    "both, of order 3": ([[0, 0], [1, 1], [1, 1], [1, 1]], [[1, 1]] * 3 + [[3, 3]], 1),
    "a point": ([[0, 0], [1, 1]], [[1, 1], [1, 1]], 0),
}


@pytest.mark.parametrize("name", SINGULAR)
def test_above_order_1_a_singular_joint_is_undecided(name):
    left, right, least = SINGULAR[name]
    joint = continuity_at(left, right)
    assert isinstance(joint.geometric, Undecided)
    assert joint.geometric_at_least == least
    assert joint.derivation.is_proved


def test_one_sided_tangents_where_a_segment_stops():
    left = [[0, 0], [1, 1], [1, 1]]
    assert continuity_at(left, [[1, 1], [0, 0]]).geometric == 0
    assert continuity_at(left, [[1, 1], [1, 1], [0, 0]]).geometric == 0
    assert continuity_at(left, [[1, 1], [1, 1], [2, 1]]).geometric == 0


def test_a_gap_in_words():
    joint = continuity_at([[0, 0], [1, 0]], [[2, 0], [3, 0]])
    assert str(joint) == "There is a gap of (1, 0): neither C^0 nor G^0."


# ---- bad input ----------------------------------------------------------------------------------

LINE = [[0, 0], [1, 1]]
BAD = {
    "a float": (lambda: continuity_at(LINE, [[1, 1], [0.5, 0]]), NotExact, r"Rational\(1, 2\)"),
    "a float ratio": (lambda: continuity_at(LINE, LINE, 0.5), NotExact, "Rational"),
    "dimensions": (lambda: continuity_at(LINE, [[1, 1, 1], [2, 2, 2]]), BadValue, "2 and 3"),
    "one point": (lambda: continuity_at(LINE, [[1, 1]]), BadValue, "single point"),
    "bare numbers": (lambda: continuity_at([0, 1], LINE), BadValue, "control points as rows"),
    "text": (lambda: continuity_at("ab", LINE), BadType, "as rows"),
    "t in points": (lambda: continuity_at([[0, 0], [t, 1]], LINE), BadValue, "parameter t"),
    "complex": (lambda: continuity_at([[0, 0], [sp.I, 1]], LINE), BadValue, "real"),
    "a complex root": (lambda: continuity_at([[sp.root(-1, 3)]] * 2, [[0]] * 2), BadValue, "real"),
    "a declared zero": (
        lambda: continuity_at([[0], [sp.Symbol("z", zero=True)]], [[0], [1]]), BadValue, "zero"),
    "a pole": (lambda: continuity_at((1 / (t - 1), t), LINE), BadValue, "defined at the joint"),
    "no polynomial": (lambda: continuity_at((sp.sin(t), t), LINE), BadValue, "polynomial in t"),
    "ratio 0": (lambda: continuity_at(LINE, LINE, 0), BadValue, "positive ratio"),
    "ratio < 0": (lambda: parametric_continuity(3, 1, -2), BadValue, "positive ratio"),
    "a negative symbol": (
        lambda: parametric_continuity(3, 1, sp.Symbol("r", negative=True)), BadValue, "positive"),
    "ratio t": (lambda: parametric_continuity(3, 1, t), BadValue, "another name"),
    "ratio P2": (lambda: parametric_continuity(3, 1, P2), BadValue, "P2"),
    "ratio i": (lambda: parametric_continuity(3, 1, sp.I), BadValue, "real"),
    "order above the degree": (lambda: parametric_continuity(2, 3), BadValue, "degree 2"),
    "order -1": (lambda: geometric_continuity(2, -1, ()), BadValue, "order"),
    "degree 0": (lambda: geometric_continuity(0, 0, ()), BadValue, "degree 1, 2, 3"),
    "properties of lines": (lambda: joint_properties(1), BadValue, "degree 2, 3, 4"),
    "degree 2.5": (lambda: parametric_continuity(2.5, 0), BadValue, "degree 1, 2, 3"),
    "too few betas": (lambda: geometric_continuity(3, 2, [1]), BadValue, "2 betas"),
    "no list of betas": (lambda: geometric_continuity(3, 1, 1), BadType, "list"),
    "beta1 = 0": (lambda: connection_matrix(2, [0, 1]), BadValue, "positive beta1"),
    "beta2 = i": (lambda: connection_matrix(2, [1, sp.I]), BadValue, "beta2 real"),
    "beta named Q1": (lambda: geometric_continuity(3, 1, [Q1]), BadValue, "Q1"),
    "degree mismatch": (lambda: a_frame(LEFT, LEFT[:3]), BadValue, "elevate_degree"),
    "a frame of lines": (lambda: a_frame(LINE, LINE), BadValue, "degree 2"),
    "a frame in two dimensions": (
        lambda: a_frame(LEFT, [[1, 2, 3]] * 4), BadValue, "one dimension"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_bad_input(name):
    call, error, said = BAD[name]
    with pytest.raises(error, match=said) as caught:
        call()
    assert str(caught.value).startswith("Expected ")


def test_integer_arrays_and_fractions_are_read():
    joint = continuity_at(np.array([[0, 0], [1, 1]]), [(1, 1), (Fraction(3, 2), Fraction(3, 2))])
    assert (joint.parametric, joint.geometric, joint.betas) == (0, sp.oo, (R(1, 2),))


@pytest.mark.parametrize("height", [sp.Integer(3), sp.sqrt(2), sp.Symbol("h")])
def test_joints_survive_pickling(height):
    joint = continuity_at([[0, 0], [1, height]], [[1, height], [2, 3]])
    conditions = geometric_continuity(3, 2, [2, height])
    assert str(conditions)
    for one in (joint, conditions):
        again = pickle.loads(pickle.dumps(one))
        assert str(again) == str(one) and again.derivation.is_proved


def test_opposite_tangents_are_seen_through_roots_and_symbols():
    a = 1 + sp.sqrt(2)
    for x, y in ((a, 1), (sp.Symbol("p"), sp.Symbol("q"))):
        back = continuity_at([[0, 0], [x, y]], [[x, y], [-2 * x, -2 * y]])
        assert "opposite" in str(back)
        on = continuity_at([[0, 0], [x, y]], [[x, y], [3 * x, 3 * y]])
        assert on.tangents[0] == on.tangents[1]


def test_a_derivation_says_why_contact_never_ends():
    faster = continuity_at([[0, 0], [1, 1]], [[1, 1], [3, 3]]).derivation
    assert faster.is_proved and "2 times as fast: G^oo" in faster.steps[-1].because
    t = sp.Symbol("t")
    same = continuity_at((t, t**2), (1 + t + t**2, (1 + t + t**2) ** 2))
    assert same.geometric == sp.oo and same.parametric < 2
    assert same.derivation.is_proved and "Bezout" in same.derivation.steps[-1].because

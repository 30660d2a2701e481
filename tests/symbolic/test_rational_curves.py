"""Rational Bezier curves, NURBS and arcs: laws over rational input, and the vectors."""

import pickle
import warnings

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy import interpolate
from sympy import Rational as R

from symbolic import (
    NURBS,
    BadType,
    BadValue,
    BSpline,
    HullWarning,
    NotExact,
    OutsideDomain,
    RationalBezier,
    Refuted,
    arc,
    arc_between,
    bernstein,
    bezier,
    circle,
    conic_type,
    implicitize,
    on_circle,
    prove,
    rational_properties,
    rational_to_bezier,
)

t, u, a = sp.symbols("t u a")
ROOT = sp.sqrt(2) / 2

numbers = st.fractions(min_value=-5, max_value=5, max_denominator=8)
positive = st.fractions(min_value=R(1, 4), max_value=5, max_denominator=8)
small = st.integers(-5, 5)
inside = st.fractions(min_value=0, max_value=1, max_denominator=16)


@st.composite
def curves(draw, sizes=(2, 5), dim=2):
    size = draw(st.integers(*sizes))
    points = draw(st.lists(st.tuples(*[numbers] * dim), min_size=size, max_size=size))
    return RationalBezier(points, draw(st.lists(positive, min_size=size, max_size=size)))


def quick(law):
    return settings(max_examples=25, deadline=None)(law)


def bernstein_quotient(curve):
    """The definition: sum w_i p_i B_i / sum w_i B_i."""
    functions, columns = bernstein(curve.degree), zip(*curve.points, strict=True)
    below = sum(w * b for w, b in zip(curve.weights, functions, strict=True))
    return [sum(w * x * b for w, x, b in zip(curve.weights, column, functions, strict=True)) / below
            for column in columns]  # fmt: skip


def at(expressions, place):
    place = sp.sympify(place) if not hasattr(place, "numerator") else sp.Rational(place)
    return tuple(sp.cancel(e.subs(t, place)) for e in expressions)


SYMBOLIC = RationalBezier(
    [sp.symbols("x0 y0"), sp.symbols("x1 y1"), sp.symbols("x2 y2")], sp.symbols("w0:3")
)


@quick
@given(curves())
def test_the_curve_is_the_quotient_of_bernstein_sums(curve):
    assert prove(curve.curve(), bernstein_quotient(curve))


@quick
@given(curves(), inside)
def test_de_casteljau_gives_the_point_and_subdivides(curve, place):
    levels = curve.de_casteljau(place)
    assert levels.points[-1][0] == at(curve.curve(), place)
    assume(0 < place < 1)
    left, right = curve.subdivide(place)
    assert left.points == tuple(level[0] for level in levels.points)
    assert right.weights == tuple(level[-1] for level in reversed(levels.weights))
    for part, local in ((left, t * place), (right, place + t * (1 - place))):
        assert prove(part.curve(), [c.subs(t, local) for c in curve.curve()])


def test_symbols_stay_unexpanded_and_right():
    point = SYMBOLIC.de_casteljau(u).points[-1][0]
    assert prove(point, [c.subs(t, u) for c in SYMBOLIC.curve()])
    left, _ = SYMBOLIC.subdivide(u)
    assert prove(left.curve()[0], SYMBOLIC.curve()[0].subs(t, u * t))


@quick
@given(curves(), positive)
def test_geometric_weights_trace_the_same_curve(curve, c):
    same, c = curve.reparametrized(c), sp.Rational(c)
    moved = c * t / (1 - t + c * t)
    assert prove(same.curve(), [x.subs(t, moved) for x in curve.curve()])


@quick
@given(curves((3, 4)), positive)
def test_geometric_weights_have_the_same_implicit_equation(curve, c):
    assume(len({*curve.points}) > 1)
    assert implicitize(curve.reparametrized(c)).polynomial == implicitize(curve).polynomial


@quick
@given(curves((2, 4)))
def test_the_standard_form_has_end_weights_one_and_the_same_curve(curve):
    standard = curve.standard_form()
    assert (standard.weights[0], standard.weights[-1]) == (1, 1)
    assert standard.points == curve.points
    n, w = curve.degree, curve.weights
    for i, weight in enumerate(standard.weights):  # c^i w_i/w_0 with c^n = w_0/w_n
        assert prove(weight**n, (w[0] / w[-1]) ** i * (w[i] / w[0]) ** n)
    assert all(weight.evalf() > 0 for weight in standard.weights)


@quick
@given(curves(dim=3), st.integers(1, 3))
def test_degree_elevation_keeps_the_curve(curve, by):
    assert curve.elevate_degree(by).degree == curve.degree + by
    assert prove(curve.elevate_degree(by).curve(), curve.curve())


@settings(max_examples=10, deadline=None)
@given(curves())
def test_end_derivatives_are_derivatives(curve):
    for place, velocity in zip((0, 1), curve.end_derivatives(), strict=True):
        assert at([sp.diff(x, t) for x in curve.curve()], R(place)) == velocity


def test_a_control_point_at_infinity_makes_half_a_circle():
    with pytest.warns(HullWarning, match="a weight is zero.*convex hull"):
        half = RationalBezier([[1, 0], [0, 1], [-1, 0]], [1, 0, 1])
    assert half.homogeneous == ((1, 0, 1), (0, 1, 0), (-1, 0, 1))
    assert half.de_casteljau(R(1, 2)).points[-1] == ((0, 1),)
    assert half.end_derivatives() == ((0, 2), (0, -2))
    assert on_circle(half).is_proved
    with pytest.warns(HullWarning):
        assert prove(half.reparametrized(2).curve(),
                     [x.subs(t, 2 * t / (1 + t)) for x in half.curve()])  # fmt: skip
    left, right = half.subdivide(R(1, 2))
    assert left.points == ((1, 0), (1, 1), (0, 1))
    assert right.weights == (R(1, 2), R(1, 2), 1)


def test_a_negative_weight_leaves_the_hull_and_warns():
    """The misconception "negative weights keep the hull": the complementary arc is outside."""
    with pytest.warns(HullWarning, match="different signs"):
        long_way = RationalBezier([[1, 0], [1, 1], [0, 1]], [1, -ROOT, 1])
    x, y = long_way.de_casteljau(R(1, 2)).points[-1][0]
    assert (x, y) == (-ROOT, -ROOT)  # the hull has only x >= 0 and y >= 0
    assert on_circle(long_way).is_proved
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        RationalBezier([[0], [1]], [-1, -2])  # the same as 1 and 2


def test_where_the_curve_is_at_infinity_a_vector_is_the_answer():
    with pytest.warns(HullWarning):
        hyperbola = RationalBezier([[0, 0], [1, 2], [3, 0]], [1, -1, 1])
    levels = hyperbola.de_casteljau(R(1, 2))
    assert levels.weights[-1] == (0,)
    with pytest.raises(BadValue, match="at infinity"):
        hyperbola.subdivide(R(1, 2))


@quick
@given(curves((2, 4)), st.lists(numbers, min_size=9, max_size=9))
def test_projective_maps_of_control_points_map_the_curve(curve, entries):
    """N08, by numbers; `rational_properties` has the generic matrix."""
    m = sp.Matrix(3, 3, [sp.Rational(e) for e in entries])
    rows = (sp.Matrix(curve.homogeneous) * m.T).tolist()
    assume(rows[0][2] and rows[-1][2] and m.det())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", HullWarning)
        mapped = RationalBezier.from_homogeneous(rows)
    x, y, w = m * sp.Matrix([*curve.curve(), 1])
    assert prove(mapped.curve(), [x / w, y / w])


@pytest.mark.parametrize("n", (1, 2, 3, 4))
def test_every_property_is_proved(n):
    for name, derivation in rational_properties(n).items():
        assert derivation.is_proved, (name, derivation)


# NURBS

KNOTS = [0, 0, 0, 1, 2, 2, 3, 3, 3]
POINTS = [[0, 0], [1, 3], [2, -1], [4, 2], [5, 0], [7, 1]]


@quick
@given(st.lists(positive, min_size=6, max_size=6), st.integers(0, 48))
def test_de_boor_insertion_and_bezier_pieces_agree_with_the_quotient(weights, place):
    place = R(place, 16)
    curve = NURBS(KNOTS, 2, POINTS, weights)
    span = curve.knots.spans.index(curve.knots.span(place))
    piece = curve.curve()[span]
    point = at(piece.coordinates, place)
    assert curve.de_boor(place).points[-1] == (point,)
    refined = curve.insert(place) if place not in (0, 3) else curve
    assert refined.de_boor(place).points[-1] == (point,)
    local = (place - piece.start) / (piece.end - piece.start)
    assert curve.to_bezier()[span].de_casteljau(local).points[-1] == (point,)


def test_a_nurbs_curve_is_a_projection():
    """N01: the homogeneous B-spline, divided by its last coordinate, is the quotient of sums."""
    curve = NURBS(KNOTS, 2, POINTS, [1, 2, R(1, 2), 3, 1, 1])
    assert curve.derivation.is_proved
    assert len(curve.derivation.steps) == 3
    spline = BSpline(KNOTS, 2).curve(curve.homogeneous)
    for piece, lifted in zip(curve.curve(), spline, strict=True):
        *numerators, w = lifted.coordinates
        assert prove(piece.coordinates, [x / w for x in numerators])


def test_scipy_gives_the_same_points():
    weights = [1, 2, R(1, 2), 3, 1, 1]
    curve = NURBS(KNOTS, 2, POINTS, weights)
    rows = np.array(curve.homogeneous, dtype=float)
    spline = interpolate.BSpline(np.array(KNOTS, dtype=float), rows, 2)
    for place in (R(0), R(1, 3), R(1), R(7, 4), R(2), R(5, 2), R(3)):
        *numerators, w = spline(float(place))
        (point,) = curve.de_boor(place).points[-1]
        assert np.allclose([float(c) for c in point], np.array(numerators) / w, atol=1e-12)


def test_equal_weights_give_the_b_spline():
    """N02, for a Bezier curve and for a B-spline."""
    assert prove(RationalBezier(POINTS, [a] * 6).curve(), bezier(5).curve(POINTS))
    curve = NURBS(KNOTS, 2, POINTS, [3] * 6)
    for piece, plain in zip(curve.curve(), BSpline(KNOTS, 2).curve(POINTS), strict=True):
        assert prove(piece.coordinates, plain.coordinates)


# Circles

CIRCLE = [(1 - u**2) / (1 + u**2), 2 * u / (1 + u**2)]


def test_the_rational_circle():
    """N03: x^2 + y^2 = 1 from (1, 0) to (0, 1); in an algebraic field for the standard weights."""
    x, y = CIRCLE
    assert prove(x**2 + y**2, 1)
    assert [c.subs(u, 0) for c in CIRCLE] == [1, 0]
    assert [c.subs(u, 1) for c in CIRCLE] == [0, 1]
    quarter = rational_to_bezier(CIRCLE, u)
    for same in (quarter, quarter.standard_form()):
        assert on_circle(same).is_proved
    assert quarter.standard_form() == arc_between([1, 0], [0, 1])
    assert quarter.standard_form().weights == (1, ROOT, 1)


def test_the_control_points_of_the_quarter_circle():
    """N04: Bernstein coefficients of 1 - u^2, 2u and 1 + u^2."""
    rows = [[1, 0, 1], [1, 1, 1], [0, 2, 2]]
    quarter = RationalBezier.from_homogeneous(rows)
    assert quarter.points == ((1, 0), (1, 1), (0, 1))
    assert quarter.weights == (1, 1, 2)
    assert quarter.homogeneous == tuple(map(tuple, rows))
    assert quarter == rational_to_bezier(CIRCLE, u)


@pytest.mark.parametrize("n", (1, 2, 3, 5))
def test_no_polynomial_curve_is_a_circular_arc(n):
    """N05: the leading coefficients satisfy a^2 + b^2 = 0."""
    derivation = rational_properties(n)["no polynomial circle"]
    assert derivation.is_proved
    leading = sp.Symbol(f"a{n}") ** 2 + sp.Symbol(f"b{n}") ** 2
    assert prove(derivation.steps[0].right, leading)


def test_which_conics_are_polynomial():
    """N06: circle, ellipse, hyperbola need weights; against the print, the parabola does not."""
    assert rational_properties(2)["polynomial conics"].is_proved
    parabola = [[0, 0], [R(1, 2), 0], [1, 1]]
    x, y = bezier(2).curve(parabola)
    assert prove(y, x**2)
    assert conic_type(parabola, [1, 1, 1]).kind == "parabola"
    assert implicitize([x, y]).polynomial == sp.Symbol("x") ** 2 - sp.Symbol("y")


@pytest.mark.parametrize("i", (0, 1, 2))
def test_a_weight_attracts_the_curve(i):
    """N07: dc/dw_1 = B_1/W (p_1 - c)."""
    weights, functions = SYMBOLIC.weights, bernstein(2)
    below = sum(w * b for w, b in zip(weights, functions, strict=True))
    for axis, c in enumerate(SYMBOLIC.curve()):
        right = functions[i] / below * (SYMBOLIC.points[i][axis] - c)
        assert prove(sp.diff(c, weights[i]), right)
    assert isinstance(prove(sp.diff(c, weights[i]), -right), Refuted)


def test_projective_invariance_with_a_generic_matrix():
    """N08."""
    assert rational_properties(2)["projective invariance"].is_proved


@pytest.mark.parametrize("cosine", [0, R(1, 2), R(-1, 2), R(3, 5), R(1, 3), ROOT, sp.sqrt(3) / 2,
                                    R(1, 30), (1 + sp.sqrt(5)) / 4, sp.sqrt(2) - 1,
                                    R(-99, 100)])  # fmt: skip
def test_arcs_of_every_cosine_lie_on_their_circle(cosine):
    curve = arc(cosine, (2, -1), 3)
    assert on_circle(curve, (2, -1), 3).is_proved
    assert curve.points[0] == (5, -1)
    assert prove((curve.points[-1][0] - 2) / 3, cosine)
    shape = curve.weights[1] ** 2 / (curve.weights[0] * curve.weights[2])
    assert prove(shape, (1 + cosine) * R(1, 2))


@settings(max_examples=6, deadline=None)
@given(small, numbers, small, small)
def test_arcs_between_rational_points(p, q, x, y):
    """The angles 2 arctan p and 2 arctan q have rational sines and cosines."""
    p, q = R(p), R(q)
    points = [[x + (1 - s * s) / (1 + s * s), y + 2 * s / (1 + s * s)] for s in (p, q)]
    assume(p != q and p * q != -1)
    curve = arc_between(*points, [x, y])
    assert on_circle(curve, [x, y]).is_proved
    assert all(weight > 0 for weight in curve.weights)


@pytest.mark.parametrize("segments", (3, 4, 6, 12))
def test_the_full_circle(segments):
    whole = circle((1, 2), R(3, 2), segments)
    assert len(whole.points) == 2 * segments + 1
    assert whole.points[0] == whole.points[-1] == (R(5, 2), 2)
    pieces = whole.to_bezier()
    assert len(pieces) == segments
    assert all(on_circle(piece, (1, 2), R(3, 2)).is_proved for piece in pieces)
    velocities = [piece.end_derivatives() for piece in pieces]
    for before, after in zip(velocities, velocities[1:] + velocities[:1], strict=True):
        assert prove(before[1], after[0])  # equal arcs meet with one velocity


def test_a_circle_of_any_radius():
    assert on_circle(circle(radius=a).to_bezier()[1], radius=a).is_proved


def test_a_curve_off_the_circle_is_refuted():
    wrong = RationalBezier([[1, 0], [1, 1], [0, 1]], [1, 1, 1])
    assert all(isinstance(verdict, Refuted) for verdict in on_circle(wrong).verify())


# Bad input

BAD = {
    "a float": ([[0, 0], [1, 1]], [1, 0.5], NotExact, r"Rational\(1, 2\)"),
    "too few weights": ([[0, 0], [1, 1]], [1], BadValue, "2 weights.*received 1"),
    "all zero": ([[0, 0], [1, 1]], [0, 0], BadValue, "only zeros"),
    "the first zero": ([[0, 0], [1, 1]], [0, 1], BadValue, "begins or ends at infinity"),
    "a hidden zero": ([[0], [1]], [sp.sqrt(2) * sp.sqrt(3) - sp.sqrt(6), 1], BadValue, "infinity"),
    "ragged": ([[0, 0], [1]], [1, 1], BadValue, "1 and 2 coordinates"),
    "one point": ([[0, 0]], [1], BadValue, "at least two"),
    "t in a point": ([[t, 0], [1, 1]], [1, 1], BadValue, "without the parameter t"),
    "t in a weight": ([[0], [1]], [1, sp.Symbol("t", positive=True)], BadValue, "parameter t"),
    "no list": ([[0, 0], [1, 1]], 1, BadType, "weights as a list"),
    "a function": ([[0, 0], [1, 1]], [1, sp.cos(a)], BadValue, "symbol in its place"),
    "a complex point": ([[sp.I, 0], [1, 1]], [1, 1], BadValue, "real coordinates"),
    "a complex weight": ([[0], [1]], [1, sp.root(-1, 3)], BadValue, "real weights"),
    "an imaginary symbol": (
        [[0], [1]], [1, sp.Symbol("w", imaginary=True)], BadValue, "declared not to be"),
    "a symbol for zero": ([[0], [1]], [1, sp.Symbol("w", zero=True)], BadValue, "Write 0"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
@pytest.mark.parametrize("make", [RationalBezier, lambda p, w: NURBS([0, 0, 1, 1], 1, p, w)])
def test_bad_points_and_weights(name, make):
    points, weights, error, said = BAD[name]
    if name == "one point":
        said = "at least two|2 control points"
    with pytest.raises(error, match=said) as caught:
        make(points, weights)
    assert str(caught.value).startswith("Expected ")


QUARTER = arc(0)
REFUSED = [
    (lambda: QUARTER.reparametrized(0), BadValue, "factor other than zero"),
    (lambda: QUARTER.de_casteljau(0.5), NotExact, "Rational"),
    (lambda: RationalBezier([[0], [1], [2]], [1, 1, a]).standard_form(), BadValue, "of one sign"),
    (lambda: RationalBezier([[0], [1], [2]], [1, 1, sp.sqrt(2) + sp.cbrt(3)]).standard_form(),
     BadValue, "exact root of order 2"),
    (lambda: arc((sp.sqrt(2) + sp.cbrt(3)) / 4), BadValue, "cosine whose sine"),
    (lambda: RationalBezier.from_homogeneous([[1], [2]]), BadValue, "and a weight"),
    (lambda: arc(1), BadValue, "between -1 and 1"),
    (lambda: arc(a), BadValue, "between -1 and 1"),
    (lambda: arc(0, radius=-1), BadValue, "positive radius"),
    (lambda: arc(0, center=(0, 0, 0)), BadValue, "two coordinates"),
    (lambda: arc_between([1, 0], [0, 2]), BadValue, "equally far.*1 and 4"),
    (lambda: arc_between([1, 0], [-1, 0]), BadValue, "nor opposite"),
    (lambda: arc_between([1, 0], [1, 0]), BadValue, "neither the same"),
    (lambda: circle(segments=5), BadValue, "3, 4, 6 or 12"),
    (lambda: circle(radius=0), BadValue, "positive radius"),
    (lambda: circle(radius=sp.I), BadValue, "real radius"),
    (lambda: QUARTER.reparametrized(sp.I), BadValue, "real factor"),
    (lambda: arc_between([1, sp.I], [sp.I, 1]), BadValue, "real coordinates"),
    (lambda: on_circle(circle()), BadType, "to_bezier"),
    (lambda: on_circle([[0, 0], [1, 1]]), BadType, "a RationalBezier"),
    (lambda: on_circle(QUARTER, [t, 0]), BadValue, "parameter t"),
    (lambda: on_circle(QUARTER, radius=t), BadValue, "parameter t"),
    (lambda: on_circle(RationalBezier([[0], [1]], [1, 1])), BadValue, "plane"),
    (lambda: rational_to_bezier([1 / t, t]), BadValue, "ends at infinity"),
    (lambda: rational_to_bezier([1, 2]), BadValue, "one point"),
    (lambda: rational_to_bezier([sp.sin(t), t]), BadValue, "symbol in its place"),
    (lambda: rational_to_bezier(t), BadType, "list of coordinates"),
    (lambda: rational_properties(0), BadValue, "degree 1, 2, 3"),
    (lambda: NURBS([0, 0, 1, 1], 1, [[0], [1]], [1, 1]).de_boor(2), OutsideDomain, "domain"),
    (lambda: NURBS([0, 1, 0, 1], 1, [[0], [1]], [1, 1]), BadValue, "decrease"),
]  # fmt: skip


@pytest.mark.parametrize("case", range(len(REFUSED)))
def test_what_is_refused(case):
    call, error, said = REFUSED[case]
    with pytest.raises(error, match=said) as caught:
        call()
    assert str(caught.value).startswith("Expected ")


@pytest.mark.parametrize("curve", [QUARTER, circle()], ids=["arc", "circle"])
def test_curves_survive_pickling(curve):
    assert pickle.loads(pickle.dumps(curve)) == curve

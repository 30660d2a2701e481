"""Laws of Bezier curves and blossoms, over random points and degrees."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational as R

from symbolic import (
    BadType,
    BadValue,
    NotExact,
    Proved,
    Refuted,
    Undecided,
    antiderivative,
    bezier,
    bezier_properties,
    blossom,
    check_blossom,
    de_casteljau,
    elevate_degree,
    hodograph,
    polar_levels,
    polynomial_to_bezier,
    prove,
    reduce_degree,
    restrict,
    subdivide,
)

t, a, b, c = sp.symbols("t a b c")
rationals = st.fractions(min_value=-5, max_value=5, max_denominator=16)
polygons = st.lists(st.tuples(rationals, rationals), min_size=1, max_size=7)


def rational(number):
    return R(number.numerator, number.denominator)


def point(points, at):
    return de_casteljau(points, at)[-1][0]


@given(polygons, rationals, rationals, rationals)
def test_a_restricted_curve_is_the_same_curve(points, start, end, at):
    r, s, u = map(rational, (start, end, at))
    assert point(restrict(points, start, end), at) == point(points, r + (s - r) * u)


@given(polygons, rationals, st.integers(0, 3))
def test_elevation_leaves_the_curve_and_reduction_takes_it_back(points, at, by):
    raised = elevate_degree(points, by)
    assert len(raised) == len(points) + by
    assert point(raised, at) == point(points, at)
    if len(raised) > 2 and by:
        reduction = reduce_degree(raised)
        assert reduction.points == elevate_degree(points, by - 1)
        assert reduction.squared_error == 0


@given(st.lists(st.tuples(rationals, rationals), min_size=3, max_size=6), st.data())
def test_no_other_curve_of_lower_degree_is_closer(points, data):
    best = reduce_degree(points)
    assert best.points[0] == point(points, 0) and best.points[-1] == point(points, 1)
    other = [list(p) for p in best.points]
    if len(other) > 2:
        i = data.draw(st.integers(1, len(other) - 2))
        other[i][0] += rational(data.draw(rationals))
    assert squared_distance(points, other) >= squared_distance(points, best.points)
    assert squared_distance(points, best.points) == best.squared_error


def squared_distance(points, lower):
    """Integrate the squared distance by polynomials, another way than the Gram matrix."""
    curves = zip(*(curve_of(rows) for rows in (points, lower)), strict=True)
    total = sum(sp.Poly((x - y) ** 2, t) for x, y in curves)
    return total.integrate(t).eval(1)


def curve_of(points):
    return bezier(len(points) - 1).curve(points)


@given(polygons, rationals)
def test_integrating_and_differentiating_are_inverse(points, at):
    assert hodograph(antiderivative(points)) == tuple(tuple(map(rational, row)) for row in points)
    start = point(points, 0)
    back = antiderivative(hodograph(points)) if len(points) > 1 else ((0, 0),)
    moved = point(back, at)
    assert tuple(x + y for x, y in zip(moved, start, strict=True)) == point(points, at)


@given(st.lists(rationals, min_size=1, max_size=6), st.integers(0, 2), st.data())
def test_the_blossom_is_symmetric_affine_and_diagonal(coefficients, more, data):
    polynomial = sum(rational(c) * t**k for k, c in enumerate(coefficients))
    n = len(coefficients) - 1 + more
    f = blossom(polynomial, degree=n)
    arguments = data.draw(st.lists(rationals, min_size=n, max_size=n))
    shuffled = data.draw(st.permutations(arguments))
    assert f(*arguments) == f(*shuffled)
    at = rational(data.draw(rationals))
    assert f(*[at] * n) == sp.S(polynomial).subs(t, at)
    if n:
        w, other = rational(data.draw(rationals)), rational(data.draw(rationals))
        first, rest = rational(arguments[0]), arguments[1:]
        mixed = f((1 - w) * first + w * other, *rest)
        assert mixed == (1 - w) * f(first, *rest) + w * f(other, *rest)


@given(polygons, rationals, rationals, st.data())
def test_blossom_values_are_polar_de_casteljau_points(points, r, s, data):
    n = len(points) - 1
    r, s = rational(r), rational(s)
    if r == s:
        return
    curve = [x.subs(t, (t - r) / (s - r)) for x in map(sp.S, bezier(n).curve(points))] if n else [
        sp.S(rational(x)) for x in points[0]]  # fmt: skip
    f = blossom(curve, degree=n)
    assert f.control_points(r, s) == tuple(tuple(map(rational, row)) for row in points)
    arguments = data.draw(st.lists(rationals, min_size=n, max_size=n))
    assert polar_levels(points, arguments, (r, s))[-1][0] == f(*arguments)


@pytest.mark.parametrize("n", [0, 1, 2, 3, 5, 8])
def test_the_certificate_proves_and_the_blossom_passes_its_own_check(n):
    coefficients = sp.symbols(f"c0:{n + 1}")
    polynomial = sum(c * t**k for k, c in enumerate(coefficients))
    f = blossom(polynomial, degree=n)
    assert f.certificate().is_proved
    if n <= 5:
        assert isinstance(check_blossom(f(*f.arguments), polynomial, f.arguments), Proved)


@pytest.mark.parametrize(("candidate", "words"), [
    (a**2 + b - a, "Not multi-affine: it is not affine in a. Not symmetric"),
    (a * b + a - b, "Not symmetric: exchanging a and b changes the value."),
    (2 * a * b, "Wrong diagonal: f(t, t) is not the polynomial."),
    (t**2, "This is the polynomial itself: a blossom has one argument per degree."),
    (a * t, "It still contains t: a blossom has arguments of its own, one per degree."),
    (a, "Wrong diagonal: f(t) is not the polynomial."),
])  # fmt: skip
def test_a_wrong_blossom_is_told_which_axiom_fails(candidate, words):
    verdict = check_blossom(candidate, t**2)
    assert isinstance(verdict, Refuted) and words in verdict.diagnosis
    assert verdict.left != verdict.right


UNSEEN_ZERO = sp.log(6) - sp.log(2) - sp.log(3)


@pytest.mark.parametrize(("candidate", "words"), [
    (a * b + (a - b) ** 2 * UNSEEN_ZERO, "The first axiom, multi-affine, could not be decided"),
    (a * b + UNSEEN_ZERO, "The third axiom, the diagonal, could not be decided"),
    (sp.Integral(sp.exp(-(a**2)), (a, 0, b)), "too long"),
])  # fmt: skip
def test_an_axiom_that_is_undecided_is_not_proved(candidate, words):
    verdict = check_blossom(candidate, t**2, [a, b])
    assert isinstance(verdict, Undecided) and words in str(verdict.diagnosis or verdict)


def test_sums_and_integrals_in_a_candidate_are_carried_out_first():
    assert check_blossom(sp.Integral(2 * a, (a, 0, 1)) * a * b, t**2)
    assert check_blossom(sp.Derivative(a**2 * b, a) / 2, t**2)


def test_dummies_are_variables_and_arguments_of_their_own():
    x, u, v = sp.Dummy("t"), sp.Dummy("u"), sp.Dummy("u")
    assert blossom(x**2, x)(3, 5) == 15
    assert blossom(x**2 + t, x)(3, 5) == 15 + t
    assert polynomial_to_bezier([x, x**2], x) == ((0, 0), (R(1, 2), 0), (1, 1))
    assert check_blossom(u * v, x**2, [u, v], x)


@pytest.mark.parametrize("degree", [0, 1, 2])
def test_the_certificate_of_a_constant_curve_and_of_lines_is_proved(degree):
    for curve in (5, [5, 7], [5, sp.Symbol("u")]):
        assert blossom(curve, degree=degree).certificate().is_proved


def test_a_parameter_that_cancels_does_no_harm():
    assert check_blossom(a * b + (t - 1) * (t + 1) - t**2 + 1, t**2)
    assert isinstance(check_blossom(2 * a * b + (t - 1) * (t + 1) - t**2 + 1, t**2), Refuted)
    assert check_blossom(a * b * (t**2 + t) / (t * (t + 1)), t**2)  # 0/0 at t = 0


def test_a_symbolic_blossom_of_high_degree_stays_small():
    f = blossom(t**16 + t**8)
    value = f(*f.arguments)
    assert value.count_ops() > 1000 and f(*range(16)) == f(*reversed(range(16)))


@pytest.mark.parametrize(("call", "error"), [
    (lambda: blossom(1 / t), BadValue),
    (lambda: blossom(t**3, degree=2), BadValue),
    (lambda: blossom(0.5 * t), NotExact),
    (lambda: blossom(a**2), BadValue),
    (lambda: polynomial_to_bezier([a]), BadValue),
    (lambda: blossom("t"), BadType),
    (lambda: blossom([]), BadValue),
    (lambda: blossom(t, "t"), BadValue),
    (lambda: blossom(t**2)(1), BadValue),
    (lambda: blossom(t).control_points(1, 1), BadValue),
    (lambda: check_blossom([a, b], t), BadValue),
    (lambda: check_blossom(a, 1 / t), BadValue),
    (lambda: check_blossom(a, t, [a, a]), BadValue),
    (lambda: check_blossom(a * b, t**2, (x for x in (a, b))), BadType),
    (lambda: check_blossom(a * b, t**2, 2), BadType),
    (lambda: check_blossom(a * b, t**2, [a, sp.Symbol("a", real=True)]), BadValue),
    (lambda: check_blossom(0.5 * a, t), NotExact),
    (lambda: elevate_degree([[0], [1]], -1), BadValue),
    (lambda: elevate_degree([[0], [1]], 1.0), BadValue),
    (lambda: reduce_degree([[0], [1]]), BadValue),
    (lambda: hodograph([[0], [1]], -1), BadValue),
    (lambda: hodograph([[t], [1]]), BadValue),
    (lambda: reduce_degree([[t], [1], [2]]), BadValue),
    (lambda: elevate_degree([[sp.Symbol("t", real=True)], [1]]), BadValue),
    (lambda: bezier(1).curve([[t], [1]]), BadValue),
    (lambda: hodograph([[0], [1]], interval=(2, 2)), BadValue),
    (lambda: antiderivative([[0], [1]], interval=2), BadValue),
    (lambda: polar_levels([[0], [1]], [0, 1]), BadValue),
    (lambda: polar_levels([[0], [1]], 1), BadType),
    (lambda: polynomial_to_bezier([sp.sin(t)]), BadValue),
    (lambda: restrict([[0], [1]], 0.5, 1), NotExact),
    (lambda: bezier_properties(0), BadValue),
])  # fmt: skip
def test_bad_input_is_refused_in_a_sentence(call, error):
    with pytest.raises(error, match="Expected .*, received .*\\. "):
        call()


def test_control_points_of_a_polynomial_lead_back_to_it():
    p = polynomial_to_bezier([t**3 - a * t, 2], t)
    assert prove(bezier(3).curve(p), [t**3 - a * t, 2])


@pytest.mark.parametrize("symbolic", [False, True])
def test_shared_points_of_high_degree_are_walked_once(symbolic):
    values = sp.symbols("y0:25") if symbolic else [k**2 % 7 for k in range(25)]
    points = tuple((y,) for y in values)
    (curve,) = de_casteljau(points, t)[-1][0]
    if not symbolic:
        found = polynomial_to_bezier(curve)
        assert found == points
    left, _ = subdivide(points, a)  # free_symbols would see a tree of 2^25 nodes
    lengths = [len(hodograph(left)), len(elevate_degree(left))]
    assert lengths == [24, 26]
    left, _ = subdivide(points, t)
    with pytest.raises(BadValue, match="received a long tuple"):
        hodograph(left)


@pytest.mark.parametrize("expression", [
    1 / t, sp.sqrt(t), sp.sin(t), t**a, 2**t, (t**2 + t) / t, sp.Derivative(t**2, t),
])  # fmt: skip
def test_what_is_no_polynomial_is_refused(expression):
    with pytest.raises(BadValue, match="Expected a polynomial in t, received"):
        blossom(a * expression + 1)


def test_a_hidden_division_by_zero_is_refused():
    """SymPy may have carried out the sum by then: infinity times a, in which t is not left."""
    hidden = 1 / sp.Add(t, -t, evaluate=False)
    with pytest.raises(BadValue, match="Expected a polynomial in t, (received|or its variable)"):
        blossom(a * hidden + 1)
    with pytest.raises(BadValue):
        blossom(hidden + t, t)

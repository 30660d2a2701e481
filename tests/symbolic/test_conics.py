"""Conics told from weights, against the discriminant of their implicit equation."""

import warnings

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Rational as R

from symbolic import (
    BadValue,
    HullWarning,
    RationalBezier,
    arc,
    conic_through,
    conic_type,
    implicitize,
    prove,
)

x, y, a = sp.symbols("x y a")

small = st.integers(-6, 6)
point = st.tuples(small, small)
weight = st.fractions(min_value=-4, max_value=4, max_denominator=4)
KINDS = {-1: "ellipse", 0: "parabola", 1: "hyperbola"}


@settings(max_examples=60, deadline=None)
@given(st.tuples(point, point, point), st.tuples(weight, weight, weight))
def test_the_weights_and_the_implicit_equation_name_the_same_conic(points, weights):
    assume(weights[0] and weights[2])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", HullWarning)
        conic = conic_type(points, weights)
        assert conic.derivation.is_proved
        if conic.kind == "point":
            return
        f = sp.Poly(implicitize(conic.curve).polynomial, x, y)
    if conic.kind == "line":
        assert f.total_degree() == 1
        return
    c = f.coeff_monomial
    assert f.total_degree() == 2
    assert KINDS[sp.sign(c(x * y) ** 2 - 4 * c(x**2) * c(y**2))] == conic.kind
    assert conic.is_circle == (c(x**2) == c(y**2) and c(x * y) == 0)
    if conic.center:  # where the gradient vanishes
        at = dict(zip((x, y), conic.center, strict=True))
        assert [f.diff(v).as_expr().subs(at) for v in (x, y)] == [0, 0]
    else:
        assert conic.kind == "parabola"


CASES = [
    ([[1, 0], [1, 1], [0, 1]], [1, sp.sqrt(2) / 2, 1], "ellipse", True),
    ([[1, 0], [1, 1], [0, 1]], [1, 1, 2], "ellipse", True),
    ([[1, 0], [1, 1], [0, 1]], [1, R(1, 2), 1], "ellipse", False),
    ([[1, 0], [1, 1], [0, 1]], [2, 2, 2], "parabola", False),
    ([[1, 0], [1, 1], [0, 1]], [sp.sqrt(2), 2, 2 * sp.sqrt(2)], "parabola", False),
    ([[1, 0], [1, 1], [0, 1]], [1, 2, 1], "hyperbola", False),
    ([[0, 0], [1, 1], [3, 3]], [1, 2, 1], "line", False),
    ([[0, 0], [1, 1], [0, 0]], [1, 2, 1], "line", False),
    ([[1, 2], [1, 2], [1, 2]], [1, 2, 1], "point", False),
    ([[0, 0, 0], [1, 1, 5], [2, 0, 1]], [1, R(1, 3), 1], "ellipse", False),
    ([[1, 0, 2], [1, 1, 2], [0, 1, 2]], [1, 1, 2], "ellipse", True),
    ([[0], [1], [3]], [1, 2, 1], "line", False),
]


@pytest.mark.parametrize("case", range(len(CASES)))
def test_known_conics(case):
    points, weights, kind, is_circle = CASES[case]
    conic = conic_type(points, weights)
    assert (conic.kind, conic.is_circle) == (kind, is_circle)
    assert conic.derivation.is_proved
    assert (conic.radius_squared == 1) == (is_circle and len(points[0]) in (2, 3))


def test_a_point_is_not_called_a_line():
    point = conic_type([[1, 2]] * 3, [1, 3, 2])
    assert point.kind == "point" and point.derivation.is_proved
    (step,) = point.derivation.steps
    assert step.because.endswith("all are one point") and step.right.rows == 2


def test_points_at_infinity():
    with pytest.warns(HullWarning):
        half = conic_type([[1, 0], [0, 1], [-1, 0]], [1, 0, 1])
        ellipse = conic_type([[1, 0], [0, 2], [-1, 0]], [1, 0, 1])
        segment = conic_type([[1, 0], [0, 0], [-1, 0]], [1, 0, 1])
    assert half.is_circle and half.center == (0, 0)
    assert (ellipse.kind, ellipse.is_circle, ellipse.center) == ("ellipse", False, (0, 0))
    assert segment.kind == "line"
    assert half.derivation.is_proved and segment.derivation.is_proved


def test_symbols_in_points_and_weights():
    points = [sp.symbols(f"p{i} q{i}") for i in range(3)]
    assert conic_type(points, [1, 2, 1]).kind == "hyperbola"
    assert conic_type(points, [a, a, a]).kind == "parabola"
    with pytest.raises(BadValue, match="decide the sign"):
        conic_type(points, [1, a, 1])


@settings(max_examples=12, deadline=None)
@given(st.tuples(*[st.fractions(R(1, 6), 4, max_denominator=6)] * 3))
def test_a_conic_through_a_point_runs_through_it(shares):
    total = sum(map(R, shares))
    a, b, c = (R(s) / total for s in shares)
    corners = sp.Matrix([[0, 0], [2, 3], [5, 1]])
    curve = conic_through(*corners.tolist(), list(sp.Matrix([[a, b, c]]) * corners))
    assert curve.points == tuple(map(tuple, corners.tolist()))
    w0, w1, w2 = curve.weights
    assert w1.is_positive
    assert b**2 == 4 * (w1**2 / (w0 * w2)) * a * c  # the conic in barycentric coordinates


def test_the_shoulder_point_is_at_one_half():
    curve = conic_through([1, 0], [1, 1], [0, 1], [R(2, 3), R(2, 3)])
    assert curve.de_casteljau(R(1, 2)).points[-1] == ((R(2, 3), R(2, 3)),)
    quarter = arc(0)
    shoulder = quarter.de_casteljau(R(1, 2)).points[-1][0]
    assert prove(conic_through(*quarter.points, shoulder).weights, quarter.weights)


REFUSED = [
    (lambda: conic_type([[0, 0], [1, 1]], [1, 1]), "three control points"),
    (lambda: conic_through([0, 0], [1, 1], [2, 2], [1, 1]), "a triangle"),
    (lambda: conic_through([0, 0], [1, 1], [2, 0], [5, 5]), "inside it"),
    (lambda: conic_through([0, 0], [1, 1], [2, 0], [1, 0]), "inside it"),
    (lambda: conic_type([[0, 0], [sp.sqrt(2), sp.sqrt(3)], [sp.sqrt(5), sp.sqrt(7)]], [1, 1, 1]),
     "fewer different roots"),
    (lambda: conic_type([[1, 0], [1, 1], [0, 1]], [1, sp.I, 1]), "real weights"),
    (lambda: conic_type([[1, 0], [1, sp.I], [0, 1]], [1, 1, 2]), "real coordinates"),
]  # fmt: skip


@pytest.mark.parametrize("case", range(len(REFUSED)))
def test_what_is_refused(case):
    call, said = REFUSED[case]
    with pytest.raises(BadValue, match=said):
        call()


def test_the_center_of_a_curve_is_kept_by_reparametrization():
    curve = RationalBezier([[0, 0], [1, 2], [3, 0]], [1, 3, 2])
    same = curve.reparametrized(5)
    first, second = (conic_type(c.points, c.weights) for c in (curve, same))
    assert (first.center, first.shape_factor) == (second.center, second.shape_factor)

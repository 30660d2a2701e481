"""Curves against their exact derivations, at rational parameters and to the promised error."""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from numeric import Curve
from numeric.curves.evaluation import HORNER_DEGREE
from symbolic import (
    BadType,
    BadValue,
    OutsideDomain,
    basis_from,
    bezier,
    de_casteljau,
    hermite,
    value,
)

t = sp.Symbol("t")
dyadic = st.integers(-1024, 1024).map(lambda k: Fraction(k, 64))  # exact as floats
parameters = st.integers(0, 64).map(lambda k: Fraction(k, 64))


@settings(max_examples=80, deadline=None)
@given(st.integers(1, 25), st.integers(1, 4), st.data())
def test_points_agree_with_exact_de_casteljau(degree, dim, data):
    row = st.lists(dyadic, min_size=dim, max_size=dim)
    points = data.draw(st.lists(row, min_size=degree + 1, max_size=degree + 1))
    at = data.draw(parameters)
    exact = [float(c) for c in de_casteljau(points, at)[-1][0]]
    size = max(1e-300, max(abs(float(c)) for point in points for c in point))
    bound = 2e-13 if degree <= HORNER_DEGREE else 4e-15
    error = np.abs(Curve.from_bezier(points)(float(at)) - exact).max() / size
    assert error <= bound


@pytest.mark.parametrize("degree", range(1, 26))
def test_alternating_points_are_the_worst_case_and_stay_within_the_bound(degree):
    points = [[Fraction((-1) ** i)] for i in range(degree + 1)]
    at = [Fraction(k / 17) for k in range(18)]  # floats, taken exactly
    exact = [float(de_casteljau(points, u)[-1][0][0]) for u in at]
    ours = Curve.from_bezier(points)([float(u) for u in at])[:, 0]
    assert np.abs(ours - exact).max() <= (2e-13 if degree <= HORNER_DEGREE else 4e-15)


@pytest.mark.parametrize("shape", [(), (1,), (5,), (2, 3), (0,), (4, 1, 2)])
def test_any_shape_of_parameters(shape):
    curve = Curve.from_bezier([[0, 0, 1], [1, 2, 1], [2, 0, 1]])
    assert curve(np.full(shape, 0.5)).shape == (*shape, 3)


def test_both_ends_belong_to_the_domain_and_to_the_polygon():
    points = np.array([[0.1, 0.2], [1.7, 2.3], [2.9, -0.4], [0.3, 0.3]])
    for degree in (3, 9):
        curve = Curve.from_bezier(np.resize(points, (degree + 1, 2)), domain=(2, 5))
        np.testing.assert_allclose(curve([2, 5]), curve.points[0][[0, -1]], rtol=0, atol=4e-15)


def test_several_segments_on_their_own_breaks():
    segments = [[[0, 0], [1, 1]], [[1, 1], [3, 1]], [[3, 1], [3, 5]]]
    curve = Curve.from_bezier(segments, domain=(0, 1, 2, 4))
    np.testing.assert_allclose(
        curve([0, 0.5, 1, 1.5, 2, 3, 4]),
        [[0, 0], [0.5, 0.5], [1, 1], [2, 1], [3, 1], [3, 3], [3, 5]],
    )
    assert Curve.from_bezier(segments, domain=(0, 3)).breaks.tolist() == [0, 1, 2, 3]


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(dyadic, dyadic), min_size=2, max_size=9), st.integers(1, 4))
def test_derivatives_agree_with_calculus(points, scale):
    n = len(points) - 1
    end = float(2**scale)
    exact = [sp.diff(e.subs(t, t / sp.Integer(2**scale)), t) for e in bezier(n).curve(points)]
    curve = Curve.from_bezier(points, domain=(0, end)).derivative()
    at = [0.0, end / 4, end]
    expected = [[float(e.subs(t, sp.Rational(a))) for e in exact] for a in at]
    np.testing.assert_allclose(curve(at), expected, rtol=0, atol=1e-10)
    assert curve.degree == n - 1


def test_derivative_of_a_constant_is_zero():
    curve = Curve.from_bezier([[0, 0], [1, 2]]).derivative()
    assert curve(0.3).tolist() == [1, 2]
    assert curve.derivative()(0.3).tolist() == [0, 0]


@pytest.mark.parametrize("n", [1, 3, 5])
def test_from_basis_is_the_exact_curve(n):
    rows = [[i * i - 3, 2 * i + 1] for i in range(n + 1)]
    exact = hermite(n).curve(rows)
    at = [Fraction(k, 8) for k in range(9)]
    expected = [[float(e.subs(t, sp.Rational(a))) for e in exact] for a in at]
    ours = Curve.from_basis(hermite(n), rows)([float(a) for a in at])
    np.testing.assert_allclose(ours, expected, rtol=1e-13)


def test_from_expressions_on_another_domain():
    curve = Curve.from_expressions([t**3 - t, 2, sp.Rational(1, 3) * t], t, domain=(-1, 2))
    at = np.linspace(-1, 2, 7)
    expected = np.stack([at**3 - at, np.full(7, 2.0), at / 3], axis=-1)
    np.testing.assert_allclose(curve(at), expected, rtol=0, atol=1e-14)


def test_agrees_with_scipy():
    from scipy.interpolate import BPoly

    rng = np.random.default_rng(0)
    points, breaks = rng.normal(size=(5, 4, 3)), np.array([0, 1, 1.5, 2, 4, 7.0])
    at = np.linspace(0, 7, 1001)
    reference = BPoly(points.swapaxes(0, 1), breaks)(at)
    np.testing.assert_allclose(Curve.from_bezier(points, breaks)(at), reference, atol=1e-13)


@pytest.mark.parametrize("points", [[[1, 1]] * 4, [[0, 0], [0, 0], [1, 1], [1, 1]]])
def test_degenerate_curves_are_curves(points):
    assert np.isfinite(Curve.from_bezier(points)(np.linspace(0, 1, 9))).all()


@pytest.mark.parametrize("scale", [1e-300, 1e-12, 1e12, 1e300])
def test_tiny_and_huge_coordinates(scale):
    curve = Curve.from_bezier(np.array([[0, 0], [1, 2], [2, 0]]) * scale)
    np.testing.assert_allclose(curve(0.5), [scale, scale], rtol=1e-15)


BAD = {
    "ragged": ([[0, 0], [1]], BadValue, "one dimension"),
    "empty": ([], BadValue, "rows"),
    "one-dimensional": ([0, 1, 2], BadValue, r"shape \(3,\)"),
    "NaN": ([[0, 0], [float("nan"), 1]], BadValue, "nan in point 1, coordinate 0"),
    "infinity": ([[0, 0], [1, float("inf")]], BadValue, "inf in point 1, coordinate 1"),
    "text": ([["0", "1"], ["2", "3"]], BadType, "never parsed"),
    "symbols": ([[t, 0], [1, 1]], BadType, "Substitute"),
    "complex": ([[1j, 0], [1, 1]], BadType, "real"),
    "unequal segments": ([[[0, 0], [1, 1]], [[0, 0], [1, 1], [2, 2]]], BadValue, "one degree"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_bad_points(name):
    points, error, said = BAD[name]
    with pytest.raises(error, match=said):
        Curve.from_bezier(points)


@pytest.mark.parametrize("at", [-0.001, 1.001, [0.5, 2], [np.nan, 2], np.array([[0.1, -1]])])
def test_parameters_outside_the_domain(at):
    with pytest.raises(OutsideDomain, match=r"parameters in \[0, 1\]"):
        Curve.from_bezier([[0, 0], [1, 1]])(at)


@pytest.mark.parametrize("at", ["0.5", None, [0.5, "1"], [[0.1], [0.1, 0.2]], 1j])
def test_parameters_that_are_not_numbers(at):
    with pytest.raises(BadType, match="real numbers"):
        Curve.from_bezier([[0, 0], [1, 1]])(at)


@pytest.mark.parametrize("domain", [(1, 0), (0, 0), (0, 1, 2), (0, float("nan"))])
def test_bad_domains(domain):
    with pytest.raises(BadValue):
        Curve.from_bezier([[0, 0], [1, 1]], domain)


@pytest.mark.parametrize("expression", [sp.sin(t), sp.sqrt(t), sp.Symbol("a") * t, sp.I * t])
def test_expressions_that_are_no_polynomials(expression):
    with pytest.raises(BadValue, match="polynomials in t"):
        Curve.from_expressions([expression], t)


@pytest.mark.parametrize("build", [
    lambda: Curve.from_bezier([[0, 0], [1, 1]], 5),
    lambda: Curve.from_bezier([[0, 0], [1, 1]], None),
    lambda: Curve.from_bezier([[0, 0], [1, 1]], "01"),
    lambda: Curve.from_bezier([[0, 0], [1, 1]], (0, float("inf"))),
    lambda: Curve.from_bezier([[None, 0], [1, 1]]),
    lambda: Curve.from_bezier(np.zeros((0, 3, 2))),
    lambda: Curve.from_expressions([], t),
    lambda: Curve.from_expressions(t**2, t),
    lambda: Curve.from_expressions([t], "t"),
    lambda: Curve.from_basis(basis_from([value(0), value(sp.Symbol("a"))]), [[0], [1]]),
])  # fmt: skip
def test_every_way_in_is_guarded(build):
    with pytest.raises((BadType, BadValue), match="Expected"):
        build()


def test_the_symbol_of_an_expression_is_matched_by_name():
    curve = Curve.from_expressions([sp.Symbol("t", real=True) ** 2], t)
    assert curve(0.5) == pytest.approx(0.25)


def test_derivatives_outside_the_domain_are_those_of_the_same_polynomial():
    curve = Curve.from_expressions(sp.Matrix([t**2, t**3]), t)
    with pytest.raises(OutsideDomain, match="extrapolate=True"):
        curve.derivatives(2, 1)
    found = curve.derivatives([-1, 2], 2, extrapolate=True)
    expected = [[[1, -1], [4, 8]], [[-2, 3], [4, 12]], [[2, -6], [2, 12]]]
    np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_whole_numbers_beyond_floats_are_told():
    curve = Curve.from_bezier([[0, 0], [1, 1]])
    for build in (lambda: curve(10**400), lambda: Curve.from_bezier([[10**400, 0], [1, 1]])):
        with pytest.raises(BadValue, match="floats can hold"):
            build()

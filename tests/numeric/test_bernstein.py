"""Polynomials in Bernstein form against exact arithmetic: parts, products, and all their roots."""

from fractions import Fraction
from math import comb

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from numeric.bernstein import form
from numeric.bernstein.evaluation import values_at
from numeric.bernstein.roots import DEEPEST, roots

x = sp.Symbol("x")
EPSILON = float(np.finfo(float).eps)
entries = st.integers(-999, 999).map(lambda k: k / 8)
places = st.integers(0, 64).map(lambda k: k / 64)


def rows(most=25):
    """Return lists of coefficients of one polynomial, of degree 0 to `most`."""
    return st.lists(entries, min_size=1, max_size=most + 1)


def exact(coefficients, u):
    """Return the value at u in rational arithmetic, by de Casteljau's algorithm."""
    level, u = [Fraction(c) for c in coefficients], Fraction(u)
    while len(level) > 1:
        level = [(1 - u) * a + u * b for a, b in zip(level, level[1:], strict=False)]
    return level[0]


def powers(coefficients):
    """Return the polynomial in x, exactly."""
    n = len(coefficients) - 1
    terms = (
        sp.Rational(c) * comb(n, i) * x**i * (1 - x) ** (n - i) for i, c in enumerate(coefficients)
    )
    return sp.Poly(sum(terms, sp.Integer(0)), x)


def bernstein(polynomial, degree=None):
    """Return the Bernstein coefficients of a polynomial in x, rounded once."""
    a = polynomial.all_coeffs()[::-1]
    n = max(len(a) - 1, degree or 0)
    shares = [[sp.Rational(comb(i, k), comb(n, k)) for k in range(len(a))] for i in range(n + 1)]
    return np.array([[float(sp.Matrix([a]).dot(sp.Matrix([row]))) for row in shares]])


def close(found, expected, size, times=64):
    error = np.abs(np.array(found, float) - np.array([float(e) for e in expected])).max()
    assert error <= times * EPSILON * max(size, 1e-300)


@settings(max_examples=60, deadline=None)
@given(rows(), places, places)
def test_parts_have_the_values_of_the_whole(coefficients, a, b):
    f, size = np.array([coefficients]), max(map(abs, coefficients))
    a, b = min(a, b), max(a, b)
    left, right = form.split(f, a)
    piece = form.part(f, a, b)
    for u in (0, 0.25, 1):
        close([exact(left[0], u)], [exact(coefficients, a * u)], size)
        close([exact(right[0], u)], [exact(coefficients, a + (1 - a) * u)], size)
        close([exact(piece[0], u)], [exact(coefficients, a + (b - a) * u)], size, 256)


@settings(max_examples=60, deadline=None)
@given(rows(12), rows(12), places)
def test_a_product_has_the_product_of_the_values(f, g, u):
    product = form.product(np.array([f]), np.array([g]))
    assert product.shape == (1, len(f) + len(g) - 1)
    size = max(map(abs, f)) * max(map(abs, g))
    close([exact(product[0], u)], [exact(f, u) * exact(g, u)], size)


@settings(max_examples=60, deadline=None)
@given(rows(), st.integers(0, 5), places)
def test_elevation_and_the_derivative(coefficients, by, u):
    f, size = np.array([coefficients]), max(map(abs, coefficients))
    close([exact(form.elevate(f, by)[0], u)], [exact(coefficients, u)], size)
    slope = powers(coefficients).diff(x).eval(sp.Rational(u))
    close([exact(form.derivative(f)[0], u)], [slope], 2 * len(coefficients) * size)


@settings(max_examples=60, deadline=None)
@given(rows(10))
def test_powers_and_back(coefficients):
    f = np.array([coefficients])
    a = form.to_powers(f)
    expected = powers(coefficients).all_coeffs()[::-1]
    close(a[0, : len(expected)], expected, np.abs(a).max())
    close(form.from_powers(a)[0], coefficients, np.abs(a).max())


@settings(max_examples=60, deadline=None)
@given(rows(), places)
def test_every_row_is_evaluated_at_its_own_place(coefficients, u):
    f = np.array([coefficients, coefficients[::-1]])[..., None]
    found = values_at(f, np.array([u, 1 - u]))[:, 0]
    close(found, [exact(coefficients, u)] * 2, max(map(abs, coefficients)))


def test_no_rows_have_no_values_and_no_roots():
    assert values_at(np.empty((0, 4, 2)), np.empty(0)).shape == (0, 2)
    assert len(roots(np.empty((0, 4))).u) == 0


def distinct(polynomial):
    """Return the distinct roots in [0, 1], exactly isolated and then rounded."""
    if polynomial.degree() < 1:
        return []
    found = polynomial.intervals(eps=sp.Rational(1, 2**60), inf=0, sup=1)
    return [float((a + b) / 2) for (a, b), _ in found]


small = st.lists(st.integers(-9, 9).map(float), min_size=2, max_size=9)


@settings(max_examples=150, deadline=None)
@given(small)
def test_roots_of_small_integers_are_all_found_and_no_others(coefficients):
    polynomial = powers(coefficients)
    expected = [] if polynomial.is_zero else distinct(polynomial)
    found = roots(np.array([coefficients]))
    assert len(found.u) == len(expected)
    # A root of multiplicity k is known to the k-th root of rounding.
    worst = [1e-12 if simple else 2e-3 for simple in found.simple]
    assert (np.abs(found.u - expected) <= worst).all()
    slope = polynomial.diff(x)
    for u, simple in zip(expected, found.simple, strict=True):
        if abs(slope.eval(sp.Rational(u))) > 1e-3 * max(map(abs, coefficients)):
            assert simple


@settings(max_examples=80, deadline=None)
@given(st.sets(st.integers(0, 32), min_size=1, max_size=6), st.integers(0, 19))
def test_known_roots_at_any_degree(chosen, by):
    expected = sorted(Fraction(k, 32) for k in chosen)
    polynomial = sp.Poly(sp.prod(x - sp.Rational(r) for r in expected), x)
    found = roots(bernstein(polynomial, polynomial.degree() + by))
    assert len(found.u) == len(expected) and found.simple.all()
    size = np.abs(bernstein(polynomial)).max()
    slopes = [abs(float(polynomial.diff(x).eval(sp.Rational(r)))) for r in expected]
    for u, r, slope in zip(found.u, expected, slopes, strict=True):
        assert abs(u - float(r)) <= 100 * EPSILON * size / slope


@pytest.mark.parametrize("multiplicity", [2, 3, 4, 7, 12, 25])
@pytest.mark.parametrize("at", [Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(1)])
def test_a_multiple_root_is_told_once(multiplicity, at):
    found = roots(bernstein(sp.Poly((x - sp.Rational(at)) ** multiplicity, x)))
    assert len(found.u) == 1 and not found.simple.any()
    # The polynomial is zero within noise as far as this from its root.
    assert abs(found.u[0] - float(at)) <= 4 * (26 * EPSILON) ** (1 / multiplicity)


@pytest.mark.parametrize("gap", [Fraction(1, 2**k) for k in (4, 10, 16, 20)])
def test_two_roots_close_together_are_two(gap):
    r = Fraction(1, 3)
    found = roots(bernstein(sp.Poly((x - sp.Rational(r)) * (x - sp.Rational(r + gap)), x)))
    np.testing.assert_allclose(found.u, [float(r), float(r + gap)], rtol=0, atol=1e-15 / gap)


@pytest.mark.parametrize("gap", [1e-9, 1e-12])
def test_two_roots_closer_than_rounding_are_near_what_is_told(gap):
    polynomial = sp.Poly((x - sp.Rational(1, 3)) * (x - sp.Rational(1, 3) - sp.Rational(gap)), x)
    found = roots(bernstein(polynomial))
    assert len(found.u) in (1, 2)
    assert np.abs(found.u - 1 / 3).max() < 1e-7


@pytest.mark.parametrize("scale", [1e-320, 1e-300, 1e-150, 1.0, 1e150, 1e307])
def test_roots_do_not_depend_on_the_scale(scale):
    f = np.array([[-1.0, 2.0, -3.0, 2.0], [1.0, 0.0, -1.0, -5.0]])
    found, expected = roots(f * scale), roots(f)
    np.testing.assert_allclose(found.u, expected.u, rtol=0, atol=1e-3 if scale < 1e-310 else 4e-16)
    assert found.row.tolist() == expected.row.tolist()


def test_scales_are_each_row_s_own():
    f = np.array([[-1e-200, 2e-200], [-1e200, 2e200], [0.0, 0.0], [-1.0, 2.0]])
    found = roots(f)
    assert found.row.tolist() == [0, 1, 3]
    np.testing.assert_allclose(found.u, 1 / 3, rtol=0, atol=1e-16)


@pytest.mark.parametrize("small", [1e-3, 1e-30, 1e-100, 1e-300])
def test_coefficients_of_very_different_size(small):
    """-small (1 - u)^n + u^n vanishes where u / (1 - u) is the n-th root of small."""
    for n in (1, 3, 10, 25):
        f = np.zeros((1, n + 1))
        f[0, [0, -1]] = -small, 1
        quotient = small ** (1 / n)
        found = roots(f)
        np.testing.assert_allclose(found.u, [quotient / (1 + quotient)], rtol=1e-12, atol=1e-16)


@pytest.mark.parametrize("degree", range(26))
def test_the_zero_polynomial_and_constants_have_no_roots(degree):
    f = np.zeros((3, degree + 1))
    f[1:] = [[2.0], [-3.0]]
    assert len(roots(f).u) == 0


def test_what_is_within_noise_has_no_roots():
    f = np.array([[1e-17, -1e-17, 1e-17], [1.0, -1.0, 1.0]])
    assert roots(f, np.array([1e-16, 1e-16])).row.tolist() == [1]
    assert roots(f).row.tolist() == [0, 1]


@settings(max_examples=60, deadline=None)
@given(st.integers(1, 25), st.integers(0, 2**32 - 1))
def test_signs_change_at_roots_and_nowhere_else(degree, seed):
    """Random coefficients, most of degree 25: exact signs between the roots that are told."""
    f = np.random.default_rng(seed).normal(size=(1, degree + 1))
    found = roots(f)
    assert found.simple.all() and (np.diff(found.u) > 0).all()
    cuts = [0.0, *found.u, 1.0]
    signs = [exact(f[0], (a + b) / 2) > 0 for a, b in zip(cuts, cuts[1:], strict=False)]
    assert all(a != b for a, b in zip(signs, signs[1:], strict=False))
    assert powers(f[0].tolist()).count_roots(0, 1) == len(found.u)


def test_chebyshev_polynomials_of_degree_25():
    """Their roots cluster at the ends: cos((2k - 1) pi / 2n), moved to [0, 1]."""
    n = 25
    polynomial = sp.Poly(sp.chebyshevt(n, 2 * x - 1), x)
    expected = sorted((1 + np.cos((2 * k - 1) * np.pi / (2 * n))) / 2 for k in range(1, n + 1))
    # Bernstein coefficients of T_25 reach 1e8 times its own size.
    np.testing.assert_allclose(roots(bernstein(polynomial)).u, expected, rtol=0, atol=1e-8)


def test_hostile_rows_open_few_intervals(monkeypatch):
    """As many as the degree and no more at each depth, whatever the polynomial."""
    import numeric.bernstein.roots as module

    opened = []

    def counted(f):
        opened.append(len(f))
        return form.split(f)

    monkeypatch.setattr(module, "split", counted)
    n = 25
    for r in (Fraction(1, 3), Fraction(1, 7)):
        for k in (2, 12, 25):
            f = bernstein(sp.Poly((x - sp.Rational(r)) ** k, x), n)
            opened.clear()
            roots(f)
            assert len(opened) <= DEEPEST and max(opened) <= n

"""Exact vectors B01-B34 of the university course that are not plain matrices: Bezier curves."""

from itertools import pairwise

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational as R
from sympy import symbols

from symbolic import (
    Refuted,
    bernstein,
    bezier,
    bezier_algorithms,
    bezier_properties,
    de_casteljau,
    elevate_degree,
    hodograph,
    polar_levels,
    prove,
    subdivide,
    subdivision_matrices,
)

t, u = symbols("t u")
DEGREES = range(1, 7)


def column(n, name="p"):
    return [[p] for p in symbols(f"{name}0:{n + 1}")]


def curve(points, at=t):
    return de_casteljau(points, at)[-1][0][0]


def test_b01_a_parametric_parabola_is_planar():
    c = sp.Matrix(3, 3, symbols("c0:3x c0:3y c0:3z"))
    chord = c * sp.Matrix([1, t, t**2]) - c[:, 0]
    assert prove(sp.Matrix.hstack(c[:, 1:], chord).det(), 0)


def test_b02_three_point_construction():
    levels = de_casteljau(column(2, "b"), t)
    b0, b1, b2 = symbols("b0:3")
    assert prove([p[0] for p in levels[1]], [(1 - t) * b0 + t * b1, (1 - t) * b1 + t * b2])
    assert prove(levels[2][0][0], (1 - t) ** 2 * b0 + 2 * t * (1 - t) * b1 + t**2 * b2)


@pytest.mark.parametrize("n", DEGREES)
def test_b04_the_recursion_is_the_bernstein_form(n):
    points = column(n)
    weights = zip(bernstein(n), points, strict=True)
    assert prove(curve(points), sum(w * p[0] for w, p in weights))


@pytest.mark.parametrize(("n", "listed"), [
    (0, [1]), (1, [1 - t, t]), (2, [(1 - t)**2, 2*t*(1 - t), t**2]),
    (3, [(1 - t)**3, 3*t*(1 - t)**2, 3*t**2*(1 - t), t**3]),
])  # fmt: skip
def test_b05_b06_bernstein_bases(n, listed):
    assert prove(list(bernstein(n)), listed)


PROPERTIES = {
    "B07": "partition of unity",
    "B08": "non-negativity",
    "B09": "end points",
    "B10": "pseudo-local maximum",
    "B11": "symmetry",
    "B12": "linear precision",
    "B13": "affine invariance",
    "B14": "parameter transformation",
    "B32": "barycentric combinations",
}


@pytest.mark.parametrize("vector", PROPERTIES)
@pytest.mark.parametrize("n", [*DEGREES, 8])
def test_property_is_proved(vector, n):
    assert bezier_properties(n)[PROPERTIES[vector]].is_proved


def test_every_property_has_its_vector():
    assert set(PROPERTIES.values()) == set(bezier_properties(2))


def test_b08_weights_vanish_only_at_the_ends():
    for n in DEGREES:
        for i, weight in enumerate(bernstein(n)):
            assert set(sp.roots(sp.Poly(weight, t))) <= {0, 1}
            assert weight.subs(t, R(1, 2)) > 0
            assert (weight.subs(t, 0) == 0) == (i > 0)
            assert (weight.subs(t, 1) == 0) == (i < n)


def test_b12_collinear_is_not_yet_a_segment():
    assert curve([[0], [3], [1]], R(3, 5)) == R(9, 5)


def test_b14_the_same_points_over_another_interval():
    r, s = symbols("r s")
    points = column(3)
    moved = polar_levels(points, [r + (s - r) * t] * 3, (r, s))[-1][0][0]
    assert prove(moved, curve(points))


@pytest.mark.parametrize("n", DEGREES)
def test_b15_b18_b19_b20_derivatives_at_the_ends(n):
    p = symbols(f"p0:{n + 1}")
    velocity = hodograph(column(n))
    assert prove(velocity[0][0], n * (p[1] - p[0]))
    assert prove(velocity[-1][0], n * (p[n] - p[n - 1]))
    assert prove(curve(velocity), sp.Derivative(curve(column(n)), t))
    if n == 3:
        assert prove([v[0] for v in velocity], [3 * (b - a) for a, b in pairwise(p)])
        form1 = (-3*(1 - t)**2*p[0] + 3*((1 - t)**2 - 2*t*(1 - t))*p[1]
                 + 3*(2*t*(1 - t) - t**2)*p[2] + 3*t**2*p[3])  # fmt: skip
        assert prove(curve(velocity), form1)
        assert isinstance(prove(velocity[-1][0], p[3] - p[2]), Refuted)  # as printed


@pytest.mark.parametrize("n", range(1, 6))
def test_b21_end_derivatives_involve_few_points(n):
    p = symbols(f"p0:{n + 1}")
    for order in range(n + 1):
        points = hodograph(column(n), order)
        assert sp.expand(points[0][0]).free_symbols == set(p[: order + 1])
        assert sp.expand(points[-1][0]).free_symbols == set(p[n - order :])


def test_b22_inner_derivatives_involve_all_points_but_at_exceptions():
    p = symbols("p0:4")
    velocity = sp.Poly(curve(hodograph(column(3)), u), *p).as_dict()
    coefficients = [velocity[tuple(int(i == j) for i in range(4))] for j in range(4)]
    inner = {root for c in coefficients for root in sp.roots(sp.Poly(c, u)) if 0 < root < 1}
    assert inner == {R(1, 3), R(2, 3)}


@pytest.mark.parametrize("n", DEGREES)
def test_b16_b17_b20_b23_b29_algorithms_are_proved(n):
    derivations = bezier_algorithms(n)
    assert len(derivations) == 5
    for derivation in derivations.values():
        assert derivation.is_proved, derivation.title


def test_b23_subdivision_matrices():
    left, right = subdivision_matrices(3, u)
    assert prove(left * sp.Matrix(column(3)), [list(p) for p in subdivide(column(3), u)[0]])
    assert prove(right * sp.Matrix(column(3)), [list(p) for p in subdivide(column(3), u)[1]])


def test_b23_subdivision_reparametrizes():
    v, points = sp.Symbol("v"), column(3)
    left, right = subdivide(points, u)
    assert prove(curve(left, v), curve(points, u * v))
    assert prove(curve(right, v), curve(points, u + (1 - u) * v))


def test_b28_counts():
    assert [len(bezier(n).geometry) for n in (1, 2, 4)] == [2, 3, 5]


def test_b29_degree_elevation():
    b0, b1, b2, b3 = symbols("p0:4")
    expected = [b0, (b0 + 3 * b1) / 4, (b1 + b2) / 2, (3 * b2 + b3) / 4, b3]
    assert prove([p[0] for p in elevate_degree(column(3))], expected)


@given(st.lists(st.integers(-9, 9), min_size=3, max_size=7))
def test_b30_variation_diminishing(coefficients):
    """The curve has no more zeros in (0, 1) than its coefficients have changes of sign."""
    signs = [c for c in coefficients if c]
    changes = sum(a * b < 0 for a, b in pairwise(signs))
    polynomial = sp.Poly(sp.expand(curve([[c] for c in coefficients])), t)
    if polynomial.degree() > 0:
        ends = sum(polynomial.eval(end) == 0 for end in (0, 1))
        assert polynomial.count_roots(0, 1) - ends <= changes


def test_b31_without_its_premises_the_hull_is_lost():
    """All points equal force partition of unity; one point apart forces non-negativity."""
    f = symbols("f0:4")
    together = sum(weight * 5 for weight in f)
    assert prove(together.subs(f[3], 1 - f[0] - f[1] - f[2]), 5)
    assert isinstance(prove(together, 5), Refuted)


def test_b32_barycentric_combinations():
    a = sp.Symbol("a")
    b, c = column(3, "b"), column(3, "c")
    mixed = [[a * p[0] + (1 - a) * q[0]] for p, q in zip(b, c, strict=True)]
    assert prove(curve(mixed), a * curve(b) + (1 - a) * curve(c))


def test_b34_inner_points_are_never_reached():
    largest = max(bernstein(3)[1].subs(t, at) for at in (0, R(1, 3), 1))
    assert largest == R(4, 9)
    assert prove(sp.Derivative(bernstein(3)[1], t), 3 * (1 - t) * (1 - 3 * t))

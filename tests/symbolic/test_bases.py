"""What is special to some bases: Catmull-Rom over any knots, SciPy as an oracle, constraints."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline, KroghInterpolator
from sympy import Rational as R
from sympy import sqrt

from symbolic import (
    Refuted,
    UnsolvableConstraints,
    basis_from,
    bezier,
    catmull_rom,
    chord_knots,
    derivative,
    hermite,
    lagrange,
    prove,
    uniform_bspline,
    value,
)

t, a = sp.symbols("t a")
P0, P1, P2 = sp.symbols("P0:3")
rationals = st.fractions(min_value=-3, max_value=3, max_denominator=8)
gaps = st.fractions(min_value=R(1, 8), max_value=3, max_denominator=8)


def exact(number):
    return R(number.numerator, number.denominator)


POINTS = [[0, 0], [3, 4], [3, 5], [4, 6]]


def test_chord_knots_are_exact():
    assert chord_knots(POINTS, 0) == (0, 1, 2, 3)
    assert chord_knots(POINTS, 1) == (0, 5, 6, 6 + sqrt(2))
    assert chord_knots(POINTS, R(1, 2)) == (0, sqrt(5), 1 + sqrt(5), 1 + sqrt(5) + 2 ** R(1, 4))
    assert chord_knots([[0, 0], [0, 0]], 0) == (0, 1)


@pytest.mark.parametrize("alpha", [0, R(1, 3), R(1, 2), 1])
def test_the_pyramid_interpolates_and_is_c1_over_any_knots(alpha):
    """Two segments share a tangent in the global parameter u: c'(t) divided by the interval."""
    points = [*POINTS, [9, 2]]
    knots = chord_knots(points, alpha)
    left, right = catmull_rom(knots[:4]), catmull_rom(knots[1:])
    at_end = sp.Matrix([condition.row(3) for condition in (value(1), derivative(1))]) * left.matrix
    at_start = sp.Matrix([value(0).row(3), derivative(0).row(3)]) * right.matrix
    assert prove(at_end.row(0), [[0, 0, 1, 0]])
    assert prove(at_start.row(0), [[0, 1, 0, 0]])
    incoming = [*at_end.row(1) / (knots[2] - knots[1]), 0]
    outgoing = [0, *at_start.row(1) / (knots[3] - knots[2])]
    assert prove(incoming, outgoing)
    assert left.derivation.is_proved


def test_any_symbolic_knots():
    knots = sp.symbols("t0:4")
    general = catmull_rom(knots)
    assert general.derivation.is_proved
    uniform = general.matrix.subs(dict(zip(knots, range(4), strict=True)))
    assert uniform == catmull_rom().matrix == catmull_rom(range(4)).matrix


@settings(max_examples=20, deadline=None)
@given(st.tuples(gaps, gaps, gaps), rationals, gaps)
def test_only_the_ratios_of_the_gaps_matter(drawn, start, scale):
    g = [exact(gap) for gap in drawn]
    knots = [0, g[0], g[0] + g[1], sum(g)]
    moved = [exact(start) + exact(scale) * knot for knot in knots]
    assert catmull_rom(moved).matrix == catmull_rom(knots).matrix


@pytest.mark.parametrize("n", [1, 2, 3, 5, 9, 12])
def test_uniform_bsplines_agree_with_scipy(n):
    coefficients = [(3 * i * i + 1) % 7 for i in range(n + 1)]
    peer = BSpline(np.arange(-n, n + 2.0), np.array(coefficients, float), n)
    curve = uniform_bspline(n).curve([[c] for c in coefficients])[0]
    for at in (R(0), R(1, 3), R(7, 8)):
        assert float(curve.subs(t, at)) == pytest.approx(float(peer(float(at))), rel=1e-9)


@settings(max_examples=20, deadline=None)
@given(st.lists(st.integers(-4, 4), min_size=2, max_size=6, unique=True), st.data())
def test_lagrange_agrees_with_scipy(nodes, data):
    values = data.draw(st.lists(st.integers(-9, 9), min_size=len(nodes), max_size=len(nodes)))
    curve = lagrange(nodes).curve([[v] for v in values])[0]
    peer = KroghInterpolator(nodes, values)
    for at in (R(-1, 3), R(5, 4)):
        assert float(curve.subs(t, at)) == pytest.approx(float(peer(float(at))), abs=1e-6)


@pytest.mark.parametrize("n", [3, 7, 13])
def test_hermite_agrees_with_scipy(n):
    data = [(7 * i) % 5 - 2 for i in range(n + 1)]
    nodes = [0] * (len(data) // 2) + [1] * (len(data) // 2)
    peer = KroghInterpolator(nodes, data[::2] + data[1::2])
    curve = hermite(n).curve([[d] for d in data])[0]
    assert float(curve.subs(t, R(2, 5))) == pytest.approx(float(peer(0.4)), rel=1e-9)


@pytest.mark.parametrize("n", [2, 3, 5])
def test_a_wrong_uniform_matrix_is_refuted(n):
    assert isinstance(prove(uniform_bspline(n).matrix, bezier(n).matrix), Refuted)


def test_constraints_at_roots_and_symbols_are_met():
    basis = basis_from(
        [(value(0), a * P0), (derivative(a, 2), (P1 - P0) / a), (value(sqrt(2)), P2)],
        geometry=(P0, P1, P2),
    )
    assert basis.derivation.is_proved
    curve = basis.curve([[P0], [P1], [P2]])[0]
    assert prove(curve.subs(t, 0), a * P0)
    assert prove(sp.diff(curve, t, 2), (P1 - P0) / a)
    assert prove(curve.subs(t, sqrt(2)), P2)


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(st.integers(-2, 2), st.integers(0, 3)), min_size=1, max_size=5))
def test_constraints_are_met_or_the_dependent_ones_named(drawn):
    conditions = [derivative(at, order) if order else value(at) for at, order in drawn]
    try:
        basis = basis_from(conditions)
    except UnsolvableConstraints as error:
        assert sp.Matrix([c.row(len(drawn) - 1) for c in conditions]).det() == 0
        assert "=" in error.received
        return
    for i, f in enumerate(basis.functions):
        values = [sp.diff(f, t, order).subs(t, at) for at, order in drawn]
        assert values == [int(i == j) for j in range(len(drawn))]


@pytest.mark.parametrize("build", [
    lambda: basis_from([value(0), value(sp.Symbol("a_1"))]),
    lambda: basis_from([(value(0), sp.Symbol("a_0")), (value(1), sp.Symbol("b_1"))]),
    lambda: catmull_rom([0, sp.sqrt(2), *sp.symbols("h0 h1")]),
])  # fmt: skip
def test_symbols_of_a_derivation_are_not_those_of_the_reader(build):
    basis = build()
    theirs = set().union(*(s.free_symbols for s in basis.matrix), sp.symbols("a_0 b_1"))
    steps = basis.derivation.steps
    own = {s for step in steps for side in (step.left, step.right) for s in side.free_symbols}
    unknowns = own - theirs - {entry.symbol for entry in basis.geometry} - {basis.parameter}
    assert basis.derivation.is_proved and len(unknowns) >= basis.degree

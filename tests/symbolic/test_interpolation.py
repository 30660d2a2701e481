"""Splines and polynomials through given points: laws, SciPy as an oracle, exact vectors."""

from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline
from sympy import Rational as R

from symbolic import (
    BadType,
    BadValue,
    NotExact,
    Refuted,
    interpolating_spline,
    lagrange,
    lebesgue_function,
    minimum_acceleration,
    prove,
    runge_phenomenon,
)

t, a, b, c = sp.symbols("t a b c")
ENDS = ("natural", "clamped", "periodic", "not-a-knot")
rationals = st.fractions(min_value=-5, max_value=5, max_denominator=8)


@st.composite
def splines(draw):
    ends = draw(st.sampled_from(ENDS))
    count = draw(st.integers({"periodic": 3, "not-a-knot": 4}.get(ends, 2), 7))
    gaps = draw(st.lists(st.fractions(R(1, 8), 3, max_denominator=8),
                         min_size=count - 1, max_size=count - 1))  # fmt: skip
    knots = np.cumsum([draw(rationals), *gaps]).tolist()
    point = st.lists(rationals, min_size=2, max_size=2)
    points = draw(st.lists(point, min_size=count, max_size=count))
    if ends == "periodic":
        points[-1] = points[0]
    tangents = draw(st.lists(point, min_size=2, max_size=2)) if ends == "clamped" else None
    return interpolating_spline(points, knots, ends, tangents)


@settings(max_examples=12)
@given(splines())
def test_it_meets_all_its_conditions_and_scipy(spline):
    assert spline.derivation.is_proved
    knots = np.array(spline.knots, dtype=float)
    bc_type = spline.ends
    if bc_type == "clamped":
        bc_type = [(1, np.array(spline.slopes[i], dtype=float)) for i in (0, -1)]
    oracle = CubicSpline(knots, np.array(spline.points, dtype=float), bc_type=bc_type)
    for piece in spline.pieces:
        at = (piece.start + piece.end) / 2
        ours = np.array([x.subs(t, at) for x in piece.coordinates], dtype=float)
        assert ours == pytest.approx(oracle(float(at)), rel=1e-9, abs=1e-9)


@settings(max_examples=12)
@given(splines())
def test_bezier_points_slopes_and_accelerations_belong_to_the_pieces(spline):
    spans = zip(spline.pieces, spline.bezier_points, pairwise(spline.slopes),
                pairwise(spline.accelerations), strict=True)  # fmt: skip
    for piece, points, slopes, accelerations in spans:
        for axis, x in enumerate(piece.coordinates):
            polynomial = sp.Poly(x, t)
            for end, i in ((piece.start, 0), (piece.end, -1)):
                assert polynomial.eval(end) == points[i][axis]
                assert polynomial.diff(t).eval(end) == slopes[i][axis]
                assert polynomial.diff(t).diff(t).eval(end) == accelerations[i][axis]
            gap = piece.end - piece.start
            assert points[1][axis] == points[0][axis] + gap * slopes[0][axis] / 3
    squares = (sp.Poly(x, t).diff(t).diff(t) ** 2 for p in spline.pieces for x in p.coordinates)
    limits = (p[:2] for p in spline.pieces for _ in p.coordinates)
    total = sum(
        sp.integrate(s.as_expr(), (t, *ends)) for s, ends in zip(squares, limits, strict=True)
    )
    assert prove(spline.energy, total)


@pytest.mark.parametrize(("ends", "tangents"), [
    ("natural", None), ("periodic", None), ("clamped", [[1], [R(1, 2)]]),
])  # fmt: skip
def test_k12_cubic_splines_accelerate_least(ends, tangents):
    spline = interpolating_spline([[0], [2], [-1], [0]], [0, 1, R(5, 2), 3], ends, tangents)
    assert minimum_acceleration(spline).is_proved


def test_k12_for_all_data_and_knots_at_once():
    spline = interpolating_spline([[y] for y in sp.symbols("y0:3")], sp.symbols("u0:3"))
    assert minimum_acceleration(spline).is_proved


@given(st.lists(rationals, min_size=3, max_size=5))
def test_k12_another_interpolant_accelerates_more(values):
    """The one polynomial through the same points is one of the curves the theorem speaks of."""
    spline = interpolating_spline([[v] for v in values])
    polynomial = sp.Poly(lagrange(range(len(values))).curve([[v] for v in values])[0], t)
    square = polynomial.diff(t).diff(t) ** 2
    energy = square.integrate(t).eval(len(values) - 1) - square.integrate(t).eval(0)
    assert energy >= spline.energy


@pytest.mark.parametrize("n", range(1, 6))
def test_s01_counts(n):
    """4n unknowns; 2n conditions interpolate, 2(n - 1) join smoothly, 2 are missing."""
    spline = interpolating_spline([[i**2] for i in range(n + 1)])
    because = [step.because for step in spline.derivation.steps]
    assert sum(len(p.coordinates) * 4 for p in spline.pieces) == 4 * n
    assert sum("is point" in b for b in because) == 2 * n
    assert sum("both sides" in b for b in because) == 2 * (n - 1)
    assert sum("natural" in b for b in because) == 2


def test_a_straight_line_and_a_cubic_are_reproduced():
    line = interpolating_spline([[0, 0], [1, 2], [3, 6]], [0, 1, 3])
    assert line.energy == 0
    knots = [0, 1, 3, 4, 6]
    cubic = interpolating_spline([[k**3 - k] for k in knots], knots, "not-a-knot")
    for piece in cubic.pieces:
        assert prove(piece.coordinates[0], t**3 - t)


@pytest.mark.parametrize(("ends", "tangents"), [
    ("natural", None), ("periodic", None), ("not-a-knot", None), ("clamped", [[1], [sp.sqrt(3)]]),
])  # fmt: skip
def test_roots_in_points_and_knots(ends, tangents):
    knots = [0, 1, sp.sqrt(3), 4]
    spline = interpolating_spline([[0], [1], [sp.sqrt(2)], [0]], knots, ends, tangents)
    assert spline.derivation.is_proved


@pytest.mark.parametrize("ends", ["natural", "clamped", "periodic"])
@pytest.mark.parametrize("knot", [sp.sqrt(2), sp.cbrt(2), a])
def test_k12_holds_for_roots_and_symbols_in_short_lines(ends, knot):
    tangents = [[sp.sqrt(3)], [1]] if ends == "clamped" else None
    proof = minimum_acceleration(
        interpolating_spline([[0], [1], [0]], [0, knot, 8], ends, tangents)
    )
    integrals = [str(s.left) for s in proof.steps if isinstance(s.left, sp.Integral)]
    assert proof.is_proved and "h0" in integrals[0]
    assert not any("sqrt" in text or "2**(" in text for text in integrals)


def test_roots_and_symbols_stay_exact():
    spline = interpolating_spline([[0], [sp.sqrt(2)], [sp.Symbol("y")]], [0, 1, sp.Symbol("u")])
    assert spline.derivation.is_proved


def test_a_hundred_points_are_no_trouble():
    spline = interpolating_spline([[(7 * i) % 11] for i in range(100)])
    h = sp.S.One
    for i in range(1, 99):
        left, here, right = (spline.slopes[i + k][0] for k in (-1, 0, 1))
        chord = spline.points[i + 1][0] - spline.points[i - 1][0]
        assert (left + 4 * here + right) / h == 3 * chord


@pytest.mark.parametrize("nodes", [[0, 1], [0, 1, 2, 3], [-1, R(-1, 3), R(1, 2), 1]])
def test_the_lebesgue_function_is_the_sum_of_absolute_values(nodes):
    functions = lagrange(nodes).functions
    pieces = lebesgue_function(nodes)
    for piece in pieces:
        at = (2 * piece.start + piece.end) / 3
        assert piece.coordinates[0].subs(t, at) == sum(abs(f.subs(t, at)) for f in functions)
        assert piece.coordinates[0].subs(t, piece.start) == 1


def test_oscillation_grows_with_the_number_of_nodes():
    worst = [lebesgue_function(range(n + 1))[0].coordinates[0].subs(t, R(1, 2)) for n in (4, 8, 16)]
    assert 4 * worst[0] < worst[1] and 30 * worst[1] < worst[2]
    assert runge_phenomenon(5).is_proved
    errors = [abs(runge_phenomenon(n).steps[-1].right) for n in (5, 10, 20)]
    assert errors[0] < R(1, 8) and errors[1] > 1 and errors[2] > 39


def test_a_wrong_spline_is_refuted():
    spline = interpolating_spline([[0], [1], [0]])
    step = spline.derivation.steps[-1]
    assert isinstance(prove(step.left, step.right + sp.ones(1, 1)), Refuted)


@pytest.mark.parametrize(("call", "error", "words"), [
    (lambda: interpolating_spline([[0], [1]], [0, 0]), BadValue, "increasing"),
    (lambda: interpolating_spline([[0], [1]], [1, 0]), BadValue, "increasing"),
    (lambda: interpolating_spline([[0], [1]], [0, 1, 2]), BadValue, "one knot per point"),
    (lambda: interpolating_spline([[0]]), BadValue, "at least two"),
    (lambda: interpolating_spline([[0], [1]], [0, 0.5]), NotExact, "Rational"),
    (lambda: interpolating_spline([[0], [1]], [0, t]), BadValue, "other symbols than t"),
    (lambda: interpolating_spline([[0], [1]], [0, 1 + sp.Symbol("t", positive=True)]), BadValue,
     "other symbols than t"),
    (lambda: interpolating_spline([[0], [1]], [0, sp.I]), BadValue, "numbers, roots"),
    (lambda: interpolating_spline([[i] for i in range(4)], [a, b, a, c], "not-a-knot"), BadValue,
     "increasing knots, received a and then a"),
    (lambda: interpolating_spline([[0], [1], [0]], [0, a, -1], "periodic"), BadValue, "0 and then"),
    (lambda: interpolating_spline([[0], [1]], ends=np.array([1, 2])), BadValue, "ends as one of"),
    (lambda: interpolating_spline([[0], [1]], 3), BadType, "list of knots"),
    (lambda: interpolating_spline([[0], [t], [1]]), BadValue, "own parameter t"),
    (lambda: interpolating_spline([[0], [1]], ends="free"), BadValue, "not-a-knot"),
    (lambda: interpolating_spline([[0], [1]], ends="clamped"), BadValue, "tangents"),
    (lambda: interpolating_spline([[0], [1]], tangents=[[0], [0]]), BadValue, "tangents"),
    (lambda: interpolating_spline([[0], [1]], ends="clamped", tangents=[[0, 1], [0, 1]]), BadValue,
     "dimension 1"),
    (lambda: interpolating_spline([[0], [1], [2]], ends="periodic"), BadValue, "equal"),
    (lambda: interpolating_spline([[0], [0]], ends="periodic"), BadValue, "at least 3"),
    (lambda: interpolating_spline([[0], [1], [2]], ends="not-a-knot"), BadValue, "at least 4"),
    (lambda: minimum_acceleration(interpolating_spline([[i] for i in range(4)], ends="not-a-knot")),
     BadValue, "minimizes nothing"),
    (lambda: minimum_acceleration(3), BadType, "interpolating spline"),
    (lambda: lebesgue_function([1, 0]), BadValue, "increasing"),
    (lambda: lebesgue_function(sp.symbols("a b")), BadValue, "increasing"),
    (lambda: runge_phenomenon(0), BadValue, "degree"),
])  # fmt: skip
def test_bad_input_is_refused_in_a_sentence(call, error, words):
    with pytest.raises(error, match=f"{words}"):
        call()


def test_the_freedoms_of_another_curve_are_not_symbols_of_the_data():
    spline = interpolating_spline([[0], [sp.Symbol("d1")], [sp.Symbol("e0")]])
    proof = minimum_acceleration(spline)
    names = {s.name for step in proof.steps for s in step.right.free_symbols}
    assert proof.is_proved and {"v1", "w0"} <= names

"""Bad knots, parameters and points get one sentence: expected, received, remedy."""

import pickle

import pytest
import sympy as sp
from sympy import Rational as R

from symbolic import (
    BadType,
    BadValue,
    BSpline,
    KnotVector,
    NotExact,
    OutsideDomain,
    clamped_knots,
    closed_derivation,
    phantom_ends,
    repeat_ends,
    uniform_knots,
    wrap_points,
)

a, b, t = sp.symbols("a b t")
SPLINE = BSpline([0, 0, 0, 1, 2, 2, 2], 2)
POINTS = [[0], [1], [3], [4]]

KNOTS = {
    "decreasing": ([0, 1, R(1, 2), 2], 1, BadValue, r"u_2 = 1/2 after u_1 = 1"),
    "decreasing roots": ([0, sp.sqrt(3), sp.sqrt(2), 2], 1, BadValue, "do not decrease"),
    "decreasing behind a symbol": ([0, 2, a, 1, 3, 4], 2, BadValue, "u_3 = 1 after u_1 = 2"),
    "a symbol that comes again": ([a, b, a, 4], 1, BadValue, "u_2 = a after u_1 = b"),
    "a sum that decreases": ([0, a + 1, b, a, 5], 1, BadValue, r"u_3 = a after u_1 = a \+ 1"),
    "too few": ([0, 0, 1], 1, BadValue, "at least 4 knots for degree 1, received 3"),
    "too often": ([0, 0, 0, 1, 1], 1, BadValue, "at most degree \\+ 1 = 2, received 3 times 0"),
    "no length": ([-1, 0, 0, 1], 1, BadValue, "domain .* positive length"),
    "a float": ([0, 0.5, 1, 2], 1, NotExact, r"Rational\(1, 2\)"),
    "text": ("0011", 1, BadType, "list of knots"),
    "a text knot": ([0, "1", 2, 3], 1, BadType, "never parsed"),
    "the parameter": ([0, 0, t, 1, 1], 1, BadValue, "without the parameter t"),
    "not real": ([0, 1, sp.I, 3], 1, BadValue, "real knots"),
    "a function": ([0, 1, sp.sin(2), 3], 1, BadValue, "numbers, roots and symbols"),
    "infinity": ([0, 1, sp.oo, sp.oo], 1, BadValue, "finite"),
    "a negative degree": ([0, 1], -1, BadValue, "degree 0, 1, 2"),
    "a float degree": ([0, 1, 2, 3], 1.0, BadValue, "degree 0, 1, 2"),
    "a set": ({0, 1, 2, 3}, 1, BadType, "list of knots"),
}


@pytest.mark.parametrize("name", KNOTS)
def test_bad_knots(name):
    knots, degree, error, said = KNOTS[name]
    for maker in (KnotVector, BSpline):
        with pytest.raises(error, match=said) as caught:
            maker(knots, degree)
        assert str(caught.value).startswith("Expected ")


CALLS = {
    "left of the domain": (lambda: SPLINE.de_boor(POINTS, -1), OutsideDomain, r"\[0, 2\]"),
    "right of it": (lambda: SPLINE.insert(POINTS, 3), OutsideDomain, r"\[0, 2\]"),
    "in an outer span": (
        lambda: BSpline(range(6), 2).de_boor(POINTS[:3], 1), OutsideDomain, "2, 3"),
    "an integral too far": (lambda: SPLINE.integral(POINTS, 0, 3), OutsideDomain, r"\[0, 2\]"),
    "a float parameter": (lambda: SPLINE.de_boor(POINTS, 0.5), NotExact, r"Rational\(1, 2\)"),
    "a symbol without a span": (lambda: SPLINE.de_boor(POINTS, t), BadValue, "Say in which span"),
    "an empty span": (lambda: SPLINE.span_matrix(1), BadValue, "2, 3, received 1"),
    "a span outside": (lambda: SPLINE.de_boor(POINTS, t, 4), BadValue, "2, 3, received 4"),
    "a span as text": (lambda: SPLINE.triangle("2"), BadValue, "2, 3"),
    "too few points": (lambda: SPLINE.curve(POINTS[:3]), BadValue, "received 3"),
    "points for another degree": (lambda: SPLINE.to_bezier(POINTS * 2), BadValue, "received 8"),
    "points with t": (lambda: SPLINE.curve([[t], [1], [2], [3]]), BadValue, "parameter t"),
    "bare numbers": (lambda: SPLINE.curve([0, 1, 2, 3]), BadValue, "row of coordinates"),
    "one knot too often": (lambda: SPLINE.insert(POINTS, 1, 3), BadValue, "4 times 1"),
    "an end knot": (lambda: SPLINE.refine(POINTS, [2]), BadValue, "4 times 2"),
    "half an insertion": (lambda: SPLINE.insert(POINTS, 1, R(1, 2)), BadValue, "number of times"),
    "new knots as a number": (lambda: SPLINE.refine(POINTS, 1), BadType, "list of new knots"),
    "a negative order": (lambda: SPLINE.derivative(POINTS, -1), BadValue, "order 0, 1, 2"),
    "no joint": (lambda: SPLINE.continuity_derivation(R(1, 2)), BadValue, "inside the domain: 1"),
    "an end as a joint": (lambda: SPLINE.jumps(2), BadValue, "inside the domain: 1"),
    "no function": (lambda: SPLINE.to_piecewise(4), BadValue, "index 0 ... 3"),
    "no samples": (lambda: SPLINE.discretization_matrix(0), BadValue, "1, 2, ... per span"),
    "two degrees": (lambda: BSpline(SPLINE.knots, 3), BadValue, "degree 2"),
    "a degree that is no integer": (lambda: BSpline(SPLINE.knots, 2.0), BadValue, "degree 2"),
    "an endless insertion": (lambda: SPLINE.insert(POINTS, 1, 10**30), BadValue, "5 times 1"),
    "no degree": (lambda: BSpline([0, 0, 1, 1]), BadValue, "degree 0, 1, 2"),
    "few points for a degree": (lambda: uniform_knots(3, 3), BadValue, "at least 4"),
    "interior knots": (lambda: clamped_knots(5, 3, [R(1, 3), R(1, 2)]), BadValue, "1 interior"),
    "interior knots outside": (lambda: clamped_knots(5, 3, [2]), BadValue, "do not decrease"),
    "no repetition": (lambda: repeat_ends(POINTS, 0), BadValue, "1, 2, 3"),
    "one point alone": (lambda: phantom_ends([[0]]), BadValue, "two control points"),
    "a short loop": (lambda: wrap_points([[0], [1]], 3), BadValue, "at least 3"),
    "a loop of no degree": (lambda: closed_derivation(4, 0), BadValue, "degree 1, 2"),
    "a loop of no number": (lambda: closed_derivation([]), BadValue, "3, 4, ... for degree 3"),
    "a loop of text": (lambda: closed_derivation("x"), BadValue, "3, 4, ... for degree 3"),
    "a loop of few points": (lambda: closed_derivation(2), BadValue, "for degree 3, received 2"),
    "the derivative of a constant": (
        lambda: BSpline([0, 1], 0).derivative_derivation(0), BadValue, "degree 1, 2"),
    "a place that symbols hide": (
        lambda: BSpline([0, 0, a, 1, 1], 1).knots.span(R(1, 2)), BadValue, "place among the knots"),
}  # fmt: skip


@pytest.mark.parametrize("name", CALLS)
def test_bad_calls(name):
    call, error, said = CALLS[name]
    with pytest.raises(error, match=said) as caught:
        call()
    assert str(caught.value).startswith("Expected ")


def test_assumptions_do_not_tell_symbols_apart():
    knots = KnotVector([0, 0, sp.Symbol("a", positive=True), sp.Symbol("a"), 1, 1], 1)
    assert knots.multiplicity(a) == 2
    point = BSpline(knots).de_boor([[1], [2], [3], [4]], sp.Symbol("a", positive=True), 1)[-1][0]
    assert point == (2,)


def test_equal_knots_are_one_even_where_roots_are_free_generators():
    root = sum(map(sp.sqrt, (2, 3, 5, 7)))
    knots = KnotVector([0, 0, sp.Mul(root, root, evaluate=False), sp.expand(root**2), 99, 99], 1)
    assert knots.multiplicity(root**2) == 2


def test_control_points_are_never_called_as_the_knots_are():
    for names in ("P Q D", "P0 P1 x y", "P D QQ R"):
        knots = KnotVector((*sp.symbols(names), 3, 4), 1)
        derivation = BSpline(knots).continuity_derivation(knots.knots[2])
        points = derivation.steps[-1].right.free_symbols - set(knots.knots)
        assert derivation.is_proved and len(points) == 3


@pytest.mark.parametrize("knots", [SPLINE.knots.knots, [0, 0, 0, a, b, 2, 2, 2],
                                   [0, 0, 0, sp.sqrt(2), 2, 2, 2]])  # fmt: skip
def test_splines_survive_pickling(knots):
    spline = BSpline(knots, 2)
    functions = spline.functions
    again = pickle.loads(pickle.dumps(spline))
    assert again == spline and hash(again) == hash(spline)
    assert [f[0].polynomial for f in again.functions] == [f[0].polynomial for f in functions]


def test_any_exact_numbers_are_knots():
    import numpy as np

    assert KnotVector(np.array([0, 0, 1, 1]), np.int64(1)) == KnotVector((0, 0, 1, 1), 1)
    assert KnotVector(sp.Matrix([[0, 1]]).tolist()[0], 0).domain == (0, 1)

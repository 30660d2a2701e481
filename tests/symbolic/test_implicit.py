"""Implicit equations: laws over random curves, Sylvester's resultant as oracle, the inversion."""

import pickle

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Rational as R

from symbolic import (
    BadType,
    BadValue,
    NotExact,
    RationalBezier,
    arc,
    bezier,
    circle,
    implicitize,
    prove,
)

t, x, y, a, b = sp.symbols("t x y a b")

small = st.integers(-6, 6)
numbers = st.fractions(min_value=-4, max_value=4, max_denominator=6)


@st.composite
def curves(draw, highest=5):
    size = draw(st.integers(2, highest + 1))
    points = draw(st.lists(st.tuples(small, small), min_size=size, max_size=size, unique=True))
    weights = draw(st.lists(st.integers(1, 6), min_size=size, max_size=size))
    return RationalBezier(points, weights)


@settings(max_examples=30, deadline=None)
@given(curves(), numbers, numbers)
def test_the_equation_holds_on_the_curve_and_nowhere_else(curve, place, shift):
    found = implicitize(curve)
    numerators, w = curve.fractions
    assume(w.subs(t, R(place)) != 0)
    point = [R(p.subs(t, R(place)), w.subs(t, R(place))) for p in numerators]
    values = dict(zip((x, y), point, strict=True))
    assert found.polynomial.subs(values) == 0
    assert R(place) in found.inversion(point)
    beside = [point[0] + R(shift), point[1] + 1]
    on_curve = found.polynomial.subs(dict(zip((x, y), beside, strict=True))) == 0
    if found.inversion(beside):
        assert on_curve
    assert found.degree * found.tracing_number <= curve.degree


@settings(max_examples=8, deadline=None)
@given(curves(highest=4))
def test_sylvesters_resultant_is_a_multiple(curve):
    (big_x, big_y), w = curve.fractions
    resultant = sp.resultant(sp.Poly(x * w - big_x, t), sp.Poly(y * w - big_y, t)).as_expr()
    found = implicitize(curve)
    assume(resultant != 0)  # zero where both leading coefficients vanish: the degree is lower
    _, rest = sp.div(sp.Poly(resultant, x, y), sp.Poly(found.polynomial, x, y))
    assert rest.is_zero


@settings(max_examples=15, deadline=None)
@given(curves(highest=3), st.tuples(small, small, small), st.tuples(small, small, small))
def test_a_parametrization_put_into_another_is_traced_more_often(curve, above, below):
    up, down = (sp.Poly(c, t) for c in (above, below))
    ratio = sp.cancel(up.as_expr() / down.as_expr()) if not down.is_zero else sp.S.Zero
    assume(ratio.has(t))
    degree = max(sp.degree(part, t) for part in sp.fraction(ratio))
    once = implicitize(curve)
    again = implicitize([c.subs(t, ratio) for c in curve.curve()])
    assert again.polynomial == once.polynomial
    assert again.tracing_number == degree * once.tracing_number


KNOWN = {
    "parabola": ([t, t**2], x**2 - y, 1),
    "the circle, I23": ([(1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)], x**2 + y**2 - 1, 1),
    "hyperbola": ([t, 1 / t], x * y - 1, 1),
    "nodal cubic": ([t**2 - 1, t**3 - t], x**3 + x**2 - y**2, 1),
    "cusp": ([t**2, t**3], x**3 - y**2, 1),
    "folium": ([3 * t / (1 + t**3), 3 * t**2 / (1 + t**3)], x**3 - 3 * x * y + y**3, 1),
    "improper parabola": ([t**2, t**4], x**2 - y, 2),
    "symmetric under t -> 1/t": ([t + 1 / t, t**2 + 1 / t**2], x**2 - y - 2, 2),
    "twelve times": ([t**12, 2 * t**12], 2 * x - y, 12),
    "a line": ([2 * t, 1 - t], x + 2 * y - 2, 1),
    "a vertical line": ([5, t**2], x - 5, 2),
    "a horizontal line": ([t / (1 + t), 0], y, 1),
    "a common factor": ([(t - 1) * t / (t - 1), (t - 1) * t**2 / (t - 1)], x**2 - y, 1),
    "with a root": ([sp.sqrt(2) * t, t**2], x**2 - 2 * y, 1),
    "that keeps it": ([sp.sqrt(2) * t, t**3], x**3 - 2 * sp.sqrt(2) * y, 1),
    "with a symbol": ([a * t, b * t**2], b * x**2 - a**2 * y, 1),
    "rational numbers": ([t / 2, t**2 / 3], 4 * x**2 - 3 * y, 1),
}


@pytest.mark.parametrize("name", KNOWN)
def test_known_equations(name):
    curve, equation, traced = KNOWN[name]
    found = implicitize(curve)
    assert prove(found.polynomial, equation)
    assert found.tracing_number == traced
    assert found.derivation.is_proved


@pytest.mark.parametrize("n", (3, 6, 8))
def test_degree_eight_takes_no_time(n):
    points = [[(7 * i * i + 3 * i) % 11, (5 * i**3 + 2) % 13] for i in range(n + 1)]
    found = implicitize(RationalBezier(points, [1 + i % 3 for i in range(n + 1)]))
    assert (found.degree, found.tracing_number) == (n, 1)
    assert found.derivation.is_proved


def test_control_points_with_symbols():
    points = [[0, 0], [a, b], [1, 0]]
    found = implicitize(bezier(2).curve(points))
    assert found.derivation.is_proved
    numbers = found.polynomial.subs({a: 2, b: 3})
    same = implicitize(bezier(2).curve([[0, 0], [2, 3], [1, 0]])).polynomial
    assert sp.div(sp.Poly(numbers, x, y), sp.Poly(same, x, y))[1].is_zero


def test_generic_rational_quadratic():
    points = [sp.symbols(f"p{i} q{i}") for i in range(3)]
    found = implicitize(RationalBezier(points, sp.symbols("w0:3")))
    assert found.degree == 2
    assert found.derivation.is_proved


def test_arcs_have_the_equation_of_the_circle():
    assert implicitize(arc(sp.sqrt(2) / 2)).polynomial == x**2 + y**2 - 1
    assert implicitize(circle(radius=2).to_bezier()[2]).polynomial == x**2 + y**2 - 4


def test_inversion():
    node = implicitize([t**2 - 1, t**3 - t])
    assert node.inversion([0, 0]) == (-1, 1)
    assert node.inversion([3, 6]) == (2,)
    assert node.inversion([3, 5]) == ()
    assert implicitize([t**2, t**4]).inversion([2, 4]) == (-sp.sqrt(2), sp.sqrt(2))
    assert implicitize([t**2 + 1, t**3 + t]).inversion([0, 0]) == ()  # t = i and -i only
    tilted = implicitize([sp.sqrt(2) * t, t**3])
    assert tilted.inversion([sp.sqrt(2), 1]) == (1,)
    assert tilted.inversion([2, 2 * sp.sqrt(2)]) == (sp.sqrt(2),)
    assert implicitize([5, t**2]).inversion([5, 4]) == (-2, 2)
    quintic = implicitize([t**5 - t, t**5 + t])
    assert [root.is_real for root in quintic.inversion([1, 3])] == []
    (root,) = implicitize([t**3, 2 * t**3]).inversion([2, 4])
    assert prove(root**3, 2)
    reached_twice = implicitize([t / (1 + t**2), t**2 / (1 + t**4)])
    assert reached_twice.inversion([0, 0]) == (0, sp.oo)


def test_other_coordinates():
    u, v = sp.symbols("u v")
    assert implicitize([t + x, t**2], u, v).polynomial.free_symbols == {u, v, x}


GENERIC = [sp.symbols(f"a{i} b{i}") for i in range(6)]


@pytest.mark.parametrize("weights", [[1] * 4, sp.symbols("w0:4")], ids=["polynomial", "rational"])
def test_the_general_cubic_takes_no_time(weights):
    curve = RationalBezier(GENERIC[:4], weights)
    general = implicitize(curve)
    assert (general.degree, general.tracing_number) == (3, 1)
    symbols = sorted({s for row in (*curve.points, curve.weights) for s in row} - {1}, key=str)
    values = {s: 3 * k * k % 11 + 1 for k, s in enumerate(symbols)}
    points = [[x.subs(values) for x in row] for row in curve.points]
    one = implicitize(RationalBezier(points, [sp.S(w).subs(values) for w in weights])).polynomial
    quotient = sp.cancel(general.polynomial.subs(values) / one)
    assert quotient.is_number and quotient != 0


@pytest.mark.parametrize("curve", [[t**2, t**3], [a * t**2, t**3], [sp.sqrt(2) * t, a * t**3]])
def test_equations_survive_pickling(curve):
    equation = implicitize(curve)
    again = pickle.loads(pickle.dumps(equation))
    assert again == equation and again.parts == equation.parts
    assert again.derivation.is_proved


def test_steps_have_no_empty_terms():
    for curve in (
        [t**2, t**3],
        [2 * t, 3 * t + 1],
        [a * t, t**2],
        [1 / (1 + t**2), t / (1 + t**2)],
    ):
        for step in implicitize(curve).derivation.steps:
            left, right = str(step).partition(", because")[0].split(" = ")[:2]
            assert "+ 0" not in left and left != right


def test_symbols_hide_neither_common_factors_nor_curves_traced_twice():
    assert implicitize([a * t**2, t**4]).tracing_number == 2
    common = implicitize([(t - a) * t / (t - a), (t - a) * b / ((t - a) * (t + 1))])
    assert prove(common.polynomial, x * y + y - b) or prove(common.polynomial, b - x * y - y)
    assert implicitize([a * t, (a - 2) * t**3]).degree == 3  # the first example has a = 2/3


REFUSED = [
    (lambda: implicitize([1, 2]), BadValue, "one point"),
    (lambda: implicitize([t, t**17]), BadValue, "degree 16 or less"),
    (lambda: implicitize([t, a * t**11]), BadValue, "degree 10 or less where it has symbols"),
    (lambda: implicitize(RationalBezier(GENERIC[:6], [1] * 6)), BadValue, "fewer symbols"),
    (lambda: implicitize([t, t, t]), BadValue, "in the plane.*3 coordinates"),
    (lambda: implicitize([t * 0.5, t]), NotExact, "Rational"),
    (lambda: implicitize([sp.sin(t), t]), BadValue, "symbol in its place"),
    (lambda: implicitize([x * t, t**2]), BadValue, "other symbols"),
    (lambda: implicitize([t, t**2], t, y), BadValue, "other than t"),
    (lambda: implicitize([t, t**2], x, x), BadValue, "two symbols"),
    (lambda: implicitize([t, t**2], "x", y), BadType, "two symbols"),
    (lambda: implicitize(5), BadType, "list of coordinates"),
    (lambda: implicitize(circle()), BadType, "one for every span"),
    (lambda: implicitize([sp.I * t, t**2]), BadValue, "real coordinates"),
    (lambda: implicitize([t, t**2 * sum(map(sp.sqrt, (2, 3, 5, 7)))]), BadValue, "fewer"),
    (lambda: implicitize([t, t**2]).inversion([1, 2, 3]), BadValue, "in the plane"),
    (lambda: implicitize([t, t**2]).inversion([a, a**2]), BadValue, "without symbols"),
]  # fmt: skip


@pytest.mark.parametrize("case", range(len(REFUSED)))
def test_what_is_refused(case):
    call, error, said = REFUSED[case]
    with pytest.raises(error, match=said) as caught:
        call()
    assert str(caught.value).startswith("Expected ")

"""Verdicts beyond polynomials: roots, angles, pieces, and functions that algebra does not know."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import (
    Abs,
    Derivative,
    Eq,
    Heaviside,
    I,
    Matrix,
    Max,
    Min,
    Not,
    Piecewise,
    Rational,
    Subs,
    Symbol,
    atan,
    cos,
    cot,
    exp,
    log,
    pi,
    sec,
    sign,
    sin,
    sqrt,
    tan,
)  # fmt: skip

from symbolic import Proved, Refuted, Undecided, check, prove
from symbolic.intervals import differ, enclosure
from symbolic.signs import sign as sign_of

t, x, y, a, b, u, v, h = sp.symbols("t x y a b u v h")
some = settings(max_examples=40, deadline=None)
rationals = st.fractions(-3, 3, max_denominator=4).map(
    lambda q: Rational(q.numerator, q.denominator)
)


def rotation(angle):
    return Matrix([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]])


def step(*pieces):
    return Piecewise(*pieces)


MANY = sum(sqrt(p) for p in (2, 3, 5, 7, 11))
WITHIN = sp.Interval(0, 1).as_relational(t)
RADIUS = (3 + cos(u)) ** 2
PROVED = [
    # roots
    (sqrt(2) * sqrt(3), sqrt(6)),
    (12 ** Rational(1, 4) * 3 ** Rational(1, 4), sqrt(6)),
    (sqrt(5 + 2 * sqrt(6)), sqrt(2) + sqrt(3)),
    ((-8) ** Rational(1, 3), 1 + sqrt(3) * I),
    (MANY**2, sp.expand(MANY**2)),
    (1 / (sqrt(2) + sqrt(3) + sqrt(5)), (2 * sqrt(3) + 3 * sqrt(2) - sqrt(30)) / 12),
    (sqrt(1 + t**2) ** 3 / (1 + t**2), sqrt(1 + t**2)),
    (1 / sqrt(1 + t**2), sqrt(1 + t**2) / (1 + t**2)),
    (sqrt(4 + 4 * t**2), 2 * sqrt(t**2 + 1)),
    (sqrt((1 + t) ** 2 + t**2), sqrt(2 * t**2 + 2 * t + 1)),
    # angles
    (sin(t) ** 2 + cos(t) ** 2, 1),
    (cos(5 * t), 16 * cos(t) ** 5 - 20 * cos(t) ** 3 + 5 * cos(t)),
    (tan(t / 2), sin(t) / (1 + cos(t))),
    (cos(t / 2) ** 2, (1 + cos(t)) / 2),
    (tan(a + b), (tan(a) + tan(b)) / (1 - tan(a) * tan(b))),
    (sec(t) ** 2 - tan(t) ** 2, tan(t) * cot(t)),
    (sin(t + pi / 3), sin(t) / 2 + sqrt(3) / 2 * cos(t)),
    (rotation(a) * rotation(b), rotation(a + b)),
    (rotation(a) ** 3, rotation(3 * a)),
    (((1 - h**2) / (1 + h**2)) ** 2 + (2 * h / (1 + h**2)) ** 2, 1),
    (cos(2 * atan(h)), (1 - h**2) / (1 + h**2)),
    ((cos(u) * cos(v)) ** 2 + (cos(u) * sin(v)) ** 2 + sin(u) ** 2, 1),
    ((x * cos(u) * cos(v) / x) ** 2 + (y * cos(u) * sin(v) / y) ** 2 + sin(u) ** 2, 1),
    ((RADIUS + sin(u) ** 2 + 8) ** 2, 36 * (RADIUS * cos(v) ** 2 + RADIUS * sin(v) ** 2)),
    (cos(pi / 5), (1 + sqrt(5)) / 4),
    (sin(pi / 8) ** 2, (1 - sqrt(2) / 2) / 2),
    (sin(2), 2 * sin(1) * cos(1)),
    (Derivative(sin(t) ** 2, t), sin(2 * t)),
    # pieces
    (Max(0, t - 1) ** 2, step((0, t < 1), ((t - 1) ** 2, True))),
    (Abs(t - 1) + Abs(t + 1), step((-2 * t, t <= -1), (2, t < 1), (2 * t, True))),
    (Abs(Abs(t) - 1), step((-t - 1, t < -1), (t + 1, t < 0), (1 - t, t < 1), (t - 1, True))),
    (Abs(x) + Abs(y), Max(x, -x) + Max(y, -y)),
    (step((t, t < 1), (2 - t, True)), step((t, sp.Ge(1, t)), (2 - t, True))),
    (step((1, (t < 0) | (t > 1)), (0, True)), 1 - step((1, WITHIN), (0, True))),
    (step((a * t, t < sqrt(2)), (b, True)), step((b, t >= sqrt(2)), (a * t, True))),
    (step((t, (t >= 0) & (t < 1))), step((2 * t - t, (t >= 0) & (t < 1)))),
    (Heaviside(t) * t, Max(0, t)),
    (step((Derivative(t**2, t), t < 1), (2, True)), Min(2 * t, 2)),
    (Derivative(t**2, t), Max(0, t) * 2 + Min(0, t) * 2),
    (Subs(Max(t, 0), t, x), Max(x, 0)),
    (sign(t) * t, Abs(t)),
    (Min(t, 1) + Max(t, 1), t + 1),
    (step((sin(t) ** 2, t < 1), (1 - cos(t) ** 2, True)), (1 - cos(2 * t)) / 2),
    # substitutions and derivatives
    (Subs(Derivative(t**3 * x, t), t, a), 3 * a**2 * x),
    (Subs(x + 2 * y, (x, y), (a, x)), a + 2 * x),
    (Subs(x + 2 * y, (x, y), (y, x)), y + 2 * x),
    (Derivative(t / (1 + t), (t, 2)), -2 / (1 + t) ** 3),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right"), PROVED, ids=str)
def test_proved(left, right):
    assert isinstance(prove(left, right), Proved)
    assert isinstance(prove(right, left), Proved)
    if isinstance(left, sp.Expr):
        assert isinstance(prove(left + Rational(1, 10**6), right), Refuted)


@pytest.mark.parametrize(("left", "right", "witness"), [
    (cos(t), sin(t), {}),
    (rotation(a) * rotation(b), rotation(a - b), {}),
    (cos(1000 * t), 1, {}),
    (pi, Rational(22, 7), {}),
    (pi**2 * t, pi * t, {}),
    (sqrt(5 - 2 * sqrt(6)), sqrt(2) - sqrt(3), {}),
    ((-8) ** Rational(1, 3), -2, {}),
    (2 ** Rational(1, 10**6), 1, {}),
    (sin(t), t, {t: 1}),
    (exp(t), 1 + t + t**2 / 2, {t: 1}),
    (t * cos(t), cos(t), {}),
    (sin(t) * sin(sqrt(2) * t), 1, {}),
    (sqrt(1 + t**2), 1 + t, {t: 1}),
    (sp.cos(pi / 7) - cos(2 * pi / 7) + cos(3 * pi / 7), Rational(1, 3), {}),
    (Abs(t), t, {t: -1}),
    (step((1, Eq(t, 2)), (0, True)), 0, {t: 2}),
    (step((1, Not(Eq(t, sqrt(2)))), (0, True)), 1, {t: sqrt(2)}),
    (step((1, t < 1), (0, True)), step((1, t <= 1), (0, True)), {t: 1}),
    (step((1, 3 * t < 1), (0, True)), step((1, 2 * t < 1), (0, True)), {t: Rational(1, 3)}),
    (step((t, t < 1), (t**2, True)), t, {t: 2}),
    (step((2 * t, t < 1), (0, t < 10**6), (1, True)), step((2 * t, t < 1), (0, True)), {t: 10**6}),
    (step((sin(t) ** 2, t < 1), (1 + cos(t) ** 2, True)), sin(t) ** 2, {}),
])  # fmt: skip
def test_refuted_by_a_witness(left, right, witness):
    verdict = prove(left, right)
    assert isinstance(verdict, Refuted)
    assert all(verdict.witness[symbol] == value for symbol, value in witness.items())
    assert abs((verdict.left - verdict.right).evalf(30)) > Rational(1, 10**9)
    if isinstance(left, sp.Expr):
        values = {s: verdict.witness.get(s, s) for s in left.free_symbols}
        assert abs((left.subs(values) - verdict.left).evalf(30)) < Rational(1, 10**25)


@pytest.mark.parametrize(("left", "right"), [
    # nowhere defined, however it is written
    (1 / (sin(t) ** 2 + cos(t) ** 2 - 1), 1 / (sin(t) ** 2 + cos(t) ** 2 - 1)),
    (x / (sqrt(x**2) - x), x / (sqrt(x**2) - x)),
    (1 / (sqrt(5 + 2 * sqrt(6)) - sqrt(2) - sqrt(3)), 3),
    (exp(1 / ((t - 1) * (t + 1) - t**2 + 1)), exp(1 / ((t - 1) * (t + 1) - t**2 + 1))),
    (Subs((t**2 + t) / t, t, 0), 1),
    # defined in different places
    (step((1, (t >= 0) & (t < 1))), 1),
    (step((1 / t, t >= 0), (0, True)), step((1 / t, t > 0), (0, True))),
    # true or false, as one takes it
    (sqrt(x) * sqrt(y), sqrt(x * y)),
    (sqrt(-x), I * sqrt(x)),
    (Max(x, y), (x + y + Abs(x - y)) / 2),
    (step((1, t < a), (0, True)), 1),
    (Abs(t - sqrt(2) * I), 1),
    (2 ** (2 ** (t + 2000)), 1),
    (Derivative(Abs(t), t), sign(t)),
    (Derivative(step((0, t < 0), (t, True)), t), step((0, t < 0), (1, True))),
    (Symbol("f") * sp.Function("f")(t), sp.Function("g")(t)),
    (log(2 * t), log(2) + log(t)),
    (Derivative(1 / (1 + t**2), (t, 400)), 0),
])  # fmt: skip
def test_undecided_rather_than_wrong(left, right):
    assert isinstance(prove(left, right), Undecided)


angles = st.builds(lambda i, j, k: i * a / 2 + j * b + k * pi / 6, *[st.integers(-3, 3)] * 3)
waves = st.builds(lambda f, angle: f(angle), st.sampled_from([sin, cos]), angles)
trigonometric = st.lists(st.tuples(rationals, waves, waves), min_size=1, max_size=3).map(
    lambda terms: sum(c * p * q for c, p, q in terms)
)


@some
@given(trigonometric, rationals)
def test_addition_theorems_prove_and_witnesses_refute(expression, extra):
    same = sp.expand_trig(sp.sympify(expression))
    assert prove(expression, same)
    verdict = prove(expression, same + extra * sin(a / 2))
    assert isinstance(verdict, Refuted if extra else Proved)
    if extra:
        there = sp.sympify(expression).subs(verdict.witness)
        assert abs((there - verdict.left).evalf(30)) < Rational(1, 10**25)


roots = st.builds(
    lambda p, q, n: (p / q) ** Rational(1, n),
    st.integers(1, 12).map(sp.Integer), st.integers(1, 6), st.sampled_from([2, 2, 3]),
)  # fmt: skip
sums = st.lists(st.tuples(rationals, roots), min_size=1, max_size=3).map(
    lambda terms: sp.Add(*(c * r for c, r in terms))
)


@some
@given(sums, sums)
def test_roots_agree_with_many_digits(left, right):
    equal = prove(left, right)
    far = abs((left - right).evalf(60)) > Rational(1, 10**40)
    assert isinstance(equal, Refuted if far else Proved)
    assert prove(left * right, sp.expand(left * right))
    assert sign_of(left - right) == (0 if not far else (1 if (left - right).evalf(60) > 0 else -1))


polynomials = st.lists(rationals, min_size=1, max_size=3).map(lambda c: sp.Poly(c, t).as_expr())


@some
@given(st.sets(rationals, min_size=1, max_size=4), st.data())
def test_pieces_are_sums_of_steps_and_a_change_in_one_piece_is_found(breaks, data):
    ends = sorted(breaks)
    formulas = [data.draw(polynomials) for _ in range(len(ends) + 1)]
    pieces = [(f, t < end) for f, end in zip(formulas, ends, strict=False)]
    whole = Piecewise(*pieces, (formulas[-1], True))
    jumps = zip(formulas, formulas[1:], ends, strict=False)
    steps = formulas[0] + sum((after - f) * Heaviside(t - end, 1) for f, after, end in jumps)
    assert prove(whole, steps)
    place = data.draw(st.integers(0, len(ends)))
    changed = [*formulas]
    changed[place] += data.draw(rationals.filter(bool)) * t**2
    pieces = [(f, t < end) for f, end in zip(changed, ends, strict=False)]
    verdict = prove(Piecewise(*pieces, (changed[-1], True)), steps)
    assert isinstance(verdict, Refuted)
    at = verdict.witness[t]
    assert place == sum(bool(end <= at) for end in ends)
    assert (verdict.left, verdict.right) == (
        changed[place].subs(t, at),
        formulas[place].subs(t, at),
    )
    assert isinstance(prove(Piecewise((7 + whole, Eq(t, ends[0])), (whole, True)), steps), Refuted)


@some
@given(st.recursive(st.sampled_from([x, y, sp.Integer(2), pi]), lambda e: st.one_of(
    st.tuples(e, e).map(lambda p: p[0] + p[1]), st.tuples(e, e).map(lambda p: p[0] * p[1]),
    st.tuples(st.sampled_from([sin, cos, exp, Abs, sp.tanh]), e).map(lambda p: p[0](p[1])),
    e.map(lambda p: sqrt(1 + p**2)), e.map(lambda p: 1 / (2 + p**2))), max_leaves=6))  # fmt: skip
def test_enclosures_hold_what_they_enclose(expression):
    values = {x: Rational(1, 3), y: Rational(-2)}
    box = enclosure(expression, values)
    if box is not None:
        exact = expression.subs(values).evalf(90)
        assert not differ(box, enclosure(sp.Rational(exact)))
        assert box.delta < 10 ** sp.Integer(-20) * max(1, abs(exact)) or abs(exact) > 10**40


def test_the_reason_says_where():
    assert "on the interval (-oo, 0) of t" in str(prove(step((1, t >= 0)), 1))
    assert "at t = 0" in str(prove(step((1, t > 0), (1, t < 0)), 1))
    assert "2 intervals" in str(prove(Max(0, t), step((0, t < 0), (t, True))))


def test_answers_are_checked_by_the_same_verdicts():
    assert check(2 * sin(t) * cos(t), sin(2 * t)).diagnosis == "Right."
    hat = step((t, t < 1), (2 - t, True))
    assert check(Min(t, 2 - t), hat).diagnosis == "Right."
    assert "at t = 2 your answer gives 2" in check(t, hat).diagnosis.lower()
    assert check(-exp(t), exp(t)).diagnosis == "The sign is reversed."
    assert "could not be decided" in check(log(2 * t), log(2) + log(t)).diagnosis


f = sp.Function("f")
ZERO = 1 / (1 + sqrt(2)) - (sqrt(2) - 1)  # that only multiplying out sees
NULL = sin(t) ** 2 + cos(t) ** 2 - 1
NOWHERE = step((1, (x > 1) & Eq(x, 0)))
n, positive = Symbol("n", integer=True), Symbol("p", positive=True)


@pytest.mark.parametrize(("left", "right"), [
    # a function has no value where its argument is a pole
    *((function(NULL + pole), function(NULL + pole)) for function, pole in (
        (sp.coth, 0), (sp.csch, 0), (sp.gamma, -1), (sp.factorial, -1), (sp.zeta, 1), (sp.atanh, 1),
        (sp.Ei, 0), (log, 0), (cot, 0), (sp.arg, 0))),
    # neither a number nor a function
    (sp.sin(sp.oo), sp.sin(sp.oo)),
    (sp.O(t), sp.O(t)),
    (sp.Symbol("A", commutative=False) * sp.Symbol("B", commutative=False),
     sp.Symbol("B", commutative=False) * sp.Symbol("A", commutative=False)),
    (sp.IndexedBase("x")[sp.Idx("i")] * 2, 0),
    ((-1) ** Rational(1, 3) / NULL - (Rational(1, 2) + sqrt(3) * I / 2) / NULL, 0),
    # nowhere defined, though at t = 0 it is multiplied by zero
    (Abs(t) * NOWHERE, x),
    (Abs(t) / ((x - 1) * (x + 1) - x**2 + 1), x),
    # what is meant is not certain
    (sp.Integral((1 + t) ** 2, t), (1 + t) ** 3 / 3),
    (sp.Sum(t, (t, 5, 1)), 0),
    (Subs(Subs(t * x, t, x), x, 2), 2 * x),
    (Subs(x + 2 * Max(y, 0), (x, y), (y, x)), y + 2 * Max(x, 0)),  # SymPy puts in one by one
    # true for what was declared
    (sin(n * pi / 2) * cos(n * pi / 2), 0),
    (sp.Mul((-1) ** n, (-1) ** n, evaluate=False), 1),
])  # fmt: skip
def test_undecided_rather_than_vacuous_or_ambiguous(left, right):
    assert isinstance(prove(left, right), Undecided)


@pytest.mark.parametrize(("left", "right"), [
    (sp.gamma(t) + sp.gamma(t), 2 * sp.gamma(t)),
    (sp.sech(t) * sp.cosh(t) * sp.coth(t) / sp.cosh(t), sp.sech(t) * sp.coth(t)),
    (Abs(t) * Derivative(f(t), t), Max(t, -t) * Derivative(f(t), t)),
    (Abs(t) * Subs(Derivative(f(t), t), t, 2), Max(t, -t) * Subs(Derivative(f(x), x), x, 2)),
])  # fmt: skip
def test_functions_that_are_not_known_are_generators(left, right):
    assert isinstance(prove(left, right), Proved)


@pytest.mark.parametrize(("left", "right"), [
    (sp.expand(ZERO + t) / (ZERO + t), 2),
    (sign(t) / x, step((1 / x, t > 0), (-1 / x, t < 0), (1, True))),
    (Heaviside(t) * log(x) + t, t),
    (tan(x) * cot(x), 2),
    (tan(x) * cot(x) * t, 2 * t),
    (sp.csc(2 * x) - 1 / (2 * sin(x) * cos(x)), 1),
    ((-1) ** Rational(1, 3) / x - (Rational(1, 2) + sqrt(3) * I / 2) / x, 1),
    (t * Subs(1 / x, x, t), 2),
    (Subs(x / x**2, x, sin(t)) * sin(t), 2),
    (positive * (positive - 1), 0),
    (n * (n - 1) * (n - 2), 0),
    (Symbol("q", nonnegative=True) ** 2, Symbol("q", nonnegative=True)),
    (Symbol("z", imaginary=True) ** 2, 1),
    (Abs(Symbol("n", integer=True) - Rational(3, 2)), Symbol("n", integer=True)),
])  # fmt: skip
def test_both_sides_are_defined_at_a_witness_which_may_be_a_value(left, right):
    verdict = prove(left, right)
    assert isinstance(verdict, Refuted)
    for side, value in ((left, verdict.left), (right, verdict.right)):
        given = {s: verdict.witness.get(Symbol(s.name), s) for s in sp.sympify(side).free_symbols}
        for symbol, number in given.items():
            assert all(getattr(number, f"is_{k}") == v for k, v in symbol.assumptions0.items())
        there = sp.sympify(side).subs(given).doit()
        assert abs((there - value).evalf(30)) < Rational(1, 10**25)


@pytest.mark.parametrize(("left", "right"), [
    (sp.Integral(t**2, (t, a, b)), (b**3 - a**3) / 3),
    (sp.Integral(x * t**2 / (x + 1), (t, 0, x)), x**4 / (3 * (x + 1))),
    (sp.Integral(t, (t, 0, t)) + t, t**2 / 2 + t),
    (sp.Derivative(sp.Integral(x**2, (x, 0, t)), t), t**2),
    (sp.Integral(sqrt(2) * t, (t, 0, 1)), sqrt(2) / 2),
    (sp.Integral(5, (t, a, b)), 5 * (b - a)),
])  # fmt: skip
def test_integrals_of_polynomials_are_carried_out(left, right):
    assert prove(left, right)
    assert isinstance(prove(left, right + t), Refuted)


@pytest.mark.parametrize("integral", [
    sp.Integral(1 / t, (t, -1, 1)), sp.Integral(t / (t + x), (t, 0, 1)), sp.Integral(t, t),
])  # fmt: skip
def test_other_integrals_are_undecided(integral):
    assert isinstance(prove(integral, 0), Undecided)


def test_entries_of_matrices_mean_what_they_mean_alone():
    exchanged = sp.Subs(a * b**2, (a, b), (b, a))
    for matrix in (sp.Matrix([[exchanged]]), sp.MatMul(sp.eye(1), sp.ImmutableMatrix([[exchanged]]),
                                                       evaluate=False)):  # fmt: skip
        assert prove(matrix, [[b * a**2]])


def test_a_branch_without_value_that_is_not_taken_hides_nothing():
    """In two variables, one is resolved before the other: a gap in x must not leave out y < 0."""
    gap = sp.Piecewise((-x / 2, x >= 1))
    left = sp.Piecewise((sp.Piecewise((y, x > -2), (x, True)), y < 0), (gap, True))
    right = sp.Piecewise((sp.Piecewise((y, x > -2), (x / (y + 2), True)), y < 0), (gap, True))
    verdict = prove(left, right)
    assert isinstance(verdict, Refuted)
    assert left.subs(verdict.witness) == verdict.left != verdict.right
    assert right.subs(verdict.witness) == verdict.right
    assert prove(left, left + 0 * y)


def test_a_witness_for_declared_symbols_is_no_hidden_pole():
    negative = sp.Symbol("x", nonpositive=True)
    left = 1 / ((1 / negative) ** sp.Rational(-1, 3) - 1) - 3
    verdict = prove(left, negative)
    assert not verdict
    assert isinstance(verdict, Undecided) or verdict.witness[sp.Symbol("x")] != 0


def test_a_divisor_that_cancels_at_a_break_point_keeps_witnesses_away():
    quotient = 1 / ((-3 * x * y - x) / (-x * y + x) + 1)  # at y = 2 it is 1/8, but for x = 0
    step = sp.Piecewise((1, sp.Eq(y, 2)), (0, True))
    for rest in (0, sin(x), sin(sp.Abs(x - Rational(3, 4)))):
        verdict = prove(step + quotient + rest, quotient + rest)
        assert isinstance(verdict, Refuted) and verdict.witness[x] != 0


@pytest.mark.parametrize(("left", "right"), [
    (sp.Sum(1 / (1 + 1 / t), (t, 0, 1)), Rational(1, 2)),
    (1 / sp.Sum(x / (t - 1), (t, -1, 1)), 0),
    (sp.Subs(1 / (1 + sp.log(x)), x, 0), 0),
    (sp.Abs(y) * sp.Subs(1 / (1 + 1 / x), x, 0), 0),
])  # fmt: skip
def test_what_divides_by_zero_on_the_way_equals_nothing(left, right):
    """SymPy takes 1/(1 + 1/0) for 0."""
    assert isinstance(prove(left, right), Undecided)


def test_what_stands_inside_is_carried_out_first():
    assert prove(sp.Subs(sp.Derivative(sin(y), x), y, x + 1), 0)
    assert prove(sp.Sum(sin(a * x), (a, 1, 2)), sin(x) + sin(2 * x))
    assert prove(sp.Product(x + a, (a, 0, 2)), x * (x + 1) * (x + 2))

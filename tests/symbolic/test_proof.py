"""Verdicts are never wrong: proved means equal, refuted means the witness shows it."""

import pickle
from functools import reduce

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import I, Rational, pi, sin, sqrt

from symbolic import BadType, Derivation, NotExact, Proved, Refuted, Step, Undecided, check, prove
from symbolic.errors import BadValue

t, x, y = symbols = sp.symbols("t x y")

leaves = st.one_of(
    st.sampled_from(symbols), st.integers(-4, 4).map(sp.Integer), st.just(Rational(1, 3))
)


def _combine(children):
    return st.one_of(
        st.tuples(children, children).map(lambda ab: ab[0] + ab[1]),
        st.tuples(children, children).map(lambda ab: ab[0] * ab[1]),
        st.tuples(children, st.integers(0, 4)).map(lambda ab: ab[0] ** ab[1]),
        st.tuples(children, children).map(lambda ab: ab[0] / (ab[1] ** 2 + 1)),
    )


expressions = st.recursive(leaves, _combine, max_leaves=10)


@settings(max_examples=150, deadline=None)
@given(expressions, expressions)
def test_verdicts_agree_with_an_independent_normal_form(left, right):
    equal = sp.cancel(sp.together(left - right)) == 0
    verdict = prove(left, right)
    assert isinstance(verdict, Proved if equal else Refuted)
    if isinstance(verdict, Refuted):
        assert left.subs(verdict.witness) == verdict.left
        assert right.subs(verdict.witness) == verdict.right
        assert verdict.left != verdict.right


@settings(max_examples=60, deadline=None)
@given(expressions)
def test_rewriting_never_changes_the_verdict(expression):
    assert prove(expression, sp.expand(expression))
    assert prove(expression, sp.together(expression))
    assert isinstance(prove(expression, expression + Rational(1, 10**9)), Refuted)


@pytest.mark.parametrize(("left", "right"), [
    (sqrt(2) * (1 + sqrt(2)) * t, sqrt(2) * t + 2 * t),
    (1 / (sqrt(3) - sqrt(2)), sqrt(3) + sqrt(2)),
    ((1 + I * t) * (1 - I * t), 1 + t**2),
    (1 / (t - 1) - 1 / (t + 1), 2 / (t**2 - 1)),
    (sin(x) * (1 + t), sin(x) + t * sin(x)),
    (pi * (t + 1), pi + pi * t),
    (sp.Symbol("t", real=True), t),
    (sp.Sum(t**2, (t, 1, 4)), 30),
    (sp.Derivative(t**3, t), 3 * t**2),
    (sp.Matrix([[1, t], [0, 1]]) ** 2, [[1, 2 * t], [0, 1]]),
    (sp.MatMul(sp.Matrix([[t, 1]]), sp.Matrix([2, 3]), evaluate=False), [[2 * t + 3]]),
])  # fmt: skip
def test_proved(left, right):
    assert isinstance(prove(left, right), Proved)


@pytest.mark.parametrize(("left", "right"), [
    (sp.log(2 * t), sp.log(2) + sp.log(t)),
    (sqrt(t**2) * sqrt(x**2), sqrt(t**2 * x**2)),
    (sqrt(x) * sqrt(y), sqrt(x * y)),
    (sp.Abs(t * x), sp.Abs(t) * sp.Abs(x)),
    (1 / (x * y - y * x + (t - 1) * (t + 1) - t**2 + 1), 1),
    ((x + y) ** 10_000, x),
])  # fmt: skip
def test_undecided_rather_than_wrong(left, right):
    assert isinstance(prove(left, right), Undecided)


def test_a_witness_avoids_the_poles_of_both_sides():
    verdict = prove(1 / t, 1 / (t - 1))
    assert isinstance(verdict, Refuted)
    assert verdict.witness[t] not in (0, 1)


def test_the_wrong_entry_is_named():
    verdict = prove(sp.eye(3), sp.Matrix([[1, 0, 0], [0, 1, 0], [0, 5, 1]]))
    assert isinstance(verdict, Refuted)
    assert verdict.where == "row 3, column 2"
    assert prove([1, 2, t], [1, 2, x]).where == "entry 3"


def test_shared_subexpressions_are_visited_once():
    """As a tree this expression has 2^200 leaves."""
    left = right = t
    for _ in range(200):
        left, right = left + x * 0 + left, 2 * right
    assert prove(left, right)
    deep = t
    for _ in range(60):
        deep = (deep + x) / 2 + (deep - x) / 2
    assert prove(deep, t)


@pytest.mark.parametrize(("left", "right", "error"), [
    (0.5, Rational(1, 2), NotExact),
    (t * 0.5, t / 2, NotExact),
    (float("nan"), 0, BadValue),
    ("t + 1", t + 1, BadType),
    (sp.Eq(t, x), t, BadType),
    ([1, 2], [1, 2, 3], BadType),
    (sp.eye(2), sp.eye(3), BadType),
    (True, 1, BadType),
])  # fmt: skip
def test_bad_input_is_refused_in_a_sentence(left, right, error):
    with pytest.raises(error, match="Expected .*, received .*\\. "):
        prove(left, right)


def test_text_is_never_evaluated():
    with pytest.raises(BadType):
        prove("__import__('os').system('exit 1')", 0)


def test_only_proved_is_true_in_a_condition():
    assert prove(t, t)
    assert not prove(t, x)
    assert not prove(sp.Abs(x * y), x * y)


def test_a_step_that_fails_never_reads_as_if_it_held():
    true = Step(t + t, 2 * t, "add")
    false = Step(t + t, t**2, "add")
    open_ = Step(sp.log(2 * t), sp.log(2) + sp.log(t), "hope")
    assert r"= 2 t \quad \checkmark" in true._repr_latex_()
    assert r"2 t \neq t^{2}" in false._repr_latex_() and "at t = 1" in false._repr_latex_()
    assert r"\overset{?}{=}" in open_._repr_latex_() and "undecided: " in open_._repr_latex_()
    assert "=" not in str(false).partition(":")[0]
    assert "NOT PROVED" in str(open_)
    for step in (false, open_):
        derivation = Derivation("Doubling", (true, step), source="nowhere")
        assert not derivation.is_proved
        for text in (str(derivation), repr(derivation), derivation._repr_latex_()):
            assert "Doubling [nowhere] (NOT PROVED: 1 of 2 steps fail)" in text
            assert r"\checkmark" not in text.rpartition("2.")[2]


def test_pieces_are_shown_in_both_forms():
    hat = sp.Piecewise((t, (t >= 0) & (t < 1)), (2 - t, (t >= 1) & (t <= 2)), (0, True))
    step = Step(hat, sp.Max(0, 1 - sp.Abs(t - 1)), "the hat function")
    assert step.verify()
    assert str(step).startswith("t if t is at least 0 and t is less than 1, 2 - t if ")
    assert r"\begin{cases}" in step._repr_latex_()
    point = sp.Piecewise((1, sp.Eq(t, 1)), (2, sp.Ne(t, 2)))
    assert str(Step(point, 1, "")).startswith("1 if t is equal to 1, 2 if t is different from 2 is")


def test_errors_survive_pickling():
    with pytest.raises(NotExact) as caught:
        prove(0.1, 1)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


@pytest.mark.parametrize("side", [
    (i for i in (1, 2)), map(abs, [1, 2]), {1: 5, 2: 6}, {1, 2}, frozenset((1,)),
], ids=["generator", "map", "dict", "set", "frozenset"])  # fmt: skip
def test_only_what_has_an_order_and_can_be_read_twice_is_a_list(side):
    with pytest.raises(BadType):
        prove(side, [1, 2])
    assert not check(side, [1, 2])


def test_symbols_are_matched_by_name_inside_derivatives_and_sums_too():
    positive, k = sp.Symbol("x", positive=True), sp.Symbol("k", integer=True)
    assert prove(sp.Derivative(positive**2, x), 2 * x)
    assert prove(sp.Subs(positive**2, x, 3), 9)
    assert prove(sp.Sum(sp.Symbol("k") ** 2, (k, 1, 3)), 14)


@pytest.mark.parametrize(("left", "right"), [
    (sp.Add(*(1 / (p + q) for p in sp.symbols("p:8") for q in sp.symbols("p:8"))), 0),
    (reduce(lambda b, _: sp.Pow(b, 512, evaluate=False), range(3), sp.Integer(7)), 1),
    (sp.Sum(sin(x), (x, 1, 10**7)), 0),
    (sp.Integral(sp.exp(sin(x)) / x, x), 0),
    (sp.Mul(*(1 + v for v in sp.symbols("v:24"))), 0),
    ((1 / (x + 1)) ** 512 + (1 / (x + 2)) ** 512, x),
    (sp.Sum(sin(x), (x, 10**9, 1)), 0),
    (sp.Product(sin(x), (x, 10**9, 1)), 0),
    (sp.Derivative(sp.exp(sin(t)), (t, 512)), 0),
    (sp.Derivative(sin(t) ** 50 * sp.exp(t**2) / t, (t, 20)), 0),
    (sp.Integral((1 + x) ** 1000 * (2 + x) ** 1000, (x, 0, 1)), 0),
    (sp.Integral(sp.Mul(*(x + v for v in sp.symbols("v:24"))), (x, 0, 1)), 0),
])  # fmt: skip
def test_what_would_take_forever_is_undecided(left, right):
    assert isinstance(prove(left, right), Undecided)


@pytest.mark.parametrize("grow", [
    lambda a: a * (1 + a), lambda a: sin(a) + sp.cos(a),
])  # fmt: skip
def test_functions_of_what_is_shared_are_neither_multiplied_out_nor_printed(grow):
    shared = sp.exp(reduce(lambda a, _: grow(a), range(25), t))
    assert prove(sin(shared) * (x + 1), x * sin(shared) + sin(shared))
    long = sp.Mul(*(1 + v for v in sp.symbols("v:24"))) + (1 + t) ** x
    assert isinstance(prove(sin(long), t), Refuted)


def test_what_is_nested_too_deeply_is_undecided():
    deep = t
    for _ in range(1000):
        deep = sp.Pow(sp.Add(1, deep, evaluate=False), sp.S.Half, evaluate=False)
    assert "nested too deeply" in str(prove(deep, t))


def test_a_symbol_declared_to_be_zero_is_not_given_another_value():
    zero = sp.Symbol("z", zero=True)
    assert isinstance(prove(zero + x, x), Undecided)
    assert isinstance(prove(sp.Derivative(zero * x, x), 0), Undecided)


def test_odd_powers_of_zero():
    assert prove(sp.Pow(0, 0, evaluate=False), 1)
    assert isinstance(prove(sp.Pow(0, Rational(-1, 2), evaluate=False), 0), Undecided)


def test_matrix_expressions_are_written_out():
    a = sp.MatrixSymbol("A", 2, 2)
    assert prove(a, a.as_explicit())
    assert prove(sp.Identity(2), sp.eye(2))
    with pytest.raises(BadType, match="can be evaluated"):
        prove(sp.Inverse(sp.ones(2)), sp.eye(2))


def test_huge_numbers_are_told_by_their_size():
    huge = sp.Integer(10) ** 5000
    assert "about 5001 digits" in str(prove(10**5000 * x, (10**5000 + 1) * x))
    for left in (sp.Piecewise((x, x < huge)), sin(huge), sp.Abs(x - huge), x**huge, sp.log(huge)):
        step = Step(left, x * huge, "size")
        for text in (str(step), repr(step.verdict), step._repr_latex_()):
            assert "digits" in text


def test_a_step_says_where_a_matrix_differs():
    step = Step([[1, 2], [3, x]], [[1, 2], [3, 5]], "hope")
    for text in (str(step), step._repr_latex_()):
        assert "in row 2, column 2 at x = 0 the left side is 0" in text


def test_words_in_latex_are_what_was_written():
    """MathJax shows backslashes in words, except before dollars and braces."""
    title, reason = "100% of C^2 & {P_0} # ~", r"(1 - t)^n, P_0^-1 and a \ b for 5$"
    latex = Derivation(title, (Step(x, sp.Symbol("P_0"), reason),))._repr_latex_()
    assert r"\textbf{100$\%$ of C$^{2}$ $\&$ \{P$\_$0\} $\#$ $\sim$ (NOT" in latex
    assert r"1. (1 - t)$^{n}$, P$\_$0$^{-1}$ and a $\backslash$ b for 5\$:" in latex
    assert r"at P$\_$0 = 1, x = 0" in latex


def test_a_derivation_without_steps_proves_nothing():
    empty = Derivation("Nothing", ())
    assert not empty.is_proved and "NOT PROVED" in str(empty)

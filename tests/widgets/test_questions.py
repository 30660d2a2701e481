"""Answers are checked exactly in the browser's code; SymPy says what is right."""

from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from symbolic import BadType, BadValue, bernstein, de_casteljau
from widgets import Scene

HERE = Path(__file__).parent
t, s = sp.symbols("t s")


def question(answer, variables=(), **more):
    scene = Scene()
    scene.question("What is it?", answer, variables, **more)
    return scene.to_json()["questions"][0]


@pytest.mark.parametrize("text, right", [
    ("3t(1-t)^2", True), ("3*t - 6*t^2 + 3*t^3", True), ("3t(1-t)(1-t)", True),
    ("t(3 - 6t + 3t^2)/1", True), ("3(t^2 - t^3)(1-t)/t", True), ("3t(1-t)^2 + 0s", True),
    ("3t^2(1-t)", False), ("3t(1-t)^2 + 1/10000000000000", False), ("0", False),
    ("3t(1-t)^2(t-7)/(t-7)", True),
])  # fmt: skip
def test_polynomials_in_any_form(checker, text, right):
    asked = question(bernstein(3)[1], [t, s])
    assert checker(asked, text)["right"] is right


def test_points_depend_on_the_figure(checker):
    scene = Scene()
    b = scene.points([[0, 0], [1, 3], [4, 1]])
    point = de_casteljau(b, sp.Rational(1, 4))[-1][0]
    scene.question(
        "c(1/4)?", point, mistakes={"That is c(3/4).": de_casteljau(b, sp.Rational(3, 4))[-1][0]}
    )
    asked = scene.to_json()["questions"][0]
    inputs = {"P0_x": 0, "P0_y": 0, "P1_x": 1, "P1_y": 3, "P2_x": 4, "P2_y": 1}
    exact = [sp.Rational(5, 8), sp.Rational(19, 16)]
    assert [e.subs(inputs) for e in point] == exact and asked["live"]
    assert checker(asked, "(5/8, 19/16)", inputs)["right"]
    assert checker(asked, "0.625, 1.1875", inputs)["right"]
    assert checker(asked, None, inputs)["solution"] == "(5/8, 19/16)"
    wrong = checker(asked, "(21/8, 27/16)", inputs)
    assert wrong == {"right": False, "message": "That is c(3/4)."}
    assert checker(asked, "(5/8, 1.1874999)", inputs)["message"].startswith("Not yet")
    assert "separated by commas" in checker(asked, "5/8", inputs)["error"]


@pytest.mark.parametrize("text", [
    "1/0", "t/(t-t)", "import os", "", "alert(1)", "__proto__", "t^99999999999", "(t^60)^60",
])  # fmt: skip
def test_what_is_no_answer_is_told_to_the_learner(checker, text):
    assert checker(question(t, [t]), text)["kind"] == "Unreadable"


LEAVES = {"t": t, "s": s, "0": 0, "1": 1, "2": 2, "3/7": sp.Rational(3, 7),
          "0.25": sp.Rational(1, 4), "(1-t)": 1 - t}  # fmt: skip
SIGNS = {"+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b,
         "/": lambda a, b: a / b}  # fmt: skip


@st.composite
def written(draw, depth=3):
    """Draw a rational expression as it is typed, and as it is."""
    if depth == 0 or draw(st.booleans()):
        return draw(st.sampled_from([(text, sp.sympify(e)) for text, e in LEAVES.items()]))
    (a, left), (b, right) = draw(written(depth - 1)), draw(written(depth - 1))
    sign, power = draw(st.sampled_from(list(SIGNS))), draw(st.integers(0, 3))
    return draw(st.sampled_from([
        (f"({a}){sign}({b})", SIGNS[sign](left, right)), (f"-({a})", -left),
        (f"({a})^{power}", left**power),
    ]))  # fmt: skip


@given(written(), written())
def test_verdicts_agree_with_sympy(checker, answer, typed):
    (right_text, right), (text, own) = answer, typed
    if right.has(sp.zoo, sp.nan) or own.has(sp.zoo, sp.nan):
        return
    for asked, expected in ((right, sp.cancel(right - own) == 0), (own, True)):
        verdict = checker(question(asked, [t, s]), text)
        if "error" in verdict:  # it divides by zero, or is of a high degree
            assert verdict["kind"] == "Unreadable"
        else:
            assert verdict["right"] == expected, (right_text, text, verdict)


@given(st.lists(st.fractions(max_denominator=60), min_size=2, max_size=7), st.fractions())
def test_one_different_coefficient_is_found(checker, coefficients, change):
    answer = sum(sp.Rational(c) * t**k for k, c in enumerate(coefficients))
    typed = [*coefficients]
    typed[len(typed) // 2] += change
    text = " + ".join(f"({c})t^{k}" for k, c in enumerate(typed))
    assert checker(question(answer, [t]), text)["right"] is (change == 0)


@pytest.mark.parametrize("make", [
    lambda q: q(0.5), lambda q: q(sp.sqrt(t), [t]), lambda q: q(sp.sin(t), [t]),
    lambda q: q(t, [t], mistakes={"the same": (t * 2) / 2}),
    lambda q: q([t, 1], [t], mistakes={"one only": t}),
    lambda q: q(t, ["t"]), lambda q: q(t, [sp.Symbol("t x")]), lambda q: q("t", [t]),
    lambda q: q(t, [t], hint=3),
])  # fmt: skip
def test_an_author_is_told_what_cannot_be_asked(make):
    with pytest.raises((BadValue, BadType)):
        make(question)


def test_a_variable_hides_an_input_of_its_name(checker):
    scene = Scene()
    u, w = scene.slider("u", 0, 1), scene.slider("w", 0, 4)
    scene.question("?", w * (1 - u) ** 2, [sp.Symbol("u")])
    asked = scene.to_json()["questions"][0]
    assert asked["tape"]["inputs"] == ["w", "u"]
    assert checker(asked, "3(1 - u)(1 - u)", {"u": 0.5, "w": 3})["right"]
    assert not checker(asked, "3/4", {"u": 0.5, "w": 3})["right"]


def test_fractions_are_answers(checker):
    assert checker(question(Fraction(3, 8)), "0.375")["right"]
    assert not question(Fraction(3, 8))["live"]

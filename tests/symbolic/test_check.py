"""Checked answers: right ones are proved, typical mistakes are named, nothing raises."""

import pytest
import sympy as sp

from symbolic import (
    BadType,
    NotExact,
    Proved,
    Refuted,
    Undecided,
    bezier,
    check,
    de_casteljau,
    hermite,
)

t = sp.Symbol("t")
MATRIX = hermite().matrix

WRONG_MATRICES = {
    "transpose:": MATRIX.T,
    "rows stand in reverse": MATRIX[::-1, :],
    "columns stand in reverse": MATRIX[:, ::-1],
    "transpose, with its columns": MATRIX[::-1, :].T,
    "stand in another order (1, 3, 2, 4)": MATRIX[:, [0, 2, 1, 3]],
    "inverse": MATRIX.inv(),
    "All signs": -MATRIX,
}


@pytest.mark.parametrize("said", WRONG_MATRICES)
def test_typical_mistakes_with_a_matrix_are_named(said):
    verdict = check(WRONG_MATRICES[said], MATRIX)
    assert isinstance(verdict, Refuted)
    assert said in verdict.diagnosis


def test_a_symmetric_matrix_is_not_called_transposed():
    assert isinstance(check(bezier(3).matrix.T, bezier(3).matrix), Proved)


def test_two_mistakes_with_one_result_are_both_named():
    verdict = check(4, 2, {"You squared.": 4, "You doubled.": 4})
    assert verdict.diagnosis.startswith("One of these: You squared.")
    assert "You doubled." in verdict.diagnosis


def test_the_questions_own_mistakes_come_first():
    assert check(-t, t, {"You went left.": -t}).diagnosis == "You went left."
    assert check(-t, t).diagnosis == "The sign is reversed."


def test_an_unknown_mistake_shows_where_it_fails_but_not_the_answer():
    verdict = check(t**2 + 7, t**2)
    assert isinstance(verdict, Refuted)
    assert "your answer gives 7" in verdict.diagnosis


@pytest.mark.parametrize("answer", [None, ...])
def test_no_answer_yet(answer):
    assert check(answer, 1).diagnosis.startswith("Not answered yet")


@pytest.mark.parametrize(
    "answer", [0.5, "1/2", [1, 2], {"a": 1}, object(), float("nan"), sp.Eq(t, 1)]
)
def test_answers_never_raise(answer):
    verdict = check(answer, sp.Rational(1, 2))
    assert isinstance(verdict, Undecided)
    assert verdict.diagnosis


@pytest.mark.parametrize("answer", ([[1, 2], [0, 1]], [[1, 0], [2, 1]]))
def test_points_reversed_or_with_coordinates_exchanged(answer):
    verdict = check(answer, [[0, 1], [1, 2]])
    assert isinstance(verdict, Refuted)
    assert "reverse order" in verdict.diagnosis or "exchanged" in verdict.diagnosis


def test_dots_left_inside_an_answer_are_no_answer():
    assert check([[1, ...], [0, 1]], sp.eye(2)).diagnosis.startswith("Not answered yet")


@pytest.mark.parametrize(("expected", "mistakes"), [(0.5, {}), (1, {"Half.": 0.5}), ("1", {})])
def test_what_the_author_got_wrong_is_not_blamed_on_the_learner(expected, mistakes):
    with pytest.raises((NotExact, BadType)):
        check(2, expected, mistakes)


@pytest.mark.parametrize(
    "mistakes", [[("You squared.", 4)], {1: 4}, "You squared.", ..., {"": "4"}]
)
@pytest.mark.parametrize("answer", [2, 4])
def test_mistakes_that_cannot_be_read_are_refused_whatever_the_answer(answer, mistakes):
    with pytest.raises(BadType, match="Expected .*, received .*\\. "):
        check(answer, 2, mistakes)


def test_inverses_of_roots_are_named_where_they_are_short_and_left_out_where_not():
    roots = sp.Matrix(2, 2, [sp.sqrt(2), 1, 1, sp.sqrt(3)])
    assert "inverse" in check(roots.inv(), roots).diagnosis
    equal = sp.Matrix([[1, (1 + sp.sqrt(2)) ** 2], [1, 3 + 2 * sp.sqrt(2)]])  # singular
    many = sp.Matrix(8, 8, lambda i, j: sp.sqrt(i + 1) + sp.sqrt(j + 2) + int(i == j))
    for matrix in (equal, many):
        assert "not the right value" in check(matrix + sp.eye(matrix.rows), matrix).diagnosis


@pytest.mark.parametrize("expected", [
    sp.Symbol("t", positive=True), sp.Derivative(t**2 / 2, t),
    sp.Integral(1, (sp.Symbol("s"), 0, t)),
])  # fmt: skip
def test_the_wrong_end_is_named_in_whatever_form_the_right_answer_comes(expected):
    assert "wrong end" in check(1 - t, expected).diagnosis


def test_a_deep_right_answer_is_walked_once():
    (curve,) = de_casteljau([[y] for y in sp.symbols("y0:25")], t)[-1][0]
    assert "not the right value" in check(curve + 1, curve).diagnosis

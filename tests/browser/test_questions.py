"""Predictions: typed, checked exactly in the browser, and told in words."""

import sympy as sp
from playwright.sync_api import Locator, expect

from browser.figures import START, Show, button, drag
from symbolic import bernstein, de_casteljau
from widgets import Figure, Scene

t = sp.Symbol("t")


def answer(figure: Locator, text: str) -> Locator:
    """Type an answer by keyboard and return where the verdict stands."""
    figure.locator(".current .answer").fill(text)
    figure.locator(".current .answer").press("Enter")
    return figure.locator(".current .verdict")


def point(points: object, at: object) -> str:
    """Return a point of the curve as a learner would type it."""
    x, y = de_casteljau(points, at)[-1][0]
    return f"({x}, {y})"


def test_right_wrong_known_and_unreadable_answers(figure: Locator) -> None:
    quarter = sp.Rational(1, 4)
    expect(answer(figure, "(1, 1)")).to_contain_text("Not yet. Divide every leg")
    expect(answer(figure, point(START, 1 - quarter))).to_contain_text("That is c(3/4)")
    expect(answer(figure, "3/")).to_contain_text("found the end")
    expect(figure.locator(".answer")).to_have_attribute("aria-invalid", "")
    expect(answer(figure, "7")).to_contain_text("Expected 2 values")
    expect(answer(figure, point(START, quarter))).to_have_text("Right: exactly equal.")
    x, y = (float(c) for c in de_casteljau(START, quarter)[-1][0])
    expect(answer(figure, f"{x}, {y}")).to_have_text("Right: exactly equal.")
    expect(answer(figure, f"{x}, {y + 1e-9:.12f}")).to_contain_text("Not yet")


def test_the_answer_belongs_to_the_figure_as_it_stands(figure: Locator) -> None:
    right = point(START, sp.Rational(1, 4))
    expect(answer(figure, right)).to_contain_text("Right")
    drag(figure, 1, 2, 5)
    expect(figure.locator(".verdict")).to_have_text("")
    expect(answer(figure, right)).to_contain_text("Not yet")
    expect(answer(figure, point([(0, 0), (2, 5), *START[2:]], sp.Rational(1, 4)))).to_contain_text(
        "Right"
    )


def test_the_answer_is_shown_on_request_after_a_try(figure: Locator) -> None:
    show = button(figure, "Show the answer")
    expect(show).to_be_hidden()
    answer(figure, "(0, 0)")
    show.click()
    expect(figure.locator(".answer")).to_have_value(point(START, sp.Rational(1, 4)))
    expect(figure.locator(".verdict")).to_contain_text("Right")
    expect(show).to_be_hidden()


def test_one_question_a_step_and_polynomials_are_proved(show: Show) -> None:
    scene = Scene("Two questions")
    scene.points([[0, 0], [1, 1]])
    scene.steps(["first", "second"])
    wrong = {"That is B_2^3: t and 1 - t change places.": bernstein(3)[2]}
    scene.question("Write B_1^3(t).", bernstein(3)[1], [t], until=0, mistakes=wrong)
    scene.question("And 1/2 + 1/3?", sp.Rational(5, 6), since=1)
    figure = show(Figure(scene).html())
    expect(answer(figure, "3t^2(1-t)")).to_contain_text("change places")
    expect(answer(figure, "3t - 6t^2 + 3t^3")).to_contain_text("Right: equal at 4 values of t")
    expect(figure.get_by_label("And 1/2 + 1/3?", exact=True)).to_be_hidden()
    button(figure, "Step forward").click()
    expect(figure.get_by_label("And 1/2 + 1/3?", exact=True)).to_be_visible()
    expect(answer(figure, "0.8333333")).to_contain_text("Not yet")
    expect(answer(figure, "5/6")).to_contain_text("Right")

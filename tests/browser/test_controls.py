"""The controls of a figure: steps, playing, number fields, and the table of numbers."""

from fractions import Fraction

import pytest
from playwright.sync_api import Locator, expect

from browser.figures import (
    START,
    Show,
    assert_drawn_from,
    button,
    drag,
    expect_point,
    html,
    next_frame,
    number,
)
from symbolic import de_casteljau


def test_steps_go_forward_and_back_one_interpolation_at_a_time(figure: Locator) -> None:
    caption, drawn = figure.locator(".captions .current"), figure.locator(".dot:visible")
    expect(drawn).to_have_count(6)
    expect(button(figure, "Step forward")).to_have_attribute("aria-disabled", "true")
    for left in (5, 4, 3, 2, 1, 0):
        button(figure, "Step back").click()
        expect(drawn).to_have_count(left)
    expect(caption).to_contain_text("Step forward to interpolate")
    expect(button(figure, "Step back")).to_have_attribute("aria-disabled", "true")
    button(figure, "Step forward").click()
    expect(caption).to_have_text("b10 = (1 − t) b0 + t b1")
    expect(drawn).to_have_count(1)


def test_playing_the_steps_starts_again_after_the_last_one(figure: Locator) -> None:
    button(figure, "Play the steps").click()
    expect(figure.locator(".count")).to_have_text("0 / 6")
    expect(figure.locator(".count")).to_have_text("1 / 6")
    button(figure, "Pause the steps").click()


def test_playing_starts_when_asked_and_stops_when_asked(figure: Locator) -> None:
    expect(number(figure)).to_have_value("0.375")
    button(figure, "Play t").click()
    expect(number(figure)).not_to_have_value("0.375")
    button(figure, "Pause t").click()
    next_frame(figure)
    value = number(figure).input_value()
    next_frame(figure)
    assert number(figure).input_value() == value
    button(figure, "Undo").click()
    expect(number(figure)).to_have_value("0.375")


def test_under_reduced_motion_a_played_slider_jumps_in_eighths(show: Show) -> None:
    figure = show(html("de_casteljau"))
    figure.page.emulate_media(reduced_motion="reduce")
    button(figure, "Play t").click()
    for value in ("0.5", "0.625"):
        expect(number(figure)).to_have_value(value)
    button(figure, "Pause t").click()


@pytest.mark.parametrize(("typed", "value"), [("3/8", 0.375), ("1/4", 0.25), (".5", 0.5)])
def test_a_number_field_takes_fractions(figure: Locator, typed: str, value: float) -> None:
    number(figure).fill("0.75")
    number(figure).press("Enter")
    number(figure).fill(typed)
    number(figure).press("Enter")
    expect(number(figure)).to_have_value(str(value))
    next_frame(figure)
    assert_drawn_from(figure, START, value)


@pytest.mark.parametrize(("typed", "said"), [
    ("half", "Expected a number such as 0.5 or 3/8; the value stays 0.375."),
    ("1/0", "Expected a number such as 0.5 or 3/8; the value stays 0.375."),
    ("2", "Expected a number from 0 to 1; the value stays 0.375."),
])  # fmt: skip
def test_a_number_field_says_what_is_wrong(figure: Locator, typed: str, said: str) -> None:
    number(figure).fill(typed)
    number(figure).press("Enter")
    expect(figure.get_by_text(said)).to_be_visible()
    expect(number(figure)).to_have_accessible_description(said)
    assert_drawn_from(figure, START, 0.375)
    number(figure).press("Escape")
    expect(number(figure)).to_have_value("0.375")
    expect(figure.get_by_text(said)).to_be_hidden()


def test_the_table_shows_all_points_and_takes_new_coordinates(figure: Locator) -> None:
    figure.get_by_text("Numbers", exact=True).click()
    number(figure, "b 0 y").fill("-1/8")
    number(figure, "b 0 y").press("Tab")
    expect_point(figure, 0, 0, -0.125)
    drag(figure, 1, 1.5, 3)
    expect(number(figure, "b 1 x")).to_have_value("1.5")
    moved = [[0, Fraction(-1, 8)], [Fraction(3, 2), 3], *START[2:]]
    x, y = de_casteljau(moved, Fraction(3, 8))[-1][0]
    row = figure.get_by_role("row").filter(has_text="c(t)")
    expect(row.get_by_role("cell")).to_have_text([f"{float(v):.4f}".rstrip("0") for v in (x, y)])

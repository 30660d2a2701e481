"""``fig.html()`` opened from a file, with the network off: points move and the curve follows."""

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import numpy as np
from playwright.sync_api import Locator, expect

from browser.figures import (
    START,
    Show,
    assert_curve,
    assert_drawn_from,
    button,
    curve,
    curve_by_numpy,
    drag,
    expect_point,
    handle,
    html,
    number,
    place,
    points,
)
from browser.frames import measure
from symbolic import de_casteljau
from widgets import Figure, Scene


def test_a_point_dragged_by_mouse_snaps_and_the_curve_follows(figure: Locator) -> None:
    assert_drawn_from(figure, START, 0.375)
    drag(figure, 1, 2.03, 4.6)
    expect_point(figure, 1, 2, 4.625)
    moved = [START[0], [2, 4.625], *START[2:]]
    assert points(figure).tolist() == moved
    assert_drawn_from(figure, moved, 0.375)


def test_the_readout_is_the_exact_point_of_the_dragged_curve(figure: Locator) -> None:
    drag(figure, 3, 7.5, 2.5)
    expect_point(figure, 3, 7.5, 2.5)
    x, y = de_casteljau([*START[:3], [Fraction(15, 2), Fraction(5, 2)]], Fraction(3, 8))[-1][0]
    expect(figure.locator(".readout .value")).to_have_text(
        f"({round(float(x), 4):g}, {round(float(y), 4):g})"
    )


def test_the_subdivided_polygons_follow_a_drag(show: Show) -> None:
    figure = show(html("subdivision"))
    drag(figure, 2, 4, 3)
    expect_point(figure, 2, 4, 3)
    moved = [*START[:2], [4, 3], START[3]]
    left = np.array([level[0] for level in de_casteljau(moved, Fraction(1, 2))], dtype=float)
    np.testing.assert_allclose(curve(figure, 2)[:4], left, atol=1e-3)


def test_arrow_keys_nudge_by_the_snapping_step_and_finer_with_shift(figure: Locator) -> None:
    handle(figure, 2).focus()
    for key in ("ArrowRight", "ArrowDown", "ArrowDown"):
        figure.page.keyboard.press(key)
    expect_point(figure, 2, 5.125, 4.75)
    assert_drawn_from(figure, [*START[:2], [5.125, 4.75], START[3]], 0.375)
    figure.page.keyboard.press("Shift+ArrowLeft")
    figure.get_by_text("Numbers", exact=True).click()
    expect(number(figure, "b 2 x")).to_have_value(str(5.125 - 1 / 64))


def test_escape_gives_up_a_drag(figure: Locator) -> None:
    mouse = figure.page.mouse
    mouse.move(*place(figure, 1, 4))
    mouse.down()
    mouse.move(*place(figure, 3, 3), steps=4)
    expect_point(figure, 1, 3, 3)
    figure.page.keyboard.press("Escape")
    expect_point(figure, 1, 1, 4)
    mouse.move(*place(figure, 2, 2))
    mouse.up()
    assert points(figure).tolist() == START


def test_undo_takes_back_move_by_move_and_reset_everything(figure: Locator) -> None:
    drag(figure, 0, 1, 1)
    drag(figure, 3, 7, 2)
    button(figure, "Undo").click()
    expect_point(figure, 3, 8, 1)
    expect_point(figure, 0, 1, 1)
    number(figure).fill("1/2")
    number(figure).press("Enter")
    button(figure, "Reset").click()
    expect_point(figure, 0, 0, 0)
    expect(number(figure)).to_have_value("0.375")
    button(figure, "Undo").click()
    expect_point(figure, 0, 1, 1)


def test_five_lines_make_a_figure_of_ones_own(show: Show, artefacts: Path) -> None:
    scene = Scene("A parabola and its tangent")
    P = scene.points([[0, 0], [2, 3], [4, 0]])
    levels = de_casteljau(P, t := scene.slider("t", 0, 1))
    scene.curve(levels[2][0], t), scene.polyline(levels[1]), scene.dots(levels[2], labels=["c(t)"])
    figure = show(Figure(scene).html())
    drag(figure, 1, 3, 2)
    expect_point(figure, 1, 3, 2)
    assert_curve(figure, curve_by_numpy(scene.to_json(), P=[[0, 0], [3, 2], [4, 0]], t=0.5))
    assert_curve(figure, np.array([[1.5, 1], [3.5, 1]]), mark=1)
    figure.screenshot(path=artefacts / "static_own_scene.png")


def test_from_event_to_frame_in_a_page(
    figure: Locator, record_property: Callable[[str, object], None]
) -> None:
    times = measure(figure, moves=80)
    assert len(times.drawn) >= 60
    record_property("static page, pointer event to frame", times.summary())

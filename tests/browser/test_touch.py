"""A figure under a finger: handles are dragged or placed by taps, all the rest scrolls the page."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Locator, expect

from browser.figures import START, expect_point, handle, html, next_frame, place, points


@pytest.fixture
def figure(browser: Browser, tmp_path: Path) -> Iterator[Locator]:
    """Yield the explorer of de Casteljau's construction on a phone without network."""
    with browser.new_context(
        has_touch=True, offline=True, viewport={"width": 390, "height": 700}
    ) as context:
        page = context.new_page()
        (tmp_path / "figure.html").write_text(html("de_casteljau"), encoding="utf-8")
        page.goto((tmp_path / "figure.html").as_uri())
        yield page.locator(".casteljau")


def swipe(figure: Locator, start: np.ndarray, end: np.ndarray) -> None:
    """Move one finger in a straight line; Playwright itself can only tap."""
    session = figure.page.context.new_cdp_session(figure.page)

    def touch(kind: str, *places: np.ndarray) -> None:
        fingers = [{"x": float(x), "y": float(y)} for x, y in places]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers})

    touch("touchStart", start)
    for share in np.linspace(0, 1, 9)[1:]:
        touch("touchMove", start + share * (end - start))
    touch("touchEnd")


def test_a_finger_on_a_handle_drags_it(figure: Locator) -> None:
    swipe(figure, place(figure, 5, 5), place(figure, 6.02, 1.1))
    expect_point(figure, 2, 6, 1.125)
    assert figure.page.evaluate("scrollY") == 0


def test_a_finger_need_not_meet_a_handle_exactly(figure: Locator) -> None:
    off = np.array([15, 10])
    swipe(figure, place(figure, 1, 4) + off, place(figure, 2, 2) + off)
    expect_point(figure, 1, 2, 2)


def test_a_finger_beside_the_handles_scrolls_the_page(figure: Locator) -> None:
    start = place(figure, 4, 1)
    swipe(figure, start, start - [0, 150])
    figure.page.wait_for_function("scrollY > 50")
    assert points(figure).tolist() == START


def test_a_point_is_placed_by_two_taps(figure: Locator) -> None:
    page = figure.page
    page.touchscreen.tap(*place(figure, 5, 5))
    expect(handle(figure, 2)).to_contain_class("selected")
    page.touchscreen.tap(*place(figure, 4.02, 3.1))
    expect_point(figure, 2, 4, 3.125)
    page.touchscreen.tap(*place(figure, 6, 2))  # nothing is selected any more
    next_frame(figure)
    assert points(figure).tolist() == [*START[:2], [4, 3.125], START[3]]

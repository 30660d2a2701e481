"""A figure in a browser, as a learner handles it: what is drawn, and moving it by mouse."""

import re
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from playwright.sync_api import Locator, expect

from numeric import Tape
from widgets import Figure, explore
from widgets.extent import evaluate

Show = Callable[[str], Locator]
START = [[0, 0], [1, 4], [5, 5], [8, 1]]  # of the explorers
NUMBER = re.compile(r"-?\d+\.?\d*")


@cache
def explorer(name: str) -> Figure:
    """Return an explorer as it stands at first; a test does not change it."""
    return getattr(explore, name)()


@cache
def html(name: str) -> str:
    """Return an explorer's page: its poster takes a second to draw."""
    return explorer(name).html()


def button(figure: Locator, name: str) -> Locator:
    return figure.get_by_role("button", name=name, exact=True)


def number(figure: Locator, name: str = "t, number") -> Locator:
    return figure.get_by_role("textbox", name=name, exact=True)


def handle(figure: Locator, index: int) -> Locator:
    return figure.locator(".handle").nth(index)


def points(figure: Locator) -> np.ndarray:
    """Return where the movable points say they are."""
    return _numbers(figure, "aria-valuetext")


def next_frame(figure: Locator) -> None:
    """Wait until what was changed by now is drawn."""
    figure.page.evaluate("() => new Promise(requestAnimationFrame)")


def expect_point(figure: Locator, index: int, x: float, y: float) -> None:
    """Wait until a point says it is exactly there; then the frame that shows it is drawn."""
    text = f"x {x:.12g}, y {y:.12g}"
    expect(handle(figure, index)).to_have_attribute("aria-valuetext", text, timeout=20_000)


def curve(figure: Locator, mark: int = 0) -> np.ndarray:
    """Return the samples of a drawn path, in the plane."""
    path = figure.locator(".mark").nth(mark).locator(".path")
    drawn = np.array(NUMBER.findall(path.get_attribute("d") or ""), dtype=float).reshape(-1, 2)
    scale, offset = plane_to_drawing(figure)
    return (drawn - offset) / scale


def curve_by_numpy(scene: dict[str, Any], mark: int = 0, **state: Any) -> np.ndarray:
    """Return the samples of the same path as NumPy computes them from exact points."""
    outputs = evaluate(scene, state, Tape.from_json(scene["tape"]))
    return outputs[scene["marks"][mark]["output"]].reshape(-1, 2)


def assert_curve(figure: Locator, expected: np.ndarray, mark: int = 0) -> None:
    """Check a drawn path to a fiftieth of a pixel, since pixels are written with two decimals."""
    scale, _ = plane_to_drawing(figure)
    np.testing.assert_allclose(curve(figure, mark) * scale, expected * scale, atol=0.02)


def assert_drawn_from(figure: Locator, b: list[list[float]], t: float) -> None:
    """Check the curve of de Casteljau's construction, and its part up to t."""
    scene = explorer("de_casteljau").scene
    for mark in (0, 1):
        assert_curve(figure, curve_by_numpy(scene, mark, b=b, t=t), mark)


def plane_to_drawing(figure: Locator) -> tuple[np.ndarray, np.ndarray]:
    """Return scale and offset from the plane to pixels, by where the movable points are drawn."""
    here, drawn = points(figure), _numbers(figure, "transform")
    scale, offset = np.array([np.polyfit(here[:, k], drawn[:, k], 1) for k in (0, 1)]).T
    return scale, offset


def place(figure: Locator, x: float, y: float) -> np.ndarray:
    """Return where a point of the plane is in the window, in pixels."""
    first = handle(figure, 0).locator(".touch").bounding_box()
    assert first is not None
    centre = [first["x"] + first["width"] / 2, first["y"] + first["height"] / 2]
    scale, _ = plane_to_drawing(figure)
    return centre + scale * (np.array([x, y]) - points(figure)[0])


def drag(figure: Locator, index: int, x: float, y: float) -> None:
    """Drag a movable point by mouse to a place in the plane."""
    figure.locator(".drawing").scroll_into_view_if_needed()
    mouse = figure.page.mouse
    start, end = place(figure, *points(figure)[index]), place(figure, x, y)
    mouse.move(*start)
    mouse.down()
    mouse.move(*end, steps=8)
    mouse.up()


def _numbers(figure: Locator, attribute: str) -> np.ndarray:
    texts = figure.locator(".handle").evaluate_all(
        "(handles, name) => handles.map((handle) => handle.getAttribute(name))", attribute
    )
    return np.array([NUMBER.findall(text) for text in texts], dtype=float)

"""Figures in JupyterLab: what is moved in the browser, Python knows, and the other way round."""

import ast
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from browser.figures import (
    START,
    assert_curve,
    assert_drawn_from,
    button,
    drag,
    expect_point,
    handle,
    number,
)
from browser.frames import measure
from chromium import OfflinePage
from numeric import Curve
from serving import Lab

MINUTE = 60_000
RUN = re.compile(r"\[\d+\]:")
ERRORS = "[data-mime-type='application/vnd.jupyter.error'], [data-mime-type$='stderr']"
FIND_FIGURE = "fig = next(f for f in Out.values() if 'Casteljau' in str(getattr(f, 'scene', '')))"
CELLS = [
    "from widgets import explore\nfig = explore.de_casteljau()\nfig",
    "[fig['b'].tolist(), fig['t'], fig['step']]",
    "fig['t'] = 0.25",
    "fig['b'] = [[0, 0], [2, 2], [5, 5], [8, 1]]",
    "fig",
]


def open_notebook(page: Page, url: str) -> None:
    page.goto(url)
    page.get_by_text("Python 3 (ipykernel) | Idle").wait_for(timeout=2 * MINUTE)


def code_cell(page: Page, text: str) -> Locator:
    return page.locator(".jp-CodeCell").filter(has=page.locator(".cm-content", has_text=text))


def run(cell: Locator) -> None:
    """Run a cell as a learner does."""
    prompt = cell.locator(".jp-InputPrompt")
    before = prompt.inner_text()
    cell.locator(".cm-content").click()
    cell.page.keyboard.press("Control+Enter")
    expect(prompt).not_to_have_text(before, timeout=MINUTE)
    expect(prompt).to_have_text(RUN, timeout=MINUTE)


def answer(cell: Locator) -> Any:
    """Run a cell and return its value."""
    run(cell)
    number = cell.locator(".jp-InputPrompt").inner_text()
    expect(cell.locator(".jp-OutputPrompt")).to_have_text(number, timeout=MINUTE)
    return ast.literal_eval(cell.locator(".jp-OutputArea-output").inner_text())


def add_cell(below: Locator, code: str) -> Locator:
    """Add a cell by keyboard."""
    below.locator(".jp-InputPrompt").click()
    for key in ("b", "Enter"):
        below.page.keyboard.press(key)
    below.page.keyboard.insert_text(code)
    return code_cell(below.page, code.splitlines()[-1])


@pytest.fixture(scope="module")
def notebook(browser: Browser, jupyterlab: Lab) -> Iterator[Page]:
    """Yield a page with a notebook of our own, with room to scroll."""
    cells = [nbformat.v4.new_code_cell(code) for code in CELLS]
    cells.append(nbformat.v4.new_markdown_cell("\n\n".join(["room to scroll"] * 60)))
    kernel = {"name": "python3", "display_name": "Python 3 (ipykernel)", "language": "python"}
    book = nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": kernel})
    nbformat.write(book, jupyterlab.folder / "figure.ipynb")
    with browser.new_context(viewport={"width": 1280, "height": 900}) as context:
        page = context.new_page()
        address = re.sub(r"/lab\b[^?]*", "/lab/tree/figure.ipynb", jupyterlab.url)
        open_notebook(page, f"{address}&reset")
        yield page


@pytest.fixture
def figure(notebook: Page) -> Locator:
    """Return a new figure, shown once."""
    cell = code_cell(notebook, "explore.de_casteljau")
    run(cell)
    expect(cell.locator(".handle")).to_have_count(4, timeout=MINUTE)
    return cell.locator(".casteljau")


def test_lesson_1_runs_and_its_figure_and_python_agree(
    page_offline: OfflinePage, jupyterlab: Lab, artefacts: Path
) -> None:
    page = page_offline.page
    page.set_viewport_size({"width": 1280, "height": 1100})
    open_notebook(page, jupyterlab.url)
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    for prompt in page.locator(".jp-CodeCell .jp-InputPrompt:not(.jp-Placeholder-prompt)").all():
        expect(prompt).to_have_text(RUN, timeout=2 * MINUTE)
    assert page.locator(ERRORS).all_inner_texts() == []

    expect(page.locator(".casteljau .drawing")).to_have_count(3)
    expect(page.locator(".casteljau .alert:visible")).to_have_count(0)

    cell = code_cell(page, "explore.de_casteljau(")
    figure = cell.locator(".casteljau")
    expect(figure.locator(".handle")).to_have_count(3)
    question = add_cell(cell, f"{FIND_FIGURE}\nfig.values['b'].tolist()")
    b0, _, b2 = answer(question)
    drag(figure, 1, 150.6, 1030.6)  # points of this figure move in steps of 4 font units
    expect_point(figure, 1, 152, 1032)
    page.screenshot(path=artefacts / "jupyterlab_lesson_1.png")
    assert answer(question) == [b0, [152, 1032], b2]
    handle(figure, 1).press("ArrowUp")
    expect_point(figure, 1, 152, 1036)
    moved = [b0, [152, 1036], b2]
    assert answer(question) == moved
    assert_curve(figure, Curve.from_bezier(moved)(np.linspace(0, 1, 129)))
    assert page_offline.refused == []


def test_what_python_sets_is_drawn(notebook: Page, figure: Locator) -> None:
    run(code_cell(notebook, "fig['t'] ="))
    expect(number(figure)).to_have_value("0.25")
    run(code_cell(notebook, "fig['b'] ="))
    expect_point(figure, 1, 2, 2)
    assert_drawn_from(figure, [START[0], [2, 2], *START[2:]], 0.25)


def test_what_is_moved_python_knows_exactly(notebook: Page, figure: Locator) -> None:
    drag(figure, 1, 2.03, 4.6)
    expect_point(figure, 1, 2, 4.625)
    figure.page.keyboard.press("ArrowRight")
    button(figure, "Step back").click()
    number(figure).fill("3/16")
    number(figure).press("Enter")
    moved = [START[0], [2.125, 4.625], *START[2:]]
    assert answer(code_cell(notebook, "tolist()")) == [moved, 0.1875, 5]


def test_a_second_view_of_a_figure_moves_along(notebook: Page, figure: Locator) -> None:
    cell = notebook.locator(".jp-CodeCell").nth(len(CELLS) - 1)
    run(cell)
    second = cell.locator(".casteljau")
    expect(second.locator(".handle")).to_have_count(4)
    drag(figure, 3, 7, 2)
    expect_point(second, 3, 7, 2)
    button(figure, "Undo").click()
    expect_point(second, 3, 8, 1)


def test_letters_typed_at_a_handle_leave_the_notebook_alone(
    notebook: Page, figure: Locator
) -> None:
    cells = notebook.locator(".jp-Cell")
    before = cells.evaluate_all("(all) => all.map((cell) => cell.className)")
    handle(figure, 0).focus()
    for key in ("a", "b", "d", "d", "x", "1", "m", "Enter", "Shift+Enter"):
        notebook.keyboard.press(key)
    expect(handle(figure, 0)).to_be_focused()
    assert cells.evaluate_all("(all) => all.map((cell) => cell.className)") == before


def test_a_figure_writes_nothing_to_the_console(notebook: Page) -> None:
    complaints: list[str] = []
    notebook.on("console", lambda message: complaints.append(f"{message.type}: {message.text}"))
    cell = code_cell(notebook, "explore.de_casteljau")
    run(cell)
    expect(cell.locator(".handle")).to_have_count(4, timeout=MINUTE)
    assert [text for text in complaints if text.startswith(("error", "warning"))] == []


def test_tab_walks_from_handle_to_handle(notebook: Page, figure: Locator) -> None:
    handle(figure, 0).focus()
    for index in (1, 2, 3):
        notebook.keyboard.press("Tab")
        expect(handle(figure, index)).to_be_focused()
    notebook.keyboard.press("Tab")
    expect(button(figure, "Step back")).to_be_focused()


def test_the_wheel_over_a_figure_scrolls_the_notebook(notebook: Page, figure: Locator) -> None:
    drawing = figure.locator(".drawing")
    drawing.scroll_into_view_if_needed()
    before = drawing.bounding_box()
    drawing.hover(position={"x": 5, "y": 150})
    notebook.mouse.wheel(0, 120)
    notebook.wait_for_function(
        "([drawing, y]) => drawing.getBoundingClientRect().y < y - 100",
        arg=[drawing.element_handle(), before["y"]],
    )


def test_from_event_to_frame_in_jupyterlab(
    figure: Locator, record_property: Callable[[str, object], None]
) -> None:
    times = measure(figure, moves=80)
    assert len(times.drawn) >= 60
    record_property("JupyterLab, pointer event to frame", times.summary())


def test_a_figure_follows_jupyterlabs_theme(
    notebook: Page, figure: Locator, artefacts: Path
) -> None:
    expect(figure).to_have_attribute("data-theme", "light")
    notebook.get_by_role("menuitem", name="Settings", exact=True).click()
    for name in ("Theme", "JupyterLab Dark"):
        notebook.locator(".lm-Menu-itemLabel").get_by_text(name, exact=True).click()
    expect(figure).to_have_attribute("data-theme", "dark", timeout=MINUTE)
    expect(notebook.locator("#jupyterlab-splash")).to_have_count(0, timeout=MINUTE)
    notebook.screenshot(path=artefacts / "jupyterlab_dark.png")

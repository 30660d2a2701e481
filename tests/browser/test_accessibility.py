"""Figures for readers with a keyboard or a screen reader: axe, names, focus, and what is spoken."""

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Locator, expect

from browser.figures import Show, drag, expect_point, handle, html

FOCUSED = """() => {
  const element = document.activeElement?.shadowRoot?.activeElement ?? document.activeElement;
  return element.ariaLabel ?? element.textContent;
}"""
HANDLES = ["b 0", "b 1", "b 2", "b 3"]
PROMPT = "Predict before you look: where is c(1/4)? Type (x, y)."
BEFORE = ["Undo", "Reset"]
AFTER = ["Step back", "Play the steps", "Step forward", "Step", PROMPT, f"Check: {PROMPT}",
         "Play t", "t", "t, number", "Numbers"]  # fmt: skip


def press(figure: Locator, key: str) -> str:
    """Press a key and return the name of what has the focus then."""
    figure.page.keyboard.press(key)
    return figure.page.evaluate(FOCUSED)


@pytest.mark.parametrize(
    "name",
    [
        "bezier_properties",
        "blossom",
        "de_casteljau",
        "hodograph",
        "kochanek_bartels",
        "subdivision",
    ],
)
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_axe_finds_nothing_serious(show: Show, name: str, theme: str) -> None:
    figure = show(html(name))
    figure.page.emulate_media(color_scheme=theme)
    expect(figure).to_have_attribute("data-theme", theme)
    for opened in ("closed", "open"):
        results = Axe().run(figure.page).response
        assert results["testEngine"]["name"] == "axe-core"
        bad = {
            (violation["id"], str(node["target"]), node["failureSummary"])
            for violation in results["violations"]
            for node in violation["nodes"]
            if violation["impact"] in ("serious", "critical")
        }
        assert bad == set(), f"with the table of numbers {opened}"
        figure.get_by_text("Numbers", exact=True).click()


@pytest.mark.parametrize("name", ["de_casteljau", "subdivision"])
def test_every_control_has_a_name(show: Show, name: str) -> None:
    figure = show(html(name))
    figure.get_by_text("Numbers", exact=True).click()
    session = figure.page.context.new_cdp_session(figure.page)
    nodes = session.send("Accessibility.getFullAXTree")["nodes"]
    roles = {"button", "slider", "textbox", "DisclosureTriangle"}
    controls = [node for node in nodes if node.get("role", {}).get("value") in roles]
    assert (
        len(controls)
        == figure.locator(":is(button, input, summary, .handle):not([hidden])").count()
    )
    names = [node["name"]["value"] for node in controls]
    assert all(names)
    assert len(set(names)) == len(names)


def test_a_handle_is_a_slider_that_tells_both_coordinates(figure: Locator) -> None:
    for index, (x, y) in enumerate([(0, 0), (1, 4), (5, 5), (8, 1)]):
        expect(handle(figure, index)).to_have_role("slider")
        expect(handle(figure, index)).to_have_accessible_name(HANDLES[index])
        expect(handle(figure, index)).to_have_attribute("aria-valuenow", str(x))
        expect(handle(figure, index)).to_have_attribute("aria-valuetext", f"x {x}, y {y}")


def test_values_are_spoken_on_release_not_while_dragging(figure: Locator) -> None:
    voice = figure.page.locator(".casteljau-host [aria-live=polite]")
    handle(figure, 1).focus()
    figure.page.keyboard.down("ArrowUp")
    expect_point(figure, 1, 1, 4.125)
    expect(voice).to_have_text("")
    figure.page.keyboard.up("ArrowUp")
    expect(voice).to_have_text("b 1 at 1, 4.125")
    drag(figure, 2, 4, 3)
    expect(voice).to_have_text("b 2 at 4, 3")


def test_a_step_speaks_its_caption(figure: Locator) -> None:
    voice = figure.page.locator(".casteljau-host [aria-live=polite]")
    figure.get_by_role("button", name="Step back").click()
    expect(voice).to_have_text("Step 5 of 6: b 1 2 = (1 - t) b 1 1 + t b 2 1")


def test_tab_goes_through_the_figure_as_it_is_read(figure: Locator) -> None:
    order = [press(figure, "Tab") for _ in range(len(BEFORE + HANDLES + AFTER))]
    assert order == BEFORE + HANDLES + AFTER


def test_shift_tab_goes_the_same_way_back(figure: Locator) -> None:
    handle(figure, 3).focus()
    order = [press(figure, "Shift+Tab") for _ in range(5)]
    assert order == [*HANDLES[2::-1], *BEFORE[::-1]]


def test_coming_back_the_focus_is_on_the_handle_used_last(figure: Locator) -> None:
    handle(figure, 2).focus()
    press(figure, "Escape")
    assert press(figure, "Shift+Tab") == "b 2"


def test_escape_leaves_the_handles(figure: Locator) -> None:
    handle(figure, 0).focus()
    assert press(figure, "Escape") == "Step back"


def test_a_button_that_cannot_act_keeps_the_focus(figure: Locator) -> None:
    forward = figure.get_by_role("button", name="Step forward")
    forward.focus()
    figure.page.keyboard.press("Enter")
    expect(forward).to_be_focused()
    expect(forward).to_have_attribute("aria-disabled", "true")


def test_letters_in_a_figure_do_nothing(figure: Locator) -> None:
    handle(figure, 0).focus()
    for key in ("a", "d", "x", "1", "Enter", "Space", "Delete"):
        assert press(figure, key) == "b 0"
    expect_point(figure, 0, 0, 0)


def test_system_colours_are_kept_where_the_reader_forces_them(figure: Locator) -> None:
    figure.page.emulate_media(forced_colors="active")
    expect(figure.locator(".mark .path").first).to_have_css("stroke", "rgb(0, 0, 0)")
    expect(figure.locator(".dot").first).to_have_css("fill", "rgb(0, 0, 0)")

"""A figure fits where it stands: theme, width, version, in another page, without scripts."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from browser.figures import (
    START,
    Show,
    assert_drawn_from,
    drag,
    expect_point,
    explorer,
    html,
    number,
)
from chromium import OfflinePage


@pytest.mark.parametrize("name", ["de_casteljau", "subdivision"])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_figure_follows_the_readers_theme(
    show: Show, artefacts: Path, name: str, theme: str
) -> None:
    figure = show(html(name))
    figure.page.emulate_media(color_scheme=theme)
    paper = {"light": "rgb(255, 255, 255)", "dark": "rgb(20, 24, 31)"}[theme]
    expect(figure).to_have_css("background-color", paper)
    figure.page.screenshot(path=artefacts / f"static_{name}_{theme}.png", full_page=True)


def test_on_a_phone_nothing_stands_out_at_the_side(show: Show, artefacts: Path) -> None:
    figure = show(html("de_casteljau"))
    figure.page.set_viewport_size({"width": 320, "height": 640})
    figure.get_by_text("Numbers", exact=True).click()
    expect(number(figure, "b 3 y")).to_be_visible()
    width = figure.page.evaluate("document.documentElement.scrollWidth")
    figure.page.screenshot(path=artefacts / "static_phone.png", full_page=True)
    assert width <= 320


def test_a_front_end_of_another_version_says_so_in_plain_words(show: Show) -> None:
    figure = show(html("de_casteljau").replace('"version":"', '"version":"9.', 1))
    expect(figure.get_by_role("alert")).to_contain_text("This figure was made by casteljau 9.")
    expect(figure.get_by_role("alert")).to_contain_text("Run the cell again")
    expect(figure.locator(".drawing")).to_have_count(0)


def embedded(page: Page, file: Path) -> Page:
    data, _ = explorer("de_casteljau")._repr_mimebundle_()
    file.write_text(f"<!doctype html><title>Book</title>{data['text/html']}", encoding="utf-8")
    page.goto(file.as_uri())
    return page


def test_embedded_in_another_page_it_lives_in_its_sandbox(
    page_offline: OfflinePage, tmp_path: Path
) -> None:
    page = embedded(page_offline.page, tmp_path / "book.html")
    figure = page.frame_locator("iframe").locator(".casteljau")
    drag(figure, 1, 2, 3)
    expect_point(figure, 1, 2, 3)
    assert_drawn_from(figure, [START[0], [2, 3], *START[2:]], 0.375)
    assert page_offline.refused == []


def test_without_scripts_the_poster_is_seen(
    browser: Browser, tmp_path: Path, artefacts: Path
) -> None:
    file = tmp_path / "figure.html"
    file.write_text(html("de_casteljau"), encoding="utf-8")
    with browser.new_context(java_script_enabled=False, offline=True) as context:
        page = context.new_page()
        page.goto(file.as_uri())
        poster = page.get_by_role("img")
        expect(poster).to_be_visible()
        box = poster.bounding_box()
        page.screenshot(path=artefacts / "static_without_scripts.png")
        assert box is not None and box["width"] > 400
        description = explorer("de_casteljau").scene["description"]
        assert poster.get_attribute("alt") == description

"""Figures opened from a file, with the network off."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Locator

from browser.figures import Show, html
from chromium import OfflinePage


@pytest.fixture
def show(page_offline: OfflinePage, tmp_path: Path) -> Iterator[Show]:
    """Yield a function that opens a page and returns its figure; nothing may go wrong in it."""
    page, complaints = page_offline.page, []
    page.on("console", lambda message: complaints.append(message.text))
    page.on("pageerror", lambda error: complaints.append(str(error)))

    def open_page(html: str) -> Locator:
        file = tmp_path / "figure.html"
        file.write_text(html, encoding="utf-8")
        page.goto(file.as_uri())
        return page.locator(".casteljau")

    yield open_page
    assert page_offline.refused == []
    assert complaints == []


@pytest.fixture
def figure(show: Show) -> Locator:
    """Return the explorer of de Casteljau's construction."""
    return show(html("de_casteljau"))

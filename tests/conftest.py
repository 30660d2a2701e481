"""Fixtures for all tests: a folder for pictures, a browser, and a JupyterLab to open in it."""

import os
import sys
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import hypothesis
import pytest
from playwright.sync_api import Browser, Route, WebSocketRoute, sync_playwright

from chromium import OfflinePage, ensure
from hatch_build import front_end_build
from serving import Lab, running_lab

ROOT = Path(__file__).parent.parent
# Continuous integration judges a change, so it draws the same examples every time; elsewhere new
# ones are tried at every run.
hypothesis.settings.register_profile("ci", derandomize=True, deadline=None)
hypothesis.settings.register_profile("local", deadline=None)
hypothesis.settings.load_profile("ci" if os.environ.get("CI") else "local")
# Without these Chromium refuses to run as root and calls its maker at every start.
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Start with the wheel: it takes longest, and runs beside all the rest."""
    items.sort(key=lambda item: item.path.parent.name != "packaging")


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print what the tests measured, which each told by ``record_property``."""
    measured = [
        f"{name}: {value}"
        for report in terminalreporter.getreports("passed")
        for name, value in report.user_properties
    ]
    if measured:
        terminalreporter.section("measured")
        terminalreporter.write_line("\n".join(measured))


@pytest.fixture(scope="session")
def artefacts() -> Path:
    """Return the folder for screenshots, outside git."""
    folder = ROOT / "artefacts"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture(scope="session")
def node() -> str:
    """Return the Node that builds the front end, to run its tests."""
    return str(front_end_build(str(ROOT)).find_node().executable)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Yield a headless Chromium."""
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=ensure(), args=FLAGS)
        yield chromium
        chromium.close()


@pytest.fixture
def page_offline(browser: Browser) -> Iterator[OfflinePage]:
    """Yield a page whose requests to other hosts are refused and noted."""
    refused: list[str] = []

    def elsewhere(address: str) -> bool:
        url = urlsplit(address)
        local = url.scheme in ("file", "data", "blob") or url.hostname in ("localhost", "127.0.0.1")
        return not local

    def refuse(route: Route) -> None:
        refused.append(route.request.url)
        route.abort()

    def refuse_socket(socket: WebSocketRoute) -> None:
        refused.append(socket.url)
        socket.close()

    with browser.new_context() as context:
        context.route(elsewhere, refuse)
        context.route_web_socket(elsewhere, refuse_socket)
        yield OfflinePage(context.new_page(), refused)


@pytest.fixture(scope="session")
def jupyterlab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """Yield a JupyterLab started by ``casteljau lab`` in an empty folder."""
    home = tmp_path_factory.mktemp("learner")
    casteljau = Path(sys.executable).with_name("casteljau")
    with running_lab([str(casteljau)], home / "casteljau-lessons", home) as lab:
        yield lab

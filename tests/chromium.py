"""Find a Chromium for the browser tests, or install one; `make test` runs this file first."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from playwright.sync_api import Page

COMMANDS = ("chromium", "chromium-browser", "google-chrome")
REMEDY = (
    "expected a Chromium for the browser tests, found none and could not install one; install "
    "it from your distribution, or name one: CASTELJAU_CHROMIUM=/path/to/chromium make test"
)


class OfflinePage(NamedTuple):
    """A page that reaches nothing but this machine."""

    page: Page
    refused: list[str]  # addresses it asked for all the same


def chromium_path() -> str | None:
    """Return the browser to use: the one named, the machine's, Playwright's, or None."""
    named = os.environ.get("CASTELJAU_CHROMIUM")
    if named and not runs(named):
        sys.exit(f"expected CASTELJAU_CHROMIUM to name a browser, got {named!r}; mend or unset it")
    found = [named] if named else filter(None, map(shutil.which, COMMANDS))
    return next(filter(runs, found), None) or downloaded()


def runs(path: str) -> bool:
    """Tell whether a browser starts: a downloaded one may lack libraries of the system."""
    try:
        return subprocess.run([path, "--version"], capture_output=True).returncode == 0
    except OSError:
        return False


def downloaded() -> str | None:
    """Return Playwright's own browser, if there is one that starts."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        path = playwright.chromium.executable_path
    return path if runs(path) else None


def from_playwright() -> None:
    run(sys.executable, "-m", "playwright", "install", "chromium")


def from_distribution() -> None:
    if shutil.which("apt-get") and os.geteuid() == 0:
        run("apt-get", "update")
        run(
            "apt-get", "install", "--yes", "--no-install-recommends", "chromium", "fonts-liberation"
        )


def run(*command: str) -> None:
    print("$", *command, flush=True)
    subprocess.run(command, stdin=subprocess.DEVNULL, check=False)


def ensure() -> str:
    """Return a browser, installed if need be; end with a remedy where that fails."""
    ways: tuple[Callable[[], None], ...] = (from_playwright, from_distribution)
    for install in ways:
        path = chromium_path()
        if path:
            return path
        install()
    return chromium_path() or sys.exit(REMEDY)


if __name__ == "__main__":
    print("Chromium:", ensure())

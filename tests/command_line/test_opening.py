"""A working copy in JupyterLab."""

from chromium import OfflinePage
from serving import Lab


def test_to_open_and_save_a_copy_does_not_edit_it(
    page_offline: OfflinePage, jupyterlab: Lab
) -> None:
    copy = min(jupyterlab.folder.glob("*.ipynb"))
    before, written = copy.read_bytes(), copy.stat().st_mtime_ns
    page = page_offline.page
    page.goto(jupyterlab.url)
    page.get_by_text("Python 3 (ipykernel) | Idle").wait_for(timeout=60_000)
    for _ in range(60):  # JupyterLab takes the shortcut only once it has finished starting
        page.locator(".jp-Notebook").first.press("Control+s")
        page.wait_for_timeout(1000)
        if copy.stat().st_mtime_ns != written:
            break
    assert copy.stat().st_mtime_ns != written and copy.read_bytes() == before
    assert page_offline.refused == []

"""Run a lesson in a fresh kernel, straight from its Markdown, and say what is wrong with it."""

import os
import re
from collections.abc import Iterator
from pathlib import Path

import jupytext
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell

TIMEOUT = 120  # seconds for one cell
VIEW = "application/vnd.jupyter.widget-view+json"
INLINE = {"MPLBACKEND": "module://matplotlib_inline.backend_inline"}
QUESTIONS = {"prediction", "exercise"}
# Run after every question: each mistake it lists must be the one that is named.
MAKE_MISTAKES = """
for sentence, wrong in mistakes.items():
    named = check(wrong, expected, mistakes).diagnosis
    assert named == sentence, f"the mistake {sentence!r} is named {named!r}"
assert check(expected, expected, mistakes), "the expected answer is refused"
"""


def complaints(path: Path, folder: Path) -> list[str]:
    """Run a lesson in a folder; return lines such as ``01_x.md:12: NameError: ...``."""
    book = read(path)
    client = NotebookClient(
        book,
        timeout=TIMEOUT,
        kernel_name="python3",
        store_widget_state=True,
        resources={"metadata": {"path": str(folder)}},
    )
    try:
        client.execute(env={**os.environ, **INLINE})
    except CellExecutionError as error:
        cell = next(c for c in code_cells(book) if any(errors(c)))
        where = line_of(cell, next(errors(cell))["traceback"])
        return [f"{path.name}:{where}: {error.ename}: {error.evalue}"]
    return [
        f"{path.name}:{cell.metadata.line}: {trouble}"
        for cell in code_cells(book)
        for trouble in broken_promises(cell, client.widget_state)
    ]


def read(path: Path) -> NotebookNode:
    """Return a lesson as a notebook whose code cells know their line, mistakes to make included."""
    text = path.read_text("utf-8")
    lines = text.splitlines()
    fences = (n for n, line in enumerate(lines) if line.startswith("```{code-cell}"))
    book = jupytext.reads(text, fmt="md:myst")
    cells = []
    for cell in book.cells:
        cells.append(cell)
        if cell.cell_type == "code":
            cell.metadata.line = 1 + lines.index(cell.source.splitlines()[0], next(fences))
        if QUESTIONS & tags(cell):
            cells.append(new_code_cell(MAKE_MISTAKES, metadata={"line": cell.metadata.line}))
    book.cells = cells
    return book


def broken_promises(cell: NotebookNode, widgets: dict) -> list[str]:
    """Return what a cell that ran did not do as it should."""
    texts = [output.get("data", {}).get("text/plain", "") for output in cell.outputs]
    found = [f"warns: {o.text}" for o in cell.outputs if o.get("name") == "stderr"]
    if QUESTIONS & tags(cell) and not any("Not answered yet" in text for text in texts):
        found.append("a question must show that it is not answered yet")
    if "solution" in tags(cell) and not any(text.endswith("Right.") for text in texts):
        found.append(f"this solution is not right: {texts}")
    for output, text in zip(cell.outputs, texts, strict=True):
        view = output.get("data", {}).get(VIEW, {})
        if (view or "Figure object" in text) and "scene" not in widgets.get(
            view.get("model_id"), {}
        ):
            found.append("this figure did not reach the page")
    return found


def line_of(cell: NotebookNode, traceback: list[str]) -> int:
    """Return the line of the lesson where a cell failed."""
    place = re.search(r"Cell.* line (\d+)", re.sub(r"\x1b\[[\d;]*m", "", "\n".join(traceback)))
    within = int(place[1]) - 1 if place and cell.source != MAKE_MISTAKES else 0
    return cell.metadata.line + within


def errors(cell: NotebookNode) -> Iterator[NotebookNode]:
    """Yield the error outputs of a cell."""
    return (output for output in cell.get("outputs", ()) if output.output_type == "error")


def code_cells(book: NotebookNode) -> list[NotebookNode]:
    """Return the cells with code."""
    return [cell for cell in book.cells if cell.cell_type == "code"]


def tags(cell: NotebookNode) -> set[str]:
    """Return the tags of a cell."""
    return set(cell.metadata.get("tags", ()))

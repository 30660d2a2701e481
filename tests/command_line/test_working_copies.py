"""Laws of the working copies: above all, an edit is never lost."""

import json
import os
import tempfile
from pathlib import Path

import jupytext
import nbformat
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from working_copies import LESSONS, STATE, notebook, write_copies

ROOT = Path(__file__).parent.parent.parent
HEADER = """---
jupytext:
  text_representation: {extension: .md, format_name: myst}
kernelspec: {display_name: Python 3, language: python, name: python3}
---

"""
LESSON = HEADER + "# Lines\n\n```{code-cell} ipython3\n:tags: [hide-input]\n\n1 + 1\n```\n"


@pytest.fixture
def lessons(tmp_path: Path) -> Path:
    folder = tmp_path / "lessons"
    folder.mkdir()
    (folder / "01_lines.md").write_text(LESSON)
    (folder / "02_curves.md").write_text(LESSON + "\nand curves\n")
    (folder / "LICENSE").write_text("not a lesson")
    (folder / "notes.md").write_text("not a lesson")
    return folder


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "copies"


def files(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()} - {STATE}


def test_copies_of_all_lessons_and_of_nothing_else(lessons: Path, folder: Path) -> None:
    assert write_copies(lessons, folder, "0.1.0") == {
        "01_lines.ipynb": "written",
        "02_curves.ipynb": "written",
    }
    assert files(folder) == {"01_lines.ipynb", "02_curves.ipynb"}
    assert set(write_copies(lessons, folder, "0.1.0").values()) == {"current"}


def test_a_copy_is_a_valid_notebook_that_never_ran(lessons: Path) -> None:
    text = notebook(lessons / "01_lines.md")
    assert text == notebook(lessons / "01_lines.md")
    book = nbformat.reads(text.decode(), as_version=4)
    nbformat.validate(book)
    assert [cell.cell_type for cell in book.cells] == ["markdown", "code"]
    assert book.cells[1].source == "1 + 1" and book.cells[1].metadata.tags == ["hide-input"]
    assert book.cells[1].outputs == [] and book.cells[1].execution_count is None
    assert book.metadata.kernelspec.name == "python3" and "jupytext" not in book.metadata


@pytest.mark.parametrize("lesson", sorted((ROOT / "lessons").glob(LESSONS)), ids=lambda p: p.stem)
def test_our_lessons_become_valid_notebooks(lesson: Path) -> None:
    book = nbformat.reads(notebook(lesson).decode(), as_version=4)
    nbformat.validate(book)
    assert [cell.source for cell in book.cells] == [
        cell.source for cell in jupytext.read(lesson).cells
    ]


def test_an_edited_copy_gets_the_next_edition_beside_it_once(lessons: Path, folder: Path) -> None:
    write_copies(lessons, folder, "0.1.0")
    (folder / "01_lines.ipynb").write_text("mine")
    assert write_copies(lessons, folder, "0.1.0")["01_lines.ipynb"] == "kept"
    (lessons / "01_lines.md").write_text(LESSON + "\nmore\n")
    assert write_copies(lessons, folder, "0.2.0")["01_lines.0.2.0.ipynb"] == "written"
    (folder / "01_lines.0.2.0.ipynb").unlink()
    for edition in ("0.2.0", "0.3.0"):
        assert write_copies(lessons, folder, edition)["01_lines.0.2.0.ipynb"] == "kept"
        assert files(folder) == {"01_lines.ipynb", "02_curves.ipynb"}
    assert (folder / "01_lines.ipynb").read_text() == "mine"


def test_editions_beside_edited_copies_are_not_written_over_either(
    lessons: Path, folder: Path
) -> None:
    for number in range(3):
        (lessons / "01_lines.md").write_text(LESSON + f"\nedition {number}\n")
        (name,) = set(write_copies(lessons, folder, "0.1.0")) - {"02_curves.ipynb"}
        (folder / name).write_text(f"mine {number}")
    names = ("01_lines.ipynb", "01_lines.0.1.0.ipynb", "01_lines.0.1.0-2.ipynb")
    assert [(folder / name).read_text() for name in names] == ["mine 0", "mine 1", "mine 2"]


@pytest.mark.parametrize("state", [None, "", "{", "[]", "3", '{"01_lines.ipynb": 1}', "\udcff"])
def test_without_its_memory_every_copy_counts_as_edited(
    lessons: Path, folder: Path, state: str | None
) -> None:
    write_copies(lessons, folder, "0.1.0")
    before = (folder / "01_lines.ipynb").read_bytes()
    if state is None:
        (folder / STATE).unlink()
    else:
        (folder / STATE).write_bytes(state.encode("utf-8", "surrogateescape"))
    (lessons / "01_lines.md").write_text(LESSON + "\nmore\n")
    assert write_copies(lessons, folder, "0.2.0")["01_lines.ipynb"] == "kept"
    assert (folder / "01_lines.ipynb").read_bytes() == before
    assert json.loads((folder / STATE).read_bytes())


def test_a_folder_in_the_place_of_a_copy_is_left_alone(lessons: Path, folder: Path) -> None:
    (folder / "01_lines.ipynb").mkdir(parents=True)
    assert write_copies(lessons, folder, "0.1.0")["01_lines.ipynb"] == "kept"


def test_an_interrupted_write_leaves_the_old_copy(
    lessons: Path, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_copies(lessons, folder, "0.1.0")
    before = {name: (folder / name).read_bytes() for name in files(folder)}
    (lessons / "01_lines.md").write_text(LESSON + "\nmore\n")

    def stop(source: Path, target: Path) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patched, pytest.raises(KeyboardInterrupt):
        patched.setattr(os, "replace", stop)
        write_copies(lessons, folder, "0.1.0")
    assert {name: (folder / name).read_bytes() for name in files(folder)} == before


ACTIONS = st.lists(
    st.sampled_from(["edit", "edit beside", "delete", "lesson", "version", "forget", "start"]),
    max_size=12,
)


@given(ACTIONS)
@settings(max_examples=60, deadline=None)
def test_whatever_happens_no_edit_is_lost(actions: list[str]) -> None:
    with tempfile.TemporaryDirectory() as name:
        lessons, folder = Path(name, "lessons"), Path(name, "copies")
        lessons.mkdir()
        lesson, own = lessons / "01_lines.md", folder / "01_lines.ipynb"
        lesson.write_text(LESSON)
        version, edits, forgot = 1, dict[Path, str](), False
        write_copies(lessons, folder, "0.1.0")
        for number, action in enumerate([*actions, "start"]):
            beside = sorted(set(folder.glob("*.ipynb")) - {own})
            if action == "edit" or (action == "edit beside" and beside):
                path = own if action == "edit" else beside[-1]
                path.write_text(f"edit {number}")
                edits[path] = f"edit {number}"
            elif action == "delete":
                own.unlink(missing_ok=True)
                edits.pop(own, None)
            elif action == "lesson":
                lesson.write_text(LESSON + f"\nchange {number}\n")
            elif action == "version":
                version += 1
            elif action == "forget":
                (folder / STATE).unlink(missing_ok=True)
                forgot = True
            elif action == "start":
                (copy,) = write_copies(lessons, folder, f"0.{version}.0")
                assert own.exists()
                held = [path.read_bytes() for path in folder.glob("*.ipynb") if path not in edits]
                # Whoever neither edited the newest edition nor deleted the memory has it.
                if not forgot and folder / copy not in edits:
                    assert notebook(lesson) in held
            assert {path: path.read_text() for path in edits} == edits

"""Every lesson runs from top to bottom, and does for a learner what lessons/README.md says."""

from pathlib import Path
from time import perf_counter

import pytest

from lessons.lesson_runner import QUESTIONS, code_cells, complaints, read, tags

FOLDER = Path(__file__).parents[2] / "lessons"
LESSONS = sorted(FOLDER.glob("[0-9][0-9]_*.md"))
each_lesson = pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)

HEADER = """---
kernelspec:
  display_name: Python 3
  name: python3
---

```{code-cell} ipython3
from symbolic import check
```
"""
PROMISES = """
```{code-cell} ipython3
:tags: [exercise]

expected, mistakes = 2, {}
```

```{code-cell} ipython3
:tags: [solution]

check(1, 2)
```

```{code-cell} ipython3
import warnings
warnings.warn("old")
```

```{code-cell} ipython3
display({"text/plain": "<widgets.figure.Figure object>"}, raw=True)
```
"""


@each_lesson
def test_runs_and_keeps_its_promises(path, tmp_path, record_property):
    start = perf_counter()
    found = complaints(path, tmp_path)
    record_property(f"{path.name}, seconds", round(perf_counter() - start, 1))
    if found:
        pytest.fail("\n".join(f"lessons/{line}" for line in found), pytrace=False)


@each_lesson
def test_predicts_practises_and_solves(path):
    cells = [cell for cell in code_cells(read(path)) if tags(cell)]
    kinds = [next(iter(tags(cell) & {*QUESTIONS, "solution"})) for cell in cells]
    assert kinds.count("prediction") >= 1
    assert kinds.count("exercise") >= 3
    after = {b for a, b in zip(kinds, kinds[1:], strict=False) if a == "exercise"}
    assert after == {"solution"}
    for cell in cells:
        if "solution" in tags(cell):
            assert cell.metadata.jupyter.source_hidden
            assert cell.source.startswith("# A solution"), "JupyterLab shows the first line"


def report(text: str, folder: Path) -> list[str]:
    path = folder / "99_broken.md"
    path.write_text(HEADER + text, encoding="utf-8")
    return complaints(path, folder)


@pytest.mark.parametrize(
    "code, complaint",
    [
        ("a = 1\na / 0", ":13: ZeroDivisionError: division by zero"),
        ("a = = 1", ":12: SyntaxError: invalid syntax"),
        (
            ":tags: [exercise]\n\nexpected, mistakes = 2, {'Odd.': 4, 'No.': 4}",
            ":14: AssertionError: the mistake 'Odd.' is named 'One of these: Odd. Or: No.'",
        ),
    ],
    ids=["error", "syntax", "mistake named wrongly"],
)
def test_a_failing_cell_is_reported_with_its_line(code, complaint, tmp_path):
    (found,) = report(f"\n```{{code-cell}} ipython3\n{code}\n```\n", tmp_path)
    assert found.startswith("99_broken.md" + complaint)


def test_broken_promises_are_reported_with_their_lines(tmp_path):
    found = report(PROMISES, tmp_path)
    for line, complaint in zip(found, [
        ":14: a question must show that it is not answered yet",
        ":20: this solution is not right",
        ":24: warns: ",
        ":29: this figure did not reach the page",
    ], strict=True):  # fmt: skip
        assert line.startswith("99_broken.md" + complaint)

"""The front end's own tests, by Node's test runner; and what its bundles may not contain."""

import re
import subprocess
from pathlib import Path

import pytest

from numeric.tape.operations import BINARY, UNARY
from widgets.figure import bundle

HERE = Path(__file__).parent
FRONT_END = HERE.parents[1] / "widgets" / "front_end"


def test_node_tests_pass(node):
    files = sorted(str(path) for path in HERE.glob("*.test.mjs"))
    assert files
    result = subprocess.run([node, "--test", *files], capture_output=True, text=True, cwd=HERE)
    assert result.returncode == 0, result.stdout + result.stderr
    assert re.search(r"^# fail 0$|^ℹ fail 0$", result.stdout, re.MULTILINE), result.stdout


@pytest.mark.parametrize("name", ["figure.mjs", "figure.page.js"])
def test_bundles_hold_no_evaluation_of_text(name):
    """A strict content-security policy forbids it, and a saved notebook must stay inert."""
    text = bundle(name)
    assert not re.search(r"\beval\s*\(|new Function|\bFunction\s*\(|setTimeout\s*\(\s*[\"'`]", text)
    assert "http://" not in text.replace("http://www.w3.org/", "")
    assert "https://" not in text


@pytest.mark.parametrize("operation", [*UNARY, *BINARY])
def test_the_interpreter_knows_every_operation(operation):
    source = (FRONT_END / "tape.js").read_text(encoding="utf-8")
    assert re.search(rf"\b{operation}\b", source)

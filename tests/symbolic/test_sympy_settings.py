"""Results do not hang on how SymPy is set up: FLINT only speeds it up, its cache even less."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
ROOT = HERE.parents[1]


@pytest.mark.parametrize(("setting", "value", "tests"), [
    ("SYMPY_GROUND_TYPES", "python", [HERE / "test_laws.py", HERE / "vectors", ROOT / "symbolic"]),
    ("SYMPY_USE_CACHE", "no", [HERE / "test_verdicts.py", ROOT / "symbolic" / "proofs"]),
])  # fmt: skip
def test_the_same_holds_with_another_setting(setting, value, tests):
    command = [sys.executable, "-m", "pytest", "--quiet", "--numprocesses=0", *map(str, tests)]
    run = subprocess.run(command, env=os.environ | {setting: value}, cwd=ROOT, text=True,
                         capture_output=True, check=False)  # fmt: skip
    assert run.returncode == 0, run.stdout[-3000:]

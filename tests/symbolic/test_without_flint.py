"""FLINT speeds SymPy up but is never needed: the exact core without it gives the same results."""

import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
TESTS = [HERE / "test_laws.py", HERE / "vectors", HERE.parents[1] / "symbolic"]


def test_laws_vectors_and_examples_hold_with_python_numbers():
    command = [sys.executable, "-m", "pytest", "--quiet", "--numprocesses=0", *map(str, TESTS)]
    environment = os.environ | {"SYMPY_GROUND_TYPES": "python"}
    run = subprocess.run(command, env=environment, cwd=HERE.parents[1], text=True,
                         capture_output=True, check=False)  # fmt: skip
    assert run.returncode == 0, run.stdout[-3000:]

"""What README shows runs, and prints what it says."""

import doctest
import re
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from numeric import Curve
from symbolic import bernstein, de_casteljau
from widgets import Figure, Scene

README = Path(__file__).parents[1] / "README.md"
BLOCKS = re.findall(r"```python\n(.*?)```", README.read_text("utf-8"), re.DOTALL)
# What a block takes for granted from the text around it.
GIVEN = {
    "points": [[0, 0], [1, 2], [2, 0], [3, 2], [4, 1]],
    "knots": [0, 0, 0, 0, 1, 2, 2, 2, 2],
    "t": np.linspace(0, 2, 5),
    "other": Curve.from_bezier([[0, 1], [4, 1]]),
    "Scene": Scene,
    "Figure": Figure,
    "Symbol": sp.Symbol,
    "bernstein": bernstein,
    "de_casteljau": de_casteljau,
}


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: block.split("\n")[0])
def test_a_block_runs(block: str) -> None:
    if ">>>" not in block:
        exec(compile(block, "README.md", "exec"), dict(GIVEN))
        return
    found = doctest.DocTestParser().get_doctest(block, {}, "README.md", None, 0)
    told: list[str] = []
    doctest.DocTestRunner().run(found, out=told.append)
    assert not told, "".join(told)


def test_there_are_blocks_of_both_kinds() -> None:
    assert {">>>" in block for block in BLOCKS} == {True, False}

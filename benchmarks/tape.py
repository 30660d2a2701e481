"""How long a figure's tape takes to compile, and one frame of it, in NumPy and in Node."""

from __future__ import annotations

import json
import shutil
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np
import sympy as sp

from numeric import Tape, compile_tape
from symbolic import de_casteljau

SAMPLES = 129
RUNS = 25
INTERPRETER = Path(__file__).parents[1] / "widgets" / "front_end" / "tape.js"
# Runs the browser's interpreter on the tape that comes by standard input, as a figure does.
TIMER = """
const { load } = await import(process.argv[1]);
let text = ""; for await (const part of process.stdin) text += part;
const { tape, axes, inputs } = JSON.parse(text);
const program = load(tape, axes), times = [];
for (let k = 0; k < 3000; k++) {
  const start = performance.now(); program.run(inputs); times.push(performance.now() - start);
}
times.sort((a, b) => a - b);
console.log(times[times.length >> 1]);
"""


def scheme(degree: int) -> tuple[dict[str, object], list[sp.Symbol]]:
    """Return all levels at t and the curve over u, as outputs and inputs of a tape."""
    points = [sp.symbols(f"P{i}_x P{i}_y") for i in range(degree + 1)]
    t, u = sp.symbols("t u")
    levels = de_casteljau(points, t)
    outputs = {f"level{r}": level for r, level in enumerate(levels)}
    inputs = [*(c for point in points for c in point), t, u]
    return outputs | {"curve": de_casteljau(points, u)[-1][0]}, inputs


def milliseconds(work: Callable[[], object], runs: int = RUNS) -> float:
    """Return the median time of some runs."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(1e3 * (time.perf_counter() - start))
    return median(times)


def in_node(tape: Tape, values: list[float]) -> float:
    """Return the median time of a frame in Node, or nan without one."""
    node = shutil.which("node")
    if node is None:
        return float("nan")
    axes = [{"low": 0, "high": 1, "count": SAMPLES}]
    job = json.dumps({"tape": tape.to_json(), "axes": axes, "inputs": values})
    command = [node, "--input-type=module", "-e", TIMER, INTERPRETER.as_uri()]
    return float(
        subprocess.run(command, input=job, text=True, capture_output=True, check=True).stdout
    )


def main() -> None:
    """Print a line a degree."""
    print(f"{'degree':>6} {'compile ms':>10} {'bytes':>7} {'NumPy ms':>9} {'Node ms':>8}")
    for degree in (3, 7, 12):
        outputs, inputs = scheme(degree)
        tape = compile_tape(outputs, inputs)
        compiling = milliseconds(lambda o=outputs, i=inputs: compile_tape(o, i))
        values = np.random.default_rng(0).normal(size=len(inputs) - 1).tolist()
        frame = milliseconds(lambda p=tape, v=values: p.run([*v, np.linspace(0, 1, SAMPLES)]))
        size = len(json.dumps(tape.to_json(), separators=(",", ":")))
        print(f"{degree:6} {compiling:10.2f} {size:7} {frame:9.3f} {in_node(tape, values):8.4f}")


if __name__ == "__main__":
    main()

"""Values of many segments at many parameters, a chunk that fits in the cache at a time."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..bernstein.evaluation import point_tape
from ..bernstein.form import to_powers
from ..tape.runner import CHUNK, Runner
from .spans import Spans

# Largest error against exact values, relative to the largest control point, over random and
# alternating control points: degree 3 1e-15, 5 6e-15, 7 5e-14, 8 2e-13, 12 2e-11, 20 5e-8. The
# Bernstein form stays near 1e-15 at every degree, and costs a few times more.
# `python -m benchmarks.horner_degree` measures it.
HORNER_DEGREE = 7


def coefficient_table(rows: np.ndarray) -> np.ndarray:
    """Return what `evaluate` reads, shape (n + 1, columns, m): powers up to `HORNER_DEGREE`."""
    horner = rows.shape[1] - 1 <= HORNER_DEGREE
    return np.ascontiguousarray(np.moveaxis(to_powers(rows) if horner else rows, 0, 2))


def evaluate(table: np.ndarray, rational: bool, spans: Spans, t: np.ndarray) -> np.ndarray:
    """Return points at parameters t of one dimension, one coordinate a row: (dim, len(t)).

    Every t must be inside the spans' domain, or belongs to the first or last segment's polynomial;
    NaN and infinities give NaN.

    Notes
    -----
    A chunk that lies in one segment reads its coefficients as numbers; one of increasing
    parameters repeats them by segment; any other gathers them by index.
    """
    degree, columns, _ = table.shape
    tape = point_tape(degree - 1, columns, rational, degree - 1 <= HORNER_DEGREE)
    rows = table.reshape(degree * columns, -1)
    out = np.empty((columns - rational, len(t)))
    runners: dict[tuple[bool, int], Runner] = {}
    with np.errstate(all="ignore"):
        for start in range(0, len(t), CHUNK):
            chunk = t[start : start + CHUNK]
            u, gather = spans.locate(chunk)
            inputs: list[Any] = [gather(row) for row in rows]
            key = (np.ndim(inputs[0]) > 0, len(chunk))
            if key not in runners:
                runners[key] = Runner(tape, [np.shape(value) for value in (*inputs, u)])
            runners[key].run([*inputs, u], out[:, start : start + CHUNK])
    return out

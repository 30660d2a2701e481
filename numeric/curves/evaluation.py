"""Values of many segments at many parameters, a chunk that fits in the cache at a time."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from ..bernstein.evaluation import point_plan
from ..bernstein.form import to_powers
from ..tape.runner import CHUNK, Runner
from .spans import Spans, Workspace

# Largest error against exact values, relative to the largest control point, over random and
# alternating control points (`python -m benchmarks.stability`; a test holds the table):
#
#   degree      Bernstein form         power form, Horner's rule
#            float64    float32         float64    float32
#      3     4e-16      3e-7            3e-15      2e-6
#      7     8e-16      4e-7            3e-13      2e-4
#     12     1e-15      5e-7            3e-11      2e-2
#     25     2e-15      1e-6            1e-4       all digits
#
# The power form loses half a digit a degree, since its coefficients are up to 3^n times larger
# than the control points they are made of. It costs a third of the time.
HORNER_DEGREE = 7

# Errors of the power form are errors of a segment's largest weight: divided by one that is this
# many times smaller, a point loses so many times more. From there on the Bernstein form is taken,
# whose errors shrink with the weight.
UNEVEN = 8.0

# Powers of these lengths and sizes stay far from the largest and smallest floats.
SAFE_LENGTHS = (1e-20, 1e20)
SAFE_SIZES = (1e-100, 1e100)
# Sums of coefficients above this may overflow: they are taken times a power of two.
HUGE, DOWN = 1e250, -200


class Table(NamedTuple):
    """Coefficients as `evaluate` reads them.

    Attributes
    ----------
    coefficients : array, shape (n + 1, columns, segments)
        Of powers or Bernstein polynomials.
    powers : bool
        Which of them: powers up to `HORNER_DEGREE`, unless weights are `UNEVEN`.
    lengths : array, shape (segments,), or None
        What t - start is to be divided by; None if the coefficients are those of its powers.
    up : int
        The coordinates are 2 to this power times the values; in a quotient it does not matter.
    """

    coefficients: np.ndarray
    powers: bool
    lengths: np.ndarray | None
    up: int


def coefficient_table(rows: np.ndarray, breaks: np.ndarray, rational: bool) -> Table:
    """Return the table of segments with these rows (m, n + 1, columns) over these breaks."""
    lengths, n = np.diff(breaks), rows.shape[1] - 1
    powers = n <= HORNER_DEGREE and not (rational and _uneven(rows[..., -1]))
    taken_up, huge = False, bool(np.abs(rows).max() > HUGE)
    if huge:
        rows = np.ldexp(rows, DOWN)
    if powers:
        rows = to_powers(rows)
        sizes = np.abs(rows).max(axis=(0, 1))  # weights and each coordinate have their own
        if _within(lengths, SAFE_LENGTHS) and _within(sizes[sizes > 0], SAFE_SIZES):
            rows = rows / lengths[:, None, None] ** np.arange(n + 1)[:, None]
            taken_up = True
    coefficients = np.ascontiguousarray(np.moveaxis(rows, 0, 2))
    return Table(coefficients, powers, None if taken_up else lengths, -DOWN if huge else 0)


def _uneven(weights: np.ndarray) -> bool:
    weights = weights * np.sign(weights[:, :1])
    return bool((UNEVEN * weights.min(axis=1) < weights.max(axis=1)).any())


def _within(values: np.ndarray, bounds: tuple[float, float]) -> bool:
    return bool((values >= bounds[0]).all() and (values <= bounds[1]).all())


def evaluate(
    table: Table,
    rational: bool,
    spans: Spans,
    t: np.ndarray,
    check: Callable[[np.ndarray], np.ndarray] | None = None,
) -> np.ndarray:
    """Return points at parameters t of one dimension, one coordinate a row: (dim, len(t)).

    A t outside the spans' domain belongs to the polynomial of the first or last segment; NaN gives
    NaN. `check` returns the parameters of a chunk as they are to be taken, or raises.

    Notes
    -----
    A chunk that lies in one segment reads its coefficients as numbers, any other one fetches them
    by index, each into the cache where it is needed.
    """
    count, columns, _ = table.coefficients.shape
    kind = count - 1, columns, rational, table.powers
    rows = table.coefficients.reshape(count * columns, -1)
    out = np.empty((columns - rational, len(t)))
    work, local = Workspace.of(min(len(t), CHUNK)), np.empty(min(len(t), CHUNK))
    runners: dict[tuple[bool, int], Runner] = {}
    with np.errstate(all="ignore"):
        for first in range(0, len(t), CHUNK):
            chunk = t[first : first + CHUNK]
            chunk = check(chunk) if check else chunk  # now that it comes into the cache
            u = local[: len(chunk)]
            one, gather = spans.locate(chunk, work)
            beginning = gather(spans.breaks, u)
            u = chunk if one and beginning == 0 else np.subtract(chunk, beginning, out=u)
            if table.lengths is not None:
                u = u / gather(table.lengths, work.numbers[: len(chunk)])
            key = (one, len(chunk))
            if key not in runners:
                runners[key] = Runner(point_plan(*kind, one), len(chunk))
            inputs = [gather(row, u) if one else partial(gather, row) for row in rows]
            runners[key].run([*inputs, u], out[:, first : first + CHUNK])
        if table.up and not rational:
            np.ldexp(out, table.up, out=out)
    if count == 1:  # a constant, also at what is no number
        out[:, np.isnan(t) | np.isinf(t)] = np.nan
    return out

"""How memory and time grow with points, segments and degree."""

from __future__ import annotations

import tracemalloc
from collections.abc import Iterator

import numpy as np

from numeric import Curve
from numeric.tape.runner import CHUNK

from .timing import medians


def limits(points: int) -> Iterator[str]:
    """Yield lines of text: peak memory beyond the result, ns a point for ever more of something."""
    rng = np.random.default_rng(1)
    yield from _memory(points, rng)
    yield ""
    t = rng.random(10 * points)
    counts = [points // 100, points // 10, points, 10 * points]
    curve = _curve(1000, 3, rng)
    works = {f"{n:g}": lambda n=n: curve(t[:n]) for n in counts}
    yield _line("ns a point by the number of points", medians(works), counts)
    for sorted_t in (True, False):
        t = np.sort(rng.random(points)) if sorted_t else rng.random(points)
        curves = {f"{m:g}": _curve(m, 3, rng) for m in (1, 10, 1000, 10**5)}
        works = {m: lambda c=c, t=t: c(t) for m, c in curves.items()}
        order = "sorted" if sorted_t else "unsorted"
        yield _line(f"... by the number of segments, t {order}", medians(works), [points] * 4)
    curves = {str(n): _curve(1, n, rng) for n in (1, 3, 7, 8, 16, 25)}
    works = {n: lambda c=c: c(t) for n, c in curves.items()}
    yield _line("... by degree", medians(works), [points] * 6)


def _memory(points: int, rng: np.random.Generator) -> Iterator[str]:
    t = rng.random(points)
    for m, n in ((1, 3), (1000, 3), (1, 12)):
        curve = _curve(m, n, rng)
        curve(t[:2])
        tracemalloc.start()
        size = curve(t).nbytes
        peak = tracemalloc.get_traced_memory()[1] - size
        tracemalloc.stop()
        yield (
            f"memory beyond the result, {m} segment{'s' * (m > 1)} of degree {n}: "
            f"{peak / 1e6:.2f} MB, or {peak / (8 * CHUNK):.1f} arrays of a chunk; "
            f"the result {size / 1e6:.1f} MB"
        )


def _curve(segments: int, degree: int, rng: np.random.Generator) -> Curve:
    return Curve.from_bezier(rng.random((segments, degree + 1, 2)))


def _line(what: str, times: dict[str, float], counts: list[int]) -> str:
    told = [
        f"{key}: {1e6 * ms / n:.3g}" for (key, ms), n in zip(times.items(), counts, strict=True)
    ]
    return f"{what}: " + ", ".join(told)

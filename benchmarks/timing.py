"""Times of several ways to do one task, taken in turn so that a busy moment meets all of them."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from statistics import median
from typing import NamedTuple

Work = Callable[[], object]


class Row(NamedTuple):
    """One task: works by who does them, what to multiply their times by, and our aim."""

    name: str
    works: dict[str, Work]
    factors: dict[str, float]
    at_most: float | None = None


def milliseconds(work: Work) -> float:
    """Return the time of one run."""
    start = time.perf_counter()
    work()
    return 1e3 * (time.perf_counter() - start)


def medians(works: Mapping[str, Work], seconds: float = 1.0, most: int = 200) -> dict[str, float]:
    """Return the median time in ms of every work, in rounds of one run each.

    Every work has one run untimed and three timed, and further ones until it has used its seconds.
    """
    times: dict[str, list[float]] = {name: [] for name in works}
    for work in works.values():
        work()
    busy = set(works)
    while busy:
        for name in works:  # in one order, round by round
            if name in busy:
                times[name].append(milliseconds(works[name]))
                taken = times[name]
                if len(taken) >= most or (len(taken) >= 3 and sum(taken) > 1e3 * seconds):
                    busy.remove(name)
    return {name: median(taken) for name, taken in times.items()}

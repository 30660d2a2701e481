"""The benchmarks run, and every way is right before it is timed; how fast is not asserted."""

from pathlib import Path

import pytest

from benchmarks import limits, numeric, picture, timing


def test_all_rows_are_checked_timed_told_and_drawn(tmp_path: Path) -> None:
    told = [numeric.tell(row, seconds=0) for row in numeric.rows(points=300)]
    assert all(row.times["ours"] > 0 for row in told)
    lines = numeric.table(told).splitlines()
    assert len(lines) == len(told) + 2 and len({line.count("|") for line in lines}) == 1
    file = tmp_path / "a.png"
    picture.draw([(row.name, row.times) for row in told], str(file))
    assert file.stat().st_size > 10_000
    assert sum(line.startswith("memory") for line in limits.limits(points=200)) == 3


def test_a_wrong_way_is_found_before_it_is_timed() -> None:
    with pytest.raises(AssertionError, match="wrong"):
        numeric.evaluation_row(
            "a line", {"wrong": lambda t: numeric.np.stack([t, t]).T}, numeric.np.linspace(0, 1, 9),
            lambda u: (u, u * u),
        )  # fmt: skip


def test_every_way_is_timed_at_least_three_times() -> None:
    calls = {"a": 0, "b": 0}

    def count(who: str) -> None:
        calls[who] += 1

    times = timing.medians({who: lambda who=who: count(who) for who in calls}, seconds=0)
    assert set(times) == set(calls) and calls == {"a": 4, "b": 4}

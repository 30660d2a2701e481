"""The Kochanek-Bartels explorer against the formulas of the paper of 1984."""

import numpy as np
import pytest

from symbolic import BadValue
from tests.widgets.explored import inputs, outputs, verdicts
from widgets import explore

SETTINGS = [(0, 0, 0), (0.5, 0, 0), (0.25, -0.5, 0.75), (-1, 1, 1), (1, 0.5, -1), (0, -1, 0)]


def at(settings, *points):
    fig = explore.kochanek_bartels(*points)
    fig["T"], fig["C"], fig["B"] = settings
    return fig


def marks(fig, kind):
    return [m for m in fig.scene["marks"] if m["kind"] == kind]


def paper(p, i, tension, continuity, bias):
    """Return DS and DD at a point, as the paper of 1984 has them."""
    before, after = p[i] - p[i - 1], p[i + 1] - p[i]
    return [
        (1 - tension) / 2 * ((1 + bias) * (1 + sign * continuity) * before
                             + (1 - bias) * (1 - sign * continuity) * after)
        for sign in (-1, 1)
    ]  # fmt: skip


@pytest.mark.parametrize("settings", SETTINGS)
def test_tangents_are_those_of_the_paper(settings):
    fig = at(settings)
    p, found = fig["P"], outputs(fig)
    assert len(marks(fig, "arrows")) == 4
    for i, mark in enumerate(marks(fig, "arrows"), 1):
        assert mark["color"] == i
        arriving, leaving = np.diff(found[mark["output"]], axis=1)[:, 0] * 2
        np.testing.assert_allclose([arriving, leaving], paper(p, i, *settings), atol=1e-12)
    readouts = [found[m["output"]] for m in marks(fig, "readout")]
    np.testing.assert_allclose(readouts, paper(p, 2, *settings), atol=1e-12)


@pytest.mark.parametrize("settings", SETTINGS)
def test_the_curve_is_hermites_with_these_tangents(settings):
    fig = at(settings)
    p = fig["P"]
    drawn = next(m for m in marks(fig, "path") if m["color"] == "curve" and not m["dashed"])
    t = np.linspace(0, 1, 129)[:, None]
    samples = outputs(fig)[drawn["output"]]
    assert samples.shape[1] == 3
    for i in range(1, 4):
        d0, d1 = paper(p, i, *settings)[1], paper(p, i + 1, *settings)[0]
        hermite = ((1 + 2 * t) * (1 - t) ** 2 * p[i] + t * (1 - t) ** 2 * d0
                   - t**2 * (1 - t) * d1 + t**2 * (3 - 2 * t) * p[i + 1])  # fmt: skip
        np.testing.assert_allclose(samples[:, i - 1], hermite, atol=1e-12)


def test_ghosts_are_special_cases():
    fig = at((0.5, 0.25, -0.5))
    ghosts = {"cardinal": (0.5, 0, 0), "catmull-rom": (0, 0, 0)}
    found, paths = outputs(fig), marks(fig, "path")
    dashed = next(m for m in paths if m["dashed"])
    pale = next(m for m in paths if m["from"] == 2 and not m["dashed"])
    for mark, settings in zip((dashed, pale), ghosts.values(), strict=True):
        special = at(settings)
        own = next(m for m in marks(special, "path") if m["color"] == "curve" and not m["dashed"])
        np.testing.assert_allclose(found[mark["output"]], outputs(special)[own["output"]])


def test_blending_functions_make_the_middle_segment():
    fig = at((0.25, -0.5, 0.75))
    found = outputs(fig)
    functions = [m for m in marks(fig, "path") if m["view"] == 1]
    assert [m["color"] for m in functions] == [1, 2, 3, 4]
    weights = np.stack([found[m["output"]].reshape(-1, 2)[:, 1] for m in functions], axis=1)
    middle = next(m for m in marks(fig, "path") if m["color"] == "accent")
    np.testing.assert_allclose(weights.sum(axis=1), 1)
    np.testing.assert_allclose(weights @ fig["P"][1:5], found[middle["output"]].reshape(-1, 2))


@pytest.mark.parametrize("settings", SETTINGS)
def test_c1_is_told_exactly(checker, settings):
    tension, continuity, _ = settings
    assert verdicts(at(settings), checker) == {"C^1 at P_2": continuity == 0 or tension == 1}


def test_all_questions(checker):
    fig = explore.kochanek_bartels()
    letter, tangent, stop = fig.scene["questions"]
    here = inputs(fig)
    assert checker(letter, "C", here) == {
        "right": True,
        "message": "Right: equal at 2 values of C, which proves it, by the degrees of both sides.",
    }
    assert "T shortens" in checker(letter, "T", here)["message"]
    assert "B turns" in checker(letter, "B", here)["message"]
    p = fig["P"]

    def told(point):
        return checker(tangent, f"({point[0]}, {point[1]})", here)

    arriving, leaving = paper(p, 2, 0, 0.5, 0)
    assert told(leaving)["right"]
    assert "arrives" in told(arriving)["message"]
    assert "the arrow" in told(leaving / 2)["message"]
    assert "for C = 0" in told((p[3] - p[1]) / 2)["message"]
    assert "Halve it" in told(2 * leaving)["message"]
    assert checker(stop, "1")["right"] and "doubles" in checker(stop, "-1")["message"]
    assert "Catmull-Rom" in checker(stop, "0")["message"]


@pytest.mark.parametrize("count", range(4, 10))
def test_four_to_nine_points(count):
    fig = explore.kochanek_bartels([[i, i % 3] for i in range(count)])
    assert len(marks(fig, "arrows")) == count - 2
    assert fig.picture().axes


def test_coincident_points_stay_where_they_are():
    fig = at((0.5, -1, 1), [[2, 1]] * 5)
    found = outputs(fig)
    drawn = [found[m["output"]] for m in fig.scene["marks"] if m.get("view") == 0]
    assert all(np.abs(points.reshape(-1, 2) - [2, 1]).max() < 1e-12 for points in drawn)
    assert fig.picture().axes


def test_a_segment_needs_neighbours():
    with pytest.raises(BadValue, match="four points"):
        explore.kochanek_bartels([[0, 0], [1, 1], [2, 0]])

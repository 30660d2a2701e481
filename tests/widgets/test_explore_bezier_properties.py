"""The explorer of Bezier properties: counts, images, shares and questions against NumPy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from numeric import compile_tape
from symbolic import BadValue
from tests.widgets.explored import inputs, shown_marks, verdicts
from widgets import explore
from widgets.explore.bezier_properties import AFFINE, HULL, LINE, changes, crossings
from widgets.picture import _convex_hull


@pytest.fixture(scope="module")
def counting():
    import sympy as sp

    s = sp.symbols("s:4")
    return compile_tape({"polygon": changes(s), "curve": crossings(s)}, list(s))


def sampled_changes(s):
    t = np.linspace(0, 1, 4001)
    values = (
        (1 - t) ** 3 * s[0] + 3 * t * (1 - t) ** 2 * s[1] + 3 * t**2 * (1 - t) * s[2] + t**3 * s[3]
    )
    return int((np.diff(values >= 0) != 0).sum())


@given(st.lists(st.integers(-8, 8), min_size=4, max_size=4))
def test_a_line_never_crosses_the_curve_more_often_than_the_polygon(counting, s):
    told = counting.run([float(v) for v in s])
    assert told["curve"] <= told["polygon"] == np.abs(np.diff(np.array(s) >= 0)).sum()
    assert (told["polygon"] - told["curve"]) % 2 == 0
    assert sampled_changes(s) <= told["curve"]  # two crossings may lie between two samples


@pytest.mark.parametrize(("s", "count"), [
    ((-1, 3, -3, 1), 3), ((-1, 1, -1, 1), 1), ((1, -1, -1, 1), 2), ((1, -1, 1, 1), 0),
    ((0, 0, 0, 0), 0), ((-3, -1, 1, 3), 1), ((1, 0, 0, 1), 0), ((2, -1, -1, 2), 2),
    ((-1, -1, -1, -1), 0),
])  # fmt: skip
def test_crossings_of_the_curve_are_counted(counting, s, count):
    assert counting.run([float(v) for v in s])["curve"] == count


def test_the_hull_holds_the_curve():
    rng = np.random.default_rng(5)
    for points in rng.integers(-8, 9, (20, 4, 2)):
        corners = _convex_hull(points)
        edges = np.roll(corners, -1, axis=0) - corners
        to_points = points[:, None] - corners
        turns = edges[:, 0] * to_points[..., 1] - edges[:, 1] * to_points[..., 0]
        assert (turns >= 0).all()
        assert {tuple(c) for c in corners.tolist()} <= {tuple(p) for p in points.tolist()}


def test_points_of_other_steps_are_not_in_the_picture():
    fig = explore.bezier_properties()
    squares = {}
    for step in (HULL, LINE, AFFINE):
        fig["step"] = step
        plane = fig.picture().axes[0]
        squares[step] = sum(len(c.get_offsets()) for c in plane.collections if c.get_zorder() == 6)
    assert squares == {HULL: 4, LINE: 6, AFFINE: 7}


def test_the_image_of_the_curve_is_the_curve_of_the_images(checker):
    fig = explore.bezier_properties()
    fig["F"] = [[1, 1], [2, -1], [0.5, 4]]
    assert verdicts(fig, checker) == {"Φ(c(t)) on the curve of Φ(b_i)": True}
    wide, thin = (
        values for mark, values in shown_marks(fig)
        if mark["kind"] == "path" and mark["axis"] is not None and mark["from"] == AFFINE
    )  # fmt: skip
    np.testing.assert_allclose(wide, thin, atol=1e-12)


def test_all_questions(checker):
    fig = explore.bezier_properties([[0, 0], [0, 4], [4, 4], [4, 0]])
    fig["F"] = [[1, 0], [1, 2], [-1, 0]]  # a quarter turn and a step to the right
    hull, line, affine, symmetry, precision, local = fig.scene["questions"]
    here = inputs(fig)
    for asked, right, wrong, told in [
        (hull, "-27/8", "27/8", "1 - t is negative"), (line, "1, 3", "(2, 3)", "is odd"),
        (affine, "(-2, 2)", "(-3, 2)", "Add the origin"), (affine, "(-2, 2)", "(2, 3)", "itself"),
        (symmetry, "3t^2 - 3t^3", "3t(1-t)^2", "write 1 - t for t"),
        (precision, "2 + 6t", "2 + 2t", "from one point to the next"),
        (local, "4/9", "2/3", "where it has it"),
    ]:  # fmt: skip
        assert checker(asked, right, here)["right"], right
        assert told in checker(asked, wrong, here)["message"]


@pytest.mark.parametrize("points", [[[2, 2]] * 4, [[0, 0], [1, 1], [2, 2], [3, 3]]])
def test_coincident_points_and_lines_show_nothing_false(points):
    fig = explore.bezier_properties(points)
    fig["L"] = [[1, 1], [1, 1]]
    fig["F"] = [[1, 1], [1, 1], [1, 1]]
    for step in range(6):
        fig["step"] = step
        assert fig.picture().axes
    assert all(np.isfinite(values).all() for _, values in shown_marks(fig))


def test_the_properties_are_those_of_a_cubic():
    with pytest.raises(BadValue, match="four control points"):
        explore.bezier_properties([[0, 0], [1, 1]])

"""The hodograph explorer against SymPy and NumPy's own derivatives."""

import numpy as np
import pytest
import sympy as sp

from symbolic import BadValue, de_casteljau
from tests.widgets.explored import inputs, shown_marks
from widgets import explore

S_SHAPE = [[0, 0], [5, 5], [2, 4], [8, 1]]
t = sp.Symbol("t")


def labelled(fig, label, view=0):
    """Return the points of dots with a label."""
    return [
        values[0] for mark, values in shown_marks(fig)
        if mark["kind"] == "dots" and mark["labels"] == [label] and mark["view"] == view
    ]  # fmt: skip


def circle(fig):
    return next(
        values[:, 0] for mark, values in shown_marks(fig)
        if mark["kind"] == "path" and mark["axis"] is not None and mark["color"] == "accent"
    )  # fmt: skip


def derivatives(points, at):
    c = sp.Matrix(de_casteljau(points, t)[-1][0])
    return [np.array(c.diff(t, k).subs(t, at), dtype=float).ravel() for k in range(3)]


@pytest.mark.parametrize("at", [0, 0.25, 0.4375, 1])
def test_readouts_and_circle_are_those_of_the_derivatives(at):
    c, v, a = derivatives(S_SHAPE, sp.Rational(at))
    fig = explore.hodograph(S_SHAPE, t=at)
    told = {m["label"]: values for m, values in shown_marks(fig) if m["kind"] == "readout"}
    curvature = (v[0] * a[1] - v[1] * a[0]) / np.hypot(*v) ** 3
    np.testing.assert_allclose(told["c'(t)"], v)
    np.testing.assert_allclose(told["speed |c'(t)|"], np.hypot(*v))
    np.testing.assert_allclose(told["curvature κ(t)"], curvature)
    centre = c + np.array([-v[1], v[0]]) / np.hypot(*v) / curvature
    radii = np.hypot(*(circle(fig) - centre).T)
    np.testing.assert_allclose(radii, 1 / abs(curvature), rtol=1e-9)


def test_where_curvature_is_zero_the_circle_is_the_tangent():
    fig = explore.hodograph([[0, 0], [1, 1], [3, 3], [6, 6]])
    x, y = circle(fig)[1:-1].T
    np.testing.assert_allclose(x, y, atol=1e-12)


def test_a_huge_circle_does_not_make_the_drawing_tiny():
    fig = explore.hodograph(S_SHAPE, t=0.75)  # near an inflection
    assert np.ptp(circle(fig), axis=0).max() > 100
    assert np.ptp(fig.scene["views"][0]["x"]) < 20


def test_inflections_are_where_the_curvature_vanishes():
    c = de_casteljau(S_SHAPE, t)[-1][0]
    turn = sp.expand(c[0].diff(t) * c[1].diff(t, 2) - c[1].diff(t) * c[0].diff(t, 2))
    roots = [r for r in sp.Poly(turn, t).nroots() if 0 <= r <= 1]
    assert len(roots) == 2
    expected = sorted([float(x.subs(t, r)) for x in c] for r in roots)
    found = sorted(map(list, labelled(explore.hodograph(S_SHAPE), "inflection")))
    np.testing.assert_allclose(found, expected)


@pytest.mark.parametrize("points", [
    [[0, 0], [1, 3], [4, 3], [5, 0]],  # an arch
    [[0, 0], [5, 5], [2, 4], [3, 1]],  # a cusp
    [[0, 0], [5, 5], [0, 5], [5, 0]],  # a loop
    [[0, 0], [1, 1], [3, 3], [6, 6]],  # a line
    [[2, 2]] * 4,
])  # fmt: skip
def test_no_inflection_is_shown_where_none_is(points):
    fig = explore.hodograph(points)
    assert not np.isfinite(labelled(fig, "inflection")).all(axis=1).any()
    assert fig.picture().axes


def test_control_points_of_the_hodograph(checker):
    fig = explore.hodograph(S_SHAPE)
    asked, here = fig.scene["questions"][0], inputs(fig)
    assert checker(asked, "(15, 15), (-9, -3), (18, -9)", here)["right"]
    assert "degree 3 is missing" in checker(asked, "(5,5), (-3,-1), (6,-3)", here)["message"]
    assert "reversed" in checker(asked, "(-15,-15), (9,3), (-18,9)", here)["message"]
    assert "number of points" in checker(asked, "(20,20), (-12,-4), (24,-12)", here)["message"]


def test_where_b3_must_be(checker):
    fig = explore.hodograph(S_SHAPE)
    _, end, cusp = fig.scene["questions"]
    here = inputs(fig)
    assert checker(end, "(2, 4)", here)["right"]
    assert "c''(1)" in checker(end, "(-1, 3)", here)["message"]
    assert checker(cusp, "(3, 1)", here)["right"]
    assert "c''(1/2)" in checker(cusp, "(7, 9)", here)["message"]
    for asked, at, text in ((end, 1, "b_3 = b_2"), (cusp, sp.Rational(1, 2), "a cusp")):
        b3 = [sp.Rational(x) for x in checker(asked, None, here)["solution"].strip("()").split(",")]
        assert not derivatives([*S_SHAPE[:3], b3], at)[1].any(), text


def test_the_hodograph_is_of_a_cubic():
    with pytest.raises(BadValue, match="four control points"):
        explore.hodograph([[0, 0], [1, 1]])

"""The B-spline explorer against the exact core: simple, repeated and pulled over knots."""

import numpy as np
import pytest

from numeric import Curve
from symbolic import BadValue
from tests.widgets.explored import outputs
from widgets import explore

DRAGGED = {
    "simple": [1, 2, 3], "uneven": [0.125, 0.25, 3.5], "double": [1, 2, 2], "triple": [2, 2, 2],
    "at the start": [0, 0, 1], "at the end": [1, 4, 4], "all at the end": [4, 4, 4],
    "pulled over": [3, 1, 2], "outside": [-2, 2, 9],
}  # fmt: skip


def drag(fig, knots):
    fig["u"] = [[x, y] for x, (_, y) in zip(knots, fig["u"], strict=True)]


def held(knots):
    """Return the inner knots as the figure reads them: never falling, inside the domain."""
    return np.clip(np.maximum.accumulate(np.maximum(knots, 0)), 0, 4)


def of_kind(fig, kind):
    return [mark for mark in fig.scene["marks"] if mark["kind"] == kind]


@pytest.mark.parametrize("name", DRAGGED)
def test_the_curve_and_its_functions_are_those_of_the_knots(name):
    fig = explore.bspline()
    drag(fig, DRAGGED[name])
    knots = [0] * 4 + held(DRAGGED[name]).tolist() + [4] * 4
    curve = Curve.from_bspline(fig["d"], knots, 3)
    found = outputs(fig)
    paths = [m for m in of_kind(fig, "path") if m["axis"] is not None]
    u = np.linspace(0, 4, 257)
    drawn = found[paths[0]["output"]][:, 0]
    near_a_gap = np.isin(u, held(DRAGGED[name]))  # four knots at one place: the curve may jump
    np.testing.assert_allclose(drawn[~near_a_gap], curve(u)[~near_a_gap], atol=1e-9)
    total = sum(found[path["output"]][:, 0, 1] for path in paths[1:])
    np.testing.assert_allclose(total, 1, atol=1e-12)
    assert all(np.isfinite(values).all() for values in found.values())


@pytest.mark.parametrize("name", DRAGGED)
@pytest.mark.parametrize("t", [0, 0.0625, 1, 2, 2.5, 3.9375, 4])
def test_de_boor_ends_at_the_point(name, t):
    fig = explore.bspline(t=t)
    drag(fig, DRAGGED[name])
    found = outputs(fig)
    last = [m for m in of_kind(fig, "dots") if m["from"] == 3][0]
    (readout,) = of_kind(fig, "readout")
    np.testing.assert_allclose(found[last["output"]][0], found[readout["output"]], atol=1e-9)
    (weights,) = of_kind(fig, "weights")
    assert found[weights["output"]].sum() == pytest.approx(1)


def test_knots_move_along_their_axis_only():
    (group,) = [g for g in explore.bspline().scene["points"] if g["name"] == "u"]
    assert group["along"] == "x"


def test_there_are_seven_points():
    with pytest.raises(BadValue, match="seven control points"):
        explore.bspline([[0, 0], [1, 1]])

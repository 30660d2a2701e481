"""The interpolation explorer: curves through their points, shares that sum to one, reach."""

import numpy as np
import pytest
import sympy as sp

from numeric import Curve
from symbolic import BadValue, interpolating_spline
from tests.widgets.explored import outputs
from widgets import explore


def curves(fig, step, color="curve"):
    found = outputs(fig)
    return [found[m["output"]] for m in fig.scene["marks"]
            if m["from"] == step and m["view"] == 0 and m["color"] == color]  # fmt: skip


@pytest.mark.parametrize("count", [3, 5, 9])
@pytest.mark.parametrize("step", [0, 1, 2])
def test_every_curve_goes_through_the_points(step, count):
    fig = explore.interpolation([[i, (3 * i) % 5] for i in range(count)])
    (drawn,) = curves(fig, step)
    np.testing.assert_allclose(drawn[0], fig["P"][:-1], atol=1e-10)
    np.testing.assert_allclose(drawn[-1], fig["P"][1:], atol=1e-10)


def test_the_natural_spline_is_the_exact_one():
    fig = explore.interpolation()
    points = [[sp.Rational(float(c)) for c in row] for row in fig["P"]]
    exact = Curve.from_interpolation(interpolating_spline(points, list(range(len(points)))))
    (drawn,) = curves(fig, 1)
    u = np.linspace(0, 1, len(drawn))
    for i in range(len(points) - 1):
        np.testing.assert_allclose(drawn[:, i], exact(i + u), atol=1e-10)


def test_only_catmull_rom_keeps_the_rest_where_it_was():
    fig = explore.interpolation()
    before = [curves(fig, step)[0] for step in range(3)]
    fig["P"] = [*fig["P"][:1], [1, 3], *fig["P"][2:]]
    moved = [np.abs(curves(fig, step)[0] - before[step]).max(axis=(0, 2)) for step in range(3)]
    assert (moved[0] > 0).all() and (moved[1] > 0).all()
    assert (moved[2][:3] > 0).all() and (moved[2][3:] == 0).all()
    ghosts = [curves(fig, step, "muted")[0] for step in range(3)]
    for ghost, old in zip(ghosts, before, strict=True):
        np.testing.assert_allclose(ghost, old, atol=1e-10)


def test_shares_sum_to_one():
    fig = explore.interpolation()
    found = outputs(fig)
    for step in range(3):
        graphs = [found[m["output"]] for m in fig.scene["marks"]
                  if m["view"] == 1 and m["from"] == step]  # fmt: skip
        np.testing.assert_allclose(sum(graph[..., 1] for graph in graphs), 1, atol=1e-10)


def test_two_points_are_too_few():
    with pytest.raises(BadValue, match="3 to 9 points"):
        explore.interpolation([[0, 0], [1, 1]])

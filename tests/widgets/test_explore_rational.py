"""The explorer of rational quadratics against the exact core."""

import numpy as np
import pytest
import sympy as sp

from numeric import Curve
from symbolic import BadValue, RationalBezier
from tests.widgets.explored import inputs, outputs
from widgets import explore


def test_the_curve_is_the_rational_one():
    fig = explore.rational([[0, 0], [1, 2], [3, 1]])
    fig["w0"], fig["w1"], fig["w2"] = 1, 0.5, 2
    exact = Curve.from_nurbs(RationalBezier([[0, 0], [1, 2], [3, 1]], [1, sp.Rational(1, 2), 2]))
    paths = [m for m in fig.scene["marks"] if m["kind"] == "path" and m["axis"] is not None]
    drawn = outputs(fig)[next(m for m in paths if m["color"] == "curve")["output"]]
    t = np.linspace(0, 1, len(drawn))
    np.testing.assert_allclose(drawn[:, 0], exact(t), atol=1e-14)


def test_shares_sum_to_one_and_the_projection_is_the_point():
    fig = explore.rational(t=0.25)
    found = outputs(fig)
    weights = next(m for m in fig.scene["marks"] if m["kind"] == "weights")
    readout = next(m for m in fig.scene["marks"] if m["kind"] == "readout")
    shares = found[weights["output"]]
    assert shares.sum() == pytest.approx(1)
    np.testing.assert_allclose(shares @ fig["P"], found[readout["output"]], atol=1e-14)


def test_all_questions(checker):
    fig = explore.rational([[0, 0], [2, 4], [4, 0]])
    middle, denominator, quarter = fig.scene["questions"]
    here = inputs(fig)
    assert checker(middle, "(2, 8/3)", here)["right"]
    assert "equal weights" in checker(middle, "(2, 2)", here)["message"]
    assert "Divide by w(1/2)" in checker(middle, "(3, 4)", here)["message"]
    assert checker(denominator, "1 + 4t - 3t^2", here)["right"]
    assert "the 2 is missing" in checker(denominator, "1 + t + t^2 - t^2", here)["message"]
    assert "change places" in checker(denominator, "2(1-t)^2 + 6t(1-t) + t^2", here)["message"]
    assert checker(quarter, "0.5", here)["right"] and not checker(quarter, "0.7", here)["right"]


def test_no_weights_at_all_show_nothing_false():
    fig = explore.rational()
    for i in range(3):
        fig[f"w{i}"] = 0
    assert not any(np.isinf(values).any() for values in outputs(fig).values())
    assert fig.picture().axes


def test_a_conic_has_three_points():
    with pytest.raises(BadValue, match="three control points"):
        explore.rational([[0, 0], [1, 1]])

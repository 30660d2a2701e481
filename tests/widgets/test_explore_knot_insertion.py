"""The explorer of knot insertion against Boehm's algorithm of the exact core."""

from fractions import Fraction

import numpy as np
import pytest

from numeric import Curve
from symbolic import BadValue, BSpline
from tests.widgets.explored import inputs, outputs
from widgets import explore
from widgets.explore.knot_insertion import KNOTS


def paths(fig, since):
    """Return the polylines that appear at a step."""
    found = outputs(fig)
    return [found[m["output"]] for m in fig.scene["marks"]
            if m["kind"] == "path" and m["axis"] is None and m["from"] == since]  # fmt: skip


def exact_points(fig):
    return [[Fraction(c) for c in row] for row in fig["d"].tolist()]


@pytest.mark.parametrize("t", [Fraction(5, 4), Fraction(3, 2), Fraction(15, 8)])
@pytest.mark.parametrize("times", [1, 2, 3])
def test_polygons_are_those_of_boehm(t, times):
    fig = explore.knot_insertion(t=t)
    points, spline = exact_points(fig), BSpline(KNOTS, 3)
    for _ in range(times):
        spline, points = spline.insert(points, t)
    (polygon,) = paths(fig, times)
    np.testing.assert_allclose(polygon, np.array(points, float), atol=1e-13)


def test_bezier_points_and_the_curve_are_the_splines():
    fig = explore.knot_insertion()
    curve = Curve.from_bspline(fig["d"], KNOTS, 3)
    (bezier,) = paths(fig, 4)
    np.testing.assert_allclose(bezier, curve.points.reshape(-1, 2), atol=1e-13)
    drawn = outputs(fig)
    (swept,) = [drawn[m["output"]] for m in fig.scene["marks"] if m.get("axis") is not None]
    u = np.linspace(0, 1, len(swept))
    for span in range(4):
        np.testing.assert_allclose(swept[:, span], curve(span + u), atol=1e-13)


def test_labels_are_the_knots_of_the_blossom():
    fig = explore.knot_insertion()
    (group,) = fig.scene["points"]
    assert group["labels"][:4] == ["f(0,0,0)", "f(0,0,1)", "f(0,1,2)", "f(1,2,3)"]
    new = [m["labels"] for m in fig.scene["marks"] if m["kind"] == "dots" and m["labels"]]
    assert new == [["f(0,1,t)", "f(1,2,t)", "f(2,3,t)"], ["f(1,t,t)", "f(2,t,t)"], ["f(t,t,t)"]]


def test_all_questions(checker):
    fig = explore.knot_insertion(t=1.25)
    one, point, count = fig.scene["questions"]
    here, d = inputs(fig), np.array(fig["d"])
    at = d[2] + (d[3] - d[2]) * 5 / 12
    first = [Fraction(float(c)).limit_denominator(1000) for c in at]
    assert checker(one, f"({first[0]}, {first[1]})", here)["right"]
    wrong = d[2] + (d[3] - d[2]) / 4
    assert "as t divides [1, 2]" in checker(one, f"({wrong[0]}, {wrong[1]})", here)["message"]
    x, y = BSpline(KNOTS, 3).de_boor(exact_points(fig), Fraction(5, 4))[-1][0]
    assert checker(point, f"({x}, {y})", here)["right"]
    assert checker(count, "6", here)["right"] and not checker(count, "5", here)["right"]


def test_there_are_seven_points():
    with pytest.raises(BadValue, match="seven control points"):
        explore.knot_insertion([[0, 0], [1, 1]])

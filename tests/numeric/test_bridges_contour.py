"""Contours: what they refuse, and how curves become contours and contours curves."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from contours import bits, contours, paths
from numeric import Curve
from numeric.bridges import Contour, segments_by_degree, to_svg
from numeric.bridges.outlines import as_contours
from symbolic import BadType, BadValue, circle

fast = settings(max_examples=60, deadline=None)
CORNER = [[0, 0], [1, 0], [1, 2], [0, 0]]


@pytest.mark.parametrize(("arguments", "said"), [
    ((CORNER, [1, 1]), "degrees add up to"),
    ((CORNER, [0, 3]), "whole numbers from 1 on"),
    ((CORNER, [1.5, 1.5]), "whole numbers from 1 on"),
    ((CORNER, [float("nan")]), "whole numbers from 1 on"),
    ((CORNER, [[1, 2]]), "whole numbers from 1 on"),
    ((CORNER, [2**62, 2**62, 2**62, 2**62, 3]), "whole numbers from 1 on"),
    ((CORNER, 3), "whole numbers from 1 on"),
    (([[0, 0, 0], [1, 1, 1]], [1]), "points in the plane"),
    (([[0, float("nan")], [1, 1]], [1]), "finite coordinates"),
    (([], []), "shape"),
    ((CORNER[:3], [1, 1], True), "ends where it starts"),
    ((CORNER, [3], True, [1, 1, 1]), "4 positive weights"),
    ((CORNER, [3], True, [1, 0, 1, 1]), "4 positive weights"),
    ((CORNER, [3], True, [1, 2, 2, 2]), "1 at the ends of segments"),
    ((CORNER, [3], True, [1, float("inf"), 1, 1]), "4 positive weights"),
])  # fmt: skip
def test_contours_refuse(arguments, said):
    with pytest.raises(BadValue, match=said):
        Contour(*arguments)


@pytest.mark.parametrize("arguments", [
    (CORNER, ["1", "2"]), (CORNER, None), ([["0", 0]], []), (CORNER, [1, 2], "yes"),
    (CORNER, [1, 2], False, ["a"] * 4),
])  # fmt: skip
def test_contours_refuse_other_types(arguments):
    with pytest.raises(BadType):
        Contour(*arguments)


def test_contours_cannot_be_changed_behind_their_back():
    vertices = np.array(CORNER, dtype=float)
    contour = Contour(vertices, [1, 2])
    vertices[0] = 7
    assert contour.vertices[0].tolist() == [0, 0]
    with pytest.raises(ValueError, match="read-only"):
        contour.vertices[0] = 7
    with pytest.raises(AttributeError):
        contour.closed = True


def test_both_ends_of_a_closed_contour_have_the_same_zeros():
    contour = Contour([[0.0, -0.0], [1, 1], [-0.0, 0.0]], [1, 1], closed=True)
    assert contour.vertices[0].tobytes() == contour.vertices[-1].tobytes()


@fast
@given(contours(highest=5))
def test_a_contour_as_a_curve_runs_through_its_vertices(contour):
    curve = contour.curve
    ends = contour.vertices[np.append(contour.starts, len(contour.vertices) - 1)]
    size = np.abs(contour.vertices).max()
    assert len(curve) == max(len(contour.degrees), 1)
    np.testing.assert_allclose(curve.points[:, 0], ends[: len(curve)], rtol=0, atol=1e-14 * size)
    np.testing.assert_allclose(curve.points[-1, -1], ends[-1], rtol=0, atol=1e-14 * size)


@fast
@given(paths)
def test_segments_by_degree_are_all_segments_and_bit_for_bit(drawn):
    found = segments_by_degree(drawn)
    rows = {
        n: [
            c.vertices[start : start + n + 1]
            for c in drawn
            for start, degree in zip(c.starts, c.degrees, strict=True)
            if degree == n
        ]
        for n in (1, 2, 3)
    }
    assert [curve.degree for curve in found] == [n for n in rows if rows[n]]
    for curve in found:
        assert curve.rows.tobytes() == np.array(rows[curve.degree]).tobytes()


@fast
@given(st.integers(1, 6), st.integers(1, 5), st.data())
def test_a_curve_whose_segments_meet_is_one_contour_bit_for_bit(degree, count, data):
    numbers = st.floats(-1e150, 1e150)
    size = degree * count + 1
    points = data.draw(
        st.lists(st.tuples(numbers, numbers), min_size=size, max_size=size, unique=True)
    )
    rows = np.array(points)[np.arange(count)[:, None] * degree + np.arange(degree + 1)]
    (contour,) = as_contours(Curve.from_bezier(rows, np.arange(count + 1.0)))
    assert bits([contour]) == bits([Contour(np.array(points), [degree] * count)])


def test_a_curve_is_cut_at_gaps_and_not_at_roundings():
    rows = np.array([[[0, 0], [1, 1]], [[1, 1 + 1e-15], [2, 0]], [[5, 5], [6, 6]]])
    path = as_contours(Curve.from_bezier(rows))
    assert [c.vertices.tolist() for c in path] == [[[0, 0], [1, 1], [2, 0]], [[5, 5], [6, 6]]]


def test_curves_of_degree_zero_are_points():
    path = as_contours(Curve.from_bezier([[[1, 2]], [[1, 2]], [[3, 4]]]))
    assert [(c.vertices.tolist(), len(c.degrees)) for c in path] == [
        ([[1, 2]], 0), ([[1, 2]], 0), ([[3, 4]], 0)
    ]  # fmt: skip


def test_a_circle_is_closed_and_rational():
    (contour,) = as_contours(Curve.from_nurbs(circle()))
    assert contour.closed and contour.rational.all()
    t = np.linspace(0, 4, 101)
    np.testing.assert_allclose(np.hypot(*contour.curve(t).T), 1, rtol=1e-14)


@pytest.mark.parametrize("weight", [0.7, 0.1, 1 / 3, 5.1])
def test_rational_curves_are_closed_within_the_rounding_of_their_points(weight):
    points = np.array([[0.1, 0.7], [1, 1], [2, 0.3], [0.1, 0.7]])
    (contour,) = as_contours(Curve.from_bezier(points, weights=[weight, 1, 2, 3 * weight]))
    assert contour.closed
    (line,) = as_contours(Curve.from_bezier([[1, 1], [1, 1 + 2**-52]]))
    assert not line.closed and line.vertices[1, 1] > 1  # no rounding here, so none is forgiven


@fast
@given(st.integers(1, 6), st.data())
def test_standard_form_keeps_the_shape(degree, data):
    """A point of the curve at t is one of the contour at another t, found by the same formula."""
    weight = st.floats(0.1, 10)
    weights = np.array(data.draw(st.lists(weight, min_size=degree + 1, max_size=degree + 1)))
    points = np.random.default_rng(degree).normal(size=(degree + 1, 2))
    sign = data.draw(st.sampled_from([1, -1]))
    (contour,) = as_contours(Curve.from_bezier(points, weights=sign * weights))
    r = (weights[0] / weights[-1]) ** (1 / degree)
    u = np.linspace(0, 1, 17)
    theirs = Curve.from_bezier(points, weights=weights)(u / (u + (1 - u) / r))
    np.testing.assert_allclose(contour.curve(u), theirs, rtol=0, atol=1e-11)


def test_equal_weights_are_none():
    for weight in (3.7, -0.1, 1e-200):
        (contour,) = as_contours(Curve.from_bezier(CORNER, weights=[weight] * 4))
        assert contour.weights is None


@pytest.mark.parametrize(
    "weights", [[1, -0.4, 1], [1, 0, 1], [1, -0.999999, 1], [3, -0.5, -0.5, 3]]
)
def test_weights_of_both_signs_are_halved_until_they_are_positive(weights):
    points = [[1, 0], [0, 3], [-1, 0], [-1, -2]][: len(weights)]
    curve = Curve.from_bezier(points, weights=weights)
    (contour,) = as_contours(curve)
    assert len(contour.degrees) > 1 and (contour.weights > 0).all()
    inner = contour.vertices[contour.starts[1:]]  # every joint is a point of the curve
    t = np.linspace(0, 1, 200001)
    nearest = [np.abs(curve(t) - point).max(axis=1).min() for point in inner]
    assert max(nearest) < 1e-3 * np.abs(curve(t)).max()


@pytest.mark.parametrize("value", [None, 3, "M0 0", {}, [None], np.zeros((2, 2))])
def test_what_is_no_curve(value):
    for function in (to_svg, segments_by_degree):
        with pytest.raises(BadType, match="curve"):
            function(value)


def test_curves_in_space_are_refused():
    with pytest.raises(BadValue, match="Curve.transform"):
        to_svg(Curve.from_bezier([[0, 0, 0], [1, 1, 1]]))

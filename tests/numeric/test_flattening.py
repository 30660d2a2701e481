"""Flattening keeps its promise: every point of the curve is within the tolerance of its chord."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from numeric import Curve
from symbolic import circle
from symbolic.errors import BadType, BadValue

TOLERANCES = st.sampled_from([0.3, 1e-2, 1e-4, 1e-6])


def deviation(curve, tolerance, samples=7):
    """Return how far points of the curve, `samples` for every chord, are from their chord."""
    t, vertices = curve.flat_parameters(tolerance), curve.flatten(tolerance)
    assert (np.diff(t) >= 0).all() and len(t) == len(vertices)
    inner = t[:-1, None] + np.diff(t)[:, None] * np.linspace(0, 1, samples + 2)[1:-1]
    chords, starts = np.diff(vertices, axis=0)[:, None], vertices[:-1, None]
    lengths = (chords**2).sum(axis=-1)
    beside = curve(inner) - starts
    along = (beside * chords).sum(axis=-1) / np.where(lengths == 0, 1, lengths)
    rest = beside - np.clip(along, 0, 1)[..., None] * chords
    found = np.sqrt((rest**2).sum(axis=-1))
    return found[np.diff(t) > 0].max(initial=0)  # the other chords cross gaps


@st.composite
def curves(draw):
    degree, dim = draw(st.integers(1, 25)), draw(st.integers(1, 4))
    segments = draw(st.integers(1, 3))
    random = np.random.default_rng(draw(st.integers(0, 10**6)))
    points = random.normal(size=(segments, degree + 1, dim))
    kind = draw(st.sampled_from(["any", "rounded", "point", "line", "repeated", "gentle", "steep"]))
    if kind == "rounded":  # coincident points, cusps, loops
        points = np.round(points)
    elif kind == "point":
        points[:] = points[0, 0]
    elif kind == "line":  # run forwards and backwards
        points = points[..., :1] * random.normal(size=dim)
    elif kind == "repeated":
        points = np.repeat(points[:, ::2], 2, axis=1)[:, : degree + 1]
    elif kind == "gentle":
        points = np.sort(points, axis=1)
    elif kind == "steep":  # forwards and, further, to the sides
        points = np.cumsum(np.append(points[..., :1] ** 2 / 9, points[..., 1:], axis=-1), axis=1)
    weights = None
    if draw(st.booleans()):
        weights = 10 ** random.uniform(-2, 2, size=points.shape[:2])
    return Curve.from_bezier(points, weights=weights)


@given(curves(), TOLERANCES)
def test_the_tolerance_is_kept(curve, tolerance):
    size = max(np.abs(curve.points).max(), 1)
    assert deviation(curve, tolerance) <= tolerance + 1e-14 * size


@given(curves(), st.sampled_from([1e-150, 1e-20, 1e20, 1e150]))
def test_points_scale_with_the_tolerance(curve, scale):
    scaled = curve.transform(scale).flatten(1e-3 * scale) / scale
    vertices = curve.flatten(1e-3)
    assert abs(len(scaled) - len(vertices)) <= 1 + len(vertices) // 50
    if scaled.shape == vertices.shape:
        np.testing.assert_allclose(scaled, vertices, atol=1e-9 * max(np.abs(vertices).max(), 1))


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6])
def test_a_parabola_takes_the_fewest_points(tolerance):
    """A chord over h of (t, t^2) is off by h^2/4, and 1/sqrt(1 + 4t^2) of that across."""
    curve = Curve.from_bezier([[-0.5, 0.25], [0, -0.25], [0.5, 0.25]])
    fewest = np.ceil(1 / np.sqrt(4 * tolerance))
    assert fewest * 0.8 <= len(curve.flatten(tolerance)) - 1 <= fewest * 1.05 + 1


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6])
def test_a_circle_takes_few_points(tolerance):
    fewest = np.pi / np.arccos(1 - tolerance)
    count = len(Curve.from_nurbs(circle()).flatten(tolerance)) - 1
    assert fewest <= count <= 2.2 * fewest + 4


def test_a_segment_that_bends_unevenly_takes_few_points():
    """The best possible number is the integral of sqrt(|c'' across c'| / 8 tolerance)."""
    curve = Curve.from_bezier([[0, 0], [4, 0], [5, 0], [5.5, 1], [5.5, 2], [5.5, 9]])
    t = np.linspace(0, 1, 2001)[1:-1]
    _, first, second = (values.T for values in curve.derivatives(t, 2))
    across = np.abs(first[0] * second[1] - first[1] * second[0]) / np.hypot(*first)
    best = np.sqrt(across / 8e-5).mean()
    assert best <= len(curve.flatten(1e-5)) <= 1.4 * best


def test_uneven_weights_take_points_where_they_are_light():
    points, weights = [[0, 0], [1, 3], [2, 0]], [[1, 1e4, 1e-2], [1e3, 1e-3, 1e3], [1e-4, 1, 1]]
    curve = Curve.from_bezier([points] * 3, weights=weights)
    assert len(curve.flatten(1e-5)) < 3000 and deviation(curve, 1e-5) <= 1e-5


def test_a_hairpin_takes_points_where_it_turns():
    """Far from its tip a narrow parabola is nearly straight."""
    hairpin = Curve.from_bezier([[-1, 1e4], [0, -1e4], [1, 1e4]])
    t = hairpin.flat_parameters(1e-3)
    gaps = np.diff(t)
    assert gaps.max() > 8 * gaps.min() and deviation(hairpin, 1e-3) <= 1e-3
    assert len(t) < 0.5 * np.sqrt(2 * 2e4 * 2 / 8 / 1e-3)  # the bound for equal parts


def test_straight_curves_have_two_vertices_each():
    straight = Curve.from_bezier([[0, 0], [1, 1], [1, 1], [8, 8], [9, 9]])
    assert straight.flatten(1e-9).tolist() == [[0, 0], [9, 9]]
    polygon = Curve.from_bspline([[0, 0], [1, 2], [3, 0]], [0, 0, 1, 2, 2], 1)
    assert polygon.flatten(1e-9).tolist() == [[0, 0], [1, 2], [3, 0]]
    heavy = Curve.from_bezier([[0, 0], [1, 1], [3, 3]], weights=[1, 100, 1])
    assert heavy.flatten(1e-9).tolist() == [[0, 0], [3, 3]]


def test_a_line_run_to_and_fro_keeps_its_turning_points():
    zigzag = Curve.from_bezier([[0.0], [3], [-2], [1]])
    turns = zigzag.flatten(1e-6)
    reached = zigzag(np.linspace(0, 1, 10001))
    assert turns.min() == pytest.approx(reached.min(), abs=1e-6)
    assert turns.max() == pytest.approx(reached.max(), abs=1e-6)


def test_both_sides_of_a_gap_are_vertices():
    curve = Curve.from_bezier([[[0, 0], [1, 1]], [[2, 1], [3, 0]], [[3, 0], [4, 4]]])
    assert curve.flatten(0.1).tolist() == [[0, 0], [1, 1], [2, 1], [3, 0], [4, 4]]
    assert curve.flat_parameters(0.1) == pytest.approx([0, 1 / 3, 1 / 3, 2 / 3, 1])


def test_weights_of_both_signs_are_no_hindrance():
    curve = Curve.from_bezier([[0, 0], [1, 3], [2, 0]], weights=[1, -0.9, 1])
    assert deviation(curve, 1e-4) <= 1e-4
    all_negative = Curve.from_bezier([[1, 0], [1, 1], [0, 1]], weights=[-1, -1, -2])
    assert deviation(all_negative, 1e-4) <= 1e-4
    many = np.random.default_rng(1).uniform(-0.2, 1, (3000, 9))
    many[:, [0, -1]] = 1
    lowest = Curve.from_bezier(many[..., None])(np.linspace(0, 3000, 90001) / 3000).reshape(-1)
    keep = lowest[:-1].reshape(3000, 30).min(axis=1) > 0.05
    random_points = np.random.default_rng(2).normal(size=(int(keep.sum()), 9, 2))
    assert deviation(Curve.from_bezier(random_points, weights=many[keep]), 1e-1) <= 1e-1


def test_a_domain_that_tells_few_parameters_apart():
    curve = Curve.from_bezier([[0, 0], [1, 2], [2, 0]], domain=(2.0**52, 2.0**52 + 8))
    vertices, t = curve.flatten(1e-9), curve.flat_parameters(1e-9)
    assert len(t) <= 9 and vertices[[0, -1]].tolist() == [[0, 0], [2, 0]]


def test_many_segments_at_once_are_as_each_by_itself():
    random = np.random.default_rng(3)
    points = random.normal(size=(2500, 4, 2))
    together = Curve.from_bezier(points, np.arange(2501.0))
    vertices, t = together.flatten(1e-3), together.flat_parameters(1e-3)
    for i in (0, 1, 1023, 1024, 2499):
        single = Curve.from_bezier(points[i], (i, i + 1.0))
        first = np.searchsorted(t, i, side="left") + (i > 0)
        count = len(single.flat_parameters(1e-3))
        np.testing.assert_allclose(
            vertices[first : first + count], single.flatten(1e-3), atol=1e-12
        )


@pytest.mark.parametrize("tolerance", [0, -1, float("nan"), float("inf"), [1, 2], "small", None])
def test_a_tolerance_is_a_positive_number(tolerance):
    with pytest.raises((BadValue, BadType), match="tolerance"):
        Curve.from_bezier([[0, 0], [1, 2], [2, 0]]).flatten(tolerance)


def test_too_many_points_are_refused_before_they_are_made():
    wild = Curve.from_bezier(np.random.default_rng(0).normal(size=(20, 26, 2)))
    with pytest.raises(BadValue, match="larger tolerance"):
        wild.flatten(1e-15)

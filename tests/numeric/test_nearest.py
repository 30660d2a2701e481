"""Nearest points against dense samples, SciPy, closed forms, and the condition of being nearest."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import numeric.measures.candidates as candidates
from numeric import Curve
from symbolic import BadType, BadValue, circle

t = sp.Symbol("t")
seeds = st.integers(0, 2**32 - 1)


def random_curve(seed, rational=False, most=9):
    """Return a curve whose segments meet."""
    random = np.random.default_rng(seed)
    degree, segments, dim = (
        random.integers(1, most + 1),
        random.integers(1, 9),
        random.integers(1, 5),
    )
    rows = random.normal(size=(segments, degree + 1, dim))
    rows[1:, 0] = rows[:-1, -1]
    weights = random.uniform(0.2, 5, (segments, degree + 1)) if rational else None
    breaks = np.append(0, np.cumsum(random.uniform(0.1, 3, segments)))
    return Curve.from_bezier(rows, breaks, weights), random


def sampled(curve, points, count=20001):
    """Return the least distances to `count` points of the curve."""
    at = curve(np.linspace(*curve.domain, count))
    return np.array([np.sqrt(((at - p) ** 2).sum(axis=1)).min() for p in points])


@settings(max_examples=80, deadline=None)
@given(seeds, st.booleans())
def test_nothing_sampled_is_nearer(seed, rational):
    curve, random = random_curve(seed, rational)
    points = random.normal(size=(9, curve.dim)) * random.choice([0.3, 1, 5])
    found = curve.nearest(points)
    size = np.abs(curve.points).max() + np.abs(points).max()
    best = sampled(curve, points)
    assert (found.distance <= best + 1e-11 * size).all()
    apart = np.abs(np.diff(curve(np.linspace(*curve.domain, 20001)), axis=0)).max() * curve.dim
    assert (found.distance >= best - apart).all()
    np.testing.assert_allclose(curve(found.t), found.points, rtol=0, atol=1e-11 * size)
    distance = np.linalg.norm(found.points - points, axis=1)
    np.testing.assert_allclose(distance, found.distance, rtol=0, atol=1e-13 * size)


@settings(max_examples=30, deadline=None)
@given(seeds, st.booleans())
def test_agrees_with_minimisation_by_scipy(seed, rational):
    from scipy.optimize import minimize_scalar

    curve, random = random_curve(seed, rational, 4)
    p = random.normal(size=curve.dim)
    found = curve.nearest(p)
    at = np.linspace(*curve.domain, 2001)
    best = at[np.argmin(((curve(at) - p) ** 2).sum(axis=1))]
    step = at[1] - at[0]
    bounds = max(at[0], best - step), min(at[-1], best + step)
    reference = minimize_scalar(lambda u: ((curve(u) - p) ** 2).sum(), bounds=bounds,
                                method="bounded", options={"xatol": 1e-12})  # fmt: skip
    ends = np.sqrt(((curve(np.array(bounds)) - p) ** 2).sum(axis=1)).min()
    assert found.distance <= min(np.sqrt(reference.fun), ends) + 1e-11
    assert found.distance == pytest.approx(np.linalg.norm(curve(found.t) - p), abs=1e-11)


@settings(max_examples=60, deadline=None)
@given(seeds, st.booleans())
def test_points_on_the_curve_are_found_again(seed, rational):
    curve, random = random_curve(seed, rational, 25)
    at = np.append(random.uniform(*curve.domain, 20), curve.breaks)
    found = curve.nearest(curve(at))
    size = np.abs(curve.points).max()
    assert found.distance.max() <= 1e-12 * size
    if curve.dim > 2:  # elsewhere a curve may come by twice
        np.testing.assert_allclose(found.t, at, rtol=0, atol=1e-6)


@settings(max_examples=40, deadline=None)
@given(seeds, st.booleans(), st.sampled_from([1e-150, 1e-20, 1.0, 1e20, 1e150]))
def test_nearest_under_similarities(seed, rational, factor):
    curve, random = random_curve(seed, rational, 5)
    points = random.normal(size=(7, curve.dim))
    expected = curve.nearest(points)
    found = curve.transform(factor).nearest(points * factor)
    np.testing.assert_allclose(found.distance / factor, expected.distance, rtol=1e-9, atol=1e-13)
    backwards = curve.reverse().nearest(points)
    np.testing.assert_allclose(backwards.distance, expected.distance, rtol=1e-9, atol=1e-13)
    offset = np.full(curve.dim, 1000.0)
    moved = curve.transform(1, offset).nearest(points + offset)
    np.testing.assert_allclose(moved.distance, expected.distance, rtol=1e-8, atol=1e-11)


def test_the_foot_on_a_parabola():
    """From (0, h) to (t, t^2): the vertex while h <= 1/2, above it t = -sqrt(h - 1/2)."""
    curve = Curve.from_expressions([t, t**2], t, (-3, 3))
    heights = np.array([-1, 0.3, 1, 2, 5])
    found = curve.nearest(np.stack([np.zeros(5), heights], axis=1))
    above = np.maximum(heights - 0.5, 0)
    np.testing.assert_allclose(found.t, -np.sqrt(above), rtol=0, atol=1e-12)
    expected = np.where(heights > 0.5, np.sqrt(np.maximum(heights - 0.25, 0)), np.abs(heights))
    np.testing.assert_allclose(found.distance, expected, rtol=1e-14)
    # The centre of curvature at the vertex: a root of multiplicity three.
    flat = curve.nearest([0, 0.5])
    assert flat.distance == pytest.approx(0.5, rel=1e-14) and abs(flat.t) < 1e-3


def test_circles_and_their_centres():
    curve = Curve.from_nurbs(circle([3, 4], 2))
    angle = np.linspace(0, 2 * np.pi, 50)
    around = np.array([3, 4]) + np.stack([np.cos(angle), np.sin(angle)], 1) * 5
    np.testing.assert_allclose(curve.nearest(around).distance, 3, rtol=1e-14)
    centre = curve.nearest([3, 4])
    assert centre.distance == pytest.approx(2, rel=1e-14)
    many = curve.nearest(np.tile([3.0, 4.0], (1000, 1)))
    assert (many.t == centre.t).all() and centre.t < 0.01


def test_the_smallest_parameter_of_equals():
    there_and_back = Curve.from_bezier([[[0, 0], [4, 0]], [[4, 0], [0, 0]]])
    assert there_and_back.nearest([1, 1]).t == 0.125
    square = Curve.from_bezier(
        [[[1, -1], [1, 1]], [[1, 1], [-1, 1]], [[-1, 1], [-1, -1]], [[-1, -1], [1, -1]]]
    )
    assert square.nearest([0, 0]).t == 0.125
    assert square.nearest([0.5, 0.5]).t == pytest.approx(0.1875, rel=1e-15)
    closed = square.nearest([1, -1])
    assert closed.t == 0 and closed.distance == 0
    assert Curve.from_bezier([[2, 3]] * 4, (5, 6)).nearest([0, 0]).t == 5


def test_ends_of_segments_that_do_not_meet_count():
    curve = Curve.from_bezier([[[0, 0], [1, 0]], [[3, 0], [4, 0]]])
    found = curve.nearest([[1.5, 0], [2.5, 0], [9, 0]])
    assert found.t.tolist() == [0.5, 0.5, 1]
    assert found.points.tolist() == [[1, 0], [3, 0], [4, 0]]
    assert found.distance.tolist() == [0.5, 0.5, 5]


@pytest.mark.parametrize("rows", [
    [[2, 3]] * 4, [[1, 2]], [[0, 0], [1, 1], [0, 1], [1, 0]], [[0, 0], [3, 0], [0, 0]],
    [[0, 0], [0, 0], [1, 1], [1, 1]], [[0, 0], [1e-9, 0], [1, 1e9]],
], ids=str)  # fmt: skip
def test_degenerate_curves(rows):
    curve = Curve.from_bezier(rows)
    points = np.array([[0.4, 0.9], [-1, 2], [0, 0], [1e6, -1e6], [2, 3]])
    size = np.abs(rows).max() + np.abs(points).max(axis=1)
    found = curve.nearest(points)
    np.testing.assert_array_less(found.distance, sampled(curve, points) + 1e-13 * size)


def test_far_away_and_very_near():
    curve = Curve.from_bezier([[0, 0], [1, 2], [2, 0]])
    far = curve.nearest([[1e200, 0], [-1e200, 0], [0, 1e150], [0, -1e300]])
    np.testing.assert_allclose(far.distance, [1e200, 1e200, 1e150, 1e300], rtol=1e-14)
    assert curve.nearest([[1e9, 0], [-1e9, 0]]).t.tolist() == [1, 0]
    near = curve.nearest(curve(0.3) + 1e-9 * np.array([-0.8, 1]))  # along the normal
    assert near.t == pytest.approx(0.3, abs=1e-14)
    assert near.distance == pytest.approx(1e-9 * np.hypot(0.8, 1), rel=1e-6)


def test_weights_of_both_signs():
    curve = Curve.from_bezier([[1, 0], [0.5, 3**0.5], [0, 0]], weights=[1, -0.4, 1])
    points = np.random.default_rng(1).normal(size=(30, 2)) * 2
    np.testing.assert_allclose(
        curve.nearest(points).distance, sampled(curve, points), rtol=0, atol=1e-6
    )


@settings(max_examples=30, deadline=None)
@given(seeds, st.sampled_from([-1, 1e-200, -1e200]))
def test_a_common_factor_of_the_weights_is_of_no_account(seed, factor):
    curve, random = random_curve(seed, True, 5)
    other = Curve.from_bezier(curve.points, curve.breaks, curve.weights * factor)
    points = random.normal(size=(7, curve.dim))
    found, expected = other.nearest(points), curve.nearest(points)
    np.testing.assert_allclose(found.distance, expected.distance, rtol=1e-9, atol=1e-13)
    assert other.length() == pytest.approx(curve.length(), rel=2e-9)
    np.testing.assert_allclose(other.bounding_box(), curve.bounding_box(), rtol=1e-12, atol=1e-12)
    if curve.dim == 2:
        np.testing.assert_allclose(other.inflections(), curve.inflections(), rtol=0, atol=1e-7)


@pytest.mark.parametrize("shape", [(), (1,), (5,), (2, 3), (0,), (4, 0)])
def test_any_shape_of_points(shape):
    found = Curve.from_bezier([[0, 0, 1], [1, 2, 1], [2, 0, 1]]).nearest(np.ones((*shape, 3)))
    assert found.t.shape == found.distance.shape == shape
    assert found.points.shape == (*shape, 3)


def long_curve():
    """Return a spline along a random walk, 3000 segments, and what comes next at random."""
    random = np.random.default_rng(3)
    points, ends = random.normal(size=(3003, 2)).cumsum(axis=0), [0] * 3
    return Curve.from_bspline(points, [*ends, *range(3001), *[3000] * 3], 3), random


def test_many_segments_and_many_points():
    curve, random = long_curve()
    points = random.uniform(-60, 60, (400, 2))
    found = curve.nearest(points)
    best = sampled(curve, points, 200001)
    assert (found.distance <= best + 1e-11).all() and (found.distance >= best - 0.01).all()


def test_few_pairs_are_solved(monkeypatch):
    """Of 3000 segments, each of 400 points looks at a few pieces."""
    curve, random = long_curve()
    counted = []
    original = candidates._descend

    def counting(levels, points):
        pairs = original(levels, points)
        counted.append(0 if pairs is None else len(pairs[0]))
        return pairs

    monkeypatch.setattr(candidates, "_descend", counting)
    curve.nearest(random.uniform(-60, 60, (400, 2)))
    assert sum(counted) < 10 * 400


def test_too_many_pairs_are_halved(monkeypatch):
    """All segments of a circle are as far from its centre, for every one of the points there."""
    curve = Curve.from_nurbs(circle())
    cuts = np.linspace(0, 1, 17)
    pieces = [curve.restrict(a, b) for a, b in zip(cuts, cuts[1:], strict=False)]
    fine = Curve.join(*pieces)
    points = np.random.default_rng(5).normal(size=(40, 2)) * 1e-16
    expected = fine.nearest(points)
    monkeypatch.setattr(candidates, "MOST_PAIRS", 300)
    found = fine.nearest(points)
    np.testing.assert_array_equal(found.t, expected.t)
    np.testing.assert_allclose(found.distance, 1, rtol=1e-13)


@pytest.mark.parametrize(("points", "error", "said"), [
    ([1, 2, 3], BadValue, "dimension 2"),
    ([[1], [2]], BadValue, "dimension 2"),
    (5, BadValue, "dimension 2"),
    ([], BadValue, "dimension 2"),
    ([1, float("nan")], BadValue, "finite"),
    ([[1, 2], [float("inf"), 2]], BadValue, "finite"),
    (["1", "2"], BadType, "real numbers"),
    (None, BadType, "real numbers"),
    ([[1, 2], [1]], BadType, "real numbers"),
])  # fmt: skip
def test_bad_points(points, error, said):
    with pytest.raises(error, match=said):
        Curve.from_bezier([[0, 0], [1, 1]]).nearest(points)


@pytest.mark.parametrize("power", [5, 8, 12])
def test_weights_of_very_different_sizes_hide_no_nearest_point(power):
    """The weights w c^i belong to the same points: here those of a parabola."""
    points = [[0, 0], [1, 3], [2, 0]]
    uneven = Curve.from_bezier(points, weights=[10.0**-power, 1, 10.0**power])
    given = np.array([[0.5, 1], [0.2, 0.5], [1, 2], [1.9, 0.2], [0.01, 0.02]])
    found, expected = uneven.nearest(given), Curve.from_bezier(points).nearest(given)
    np.testing.assert_allclose(found.distance, expected.distance, atol=1e-9)
    np.testing.assert_allclose(uneven(found.t), expected.points, atol=1e-5)

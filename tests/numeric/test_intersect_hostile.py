"""Intersections of degenerate curves, bad input, and batches of pairs."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from numeric import Curve, intersect_segments
from symbolic import BadType, BadValue

seeds = st.integers(0, 2**32 - 1)
LINE = Curve.from_bezier([[0, 0], [1, 0]])

shapes = st.sampled_from(["random", "point", "line", "repeated", "folded", "closed", "grid"])


def hostile(shape, random, degree, segments, dim):
    rows = random.normal(size=(segments, degree + 1, dim))
    if shape == "grid":
        rows = random.integers(-1, 2, rows.shape).astype(float)
    if shape == "point":
        rows[:] = rows[:1, :1]
    if shape in ("line", "folded"):
        along = np.sort if shape == "line" else np.asarray
        rows = along(random.normal(size=(segments, degree + 1, 1)), **(
            {"axis": 1} if shape == "line" else {})) * np.ones(dim)  # fmt: skip
    if shape == "repeated":
        rows = np.repeat(rows[:1], segments, axis=0)
        rows[:, : (degree + 1) // 2] = rows[:, :1]
    if shape == "closed":
        rows[:, -1] = rows[:, 0]
    return rows


@settings(max_examples=35, deadline=None)
@given(seeds, shapes, shapes, st.integers(0, 8), st.integers(1, 4), st.integers(2, 3),
       st.booleans(), st.sampled_from([1e-150, 1.0, 1e150]))  # fmt: skip
def test_hostile_curves_give_few_and_true_places(
    seed, shape, other_shape, degree, segments, dim, rational, scale
):
    random = np.random.default_rng(seed)
    curves = []
    for kind in (shape, other_shape):
        rows = hostile(kind, random, degree, segments, dim)
        weights = random.uniform(0.2, 4, rows.shape[:2]) if rational else None
        curves.append(Curve.from_bezier(rows * scale, weights=weights))
    first, second = curves
    for a, b in ((first, second), (first, first)):
        found = a.intersect(b)
        size = max(np.abs(a.points).max(), np.abs(b.points).max()) or 1
        assert len(found.t) <= 8 * max(degree, 1) ** 2 * segments**2
        assert len(found.shared) <= 8 * max(degree, 1) * segments**2
        assert (found.distance <= 2e-13 * size).all()
        np.testing.assert_allclose(a(found.t) / size, found.points / size, rtol=0, atol=1e-12)
        np.testing.assert_allclose(
            a(found.shared[..., 0]) / size, b(found.shared[..., 1]) / size, rtol=0, atol=1e-11
        )
        assert (np.diff(found.t) >= 0).all()
    if dim == 2:
        point, direction = random.integers(-1, 2, (2, 2)) * scale
        assume(direction.any())
        found = first.intersect_line(point, direction)
        assert len(found.t) <= (degree + 1) * segments and (np.diff(found.t) >= 0).all()
        size = np.abs(first.points).max() + np.abs(point).max()
        assert (found.distance <= 1e-13 * (size or 1)).all()
        np.testing.assert_allclose(
            (point + found.s[:, None] * direction) / (size or 1), found.points / (size or 1),
            rtol=0, atol=1e-12,
        )  # fmt: skip


def test_points_and_standing_segments():
    point = Curve.from_bezier([[0.5, 0]])
    found = LINE.intersect(point)
    assert found.t == 0.5 and found.distance == 0 and not found.transversal.any()
    assert len(point.intersect(point).t) == 1
    assert len(point.intersect(Curve.from_bezier([[0.5, 1]])).t) == 0
    stays = np.zeros((200, 4, 2))
    assert len(Curve.from_bezier(stays).intersect(Curve.from_bezier(stays)).t) == 1
    halting = Curve.from_bezier([[[0, 1], [0.5, 0]], [[0.5, 0], [0.5, 0]], [[0.5, 0], [1, 1]]])
    assert len(halting.intersect(Curve.from_bezier([[0, 0.5], [1, 0.5]])).t) == 2


def test_bad_input():
    for wrong in (None, 3, [[0, 0], [1, 1]]):
        with pytest.raises(BadType):
            LINE.intersect(wrong)
    with pytest.raises(BadValue):
        LINE.intersect(Curve.from_bezier([[0, 0, 0], [1, 1, 1]]))
    flat = Curve.from_bezier([[0], [1]])
    with pytest.raises(BadValue):
        flat.intersect(flat)
    for point, direction in (([0, 0], [0, 0]), ([0], [1, 0]), ([0, np.nan], [1, 0]),
                             ([0, 0], [np.inf, 0])):  # fmt: skip
        with pytest.raises(BadValue):
            LINE.intersect_line(point, direction)
    with pytest.raises(BadType):
        LINE.intersect_line("here", [1, 0])
    with pytest.raises(BadValue):
        Curve.from_bezier([[0, 0, 0], [1, 1, 1]]).intersect_line([0, 0], [1, 0])
    for first, second in (([LINE.rows[0]], [LINE.rows[0]] * 2), ([[[0, 0]]], [[[0, 0, 0]]]),
                          ([[[0], [1]]], [[[0], [1]]]), ([[[0, np.nan]]], [[[0, 0]]])):  # fmt: skip
        with pytest.raises(BadValue):
            intersect_segments(first, second)


def test_batches_agree_with_single_pairs():
    random = np.random.default_rng(3)
    first, second = random.random((2, 3000, 4, 2))
    second[5] = first[5]
    second[7], first[9] = second[7, 0], first[9, 0]
    second[11, 0] = first[11, 0]
    found = intersect_segments(first, second)
    assert len(found.pair) > 2000 and found.distance.max() <= 1e-14
    assert (np.diff(found.pair) >= 0).all() and 5 in found.shared_pair
    for k in range(30):
        one = Curve.from_bezier(first[k]).intersect(Curve.from_bezier(second[k]))
        own = found.pair == k
        np.testing.assert_allclose(found.u[own], one.t, rtol=0, atol=1e-12)
        np.testing.assert_allclose(found.v[own], one.s, rtol=0, atol=1e-12)
        np.testing.assert_allclose(found.shared[found.shared_pair == k], one.shared)

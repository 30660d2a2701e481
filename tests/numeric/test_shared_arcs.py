"""Arcs that curves have in common, told from (t, s) to (t, s), and not as points."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from numeric import Curve
from symbolic import circle

t = sp.Symbol("t")
seeds = st.integers(0, 2**32 - 1)
CIRCLE = Curve.from_nurbs(circle())
LINE = Curve.from_bezier([[0, 0], [1, 0]])


@pytest.mark.parametrize("size", [0.3, 1e-2, 1e-3])
def test_a_small_loop_is_found_though_a_curve_lies_on_itself(size):
    loop = Curve.from_expressions([t**2, t**3 - size**2 * t], t, (-1, 1))
    found = loop.intersect(loop)
    np.testing.assert_allclose(found.t, [-size, size], rtol=0, atol=1e-10)
    assert found.transversal.all() and len(found.shared) == 1


@settings(max_examples=30, deadline=None)
@given(seeds, st.integers(1, 6), st.booleans(), st.booleans())
def test_arcs_in_common_are_told(seed, degree, rational, reverse):
    random = np.random.default_rng(seed)
    weights = random.uniform(0.5, 2, degree + 1) if rational else None
    points = np.cumsum(random.uniform(0.2, 1, (degree + 1, 2)), axis=0)  # without double points
    whole = Curve.from_bezier(points, weights=weights)
    a, b, c, d = np.sort(random.random(4))
    assume(np.diff([a, b, c, d]).min() > 0.01)
    inner, outer = whole.restrict(b, d), whole.restrict(a, c)
    if reverse:
        outer = outer.reverse()
    found = inner.intersect(outer)
    assert len(found.t) == 0 and found.shared.shape == (1, 2, 2)
    (t0, s0), (t1, s1) = found.shared[0]
    np.testing.assert_allclose(inner([t0, t1]), whole([b, c]), rtol=0, atol=1e-11)
    np.testing.assert_allclose(outer([s0, s1]), whole([b, c]), rtol=0, atol=1e-11)
    touch = whole.restrict(a, b).intersect(whole.restrict(b, d))
    assert len(touch.t) == 1 and not touch.transversal.any() and not len(touch.shared)
    apart = whole.restrict(a, b).intersect(whole.restrict(c, d))
    assert len(apart.t) == 0 and not len(apart.shared)


def test_closed_curves_that_coincide():
    for other in (CIRCLE, CIRCLE.reverse(), CIRCLE.transform([[0.8, -0.6], [0.6, 0.8]])):
        found = CIRCLE.intersect(other)
        assert len(found.t) == 0
        assert np.diff(found.shared[..., 0], axis=1).sum() == pytest.approx(1)
        for (t0, s0), (t1, s1) in found.shared:
            np.testing.assert_allclose(CIRCLE([t0, t1]), other([s0, s1]), rtol=0, atol=1e-12)


def test_collinear_lines():
    for points, shared in (
        ([[0.25, 0], [0.75, 0]], [[0.25, 0], [0.75, 1]]),
        ([[1.5, 0], [0.5, 0]], [[0.5, 1], [1, 0.5]]),
        ([[-1, 0], [2, 0]], [[0, 1 / 3], [1, 2 / 3]]),
    ):
        found = LINE.intersect(Curve.from_bezier(points))
        assert len(found.t) == 0
        np.testing.assert_allclose(found.shared, [shared], rtol=0, atol=1e-12)
    assert len(LINE.intersect(Curve.from_bezier([[1.1, 0], [2, 0]])).t) == 0
    along = LINE.intersect_line([3, 0], [-2, 0])
    assert len(along.t) == 0
    np.testing.assert_allclose(along.shared, [[[0, 1.5], [1, 1]]])


def test_a_circle_that_runs_twice_does_not_change_its_round_within_an_arc():
    x, y = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
    once = Curve.from_expressions([x, y], t, (-1, 1))  # the right half
    twice = Curve.from_expressions([x**2 - y**2, 2 * x * y], t, (-1, 1))  # all of it
    found = twice.intersect(once)
    end = np.sqrt(2) - 1
    np.testing.assert_allclose(found.shared, [[[-end, -1], [end, 1]]], rtol=0, atol=1e-12)
    assert len(found.t) == 0

"""Contacts that rounding blurs: slow ends, cusps, folds, high orders; and arcs through them."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from numeric import Curve

t = sp.Symbol("t")
seeds = st.integers(0, 2**32 - 1)
LINE = Curve.from_bezier([[-1, 0], [1, 0]])
CUSP = Curve.from_expressions([t**2, t**3], t, (-1, 1))


def grid_curve(random, dim, rational):
    """Return a curve that often has repeated control points, cusps, folds or straight parts."""
    points = random.integers(0, int(random.integers(2, 5)), (int(random.integers(2, 7)), dim))
    weights = random.choice([0.5, 1, 2, 3, 1 / 3], len(points)) if rational else None
    return Curve.from_bezier(points, weights=weights)


def assert_same(found, other):
    """Fail unless both tell the same points, up to what rounding blurs, and arcs."""
    assert len(found.t) == len(other.t)
    if len(found.t):
        apart = np.abs(found.points[:, None] - other.points).max(axis=2)
        assert max(apart.min(axis=0).max(), apart.min(axis=1).max()) < 1e-5
    length = [np.abs(np.diff(f.shared[..., 0], axis=1)).sum() for f in (found, other)]
    assert abs(length[0] - length[1]) < 1e-5


@settings(max_examples=100, deadline=None)
@given(seeds, st.sampled_from([2, 2, 3]), st.booleans(), st.sampled_from([0.5, 0.25, 0.3173]))
@example(278, 2, True, 0.25)
@example(862, 2, False, 0.25)
def test_contacts_do_not_depend_on_how_a_curve_is_written(seed, dim, rational, at):
    random = np.random.default_rng(seed)
    first, second = (grid_curve(random, dim, rational) for _ in range(2))
    found = first.intersect(second)
    assert_same(found, first.elevate(2).intersect(second))
    assert_same(found, Curve.join(*first.split(at)).intersect(second))
    assert_same(found, first.reverse().intersect(second))
    swapped = second.intersect(first)
    assert_same(found, swapped._replace(shared=swapped.shared[..., ::-1]))


@settings(max_examples=40, deadline=None)
@given(seeds, st.integers(0, 2), st.booleans())
@example(79, 2, True)
def test_arcs_run_through_a_cusp(seed, by, reverse):
    random = np.random.default_rng(seed)
    whole = CUSP.transform(random.normal(size=(2, 2)), random.normal(size=2))
    a, b, c, d = 2 * np.sort(random.random(4)) - 1
    assume(np.diff([a, b, c, d]).min() > 0.05)
    inner, outer = whole.restrict(b, d), whole.restrict(a, c).elevate(by)
    found = inner.intersect(outer.reverse() if reverse else outer)
    assert len(found.t) == 0
    np.testing.assert_allclose(found.shared[..., 0], [[b, c]], rtol=0, atol=1e-6)


def test_curves_with_cusps_meet_themselves():
    for curve in (CUSP, CUSP.reverse(), CUSP.transform([[0.6, -0.8], [0.8, 0.6]])):
        found = CUSP.intersect(CUSP) if curve is CUSP else curve.intersect(curve)
        assert len(found.t) == 0 and found.shared.tolist() == [[[-1, -1], [1, 1]]]
    halves = CUSP.restrict(-1, 0).intersect(CUSP.restrict(0, 1))
    assert halves.t == 0 and halves.s == 0 and not halves.transversal.any()


def test_arcs_end_at_folds():
    twice = Curve.from_expressions([t**2, t**4], t, (-1, 1))  # there and back on a parabola
    once = Curve.from_expressions([t, t**2], t, (0, 1))
    for first, second in ((twice, once), (once, twice)):
        found = first.intersect(second)
        assert len(found.t) == 0
        shared = found.shared if first is twice else found.shared[..., ::-1]
        assert sorted(np.abs(shared[..., 0]).round(6).ravel().tolist()) == [0, 0, 1, 1]
    assert len(twice.intersect(twice).shared) == 2
    x = t**3 - t  # three times on a part of the parabola, between folds at t = +-1/sqrt(3)
    found = Curve.from_expressions([x, x**2], t, (-2, 2)).intersect(
        Curve.from_expressions([t, t**2], t, (-1, 1))
    )
    fold, end = 1 / np.sqrt(3), 1.3247179572447460
    np.testing.assert_allclose(
        found.shared[..., 0], [[-end, -fold], [-fold, fold], [fold, end]], rtol=0, atol=1e-7
    )
    assert len(found.t) == 0
    # A line there and back, cut at 1/2: no arc jumps from the way there to the way back.
    back = Curve.from_bezier([[0, 1], [1, 1], [0, 1]], weights=[0.5, 2, 1 / 3])
    half = Curve.from_bezier([[1, 1], [0, 1]], weights=[3, 2]).split(0.5)[1]
    for (t0, s0), (t1, s1) in half.intersect(back).shared:
        middle = half((t0 + t1) / 2)
        assert back.restrict(min(s0, s1), max(s0, s1)).nearest(middle).distance < 1e-13
        assert s0 > 0.5 and s1 == 1 or s0 < 0.5 and s1 == 0


@pytest.mark.parametrize("degree", range(1, 13))
def test_a_slow_end_is_one_place(degree):
    """The line's end is a point of the arch, and reached with its first derivatives zero."""
    arch = Curve.from_bezier([[-1, 0], [0, 2], [1, 0]])
    for other in ([0.5, 3], [2, 0.2], [-1, 1]):
        slow = Curve.from_bezier([[0, 1]] * degree + [other])
        for line, end in ((slow, 0), (slow.reverse(), 1)):
            found = line.intersect(arch)
            near = np.abs(found.s - 0.5) < 0.05
            assert near.sum() == 1 and (~near).sum() == (other == [2, 0.2])
            np.testing.assert_allclose(found.t[near], end, rtol=0, atol=1e-7)
            assert (found.distance <= 1e-13).all()


def test_the_slow_end_of_a_closed_curve_is_its_start():
    line = Curve.from_bezier([[1, 1], [0, 0], [0, 1]])
    closed = Curve.from_bezier([[0, 1], [1, 0], [0, 1], [1, 0], [0, 1], [0, 1]])
    for first in (line, line.elevate(2), line.elevate(5)):
        found = first.intersect(closed)
        np.testing.assert_allclose(found.t, [1 / 3, 1 / 3, 1], rtol=0, atol=1e-12)
        assert found.s[-1] == 0 and found.transversal.all()


@pytest.mark.parametrize("order", [2, 3, 4, 12])
@pytest.mark.parametrize("height", [1e-6, 1e-9, 1e-12])
def test_near_misses_and_two_crossings(order, height):
    graph = Curve.from_expressions([t, t**order], t, (-1, 1))
    below = graph.intersect(LINE.transform(1, [0, -height]))
    above = graph.intersect(LINE.transform(1, [0, height]))
    root = height ** (1 / order)
    expected = [-root, root] if order % 2 == 0 else [root]
    assert len(below.t) == order % 2
    np.testing.assert_allclose(above.t, expected, rtol=1e-3)
    by_line = graph.intersect_line([0, height], [1, 0])
    np.testing.assert_allclose(by_line.t, expected, rtol=1e-3)


@pytest.mark.parametrize("angle", [0.3, 1e-3, 1e-6])
def test_tangents_of_a_conic_at_every_place(angle):
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    conic = Curve.from_bezier([[1, 0], [1, 2], [-1, 1]], weights=[1, 0.7, 2]).transform(turn)
    at = np.linspace(0, 1, 23)
    for u, point, slope in zip(at, *conic.derivatives(at, 1), strict=True):
        tangent = Curve.from_bezier([point - slope, point + slope])
        for found in (conic.intersect(tangent), conic.intersect_line(point, slope)):
            assert len(found.t) == 1 and not found.transversal.any()
            assert abs(found.t[0] - u) < 1e-6 and found.distance[0] <= 1e-14

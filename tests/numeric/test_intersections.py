"""Intersections against resultants over the rationals, known incidences and closed forms."""

from itertools import product

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from numeric import Curve
from symbolic import circle

t, s = sp.symbols("t s")
seeds = st.integers(0, 2**32 - 1)
CIRCLE = Curve.from_nurbs(circle())
LINE = Curve.from_bezier([[0, 0], [1, 0]])


def exact_places(first, second):
    """Return all (t, s) in the unit square where two planar segments of integers meet.

    The roots t of the resultant by s are isolated over the rationals; s is the common root of
    both equations at t, by their subresultant of degree 1.
    """

    def polynomials(points, u):
        n = len(points) - 1
        basis = [sp.binomial(n, i) * u**i * (1 - u) ** (n - i) for i in range(n + 1)]
        return [sp.expand(sum(b * int(p[k]) for b, p in zip(basis, points, strict=True)))
                for k in (0, 1)]  # fmt: skip

    f, g = (sp.Poly(a - b, s) for a, b in zip(polynomials(first, t), polynomials(second, s),
                                              strict=True))  # fmt: skip
    chain = sp.subresultants(f, g)
    assume(chain[-1].degree() == 0 and chain[-2].degree() == 1)
    resultant = sp.Poly(sp.factor_list(chain[-1].as_expr())[1][-1][0], t)
    whole = sp.Poly(chain[-1].as_expr(), t)
    assume(whole.is_sqf and resultant.degree() == whole.degree())
    places = []
    for root in whole.real_roots():
        at = sp.N(root, 50)
        a, b = (c.subs(t, at) for c in chain[-2].all_coeffs())
        assume(abs(a) > 1e-20)
        other = -b / a
        assume(min(abs(x - y) for x, y in product((at, other), (0, 1))) > 1e-9)
        if 0 <= at <= 1 and 0 <= other <= 1:
            places.append((float(at), float(other)))
    return np.array(places).reshape(-1, 2)


def assert_same_places(found, expected, atol=1e-9):
    assert len(found.t) == len(expected)
    np.testing.assert_allclose(np.column_stack([found.t, found.s]), expected, rtol=0, atol=atol)


def random_cubics(seed, size=12):
    random = np.random.default_rng(seed)
    return random.integers(0, size, (4, 2)), random.integers(0, size, (4, 2))


@settings(max_examples=25, deadline=None)
@given(seeds)
def test_cubics_meet_where_the_resultant_vanishes(seed):
    first, second = random_cubics(seed)
    expected = exact_places(first, second)
    found = Curve.from_bezier(first).intersect(Curve.from_bezier(second))
    assert_same_places(found, expected)
    assert found.transversal.all() and len(found.shared) == 0
    assert found.distance.max(initial=0) <= 1e-13


def test_two_cubics_meet_nine_times():
    # The graph of Chebyshev's cubic T3 and its mirror image, scaled to integers on [-1, 1]: they
    # meet where T9(x) = x, at the cosines of k pi / 4 and k pi / 5.
    graph = np.array([[-3, -1], [-1, 5], [1, -5], [3, 1]]) * [1, 3]
    first, second = Curve.from_bezier(graph), Curve.from_bezier(graph[:, ::-1])
    found = first.intersect(second)
    cosines = np.cos(np.pi * np.concatenate([np.arange(5) / 4, np.array([1, 2, 3, 4]) / 5]))
    np.testing.assert_allclose(found.points[:, 0], 3 * np.sort(cosines), rtol=0, atol=1e-13)
    assert found.transversal.all()


@settings(max_examples=60, deadline=None)
@given(seeds, st.integers(1, 8), st.integers(1, 8), st.integers(2, 4), st.booleans())
def test_every_point_that_two_curves_are_known_to_share_is_found(seed, n, k, dim, rational):
    """The second curve interpolates points of the first one."""
    random = np.random.default_rng(seed)
    weights = random.uniform(0.3, 3, n + 1) if rational else None
    first = Curve.from_bezier(random.normal(size=(n + 1, dim)), weights=weights)
    at = np.sort(random.random(k + 1)) if n > 1 else random.random(1)
    assume(len(at) < 2 or np.diff(at).min() > 0.02)
    there = np.linspace(0.05, 0.95, k + 1)[: len(at)]
    points = first(random.permutation(at))
    matrix = np.array([[float(sp.binomial(k, i)) * v**i * (1 - v) ** (k - i) for i in range(k + 1)]
                       for v in there])  # fmt: skip
    rows = np.linalg.lstsq(matrix, points, rcond=None)[0]
    second = Curve.from_bezier(rows)
    found = first.intersect(second)
    size = np.abs(second.points).max() + np.abs(first.points).max()
    for point, v in zip(points, there, strict=True):
        u = first.nearest(point).t
        a, b = first.derivatives(u, 1)[1], second.derivatives(v, 1)[1]
        sine = np.linalg.norm(a - (a @ b) / (b @ b) * b) / np.linalg.norm(a)
        if sine < 1e-3 or np.linalg.norm(a) < 1e-2 * size or np.linalg.norm(b) < 1e-2 * size:
            continue
        near = (np.abs(found.t - u) < 1e-7) & (np.abs(found.s - v) < 1e-7)
        assert near.sum() == 1 and found.transversal[near].all()
    assert found.distance.max(initial=0) <= 1e-13 * size


@settings(max_examples=25, deadline=None)
@given(seeds, st.sampled_from([1e-150, 1e-20, 1.0, 1e20, 1e150]), st.booleans())
def test_order_direction_scale_and_place_do_not_matter(seed, scale, rational):
    random = np.random.default_rng(seed)
    weights = random.uniform(0.3, 3, (2, 5)) if rational else [None, None]
    first, second = (Curve.from_bezier(random.normal(size=(5, 2)), weights=w) for w in weights)
    found = first.intersect(second)
    places = np.column_stack([found.t, found.s])
    swapped = second.intersect(first)
    order = np.argsort(swapped.s)
    np.testing.assert_allclose(
        np.column_stack([swapped.s, swapped.t])[order], places, rtol=0, atol=1e-8
    )
    turned = first.reverse().intersect(second)
    np.testing.assert_allclose(1 - turned.t[::-1], found.t, rtol=0, atol=1e-8)
    matrix = np.array([[2.0, 1.0], [-1.0, 1.0]])
    moved = [c.transform(matrix, [3, -2]).transform(scale) for c in (first, second)]
    assert_same_places(moved[0].intersect(moved[1]), places, atol=1e-8)
    assert (moved[0].intersect(moved[1]).distance <= 1e-13 * 10 * scale).all()


def test_circles():
    for angle in np.linspace(0, 6, 20):
        shift = np.array([np.cos(angle), np.sin(angle)])
        found = CIRCLE.intersect(CIRCLE.transform(1, shift))
        assert len(found.t) == 2 and found.transversal.all()
        np.testing.assert_allclose(found.points @ shift, 0.5, rtol=0, atol=1e-14)
        np.testing.assert_allclose(np.hypot(*found.points.T), 1, rtol=0, atol=1e-14)
        for outside in (CIRCLE.transform(1, 2 * shift), CIRCLE.transform(0.5, 0.5 * shift)):
            touch = CIRCLE.intersect(outside)
            assert len(touch.t) == 1 and not touch.transversal.any()
            np.testing.assert_allclose(touch.points[0], shift, rtol=0, atol=1e-7)
            assert touch.distance[0] <= 1e-14
        for apart in (2.001, 2 + 1e-9):
            assert len(CIRCLE.intersect(CIRCLE.transform(1, apart * shift)).t) == 0
        close = CIRCLE.intersect(CIRCLE.transform(1, (2 - 1e-9) * shift))
        assert len(close.t) == 2 and close.transversal.all()
        through = CIRCLE.intersect_line([0, 0], shift)
        np.testing.assert_allclose(np.sort(through.s), [-1, 1], rtol=0, atol=1e-14)
        tangent = CIRCLE.intersect_line(shift, [-shift[1], shift[0]])
        assert len(tangent.t) == 1 and not tangent.transversal.any()
        assert tangent.distance[0] <= 1e-15 and abs(tangent.s[0]) < 1e-7


@pytest.mark.parametrize("order", [2, 3, 4, 5, 9, 16])
def test_a_contact_of_high_order_is_one_place(order):
    graph = Curve.from_expressions([t, t**order], t, (-1, 1))
    flat = Curve.from_bezier([[-1, 0], [1, 0]])
    found = graph.intersect(flat)
    assert len(found.t) == 1 and not found.transversal.any() and not len(found.shared)
    assert abs(found.t[0]) <= 1e-13 ** (1 / order) and found.distance[0] <= 1e-13
    assert len(graph.intersect(flat.transform(1, [0, -1e-6])).t) == 0 or order % 2
    by_line = graph.intersect_line([0, 0], [1, 0])
    assert len(by_line.t) == 1 and abs(by_line.t[0]) <= 1e-13 ** (1 / order)


@pytest.mark.parametrize("ratio", [1.0, 1e3, 1e8, 1e12])
def test_weights_of_very_different_size(ratio):
    # The same parabola by another parameter: u / (1 - u) is 1 / ratio times what it was.
    points = [[0, 0], [1, 2], [2, 0]]
    plain, uneven = (Curve.from_bezier(points, weights=[1, r, r * r]) for r in (1, ratio))
    for line in (Curve.from_bezier([[0, 0.5], [2, 0.5]]), Curve.from_bezier([[1, 0], [1, 2]])):
        expected, found = plain.intersect(line), uneven.intersect(line)
        np.testing.assert_allclose(found.s, expected.s, rtol=0, atol=1e-13)
        u = expected.t / ratio / (1 - expected.t + expected.t / ratio)
        np.testing.assert_allclose(found.t, u, rtol=1e-12)
        by_line = uneven.intersect_line([0, 0.5], [1, 0])
        np.testing.assert_allclose(by_line.points[:, 1], 0.5, rtol=0, atol=1e-6)
    shared = plain.intersect(uneven)
    assert len(shared.t) == 0
    np.testing.assert_allclose(shared.shared, [[[0, 0], [1, 1]]], rtol=0, atol=1e-12)


def test_cusps_double_points_and_joints():
    cusp = Curve.from_expressions([t**2, t**3], t, (-1, 1))
    for line in ([[-1, 0.5], [1, -0.5]], [[0, -1], [0, 1]], [[-1, 0], [1, 0]]):
        found = cusp.intersect(Curve.from_bezier(line))
        near = np.abs(found.t) < 1e-4
        assert near.sum() == 1 and found.distance.max() <= 1e-13
    loop = Curve.from_expressions([t**2, t**3 - t], t, (-2, 2))  # it meets itself at (1, 0)
    found = loop.intersect(Curve.from_bezier([[0.5, -0.5], [1.5, 0.5]]))
    assert np.isclose(found.points, [1, 0], rtol=0, atol=1e-12).all(axis=1).sum() == 2
    itself = loop.intersect(loop)
    np.testing.assert_allclose(itself.t, [-1, 1], rtol=0, atol=1e-12)
    np.testing.assert_allclose(itself.s, [1, -1], rtol=0, atol=1e-12)
    np.testing.assert_allclose(itself.shared, [[[-2, -2], [2, 2]]], rtol=0, atol=1e-12)
    joint = LINE.intersect(Curve.from_bezier([[0.5, 0], [0.5, 1]]))
    assert joint.t == 0.5 and joint.s == 0 and joint.transversal.all()
    corner = Curve.from_bezier([[[0, 1], [0.5, 0]], [[0.5, 0], [1, 1]]]).intersect(LINE)
    assert corner.t == 0.5 and corner.s == 0.5
    ends = LINE.intersect(Curve.from_bezier([[1, 0], [2, 1], [3, 0]]))
    assert ends.t == 1 and ends.s == 0 and ends.transversal.all()


def test_polylines_of_many_segments():
    random = np.random.default_rng(5)
    walks = random.integers(-(10**6), 10**6, (2, 401, 2))
    first, second = (Curve.from_bezier(np.stack([w[:-1], w[1:]], axis=1), (0, 400)) for w in walks)

    def side(a, b, p):  # exact in integers
        a, b, p = (k.astype(np.int64) for k in (a, b, p))
        return np.sign((b - a)[..., 0] * (p - a)[..., 1] - (b - a)[..., 1] * (p - a)[..., 0])

    a, b = walks[0][:-1, None], walks[0][1:, None]
    c, d = walks[1][None, :-1], walks[1][None, 1:]
    sides = side(a, b, c) * side(a, b, d), side(c, d, a) * side(c, d, b)
    assert not ((sides[0] == 0) & (sides[1] <= 0)).any()
    cross = (sides[0] < 0) & (sides[1] < 0)
    found = first.intersect(second)
    assert cross.sum() > 10000
    pairs = np.column_stack([found.t.astype(int), found.s.astype(int)])
    assert sorted(pairs.tolist()) == np.argwhere(cross).tolist()


def test_nearly_parallel_curves_are_resolved():
    bow = Curve.from_expressions([t, t**2], t, (-1, 1))
    for slope in (1e-3, 1e-5, 1e-7):
        tilted = Curve.from_expressions([t, t**2 + sp.Rational(slope) * (t - sp.Rational(1, 3))],
                                        t, (-1, 1))  # fmt: skip
        found = bow.intersect(tilted)
        assert len(found.t) == 1
        np.testing.assert_allclose(found.t, 1 / 3, rtol=0, atol=1e-14 / slope)

"""Polylines with integer points, their intersections known exactly: corners, overlaps, halts."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from numeric import Curve

grid = st.integers(0, 4)
walks = st.lists(st.tuples(grid, grid), min_size=2, max_size=8)
scales = st.sampled_from([1e-100, 0.1, 1.0, 1e100])


def polyline(walk, by=0):
    pieces = [walk[i : i + 2] for i in range(len(walk) - 1)]
    return Curve.from_bezier(pieces, (0, len(pieces))).elevate(by)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def where_segments_meet(p, q, a, b):
    """Return the places (u, v) where p q and a b meet: one, the two ends of an arc, or none."""
    d, e, w = minus(q, p), minus(b, a), minus(a, p)
    if cross(d, e):
        u, v = Fraction(cross(w, e), cross(d, e)), Fraction(cross(w, d), cross(d, e))
        return [(u, v)] if 0 <= u <= 1 and 0 <= v <= 1 else []
    if d == (0, 0) and e == (0, 0):
        return [(Fraction(0), Fraction(0))] if w == (0, 0) else []
    if d == (0, 0):
        return [(u, v) for v, u in where_segments_meet(a, b, p, q)[:1]]
    if cross(w, d):
        return []
    start, end = (Fraction(dot(minus(point, p), d), dot(d, d)) for point in (a, b))
    low, high = max(0, min(start, end)), min(1, max(start, end))
    ends = [low] if low == high else [low, high] if low < high else []
    return [(u, (u - start) / (end - start) if start != end else Fraction(0)) for u in ends]


class Walk:
    """Parameters of a polyline counted without halts, and from its start again if it is closed."""

    def __init__(self, walk):
        moves = [walk[i] != walk[i + 1] for i in range(len(walk) - 1)]
        self.at = [sum(moves[:i]) for i in range(len(walk))]
        self.closed = walk[0] == walk[-1]

    def on_arc(self, t):
        return round(float(np.interp(float(t), range(len(self.at)), self.at)), 9)

    def place(self, t):
        at = self.on_arc(t)
        return 0.0 if self.closed and at == self.at[-1] else at

    def also(self, at):
        """Return a place, and the end of a closed curve for its start."""
        return [at, self.at[-1]] if self.closed and at == 0 else [at]


def exact_intersections(first, second):
    """Return the places (t, s) where two polylines meet apart from arcs, and the arcs."""
    places, arcs = set(), []
    one, two = Walk(first), Walk(second)
    for i in range(len(first) - 1):
        for j in range(len(second) - 1):
            met = where_segments_meet(*first[i : i + 2], *second[j : j + 2])
            if len(met) == 2:
                arcs.append([(one.on_arc(i + u), two.on_arc(j + v)) for u, v in met])
            places |= {(one.place(i + u), two.place(j + v)) for u, v in met}

    def on(t, s):
        return any(
            t0 <= t <= t1 and abs(s - s0 - (t - t0) * (s1 - s0) / (t1 - t0)) < 1e-9
            for (t0, s0), (t1, s1) in arcs
        )

    apart = {
        (t, s) for t, s in places if not any(on(x, y) for x in one.also(t) for y in two.also(s))
    }
    return sorted(apart), arcs


@settings(max_examples=90, deadline=None)
@given(walks, walks, scales, st.integers(0, 2))
def test_polylines_meet_where_fractions_say(first, second, scale, by):
    expected, arcs = exact_intersections(first, second)
    found = polyline(first).transform(scale).intersect(polyline(second, by).transform(scale))
    one, two = Walk(first), Walk(second)
    told = sorted((one.place(t), two.place(s)) for t, s in zip(found.t, found.s, strict=True))
    assert len(told) == len(expected)
    np.testing.assert_allclose(np.ravel(told), np.ravel(expected), rtol=0, atol=1e-8)
    for side, walk in enumerate((one, two)):
        length = sum(abs(end[side] - start[side]) for start, end in arcs)
        ends = [[walk.on_arc(t) for t in arc] for arc in found.shared[..., side]]
        assert abs(np.abs(np.diff(ends)).sum() - length) < 1e-7


@settings(max_examples=90, deadline=None)
@given(walks, st.tuples(grid, grid), st.tuples(grid, grid), scales, st.integers(0, 2),
       st.sampled_from([None, -2.3, 1 / 3]), st.sampled_from([1e-9, 1.0, 1e12]))  # fmt: skip
def test_a_line_meets_a_polyline_where_fractions_say(walk, p, q, scale, by, weight, speed):
    direction = minus(q, p) if p != q else (1, -2)
    heights = [cross(direction, minus(point, p)) for point in walk]
    exact = Walk(walk)
    inside = [i for i in range(len(walk) - 1) if heights[i] == heights[i + 1] == 0]
    arcs = [(exact.at[i], exact.at[i + 1]) for i in inside if walk[i] != walk[i + 1]]
    on = {exact.place(t) for i in inside for t in (i, i + 1) if walk[i] != walk[i + 1]}
    corners = {exact.place(i) for i, h in enumerate(heights) if h == 0}
    expected = sorted((corners - on) | {
        exact.place(i + h / (h - k))
        for i, (h, k) in enumerate(zip(heights, heights[1:], strict=False)) if h * k < 0
    })  # fmt: skip
    curve = polyline(walk, by)
    if weight:
        weights = np.full(curve.points.shape[:2], weight)
        curve = Curve.from_bezier(curve.points, curve.breaks, weights)
    along = np.array(direction) * scale * speed
    found = curve.transform(scale).intersect_line(np.array(p) * scale, along)
    told = sorted(exact.place(t) for t in found.t)
    assert len(told) == len(expected)
    np.testing.assert_allclose(told, expected, rtol=0, atol=1e-8)
    ends = [[exact.on_arc(t) for t in arc] for arc in found.shared[..., 0]]
    assert all(start < end for start, end in ends)
    assert sum(end - start for start, end in ends) == sum(end - start for start, end in arcs)
    for (t0, s0), (t1, s1) in found.shared:
        for t, s in ((t0, s0), (t1, s1)):
            np.testing.assert_allclose(
                curve(t), p + s * speed * np.array(direction), rtol=0, atol=1e-12
            )


def test_a_seam_that_is_found_a_rounding_off_is_one_place():
    closed = polyline([(1, 1), (1, 0), (1, 1)]).transform(1e-100)
    assert closed.intersect_line([0, 0], [1e-109, 1e-109]).t.tolist() == pytest.approx(
        [0], abs=1e-12
    )


def test_a_fold_ends_an_arc():
    found = polyline([(0, 0), (2, 0), (2, 0), (1, 0)]).intersect(polyline([(0, 0), (4, 0)]))
    np.testing.assert_allclose(found.shared, [[[0, 0], [1, 0.5]], [[2, 0.5], [3, 0.25]]])
    along = polyline([(0, 0), (2, 0), (1, 0)]).intersect_line([0, 0], [1, 0])
    np.testing.assert_allclose(along.shared, [[[0, 0], [1, 2]], [[1, 2], [2, 1]]])

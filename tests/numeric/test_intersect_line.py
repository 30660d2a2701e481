"""Intersections with lines against exact roots, and against long segments."""

import numpy as np
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from numeric import Curve

t = sp.Symbol("t")
seeds = st.integers(0, 2**32 - 1)


@settings(max_examples=40, deadline=None)
@given(seeds, st.integers(2, 12), st.booleans())
def test_a_line_meets_a_curve_where_a_long_segment_does(seed, degree, rational):
    random = np.random.default_rng(seed)
    weights = random.uniform(0.3, 3, (3, degree + 1)) if rational else None
    curve = Curve.from_bezier(random.normal(size=(3, degree + 1, 2)), (0, 2), weights)
    point, direction = random.normal(size=(2, 2))
    by_line = curve.intersect_line(point, direction)
    ends = point + np.outer([-20, 20], direction / np.linalg.norm(direction))
    by_segment = curve.intersect(Curve.from_bezier(ends))
    np.testing.assert_allclose(by_line.t, by_segment.t, rtol=0, atol=1e-7)
    np.testing.assert_allclose(
        point + by_line.s[:, None] * direction, by_line.points, rtol=0, atol=1e-10
    )


@settings(max_examples=20, deadline=None)
@given(seeds, st.integers(1, 7))
def test_a_line_meets_a_curve_at_real_roots(seed, degree):
    random = np.random.default_rng(seed)
    points = random.integers(-9, 10, (degree + 1, 2))
    a, b, c = (int(k) for k in random.integers(-5, 6, 3))
    assume(a or b)
    heights = [a * int(x) + b * int(y) - c for x, y in points]
    f = sp.Poly(sum(sp.binomial(degree, i) * t**i * (1 - t) ** (degree - i) * h
                    for i, h in enumerate(heights)), t)  # fmt: skip
    assume(not f.is_zero)
    expected = [float(r) for r in sorted(set(f.real_roots())) if 0 <= r <= 1] if f.degree() else []
    point = np.array([a, b]) * c / (a * a + b * b)
    found = Curve.from_bezier(points).intersect_line(point, [-b, a])
    np.testing.assert_allclose(found.t, expected, rtol=0, atol=1e-7)

"""Laws that curves of every kind obey, each in one body."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from numeric import Curve
from numeric.curves.spans import Spans, Workspace
from symbolic import BadType, BadValue, OutsideDomain
from tests.numeric.curve_kinds import KINDS, rows, t

kinds = pytest.mark.parametrize("kind", KINDS.values(), ids=list(KINDS))


def places(curve, count=9):
    """Return rational parameters, exact as floats: in the domain, and all breaks."""
    breaks = [Fraction(b) for b in curve.breaks.tolist()]
    inner = [a + (b - a) * Fraction(k, 8) for a, b in zip(breaks, breaks[1:], strict=False)
             for k in range(1, 8, max(1, 8 // count))]  # fmt: skip
    return sorted({*breaks, *inner})


def assert_near(found, expected, curve, factor=1.0):
    np.testing.assert_allclose(found, expected, rtol=0, atol=factor * 2e-14 * size(curve))


def size(curve):
    return max(np.abs(curve.points).max(), 1)


@kinds
def test_points_are_exact_values_rounded(kind):
    curve, at = kind.curve, places(kind.curve)
    expected = np.array([[float(x) for x in kind.exact(u)] for u in at])
    t = np.array([float(u) for u in at])
    for order in (slice(None), slice(None, None, -1), np.random.default_rng(0).permutation(len(t))):
        assert_near(curve(t[order]), expected[order], curve)
    one_by_one = np.array([curve(u) for u in at])
    np.testing.assert_array_equal(one_by_one, curve(t))


@kinds
def test_any_shape_no_parameters_and_not_a_number(kind):
    curve = kind.curve
    start, end = curve.domain
    for shape in [(), (0,), (3,), (2, 0, 4), (2, 3, 1)]:
        assert curve(np.full(shape, start)).shape == (*shape, curve.dim)
    t = np.array([start, np.nan, end, np.inf, -np.inf, (start + end) / 2])
    found = curve(t)
    assert np.isnan(found[[1, 3, 4]]).all()
    np.testing.assert_array_equal(found[[0, 2, 5]], curve(t[[0, 2, 5]]))
    for outside in (np.nextafter(start, -np.inf), np.nextafter(end, np.inf)):
        with pytest.raises(OutsideDomain):
            curve([start, outside])


@kinds
def test_affine_maps_of_points_are_affine_maps_of_the_curve(kind):
    curve, random = kind.curve, np.random.default_rng(1)
    matrix, offset = random.normal(size=(3, curve.dim)), random.normal(size=3)
    t = np.linspace(*curve.domain, 41)
    assert_near(curve.transform(matrix, offset)(t), curve(t) @ matrix.T + offset, curve, 10)


@kinds
def test_parts_joined_again_are_the_curve(kind):
    curve = kind.curve
    for u in places(curve)[1:-1:3]:
        left, right = curve.split(u)
        assert (left.domain, right.domain) == ((curve.domain[0], u), (u, curve.domain[1]))
        t = np.linspace(curve.domain[0], float(u), 20)[:-1]
        assert_near(left(t), curve(t), curve, 10)
        t = np.linspace(float(u), curve.domain[1], 20)
        assert_near(right(t), curve(t), curve, 10)
        if np.abs(left(u) - right(u)).max() < 1e-13 * size(curve):  # no gap at a break
            joined = Curve.join(left, right)
            t = np.linspace(*joined.domain, 40)
            assert_near(joined(t), curve(t + curve.domain[0] - joined.domain[0]), curve, 10)


@kinds
def test_a_part_knows_the_rest_of_its_polynomial(kind):
    curve = kind.curve
    if curve.degree > 8:
        return  # far outside, a polynomial of high degree is not determined by rounded values
    a, b = curve.breaks[0], curve.breaks[1]
    part = curve.restrict(a + (b - a) / 4, a + (b - a) * 3 / 4)
    t = np.linspace(a, b, 21)[:-1]
    assert_near(part(t, extrapolate=True), curve(t), curve, 1e3)


@kinds
def test_backwards_twice_is_forwards(kind):
    curve = kind.curve
    start, end = curve.domain
    back = curve.reverse()
    t = np.linspace(start, end, 37)[1:-1]
    t = t[np.abs(t[:, None] - curve.breaks).min(axis=1) > 1e-9]  # at gaps the sides change
    assert_near(back(start + end - t), curve(t), curve, 10)
    np.testing.assert_array_equal(back.reverse().rows, curve.rows)
    np.testing.assert_allclose(back.reverse().breaks, curve.breaks, rtol=1e-15)


@kinds
def test_another_domain_and_a_higher_degree_change_no_point(kind):
    curve, u = kind.curve, np.linspace(0, 1, 33)
    start, end = curve.domain
    moved = curve.reparametrize((Fraction(-7, 2), 100))
    assert moved.domain == (-3.5, 100)
    t = start + u * (end - start)
    t = t[np.abs(t[:, None] - curve.breaks[1:-1]).min(axis=1, initial=1) > 1e-9]
    assert_near(moved(-3.5 + (t - start) / (end - start) * 103.5), curve(t), curve, 20)
    assert_near(curve.elevate(2)(t), curve(t), curve, 10)


@kinds
def test_derivatives_are_limits_of_differences(kind):
    """The curve on both sides of t differs from its Taylor polynomial by the next order."""
    curve = kind.curve
    lengths = np.diff(curve.breaks)
    t = curve.breaks[:-1] + 0.4 * lengths
    value, first, second = curve.derivatives(t, 2)
    np.testing.assert_array_equal(value, curve(t))
    h = 1e-4 * lengths[:, None]
    ahead, behind = curve(t + h[:, 0]), curve(t - h[:, 0])
    scale = size(curve) * max(curve.degree, 1) ** 3
    np.testing.assert_allclose((ahead - behind) / 2, first * h, atol=1e-10 * scale)
    np.testing.assert_allclose(ahead - 2 * value + behind, second * h**2, atol=1e-10 * scale)
    assert_near(curve.derivative()(t) * lengths[:, None], first * lengths[:, None], curve, 1e3)


# Breaks at the limits of floats: neighbours, tiny spans beside huge ones, below normal numbers.
gaps = st.one_of(
    st.floats(1e-300, 1e300), st.floats(1e-3, 1e3), st.just(0.0), st.sampled_from([5e-324, 1e-310])
)


@given(st.floats(-1e6, 1e6), st.lists(gaps, min_size=1, max_size=60), st.integers(0, 10**6))
def test_spans_are_those_of_a_search(start, lengths, seed):
    breaks = [start]
    for gap in lengths:
        breaks.append(max(np.nextafter(breaks[-1], np.inf), breaks[-1] + gap))
    breaks = np.array(breaks)
    if not np.isfinite(breaks[-1] - breaks[0]):
        return
    random = np.random.default_rng(seed)
    t = np.concatenate([
        breaks, np.nextafter(breaks, np.inf), np.nextafter(breaks, -np.inf),
        random.uniform(breaks[0], breaks[-1], 50), random.choice(breaks, 50),
        [-1.7e308, 1.7e308],
    ])  # fmt: skip
    random.shuffle(t)
    expected = np.clip(np.searchsorted(breaks, t, side="right") - 1, 0, len(breaks) - 2)
    spans = Spans.over(breaks)
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(spans.segment(t), expected)
        for order in (np.arange(len(t)), np.argsort(t)):
            _, gather = spans.locate(t[order], Workspace.of(len(t)))
            found = gather(np.arange(len(breaks) - 1.0), np.empty(len(t)))
            np.testing.assert_array_equal(np.broadcast_to(found, len(t)), expected[order])


POINTS = rows(5, 2)
LINE, CURVE = Curve.from_bezier([[9, 9], [8, 8]]), Curve.from_bezier(POINTS)
NAN, INFINITY = float("nan"), float("inf")


def spline(knots, degree=2):
    return lambda: Curve.from_bspline(POINTS, knots, degree)


def weighted(weights):
    return lambda: Curve.from_bezier(POINTS, weights=weights)


BAD = {
    "knots that fall": (spline([0, 0, 0, 2, 1, 3, 3, 3]), "not decrease"),
    "NaN among knots": (spline([0, 0, 0, NAN, 1, 3, 3, 3]), "finite knots"),
    "too few knots": (spline([0, 0, 1, 1]), "8 knots"),
    "no degree": (spline([0] * 8, None), "degree"),
    "an empty domain": (spline([0] * 8), "not empty"),
    "weights that vanish inside": (weighted([1, -1, 0, -1, 1]), "zeros in the domain"),
    "weights that vanish at an end": (weighted([0, 1, 1, 1, 1]), "zeros in the domain"),
    "no weights": (weighted([0] * 5), "not all zero"),
    "too few weights": (weighted([1, 2]), "one weight for every"),
    "infinite weights": (weighted([1, INFINITY, 1, 1, 1]), "finite weights"),
    "a pole inside": (lambda: Curve.from_expressions([1 / (2 * t - 1)]), "zeros in the domain"),
    "no curve to join": (lambda: Curve.join(CURVE, "line"), "curves"),
    "a gap": (lambda: Curve.join(CURVE, LINE), "gap"),
    "other dimensions": (lambda: Curve.join(CURVE, Curve.from_bezier([[0]])), "dimension"),
    "a part from behind": (lambda: CURVE.restrict(0.5, 0.5), "start < end"),
    "a split at an end": (lambda: CURVE.split(0), "an end"),
    "a split outside": (lambda: CURVE.split(2), "Stay inside"),
    "a matrix of another shape": (lambda: CURVE.transform([[1, 2, 3]]), "2 columns"),
    "an infinite map": (lambda: CURVE.transform(INFINITY), "finite"),
    "an order below zero": (lambda: CURVE.derivatives(0, -1), "order"),
}


@pytest.mark.parametrize("make, said", BAD.values(), ids=list(BAD))
def test_bad_input_is_told_clearly(make, said):
    with pytest.raises((BadValue, BadType, OutsideDomain), match=said):
        make()

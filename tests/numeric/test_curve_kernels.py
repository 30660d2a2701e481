"""Curves of every scale against exact values, and over chunks of parameters."""

from fractions import Fraction
from itertools import accumulate
from math import comb, factorial

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from numeric import Curve
from numeric.curves.evaluation import HORNER_DEGREE
from numeric.tape.runner import CHUNK

# Errors of the power form as documented, those of two roundings more, and light weights' share.
POLYNOMIAL = {True: 6e-13, False: 8e-15}
RATIONAL = {True: 5e-12, False: 2e-14}

sizes = st.sampled_from([-150, -101, -60, -3, 0, 0, 3, 60, 101, 150]).map(lambda k: 10.0**k)
lengths = st.sampled_from([-300, -100, -21, -19, -3, 0, 0, 3, 19, 21, 100]).map(lambda k: 10.0**k)
seeds = st.integers(0, 2**32 - 1).map(np.random.default_rng)


@st.composite
def hostile_curves(draw):
    """Return control points, breaks, and weights or None: of any size, with repeated points."""
    degree, dim = draw(st.integers(0, 25)), draw(st.integers(1, 4))
    segments, random = draw(st.integers(1, 3)), draw(seeds)
    points = random.uniform(-1, 1, (segments, degree + 1, dim))
    shape = draw(st.sampled_from(["random", "signs", "a point", "far away", "a repeated point"]))
    if shape == "signs":
        points = np.sign(points) * random.uniform(0.5, 1)
    elif shape == "a point":
        points[:] = points[:, :1]
    elif shape == "far away":
        points += 1e6
    elif shape == "a repeated point":
        points[:, degree // 2 :] = points[:, -1:]
    points *= draw(sizes)
    if draw(st.booleans()):
        points[..., 0] *= 1e-60  # one coordinate much smaller than the others
    start = draw(st.sampled_from([0.0, -1.0, 1e6, 1e-5]))
    steps = [draw(lengths) for _ in range(segments)]
    breaks = list(
        accumulate(steps, lambda a, h: max(a + h, np.nextafter(a, np.inf)), initial=start)
    )
    weights = None
    if draw(st.booleans()):
        weights = random.uniform(0.4, 3, (segments, degree + 1)) * draw(sizes)
        weights *= random.choice([-1, 1])
    return points, np.array(breaks), weights


def exact_point(points, weights, u):
    """Return the point of one segment at u, by Bernstein polynomials of Fractions."""
    n = len(points) - 1
    basis = [comb(n, i) * u**i * (1 - u) ** (n - i) for i in range(n + 1)]
    if weights is not None:
        basis = [b * Fraction(w) for b, w in zip(basis, weights.tolist(), strict=True)]
        basis = [b / sum(basis) for b in basis]
    return [
        sum(b * Fraction(x) for b, x in zip(basis, axis, strict=True)) for axis in points.T.tolist()
    ]


@settings(max_examples=120, deadline=None)
@given(hostile_curves(), seeds, st.booleans())
def test_points_are_exact_up_to_rounding_at_every_scale(made, random, ordered):
    points, breaks, weights = made
    curve = Curve.from_bezier(points, breaks, weights)
    i = random.integers(0, len(points), 5)
    inner = breaks[i] + random.random(5) * (breaks[i + 1] - breaks[i])
    t = np.concatenate([inner, breaks, np.nextafter(breaks[1:], -np.inf)]).clip(*curve.domain)
    t = np.sort(t) if ordered else t
    segment = np.clip(np.searchsorted(breaks, t, side="right") - 1, 0, len(points) - 1)
    bound = (POLYNOMIAL if weights is None else RATIONAL)[curve.degree <= HORNER_DEGREE]
    size = np.abs(points).max(axis=(0, 1))
    for at, k, found in zip(t.tolist(), segment, curve(t), strict=True):
        start, end = Fraction(breaks[k]), Fraction(breaks[k + 1])
        u = (Fraction(at) - start) / (end - start)
        expected = exact_point(points[k], None if weights is None else weights[k], u)
        error = np.array(
            [float(abs(Fraction(x) - e)) for x, e in zip(found, expected, strict=True)]
        )
        assert (error <= bound * size).all()


def exact_derivatives(curve, k, u, order):
    """Return derivatives of order 0, 1, ... by t at u in segment k, as a quotient of series."""
    h = Fraction(curve.breaks[k + 1]) - Fraction(curve.breaks[k])
    n, rows = curve.degree, [[Fraction(x) for x in row] for row in curve.homogeneous[k].tolist()]

    def taylor(column):
        """Return c^(j) / j! for j = 0, ..., order, from differences of the control points."""
        terms, level = [], column
        for j in range(order + 1):
            m = len(level) - 1
            value = sum(comb(m, i) * u**i * (1 - u) ** (m - i) * c for i, c in enumerate(level))
            terms.append(comb(n, j) * value if j <= n else Fraction(0))
            level = [b - a for a, b in zip(level, level[1:], strict=False)] or [Fraction(0)]
        return terms

    *axes, w = [taylor(list(column)) for column in zip(*rows, strict=True)]
    quotients = []
    for axis in axes:
        series = []
        for j in range(order + 1):
            series.append((axis[j] - sum(w[i] * series[j - i] for i in range(1, j + 1))) / w[0])
        quotients.append(series)
    return [[factorial(j) * q[j] / h**j for q in quotients] for j in range(order + 1)]


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 25), st.integers(1, 4), st.booleans(), seeds, st.sampled_from([1e-9, 1, 1e9]))
def test_derivatives_are_exact_derivatives_rounded(degree, dim, rational, random, scale):
    points = random.uniform(-1, 1, (2, degree + 1, dim))
    weights = random.uniform(0.5, 2, (2, degree + 1)) if rational else None
    curve = Curve.from_bezier(points, np.array([-1, 0, 2]) * scale, weights)
    t = np.array([-1, -0.375, 0, 1.25, 2]) * scale
    found, hodograph = curve.derivatives(t, 3), curve.derivative()(t)
    for place, at in enumerate(t):
        k = int(at >= 0)
        h = curve.breaks[k + 1] - curve.breaks[k]
        u = (Fraction(at) - Fraction(curve.breaks[k])) / Fraction(h)
        for j, expected in enumerate(exact_derivatives(curve, k, u, 3)):
            size = (2 * max(degree, 1) / h) ** j * (8**j if rational else 1)
            error = np.abs(found[j][place] - np.array([float(e) for e in expected])).max()
            assert error <= 1e-12 * size
            if j == 1:
                told = np.abs(hodograph[place] - np.array([float(e) for e in expected])).max()
                assert told <= 1e-12 * size


@pytest.mark.parametrize("degree", [0, 2, 9])
@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("segments", [1, 3, 4000])
def test_many_parameters_give_what_each_gives_alone(degree, rational, segments):
    """Chunks in one segment, in several, sorted or not, and those that end between two."""
    random = np.random.default_rng(degree)
    points = random.uniform(-1, 1, (segments, degree + 1, 2))
    weights = random.uniform(1, 2, (segments, degree + 1)) if rational else None
    curve = Curve.from_bezier(points, (-1, 1), weights)
    count = 4 * CHUNK + 3  # of three segments, the first chunk holds one and the second two
    rising = np.sort(np.append(random.uniform(-1, 1, count - 9), np.resize(curve.breaks, 9)))
    orders = {
        "rising": rising,
        "falling": rising[::-1],
        "in any order": random.permutation(rising),
        "one value": np.full(count, 0.25),
        "one number out of order": np.append(rising[1:], rising[0]),
        "some that are no numbers": np.where(np.arange(count) % CHUNK == 5, np.nan, rising),
        "the first no number": np.append(np.nan, rising[1:]),
        "every second of a longer array": np.repeat(rising, 2)[::2],
    }
    for name, t in orders.items():
        found = curve(t)
        near = np.add.outer([4, CHUNK, 2 * CHUNK, count - 5], np.arange(-4, 5)).ravel()
        some = np.append(near, random.integers(0, count, 30))
        alone = np.array([curve(t[i]) for i in some])
        np.testing.assert_allclose(found[some], alone, rtol=0, atol=1e-14, err_msg=name)
        segment = np.searchsorted(curve.breaks[1:-1], t, side="right")
        again = Curve.from_bezier(segment_numbers(segments), (-1, 1))(t)[:, 0]
        np.testing.assert_array_equal(again, np.where(np.isnan(t), np.nan, segment), err_msg=name)


def segment_numbers(segments):
    """Return control points of constants: which segment it is."""
    return np.arange(float(segments))[:, None, None]


def test_long_arrays_are_left_as_they_are():
    t = np.random.default_rng(0).random(3 * CHUNK)
    kept = t.copy()
    Curve.from_bezier(np.zeros((50, 4, 2)))(t)
    np.testing.assert_array_equal(t, kept)


@settings(max_examples=40, deadline=None)
@given(hostile_curves(), seeds)
def test_a_curve_cut_anywhere_is_in_its_parts(made, random):
    points, breaks, _ = made
    curve = Curve.from_bezier(points, breaks)
    start, end = curve.domain
    u = np.sort(random.random(2))
    a, b = (start + u * (end - start)).clip(start, end)
    assume(start < a < b < end)
    bound = 2 * POLYNOMIAL[curve.degree <= HORNER_DEGREE] * np.abs(points).max(axis=(0, 1))
    left, right = curve.split(a)
    middle = curve.restrict(a, b)
    assert (left.domain, right.domain, middle.domain) == ((start, a), (a, end), (a, b))
    for part in (left, right, middle):
        assert (np.diff(part.breaks) > 0).all()
        t = np.linspace(*part.domain, 7)
        t = t[t < part.domain[1]]  # at a gap, its end belongs to what follows
        assert (np.abs(part(t) - curve(t)) <= bound).all()


def test_parts_between_breaks_are_whole_segments():
    curve = Curve.from_bezier([[[0.1], [0.7]], [[5], [6]], [[0.3], [0.9]]], (0, 1, 3, 4))
    assert curve.restrict(1, 3).rows.tolist() == [[[5], [6]]]
    assert curve.restrict(0, 3).rows.tolist() == curve.rows[:2].tolist()
    assert [part.rows.tolist() for part in curve.split(1)] == [
        curve.rows[:1].tolist(), curve.rows[1:].tolist(),
    ]  # fmt: skip

"""Boxes, lengths, curvature and inflections against closed forms and exact arithmetic."""

import math

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.special import ellipe

from numeric import Curve
from symbolic import BadType, BadValue, OutsideDomain, circle

t = sp.Symbol("t")
CUSP = [[0, 0], [1, 1], [0, 1], [1, 0]]
LOOP = [[0, 0], [3, 2], [-2, 2], [1, 0]]
S_SHAPE = [[0, 0], [1, 2], [2, -2], [3, 0]]
POINT = [[2, 3]] * 4
THERE_AND_BACK = [[0, 0], [3, 0], [0, 0]]
numbers = st.integers(-99, 99).map(float)


def random_curve(seed, rational=False, most=25, dims=(1, 2, 3, 4)):
    random = np.random.default_rng(seed)
    degree, segments, dim = random.integers(1, most + 1), random.integers(1, 5), random.choice(dims)
    points = random.normal(size=(segments, degree + 1, dim))
    weights = random.uniform(0.2, 5, (segments, degree + 1)) if rational else None
    breaks = np.append(0, np.cumsum(random.uniform(0.1, 3, segments)))
    return Curve.from_bezier(points, breaks, weights)


seeds = st.integers(0, 2**32 - 1)


@settings(max_examples=60, deadline=None)
@given(seeds, st.booleans())
def test_the_box_contains_every_point_and_is_attained(seed, rational):
    curve = random_curve(seed, rational)
    box = curve.bounding_box()
    size = np.abs(curve.points).max()
    segments = [
        curve.with_rows(curve.rows[i : i + 1], np.array([0.0, 1])) for i in range(len(curve))
    ]
    points = np.concatenate([segment(np.linspace(0, 1, 4001)) for segment in segments])
    rounding = 1e-11 * size  # of points by Horner's rule, divided by weights
    assert (points >= box[0] - rounding).all() and (points <= box[1] + rounding).all()
    # The samples miss an extremum by a square of their distance.
    assert np.abs(np.stack([points.min(axis=0), points.max(axis=0)]) - box).max() < 1e-3 * size


def test_boxes_of_closed_forms():
    np.testing.assert_allclose(
        Curve.from_nurbs(circle([1, 2], 3)).bounding_box(), [[-2, -1], [4, 5]], rtol=1e-15
    )
    curve = Curve.from_expressions([t**3 - 3 * t, t], t, (-2, 2))
    np.testing.assert_allclose(curve.bounding_box(), [[-2, -2], [2, 2]], rtol=1e-15)
    # y = t / (1 + t^2) is largest at 1.
    curve = Curve.from_expressions([t, t / (1 + t**2)], t, (0, 3))
    np.testing.assert_allclose(curve.bounding_box(), [[0, 0], [3, 0.5]], rtol=0, atol=1e-15)


def test_a_box_where_a_weight_is_negative():
    """The other arc of a circle: its middle lies on the far side of the control points."""
    arc = Curve.from_bezier([[1, 0], [0.5, 3**0.5], [0, 0]], weights=[1, -0.4, 1])
    points = arc(np.linspace(0, 1, 10001))
    np.testing.assert_allclose(
        arc.bounding_box(), [points.min(axis=0), points.max(axis=0)], rtol=0, atol=1e-7
    )


@pytest.mark.parametrize(
    "points", [POINT, CUSP, THERE_AND_BACK, [[1, 2]], [[0, 0], [0, 0], [1, 1]]]
)
@pytest.mark.parametrize("scale", [1e-300, 1e-150, 1.0, 1e150, 1e300])
def test_boxes_of_degenerate_curves_at_any_scale(points, scale):
    expected = Curve.from_bezier(points).bounding_box()
    found = Curve.from_bezier(np.array(points) * scale).bounding_box()
    np.testing.assert_allclose(found / scale, expected, rtol=1e-14)


def parabola_length(a, b):
    """Return the length of y = x^2 from a to b."""

    def primitive(x):
        return x * math.hypot(1, 2 * x) / 2 + math.asinh(2 * x) / 4

    return primitive(b) - primitive(a)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-14, 1e-30])
@pytest.mark.parametrize("elevated", [0, 1, 7, 23])
def test_disguised_parabolas(tolerance, elevated):
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    curve = Curve.from_expressions([t, t**2], t, (-1, 3)).elevate(elevated).transform(turn, [7, -5])
    pieces = Curve.join(*curve.split(0.3)).reparametrize((5, 6))
    expected = parabola_length(-1, 3)
    for form in (curve, pieces):
        assert abs(form.length(tolerance) - expected) <= max(tolerance, 1e-13) * expected


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-14, 1e-30])
def test_an_ellipse_and_a_circle(tolerance):
    round_ = Curve.from_nurbs(circle())
    flat = round_.transform([[50, 0], [0, 1]], [1000, 0])
    expected = 4 * 50 * ellipe(1 - 1 / 50**2)
    assert abs(flat.length(tolerance) - expected) <= max(tolerance, 2e-13) * expected
    assert abs(round_.length(tolerance) - 2 * math.pi) <= max(tolerance, 1e-14) * 2 * math.pi


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6, 1e-9, 1e-12])
def test_cusps(tolerance):
    """(t^2, t^3) has length ((4 + 9 t^2)^(3/2) - 8) / 27 from its cusp at 0."""
    curve = Curve.from_expressions([t**2, t**3], t, (-1, sp.Rational(2, 3)))
    expected = sum(((4 + 9 * u * u) ** 1.5 - 8) / 27 for u in (1, 2 / 3))
    assert abs(curve.length(tolerance) - expected) <= tolerance * expected


@pytest.mark.parametrize("end", [sp.Rational(1, 10**k) for k in range(0, 12, 3)])
def test_nearly_cusps(end):
    """The speed of (t^2, end t) is a hyperbola of width `end`: hidden between all nodes."""
    curve = Curve.from_expressions([t**2, end * t], t, (sp.Rational(-1, 3), 1))
    a = float(end)
    expected = parabola_length(-1 / 3 / a, 1 / a) * a**2
    assert curve.length() == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("k", range(1, 40))
def test_no_kink_hides_between_the_nodes(k, rational):
    """(t - a)^2 / (1 + t^2) turns at a and -1/a; the length on a line is that of both ways."""
    at = sp.Rational(k, 1000 if k % 2 else 41)
    below = 1 + t**2 if rational else sp.Integer(1)
    points = [(t - at) ** 2 / below]
    turn = [float((u - at) ** 2 / below.subs(t, u)) for u in (0, at, 1)]
    expected = abs(turn[0] - turn[1]) + abs(turn[2] - turn[1])
    assert Curve.from_expressions(points, t).length() == pytest.approx(expected, rel=1e-9)


def test_there_and_back_counts_twice():
    assert Curve.from_bezier(THERE_AND_BACK).length() == pytest.approx(3, rel=1e-9)
    assert Curve.from_bezier(THERE_AND_BACK).length(1e-13) == pytest.approx(3, rel=1e-13)
    assert Curve.from_bezier([[0], [3], [0]]).length() == pytest.approx(3, rel=1e-9)


@pytest.mark.parametrize("points", [POINT, [[5, 1, 2]], [[3], [3]]])
def test_a_point_has_no_length(points):
    curve = Curve.from_bezier(points)
    assert curve.length() == 0
    assert curve.parameter_at_length([0, 0]).tolist() == [0, 0]
    assert curve.parameters_by_arc_length(3).tolist() == [0, 0.5, 1]


@settings(max_examples=40, deadline=None)
@given(st.lists(st.lists(numbers, min_size=3, max_size=3), min_size=2, max_size=2))
def test_lines_are_as_long_as_their_ends_are_apart(points):
    line = Curve.from_bezier(points)
    distance = math.dist(*points)
    assert line.length() == pytest.approx(distance, rel=1e-14)
    assert line.elevate(5).length() == pytest.approx(distance, rel=1e-14)


@settings(max_examples=40, deadline=None)
@given(seeds, st.booleans(), st.sampled_from([1e-150, 1e-9, 3.0, 1e12, 1e150]))
def test_length_under_similarities_and_other_forms(seed, rational, factor):
    curve = random_curve(seed, rational, 12)
    length = curve.length()
    assert curve.transform(factor).length() == pytest.approx(factor * length, rel=4e-9)
    assert curve.reverse().length() == pytest.approx(length, rel=2e-9)
    assert curve.reparametrize((3, 99)).length() == pytest.approx(length, rel=2e-9)
    if not rational:  # between the chord's and the polygon's
        polygon = np.linalg.norm(np.diff(curve.points, axis=1), axis=2).sum()
        chord = np.linalg.norm(curve.points[:, -1] - curve.points[:, 0], axis=1).sum()
        assert chord * (1 - 1e-9) <= length <= polygon * (1 + 1e-9)
    middle = sum(curve.domain) / 2
    halves = curve.split(middle)
    assert sum(half.length() for half in halves) == pytest.approx(length, rel=2e-9)


@settings(max_examples=20, deadline=None)
@given(seeds, st.booleans())
def test_length_agrees_with_scipy(seed, rational):
    from scipy.integrate import quad

    curve = random_curve(seed, rational, 5, (2, 3, 4))
    slope = curve.derivative()
    expected = sum(
        quad(lambda u: float(np.linalg.norm(slope(u))), a, b, limit=500, epsabs=0, epsrel=1e-10)[0]
        for a, b in zip(curve.breaks, np.nextafter(curve.breaks[1:], 0), strict=False)
    )
    assert curve.length() == pytest.approx(expected, rel=1e-7)  # SciPy overlooks some turns


@settings(max_examples=40, deadline=None)
@given(seeds)
def test_on_a_line_the_length_is_the_total_variation(seed):
    """Between turns, the roots of c' by their companion matrix, coordinates add up."""
    random = np.random.default_rng(seed)
    powers = np.polynomial.Polynomial(random.normal(size=random.integers(2, 7)))
    turns = powers.deriv().roots()
    turns = np.sort(turns[np.isreal(turns)].real)
    at = np.clip(np.concatenate([[0], turns, [1]]), 0, 1)
    expected = np.abs(np.diff(powers(at))).sum()
    exact = sum(sp.Rational(a) * t**k for k, a in enumerate(powers.coef))
    assert Curve.from_expressions([exact], t).length() == pytest.approx(expected, rel=1e-9)


@settings(max_examples=40, deadline=None)
@given(seeds, st.booleans())
def test_parameters_at_lengths_have_these_lengths(seed, rational):
    curve = random_curve(seed, rational, 8)
    total = curve.length(1e-13)
    share = np.array([[0, 0.1], [1, 0.73], [0.5, np.nan]])
    at = curve.parameter_at_length(share * total)
    assert at.shape == share.shape and np.isnan(at[2, 1])
    np.testing.assert_allclose([at[0, 0], at[1, 0]], curve.domain, rtol=1e-8)
    for u, part in ((at[0, 1], 0.1), (at[1, 1], 0.73), (at[2, 0], 0.5)):
        assert curve.restrict(curve.domain[0], u).length(1e-13) == pytest.approx(
            part * total, rel=1e-11
        )


@pytest.mark.parametrize("points", [CUSP, LOOP, S_SHAPE, THERE_AND_BACK, [[0, 0]] * 3 + [[1, 1]]])
def test_equal_lengths_between_parameters(points):
    curve = Curve.from_bezier(points, domain=(2, 5))
    at = curve.parameters_by_arc_length(12)
    assert (at[0], at[-1]) == (2, 5) and (np.diff(at) > 0).all()
    parts = [curve.restrict(a, b).length(1e-12) for a, b in zip(at, at[1:], strict=False)]
    np.testing.assert_allclose(parts, curve.length() / 11, rtol=1e-8)


def test_circles_are_divided_into_equal_angles():
    curve = Curve.from_nurbs(circle())
    at = curve(curve.parameters_by_arc_length(1001))
    angle = np.linspace(0, 2 * np.pi, 1001)
    np.testing.assert_allclose(at, np.stack([np.cos(angle), np.sin(angle)], 1), rtol=0, atol=1e-14)


def test_resting_segments_are_passed_over():
    segments = [[[0, 0], [1, 0]], [[1, 0], [1, 0]], [[1, 0], [1, 2]]]
    curve = Curve.from_bezier(segments, domain=(0, 3))
    np.testing.assert_allclose(curve.parameter_at_length([0.5, 2, 3]), [0.5, 2.5, 3])
    assert curve(curve.parameter_at_length(1)).tolist() == [1, 0]


@pytest.mark.parametrize("s", [-1e-9, 5.1, [0, 6], np.inf, -np.inf])
def test_lengths_out_of_reach(s):
    with pytest.raises(OutsideDomain, match=r"lengths in \[0, 5\]"):
        Curve.from_bezier([[0, 0], [3, 4]]).parameter_at_length(s)


def test_a_length_that_was_measured_may_be_given_back():
    curve = Curve.from_bezier(CUSP)
    for tolerance in (1e-9, 1e-12):
        assert curve.parameter_at_length(curve.length(tolerance)) == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize("tolerance", [0, -1, float("nan"), float("inf"), "1e-3", None, [1e-3, 1]])
def test_bad_tolerances(tolerance):
    with pytest.raises((BadValue, BadType), match="Expected"):
        Curve.from_bezier(LOOP).length(tolerance)


@pytest.mark.parametrize("count", [1, 0, -3, 2.0, True, "5", None])
def test_bad_counts(count):
    with pytest.raises(BadValue, match="2, 3"):
        Curve.from_bezier(LOOP).parameters_by_arc_length(count)


# Curvature


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(numbers, numbers), min_size=3, max_size=9), st.integers(0, 16))
def test_curvature_agrees_with_exact_calculus(points, k):
    u = sp.Rational(k, 16)
    from symbolic import bezier

    c = bezier(len(points) - 1).curve([[sp.Integer(int(a)) for a in p] for p in points])
    first, second = ([sp.diff(e, t, order).subs(t, u) for e in c] for order in (1, 2))
    speed = float(sp.sqrt(first[0] ** 2 + first[1] ** 2))
    assume(speed > 1)
    expected = float(first[0] * second[1] - first[1] * second[0]) / speed**3
    scale = math.hypot(*map(float, second)) / speed**2
    n = len(points) - 1
    found = Curve.from_bezier(points).curvature(float(u))
    assert abs(found - expected) <= 1e-12 * (scale + 100 * n * n / speed**2) * (1 + 100 * n / speed)


def test_curvature_of_circles():
    for radius in (0.001, 1, 1000):
        curve = Curve.from_nurbs(circle([5, -7], sp.Rational(radius)))
        at = np.linspace(0, 1, 99).reshape(3, 33)
        np.testing.assert_allclose(curve.curvature(at), 1 / radius, rtol=1e-10)
        np.testing.assert_allclose(curve.reverse().curvature(at), -1 / radius, rtol=1e-10)


def test_curvature_in_space():
    """(t, t^2, t^3) at 0 has curvature 2; a plane curve lifted has the size of its own."""
    curve = Curve.from_expressions([t, t**2, t**3], t, (-1, 1))
    assert curve.curvature(0) == pytest.approx(2, rel=1e-14)
    flat = Curve.from_bezier(S_SHAPE)
    lifted = flat.transform([[0.6, -0.8], [0.8, 0.6], [0, 0], [0, 0]], [1, 2, 3, 4])
    at = np.linspace(0, 1, 41)
    np.testing.assert_allclose(lifted.curvature(at), np.abs(flat.curvature(at)), atol=1e-12)


@settings(max_examples=40, deadline=None)
@given(seeds, st.booleans(), st.sampled_from([1e-150, 1e-3, 7.0, 1e150]))
def test_curvature_scales_inversely_and_takes_no_notice_of_the_domain(seed, rational, factor):
    curve = random_curve(seed, rational, 6, (2, 3, 4))
    at = np.linspace(*curve.domain, 12)[1:-1]
    expected = curve.curvature(at)
    tight = 1e-9 * (1 + np.abs(expected) ** 2)
    assert (np.abs(curve.transform(factor).curvature(at) * factor - expected) < tight).all()
    moved = curve.reparametrize((-3, -1))
    share = (at - curve.domain[0]) / (curve.domain[1] - curve.domain[0])
    assert (np.abs(moved.curvature(-3 + 2 * share) - expected) < 1e3 * tight).all()


@pytest.mark.parametrize("end", [1e-300, 1e-160, 1e160, 1e300])
def test_curvature_on_domains_whose_squares_are_no_floats(end):
    curve = Curve.from_bezier(LOOP)
    at = np.array([0, 0.2, 0.9])
    found = curve.reparametrize((0, end)).curvature(at * end)
    np.testing.assert_allclose(found, curve.curvature(at), rtol=1e-12)
    with pytest.raises(OutsideDomain, match="parameters in"):
        curve.reparametrize((0, end)).curvature(2 * end)


def test_curvature_of_many_points_takes_them_in_chunks():
    curve = Curve.from_bezier(LOOP)
    at = np.linspace(0, 1, 40_000).reshape(2, -1)
    found = curve.curvature(at)
    picked = [[0, 1, 16_383, 16_384, 19_999]]
    for row in (0, 1):
        np.testing.assert_array_equal(found[row][picked], curve.curvature(at[row][picked]))


def test_where_the_speed_vanishes_curvature_has_no_value():
    assert np.isnan(Curve.from_bezier(CUSP).curvature(0.5))
    assert np.isnan(Curve.from_bezier(POINT).curvature([0, 0.3, 1])).all()
    assert np.isnan(Curve.from_bezier([[0, 0], [0, 0], [1, 1], [2, 0]]).curvature(0))
    slow = Curve.from_bezier([[0.1, 0.7], [0.1, 0.7], [1, 1]], weights=[1, 3, 2])
    assert np.isnan(slow.curvature(0))
    assert np.isnan(Curve.from_bezier(LOOP).curvature([np.nan, 0.2])).tolist() == [True, False]
    assert Curve.from_bezier(LOOP).curvature(np.empty((0, 2))).shape == (0, 2)


def test_a_line_is_not_curved():
    line = Curve.from_bezier([[0.1, 0.3], [0.2, 0.6], [0.3, 0.9]])
    assert np.abs(line.curvature(np.linspace(0, 1, 9))).max() < 1e-14
    assert Curve.from_bezier([[0, 0], [1, 2]]).curvature(0.5) == 0


def test_curvature_needs_a_plane_and_a_domain():
    with pytest.raises(BadValue, match="dimension 2 or more"):
        Curve.from_bezier([[0], [1]]).curvature(0)
    with pytest.raises(OutsideDomain):
        Curve.from_bezier(LOOP).curvature(1.5)
    with pytest.raises(BadType):
        Curve.from_bezier(LOOP).curvature("0.5")


# Inflections


def test_inflections_of_known_curves():
    assert Curve.from_bezier(S_SHAPE).inflections().tolist() == pytest.approx([0.5], abs=1e-15)
    assert Curve.from_expressions([t, t**3 - t], t, (-1, 3)).inflections() == pytest.approx(
        [0], abs=1e-15
    )
    sine = Curve.from_expressions([t, t**5 / 20 - t**4 / 12 - t**3 / 3 + t**2], t, (-5, 5))
    # y'' = t^3 - t^2 - 2 t + 2 = (t - 1)(t^2 - 2)
    np.testing.assert_allclose(sine.inflections(), [-(2**0.5), 1, 2**0.5], rtol=1e-13)


@pytest.mark.parametrize("curve", [
    Curve.from_bezier(POINT), Curve.from_bezier(CUSP), Curve.from_bezier(LOOP),
    Curve.from_bezier(THERE_AND_BACK), Curve.from_bezier([[1, 1]]),
    Curve.from_expressions([t, t**4], t, (-1, 1)),  # a zero of curvature, no change
    Curve.from_nurbs(circle()), Curve.from_bezier([[0, 0], [1, 3], [2, -5]]),
], ids=str)  # fmt: skip
def test_curves_without_inflections(curve):
    assert curve.inflections().shape == (0,)


@settings(max_examples=60, deadline=None)
@given(seeds, st.integers(1, 12), st.booleans())
def test_straight_lines_have_no_inflections(seed, degree, rational):
    random = np.random.default_rng(seed)
    along = np.sort(random.random(degree + 1)) if seed % 2 else random.normal(size=degree + 1)
    points = random.normal(size=2) + along[:, None] * random.normal(size=2)
    weights = random.uniform(0.5, 2, degree + 1) if rational else None
    assert len(Curve.from_bezier(points, weights=weights).inflections()) == 0


def test_changes_across_breaks_count():
    up, down = [[0, 0], [1, 1], [2, 0]], [[2, 0], [3, -1], [4, 0]]
    straight = [[2, 0], [3, -1], [4, -2]]
    assert Curve.from_bezier([up, down]).inflections().tolist() == [0.5]
    assert Curve.from_bezier([up, down, up]).inflections() == pytest.approx([1 / 3, 2 / 3])
    assert len(Curve.from_bezier([up, up]).inflections()) == 0
    # A straight stretch between two bends: where it ends.
    assert Curve.from_bezier([up, straight, down], (0, 1, 2, 3)).inflections().tolist() == [2]
    assert len(Curve.from_bezier([up, straight, up]).inflections()) == 0


@settings(max_examples=60, deadline=None)
@given(seeds, st.booleans())
def test_curvature_has_one_sign_between_inflections(seed, rational):
    curve = random_curve(seed, rational, 8, (2,))
    at = np.unique(np.concatenate([curve.inflections(), curve.domain]))
    signs = []
    for a, b in zip(at, at[1:], strict=False):
        between = curve.curvature(a + (b - a) * np.linspace(0.001, 0.999, 301))
        big = between[np.abs(between) > 1e-7]
        assert (big > 0).all() or (big < 0).all()
        signs += [np.sign(big[0])] if len(big) else []
    if len(signs) == len(at) - 1:
        assert all(a != b for a, b in zip(signs, signs[1:], strict=False))


@settings(max_examples=40, deadline=None)
@given(seeds, st.booleans(), st.sampled_from([1e-150, 1e-5, 1.0, 1e150]))
def test_inflections_are_affine_invariants(seed, rational, factor):
    curve = random_curve(seed, rational, 6, (2,))
    image = curve.transform(factor * np.array([[2, 1], [-1, 3]]), [factor, 0])
    expected = curve.inflections()
    np.testing.assert_allclose(image.inflections(), expected, rtol=0, atol=1e-7)
    start, end = curve.domain
    back = np.sort(start + end - curve.reverse().inflections())
    np.testing.assert_allclose(back, expected, rtol=0, atol=1e-7)


def test_elevation_changes_no_inflections():
    curve = Curve.from_bezier([[0, 0], [1, 2], [2, -3], [3, 0]])
    expected = curve.inflections()
    assert len(expected) == 1
    for by in range(1, 23):
        np.testing.assert_allclose(curve.elevate(by).inflections(), expected, rtol=0, atol=1e-9)


def test_inflections_need_the_plane():
    with pytest.raises(BadValue, match="plane"):
        Curve.from_bezier([[0, 0, 0], [1, 1, 1]]).inflections()


def test_arc_length_over_weights_of_very_different_sizes():
    points = [[0, 0], [1, 3], [2, 0]]
    uneven = Curve.from_bezier(points, weights=[1e-5, 1, 1e5])
    parabola = Curve.from_bezier(points)
    assert uneven.length() == pytest.approx(parabola.length(), rel=1e-12)
    expected = parabola(parabola.parameters_by_arc_length(9))
    np.testing.assert_allclose(uneven(uneven.parameters_by_arc_length(9)), expected, atol=1e-10)


@pytest.mark.parametrize("weight", [1e5, 1e10, 1e14])
def test_a_curve_that_rests_at_a_heavy_point_has_a_length(weight):
    """It runs along both legs in no time, and nearly stands still at the point between."""
    legs = np.sqrt(10)
    curve = Curve.from_bezier([[0, 0], [1, 3], [2, 0]], weights=[1, weight, 1])
    assert 2 * legs * (1 - 20 / weight) <= curve.length() <= 2 * legs * (1 + 1e-12)
    t = curve.parameters_by_arc_length(5)
    assert (np.diff(t) >= 0).all() and t[2] == pytest.approx(0.5, abs=0.05)

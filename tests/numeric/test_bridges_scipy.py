"""SciPy's splines and ours give the same points, and come back as they went."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import interpolate
from scipy.interpolate import BPoly, BSpline, PPoly

from numeric import Curve
from numeric.bridges import from_scipy, to_scipy
from symbolic import BadType, BadValue, circle

fast = settings(max_examples=60, deadline=None)
KINDS = [BSpline, PPoly, BPoly]


def random_breaks(rng, count):
    return np.cumsum(rng.uniform(0.01, 2, count + 1)) - 3


@fast
@given(st.integers(0, 6), st.integers(0, 12), st.integers(0, 4), st.booleans(), st.integers(0, 999))
def test_bsplines_with_repeated_knots(degree, inner, dim, clamped, seed):
    rng = np.random.default_rng(seed)
    steps = np.arange(degree + 1) * (0.0 if clamped else 0.3)
    inside = np.sort(rng.integers(0, 5, inner)) * 0.7
    knots = np.concatenate([-1 - steps[::-1], inside, 4 + steps])
    count = len(knots) - degree - 1
    c = rng.normal(size=(count + 2, dim) if dim else count + 2)  # two that SciPy ignores
    spline = BSpline(knots, c, degree)
    curve = from_scipy(spline)
    assert curve.domain == (knots[degree], knots[count])
    t = np.append(rng.uniform(*curve.domain, 40), curve.breaks[:-1])
    expected = spline(t) if dim else spline(t)[:, None]
    np.testing.assert_allclose(curve(t), expected, rtol=0, atol=1e-12)


@fast
@given(st.integers(0, 7), st.integers(1, 6), st.integers(0, 4), st.booleans(), st.integers(0, 999))
def test_ppoly_and_bpoly_also_with_decreasing_breaks(degree, count, dim, decreasing, seed):
    rng = np.random.default_rng(seed)
    x = random_breaks(rng, count)
    x = x[::-1] if decreasing else x
    c = rng.normal(size=(degree + 1, count, dim) if dim else (degree + 1, count))
    t = rng.uniform(x.min(), x.max(), 50)
    for kind in (PPoly, BPoly):
        spline = kind(c, x)
        curve = from_scipy(spline)
        assert curve.breaks.tolist() == sorted(x)
        expected = spline(t) if dim else spline(t)[:, None]
        size = np.abs(curve.rows).max()
        np.testing.assert_allclose(curve(t), expected, rtol=0, atol=3e-13 * size)


@pytest.mark.parametrize("make", [
    lambda x, y: interpolate.CubicSpline(x, y, axis=1),
    lambda x, y: interpolate.PchipInterpolator(x, y, axis=1),
    lambda x, y: interpolate.Akima1DInterpolator(x, y, axis=1),
    lambda x, y: interpolate.make_interp_spline(x, y, k=5, axis=1),
    lambda x, y: interpolate.CubicHermiteSpline(x, y, 2 * y, axis=1),
])  # fmt: skip
def test_interpolants_along_another_axis(make):
    rng = np.random.default_rng(1)
    x, y = np.sort(rng.normal(size=9)), rng.normal(size=(2, 9))
    curve, spline = from_scipy(make(x, y)), make(x, y)
    np.testing.assert_allclose(curve(x), y.T, atol=1e-11)
    t = rng.uniform(x[0], x[-1], 100)
    bound = 1e-13 * np.abs(curve.rows).max()
    np.testing.assert_allclose(curve(t), spline(t).T, rtol=0, atol=bound)


@fast
@given(
    st.integers(0, 25), st.integers(1, 5), st.integers(1, 4), st.integers(0, 999),
    st.sampled_from([1e-150, 1.0, 1e150]),
)  # fmt: skip
def test_control_points_come_back_bit_for_bit(degree, count, dim, seed, scale):
    """Also where some segments meet, and others do not."""
    rng = np.random.default_rng(seed)
    rows = scale * rng.normal(size=(count, degree + 1, dim))
    meets = np.flatnonzero(rng.random(count - 1) < 0.5)
    rows[meets + 1, 0] = rows[meets, -1]
    curve = Curve.from_bezier(rows, random_breaks(rng, count))
    for kind in (BPoly, BSpline):
        back = from_scipy(to_scipy(curve, kind))
        assert back.rows.tobytes() == curve.rows.tobytes()
        assert back.breaks.tobytes() == curve.breaks.tobytes()


@fast
@given(
    st.integers(0, 5), st.integers(1, 5), st.integers(0, 999),
    st.sampled_from([1e-150, 1.0, 1e150]), st.sampled_from([1e-20, 1.0, 1e20]),
)  # fmt: skip
def test_powers_come_back_within_rounding(degree, count, seed, scale, length):
    rng = np.random.default_rng(seed)
    rows = scale * rng.normal(size=(count, degree + 1, 2))
    curve = Curve.from_bezier(rows, length * random_breaks(rng, count))
    back = from_scipy(to_scipy(curve, PPoly))
    assert back.breaks.tobytes() == curve.breaks.tobytes()
    np.testing.assert_allclose(back.rows, rows, rtol=0, atol=1e-13 * np.abs(rows).max())


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dim", [1, 3])
def test_scipy_evaluates_and_differentiates_what_it_gets(kind, dim):
    rng = np.random.default_rng(dim)
    points, knots = rng.normal(size=(8, dim)), [0, 0, 0, 0, 0.3, 1, 1, 2.5, 4, 4, 4, 4]
    curve = Curve.from_bspline(points, knots, 3)
    spline = to_scipy(curve, kind)
    assert type(spline) is kind
    t = np.append(rng.uniform(0, 4, 50), [0, 4])
    np.testing.assert_allclose(spline(t), curve(t), atol=1e-13)
    np.testing.assert_allclose(spline.derivative()(t), curve.derivative()(t), atol=1e-11)


def test_splines_share_no_memory_with_the_curve():
    curve = Curve.from_bezier([[0.0, 1.0], [2.0, 3.0]])
    for kind in (BPoly, PPoly):
        spline = to_scipy(curve, kind)
        spline.c[:] = 7
        spline.x[1] = 9
    assert curve.rows.tolist() == [[[0, 1], [2, 3]]] and curve.breaks.tolist() == [0, 1]
    spline = BPoly([[1.0], [2.0]], [0.0, 1.0])
    from_scipy(spline)
    spline.c[:] = 7  # is not made read-only


def test_pieces_of_length_zero_are_left_out():
    spline = PPoly([[1.0, 5.0, 2.0]], [0, 1, 1, 3])
    curve = from_scipy(spline)
    assert curve.breaks.tolist() == [0, 1, 3] and curve.rows.ravel().tolist() == [1, 2]


@pytest.mark.parametrize(("spline", "error", "said"), [
    (3, BadType, "BSpline, PPoly or BPoly"),
    (([0, 0, 1, 1], [1, 2], 1), BadType, "BSpline\\(t, c, k\\)"),
    (BSpline([0, 0, 1, 1], [1j, 2], 1), BadType, "real coefficients"),
    (PPoly([[1j]], [0, 1]), BadType, "real coefficients"),
    (BSpline([0, 0, 1, 1], np.zeros((2, 2, 2)), 1), BadValue, "numbers or points"),
    (PPoly([[np.nan]], [0, 1]), BadValue, "finite"),
    (PPoly([[1.0]], [0, np.inf]), BadValue, "finite"),
    (PPoly(np.ones((9, 1)), [0, 1e60]), BadValue, "moderate length"),
    (PPoly([[1.0]], [0, 0]), BadValue, "at least one"),
])  # fmt: skip
def test_what_is_not_read(spline, error, said):
    with pytest.raises(error, match=said):
        from_scipy(spline)


@pytest.mark.parametrize(("curve", "kind", "error", "said"), [
    (Curve.from_nurbs(circle()), BSpline, BadValue, "homogeneous"),
    (Curve.from_bezier([[0], [1]]), "BSpline", BadType, "the class"),
    (Curve.from_bezier([[0], [1]]), interpolate.CubicSpline, BadType, "the class"),
    ([[0], [1]], BSpline, BadType, "a curve"),
    (Curve.from_bezier([[0], [1], [5]], (0, 1e-200)), PPoly, BadValue, "use BPoly"),
    (Curve.from_bezier([[0], [1], [5]], (0, 1e200)), PPoly, BadValue, "use BPoly"),
])  # fmt: skip
def test_what_is_not_written(curve, kind, error, said):
    with pytest.raises(error, match=said):
        to_scipy(curve, kind)


def test_the_remedy_for_rational_curves():
    curve = Curve.from_nurbs(circle())
    spline = to_scipy(Curve(curve.homogeneous, curve.breaks), BSpline)
    t = np.linspace(0, 1, 33)
    np.testing.assert_allclose(spline(t)[:, :2] / spline(t)[:, 2:], curve(t), atol=1e-14)

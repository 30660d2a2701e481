"""Curves whose numbers are as large or small as floats can be, and what is told beyond."""

import warnings

import numpy as np
import pytest

from numeric import Curve
from symbolic import BadValue, OutsideDomain

LARGEST = np.finfo(float).max


@pytest.mark.parametrize("degree", [1, 3, 7, 8, 25])
@pytest.mark.parametrize("weights", [None, 1.0, 1e-300, 1e300, 5e-324])
def test_the_largest_numbers_are_coordinates_too(degree, weights):
    points = np.outer((-1.0) ** np.arange(degree + 1), [LARGEST, LARGEST / 3])
    weights = None if weights is None else np.full(degree + 1, weights)
    curve = Curve.from_bezier(points, weights=weights)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = curve([0, 0.25])
    np.testing.assert_allclose(found[0], points[0], rtol=1e-15)
    expected = points[0] * 0.5**degree  # (1 - 2 u)^n
    np.testing.assert_allclose(found[1], expected, rtol=0, atol=1e-12 * LARGEST)


@pytest.mark.parametrize("size", [1e-250, 1e-90, 1, 1e90, 1e249])
@pytest.mark.parametrize("length", [1e-300, 1e-19, 1, 1e19, 1e300])
@pytest.mark.parametrize("weights", [None, [1, 2, 1, 2, 1, 2, 1, 2]])
def test_powers_of_any_length_are_taken_of_any_size(size, length, weights):
    points = np.array([[3, 1], [1, 2], [2, 2], [5, 1], [4, 3], [1, 1], [2, 4], [3, 2.0]])
    usual, u = Curve.from_bezier(points, weights=weights), np.array([0, 0.125, 0.75, 1])
    for beside in (size, 1):  # one coordinate of this size, beside another
        curve = Curve.from_bezier(points * [size, beside], (0, length), weights)
        np.testing.assert_allclose(curve(u * length), usual(u) * [size, beside], rtol=1e-13)


@pytest.mark.parametrize("factor", [1e-200, -1e-200, 1e200, 5e-324, 1e-30])
def test_a_common_factor_of_weights_changes_nothing(factor):
    points, t = [[1.0, 0], [1, 1], [0, 1]], np.linspace(0, 1, 9)
    arc = Curve.from_bezier(points, weights=[1, 1, 2])
    other = Curve.from_bezier(points, weights=np.array([1, 1, 2]) * factor)
    for mine, told in zip(arc.derivatives(t, 3), other.derivatives(t, 3), strict=True):
        np.testing.assert_allclose(told, mine, atol=1e-12)
    twice = arc.derivative().derivative()(t)
    np.testing.assert_allclose(other.derivative().derivative()(t), twice, atol=1e-12)


def test_a_vector_of_weight_zero_keeps_its_share_of_small_weights():
    half = Curve.from_bezier([[1, 0], [0, 1], [-1, 0]], weights=[1, 0, 1])
    small = Curve.from_bezier(np.array([[1, 0], [0, 1e-200], [-1, 0]]), weights=[1e-200, 0, 1e-200])
    t = np.linspace(0, 1, 9)
    np.testing.assert_allclose(small(t), half(t), atol=1e-15)
    np.testing.assert_allclose(np.hypot(*half(t).T), 1, atol=1e-15)


TINY = Curve.from_bezier([[[0.0], [1]], [[1], [2]]], [0, 1e-17, 1])
HIGH = Curve.from_bezier([[1e200, 0], [1, 1]])
BEYOND = {
    "maps": (lambda: HIGH.transform(1e200), "floats can hold"),
    "maps of rational curves":
        (lambda: Curve.from_bezier([[1e200], [1]], weights=[1, 2]).transform(1e200), "can hold"),
    "derivatives": (lambda: Curve.from_bezier([[1], [2]], (0, 5e-324)).derivative(), "can hold"),
    "vectors": (lambda: Curve.from_bezier([[1], [1e300]], weights=[1e-300, 0]), "can hold"),
    "knots": (lambda: Curve.from_bspline([[0], [1], [2], [3]],
                                         [-LARGEST] * 3 + [0] + [LARGEST] * 3, 2), "finite length"),
    "segments moved": (lambda: TINY.reparametrize((1, 2)), "too short"),
    "segments reversed": (lambda: TINY.reverse(), "too short"),
    "degrees lowered": (lambda: HIGH.elevate(-1), "whole number"),
    "half degrees": (lambda: HIGH.elevate(0.5), "whole number"),
    "degrees that are text": (lambda: HIGH.elevate("1"), "whole number"),
    "maps to no coordinate": (lambda: HIGH.transform(np.zeros((0, 2))), "2 columns"),
    "orders that are truths": (lambda: HIGH.derivatives(0, True), "whole number"),
    "parts from outside": (lambda: HIGH.restrict(-1, 0.5), "inside the domain"),
    "parts to NaN": (lambda: HIGH.restrict(0, np.nan), "finite number"),
}  # fmt: skip


@pytest.mark.parametrize("make, said", BEYOND.values(), ids=list(BEYOND))
def test_what_floats_cannot_hold_is_told(make, said):
    with pytest.raises((BadValue, OutsideDomain), match=said):
        make()


def test_domains_from_the_smallest_to_the_largest():
    line = Curve.from_bezier([[0.0], [1.0]], (0, 1e-310))
    for domain in [(0, 1), (0, 1e300), (-1e-310, 0), (1e308, 1.5e308)]:
        moved = line.reparametrize(domain)
        middle = domain[0] + (domain[1] - domain[0]) / 2
        assert moved(middle)[0] == pytest.approx(0.5, abs=1e-8)
        assert moved.reverse()(domain[0])[0] == 1

"""Exact vectors A01-A10 of the university course: symmetric multi-affine maps and blossoms."""

import pytest
import sympy as sp
from sympy import Rational as R
from sympy import symbols

from symbolic import Refuted, blossom, check_blossom, polar_levels, prove

t, r, s = symbols("t r s")
t1, t2, t3 = T = symbols("t1:4")
p0, p1, p2, p3 = P = symbols("p0:4")
F = (1 + 3 * t**2 - t**3, 1 + 3 * t - t**3)


def test_a01_symmetric_2_affine_map_and_its_diagonal():
    c0, c1, c2, c3 = symbols("c0:4")
    f = c0 + c1 * t1 + c2 * t2 + c3 * t1 * t2
    diagonal = c0 + (c1 + c2) * t + c3 * t**2
    verdict = check_blossom(f, diagonal, [t1, t2])
    assert isinstance(verdict, Refuted) and "Not symmetric" in verdict.diagnosis
    assert check_blossom(f.subs(c2, c1), diagonal.subs(c2, c1), [t1, t2])


@pytest.mark.parametrize(("power", "expected"), [
    (0, sp.S.One), (1, (t1 + t2 + t3) / 3), (2, (t1*t2 + t2*t3 + t1*t3) / 3), (3, t1*t2*t3),
])  # fmt: skip
def test_a02_blossom_of_monomials(power, expected):
    assert prove(blossom(t**power, degree=3)(*T), expected)


def test_a03_quadratic_triangle():
    frr, frs, fss = symbols("frr frs fss")
    levels = polar_levels([[frr], [frs], [fss]], [t, t], (r, s))
    assert prove(levels[1][0][0], ((s - t) * frr + (t - r) * frs) / (s - r))
    assert prove(levels[1][1][0], ((s - t) * frs + (t - r) * fss) / (s - r))
    whole = ((s - t)**2*frr + 2*(s - t)*(t - r)*frs + (t - r)**2*fss) / (s - r)**2  # fmt: skip
    assert prove(levels[2][0][0], whole)


def test_a04_cubic_triangle():
    value = polar_levels([[p] for p in P], [t, t, t], (r, s))[-1][0][0]
    weights = [(s - t)**3, 3*(s - t)**2*(t - r), 3*(s - t)*(t - r)**2, (t - r)**3]  # fmt: skip
    assert prove(value, sum(w * p for w, p in zip(weights, P, strict=True)) / (s - r) ** 3)


def test_a05_legs_of_the_quadratic():
    legs = polar_levels([[p] for p in P[:3]], [t])[1]
    assert prove([leg[0] for leg in legs], [(1 - t) * p0 + t * p1, (1 - t) * p1 + t * p2])
    assert isinstance(prove(legs[1][0], (t - 1) * p1 + t * p2), Refuted)  # as printed


def test_a07_worked_example():
    x, y = blossom(F)(*T)
    assert prove(x, 1 + (t1 * t2 + t2 * t3 + t1 * t3) - t1 * t2 * t3)
    assert prove(y, 1 + (t1 + t2 + t3) - t1 * t2 * t3)
    t0 = sp.Symbol("t0")
    as_printed = 1 + (t0 + t1 + t2) - t0 * t1 * t2
    assert isinstance(prove(y, as_printed), Refuted)


def test_a08_control_points_of_the_worked_example():
    assert blossom(F).control_points() == ((1, 1), (1, 2), (2, 3), (3, 3))


def test_a09_the_parabola():
    assert blossom((t, t**2)).control_points() == ((0, 0), (R(1, 2), 0), (1, 1))


def test_a10_end_tangents_over_an_interval():
    from symbolic import hodograph

    velocity = hodograph([[p] for p in P], interval=(r, s))
    assert prove(velocity[0][0], 3 * (p1 - p0) / (s - r))
    assert prove(velocity[-1][0], 3 * (p3 - p2) / (s - r))
    assert isinstance(prove(velocity[0][0], 3 * (p1 - p0)), Refuted)  # as printed

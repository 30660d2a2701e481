"""Exact vectors A05-B34 of the university course: Bezier curves; misprints are refuted."""

import pytest
import sympy as sp
from sympy import Rational as R
from sympy import symbols

from symbolic import bernstein, bezier, de_casteljau, prove, subdivide
from tests.symbolic.vectors.tables import assert_proved, assert_refuted, column

t, u = symbols("t u")
P0, P1, P2, P3 = P = symbols("P0:4")
HALF = R(1, 2)

BEZIER_TMG = [[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]]


def cubic():
    return bezier(3).curve(column(P))[0]


EQUALITIES = {
    "A05 quadratic polynomial form": (
        de_casteljau(column(P[:3]), t)[-1][0][0],
        (1 - t)**2*P0 + 2*t*(1 - t)*P1 + t**2*P2),
    "A05 its second leg": (de_casteljau(column(P[:3]), t)[1][1][0], (1 - t)*P1 + t*P2),
    "A06 cubic polynomial form": (
        cubic(), (1 - t)**3*P0 + 3*t*(1 - t)**2*P1 + 3*(1 - t)*t**2*P2 + t**3*P3),
    "A08 worked example": (
        bezier(3).curve([[1, 1], [1, 2], [2, 3], [3, 3]]), [1 + 3*t**2 - t**3, 1 + 3*t - t**3]),
    "A09 the parabola y = x^2": (bezier(2).curve([[0, 0], [HALF, 0], [1, 1]]), [t, t**2]),
    "B03 worked example": (
        de_casteljau([[0, 1, 0], [1, 1, 0], [0, 2, 0]], t)[-1][0], [2*t*(1 - t), 1 + t**2, 0]),
    "B03 its point at 1/2": (
        de_casteljau([[0, 1, 0], [1, 1, 0], [0, 2, 0]], HALF)[-1][0], [HALF, R(5, 4), 0]),
    "B05 Bernstein basis of degree 3": (
        bezier(3).functions, [(1 - t)**3, 3*t*(1 - t)**2, 3*t**2*(1 - t), t**3]),
    "B18 end tangents": (
        [sp.diff(cubic(), t).subs(t, 0), sp.diff(cubic(), t).subs(t, 1)],
        [3*(P1 - P0), 3*(P3 - P2)]),
    "B19 second derivatives at the ends": (
        [sp.diff(cubic(), t, 2).subs(t, 0), sp.diff(cubic(), t, 2).subs(t, 1)],
        [6*(P2 - 2*P1 + P0), 6*(P3 - 2*P2 + P1)]),
    "B20 hodograph": (
        sp.diff(cubic(), t), bezier(2).curve(column([3*(P1 - P0), 3*(P2 - P1), 3*(P3 - P2)]))[0]),
    "B23 left part": (
        subdivide(column(P), u)[0],
        column([P0, (1 - u)*P0 + u*P1, (1 - u)**2*P0 + 2*u*(1 - u)*P1 + u**2*P2,
                (1 - u)**3*P0 + 3*u*(1 - u)**2*P1 + 3*u**2*(1 - u)*P2 + u**3*P3])),
    "B23 right part": (
        subdivide(column(P), u)[1],
        column([(1 - u)**3*P0 + 3*u*(1 - u)**2*P1 + 3*u**2*(1 - u)*P2 + u**3*P3,
                (1 - u)**2*P1 + 2*u*(1 - u)*P2 + u**2*P3, (1 - u)*P2 + u*P3, P3])),
    "B25 Bernstein matrix, row form": (bezier(3).matrix, BEZIER_TMG),
    "B26 Bernstein matrix, column form": (bezier(3).matrix_as(layout="GMT"), BEZIER_TMG),
    "B27 blending functions": (
        bezier(3).functions,
        [-t**3 + 3*t**2 - 3*t + 1, 3*(t**3 - 2*t**2 + t), -3*t**3 + 3*t**2, t**3]),
    "B34 maximum of an inner weight": (bernstein(3)[1].subs(t, R(1, 3)), R(4, 9)),
}  # fmt: skip

MISPRINTS = {
    "A05 (t - 1) for (1 - t)": (de_casteljau(column(P[:3]), t)[1][1][0], (t - 1)*P1 + t*P2),
    "B18 the lost factor 3": (sp.diff(cubic(), t).subs(t, 1), P3 - P2),
    "B25 lost minus signs": (
        bezier(3).matrix, [[1, 3, -3, 1], [3, -6, 3, 0], [3, 3, 0, 0], [1, 0, 0, 0]]),
    "B26 a wrong second row": (
        bezier(3).matrix_as(layout="GMT"),
        [[-1, 3, -3, 1], [-3, -3, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]]),
}  # fmt: skip


@pytest.mark.parametrize("name", EQUALITIES)
def test_vector_is_proved(name):
    assert_proved(*EQUALITIES[name])


@pytest.mark.parametrize("name", MISPRINTS)
def test_misprint_is_refuted_with_a_witness(name):
    assert_refuted(*MISPRINTS[name])


@pytest.mark.parametrize("n", range(1, 7))
def test_b15_end_tangents_of_any_degree(n):
    points = symbols(f"P0:{n + 1}")
    velocity = sp.diff(bezier(n).curve(column(points))[0], t)
    assert prove(velocity.subs(t, 0), n * (points[1] - points[0]))
    assert prove(velocity.subs(t, 1), n * (points[n] - points[n - 1]))


@pytest.mark.parametrize("n", range(1, 8))
def test_b24_b33_counts_of_the_scheme(n):
    levels = de_casteljau(column(symbols(f"P0:{n + 1}")), t)
    assert [len(level) for level in levels] == list(range(n + 1, 0, -1))
    assert sum(map(len, levels[1:])) == n * (n + 1) // 2


@pytest.mark.parametrize("n", range(1, 7))
def test_b10_weight_i_is_largest_at_i_over_n(n):
    for i, weight in enumerate(bernstein(n)):
        slope = sp.Poly(sp.diff(weight, t), t)
        assert i in (0, n) or slope.eval(R(i, n)) == 0
        assert weight.subs(t, R(i, n)) == max(weight.subs(t, R(k, 4 * n)) for k in range(4 * n + 1))

"""Exact vectors of the university course, by their ids; misprinted ones are refuted as printed."""

import pytest
import sympy as sp
from sympy import Matrix, symbols
from sympy import Rational as R

from symbolic import (
    Refuted,
    basis_from,
    bernstein,
    bezier,
    de_casteljau,
    derivative,
    hermite,
    prove,
    subdivide,
    value,
)

t, u = symbols("t u")
P0, P1, P2, P3 = P = symbols("P0:4")
HALF = R(1, 2)

BEZIER_TMG = [[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]]
HERMITE_TMG = [[2, -2, 1, 1], [-3, 3, -2, -1], [0, 0, 1, 0], [1, 0, 0, 0]]
HERMITE_GMT = [[2, -3, 0, 1], [-2, 3, 0, 0], [1, -2, 1, 0], [1, -1, 0, 0]]
HERMITE_FUNCTIONS = [
    2 * t**3 - 3 * t**2 + 1,
    -2 * t**3 + 3 * t**2,
    t**3 - 2 * t**2 + t,
    t**3 - t**2,
]
MIDPOINT = [value(0), value(HALF), derivative(HALF), value(1)]


def column(points):
    return [[p] for p in points]


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
    "H02 constraint rows": (
        [condition.row(3) for condition in MIDPOINT],
        [[0, 0, 0, 1], [R(1, 8), R(1, 4), HALF, 1], [R(3, 4), 1, 1, 0], [1, 1, 1, 1]]),
    "H03 mid-point cubic matrix": (
        basis_from(MIDPOINT).matrix,
        [[-4, 0, -4, 4], [8, -4, 6, -4], [-5, 4, -2, 1], [1, 0, 0, 0]]),
    "H04 mid-point cubic functions": (
        basis_from(MIDPOINT).functions,
        [-4*t**3 + 8*t**2 - 5*t + 1, -4*t**2 + 4*t, -4*t**3 + 6*t**2 - 2*t, 4*t**3 - 4*t**2 + t]),
    "H07 Hermite constraints, column form": (
        Matrix([c.row(3) for c in (value(0), value(1), derivative(0), derivative(1))]).T,
        [[0, 1, 0, 3], [0, 1, 0, 2], [0, 1, 1, 1], [1, 1, 0, 0]]),
    "H08 Hermite matrix, column form": (hermite().matrix_as(layout="GMT"), HERMITE_GMT),
    "H09 Hermite matrix, row form": (hermite().matrix, HERMITE_TMG),
    "H11 Hermite functions": (hermite().functions, HERMITE_FUNCTIONS),
    "H12 minimum of the last function": (hermite().functions[3].subs(t, R(2, 3)), -R(4, 27)),
    "H12 the point weights sum to one": (hermite().functions[0] + hermite().functions[1], 1),
    "H13 worked example": (
        hermite().curve([[1, 2, 1], [4, 5, 4], [1, 1, 1], [6, 6, 6]]),
        [t**3 + t**2 + t + 1, t**3 + t**2 + t + 2, t**3 + t**2 + t + 1]),
    "H14 the other order of the geometry": (
        basis_from([value(0), derivative(0), derivative(1), value(1)]).functions,
        [HERMITE_FUNCTIONS[i] for i in (0, 2, 3, 1)]),
    "H16 Bezier to Hermite, row form": (
        bezier(3).to(hermite()), [[1, 0, 0, 0], [0, 0, 0, 1], [-3, 3, 0, 0], [0, 0, -3, 3]]),
    "H17 inner Bezier points from tangents": (
        hermite().to(bezier(3)), [[1, 0, 0, 0], [1, 0, R(1, 3), 0], [0, 1, 0, -R(1, 3)],
                                  [0, 1, 0, 0]]),
    "H18 Bezier to Hermite, column form": (
        bezier(3).to(hermite()).T, [[1, 0, -3, 0], [0, 0, 3, 0], [0, 0, 0, -3], [0, 1, 0, 3]]),
    "H19 product of H18 and H08": (
        bezier(3).to(hermite()).T * hermite().matrix_as(layout="GMT"), BEZIER_TMG),
}  # fmt: skip

MISPRINTS = {
    "A05 (t - 1) for (1 - t)": (de_casteljau(column(P[:3]), t)[1][1][0], (t - 1)*P1 + t*P2),
    "B18 the lost factor 3": (sp.diff(cubic(), t).subs(t, 1), P3 - P2),
    "B25 lost minus signs": (
        bezier(3).matrix, [[1, 3, -3, 1], [3, -6, 3, 0], [3, 3, 0, 0], [1, 0, 0, 0]]),
    "B26 a wrong second row": (
        bezier(3).matrix_as(layout="GMT"),
        [[-1, 3, -3, 1], [-3, -3, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]]),
    "H04 1 for u": (basis_from(MIDPOINT).functions[3], 4*t**3 - 4*t**2 + 1),
    "H08 a lost minus sign": (
        hermite().matrix_as(layout="GMT"),
        [[2, -3, 0, 1], [-2, 3, 0, 0], [1, -2, 1, 0], [1, 1, 0, 0]]),
    "H18 merged rows": (
        bezier(3).to(hermite()).T, [[1, 0, -3, 0], [0, 0, 0, 0], [0, -3, 0, 0], [0, 0, 0, 0]]),
}  # fmt: skip


@pytest.mark.parametrize("name", EQUALITIES)
def test_vector_is_proved(name):
    ours, printed = EQUALITIES[name]
    assert prove(ours, printed)


@pytest.mark.parametrize("name", MISPRINTS)
def test_misprint_is_refuted_with_a_witness(name):
    ours, printed = MISPRINTS[name]
    verdict = prove(ours, printed)
    assert isinstance(verdict, Refuted)
    assert verdict.left != verdict.right


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

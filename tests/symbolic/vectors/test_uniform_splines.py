"""Exact vectors S02-S19 of the university course: uniform B-splines, Catmull-Rom and its family."""

from itertools import pairwise

import pytest
import sympy as sp
from sympy import Rational as R
from sympy import symbols

from symbolic import (
    Proved,
    Refuted,
    bezier,
    cardinal,
    catmull_rom,
    hermite,
    identify,
    kochanek_bartels,
    prove,
    uniform_bspline,
)
from tests.symbolic.vectors.tables import assert_proved, assert_refuted, column

t, alpha, beta, gamma = symbols("t alpha beta gamma")
T, C, B = symbols("T C B")
p0, p1, p2, p3, p4 = symbols("p0:5")
SIX = R(1, 6)


def segment(basis, *points):
    return basis.curve(column(points or (p0, p1, p2, p3)))[0]


def ends(basis, order=0):
    """Return the derivative of some order at both ends of a segment."""
    curve = sp.diff(segment(basis), t, order)
    return [curve.subs(t, 0), curve.subs(t, 1)]


def bezier_points(basis):
    return list(basis.to(bezier(3)) * sp.Matrix([p0, p1, p2, p3]))


KOCHANEK_BARTELS = kochanek_bartels(T, C, B)
NOTES = kochanek_bartels(alpha, -gamma, beta)  # gamma has the opposite sign of C
NOTES_START = (1 - alpha)/2*(
    (1 + beta)*(1 - gamma)*(p1 - p0) + (1 - beta)*(1 + gamma)*(p2 - p1))  # fmt: skip
NOTES_END = (1 - alpha)/2*(
    (1 + beta)*(1 + gamma)*(p2 - p1) + (1 - beta)*(1 - gamma)*(p3 - p2))  # fmt: skip
BSPLINE = uniform_bspline()
BSPLINE_TMG = [[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 0, 3, 0], [1, 4, 1, 0]]

EQUALITIES = {
    "S02 B-spline to Bezier": (
        6*BSPLINE.to(bezier(3)), [[1, 4, 1, 0], [0, 4, 2, 0], [0, 2, 4, 0], [0, 1, 4, 1]]),
    "S03 first Bezier points": (
        bezier_points(BSPLINE),
        [(p0 + 4*p1 + p2)/6, (2*p1 + p2)/3, (p1 + 2*p2)/3, (p1 + 4*p2 + p3)/6]),
    "S03 a joint is a midpoint": (
        bezier_points(BSPLINE)[0], ((p0 + 2*p1)/3 + (2*p1 + p2)/3)/2),
    "S04 end values": (ends(BSPLINE), [(p0 + 4*p1 + p2)/6, (p1 + 4*p2 + p3)/6]),
    "S04 end tangents": (ends(BSPLINE, 1), [(p2 - p0)/2, (p3 - p1)/2]),
    "S05 B-spline to Hermite": (
        BSPLINE.to(hermite()),
        [[SIX, 4*SIX, SIX, 0], [0, SIX, 4*SIX, SIX], [-R(1, 2), 0, R(1, 2), 0],
         [0, -R(1, 2), 0, R(1, 2)]]),
    "S07 B-spline matrix": (6*BSPLINE.matrix, BSPLINE_TMG),
    "S07 as a product": (hermite().matrix*BSPLINE.to(hermite()), sp.Matrix(BSPLINE_TMG)/6),
    "S08 B-spline functions": (
        BSPLINE.functions,
        [(1 - t)**3/6, (3*t**3 - 6*t**2 + 4)/6, (-3*t**3 + 3*t**2 + 3*t + 1)/6, t**3/6]),
    "S11 double end point": (segment(BSPLINE, p0, p0, p1, p2).subs(t, 0), (5*p0 + p1)/6),
    "S11 its tangent": (
        sp.diff(segment(BSPLINE, p0, p0, p1, p2), t).subs(t, 0), (p1 - p0)/2),
    "S12 triple end point": (segment(BSPLINE, p0, p0, p0, p1), p0 + (p1 - p0)*t**3/6),
    "S13 Catmull-Rom tangents": (ends(catmull_rom(), 1), [(p2 - p0)/2, (p3 - p1)/2]),
    "S14 Catmull-Rom's Bezier points": (
        bezier_points(catmull_rom()), [p1, (p2 + 6*p1 - p0)/6, (-p3 + 6*p2 + p1)/6, p2]),
    "S15 Catmull-Rom to Bezier": (
        catmull_rom().to(bezier(3)),
        [[0, 1, 0, 0], [-SIX, 1, SIX, 0], [0, SIX, 1, -SIX], [0, 0, 1, 0]]),
    "S17 cardinal tangents": (
        ends(cardinal(alpha), 1), [(1 - alpha)*(p2 - p0)/2, (1 - alpha)*(p3 - p1)/2]),
    "S18 tangents of 1984": (
        ends(KOCHANEK_BARTELS, 1),
        [(1 - T)/2*((1 + B)*(1 + C)*(p1 - p0) + (1 - B)*(1 - C)*(p2 - p1)),
         (1 - T)/2*((1 + B)*(1 - C)*(p2 - p1) + (1 - B)*(1 + C)*(p3 - p2))]),
    "S18 tangents of the notes": (ends(NOTES, 1), [NOTES_START, NOTES_END]),
    "S19 no bias and continuity": (kochanek_bartels(alpha, 0, 0).matrix, cardinal(alpha).matrix),
    "S19 no parameters": (kochanek_bartels(0, 0, 0).matrix, catmull_rom().matrix),
}  # fmt: skip

MISPRINTS = {
    "S03 v_0 = p_0": (bezier_points(BSPLINE)[0], p0),
    "S18 the notes' gamma is not C": (
        ends(kochanek_bartels(alpha, gamma, beta), 1), [NOTES_START, NOTES_END]),
}  # fmt: skip


@pytest.mark.parametrize("name", EQUALITIES)
def test_vector_is_proved(name):
    assert_proved(*EQUALITIES[name])


@pytest.mark.parametrize("name", MISPRINTS)
def test_misprint_is_refuted_with_a_witness(name):
    assert_refuted(*MISPRINTS[name])


def jumps(basis):
    """Return by order how the derivatives of two consecutive segments differ at their joint."""
    first, second = segment(basis, p0, p1, p2, p3), segment(basis, p1, p2, p3, p4)
    return [sp.diff(second, t, r).subs(t, 0) - sp.diff(first, t, r).subs(t, 1) for r in range(4)]


def continuity(basis):
    """Return the highest order up to which all derivatives agree at every joint."""
    orders = [bool(prove(jump, 0)) for jump in jumps(basis)]
    return orders.index(False) - 1


def test_s09_partition_of_unity_positivity_and_c2_joints():
    assert prove(sum(BSPLINE.functions), 1)
    assert all(weight >= 0 for weight in BSPLINE.to(bezier(3)))
    assert continuity(BSPLINE) == 2
    assert isinstance(prove(jumps(BSPLINE)[3], 0), Refuted)


@pytest.mark.parametrize("n", range(3, 8))
def test_s10_counts_of_segments(n):
    points = range(n + 1)
    segments = [points[i : i + 4] for i in points if i + 3 <= n]
    assert len(segments) == n - 2
    assert 4 * len(segments) == 4 * (n - 3) + 3 + 1  # points v_0 ... v_{4(n - 3) + 3}
    assert all(b[:-1] == a[1:] for a, b in pairwise(segments))


def test_s16_catmull_rom_is_c1_not_c2_and_leaves_the_hull():
    assert continuity(catmull_rom()) == 1
    assert catmull_rom().functions[0].subs(t, R(1, 2)) < 0


def test_s19_kochanek_bartels_is_c1_just_if_continuity_is_zero_or_tension_one():
    assert continuity(KOCHANEK_BARTELS) == 0
    assert continuity(kochanek_bartels(T, 0, B)) == 1
    assert continuity(kochanek_bartels(1, C, B)) >= 1
    # The tangents differ by (1 - T) C ((1 + B)(p2 - p1) - (1 - B)(p3 - p2)) at the joint p2, and
    # 1 + B and 1 - B are not both zero: nothing else makes them agree for all points.
    difference = (1 - T) * C * ((1 + B) * (p2 - p1) - (1 - B) * (p3 - p2))
    assert isinstance(prove(jumps(KOCHANEK_BARTELS)[1], difference), Proved)


@pytest.mark.parametrize(("matrix", "basis"), [
    (sp.Matrix(BSPLINE_TMG) / 6, BSPLINE),
    (cardinal(0).matrix, catmull_rom()),
])  # fmt: skip
def test_s07_s15_the_matrix_is_recognised(matrix, basis):
    assert identify(matrix)[0].basis is basis

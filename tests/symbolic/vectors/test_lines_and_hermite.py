"""Exact vectors L01-L05 and H01-H21 of the university course: lines, constraints, Hermite."""

import pytest
import sympy as sp
from sympy import Matrix, symbols
from sympy import Rational as R

from symbolic import basis_from, bezier, derivative, hermite, identify, lagrange, prove, value
from tests.symbolic.vectors.tables import assert_proved, assert_refuted

t, u, v, a, b, t1, t2, x, y = symbols("t u v a b t1 t2 x y")
c0, c1, c2, c3 = C = symbols("c0:4")
P0, P1, P2, P3 = symbols("P0:4")
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
OTHER_ORDER = ("P0", "T0", "T1", "P1")


def line(nodes):
    return lagrange(nodes).curve([[P0], [P1]])[0]


def functions(basis, geometry):
    """Return the blending functions in the order of another book."""
    return list(Matrix([basis.powers]) * basis.matrix_as(geometry=geometry))


EQUALITIES = {
    "L01 a line over [0, 1]": (line([0, 1]), P0 + (P1 - P0)*t),
    "L02 a line over [-1, 1]": (line([-1, 1]), (P1 + P0)/2 + (P1 - P0)*t/2),
    "L03 from [a, b] to [0, 1]": (lagrange([a, b]).curve([[0], [1]])[0], (t - a)/(b - a)),
    "L03 and back": (lagrange([0, 1]).curve([[a], [b]])[0], (b - a)*t + a),
    "L03 there and back": (((b - a)*v + a - a)/(b - a), v),
    "L04 an affine map": (c0 + c1*(a*x + (1 - a)*y), a*(c0 + c1*x) + (1 - a)*(c0 + c1*y)),
    "L05 weights over [t1, t2]": (
        lagrange([t1, t2]).functions, [(t2 - t)/(t2 - t1), (t - t1)/(t2 - t1)]),
    "L05 their sum": (sum(lagrange([t1, t2]).functions), 1),
    "L05 every affine function": (
        lagrange([t1, t2]).curve([[c0 + c1*t1], [c0 + c1*t2]])[0], c0 + c1*t),
    "H01 a cubic's derivative": (
        sp.Derivative(c3*t**3 + c2*t**2 + c1*t + c0, t), 3*c3*t**2 + 2*c2*t + c1),
    "H01 the derivative of T": (
        Matrix([derivative(u).row(3)]).T, [[3*u**2], [2*u], [1], [0]]),
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
    "H12 values at both ends": (
        [[f.subs(t, at) for f in hermite().functions] for at in (0, 1)],
        [[1, 0, 0, 0], [0, 1, 0, 0]]),
    "H12 where the last function is smallest": (
        sp.diff(hermite().functions[3], t), t*(3*t - 2)),
    "H12 minimum of the last function": (hermite().functions[3].subs(t, R(2, 3)), -R(4, 27)),
    "H12 the point weights sum to one": (hermite().functions[0] + hermite().functions[1], 1),
    "H13 worked example": (
        hermite().curve([[1, 2, 1], [4, 5, 4], [1, 1, 1], [6, 6, 6]]),
        [t**3 + t**2 + t + 1, t**3 + t**2 + t + 2, t**3 + t**2 + t + 1]),
    "H14 by its constraints": (
        basis_from([value(0), derivative(0), derivative(1), value(1)]).functions,
        [HERMITE_FUNCTIONS[i] for i in (0, 2, 3, 1)]),
    "H14 the other order of the geometry": (
        functions(hermite(), OTHER_ORDER), [HERMITE_FUNCTIONS[i] for i in (0, 2, 3, 1)]),
    "H15 slide 454": (functions(hermite(), ("P0", "P1", "T0", "T1")), HERMITE_FUNCTIONS),
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
    "L01 a lost minus sign": (line([0, 1]), P0 + P1*P0*t),
    "H15 both orders under one name": (functions(hermite(), OTHER_ORDER), HERMITE_FUNCTIONS),
    "H04 1 for u": (basis_from(MIDPOINT).functions[3], 4*t**3 - 4*t**2 + 1),
    "H08 a lost minus sign": (
        hermite().matrix_as(layout="GMT"),
        [[2, -3, 0, 1], [-2, 3, 0, 0], [1, -2, 1, 0], [1, 1, 0, 0]]),
    "H18 merged rows": (
        bezier(3).to(hermite()).T, [[1, 0, -3, 0], [0, 0, 0, 0], [0, -3, 0, 0], [0, 0, 0, 0]]),
}  # fmt: skip


@pytest.mark.parametrize("name", EQUALITIES)
def test_vector_is_proved(name):
    assert_proved(*EQUALITIES[name])


@pytest.mark.parametrize("name", MISPRINTS)
def test_misprint_is_refuted_with_a_witness(name):
    assert_refuted(*MISPRINTS[name])


@pytest.mark.parametrize("n", [1, 2, 3])
def test_h06_lagrange_functions_over_symbolic_nodes(n):
    nodes = symbols(f"u0:{n + 1}")
    basis = lagrange(nodes)
    for i, function in enumerate(basis.functions):
        product = sp.Mul(*((t - w)/(nodes[i] - w) for w in nodes if w != nodes[i]))  # fmt: skip
        assert prove(function, product)
        assert prove([function.subs(t, w) for w in nodes], [int(i == j) for j in range(n + 1)])
    assert prove(sum(basis.functions), 1)
    assert basis.derivation.is_proved


@pytest.mark.parametrize("matrix", [HERMITE_TMG, HERMITE_GMT])
def test_h08_h09_the_convention_is_recognised(matrix):
    (found,) = identify(matrix)
    assert found.basis is hermite()
    assert found.layout == ("TMG" if matrix is HERMITE_TMG else "GMT")
    assert found.geometry == ("P0", "P1", "T0", "T1")


def test_h03_a_matrix_is_recognised_by_its_constraints():
    matrix = [[-4, 0, -4, 4], [8, -4, 6, -4], [-5, 4, -2, 1], [1, 0, 0, 0]]
    (found,) = identify(matrix)
    assert "c(0), c(1/2), c'(1/2), c(1)" in found.basis.name


@pytest.mark.parametrize("n", [1, 3, 5, 7])
def test_h14_the_general_order_of_the_geometry(n):
    """v_0^0, v_0^1, ..., v_0^k, v_1^k, ..., v_1^0 with k = (n - 1)/2: function j is dual to it."""
    names = [entry.name for entry in hermite(n).geometry]
    order = names[::2] + names[1::2][::-1]
    for j, function in enumerate(functions(hermite(n), order)):
        k = (n + 1) // 2
        conditions = [(0, r) for r in range(k)] + [(1, r) for r in reversed(range(k))]
        values = [sp.diff(function, t, r).subs(t, at) for at, r in conditions]
        assert values == [int(i == j) for i in range(n + 1)]


@pytest.mark.parametrize("n", range(6))
def test_h20_coefficients_of_a_bivariate_polynomial(n):
    monomials = [(i, j) for i in range(n + 1) for j in range(n + 1) if i + j <= n]
    assert len(monomials) == R((n + 1) * (n + 2), 2)
    assert n != 3 or len(monomials) == 10


@pytest.mark.parametrize(("n", "planar"), [(2, True), (3, False)])
def test_h21_a_cubic_is_the_lowest_degree_that_leaves_its_plane(n, planar):
    points = [symbols(f"x{i} y{i} z{i}") for i in range(n + 1)]
    curve = Matrix(bezier(n).curve(points))
    torsion = Matrix.hstack(*(sp.diff(curve, t, r) for r in (1, 2, 3))).det()
    assert bool(prove(torsion, 0)) is planar

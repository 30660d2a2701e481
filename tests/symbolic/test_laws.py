"""Laws that hold for every family and degree; a new family joins by its line in the index."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational as R

from symbolic import FAMILIES, basis_from, bezier, de_casteljau, hermite, prove, subdivide, value

DEGREES = {"Bezier": (1, 2, 3, 4, 7, 12), "Hermite": (1, 3, 5, 7, 11)}
BASES = [FAMILIES[name](n) for name in FAMILIES for n in DEGREES[name]]
t = sp.Symbol("t")

rationals = st.fractions(min_value=-5, max_value=5, max_denominator=16)
every_basis = pytest.mark.parametrize("basis", BASES, ids=lambda basis: basis.name)


def geometry_of(basis, dim=2):
    names = [str(entry) for entry in basis.geometry]
    return [[sp.Symbol(f"{name}_{axis}") for axis in "xyz"[:dim]] for name in names]


@every_basis
def test_every_step_of_the_derivation_is_proved(basis):
    assert basis.derivation.steps
    assert basis.derivation.is_proved


@every_basis
def test_point_functions_sum_to_one(basis):
    points = [f for f, g in zip(basis.functions, basis.geometry, strict=True) if g.kind == "point"]
    assert prove(sum(points), 1)


@every_basis
def test_affine_invariance(basis):
    """Points move by A x + d and vectors by A x; the whole curve moves by A x + d."""
    a, b, c, d, e, f = sp.symbols("a b c d e f")
    rows = geometry_of(basis)
    moved = []
    for (x, y), entry in zip(rows, basis.geometry, strict=True):
        shift = int(entry.kind == "point")
        moved.append([a * x + b * y + shift * e, c * x + d * y + shift * f])
    x, y = basis.curve(rows)
    assert prove(basis.curve(moved), [a * x + b * y + e, c * x + d * y + f])


@every_basis
def test_end_points_are_the_first_and_last_point(basis):
    rows = geometry_of(basis)
    points = [row for row, g in zip(rows, basis.geometry, strict=True) if g.kind == "point"]
    curve = sp.Matrix(basis.curve(rows))
    assert prove(curve.subs(t, 0), sp.Matrix(points[0]))
    assert prove(curve.subs(t, 1), sp.Matrix(points[-1]))


@every_basis
def test_every_printed_convention_gives_the_same_curve(basis):
    rows = sp.Matrix(geometry_of(basis))
    powers = sp.Matrix(basis.powers)
    for order, column in (("descending", powers), ("ascending", powers[::-1, :])):
        row_form = column.T * basis.matrix_as(order, "TMG") * rows
        column_form = rows.T * basis.matrix_as(order, "GMT") * column
        assert prove(list(row_form), basis.curve(rows))
        assert prove(list(column_form), basis.curve(rows))


@pytest.mark.parametrize("n", (1, 3, 5, 7))
def test_conversion_there_and_back_is_the_identity(n):
    there, back = hermite(n).to(bezier(n)), bezier(n).to(hermite(n))
    assert there * back == sp.eye(n + 1)
    rows = sp.Matrix(geometry_of(hermite(n)))
    assert prove(bezier(n).curve(there * rows), hermite(n).curve(rows))


@pytest.mark.parametrize("n", (1, 3, 5, 7, 11))
def test_hermite_interpolates_every_derivative(n):
    functions = hermite(n).functions
    for j, f in enumerate(functions):
        for i in range(n + 1):
            order, at = divmod(i, 2)
            assert sp.diff(f, t, order).subs(t, at) == int(i == j)


@pytest.mark.parametrize("n", (1, 2, 3, 5, 9))
def test_de_casteljau_is_the_bernstein_form(n):
    rows = geometry_of(bezier(n))
    assert prove(de_casteljau(rows, t)[-1][0], bezier(n).curve(rows))


@pytest.mark.parametrize("n", (1, 2, 3, 4, 6))
def test_the_parts_of_a_subdivided_curve_run_along_it(n):
    rows, u = geometry_of(bezier(n)), sp.Symbol("u")
    whole = sp.Matrix(bezier(n).curve(rows))
    left, right = subdivide(rows, u)
    assert prove(bezier(n).curve(left), list(whole.subs(t, u * t)))
    assert prove(bezier(n).curve(right), list(whole.subs(t, u + (1 - u) * t)))


@pytest.mark.parametrize("n", (1, 2, 3, 5))
def test_symmetry_and_linear_precision(n):
    rows = geometry_of(bezier(n))
    assert prove(bezier(n).curve(rows[::-1]), list(sp.Matrix(bezier(n).curve(rows)).subs(t, 1 - t)))
    assert prove(bezier(n).curve([[R(i, n)] for i in range(n + 1)]), [t])


@given(st.lists(st.tuples(rationals, rationals), min_size=2, max_size=7), rationals)
def test_exact_points_give_exact_points(points, at):
    point = de_casteljau(points, at)[-1][0]
    assert all(coordinate.is_Rational for coordinate in point)
    curve = bezier(len(points) - 1).curve(points)
    assert [c.subs(t, R(at.numerator, at.denominator)) for c in curve] == list(point)


@given(st.lists(rationals, min_size=1, max_size=6, unique=True), st.data())
def test_values_at_distinct_parameters_are_interpolated(nodes, data):
    """Lagrange's problem, solved by constraints: the curve takes every value asked for."""
    basis = basis_from([value(node) for node in nodes])
    asked = data.draw(st.lists(rationals, min_size=len(nodes), max_size=len(nodes)))
    curve = basis.curve([[v] for v in asked])[0]
    exact = [R(v.numerator, v.denominator) for v in asked]
    assert [curve.subs(t, R(n.numerator, n.denominator)) for n in nodes] == exact


def test_symbolic_parameters_stay_symbolic():
    """A cardinal-like basis: tension is a parameter, not an entry of the geometry."""
    from symbolic import derivative

    p0, p1, p2, p3, c = sp.symbols("P0:4 c")
    basis = basis_from(
        [(value(0), p1), (value(1), p2), (derivative(0), (1 - c) * (p2 - p0) / 2),
         (derivative(1), (1 - c) * (p3 - p1) / 2)], geometry=(p0, p1, p2, p3),
    )  # fmt: skip
    assert [str(entry) for entry in basis.geometry] == ["P0", "P1", "P2", "P3"]
    catmull_rom = sp.Matrix([[-1, 3, -3, 1], [2, -5, 4, -1], [-1, 0, 1, 0], [0, 2, 0, 0]]) / 2
    assert basis.matrix.subs(c, 0) == catmull_rom
    assert basis.derivation.is_proved

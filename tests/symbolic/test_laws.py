"""Laws that hold for every family that owes them; a new family joins in `families.py`."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational as R

from symbolic import (
    FAMILIES,
    basis_from,
    bezier,
    de_casteljau,
    hermite,
    identify,
    prove,
    subdivide,
    value,
)
from tests.symbolic.families import OWED, owing

t = sp.Symbol("t")
rationals = st.fractions(min_value=-5, max_value=5, max_denominator=16)


def for_all_that_owe(law):
    pairs = owing(law)
    return pytest.mark.parametrize(
        ("family", "basis"), pairs, ids=[basis.name for _, basis in pairs]
    )


def geometry_of(basis, dim=2):
    names = [str(entry) for entry in basis.geometry]
    return [[sp.Symbol(f"{name}_{axis}") for axis in "xyz"[:dim]] for name in names]


def at(curve, parameter):
    return [c.subs(t, parameter) for c in curve]


def test_every_family_says_what_it_owes():
    assert OWED.keys() == FAMILIES.keys()
    known = set().union(*(family.laws for family in OWED.values()))
    assert all(owing(law) for law in known)
    for family in OWED.values():
        assert ("ends" in family.laws) == (family.ends is not None)
        assert ("symmetry" in family.laws) == (family.reversed is not None)


@for_all_that_owe("derivation")
def test_every_step_of_the_derivation_is_proved(family, basis):
    assert basis.derivation.steps
    assert basis.derivation.is_proved


@for_all_that_owe("partition of unity")
def test_point_functions_sum_to_one(family, basis):
    points = [f for f, g in zip(basis.functions, basis.geometry, strict=True) if g.kind == "point"]
    assert prove(sum(points), 1)


@for_all_that_owe("affine invariance")
def test_affine_invariance(family, basis):
    """Points move by A x + d and vectors by A x; the whole curve moves by A x + d."""
    a, b, c, d, e, f = 2, -1, 3, R(1, 2), sp.Symbol("e"), sp.Symbol("f")
    rows = geometry_of(basis)
    moved = []
    for (x, y), entry in zip(rows, basis.geometry, strict=True):
        shift = int(entry.kind == "point")
        moved.append([a * x + b * y + shift * e, c * x + d * y + shift * f])
    x, y = basis.curve(rows)
    assert prove(basis.curve(moved), [a * x + b * y + e, c * x + d * y + f])


@for_all_that_owe("ends")
def test_the_curve_starts_and_ends_at_points_of_its_geometry(family, basis):
    rows = geometry_of(basis)
    names = [entry.name for entry in basis.geometry]
    curve = basis.curve(rows)
    for parameter, name in enumerate(family.ends(basis)):
        assert prove(at(curve, parameter), rows[names.index(name)])


@for_all_that_owe("symmetry")
def test_the_reversed_geometry_gives_the_same_curve_backwards(family, basis):
    rows = geometry_of(basis)
    assert prove(basis.curve(family.reversed(rows)), at(basis.curve(rows), 1 - t))


@for_all_that_owe("positivity")
def test_no_weight_is_negative_between_the_ends(family, basis):
    """A polynomial with coefficients >= 0 in the Bernstein basis is >= 0 on [0, 1]."""
    assert all(entry >= 0 for entry in basis.to(bezier(basis.degree)))


@for_all_that_owe("round trip")
def test_conversion_to_bezier_and_back_is_the_identity(family, basis):
    other = bezier(basis.degree)
    there, back = basis.to(other), other.to(basis)
    assert prove(there * back, sp.eye(basis.degree + 1))
    rows = sp.Matrix(geometry_of(basis))
    assert prove(other.curve(there * rows), basis.curve(rows))


@for_all_that_owe("conventions")
def test_every_printed_convention_gives_the_same_curve(family, basis):
    rows = sp.Matrix(geometry_of(basis))
    powers = sp.Matrix(basis.powers)
    names = [entry.name for entry in basis.geometry][::-1]
    other = rows[::-1, :]
    for order, column in (("descending", powers), ("ascending", powers[::-1, :])):
        row_form = column.T * basis.matrix_as(order, "TMG") * rows
        column_form = other.T * basis.matrix_as(order, "GMT", names) * column
        assert prove(list(row_form), basis.curve(rows))
        assert prove(list(column_form), basis.curve(rows))


@for_all_that_owe("identify")
def test_the_matrix_tells_its_basis_in_every_convention(family, basis):
    for powers, layout in (("descending", "TMG"), ("ascending", "GMT")):
        matrix = basis.matrix_as(powers, layout)
        found = identify(matrix)
        assert all(prove(candidate.matrix, matrix) for candidate in found)
        assert any(
            (candidate.powers, candidate.layout) == (powers, layout)
            and candidate.geometry == tuple(entry.name for entry in basis.geometry)
            for candidate in found
        )


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
def test_linear_precision(n):
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

"""A matrix tells its basis, its parameters and its convention; no candidate is ever wrong."""

from itertools import permutations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational as R
from sympy import sqrt

from symbolic import (
    basis_from,
    bezier,
    cardinal,
    catmull_rom,
    derivative,
    hermite,
    identify,
    kochanek_bartels,
    lagrange,
    monomial,
    prove,
    uniform_bspline,
    value,
)

a, b = sp.symbols("a b")
rationals = st.fractions(min_value=-3, max_value=3, max_denominator=8)
gaps = st.fractions(min_value=R(1, 8), max_value=3, max_denominator=8)
conventions = st.tuples(
    st.sampled_from(("descending", "ascending")),
    st.sampled_from(("TMG", "GMT")),
    st.permutations(range(4)),
)


drawn_bases = st.one_of(
    st.sampled_from([bezier(3), hermite(), uniform_bspline(), monomial(3), catmull_rom()]),
    rationals.map(cardinal),
    st.tuples(rationals, rationals, rationals).map(lambda drawn: kochanek_bartels(*drawn)),
    st.tuples(gaps, gaps).map(lambda ad: catmull_rom([-ad[0], 0, 1, 1 + ad[1]])),
    st.lists(rationals, min_size=4, max_size=4, unique=True).map(lagrange),
)


@settings(max_examples=40, deadline=None)
@given(drawn_bases, conventions)
def test_a_matrix_tells_its_basis_whatever_the_convention(basis, convention):
    powers, layout, places = convention
    order = [basis.geometry[i].name for i in places]
    matrix = basis.matrix_as(powers, layout, order)
    found = identify(matrix)
    assert found
    assert all(candidate.matrix == matrix for candidate in found)
    assert any(
        candidate.basis.matrix_as(geometry=candidate.geometry) == basis.matrix_as(geometry=order)
        for candidate in found
        if (candidate.powers, candidate.layout) == (powers, layout)
    )


@pytest.mark.parametrize("order", list(permutations(range(4)))[::5])
def test_every_order_of_hermites_geometry_is_named(order):
    names = tuple(("P0", "P1", "T0", "T1")[i] for i in order)
    found = identify(hermite().matrix_as(geometry=names))
    assert [(c.basis, c.geometry) for c in found] == [(hermite(), names)]


def test_the_most_specific_candidate_comes_first():
    names = [candidate.basis.name for candidate in identify(catmull_rom().matrix)]
    assert names == [
        "uniform Catmull-Rom basis",
        "cardinal basis with tension 0",
        "Kochanek-Bartels basis with tension 0, continuity 0 and bias 0",
    ]


def test_a_symmetric_matrix_belongs_to_both_layouts():
    assert [candidate.layout for candidate in identify(bezier(4).matrix)] == ["TMG", "GMT"]


@pytest.mark.parametrize("basis", [
    kochanek_bartels(*sp.symbols("T C B")), cardinal(sqrt(2)), lagrange([0, a, b]),
    catmull_rom([0, sqrt(5), 4, 6]), catmull_rom([-a, 0, 1, 1 + b]), cardinal(1),
    basis_from([value(0), derivative(a), derivative(0, 2), value(1)]),
    basis_from([value(R(1, 2)), derivative(R(1, 2)), derivative(R(1, 2), 2)]),
], ids=lambda basis: basis.name)  # fmt: skip
def test_parameters_are_solved_for_exactly(basis):
    for matrix in (basis.matrix, basis.matrix_as("ascending", "GMT")):
        found = identify(matrix)
        assert found
        assert all(prove(candidate.matrix, matrix) for candidate in found)


@pytest.mark.parametrize("matrix", [
    sp.zeros(4), sp.Matrix(4, 4, range(16)), sp.Matrix(2, 3, range(6)), [[7]],
    bezier(3).matrix + sp.eye(4), sp.Matrix(4, 4, sp.symbols("m:16")), [[a, 1], [1, 2]],
    cardinal(a).matrix.subs(a, sp.Symbol("P0")),
])  # fmt: skip
def test_an_unknown_matrix_has_no_candidates(matrix):
    assert identify(matrix) == []


@settings(max_examples=25, deadline=None)
@given(st.lists(st.integers(-2, 2), min_size=9, max_size=9))
def test_no_candidate_is_ever_wrong(entries):
    matrix = sp.ImmutableMatrix(3, 3, entries)
    assert all(candidate.matrix == matrix for candidate in identify(matrix))


@pytest.mark.parametrize(("matrix", "factor"), [
    (6 * uniform_bspline().matrix, 6), (2 * catmull_rom().matrix_as(layout="GMT"), 2),
    (3 * hermite().matrix, 3), (sp.Symbol("k") * bezier(2).matrix, sp.Symbol("k")),
    (2 * sp.eye(3), 2),
])  # fmt: skip
def test_a_factor_left_in_front_of_the_matrix_is_told(matrix, factor):
    found = identify(matrix)
    assert found and all(each.matrix == sp.ImmutableMatrix(matrix) for each in found)
    assert found[0].factor == factor and f"c(t) = {1 / sp.S(factor)} " in str(found[0])

"""Bad input gets one sentence: what was expected, what came, how to mend it."""

import pickle

import numpy as np
import pytest
import sympy as sp

from symbolic import (
    BadType,
    BadValue,
    NotExact,
    UnsolvableConstraints,
    basis_from,
    bernstein,
    bezier,
    de_casteljau,
    derivative,
    hermite,
    kochanek_bartels,
    lagrange,
    subdivide,
    value,
)
from symbolic.exact import exact

P0, P1 = sp.symbols("P0 P1")

POINTS = {
    "ragged": ([[0, 0], [1]], BadValue, "1 and 2 coordinates"),
    "empty": ([], BadValue, "none"),
    "an empty row": ([[]], BadValue, "none"),
    "one-dimensional": ([0, 1, 2], BadValue, "bare coordinate 0"),
    "NaN": ([[float("nan"), 0]], BadValue, "nan"),
    "infinity": ([[sp.oo, 0]], BadValue, "oo"),
    "a float": ([[0.1, 0]], NotExact, r"Rational\(1, 10\)"),
    "a NumPy float": (np.array([[0.25, 0]]), NotExact, r"Rational\(1, 4\)"),
    "text": ([["1", "2"]], BadType, "never parsed"),
    "text for all points": ("ab", BadType, "rows"),
    "a number": (3, BadType, "rows"),
    "booleans": ([[True, False]], BadType, "True"),
}


@pytest.mark.parametrize("name", POINTS)
@pytest.mark.parametrize("function", [de_casteljau, subdivide])
def test_bad_points(name, function):
    points, error, said = POINTS[name]
    with pytest.raises(error, match=said) as caught:
        function(points, sp.Symbol("t"))
    assert str(caught.value).startswith("Expected ")


@pytest.mark.parametrize("n", [0, -1, 2.5, "3", True, None])
def test_bad_degrees(n):
    with pytest.raises(BadValue, match="degree 1, 2, 3"):
        bezier(n)


@pytest.mark.parametrize("n", [0, -3, 2, 4, 3.0, "3"])
def test_bad_hermite_degrees(n):
    with pytest.raises(BadValue, match="odd degree"):
        hermite(n)


CONSTRAINTS = {
    "a repeated value": (
        [value(0), value(0), value(1)], UnsolvableConstraints,
        r"c\(0\) = P0 and c\(0\) = P1, which can hold together only if -P0 \+ P1 = 0"),
    "the same demand twice": (
        [(value(0), P0), (value(0), P0)], UnsolvableConstraints, "which say the same"),
    "no position anywhere": (
        [derivative(0), derivative(1)], UnsolvableConstraints, r"c'\(0\) = T0 and c'\(1\) = T1"),
    "a derivative that is always zero": (
        [value(0), derivative(0, order=3)], UnsolvableConstraints, r"c'''\(0\) = J0, though"),
    "a dependent triple": (
        [value(-1), value(1), derivative(0)], UnsolvableConstraints,
        r"c\(-1\) = P0 and c\(1\) = P1 and c'\(0\) = T0"),
    "none": ([], BadValue, "at least one constraint"),
    "a number": ([3], BadType, "value\\(at\\)"),
    "a square": ([(value(0), P0**2), value(1)], BadValue, "linear combination"),
    "a constant": ([(value(0), P0 + 1), value(1)], BadValue, "linear combination"),
}  # fmt: skip


@pytest.mark.parametrize("name", CONSTRAINTS)
def test_bad_constraints_are_named(name):
    constraints, error, said = CONSTRAINTS[name]
    with pytest.raises(error, match=said):
        basis_from(constraints)


@pytest.mark.parametrize("order", [0, -1, 1.5, "1", True])
def test_bad_orders_of_derivatives(order):
    with pytest.raises(BadValue, match="order 1, 2, 3"):
        derivative(0, order=order)


def test_a_float_parameter_is_refused_with_the_fraction_that_was_meant():
    with pytest.raises(NotExact, match=r"Rational\(1, 10\)"):
        value(0.1)


def test_a_basis_wants_one_row_for_every_entry():
    with pytest.raises(BadValue, match="4 rows .P0, P1, T0, T1., received 3"):
        hermite().curve([[0, 0], [1, 1], [2, 2]])


def test_conversion_between_degrees_is_refused():
    with pytest.raises(BadValue, match="degree 3"):
        bezier(3).to(hermite(5))


def test_conventions_are_checked_by_name():
    with pytest.raises(BadValue, match="'descending' or 'ascending'"):
        bezier(2).matrix_as(powers="up")
    with pytest.raises(BadValue, match="'TMG' or 'GMT'"):
        bezier(2).matrix_as(layout="GTM")


T = sp.Symbol("t")


@pytest.mark.parametrize(("constraints", "geometry"), [
    ([(value(0), P0), (value(1), P1)], (P0, P0)),
    ([(value(0), P0), (value(1), P1)], ()),
    ([(value(0), P0), (value(1), P1)], P0),
    ([(value(0), P0), (value(1), P1)], (P0, P1, sp.Symbol("P2"))),
    ([(value(0), 0)], None),
    ([(value(0), T), (value(1), P1)], None),
    (5, None),
])  # fmt: skip
def test_bad_geometry(constraints, geometry):
    with pytest.raises((BadType, BadValue), match="Expected"):
        basis_from(constraints, geometry)


@pytest.mark.parametrize("at", [T, sp.sin(1), sp.pi, "0", None])
def test_parameters_of_which_zero_cannot_be_told(at):
    with pytest.raises((BadType, BadValue), match="Expected"):
        value(at)


def test_the_same_parameter_under_two_assumptions_is_one():
    with pytest.raises(UnsolvableConstraints):
        basis_from([value(sp.Symbol("a")), value(sp.Symbol("a", positive=True))])


@pytest.mark.parametrize("three", [3, np.int64(3), sp.Integer(3)])
def test_any_integer_is_a_degree(three):
    assert bezier(three) is bezier(3)
    assert hermite(three) is hermite(3)


@pytest.mark.parametrize("n", [[3], {}, 1.0, "2"])
def test_unhashable_and_odd_degrees(n):
    for family in (bezier, hermite, bernstein):
        with pytest.raises(BadValue, match="degree"):
            family(n)


@pytest.mark.parametrize("basis", [
    bezier(3), hermite(5), lagrange([0, 1, sp.Symbol("a")]), kochanek_bartels(*sp.symbols("T C B")),
], ids=lambda basis: basis.name)  # fmt: skip
def test_bases_survive_pickling(basis):
    again = pickle.loads(pickle.dumps(basis))
    assert again.matrix == basis.matrix
    assert again.derivation.is_proved


@pytest.mark.parametrize(("value", "hint"), [
    (1 / 3, r"Rational\(1, 3\)"), (0.1, r"Rational\(1, 10\)"), (2.0, "Write 2"),
    (0.123456789, r"Rational\(123456789, 1000000000\)"),
])  # fmt: skip
def test_the_fraction_that_was_meant_is_told(value, hint):
    with pytest.raises(NotExact, match=hint):
        exact(value)

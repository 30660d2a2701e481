"""Bad input for bases is told in one sentence: what was expected, what came, the remedy."""

import numpy as np
import pytest
import sympy as sp
from sympy import sqrt

from symbolic import (
    BadType,
    BadValue,
    Condition,
    NotExact,
    UnsolvableConstraints,
    basis_from,
    bezier,
    cardinal,
    catmull_rom,
    chord_knots,
    hermite,
    identify,
    kochanek_bartels,
    lagrange,
    monomial,
    uniform_bspline,
    value,
)

t, a = sp.symbols("t a")
P0, P1, *_ = P = sp.symbols("P0:4")

POINTS = [[0, 0], [3, 4], [3, 5], [4, 6]]
HIGH_ROOTS = [sqrt(p) for p in (2, 3, 5, 7, 11)]
BAD = {
    "one node": (lambda: lagrange([0]), BadValue, "at least two nodes"),
    "equal nodes": (lambda: lagrange([0, 1, 0]), BadValue, "0 as u_0 and u_2"),
    "nodes equal but not written so": (
        lambda: lagrange([(1 + sqrt(2)) ** 2, 3 + 2 * sqrt(2)]), BadValue, "different nodes"),
    "one symbol under two assumptions": (
        lambda: lagrange([a, sp.Symbol("a", positive=True)]), BadValue, "a as u_0 and u_1"),
    "t as a node": (lambda: lagrange([0, t]), BadValue, "other symbols than t"),
    "a point as a node": (lambda: lagrange([0, P1]), BadValue, "other names"),
    "an imaginary node": (lambda: lagrange([0, sp.I]), BadValue, "numbers, roots"),
    "pi as a node": (lambda: lagrange([0, sp.pi]), BadValue, "numbers, roots"),
    "roots of a high degree": (lambda: lagrange(HIGH_ROOTS), BadValue, "degree at most 8"),
    "a float node": (lambda: lagrange([0, 0.5]), NotExact, r"Rational\(1, 2\)"),
    "text as nodes": (lambda: lagrange("01"), BadType, "list of nodes"),
    "three knots": (lambda: catmull_rom([0, 1, 2]), BadValue, "four knots"),
    "decreasing knots": (lambda: catmull_rom([0, 1, 3, 2]), BadValue, "3 and then 2"),
    "a double knot": (lambda: catmull_rom([0, 1, 1, 2]), BadValue, "increasing knots"),
    "a double symbolic knot": (lambda: catmull_rom([0, a, a, 2]), BadValue, "a and then a"),
    "knots that turn back behind a symbol": (
        lambda: catmull_rom([a, 2, a, 3]), BadValue, "a and then a"),
    "knots that decrease behind a symbol": (
        lambda: catmull_rom([0, a, -1, 3]), BadValue, "0 and then -1"),
    "a node divided by zero": (
        lambda: lagrange([1, 1 / sp.Add(a, -a, evaluate=False)]), BadValue, "division by zero"),
    "a function as a node": (lambda: value(2**a), BadValue, "numbers, roots"),
    "knots equal but not written so": (
        lambda: catmull_rom([0, (1 + sqrt(2)) ** 2, 3 + 2 * sqrt(2), 9]), BadValue, "increasing"),
    "float knots": (lambda: catmull_rom([0, 1.5, 2, 3]), NotExact, r"Rational\(3, 2\)"),
    "points as knots": (lambda: catmull_rom(P), BadValue, "other names"),
    "a number as knots": (lambda: catmull_rom(3), BadType, "four knots"),
    "coincident points": (
        lambda: chord_knots([[0, 0], [0, 0], [1, 1]], 1), BadValue, "P0 = P1.*alpha = 0"),
    "alpha 2": (lambda: chord_knots(POINTS, 2), BadValue, "between 0 and 1"),
    "a float alpha": (lambda: chord_knots(POINTS, 0.5), NotExact, r"Rational\(1, 2\)"),
    "symbolic distances": (
        lambda: chord_knots([[0, 0], [a, 1]], 1), BadValue, r"root of a\*\*2 \+ 1"),
    "t as tension": (lambda: cardinal(t), BadValue, "other names than t"),
    "a point as bias": (lambda: kochanek_bartels(0, 0, P1), BadValue, "P1"),
    "a float tension": (lambda: cardinal(0.5), NotExact, r"Rational\(1, 2\)"),
    "an imaginary tension": (lambda: cardinal(sp.I), BadValue, "numbers, roots"),
    "a tension divided by zero": (
        lambda: cardinal(1 / sp.Add(a, -a, evaluate=False)), BadValue, "division by zero"),
    "imaginary points": (
        lambda: chord_knots([[0, 0], [1, sp.I]], 1), BadValue, "real coordinates"),
    "a matrix without entries": (lambda: identify([[], []]), BadType, "a matrix"),
    "an array as the order of powers": (
        lambda: bezier(2).matrix_as(np.array([1, 2])), BadValue, "'descending'"),
    "one entry under two assumptions": (
        lambda: basis_from([(value(0), P0), (value(1), P1)], [P0, sp.Symbol("P0", real=True)]),
        BadType, "different symbols"),
    "an indexed entry": (
        lambda: basis_from([value(0), (value(1), sp.IndexedBase("p")[1])]), BadValue, r"p\[1\]"),
    "a condition made by hand at a float": (
        lambda: basis_from([Condition(0.5, 0), value(1)]), NotExact, r"Rational\(1, 2\)"),
    "a condition made by hand of order -1": (
        lambda: basis_from([Condition(0, -1), value(1)]), BadValue, "order 1, 2, 3"),
    "text as tension": (lambda: cardinal("T"), BadType, "never parsed"),
    "degree 0": (lambda: uniform_bspline(0), BadValue, "degree 1, 2, 3"),
    "a float degree": (lambda: monomial(2.0), BadValue, "degree 1, 2, 3"),
    "an entry left out": (
        lambda: hermite().matrix_as(geometry=("P0", "T0", "T1")), BadValue, "in some order"),
    "an entry twice": (
        lambda: hermite().matrix_as(geometry=("P0", "T0", "T1", "T1")), BadValue, "once"),
    "text as geometry": (
        lambda: hermite().matrix_as(geometry="P0 P1 T0 T1"), BadType, "list of names"),
    "text to identify": (lambda: identify("1 2"), BadType, "never parsed"),
    "a list to identify": (lambda: identify([1, 2]), BadType, "a matrix"),
    "floats to identify": (lambda: identify([[0.5, 1], [1, 2]]), NotExact, r"Rational\(1, 2\)"),
    "functions to identify": (lambda: identify([[t, 1], [1, t]]), BadValue, "without the parame"),
    "a parameter that is an entry": (
        lambda: basis_from([value(P0), (value(1), P0)]), BadValue, "other names"),
    "constraints at high roots": (
        lambda: basis_from(list(map(value, HIGH_ROOTS))), BadValue, "degree at most 8"),
    "dependent constraints at roots": (
        lambda: basis_from([value((1 + sqrt(2)) ** 2), value(3 + 2 * sqrt(2))]),
        UnsolvableConstraints, r"c\(\(1 \+ sqrt\(2\)\)\*\*2\) = P0 and"),
    "conversion to a singular basis": (
        lambda: bezier(3).to(cardinal(1)), BadValue, "singular matrix"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_explained(name):
    call, error, said = BAD[name]
    with pytest.raises(error, match=said) as caught:
        call()
    assert str(caught.value).startswith("Expected ")

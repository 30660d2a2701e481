"""A basis from what its curves must satisfy: constraints, linear system, inverse, functions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any, NoReturn

import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError

from ..errors import UnsolvableConstraints
from ..exact import PARAMETER
from ..exact_matrix import inverse, product, solution, to_matrix
from ..fields import common_field
from ..names import unused_letter
from ..proofs.derivation import Derivation, Step
from ..written import times
from .basis import Basis, Geometry
from .constraints import Condition, row_of_powers
from .demands import demand_rows, entries_of, read_constraints
from .parameters import refuse_high_roots


def basis_from(
    constraints: Iterable[Any],
    geometry: Sequence[sp.Symbol] | None = None,
    name: str = "basis from constraints",
) -> Basis:
    r"""Derive the basis whose curves satisfy the given constraints.

    N constraints determine a curve of degree N - 1. Writing them as C A = L G, with A the
    coefficients of the powers and G the geometry vector, the basis matrix is M = C^-1 L.

    Parameters
    ----------
    constraints : list of conditions, or of pairs (condition, combination)
        `value(at)` and `derivative(at, order)`. A bare condition gets its own entry of G, named
        P0, P1, ... (values), T0, ... (first derivatives), A0, ... and J0, ... . In a pair the
        condition equals a linear combination of symbols, such as ``3*(P1 - P0)``, or 0.
    geometry : list of Symbol, optional
        The entries of G in order; other symbols are parameters of the basis. By default every
        symbol is an entry, in order of appearance.
    name : str

    Raises
    ------
    UnsolvableConstraints
        If constraints contradict or repeat each other; the sentence names them.
    BadValue, BadType
        For an empty list, entries of another form, or a combination that is not linear in G.

    Examples
    --------
    >>> from symbolic import derivative, value
    >>> basis_from([value(0), value(1), derivative(0), derivative(1)]).matrix
    Matrix([
    [ 2, -2,  1,  1],
    [-3,  3, -2, -1],
    [ 0,  0,  1,  0],
    [ 1,  0,  0,  0]])
    >>> P0, P1, P2 = sp.symbols("P0:3")
    >>> basis_from([(value(0), P0), (value(1), P2), (derivative(0), 2*(P1 - P0))],
    ...            geometry=(P0, P1, P2)).functions
    (t**2 - 2*t + 1, -2*t**2 + 2*t, t**2)
    """
    conditions, combinations = read_constraints(constraints)
    return basis_of(conditions, combinations, entries_of(conditions, combinations, geometry), name)


def basis_of(
    conditions: Sequence[Condition],
    combinations: Sequence[sp.Expr],
    entries: Sequence[sp.Symbol],
    name: str,
) -> Basis:
    """Return the basis of constraints that are read already; entries may be left unmentioned."""
    system = _system(conditions)
    try:
        solved = inverse(system)
    except DMNonInvertibleMatrixError:
        _refuse_unsolvable(system, conditions, combinations)
    constant_one = system[:, -1:]  # what the conditions make of the curve c = 1
    matrix, kinds = solved, constant_one
    if list(entries) != list(combinations):  # otherwise each condition has an entry of its own
        demands = demand_rows(entries, combinations)
        refuse_high_roots(demands.domain)
        matrix, kinds = product(solved, demands), solution(demands, constant_one)
    return Basis(
        name,
        tuple(
            Geometry(symbol, "point" if kind else "vector")
            for symbol, kind in zip(entries, _moves(kinds, entries), strict=True)
        ),
        matrix,
        partial(_derivation, conditions=conditions, combinations=combinations),
    )


def _system(conditions: Sequence[Condition]) -> DomainMatrix:
    """Return the constraint matrix C: one row for every condition, highest power first."""
    field, parameters = common_field(condition.at for condition in conditions)
    refuse_high_roots(field)
    degree = len(conditions) - 1
    rows = [
        row_of_powers(at, condition.order, degree, field.zero, field.one)
        for condition, at in zip(conditions, parameters, strict=True)
    ]
    shape = (len(rows), degree + 1)
    return DomainMatrix.from_list_flat([e for row in rows for e in row], shape, field).to_dense()


def _moves(kinds: DomainMatrix | None, entries: Sequence[sp.Symbol]) -> list[Any]:
    """Return what is truthy for entries that move with the curve: all, where it is not known."""
    return [True] * len(entries) if kinds is None else kinds.to_list_flat()


def _refuse_unsolvable(
    system: DomainMatrix, conditions: Sequence[Condition], combinations: Sequence[sp.Expr]
) -> NoReturn:
    """Name the first constraints of which one follows from the others."""
    relation = system.transpose().nullspace().to_Matrix().row(0)
    involved = [i for i in range(len(conditions)) if relation[i] != 0]
    named = " and ".join(f"{conditions[i]} = {combinations[i]}" for i in involved)
    degree = len(conditions) - 1
    # The rows cancel, so the same combination of the right sides has to be zero.
    demand = sp.expand(sp.Add(*(relation[i] * combinations[i] for i in involved)))
    trouble = f"which can hold together only if {demand} = 0"
    if len(involved) == 1:
        trouble = f"though {conditions[involved[0]]} is 0 for every curve of degree {degree}"
    elif demand == 0:
        trouble = "which say the same"
    raise UnsolvableConstraints(
        f"{degree + 1} independent constraints for a curve of degree {degree}",
        f"{named}, {trouble}",
        "Replace one of them by a condition that says something else.",
    )


def _derivation(
    basis: Basis,
    conditions: Sequence[Condition],
    combinations: Sequence[sp.Expr],
) -> Derivation:
    letter = unused_letter("abc", (*(condition.at for condition in conditions), *combinations))
    unknowns = [sp.Symbol(f"{letter}_{k}") for k in range(basis.degree, -1, -1)]
    curve = sp.Add(*(a * p for a, p in zip(unknowns, basis.powers, strict=True)))
    powers, column = sp.ImmutableMatrix([basis.powers]), sp.ImmutableMatrix(unknowns)
    system = _system(conditions)
    demands = demand_rows([entry.symbol for entry in basis.geometry], combinations)
    c, c_inverse, right = map(to_matrix, (system, inverse(system), demands))
    rows = [sp.Add(*(e * a for e, a in zip(c.row(i), unknowns, strict=True)))
            for i in range(len(conditions))]  # fmt: skip
    finished = basis.matrix * sp.ImmutableMatrix([entry.symbol for entry in basis.geometry])
    given = ", ".join(map(str, basis.geometry))
    steps = [
        Step(times(powers, column), sp.ImmutableMatrix([[curve]]),
             "the curve c with unknown coefficients, highest power first"),
        *(Step(condition.of(curve, PARAMETER), row, f"{condition} in terms of the coefficients")
          for condition, row in zip(conditions, rows, strict=True)),
        Step(times(c, column), sp.ImmutableMatrix(rows),
             "the same rows as the left side of one linear system"),
        Step(times(c, c_inverse), sp.ImmutableMatrix(sp.eye(c.rows)),
             "the inverse of the constraint matrix"),
        Step(times(c_inverse, right), basis.matrix,
             f"the inverse times the right sides, in terms of ({given}), is the basis matrix"),
        Step(times(powers, basis.matrix), sp.ImmutableMatrix([basis.functions]),
             f"one blending function for each of {given}"),
        Step(times(c, finished), sp.ImmutableMatrix(combinations),
             f"the finished curve has {', '.join(map(str, conditions))} as demanded, row by row"),
    ]  # fmt: skip
    return Derivation(
        f"{basis.name}: from {len(conditions)} constraints",
        tuple(steps),
        "Foley, van Dam, Feiner and Hughes, Computer Graphics, section 11.2",
    )

"""A basis from what its curves must satisfy: constraints, linear system, inverse, functions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from ..errors import BadType, BadValue, UnsolvableConstraints, shown
from ..exact import PARAMETER, as_list, by_name, exact
from ..exact_matrix import dense, product, solution, to_matrix
from ..proofs.derivation import Derivation, Step
from .basis import Basis, Geometry
from .constraints import Condition

_LETTERS = {0: "P", 1: "T", 2: "A", 3: "J"}  # position, tangent, acceleration, jerk


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
    conditions, combinations = _read(constraints)
    entries = _entries(combinations, geometry)
    degree = len(conditions) - 1
    system = dense([condition.row(degree) for condition in conditions])
    demands = dense([_linear_in(entries, right) for right in combinations])
    _refuse_unsolvable(system, conditions, combinations)
    inverse = system.inv().to_dense()
    matrix = product(inverse, demands)
    constant_curve = solution(demands, system[:, degree:])
    kinds = [True] * len(entries) if constant_curve is None else constant_curve.to_list_flat()
    return Basis(
        name,
        tuple(
            Geometry(symbol, "point" if kind else "vector")
            for symbol, kind in zip(entries, kinds, strict=True)
        ),
        matrix,
        partial(
            _derivation,
            conditions=conditions,
            combinations=combinations,
            system=system,
            inverse=inverse,
            demands=demands,
        ),  # fmt: skip
    )


def _read(constraints: Iterable[Any]) -> tuple[list[Condition], list[sp.Expr]]:
    conditions: list[Condition] = []
    combinations: list[sp.Expr | None] = []
    listed = as_list(constraints)
    if listed is None:
        raise BadType("a list of constraints", shown(constraints), "Write [value(0), value(1)].")
    for entry in listed:
        bare = isinstance(entry, Condition)
        pair = (entry, None) if bare else entry
        if not (isinstance(pair, tuple) and len(pair) == 2 and isinstance(pair[0], Condition)):
            raise BadType(
                "value(at), derivative(at, order) or a pair (condition, combination)",
                shown(entry),
                "Write for example (derivative(0), 3*(P1 - P0)).",
            )
        conditions.append(pair[0])
        combinations.append(None if bare else by_name(exact(pair[1])))
    if not conditions:
        raise BadValue("at least one constraint", "none", "A cubic needs four.")
    taken = {str(s) for right in combinations if right is not None for s in right.free_symbols}
    named: list[sp.Expr] = []
    for condition, right in zip(conditions, combinations, strict=True):
        named.append(_next_symbol(condition.order, taken) if right is None else right)
    return conditions, named


def _next_symbol(order: int, taken: set[str]) -> sp.Symbol:
    letter = _LETTERS.get(order, f"D{order}_")
    index = 0
    while f"{letter}{index}" in taken:
        index += 1
    taken.add(f"{letter}{index}")
    return sp.Symbol(f"{letter}{index}")


def _entries(
    combinations: Sequence[sp.Expr], geometry: Sequence[sp.Symbol] | None
) -> tuple[sp.Symbol, ...]:
    mentioned: dict[sp.Symbol, None] = {}
    for right in combinations:
        mentioned.update(dict.fromkeys(sorted(right.free_symbols, key=str)))
    entries = tuple(mentioned) if geometry is None else _given(geometry)
    unused = [str(symbol) for symbol in entries if symbol not in mentioned]
    if unused or not entries:
        raise BadValue(
            "constraints that mention every entry of the geometry",
            f"none with {', '.join(unused) or 'any'}",
            "Leave it out, or add a constraint such as (value(0), P0).",
        )
    if PARAMETER in mentioned:
        raise BadValue(
            "combinations of points and vectors",
            f"the curve's own parameter {PARAMETER}",
            "Call it by another name.",
        )
    return entries


def _given(geometry: Any) -> tuple[sp.Symbol, ...]:
    symbols = as_list(geometry) or []
    if not all(isinstance(s, sp.Symbol) for s in symbols) or len({*symbols}) != len(symbols):
        raise BadType("different symbols as geometry", shown(geometry), "Use symbols('P0:4').")
    if not symbols:
        raise BadType("symbols as geometry", shown(geometry), "Use symbols('P0:4').")
    return tuple(by_name(symbol) for symbol in symbols)


def _linear_in(entries: Sequence[sp.Symbol], combination: sp.Expr) -> list[sp.Expr]:
    try:
        polynomial = sp.Poly(combination, *entries)
        monomials = polynomial.as_dict()
    except sp.PolynomialError:
        monomials = {(2,): sp.S.One}
    if any(sum(exponents) != 1 for exponents in monomials):
        raise BadValue(
            f"a linear combination of {', '.join(map(str, entries))}",
            shown(combination),
            "Name the geometry with geometry=(...) if some symbols are parameters.",
        )
    unit = range(len(entries))
    return [monomials.get(tuple(int(i == j) for i in unit), sp.S.Zero) for j in unit]


def _refuse_unsolvable(
    system: DomainMatrix, conditions: Sequence[Condition], combinations: Sequence[sp.Expr]
) -> None:
    relations = system.transpose().nullspace()
    if not relations.shape[0]:
        return
    relation = relations.to_Matrix().row(0)
    involved = [i for i in range(len(conditions)) if relation[i] != 0]
    named = " and ".join(f"{conditions[i]} = {combinations[i]}" for i in involved)
    degree = len(conditions) - 1
    # The rows cancel, so the same combination of the right sides has to be zero.
    demand = sp.Add(*(relation[i] * combinations[i] for i in involved))
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
    system: DomainMatrix,
    inverse: DomainMatrix,
    demands: DomainMatrix,
) -> Derivation:
    unknowns = [sp.Symbol(f"a_{k}") for k in range(basis.degree, -1, -1)]
    curve = sp.Add(*(a * p for a, p in zip(unknowns, basis.powers, strict=True)))
    powers, column = sp.ImmutableMatrix([basis.powers]), sp.ImmutableMatrix(unknowns)
    c, c_inverse, right = map(to_matrix, (system, inverse, demands))
    rows = [sum((e * a for e, a in zip(c.row(i), unknowns, strict=True)), sp.S.Zero)
            for i in range(len(conditions))]  # fmt: skip
    finished = basis.curve([[entry.symbol] for entry in basis.geometry])[0]
    given = ", ".join(map(str, basis.geometry))
    steps = [
        Step(_times(powers, column), sp.ImmutableMatrix([[curve]]),
             "the curve c with unknown coefficients, highest power first"),
        *(Step(condition.of(curve, PARAMETER), row, f"{condition} in terms of the coefficients")
          for condition, row in zip(conditions, rows, strict=True)),
        Step(_times(c, column), sp.ImmutableMatrix(rows),
             "the same rows as the left side of one linear system"),
        Step(_times(c, c_inverse), sp.ImmutableMatrix(sp.eye(c.rows)),
             "the inverse of the constraint matrix"),
        Step(_times(c_inverse, right), basis.matrix,
             f"the inverse times the right sides, in terms of ({given}), is the basis matrix"),
        Step(_times(powers, basis.matrix), sp.ImmutableMatrix([basis.functions]),
             f"one blending function for each of {given}"),
        *(Step(condition.of(finished, PARAMETER), given_side, f"{condition} of the finished curve")
          for condition, given_side in zip(conditions, combinations, strict=True)),
    ]  # fmt: skip
    return Derivation(f"{basis.name}: from {len(conditions)} constraints", tuple(steps))


def _times(left: sp.ImmutableMatrix, right: sp.ImmutableMatrix) -> sp.MatMul:
    return sp.MatMul(left, right, evaluate=False)

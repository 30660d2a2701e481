"""What the conditions of a basis have to equal: entries of the geometry and combinations."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list, by_name, exact, whole_number
from ..exact_matrix import dense
from ..fields import common_field
from .constraints import Condition, derivative, value
from .parameters import refuse_clash

_LETTERS = {0: "P", 1: "T", 2: "A", 3: "J"}  # position, tangent, acceleration, jerk


def read_constraints(constraints: Iterable[Any]) -> tuple[list[Condition], list[sp.Expr]]:
    """Return the conditions, and what each of them equals: its own new symbol, if nothing is said.

    >>> from symbolic import derivative, value
    >>> read_constraints([value(0), (derivative(0), sp.Symbol("P0"))])[1]
    [P1, P0]
    """
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
        conditions.append(_read(pair[0]))
        combinations.append(None if bare else by_name(exact(pair[1])))
    if not conditions:
        raise BadValue("at least one constraint", "none", "A cubic needs four.")
    expressions = [condition.at for condition in conditions]
    expressions += [right for right in combinations if right is not None]
    common_field(expressions)  # refuses functions
    taken = {str(symbol) for expression in expressions for symbol in expression.free_symbols}
    named: list[sp.Expr] = []
    for condition, right in zip(conditions, combinations, strict=True):
        named.append(_next_symbol(condition.order, taken) if right is None else right)
    return conditions, named


def _read(condition: Condition) -> Condition:
    """Return a condition with its parts read; `Condition` itself takes whatever comes."""
    if whole_number(condition.order) == 0:
        return value(condition.at)
    return derivative(condition.at, condition.order)


def _next_symbol(order: int, taken: set[str]) -> sp.Symbol:
    letter = _LETTERS.get(order, f"D{order}_")
    index = 0
    while f"{letter}{index}" in taken:
        index += 1
    taken.add(f"{letter}{index}")
    return sp.Symbol(f"{letter}{index}")


def entries_of(
    conditions: Sequence[Condition],
    combinations: Sequence[sp.Expr],
    geometry: Sequence[sp.Symbol] | None,
) -> tuple[sp.Symbol, ...]:
    """Return the geometry vector: the given one, or every symbol in order of appearance."""
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
    refuse_clash([condition.at for condition in conditions], entries)
    return entries


def _given(geometry: Any) -> tuple[sp.Symbol, ...]:
    listed = as_list(geometry) or []
    symbols = tuple(by_name(s) for s in listed if isinstance(s, sp.Symbol))
    if not symbols or len({*symbols}) < len(listed):
        raise BadType("different symbols as geometry", shown(geometry), "Use symbols('P0:4').")
    return symbols


def demand_rows(entries: Sequence[sp.Symbol], combinations: Sequence[sp.Expr]) -> DomainMatrix:
    """Return the combinations as rows of a matrix L: the right sides are L * entries.

    >>> p, q, a = sp.symbols("p q a")
    >>> demand_rows([p, q], [a*(q - p), p]).to_Matrix()
    Matrix([
    [-a, a],
    [ 1, 0]])
    """
    return dense([_linear_in(entries, right) for right in combinations])


def _linear_in(entries: Sequence[sp.Symbol], combination: sp.Expr) -> list[sp.Expr]:
    if combination in entries:
        return [sp.Integer(entry == combination) for entry in entries]
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

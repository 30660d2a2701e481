"""Witnesses that respect what was declared about symbols, as in `Symbol("n", integer=True)`.

Symbols are matched by name, and what is proved holds for all their values. A witness against an
equality has to be one that was meant: sin(n pi/2) cos(n pi/2) = 0 is true for integers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

import sympy as sp

from ..dag import postorder
from ..errors import written
from .generators import NoNormalForm
from .side import evaluated, put_in
from .verdict import Refuted, Undecided, Verdict

Pair = tuple[sp.Expr, sp.Expr]

_CANDIDATES = tuple(map(sp.sympify, (1, 2, 3, sp.Rational(1, 2), 4, 0, -1, -2, -sp.S.Half, sp.I)))
_TRIES = 5


def as_declared(refuted: Refuted, given: Pair, compare: Callable[[Pair], Verdict]) -> Verdict:
    """Return the refutation if its witness is among the values declared, or one where it is.

    If none is found, the verdict is undecided.
    """
    declared: dict[sp.Symbol, list[sp.Symbol]] = {}
    for node in set(postorder(given)):
        if type(node) is sp.Symbol and node != sp.Symbol(node.name):
            declared.setdefault(sp.Symbol(node.name), []).append(node)
    broken = [
        symbol
        for symbol, names in declared.items()
        if symbol in refuted.witness and not _may_be(names, refuted.witness[symbol])
    ]
    if not broken:
        return refuted
    allowed = {s: [n for n in _CANDIDATES if _may_be(names, n)] for s, names in declared.items()}
    sides = _without_operators(given)
    for k in range(_TRIES if sides and all(allowed.values()) else 0):
        values = {s: row[(k + i) % len(row)] for i, (s, row) in enumerate(allowed.items())}
        try:
            left, right = put_in(sides, values)
        except NoNormalForm:
            continue
        verdict = compare((left, right))
        if isinstance(verdict, Refuted):
            return replace(verdict, witness={**values, **verdict.witness})
    places = ", ".join(f"{symbol} = {written(refuted.witness[symbol])}" for symbol in broken)
    return Undecided(f"the sides differ at {places}, but that is not what was declared")


def _without_operators(given: Pair) -> list[sp.Expr]:
    try:
        sides = [evaluated(side, keep_operators=False) for side in given]
    except NoNormalForm:
        return []
    bound = any(
        isinstance(node, sp.Derivative | sp.Subs | sp.Integral) for node in postorder(sides)
    )
    return [] if bound else sides


def _may_be(names: Iterable[sp.Symbol], value: sp.Expr) -> bool:
    facts = [fact for name in names for fact in name.assumptions0.items()]
    return all(getattr(value, f"is_{fact}") is holds for fact, holds in facts)

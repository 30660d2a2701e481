"""Comparing piecewise expressions: on every interval between break points, and at these points.

The variable of piecewise expressions is a real number. Its break points are where a condition, or
the argument of Abs, Max, Min, sign or Heaviside, which is linear in the variable, changes its sign.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.functions.elementary.piecewise import ExprCondPair
from sympy.logic.boolalg import And, BooleanFalse, BooleanTrue, Not, Or

from ..dag import postorder, substitute
from ..errors import BadValue, shown, written
from ..polynomials import polynomials
from ..signs import sign
from .cells import Cell, certain_sign
from .comparison import compared
from .normal_form import NormalForms
from .side import CORNERED, has_corners
from .verdict import Proved, Refuted, Undecided, Verdict
from .witness import Windows

MOST_CELLS = 1000

Pair = tuple[sp.Expr, sp.Expr]
SignOf = Callable[[sp.Expr], int]


@dataclass(frozen=True)
class _Split:
    """Where nodes that depend on the sign of linear functions of one variable change."""

    variable: sp.Symbol | None  # None: all these signs are known
    nodes: frozenset[sp.Basic]
    breaks: tuple[sp.Expr, ...]


def compared_in_pieces(sides: Pair, windows: Windows | None = None) -> Verdict:
    """Decide whether two expressions are equal wherever they are defined.

    Where only one of them is defined nothing is decided. An identity on an open interval is one of
    formulas; a witness is taken from the interval on which the formulas differ.
    """
    windows = windows or {}
    split = _split(sides)
    if split is None:
        verdict = compared(NormalForms(sides), (0, 1), sides, windows)
        if has_corners(sides) and isinstance(verdict, Undecided):
            node = next(n for n in postorder(sides) if isinstance(n, CORNERED))
            return Undecided(f"{shown(node, 60)} has no break points that are known numbers")
        return verdict
    if split.variable is None:
        return _merged([_in_piece(sides, split, certain_sign, None, windows, "")])
    variable = split.variable
    breaks, cells = windows.get(variable, Cell()).cut(split.breaks)
    if len(cells) > MOST_CELLS:
        return Undecided(f"there are more than {MOST_CELLS} intervals")
    others = {symbol: cell for symbol, cell in windows.items() if symbol != variable}
    found: list[Verdict | None] = []
    for i, cell in enumerate(cells):
        signs, where = _signs_at(variable, cell.inside()), f"on the interval {cell} of {variable}"
        inside = _in_piece(sides, split, signs, None, {**windows, variable: cell}, where)
        if isinstance(inside, Refuted):
            inside = replace(inside, witness={variable: cell.inside(), **inside.witness})
        found.append(inside)
        for point in breaks[i : i + 1]:
            signs, where = _signs_at(variable, point), f"at {variable} = {written(point)}"
            at_point = _in_piece(sides, split, signs, (variable, point), others, where)
            if isinstance(at_point, Refuted):
                at_point = replace(at_point, witness={variable: point, **at_point.witness})
            found.append(at_point)
        if any(isinstance(verdict, Refuted) for verdict in found[-2:]):
            break
    return _merged(found, len(cells))


def _merged(found: Sequence[Verdict | None], cells: int = 1) -> Verdict:
    """Sum up the verdicts on all pieces; None where neither side is defined."""
    verdicts = [verdict for verdict in found if verdict is not None]
    for kind in (Refuted, Undecided):
        for verdict in verdicts:
            if isinstance(verdict, kind):
                return verdict
    if not verdicts:
        return Undecided("both sides are defined nowhere")
    kind_of_most = max((v.kind for v in verdicts if isinstance(v, Proved)), key=len)
    if cells == 1 or "intervals" in kind_of_most:
        return Proved(kind_of_most)
    return Proved(f"{kind_of_most}, on each of {cells} intervals and at the points between them")


def _in_piece(
    sides: Pair,
    split: _Split,
    sign_of: SignOf,
    at: tuple[sp.Symbol, sp.Expr] | None,
    windows: Windows,
    where: str,
) -> Verdict | None:
    left, right = (_resolved(side, split.nodes, sign_of, at) for side in sides)
    if left is None and right is None:
        return None
    if left is None or right is None:
        only = "left" if right is None else "right"
        return Undecided(f"only the {only} side is defined {where}".rstrip())
    verdict = compared_in_pieces((left, right), windows)
    if isinstance(verdict, Undecided) and where:
        return Undecided(f"{verdict.why}, {where}")
    return verdict


def _signs_at(variable: sp.Symbol, number: sp.Expr) -> SignOf:
    return lambda switch: certain_sign(substitute([switch], {variable: number})[0])


def _split(sides: Pair) -> _Split | None:
    """Find the nodes that can be resolved first: signs of numbers, or one variable's."""
    roots: dict[sp.Symbol | None, dict[sp.Basic, list[sp.Expr]]] = {}
    for node in postorder(sides):
        if isinstance(node, CORNERED):
            found = _break_points(node)
            if found is not None:
                roots.setdefault(found[0], {})[node] = found[1]
    if not roots:
        return None
    variable = None if None in roots else min((s for s in roots if s is not None), key=str)
    points = [point for breaks in roots[variable].values() for point in breaks]
    return _Split(variable, frozenset(roots[variable]), tuple(dict.fromkeys(points)))


def _break_points(node: sp.Basic) -> tuple[sp.Symbol | None, list[sp.Expr]] | None:
    """Return the one variable whose linear functions decide a node's value, and their zeros."""
    switches = _switches(node)
    if switches is None or has_corners(switches):
        return None
    symbols = set().union(*(s.free_symbols for s in switches))
    if len(symbols) > 1:
        return None
    try:
        if not symbols:
            return None if any(sign(s) is None for s in switches) else (None, [])
        (variable,) = symbols
        zeros = []
        field, rows = polynomials(switches, variable)
    except BadValue:
        return None
    for row in rows:
        if len(row) > 2 or any(sign(field.to_sympy(c)) is None for c in row):
            return None
        if len(row) == 2:
            zeros.append(field.to_sympy(-row[1] / row[0]))
    return variable, zeros


def _switches(node: sp.Basic) -> list[sp.Expr] | None:
    """Return the expressions whose signs decide the value of a node, or None if others do."""
    if isinstance(node, sp.Piecewise):
        switches = []
        for _, condition in node.args:
            for part in postorder([condition], lambda n: n.args if _is_logical(n) else ()):
                if isinstance(part, Relational):
                    switches.append(part.lhs - part.rhs)
                elif not _is_logical(part) and part not in (sp.true, sp.false):
                    return None
        return switches
    if isinstance(node, sp.Max | sp.Min):
        return [a - b for a, b in combinations(node.args, 2)]
    return [node.args[0]]


def _is_logical(node: sp.Basic) -> bool:
    return isinstance(node, And | Or | Not)


def _resolved(
    side: sp.Expr,
    nodes: frozenset[sp.Basic],
    sign_of: SignOf,
    at: tuple[sp.Symbol, sp.Expr] | None,
) -> sp.Expr | None:
    """Return a side with all these nodes replaced by their values; None if it is undefined.

    What may be undefined is kept, times zero, where SymPy drops it, as in 0*(1/x) or 1/x - 1/x.
    """

    def arguments(node: sp.Basic) -> tuple[sp.Basic, ...]:
        if isinstance(node, _WITH_BOUND_SYMBOLS):
            return ()
        if node not in nodes:
            return node.args
        chosen = _chosen(node, sign_of)
        return (chosen[1],) if chosen else ()

    new: dict[int, sp.Basic | None] = {}
    doubtful: dict[int, frozenset[sp.Basic]] = {}  # parts of the old nodes' new values
    dropped: dict[sp.Basic, None] = {}
    for node in postorder([side], arguments):
        below = [new[id(argument)] for argument in arguments(node)]
        if isinstance(node, ExprCondPair) and below[0] is None and below[1] is not None:
            new[id(node)] = ExprCondPair(sp.nan, below[1])  # this branch may not be the one taken
        elif any(value is None for value in below):
            new[id(node)] = None
        elif node in nodes:
            chosen = _chosen(node, sign_of)
            new[id(node)] = None if chosen is None else sp.Mul(chosen[0], *below)
        elif at is not None and node == at[0]:
            new[id(node)] = at[1]
        elif isinstance(node, _WITH_BOUND_SYMBOLS):
            is_free = at is not None and at[0] in node.free_symbols
            new[id(node)] = sp.Subs(node, at[0], at[1]) if at and is_free else node
        else:
            same = all(a is b for a, b in zip(below, node.args, strict=True))
            value = node if same else node.func(*below)
            new[id(node)] = None if value in _UNDEFINED else value
        before = frozenset().union(*(doubtful[id(argument)] for argument in arguments(node)))
        value = new[id(node)]
        if value is not None and (before or may_be_undefined(node) or may_be_undefined(value)):
            after = frozenset(n for n in postorder([value]) if may_be_undefined(n))
            if node.is_Add or node.is_Mul:
                dropped |= dict.fromkeys(before - after)
            doubtful[id(node)] = after
        else:
            doubtful[id(node)] = before
    result = new[id(side)]
    if result is None or not dropped:
        return result
    kept = (sp.Mul(0, part, evaluate=False) for part in sorted(dropped, key=sp.default_sort_key))
    return sp.Add(result, *kept, evaluate=False)


_WITH_BOUND_SYMBOLS = (sp.Derivative, sp.Subs, sp.Limit)  # left where functions are not known


def may_be_undefined(node: sp.Basic) -> bool:
    """Tell whether a node may have no value though all its arguments have one."""
    if node.is_Pow:
        return not node.exp.is_nonnegative
    if isinstance(node, sp.Piecewise):
        return node.args[-1].cond != sp.true
    return isinstance(node, sp.Function) and not isinstance(node, _DEFINED_EVERYWHERE)


_DEFINED_EVERYWHERE = (sp.sin, sp.cos, sp.exp, AppliedUndef, *CORNERED)
_UNDEFINED = (sp.nan, sp.zoo, sp.oo, -sp.oo)


def _chosen(node: sp.Basic, sign_of: SignOf) -> tuple[int, sp.Expr] | None:
    """Return the factor and the expression that a node is equal to, given the signs."""
    if isinstance(node, sp.Piecewise):
        branches = (value for value, condition in node.args if _holds(condition, sign_of))
        branch = next(branches, None)
        return None if branch is None else (1, branch)
    if isinstance(node, sp.Max | sp.Min):
        best = node.args[0]
        for argument in node.args[1:]:
            larger = sign_of(argument - best) > 0
            best = argument if larger == isinstance(node, sp.Max) else best
        return 1, best
    direction = sign_of(node.args[0])
    if isinstance(node, sp.Abs):
        return direction, node.args[0]
    if isinstance(node, sp.Heaviside):
        return 1, sp.S.Zero if direction < 0 else (sp.S.One if direction else node.args[1])
    return direction, sp.S.One


def _holds(condition: sp.Basic, sign_of: SignOf) -> bool:
    if isinstance(condition, BooleanTrue | BooleanFalse):
        return bool(condition)
    if isinstance(condition, And):
        return all(_holds(part, sign_of) for part in condition.args)
    if isinstance(condition, Or):
        return any(_holds(part, sign_of) for part in condition.args)
    if isinstance(condition, Not):
        return not _holds(condition.args[0], sign_of)
    return _RELATIONS[condition.func](sign_of(condition.lhs - condition.rhs))


_RELATIONS: Mapping[type, Callable[[int], bool]] = {
    sp.StrictLessThan: lambda s: s < 0,
    sp.LessThan: lambda s: s <= 0,
    sp.StrictGreaterThan: lambda s: s > 0,
    sp.GreaterThan: lambda s: s >= 0,
    sp.Equality: lambda s: s == 0,
    sp.Unequality: lambda s: s != 0,
}

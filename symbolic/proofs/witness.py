"""Witnesses: values of the symbols at which two sides certainly differ, or are certainly defined.

Where the generators are independent the algebra finds one: a polynomial that is not zero has
finitely many roots in its first variable, so some small rational keeps it from vanishing. Elsewhere
both sides are enclosed at a few rational points; enclosures that do not meet are a proof.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import count, islice
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from ..dag import postorder, substitute
from ..intervals import can_enclose, differ, enclosure
from .cells import Cell
from .elements import composed, parts, used, value_of
from .generators import Generators
from .verdict import Refuted

Windows = Mapping[sp.Symbol, Cell]
"""Open intervals to which some symbols are confined."""

_POINTS = 6  # at which sides are enclosed
_DEFINED_EVERYWHERE = (
    sp.sin, sp.cos, sp.exp, sp.sinh, sp.cosh, sp.erf, sp.erfc, sp.floor, sp.ceiling, sp.re, sp.im,
    sp.conjugate, sp.Abs, sp.sign, sp.Heaviside, sp.Max, sp.Min, sp.Piecewise, AppliedUndef,
)  # fmt: skip


def algebraic_witness(
    generators: Generators, sides: Sequence[Any], nonzero: Iterable[Any], windows: Windows
) -> Refuted:
    """Return values at which no element of `nonzero` vanishes, and the two sides there.

    The generators that occur have to be independent. The angle of a cosine c and a sine s is
    taken as 2 atan(h) with a rational h: c = (1 - h^2)/(1 + h^2) and s = 2h/(1 + h^2).
    """
    left = [part for element in nonzero for part in parts(element)]
    left += [part for side in sides for part in parts(side)[1:]]
    values: dict[sp.Symbol, sp.Expr] = {}
    chosen: dict[int, Any] = {}
    for position in sorted(set().union(*map(used, (*left, *sides)))):
        generator = generators.listed[position]
        if generator.kind == "number" or position in chosen:
            continue
        angle, symbol = generator.angle, generator.symbol
        for number in numbers_in(windows.get(symbol) if angle is None else None):
            at, value = {position: number}, number
            if angle is not None:
                at, value = _at_angle(generators, angle, number)
            elements = {i: left[0].ring.one * sp.QQ(v.p, v.q) for i, v in at.items()}
            there = [composed(polynomial, elements) for polynomial in left]
            if all(there):
                left, values[symbol], chosen = there, value, chosen | elements
                break
    expressions = [generator.expression for generator in generators.listed]
    a, b = (value_of(composed(side, chosen), expressions) for side in sides)
    return Refuted(values, a, b)


def _at_angle(
    generators: Generators, angle: sp.Expr, h: sp.Rational
) -> tuple[dict[int, sp.Rational], sp.Expr]:
    coefficient, _ = angle.as_coeff_Mul(rational=True)
    cosine, sine = (1 - h**2) / (1 + h**2), 2 * h / (1 + h**2)
    at = {generators.of(sp.cos(angle)): cosine, generators.of(sp.sin(angle)): sine}
    return at, 2 * sp.atan(h) / coefficient


def enclosed_witness(left: sp.Expr, right: sp.Expr, windows: Windows) -> Refuted | None:
    """Return a rational point at which enclosures prove that the sides differ, if one is found."""
    for values in _points(free_symbols([left, right]), windows, with_negative=True):
        a, b = enclosure(left, values), enclosure(right, values)
        if a is not None and b is not None and differ(a, b):
            return Refuted(values, *substitute([left, right], values))
    return None


def is_somewhere_defined(expressions: Sequence[sp.Expr], windows: Windows) -> bool:
    """Tell whether at one point certainly no divisor vanishes and every function has a value.

    Only small positive numbers are tried, where sqrt(x**2) is what everybody takes it for.
    """
    nodes = list(postorder(expressions))
    divisors = [n.base for n in nodes if n.is_Pow and not n.exp.is_nonnegative]
    functions = [
        n for n in nodes if isinstance(n, sp.Function) and not isinstance(n, _DEFINED_EVERYWHERE)
    ]
    for values in _points(free_symbols(expressions), windows, with_negative=False):
        boxes = [enclosure(divisor, values) for divisor in divisors]
        if all(box is not None and 0 not in box for box in boxes) and all(
            _has_value(function, values) for function in functions
        ):
            return True
    return False


def _has_value(function: sp.Expr, values: Mapping[sp.Symbol, sp.Rational]) -> bool:
    if can_enclose(function.func):
        return enclosure(function, values) is not None
    # The poles of gamma, zeta, Ei, LambertW, atanh ... on the real line are whole numbers.
    boxes = [enclosure(argument, values) for argument in function.args]
    return all(box is not None and not _holds_whole_number(box) for box in boxes)


def _holds_whole_number(box: Any) -> bool:
    return 0 in box or int(box.a) in box or int(box.a) != int(box.b)


def free_symbols(expressions: Sequence[sp.Expr]) -> list[sp.Symbol]:
    """Return the symbols of expressions by name, those bound by a substitution left out."""
    found: dict[int, frozenset[sp.Symbol]] = {}
    for node in postorder(expressions):
        below = frozenset().union(*(found[id(argument)] for argument in node.args))
        if isinstance(node, sp.Subs):
            inside = found[id(node.expr)] - set(node.variables)
            below = inside.union(*(found[id(p)] for p in node.point.args))
        if isinstance(node, sp.Integral):
            limits = [found[id(limit)] for each in node.limits for limit in each.args[1:]]
            below = (found[id(node.function)] - set(node.variables)).union(*limits)
        found[id(node)] = frozenset([node]) if node.is_Symbol else below
    return sorted(frozenset().union(*(found[id(e)] for e in expressions)), key=str)


def numbers_in(cell: Cell | None) -> Iterator[sp.Rational]:
    """Yield rationals of an open interval; without one 0, 1, 1/2, ... where parameters live."""
    if cell is not None:
        low, high = cell.window()
        yield cell.inside()
        yield from (low + (high - low) * r for r in _small_rationals() if 0 < r < 1)
    else:
        yield from _small_rationals()


def _small_rationals() -> Iterator[sp.Rational]:
    """Yield 0, 1, 1/2, 1/3, ... in [0, 1], after a while integers too."""
    yield from (sp.Integer(0), sp.Integer(1))
    for n in count(2):
        yield from (sp.Rational(k, n) for k in range(1, n) if sp.igcd(k, n) == 1)
        if n > 4:
            yield from (sp.Integer(n - 3), sp.Integer(4 - n))


def _points(
    symbols: Sequence[sp.Symbol], windows: Windows, with_negative: bool
) -> Iterator[dict[sp.Symbol, sp.Rational]]:
    """Yield a few points with different small coordinates; the second one has negative ones."""
    wanted = _POINTS + len(symbols)
    pairs = ((sp.Rational(1, n), sp.Integer(n)) for n in range(2, wanted + 2))
    free = [sp.Integer(1), *(number for pair in pairs for number in pair)]
    rows = {s: list(islice(numbers_in(windows[s]), wanted)) if s in windows else free
            for s in symbols}  # fmt: skip
    for k in range(_POINTS if symbols else 1):
        values = {s: rows[s][(k + i) % wanted] for i, s in enumerate(symbols)}
        if with_negative and k == 1:
            values = {s: v if s in windows else -v for s, v in values.items()}
        yield values

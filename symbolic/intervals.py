"""Numbers enclosed in intervals: what an expression certainly is, and certainly is not.

Every operation rounds outwards (mpmath's interval arithmetic), so disjoint enclosures belong to
different numbers. Overlapping ones say nothing: equality is never concluded here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp
from mpmath import libmp
from mpmath.ctx_iv import MPIntervalContext

from .dag import postorder

Interval = Any
DIGITS = 70
_LARGEST = 10_000  # power of ten, and exponent: the exact value has to be written down too


def enclosure(
    number: sp.Expr, values: Mapping[sp.Symbol, sp.Rational] | None = None, digits: int = DIGITS
) -> Interval | None:
    """Return an interval that certainly holds the real value of an expression, or None.

    None also for everything that might be undefined or not real, or that is not known here.

    >>> box = enclosure(sp.sin(1) - sp.sqrt(2)/2)
    >>> bool(box > 0), enclosure(sp.sqrt(-1)), enclosure(sp.Symbol("x"))
    (True, None, None)
    """
    context = MPIntervalContext()
    context.dps = digits
    boxes: dict[int, Interval] = {}
    try:
        for node in postorder([number]):
            boxes[id(node)] = _box(node, boxes, values or {}, context)
    except (_Unknown, ArithmeticError, ValueError, TypeError, libmp.ComplexResult):
        return None
    return boxes[id(number)]


def differ(left: Interval, right: Interval) -> bool:
    """Tell whether two enclosed numbers are certainly different, by more than any rounding."""
    gap = max(left.a - right.b, right.a - left.b)
    return bool(gap > 1000 * (left.delta + right.delta))


def _box(
    node: sp.Basic,
    boxes: Mapping[int, Interval],
    values: Mapping[sp.Symbol, sp.Rational],
    context: Any,
) -> Interval:
    if node.is_Symbol:
        node = values.get(node, node)
    if node.is_Rational:
        return context.mpf(int(node.p)) / int(node.q)
    if node in (sp.pi, sp.E):
        return +(context.pi if node == sp.pi else context.e)
    operation = _OPERATIONS.get(node.func)
    if operation is None:
        raise _Unknown
    box = operation(context, *(boxes[id(argument)] for argument in node.args))
    largest = context.mpf(10) ** _LARGEST
    if not -largest < box.a <= box.b < largest:
        raise _Unknown
    return box


def can_enclose(function: type) -> bool:
    """Tell whether values of this function can be enclosed, where it has some."""
    return function in _OPERATIONS


class _Unknown(Exception):
    """A node without a known finite real value."""


def _sum(context: Any, *terms: Interval) -> Interval:
    return sum(terms, context.zero)


def _product(context: Any, *factors: Interval) -> Interval:
    result = context.one
    for factor in factors:
        result = result * factor
    return result


def _power(context: Any, base: Interval, exponent: Interval) -> Interval:
    whole = int(exponent.a) if exponent.delta == 0 and exponent.a == int(exponent.a) else None
    if whole is not None:
        if (whole < 0 and 0 in base) or abs(whole) > _LARGEST:
            raise _Unknown
        return base**whole
    if not base > 0:
        raise _Unknown
    return context.exp(exponent * context.log(base))


def _log(context: Any, argument: Interval) -> Interval:
    if not argument > 0:
        raise _Unknown
    return context.log(argument)


def _quotient(context: Any, numerator: Interval, denominator: Interval) -> Interval:
    if 0 in denominator:
        raise _Unknown
    return numerator / denominator


def _absolute(context: Any, argument: Interval) -> Interval:
    return abs(argument)


_OPERATIONS: dict[type, Callable[..., Interval]] = {
    sp.Add: _sum,
    sp.Mul: _product,
    sp.Pow: _power,
    sp.log: _log,
    sp.Abs: _absolute,
    sp.exp: lambda c, x: c.exp(x),
    sp.sin: lambda c, x: c.sin(x),
    sp.cos: lambda c, x: c.cos(x),
    sp.tan: lambda c, x: _quotient(c, c.sin(x), c.cos(x)),
    sp.cot: lambda c, x: _quotient(c, c.cos(x), c.sin(x)),
    sp.sec: lambda c, x: _quotient(c, c.one, c.cos(x)),
    sp.csc: lambda c, x: _quotient(c, c.one, c.sin(x)),
    sp.sinh: lambda c, x: (c.exp(x) - c.exp(-x)) / 2,
    sp.cosh: lambda c, x: (c.exp(x) + c.exp(-x)) / 2,
    sp.tanh: lambda c, x: (c.exp(x) - c.exp(-x)) / (c.exp(x) + c.exp(-x)),
    sp.coth: lambda c, x: _quotient(c, c.exp(x) + c.exp(-x), c.exp(x) - c.exp(-x)),
    sp.sech: lambda c, x: 2 / (c.exp(x) + c.exp(-x)),
    sp.csch: lambda c, x: _quotient(c, c.mpf(2), c.exp(x) - c.exp(-x)),
}

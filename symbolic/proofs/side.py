"""One side of an equality: an expression, or a matrix or nested list of them, read once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.logic.boolalg import Boolean
from sympy.matrices.exceptions import MatrixError

from ..dag import postorder, transformed
from ..errors import BadType, BadValue, shown
from ..exact import as_list, by_name, exact
from ..fields import operands
from ..radicals import is_radical
from .elements import HIGHEST_POWER
from .generators import NoNormalForm
from .size import size_multiplied_out

CORNERED = (sp.Piecewise, sp.Max, sp.Min, sp.Abs, sp.sign, sp.Heaviside)
_DEEPEST_LIST = 8
_MOST_TERMS = 1000  # of a sum or integral written out
_HIGHEST_DERIVATIVE = 10  # of functions: what the product rule makes of them doubles every time


@dataclass(frozen=True)
class Side:
    """Scalars row by row, and the shape they have: () for one, (rows, columns) for a matrix."""

    shape: tuple[int, ...]
    scalars: tuple[sp.Expr, ...]


def read_side(value: Any) -> Side:
    """Read one side of an equality exactly, without evaluating anything.

    Raises
    ------
    BadType, BadValue, NotExact
        For text, floats, equations, sets, iterators, ragged lists.

    Examples
    --------
    >>> read_side([[1, 2], [3, 4]]).shape
    (2, 2)
    """
    return _read(value, 0)


def _read(value: Any, depth: int) -> Side:
    if isinstance(value, sp.MatrixExpr) and not isinstance(value, sp.MatrixBase):
        value = _explicit(value)
    entries = as_list(value)
    if entries is None:
        return Side((), (_scalar(value),))
    if depth == _DEEPEST_LIST:
        raise BadType(f"lists at most {depth} deep", shown(value), "Flatten it.")
    sides = [_read(entry, depth + 1) for entry in entries]
    if len({side.shape for side in sides}) > 1:
        raise BadType("a list of entries of one kind", shown(value), "Make its rows equally long.")
    inner = sides[0].shape if sides else ()
    return Side((len(sides), *inner), tuple(s for side in sides for s in side.scalars))


def _scalar(value: Any) -> sp.Expr:
    if isinstance(value, Boolean) and not isinstance(value, sp.Expr):
        raise BadType("an expression", shown(value), "Give its left and right side separately.")
    return exact(value)


def _explicit(value: sp.MatrixExpr) -> sp.MatrixBase:
    try:
        # Multiplies explicit matrices, far faster than as_explicit, and leaves their entries alone.
        flat = value.doit(deep=False)
        whole = flat if isinstance(flat, sp.MatrixBase) else value.doit()
        return whole if isinstance(whole, sp.MatrixBase) else whole.as_explicit()
    except (MatrixError, ValueError, TypeError) as reason:
        raise BadType(
            "a matrix of known size that can be evaluated",
            f"{shown(value)} ({reason})",
            "Write its entries out.",
        ) from None


def evaluated(expression: sp.Expr, keep_operators: bool = True) -> sp.Expr:
    """Return an expression with its sums, integrals, derivatives and substitutions carried out.

    Symbols lose their assumptions first: they are matched by name. Derivatives and substitutions
    in rational functions stay, if they may: normal forms carry them out, far faster.

    Raises
    ------
    NoNormalForm
        Where carrying them out could take forever: long sums, integrals of no polynomial. Where it
        is not certain what is meant: integrals without limits, known only up to a constant. And
        for a symbol declared to be zero, since a witness would give it another value.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> evaluated(sp.Sum(t**2, (t, 1, 3)))
    14
    """
    nodes = list(postorder([expression]))
    symbols = {node for node in nodes if type(node) is sp.Symbol}
    zeros = [symbol for symbol in symbols if symbol.is_zero]
    if zeros:
        raise NoNormalForm(f"{zeros[0]} is declared to be zero: write 0")
    if any(symbol != sp.Symbol(symbol.name) for symbol in symbols):
        try:
            expression = by_name(expression)
        except (TypeError, ValueError):  # such as Idx, an index that has to be an integer
            raise NoNormalForm(
                f"{shown(expression, 60)} is nothing without what is assumed about its symbols"
            ) from None
        nodes = list(postorder([expression]))
    pending = [node for node in nodes if isinstance(node, tuple(_LIMITS))]
    keep_operators = keep_operators and all(map(is_operator, pending))
    for node in pending:
        _refuse_ambiguous(node, keep_operators)
    if not pending or keep_operators:
        return expression
    for node in pending:
        for kind, is_short in _LIMITS.items():
            if isinstance(node, kind) and not is_short(node):
                raise NoNormalForm(
                    f"{shown(node, 60)} is too long to be carried out, or not understood"
                )
    result = _carried_out(expression)
    try:
        return exact(result)
    except BadValue:
        raise NoNormalForm(f"{shown(expression, 60)} is {shown(result, 60)}") from None


def put_in(expressions: Iterable[sp.Expr], values: Mapping[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
    """Put values in for symbols; 1/(1 + 1/0) is not 0, as SymPy has it, but undefined.

    Raises
    ------
    NoNormalForm
        Where something on the way is not defined.
    """

    def change(old: sp.Basic, new: sp.Basic) -> sp.Basic:
        return _defined(values.get(old, new) if old.is_Symbol else new)

    return transformed(expressions, change)


def _defined(node: sp.Basic) -> sp.Basic:
    if node in (sp.nan, sp.zoo, sp.oo, -sp.oo):
        raise NoNormalForm("a side is not defined there")
    return node


def _carried_out(expression: sp.Expr) -> sp.Expr:
    """Carry out sums, integrals, derivatives and substitutions, the innermost ones first."""

    def change(_: sp.Basic, new: sp.Basic) -> sp.Basic:
        if isinstance(new, sp.Sum | sp.Product):
            ((index, start, end),) = new.limits
            values = range(int(start), int(end) + 1) if end >= start else ()
            terms = [put_in([new.function], {index: sp.Integer(k)})[0] for k in values]
            new = (sp.Add if isinstance(new, sp.Sum) else sp.Mul)(*terms)
        elif isinstance(new, sp.Subs) and not new.expr.has(sp.Derivative, sp.Subs):
            inner = new.expr
            for variable, point in zip(new.variables, new.point, strict=True):
                (inner,) = put_in([inner], {variable: point})
            new = inner
        elif any(isinstance(new, kind) for kind in _LIMITS):
            new = new.doit()
        return _defined(new)

    return transformed([expression], change)[0]


def _refuse_ambiguous(node: sp.Basic, keep_operators: bool) -> None:
    if isinstance(node, sp.Derivative) and has_corners([node.expr]):
        raise NoNormalForm("a derivative at break points is not understood")  # nor by SymPy
    if isinstance(node, sp.Subs) and not (
        _is_one_substitution(node) or (keep_operators and set(node.point) == set(node.variables))
    ):  # (an exchange of symbols is meant all at once)
        raise NoNormalForm(f"{shown(node, 60)} depends on what is put in first")
    if isinstance(node, sp.Integral) and any(len(limits) == 1 for limits in node.limits):
        raise NoNormalForm(f"{shown(node, 60)} is known only up to a constant")


def has_corners(expressions: Iterable[sp.Basic]) -> bool:
    """Tell whether some expression is made of pieces."""
    return any(isinstance(node, CORNERED) for node in postorder(expressions))


def is_operator(node: sp.Basic) -> bool:
    """Tell whether a node is a derivative, integral or substitution in a rational function."""
    if isinstance(node, sp.Derivative):
        inside, variables = [node.expr], node.variables
        if not _is_low_derivative(node, HIGHEST_POWER):
            return False
    elif isinstance(node, sp.Subs):
        inside, variables = [node.expr, *node.point], node.variables
    elif isinstance(node, sp.Integral) and [len(limits) for limits in node.limits] == [3]:
        inside, variables = [node.function, *node.limits[0][1:]], node.variables
    else:
        return False
    return all(variable.is_Symbol for variable in variables) and all(
        below.is_Rational or below.is_Symbol or operands(below) or is_radical(below)
        or isinstance(below, sp.Derivative | sp.Subs | sp.Integral)
        for below in postorder(inside, _inside)
    )  # fmt: skip


def _is_one_substitution(node: sp.Subs) -> bool:
    """Tell whether it is the same all at once (its printed form) and one by one (its `doit`).

    SymPy writes nested substitutions, which are one by one, as a single one.
    """
    return len(set(node.variables)) == len(node.variables) and not any(
        symbol in node.variables[i + 1 :]
        for i, point in enumerate(node.point)
        for symbol in point.free_symbols
    )


def operator_arguments(node: sp.Basic) -> tuple[sp.Basic, ...]:
    """Return what an operator works on, and after it the points or limits put in."""
    if isinstance(node, sp.Integral):
        return (node.function, *node.limits[0][1:])
    return (node.expr, *node.point) if isinstance(node, sp.Subs) else (node.expr,)


def _inside(node: sp.Basic) -> tuple[sp.Basic, ...]:
    if isinstance(node, sp.Derivative | sp.Subs | sp.Integral):
        return operator_arguments(node)
    return operands(node)


def _is_short_sum(node: sp.Sum | sp.Product) -> bool:
    lengths = [limit[2] - limit[1] if len(limit) == 3 else sp.oo for limit in node.limits]
    # Sums that run backwards are subtracted by some (SymPy), empty for others.
    return all(n.is_Integer and -1 <= n <= _MOST_TERMS for n in lengths) and len(lengths) == 1


def _is_low_derivative(node: sp.Derivative, highest: int = _HIGHEST_DERIVATIVE) -> bool:
    orders = [order for _, order in node.variable_count]
    return all(order.is_Integer for order in orders) and sum(orders) <= highest


def _is_polynomial_integral(node: sp.Integral) -> bool:
    if len(node.limits) != 1 or not node.function.is_polynomial(*node.variables):
        return False
    return size_multiplied_out(node.function, _MOST_TERMS) <= _MOST_TERMS


_LIMITS: dict[type, Callable[[Any], bool]] = {
    sp.Derivative: _is_low_derivative,
    sp.Subs: lambda node: True,
    sp.Sum: _is_short_sum,
    sp.Product: _is_short_sum,
    sp.Integral: _is_polynomial_integral,
}

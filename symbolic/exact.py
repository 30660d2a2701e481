"""Reading numbers and points exactly: rationals stay rationals, floats and text are refused."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from numbers import Rational, Real
from operator import index
from typing import Any

import sympy as sp

from .dag import postorder, substitute, symbols_in
from .errors import BadType, BadValue, NotExact, shown

PARAMETER = sp.Symbol("t")
"""The parameter of every curve."""

Point = tuple[sp.Expr, ...]
_NOT_FINITE = frozenset((sp.nan, sp.oo, -sp.oo, sp.zoo))


def exact(value: Any) -> sp.Expr:
    """Return a number or SymPy expression exactly as a SymPy expression.

    Parameters
    ----------
    value : int, Fraction, finite Decimal, NumPy integer, or SymPy expression without floats

    Raises
    ------
    NotExact
        For floats, with the fraction that was probably meant.
    BadType, BadValue
        For text (it is never parsed), other types, and for NaN or infinity.

    Examples
    --------
    >>> exact(Fraction(1, 3)), exact(Decimal("0.25"))
    (1/3, 1/4)
    """
    if isinstance(value, sp.Expr) and not isinstance(value, sp.MatrixExpr):
        return _finite_and_exact(value)
    if hasattr(value, "item") and getattr(value, "shape", None) == ():
        value = value.item()  # zero-dimensional NumPy arrays and NumPy scalars
    if isinstance(value, str | bytes):
        raise BadType(
            "a number or a SymPy expression",
            shown(value),
            "Text is never parsed: write Rational(1, 10), or a Symbol.",
        )
    if whole_number(value) is not None:
        return sp.Integer(whole_number(value))
    if isinstance(value, Rational) and not isinstance(value, bool):
        return sp.Rational(int(value.numerator), int(value.denominator))
    if isinstance(value, Decimal) and value.is_finite():
        return exact(Fraction(value))
    if isinstance(value, Decimal):
        _refuse_float(float("nan"))
    if isinstance(value, Real) and not isinstance(value, bool):
        _refuse_float(float(value))
    raise BadType("a number or a SymPy expression", shown(value), "Use int, Fraction or Rational.")


def exact_points(points: Any) -> tuple[Point, ...]:
    """Return control points as a tuple of rows of exact coordinates, shape (n, dim).

    Lists, tuples, integer arrays and SymPy matrices are accepted; every row is one point.

    Raises
    ------
    BadValue
        For no points, ragged rows, or a flat list of numbers.
    BadType, NotExact
        As in `exact`.

    Examples
    --------
    >>> exact_points([[0, 1], (Fraction(1, 2), 2)])
    ((0, 1), (1/2, 2))
    """
    rows = [_row(row) for row in _rows(points)]
    if not rows or not rows[0]:
        raise BadValue("at least one control point", "none", "Give rows like [[0, 0], [1, 2]].")
    sizes = {len(row) for row in rows}
    if len(sizes) > 1:
        raise BadValue(
            "control points of one dimension",
            f"rows with {' and '.join(map(str, sorted(sizes)))} coordinates",
            "Give every point the same number of coordinates.",
        )
    return tuple(rows)


def control_points(points: Any) -> tuple[Point, ...]:
    """Return the control points of a curve in t: exact rows that do not contain t themselves.

    Raises
    ------
    BadValue
        As in `exact_points`, and for points that contain t.

    Examples
    --------
    >>> control_points([[0, sp.Symbol("a")]])
    ((0, a),)
    """
    rows = exact_points(points)
    if any(symbol.name == PARAMETER.name for symbol in symbols_in(x for row in rows for x in row)):
        raise BadValue(
            f"control points without the curve's own parameter {PARAMETER}",
            shown(points),
            "Call it by another name.",
        )
    return rows


def _finite_and_exact(value: sp.Expr) -> sp.Expr:
    for node in postorder([value]):
        if node.is_Float:
            _refuse_float(float(node))
        if node in _NOT_FINITE:
            raise BadValue("a finite number", shown(value), "Leave such values out.")
    return value


def _refuse_float(value: float) -> None:
    if value != value or value in (float("inf"), float("-inf")):
        raise BadValue("a finite number", shown(value), "Leave such values out.")
    meant = Fraction(value).limit_denominator(1000)  # 1/3 rather than 0.3333333333333333
    if float(meant) != value:
        meant = Fraction(repr(value))
    parts = f"({meant.numerator}, {meant.denominator})"
    hint = f"Rational{parts} or Fraction{parts}"
    if meant.denominator == 1:
        hint = str(meant)
    raise NotExact("an exact number", f"the float {value!r}", f"Write {hint}.")


def by_name(expression: sp.Expr) -> sp.Expr:
    """Return an expression whose symbols have no assumptions: they are matched by name.

    >>> by_name(sp.Symbol("x", positive=True) + 1) == sp.Symbol("x") + 1
    True
    """
    symbols = [node for node in postorder([expression]) if type(node) is sp.Symbol]
    plain = {s: sp.Symbol(s.name) for s in symbols if s.is_commutative}  # a matrix stays one
    return substitute([expression], plain)[0]


def as_list(value: Any) -> list[Any] | None:
    """Return the entries of a list, tuple, array or matrix (row by row); None for anything else.

    Sets and dictionaries have no order, and an iterator can be read only once: they are no lists.

    >>> as_list(sp.Matrix([[1, 2], [3, 4]])), as_list({1, 2})
    ([[1, 2], [3, 4]], None)
    """
    if isinstance(value, list | tuple | range | sp.Tuple):
        return list(value)
    if isinstance(value, sp.Point):
        return list(value.args)
    if hasattr(value, "tolist") and getattr(value, "shape", ()) != ():  # SymPy's and NumPy's arrays
        return list(value.tolist())
    return None


def whole_number(value: Any) -> int | None:
    """Return an int, NumPy or SymPy integer as an int; None for anything else.

    >>> whole_number(sp.Integer(3)), whole_number(3.0), whole_number(True)
    (3, None, None)
    """
    if isinstance(value, bool):
        return None
    try:
        return index(value)
    except TypeError:
        return None


def _rows(points: Any) -> list[Any]:
    rows = as_list(points)
    if rows is None:
        raise BadType(
            "control points as a list of rows",
            shown(points),
            "Give rows like [[0, 0], [1, 2], [3, 0]].",
        )
    return rows


def _row(row: Any) -> Point:
    coordinates = as_list(row)
    if coordinates is None:
        raise BadValue(
            "every control point as a row of coordinates",
            f"the bare coordinate {exact(row)}",
            "Write [[0], [1], [3]] for points on a line, [[0, 0], [1, 2]] in the plane.",
        )
    return tuple(exact(coordinate) for coordinate in coordinates)

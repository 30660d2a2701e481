"""Mathematics as one line of text that a screen reader can speak."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import sympy as sp
from sympy.printing.str import StrPrinter

from ..errors import written
from ..exact import as_list

_RELATIONS = {"<=": "at most", ">=": "at least", "<": "less than", ">": "greater than",
              "==": "equal to", "!=": "different from"}  # fmt: skip


def linear_text(side: Any) -> str:
    """Return a side of an equality as one line: products without stars, matrices by rows.

    >>> t, n, i = sp.symbols("t n i")
    >>> linear_text(3*t**2*(1 - t)/2), linear_text(sp.Mul(1 - t, 2, 3, evaluate=False))
    ('3 t^2 (1 - t)/2', '(1 - t) times 2 times 3')
    >>> linear_text(sp.Subs(sp.Derivative(t**2, t), t, 1))
    'd/dt (t^2) at t = 1'
    >>> linear_text(sp.ImmutableMatrix([[1, t], [0, 1]]))
    'the matrix with rows (1, t), (0, 1)'
    >>> linear_text(sp.Sum(t**i, (i, 0, n)) - 1)
    '(the sum from i = 0 to n of t^i) - 1'
    >>> linear_text(sp.Piecewise((t, t < 1), (1, True)))
    't if t is less than 1, else 1'
    """
    if isinstance(side, sp.MatrixExpr | sp.Expr) or not (entries := as_list(side)):
        return _spoken(side)
    if isinstance(side, sp.MatrixBase):
        return _matrix(side.tolist())
    return f"({', '.join(map(linear_text, entries))})"


def _spoken(expression: Any) -> str:
    printer = StrPrinter()
    for kind, words in _WORDS.items():
        # SymPy's printers look their methods up by the name of the class.
        setattr(printer, f"_print_{kind}", _within(printer, words))
    text = written(expression, printer.doprint)
    powers = text.replace("**", "^")
    return re.sub(r"\*(?=-?\d)", " times ", powers).replace("*", " ")


def _within(printer: Any, words: Callable[[Any], str]) -> Callable[[Any], str]:
    def method(expression: Any) -> str:
        text = words(expression)
        return text if printer._print_level == 1 else f"({text})"

    return method


def _matrix(rows: list[list[Any]]) -> str:
    texts = [f"({', '.join(map(linear_text, row))})" for row in rows]
    if len(rows) == 1:
        return f"the row {texts[0]}"
    if rows and len(rows[0]) == 1:
        return f"the column ({', '.join(linear_text(row[0]) for row in rows)})"
    return f"the matrix with rows {', '.join(texts)}"


def _substitution(node: sp.Subs) -> str:
    pairs = zip(node.variables, node.point, strict=True)
    places = ", ".join(f"{v} = {linear_text(p)}" for v, p in pairs)
    return f"{linear_text(node.expr)} at {places}"


def _derivative(node: sp.Derivative) -> str:
    parts = []
    for variable, order in node.variable_count:
        power = "" if order == 1 else f"^{order}"
        parts.append(f"d{power}/d{variable}{power}")
    return f"{' '.join(parts)} ({linear_text(node.expr)})"


def _over_limits(word: str) -> Callable[[Any], str]:
    def text(node: Any) -> str:
        ranges = [
            f"from {v} = {linear_text(ends[0])} to {linear_text(ends[1])}"
            if len(ends) == 2
            else f"over {v}"
            for v, *ends in node.limits
        ]
        return f"the {word} {' and '.join(ranges)} of {linear_text(node.function)}"

    return text


def _piecewise(node: sp.Piecewise) -> str:
    return ", ".join(
        f"else {linear_text(value)}" if condition == sp.true
        else f"{linear_text(value)} if {_condition(condition)}"
        for value, condition in node.args
    )  # fmt: skip


def _condition(condition: Any) -> str:
    if isinstance(condition, sp.And | sp.Or):
        word = " and " if isinstance(condition, sp.And) else " or "
        return word.join(map(_condition, condition.args))
    words = _RELATIONS.get(getattr(condition, "rel_op", ""))
    if words is None:
        return written(condition)
    return f"{linear_text(condition.lhs)} is {words} {linear_text(condition.rhs)}"


_WORDS: dict[str, Callable[[Any], str]] = {
    "Subs": _substitution,
    "Derivative": _derivative,
    "Integral": _over_limits("integral"),
    "Sum": _over_limits("sum"),
    "Product": _over_limits("product"),
    "Piecewise": _piecewise,
    "MatMul": lambda node: " times ".join(map(linear_text, node.args)),
    "MatAdd": lambda node: " plus ".join(map(linear_text, node.args)),
    "MatrixBase": lambda node: _matrix(node.tolist()),
    "Abs": lambda node: f"the absolute value of {linear_text(node.args[0])}",
}

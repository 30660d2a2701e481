"""How large an expression becomes when it is multiplied out or printed, told without doing it."""

from __future__ import annotations

from math import comb, prod

import sympy as sp

from ..dag import postorder
from ..errors import shown
from ..fields import operands

_LONGEST_NAME = 200


def size_multiplied_out(expression: sp.Expr, limit: int) -> int:
    """Return a bound for the number of symbols and numbers then, or something above the limit.

    >>> x, y = sp.symbols("x y")
    >>> size_multiplied_out((x + y)**2 * (1 + x), 100), size_multiplied_out((1 + x)**500, 100)
    (6, 101)
    """
    sizes: dict[int, int] = {}
    for node in postorder([expression]):
        below = [sizes[id(argument)] for argument in node.args]
        if node.is_Mul:
            size = prod(below)
        elif node.is_Pow and operands(node):
            power = min(abs(int(node.exp)), limit)
            size = comb(below[0] + power - 1, power)
        else:
            size = sum(below)
        sizes[id(node)] = min(max(size, 1), limit + 1)
    return sizes[id(expression)]


def named(expression: sp.Expr) -> str:
    """Return an expression as text, or in words if it prints at great length (shared parts do).

    >>> x = sp.Symbol("x")
    >>> named(sp.sin(x)), named(sp.exp(sp.Add(*sp.symbols("x:300"))))
    ('sin(x)', 'exp(...)')
    """
    sizes: dict[int, int] = {}
    for node in postorder([expression]):
        sizes[id(node)] = 1 + sum(sizes[id(argument)] for argument in node.args)
    if sizes[id(expression)] <= _LONGEST_NAME:
        return shown(expression, _LONGEST_NAME)
    return f"{type(expression).__name__}(...)"

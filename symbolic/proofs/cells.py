"""Open intervals of the real line between exact numbers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cmp_to_key

import sympy as sp

from ..errors import shown, written
from ..signs import sign
from .generators import NoNormalForm


@dataclass(frozen=True)
class Cell:
    """The real numbers between two rational or algebraic ones; None is infinity.

    >>> print(Cell(None, sp.sqrt(2)), Cell(sp.sqrt(2), sp.sqrt(3)).inside())
    (-oo, sqrt(2)) 3/2
    """

    low: sp.Expr | None = None
    high: sp.Expr | None = None

    def inside(self) -> sp.Rational:
        """Return a rational number of the cell, with a small denominator."""
        if self.low is None:
            return sp.Integer(0) if self.high is None else sp.ceiling(self.high) - 1
        if self.high is None:
            return sp.floor(self.low) + 1
        parts = 1
        while True:
            number = (sp.floor(self.low * parts) + 1) / sp.Integer(parts)
            if certain_sign(self.high - number) == 1:
                return number
            parts *= 2

    def window(self) -> tuple[sp.Rational, sp.Rational]:
        """Return rational numbers between which everything belongs to the cell."""
        middle = self.inside()
        low = middle - 1 if self.low is None else self.low
        high = middle + 1 if self.high is None else self.high
        if not low.is_Rational:
            low = Cell(low, middle).inside()
        if not high.is_Rational:
            high = Cell(middle, high).inside()
        return low, high

    def holds(self, number: sp.Expr) -> bool:
        """Tell whether a number lies in the cell, its ends not included."""
        return (self.low is None or certain_sign(number - self.low) == 1) and (
            self.high is None or certain_sign(self.high - number) == 1
        )

    def cut(self, numbers: Iterable[sp.Expr]) -> tuple[list[sp.Expr], list[Cell]]:
        """Return the numbers inside in order, each once, and the n + 1 cells they leave.

        >>> print(*Cell(0, 2).cut([sp.Integer(1), sp.Integer(5), sp.Integer(1)])[1])
        (0, 1) (1, 2)
        """
        ordered = sorted(numbers, key=cmp_to_key(_order))
        different: list[sp.Expr] = []
        for number in ordered:
            if self.holds(number) and (not different or certain_sign(number - different[-1])):
                different.append(number)
        ends = [self.low, *different, self.high]
        return different, [Cell(a, b) for a, b in zip(ends, ends[1:], strict=False)]

    def __str__(self) -> str:
        low = "-oo" if self.low is None else written(self.low)
        return f"({low}, {'oo' if self.high is None else written(self.high)})"


def certain_sign(number: sp.Expr) -> int:
    """Return the sign of a real number; `NoNormalForm` if it is not known."""
    found = sign(number)
    if found is None:
        raise NoNormalForm(f"the sign of {shown(number, 60)} is not known")
    return found


def _order(left: sp.Expr, right: sp.Expr) -> int:
    return certain_sign(left - right)

"""Which of two exact numbers is larger: decided, never guessed."""

from __future__ import annotations

import sympy as sp

from .fields import common_field


def sign(number: sp.Expr) -> int | None:
    """Return -1, 0 or 1 for a real number made of rationals and roots, None where symbols decide.

    Zero is recognised in the algebraic field of the roots; only then is a value computed.

    Raises
    ------
    BadValue
        For functions, and division by zero, as in `common_field`.

    Examples
    --------
    >>> sign(sp.sqrt(2) + sp.sqrt(3) - 3), sign(sp.sqrt(2)*sp.sqrt(3) - sp.sqrt(6))
    (1, 0)
    >>> sign(sp.Symbol("a")), sign(sp.Symbol("a") - sp.Symbol("a"))
    (None, 0)
    """
    if number.is_Rational:
        return (number.p > 0) - (number.p < 0)
    _, (element,) = common_field([number])
    if not element:
        return 0
    if number.free_symbols:
        return None
    value = number.evalf(30)
    return None if not value.is_Float else (1 if value > 0 else -1)

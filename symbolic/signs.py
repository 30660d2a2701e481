"""Which of two exact numbers is larger: decided, never guessed."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from .fields import common_field
from .intervals import enclosure


def sign(number: sp.Expr) -> int | None:
    """Return -1, 0 or 1 for a real number made of rationals and roots, None where symbols decide.

    Zero is recognised by the algebra of the roots; only then is the number enclosed, closer and
    closer, until its sign is certain.

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
    field, (element,) = common_field([number])
    if not element:
        return 0
    if number.free_symbols:
        return None
    if _is_hidden_zero(field, element):
        return 0
    for digits in (30, 300, 3000):
        box = enclosure(number, digits=digits)
        if box is None or 0 not in box:
            return None if box is None else (1 if box > 0 else -1)
    return None


def _is_hidden_zero(field: Domain, element: Any) -> bool:
    """Tell whether a rational function of free roots p**(1/n) is zero once they are multiplied out.

    Roots of different primes are independent, so it is zero only if every coefficient is.
    """
    if not field.is_FractionField:
        return False
    reduced: dict[tuple[int, ...], Any] = {}
    for monomial, coefficient in element.numer.terms():
        exponents = []
        for root, exponent in zip(field.symbols, monomial, strict=True):
            whole, rest = divmod(exponent, int(root.exp.q))
            coefficient *= field.domain.from_sympy(root.base**whole)
            exponents.append(rest)
        key = tuple(exponents)
        reduced[key] = reduced.get(key, field.domain.zero) + coefficient
    return not any(reduced.values())

"""Which of two exact numbers is larger: decided, never guessed."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from .fields import common_field
from .intervals import enclosure


def sign(number: sp.Expr) -> int | None:
    """Return -1, 0 or 1 for a real number made of rationals and roots, None where symbols decide.

    The number is enclosed in an interval; where that could be zero, the algebra of the roots
    decides whether it is, and if not it is enclosed closer and closer.

    Raises
    ------
    BadValue
        For functions that may be zero, and division by zero, as in `common_field`.

    Examples
    --------
    >>> sign(sp.sqrt(2) + sp.sqrt(3) - 3), sign(sp.sqrt(2)*sp.sqrt(3) - sp.sqrt(6))
    (1, 0)
    >>> sign(sp.Symbol("a")), sign(sp.Symbol("a") - sp.Symbol("a"))
    (None, 0)
    """
    if number.is_Rational:
        return (number.p > 0) - (number.p < 0)
    found = _clear_sign(number, 30)
    if found is not None:
        return found
    field, (element,) = common_field([number])
    if not element or _is_hidden_zero(field, element):
        return 0
    if number.free_symbols:
        return None
    found = _clear_sign(number, 300)
    return found if found is not None else _clear_sign(number, 3000)


def _clear_sign(number: sp.Expr, digits: int) -> int | None:
    box = enclosure(number, digits=digits)
    return None if box is None or 0 in box else (1 if box > 0 else -1)


def _is_hidden_zero(field: Domain, element: Any) -> bool:
    """Tell whether a rational function of free roots p**(1/n) is zero once they are multiplied out.

    Roots of different primes are independent, so it is zero only if every coefficient is.
    """
    if not field.is_FractionField:
        return False
    reduced: dict[tuple[int, ...], Any] = {}
    for monomial, coefficient in element.numer.terms():
        exponents = []
        for generator, exponent in zip(field.symbols, monomial, strict=True):
            if not generator.is_Symbol:
                base, power = generator.as_base_exp()
                whole, exponent = divmod(exponent, int(power.q))
                coefficient *= field.domain.from_sympy(base**whole)
            exponents.append(exponent)
        key = tuple(exponents)
        reduced[key] = reduced.get(key, field.domain.zero) + coefficient
    return not any(reduced.values())

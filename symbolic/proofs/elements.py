"""Computing with elements of a polynomial ring and of its fraction field, within limits.

An element is a polynomial as long as nothing but numbers divides it; SymPy lets both kinds meet.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from operator import add, mul
from typing import Any

import sympy as sp

from ..errors import shown
from .generators import NoNormalForm

# Limits, so that a short text cannot keep a reader waiting for longer than a few seconds.
HIGHEST_POWER = 512
MOST_PRODUCTS = 300_000  # of terms in one multiplication of polynomials
MOST_PRODUCTS_OF_FRACTIONS = 3_000  # every operation there looks for a common divisor
MOST_BITS = 100_000  # of a coefficient

Relations = Mapping[int, tuple[int, Any]]
"""The position of a generator g to (n, base) with g^n = base."""


def parts(element: Any) -> tuple[Any, ...]:
    """Return numerator and denominator, or a polynomial alone."""
    return (element.numer, element.denom) if hasattr(element, "numer") else (element,)


def divided(numer: Any, denom: Any) -> Any:
    """Return the quotient of two elements, a polynomial if the divisor is a number."""
    if not denom:
        raise NoNormalForm("a denominator is identically zero")
    if not hasattr(denom, "numer"):
        if denom.is_ground:
            return numer * (1 / denom.LC)
        denom = denom.ring.to_field().raw_new(denom)
    return plain(numer / denom)


def plain(element: Any) -> Any:
    """Return a fraction as the polynomial that it is, if its denominator is a number."""
    if hasattr(element, "numer") and element.denom.is_ground:
        return element.numer * (1 / element.denom.LC)
    return element


def used(element: Any) -> set[int]:
    """Return the positions of the generators that occur in an element."""
    found = {i for part in parts(element) for m in part for i, e in enumerate(m) if e}
    return found


def folded(operation: Callable[[Any, Any], Any], operands: Sequence[Any]) -> Any:
    """Add or multiply one after the other, as long as the result stays within the limits."""
    result = operands[0]
    for operand in operands[1:]:
        fractions = hasattr(result, "numer") or hasattr(operand, "numer")
        products = _size(result) * _size(operand)
        if products > (MOST_PRODUCTS_OF_FRACTIONS if fractions else MOST_PRODUCTS) and (
            fractions or operation is not add
        ):
            raise NoNormalForm("it has too many terms to expand")
        result = operation(result, operand)
    return result


def power(base: Any, exponent: int, relations: Relations) -> Any:
    """Return base**exponent, reduced."""
    if abs(exponent) > HIGHEST_POWER:
        raise NoNormalForm(f"the power {shown(exponent, 40)} is too high to expand")
    if exponent < 0:
        base, exponent = divided(_one(base), reduced(base, relations)), -exponent
    if exponent * _bits(base) > MOST_BITS:
        raise NoNormalForm("its numbers have too many digits")
    if exponent == 0:
        return _one(base)  # also for the base 0, as SymPy has it

    def times(left: Any, right: Any) -> Any:
        return reduced(left * right, relations)

    result = base
    for bit in bin(exponent)[3:]:
        result = folded(times, [result, result])
        result = folded(times, [result, base]) if bit == "1" else result
    return result


def reduced(element: Any, relations: Relations) -> Any:
    """Return the element with g^n = base used until no power of a bound generator is too high."""
    for position, (order, base) in reversed(list(relations.items())):
        if all(m[position] < order for part in parts(element) for m in part):
            continue
        quotient = [_lowered(part, position, order, base) for part in parts(element)]
        element = divided(*quotient) if len(quotient) == 2 else quotient[0]
    return element


def _lowered(polynomial: Any, position: int, order: int, base: Any) -> Any:
    groups: dict[int, dict[tuple[int, ...], Any]] = {}
    for monomial, coefficient in polynomial.items():
        times, rest = divmod(monomial[position], order)
        lower = (*monomial[:position], rest, *monomial[position + 1 :])
        groups.setdefault(times, {})[lower] = coefficient
    return _sum_of_products(polynomial, {(k,): g for k, g in groups.items()}, [base])


def composed(element: Any, at: Mapping[int, Any]) -> Any:
    """Return the element with other elements put for some generators, all at once."""
    if not at:
        return element
    values = [_composed(part, at) for part in parts(element)]
    if len(values) == 2 and not values[1]:
        raise NoNormalForm("a side is not defined where something is substituted")
    return divided(*values) if len(values) == 2 else values[0]


def _composed(polynomial: Any, at: Mapping[int, Any]) -> Any:
    groups: dict[tuple[int, ...], dict[tuple[int, ...], Any]] = {}
    for monomial, coefficient in polynomial.items():
        exponents = tuple(monomial[i] for i in at)
        rest = tuple(0 if i in at else e for i, e in enumerate(monomial))
        groups.setdefault(exponents, {})[rest] = coefficient
    return _sum_of_products(polynomial, groups, list(at.values()))


def _sum_of_products(
    like: Any, groups: Mapping[tuple[int, ...], dict[tuple[int, ...], Any]], bases: Sequence[Any]
) -> Any:
    """Add up the polynomials of all groups, times the bases to the powers in its key."""
    powers: dict[tuple[int, int], Any] = {}
    terms = [like.ring.zero]
    for exponents, group in groups.items():
        factors = [like.ring.from_dict(group)]
        for i, exponent in enumerate(exponents):
            if exponent and (i, exponent) not in powers:
                powers[i, exponent] = power(bases[i], exponent, {})
            if exponent:
                factors.append(powers[i, exponent])
        terms.append(folded(mul, factors))
    return folded(add, terms)


def differentiated(element: Any, position: int) -> Any:
    """Return the derivative by one generator, of a quotient by the quotient rule."""
    numer, *denom = parts(element)
    generator = numer.ring.gens[position]
    if not denom:
        return numer.diff(generator)
    left, right = numer.diff(generator), denom[0].diff(generator)
    top = folded(mul, [left, denom[0]]) - folded(mul, [numer, right])
    return divided(top, power(denom[0], 2, {}))


def integrated(element: Any, position: int) -> Any:
    """Return the antiderivative by one generator, zero at zero, of what is a polynomial in it."""
    numer, *denom = parts(element)
    raised = {}
    for monomial, coefficient in numer.items():
        power_of_it = monomial[position] + 1
        key = (*monomial[:position], power_of_it, *monomial[position + 1 :])
        raised[key] = coefficient / power_of_it
    antiderivative = numer.ring.from_dict(raised)
    return divided(antiderivative, denom[0]) if denom else antiderivative


def _one(element: Any) -> Any:
    return element.numer.ring.one if hasattr(element, "numer") else element.ring.one


def _size(element: Any) -> int:
    return sum(len(part) for part in parts(element))


def _bits(element: Any) -> int:
    """Return the length of the longest coefficient."""
    numbers = [c for part in parts(element) for c in part.values()]
    return max((max(abs(int(c.numerator)), int(c.denominator)).bit_length() for c in numbers),
               default=0)  # fmt: skip


def value_of(element: Any, expressions: Sequence[sp.Expr]) -> sp.Expr:
    """Return an element as an expression, with these in place of the generators."""
    sums = [
        sp.Add(*(sp.Rational(int(c.numerator), int(c.denominator))
                 * sp.Mul(*(g**e for g, e in zip(expressions, m, strict=False) if e))
                 for m, c in part.terms()))
        for part in parts(element)
    ]  # fmt: skip
    return sums[0] / sums[1] if len(sums) == 2 else sums[0]

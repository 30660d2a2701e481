"""Roots of rational numbers in terms of roots of primes, which know no hidden relations.

sqrt(6) is sqrt(2) sqrt(3), and 12**(1/4) is 3**(1/4) sqrt(2): real roots of different primes are
independent (Besicovitch 1940, "On the linear independence of fractional powers of integers"), so
Q(2^(1/a), 3^(1/b), ...) has the degree a b ... and its elements have one form each.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import gcd, lcm

import sympy as sp

from .dag import postorder, transformed
from .intervals import enclosure

_LARGEST_TRIAL_DIVISOR = 10_000


def is_radical(node: sp.Basic) -> bool:
    """Tell whether an expression is a root of a rational number, such as sqrt(2) or I."""
    if node is sp.I:
        return True
    if not (node.is_Pow and node.base.is_Rational and node.exp.is_Rational):
        return False
    return bool(node.base) and not node.exp.is_Integer


def is_nested_root(node: sp.Basic) -> bool:
    """Tell whether an expression is a root of a number that contains roots itself.

    >>> is_nested_root(sp.sqrt(2 + sp.sqrt(2))), is_nested_root(sp.sqrt(2))
    (True, False)
    """
    if not (node.is_Pow and node.exp.is_Rational) or node.exp.is_Integer or node.base.is_Rational:
        return False
    return all(
        leaf.is_Rational or is_radical(leaf) or leaf.is_Add or leaf.is_Mul or leaf.is_Pow
        for leaf in postorder([node])
    )


def prime_roots(radical: sp.Expr) -> tuple[sp.Rational, dict[int, sp.Rational]]:
    """Split a root of a rational number into a rational and powers of primes, 0 < exponent < 1.

    The base -1 stands for e^(i pi): SymPy means principal values, so (-2)**(1/3) is
    (-1)**(1/3) * 2**(1/3). Of huge numbers only small primes are split off.

    >>> prime_roots(sp.sqrt(6)), prime_roots(sp.Integer(12)**sp.Rational(1, 5))
    ((1, {2: 1/2, 3: 1/2}), (1, {2: 2/5, 3: 1/5}))
    >>> prime_roots(sp.Pow(-8, sp.Rational(2, 3), evaluate=False))
    (4, {-1: 2/3})
    """
    return roots_of(radical, (prime for part in _parts(radical) for prime, _ in _factors(part)))


def roots_of(radical: sp.Expr, bases: Iterable[int]) -> tuple[sp.Rational, dict[int, sp.Rational]]:
    """Split a root of a rational into a rational and powers of bases, of which it is a product.

    >>> roots_of(sp.sqrt(15), [3, 5]), roots_of(sp.sqrt(15), [15])
    ((1, {3: 1/2, 5: 1/2}), (1, {15: 1/2}))
    """
    base, exponent = _base_and_exponent(radical)
    powers = {b: (_multiplicity(b, base.p) - _multiplicity(b, base.q)) * exponent for b in bases}
    if base < 0:
        powers[-1] = exponent % 2
    rational = sp.S.One
    for b, power in powers.items():
        rational *= sp.Integer(b) ** sp.floor(power)
    return rational, {b: e % 1 for b, e in powers.items() if e % 1}


def orders(radicals: Iterable[sp.Expr]) -> dict[int, int]:
    """Return for every prime the order n of the root p**(1/n) in which all radicals are powers.

    >>> orders([sp.sqrt(6), sp.cbrt(2)])
    {2: 6, 3: 2}
    """
    return _orders(prime_roots(radical) for radical in radicals)


def coprime_orders(radicals: Iterable[sp.Expr]) -> dict[int, int]:
    """Return as few bases b as a common divisor can tell, and the orders of their roots b**(1/n).

    Different bases have no common factor and are no perfect powers, so their roots are independent
    like those of primes; sqrt(465) alone needs one root, not those of 3, 5 and 31.

    >>> coprime_orders([sp.sqrt(465)]), coprime_orders([sp.sqrt(6), sp.sqrt(10)])
    ({465: 2}, {2: 2, 3: 2, 5: 2})
    """
    listed = list(radicals)
    bases = _coprime_bases(part for radical in listed for part in _parts(radical))
    return _orders(roots_of(radical, bases) for radical in listed)


def _orders(split: Iterable[tuple[sp.Rational, dict[int, sp.Rational]]]) -> dict[int, int]:
    found: dict[int, int] = {}
    for _, powers in split:
        for base, exponent in powers.items():
            found[base] = lcm(found.get(base, 1), int(exponent.q))
    return dict(sorted(found.items()))


def _base_and_exponent(radical: sp.Expr) -> tuple[sp.Rational, sp.Rational]:
    return (sp.S.NegativeOne, sp.S.Half) if radical is sp.I else radical.args


def _parts(radical: sp.Expr) -> tuple[int, int]:
    base, _ = _base_and_exponent(radical)
    return abs(int(base.p)), int(base.q)


def _multiplicity(base: int, number: int) -> int:
    return sp.multiplicity(base, number) if base > 1 else 0


def _coprime_bases(numbers: Iterable[int]) -> tuple[int, ...]:
    """Return pairwise coprime numbers, no perfect powers, of which all the numbers are products."""
    bases: list[int] = []
    waiting = list(numbers)
    while waiting:
        number = waiting.pop()
        if number == 1:
            continue
        power = sp.perfect_power(number, factor=False)
        if power:
            waiting.append(int(power[0]))
            continue
        known = next((b for b in bases if gcd(b, number) > 1), None)
        if known is None:
            bases.append(number)
        elif known != number:
            common = gcd(known, number)
            bases.remove(known)
            waiting += [common, known // common, number // common]
    return tuple(bases)


def plain_roots(expressions: Iterable[sp.Expr]) -> list[sp.Expr]:
    """Write roots of -1 with cos and sin, and nested square roots as sums, where radicals suffice.

    >>> plain_roots([sp.Pow(-1, sp.Rational(1, 3)), sp.sqrt(5 + 2*sp.sqrt(6))])
    [1/2 + sqrt(3)*I/2, sqrt(2) + sqrt(3)]
    """
    return transformed(expressions, _plain_or_same)


def _plain_or_same(_: sp.Basic, node: sp.Basic) -> sp.Basic:
    if not (node.is_Pow and node.exp.is_Rational) or node.exp.is_Integer:
        return node
    plain = _plain(node)
    # What is remembered may be equal but another object, and whatever is built from another object
    # is evaluated anew by SymPy: 0*(1/x) would lose its divisor.
    return node if plain == node else plain


@lru_cache(maxsize=1024)
def _plain(node: sp.Pow) -> sp.Expr:
    base, exponent = node.args
    if base == -1 and exponent.q in (3, 4, 6):
        return sp.cos(sp.pi * exponent) + sp.I * sp.sin(sp.pi * exponent)
    if exponent.q == 2 and not base.is_Rational and _is_small_number(base):
        root = sp.sqrtdenest(sp.sqrt(base))
        value = enclosure(root)  # SymPy is not trusted: the root is squared, and its sign looked at
        if root != sp.sqrt(base) and value and value > 0 and sp.expand(root**2 - base) == 0:
            return root ** (2 * exponent)
    return node


def _is_small_number(base: sp.Expr) -> bool:
    terms = sp.Add.make_args(base)
    return len(terms) <= 4 and all(
        factor.is_Rational or (is_radical(factor) and factor is not sp.I)
        for term in terms
        for factor in sp.Mul.make_args(term)
    )


@lru_cache(maxsize=1024)
def _factors(number: int) -> tuple[tuple[int, int], ...]:
    found = sp.factorint(
        number, limit=_LARGEST_TRIAL_DIVISOR, use_rho=False, use_pm1=False, use_ecm=False
    )
    return tuple((int(prime), int(count)) for prime, count in found.items())

"""Roots of rational numbers in terms of roots of primes, which know no hidden relations.

sqrt(6) is sqrt(2) sqrt(3), and 12**(1/4) is 3**(1/4) sqrt(2): real roots of different primes are
independent (Besicovitch 1940, "On the linear independence of fractional powers of integers"), so
Q(2^(1/a), 3^(1/b), ...) has the degree a b ... and its elements have one form each.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import lcm

import sympy as sp

from .dag import transformed
from .intervals import enclosure

_LARGEST_TRIAL_DIVISOR = 10_000


def is_radical(node: sp.Basic) -> bool:
    """Tell whether an expression is a root of a rational number, such as sqrt(2) or I."""
    if node is sp.I:
        return True
    if not (node.is_Pow and node.base.is_Rational and node.exp.is_Rational):
        return False
    return bool(node.base) and not node.exp.is_Integer


def prime_roots(radical: sp.Expr) -> tuple[sp.Rational, dict[int, sp.Rational]]:
    """Split a root of a rational number into a rational and powers of primes, 0 < exponent < 1.

    The base -1 stands for e^(i pi): SymPy means principal values, so (-2)**(1/3) is
    (-1)**(1/3) * 2**(1/3). Of huge numbers only small primes are split off.

    >>> prime_roots(sp.sqrt(6)), prime_roots(sp.Integer(12)**sp.Rational(1, 5))
    ((1, {2: 1/2, 3: 1/2}), (1, {2: 2/5, 3: 1/5}))
    >>> prime_roots(sp.Pow(-8, sp.Rational(2, 3), evaluate=False))
    (4, {-1: 2/3})
    """
    base, exponent = (sp.S.NegativeOne, sp.S.Half) if radical is sp.I else radical.args
    powers: dict[int, sp.Rational] = {}
    for part, direction in ((abs(base.p), 1), (base.q, -1)):
        for prime, count in _factors(int(part)):
            powers[prime] = powers.get(prime, sp.S.Zero) + direction * count * exponent
    if base < 0:
        powers[-1] = exponent % 2
    rational = sp.S.One
    for prime, power in powers.items():
        rational *= sp.Integer(prime) ** sp.floor(power)
    return rational, {p: e % 1 for p, e in powers.items() if e % 1}


def orders(radicals: Iterable[sp.Expr]) -> dict[int, int]:
    """Return for every prime the order n of the root p**(1/n) in which all radicals are powers.

    >>> orders([sp.sqrt(6), sp.cbrt(2)])
    {2: 6, 3: 2}
    """
    found: dict[int, int] = {}
    for radical in radicals:
        for prime, exponent in prime_roots(radical)[1].items():
            found[prime] = lcm(found.get(prime, 1), int(exponent.q))
    return dict(sorted(found.items()))


def plain_roots(expressions: Iterable[sp.Expr]) -> list[sp.Expr]:
    """Write roots of -1 with cos and sin, and nested square roots as sums, where radicals suffice.

    >>> plain_roots([sp.Pow(-1, sp.Rational(1, 3)), sp.sqrt(5 + 2*sp.sqrt(6))])
    [1/2 + sqrt(3)*I/2, sqrt(2) + sqrt(3)]
    """
    return transformed(expressions, lambda _, node: _plain(node) if node.is_Pow else node)


@lru_cache(maxsize=1024)
def _plain(node: sp.Pow) -> sp.Expr:
    base, exponent = node.args
    if not exponent.is_Rational or exponent.is_Integer:
        return node
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

"""Trigonometry becomes algebra: every angle in terms of a few base angles.

The angles that occur are linear combinations of atoms (mostly symbols) with rational coefficients
and of pi. Addition theorems and multiples write their sines and cosines as polynomials in cos(a)
and sin(a) of one base angle a per atom; there only cos(a)^2 + sin(a)^2 = 1 is left to be known.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import gcd, lcm

import sympy as sp

from ..dag import postorder, transformed
from .size import size_multiplied_out

HIGHEST_MULTIPLE = 64
_FUNCTIONS = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc)
_INVERSES = (sp.atan, sp.asin, sp.acos)
_LARGEST_ARGUMENT = 100  # that is expanded

Pair = tuple[sp.Expr, sp.Expr]  # cosine and sine of one angle


def in_base_angles(expressions: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Write all trigonometric functions with the cosines and sines of base angles.

    >>> x, y = sp.symbols("x y")
    >>> in_base_angles([sp.cos(2*x), sp.sin(x - y), sp.tan(x)])[1]
    sin(x)*cos(y) - sin(y)*cos(x)
    """
    arguments = {n.args[0] for n in postorder(expressions) if isinstance(n, _FUNCTIONS)}
    if not arguments:
        return list(expressions)
    base = {atom: unit * atom for atom, unit in _units(map(_parts, arguments)).items()}
    memo: dict[tuple[sp.Expr, int], Pair] = {}

    def change(_: sp.Basic, node: sp.Basic) -> sp.Basic:
        if not isinstance(node, _FUNCTIONS):
            return node
        pair = sp.S.One, sp.S.Zero
        for atom, coefficient in _parts(node.args[0]).items():
            if atom is sp.pi:
                angle = coefficient * sp.pi
                pair = _sum(pair, (sp.cos(angle), sp.sin(angle)))
                continue
            if atom not in base:
                return node  # it was rewritten itself, as in sin(sin(2*x))
            multiple = coefficient * atom / base[atom]
            if not multiple.is_Integer or abs(multiple) > HIGHEST_MULTIPLE:
                return node
            pair = _sum(pair, _multiple(base[atom], int(multiple), memo))
        return _value(node.func, *pair)

    return transformed(expressions, change)


def given_divisors(expression: sp.Expr) -> list[sp.Expr]:
    """Return what an expression divides by, also in its tangents and their like.

    >>> x = sp.Symbol("x")
    >>> given_divisors(sp.tan(2*x) / x)
    [x, cos(2*x)]
    """
    found = []
    for node in postorder([expression], _outside_of_operators):
        if node.is_Pow and node.exp.is_Rational and node.exp.is_negative:
            found.append(node.base)
        elif isinstance(node, sp.tan | sp.sec):
            found.append(sp.cos(node.args[0]))
        elif isinstance(node, sp.cot | sp.csc):
            found.append(sp.sin(node.args[0]))
    return [divisor for divisor in dict.fromkeys(found) if not divisor.is_Rational]


def _outside_of_operators(node: sp.Basic) -> tuple[sp.Basic, ...]:
    return () if isinstance(node, sp.Derivative | sp.Subs | sp.Integral) else node.args


def _parts(argument: sp.Expr) -> dict[sp.Expr, sp.Rational]:
    """Return the rational coefficient of every atom in an angle; pi and 1 are atoms too."""
    if size_multiplied_out(argument, _LARGEST_ARGUMENT) <= _LARGEST_ARGUMENT:
        argument = sp.expand(argument)
    parts: dict[sp.Expr, sp.Rational] = {}
    for term in sp.Add.make_args(argument):
        coefficient, atom = term.as_coeff_Mul(rational=True)
        parts[atom] = parts.get(atom, sp.S.Zero) + coefficient
    return {atom: coefficient for atom, coefficient in parts.items() if coefficient}


def _units(angles: Iterable[Mapping[sp.Expr, sp.Rational]]) -> dict[sp.Expr, sp.Rational]:
    """Return for every atom the largest rational of which all its coefficients are multiples."""
    units: dict[sp.Expr, sp.Rational] = {}
    for parts in angles:
        for atom, coefficient in parts.items():
            # The sine of an arc sine is known, that of its double only through it.
            unit = units.get(atom, sp.Integer(isinstance(atom, _INVERSES)))
            p, q = lcm(int(unit.q), int(coefficient.q)), abs(coefficient)
            units[atom] = sp.Rational(gcd(int(unit * p), int(q * p)), p)
    return units


def _multiple(angle: sp.Expr, n: int, memo: dict[tuple[sp.Expr, int], Pair]) -> Pair:
    """Return cos(n a) and sin(n a) by doubling and adding, sharing what they have in common."""
    if (angle, n) in memo:
        return memo[angle, n]
    if n < 0:
        cosine, sine = _multiple(angle, -n, memo)
        pair = cosine, -sine
    elif n == 1:
        pair = sp.cos(angle), sp.sin(angle)
    elif n % 2:
        pair = _sum(_multiple(angle, n - 1, memo), _multiple(angle, 1, memo))
    else:
        half = _multiple(angle, n // 2, memo)
        pair = _sum(half, half)
    memo[angle, n] = pair
    return pair


def _sum(left: Pair, right: Pair) -> Pair:
    (c, s), (d, r) = left, right
    return c * d - s * r, s * d + c * r


def _value(function: type, cosine: sp.Expr, sine: sp.Expr) -> sp.Expr:
    return {
        sp.cos: lambda: cosine,
        sp.sin: lambda: sine,
        sp.tan: lambda: sine / cosine,
        sp.cot: lambda: cosine / sine,
        sp.sec: lambda: 1 / cosine,
        sp.csc: lambda: 1 / sine,
    }[function]()

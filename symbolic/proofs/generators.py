"""What the generators of a ring stand for: free symbols, angles, roots, and what is not understood.

Some are bound by a relation g^n = base: sin(a)^2 = 1 - cos(a)^2, sqrt(2)^2 = 2, or the root of an
expression. Multiplied out and reduced by these, symbols, roots of primes, pi and the angles of
different symbols have one normal form for every function: they are independent of each other.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import lcm
from typing import Literal

import sympy as sp

from ..errors import shown
from ..fields import operands
from ..radicals import is_radical, orders

HIGHEST_ROOT = 24  # of an expression with symbols
LARGEST_PRIME = 10**60  # that is recognised as one


class NoNormalForm(Exception):
    """Why an expression has no normal form here; becomes the reason of an Undecided."""


@dataclass(frozen=True)
class Generator:
    """A generator of the ring, and what is known about it.

    A "number" is a root of a prime, I or pi; an "angle" the cosine or sine of a multiple of one
    symbol. Each of these is independent of all generators with other symbols; "other" may not be.
    """

    expression: sp.Expr
    kind: Literal["symbol", "number", "angle", "other"]
    symbol: sp.Symbol | None = None  # that a symbol or an angle belongs to
    angle: sp.Expr | None = None


class Generators:
    """The generators that a set of nodes needs, and where each of them stands in the ring."""

    def __init__(self, nodes: Iterable[sp.Basic], more_radicals: Sequence[sp.Expr] = ()) -> None:
        self.listed: list[Generator] = []
        self.position: dict[sp.Expr, int] = {}
        self.roots_of_primes: dict[int, tuple[int, int]] = {}  # order, position
        self.order = 1  # of the roots of expressions: all of them are powers of such roots
        self._trouble: dict[sp.Basic, str] = {}
        radicals = list(more_radicals)
        bases: dict[sp.Expr, None] = {}
        for node in nodes:
            if node.is_Rational or operands(node):
                continue
            if is_radical(node):
                radicals.append(node)
            elif is_root(node):
                bases[node.base] = None
                self.order = lcm(self.order, int(node.exp.q))
            else:
                self._add_leaf(node)
        for prime, n in orders(radicals).items():
            independent = n == 2 if prime < 0 else prime < LARGEST_PRIME and sp.isprime(prime)
            root = sp.Pow(prime, sp.Rational(1, n))
            position = self._add(Generator(root, "number" if independent else "other"))
            self.roots_of_primes[prime] = n, position
        for base in bases:
            self._add(Generator(sp.Pow(base, sp.Rational(1, self.order)), "other"))

    def _add_leaf(self, node: sp.Basic) -> None:
        if not isinstance(node, sp.Expr) or node.is_commutative is False:
            self._trouble[node] = f"{shown(node, 60)} is not a commutative expression"
        elif node in (sp.nan, sp.zoo, sp.oo, -sp.oo) or (node.is_Pow and node.base == 0):
            self._trouble[node] = "one side is undefined or infinite"
        elif isinstance(node, sp.AccumBounds | sp.Order):
            self._trouble[node] = f"{shown(node, 60)} is not one number"
        elif isinstance(node, sp.cos | sp.sin):
            (angle,) = node.args
            symbol = _symbol_of(angle)
            for function in (sp.cos(angle), sp.sin(angle)):
                self._add(Generator(function, "angle" if symbol else "other", symbol, angle))
        elif node.is_Symbol:
            self._add(Generator(node, "symbol", node))
        else:
            self._add(Generator(node, "number" if node is sp.pi else "other"))

    def _add(self, generator: Generator) -> int:
        if generator.expression not in self.position:
            self.position[generator.expression] = len(self.listed)
            self.listed.append(generator)
        return self.position[generator.expression]

    def of(self, leaf: sp.Expr) -> int:
        """Return the position of a leaf's generator, or say why there is none."""
        if leaf in self._trouble:
            raise NoNormalForm(self._trouble[leaf])
        return self.position[leaf]

    def of_root(self, node: sp.Expr) -> int:
        """Return the position of the generator of which a root of an expression is a power."""
        return self.position[sp.Pow(node.base, sp.Rational(1, self.order))]

    def are_independent(self, positions: Iterable[int]) -> bool:
        """Tell whether two different normal forms in these generators are different functions."""
        roles: dict[sp.Symbol, sp.Expr | None] = {}
        for generator in map(self.listed.__getitem__, positions):
            if generator.kind == "other":
                return False
            if generator.kind == "number":
                continue
            if roles.setdefault(generator.symbol, generator.angle) != generator.angle:
                return False  # t and cos(t), or cos(t) and cos(sqrt(2)*t)
        return True


def is_root(node: sp.Basic) -> bool:
    """Tell whether a node is a root of an expression that is no rational number.

    >>> x = sp.Symbol("x")
    >>> is_root(sp.sqrt(x)), is_root(sp.sqrt(2)), is_root(x**2), is_root(2**x)
    (True, False, False, False)
    """
    if not (node.is_Pow and node.exp.is_Rational) or node.exp.is_Integer:
        return False
    return not node.base.is_Rational and int(node.exp.q) <= HIGHEST_ROOT


def _symbol_of(angle: sp.Expr) -> sp.Symbol | None:
    """Return the symbol of which the angle is a rational multiple, if it is one."""
    coefficient, atom = angle.as_coeff_Mul(rational=True)
    return atom if atom.is_Symbol and coefficient.is_Rational else None

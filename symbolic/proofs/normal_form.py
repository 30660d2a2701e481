"""Expressions as elements of one polynomial ring or its fraction field: equal means the same.

Symbols are matched by name. Roots and the sines of base angles are generators with a relation
g^n = base, by which all results are reduced. Anything else (exp(t), f(t)) becomes one more
generator: an equality that holds for independent generators holds for their values, but not the
other way round.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from operator import add, mul
from typing import Any

import sympy as sp
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

from ..dag import postorder
from ..errors import shown
from ..fields import operands
from ..radicals import is_radical, plain_roots, prime_roots
from .angles import given_divisors, in_base_angles
from .elements import (
    composed,
    differentiated,
    divided,
    folded,
    integrated,
    plain,
    power,
    reduced,
    used,
)
from .generators import Generators, NoNormalForm, is_root
from .side import is_operator, operator_arguments

HIGHEST_ORDER = 32  # of derivatives of quotients


class NormalForms:
    """Several expressions in one common structure; those that fail say so when asked for.

    Attributes
    ----------
    generators : Generators
        What the generators of the ring stand for.
    """

    def __init__(self, expressions: Iterable[sp.Expr]) -> None:
        # Rewriting lets divisors vanish, as in tan(x)*cot(x): they are written down before.
        roots = list(expressions)
        given = [given_divisors(root) for root in roots]
        rewritten = in_base_angles(plain_roots([*roots, *(d for row in given for d in row)]))
        self._roots, rest = rewritten[: len(roots)], iter(rewritten[len(roots) :])
        self._given_divisors = [[next(rest) for _ in row] for row in given]
        self._nodes = list(postorder(rewritten, _operands))
        self._divides = any(given) or any(map(_divides, self._nodes))
        more: list[sp.Expr] = []
        while not self._computed(more):
            pass

    def _computed(self, more_radicals: list[sp.Expr]) -> bool:
        """Compute all elements; False if a radical turned up that is no generator yet."""
        self.generators = Generators(self._nodes, more_radicals)
        self._ring = _ring(max(1, len(self.generators.listed)))
        self._relations: dict[int, tuple[int, Any]] = {}
        self._positions_of_bases: dict[Any, int] = {}
        self._bind_known_roots()
        self._values: dict[int, Any] = {}
        self._divisors_at_points: dict[int, list[Any]] = {}  # of substitutions
        for node in self._nodes:
            try:
                self._values[id(node)] = plain(self._element(node))
            except NoNormalForm as reason:
                self._values[id(node)] = reason
            except _NeedsRadical as needed:
                more_radicals.append(needed.radical)
                return False
        return True

    def element(self, place: int) -> Any:
        """Return the normal form of the expression at this place."""
        return reduced(self._known(self._roots[place]), self._relations)

    def difference(self, left: Any, right: Any) -> Any:
        """Return left - right, reduced: zero if they are equal."""
        return reduced(left - right, self._relations)

    def divisors(self, *places: int) -> list[Any]:
        """Return everything by which is divided in the expressions at these places."""
        if not self._divides:
            return []
        return self._divisors(self._all_of(places)) + [
            reduced(self._known(divisor), self._relations)
            for place in places
            for divisor in self._given_divisors[place]
        ]

    def leaves(self, *places: int) -> set[int]:
        """Return the positions of all generators from which these expressions are built."""
        found = set()
        for node in postorder(self._all_of(places), _operands):
            if is_root(node):
                found.add(self.generators.of_root(node))
            elif is_radical(node):
                found |= {self.generators.roots_of_primes[p][1] for p in prime_roots(node)[1]}
            elif not (node.is_Rational or _operands(node)):
                found.add(self.generators.of(node))
        return found

    def _divisors(self, roots: Iterable[sp.Basic]) -> list[Any]:
        """Return all divisors, reduced; those inside a substitution at the point put in."""
        found = []
        for node in postorder(roots, _outside_of_substitutions):
            if _divides(node):
                found.append(reduced(self._known(node.base), self._relations))
            found += self._divisors_at_points.get(id(node), [])
        return found

    def _all_of(self, places: Iterable[int]) -> list[sp.Expr]:
        """Return the expressions at these places, and what they are divided by."""
        return [e for place in places for e in (self._roots[place], *self._given_divisors[place])]

    def _bind_known_roots(self) -> None:
        one, gens = self._ring.one, self._ring.gens
        for prime, (order, position) in self.generators.roots_of_primes.items():
            self._relations[position] = order, one * prime
        for expression, position in self.generators.position.items():
            if isinstance(expression, sp.sin):
                cosine = gens[self.generators.position[sp.cos(expression.args[0])]]
                self._relations[position] = 2, one - cosine**2

    def _known(self, node: sp.Basic) -> Any:
        value = self._values[id(node)]
        if isinstance(value, NoNormalForm):
            raise value
        return value

    def _element(self, node: sp.Basic) -> Any:
        below = [self._known(operand) for operand in _operands(node)]
        if not below:
            return self._leaf(node)
        if node.is_Add:
            return folded(add, below)
        if node.is_Mul:
            return folded(lambda a, b: reduced(a * b, self._relations), below)
        if isinstance(node, sp.Derivative):
            return self._derivative(node, below[0])
        if isinstance(node, sp.Subs):
            return self._substituted(node, below[0], below[1:])
        if isinstance(node, sp.Integral):
            return self._integral(node, below[0], *below[1:])
        if is_root(node):
            return self._root(node, below[0])
        return power(below[0], int(node.exp), self._relations)

    def _leaf(self, node: sp.Basic) -> Any:
        if node.is_Rational:
            return self._ring.one * sp.QQ(node.p, node.q)
        return (
            self._radical(node) if is_radical(node) else self._ring.gens[self.generators.of(node)]
        )

    def _radical(self, radical: sp.Expr) -> Any:
        rational, powers = prime_roots(radical)
        element = self._ring.one * sp.QQ(rational.p, rational.q)
        for prime, exponent in powers.items():
            order, position = self.generators.roots_of_primes.get(prime, (1, 0))
            if not (exponent * order).is_Integer:
                raise _NeedsRadical(radical)
            element *= self._ring.gens[position] ** int(exponent * order)
        return element

    def _root(self, node: sp.Expr, base: Any) -> Any:
        """Return base**(p/q): the root of its rational content times a power of a generator."""
        if not base:
            if node.exp.is_negative:
                raise NoNormalForm("a denominator is identically zero")
            return self._ring.zero
        content, primitive = _content(base)
        if primitive == 1:
            return self._number_to_the(content, node.exp)
        own = self.generators.of_root(node)
        position = self._positions_of_bases.setdefault(primitive, own)
        self._relations.setdefault(position, (self.generators.order, primitive))
        exponent = int(node.exp * self.generators.order)
        root = power(self._ring.gens[position], exponent, self._relations)
        return root * self._number_to_the(content, node.exp)

    def _number_to_the(self, number: sp.Rational, exponent: sp.Rational) -> Any:
        result = sp.Integer(1)
        element = self._ring.one
        for factor in sp.Mul.make_args(sp.Pow(number, exponent)):
            if is_radical(factor):
                element = reduced(element * self._radical(factor), self._relations)
            else:
                result *= factor
        if not result.is_Rational:
            raise NoNormalForm(f"{shown(number, 60)}**({exponent}) is not understood")
        return element * sp.QQ(result.p, result.q)

    def _derivative(self, node: sp.Derivative, element: Any) -> Any:
        for variable, order in node.variable_count:
            position = self.generators.position.get(variable)
            if position is None:
                return self._ring.zero
            if order > HIGHEST_ORDER and hasattr(element, "numer"):
                raise NoNormalForm(f"the derivative of order {order} of a quotient is too long")
            for _ in range(int(order)):
                element = differentiated(element, position)
        return element

    def _integral(self, node: sp.Integral, element: Any, start: Any, end: Any) -> Any:
        position = self.generators.position.get(node.variables[0])
        if position is None:
            return reduced(folded(mul, [element, end - start]), self._relations)
        if any(position in used(divisor) for divisor in self._divisors([node.function])):
            raise NoNormalForm("an integral of no polynomial is not understood")
        whole = integrated(element, position)
        return self._at(whole, {position: end}) - self._at(whole, {position: start})

    def _substituted(self, node: sp.Subs, element: Any, points: Sequence[Any]) -> Any:
        at = {
            self.generators.position[variable]: point
            for variable, point in zip(node.variables, points, strict=True)
            if variable in self.generators.position
        }
        divisors = [self._at(divisor, at) for divisor in self._divisors([node.expr])]
        if not all(divisors):
            raise NoNormalForm("a side is not defined where something is substituted")
        self._divisors_at_points[id(node)] = divisors
        return self._at(element, at)

    def _at(self, element: Any, at: Mapping[int, Any]) -> Any:
        return reduced(composed(element, at), self._relations)


class _NeedsRadical(Exception):
    def __init__(self, radical: sp.Expr) -> None:
        self.radical = radical


def _operands(node: sp.Basic) -> tuple[sp.Basic, ...]:
    if is_root(node):
        return (node.base,)
    if is_operator(node):
        return operator_arguments(node)
    return operands(node)


def _outside_of_substitutions(node: sp.Basic) -> tuple[sp.Basic, ...]:
    return tuple(node.point) if isinstance(node, sp.Subs) else _operands(node)


def _divides(node: sp.Basic) -> bool:
    return bool(node.is_Pow and node.exp.is_negative and _operands(node))


def _content(element: Any) -> tuple[sp.Rational, Any]:
    """Split off the largest positive rational factor; a number is all content."""
    element = plain(element)
    if hasattr(element, "numer"):
        numer, denom = (part.primitive() for part in (element.numer, element.denom))
        return sp.QQ.to_sympy(numer[0] / denom[0]), divided(numer[1], denom[1])
    content, primitive = element.primitive()
    if primitive.is_ground:
        return sp.QQ.to_sympy(element.LC), element.ring.one
    return sp.QQ.to_sympy(content), primitive


@lru_cache(maxsize=64)
def _ring(size: int) -> PolyRing:
    return PolyRing([sp.Symbol(f"g{i}") for i in range(size)], sp.QQ, lex)

"""Expressions as elements of one polynomial ring or fraction field: equal means the same element.

Symbols are matched by name. Square roots and other radicals of rationals live in the algebraic
field they generate. Anything else (sin(t), pi, t**(1/2)) becomes one more generator: an equality
that holds for independent generators holds for their values, but not the other way round.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import prod
from operator import add, mul
from typing import Any

import sympy as sp
from sympy.polys.fields import FracField
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

from ..dag import postorder

# Limits, so that a short text cannot keep a reader waiting for longer than a few seconds.
HIGHEST_POWER = 512
MOST_PRODUCTS = 300_000  # of terms in one multiplication of polynomials
MOST_PRODUCTS_OF_FRACTIONS = 3_000  # every operation there looks for a common divisor
MOST_BITS = 100_000  # of a coefficient
HIGHEST_ALGEBRAIC_DEGREE = 8


class NoNormalForm(Exception):
    """Why an expression has no normal form here; becomes the reason of an Undecided."""


@dataclass(frozen=True)
class NormalForms:
    """Several expressions as elements of one field (or ring, where nothing is divided).

    Attributes
    ----------
    elements : one per expression
    generators : the symbol or opaque node behind every generator of the field
    opaque : whether some generator stands for more than a free symbol
    divisors : elements by which something was divided
    """

    elements: tuple[Any, ...]
    generators: tuple[sp.Expr, ...]
    opaque: bool
    divisors: tuple[Any, ...]
    domain: Any

    @property
    def kind(self) -> str:
        """Name the structure in which the expressions were compared."""
        if not self.generators:
            return "numbers"
        names = sorted(map(str, self.generators), key=lambda name: (len(name), name))
        if len(names) > 6:
            names = [*names[:3], "...", names[-1]]
        form = "rational functions" if self.divisors else "polynomials"
        field = "rational" if self.domain == sp.QQ else "algebraic"
        return f"{form} in {', '.join(names)} with {field} coefficients"


def normal_forms(expressions: Sequence[sp.Expr]) -> NormalForms:
    """Return the normal forms of several expressions in one common structure.

    Raises
    ------
    NoNormalForm
        For division by zero, powers too high to expand, and non-commutative symbols.
    """
    nodes = list(postorder(expressions, _operands))
    leaves = _Leaves(nodes)
    divides = any(node.is_Pow and _operands(node) and node.exp.is_negative for node in nodes)
    stand_ins = [sp.Dummy(f"g{i}") for i in range(max(1, len(leaves.generators)))]
    structure = (FracField if divides else PolyRing)(stand_ins, leaves.domain, lex)
    values: dict[int, Any] = {}
    divisors: list[Any] = []
    for node in nodes:
        values[id(node)] = _element(node, values, leaves, structure, divisors)
    return NormalForms(
        tuple(values[id(expression)] for expression in expressions),
        tuple(leaves.generators),
        leaves.opaque,
        tuple(divisors),
        leaves.domain,
    )


def _operands(node: sp.Basic) -> tuple[sp.Basic, ...]:
    if node.is_Add or node.is_Mul:
        return node.args
    if node.is_Pow and node.exp.is_Integer:
        return (node.base,)
    return ()


def _is_radical(node: sp.Basic) -> bool:
    if node is sp.I:
        return True
    return bool(node.is_Pow and node.base.is_Rational and node.base and node.exp.is_Rational)


def _algebraic_field(radicals: Sequence[sp.Expr]) -> Any:
    """Return the field of some radicals, if its degree stays small."""
    degree = prod(2 if r is sp.I else int(r.exp.q) for r in radicals)
    if degree > HIGHEST_ALGEBRAIC_DEGREE:
        raise NoNormalForm(f"radicals of degree {degree} together are too many")
    return sp.QQ.algebraic_field(*radicals)


class _Leaves:
    """The generators and the coefficient domain that a set of nodes needs."""

    def __init__(self, nodes: Sequence[sp.Basic]) -> None:
        self.generators: list[sp.Expr] = []
        self.opaque = False
        self._index: dict[Any, int] = {}
        radicals = []
        for node in nodes:
            if _operands(node) or node.is_Rational:
                continue
            if _is_radical(node):
                radicals.append(node)
            else:
                self._add(node)
        different = list(dict.fromkeys(radicals))
        self.domain = _algebraic_field(different) if different else sp.QQ

    def _add(self, node: sp.Basic) -> None:
        if not isinstance(node, sp.Expr) or node.is_commutative is False:
            raise NoNormalForm(f"{node} is not a commutative expression")
        if node in (sp.nan, sp.zoo, sp.oo, -sp.oo) or (node.is_Pow and node.base == 0):
            raise NoNormalForm("one side is undefined or infinite")
        self.opaque = self.opaque or not node.is_Symbol
        if self._key(node) not in self._index:
            self._index[self._key(node)] = len(self.generators)
            self.generators.append(sp.Symbol(node.name) if type(node) is sp.Symbol else node)

    def position(self, node: sp.Basic) -> int | None:
        return self._index.get(self._key(node))

    @staticmethod
    def _key(node: sp.Basic) -> Any:
        return node.name if type(node) is sp.Symbol else node


def _element(
    node: sp.Basic, values: dict[int, Any], leaves: _Leaves, structure: Any, divisors: list[Any]
) -> Any:
    operands = [values[id(operand)] for operand in _operands(node)]
    if node.is_Add and operands:
        return _folded(add, operands)
    if node.is_Mul and operands:
        return _folded(mul, operands)
    if operands:
        return _power(operands[0], int(node.exp), divisors)
    position = leaves.position(node)
    if position is not None:
        return structure.gens[position]
    return structure.one * leaves.domain.from_sympy(node)


def _size(element: Any) -> int:
    return len(element.numer) + len(element.denom) if hasattr(element, "numer") else len(element)


def _folded(operation: Callable[[Any, Any], Any], operands: Sequence[Any]) -> Any:
    """Add or multiply one after the other, as long as the result stays within the limits."""
    result = operands[0]
    for operand in operands[1:]:
        fractions = hasattr(result, "numer")
        products = _size(result) * _size(operand)
        if products > (MOST_PRODUCTS_OF_FRACTIONS if fractions else MOST_PRODUCTS) and (
            fractions or operation is mul
        ):
            raise NoNormalForm("it has too many terms to expand")
        result = operation(result, operand)
    return result


def _bits(element: Any) -> int:
    """Return the length of the longest coefficient; 0 for algebraic ones."""
    parts = (element.numer, element.denom) if hasattr(element, "numer") else (element,)
    numbers = [c for part in parts for c in part.values() if part.ring.domain == sp.QQ]
    return max((max(abs(int(c.numerator)), int(c.denominator)).bit_length() for c in numbers),
               default=0)  # fmt: skip


def _power(base: Any, exponent: int, divisors: list[Any]) -> Any:
    if abs(exponent) > HIGHEST_POWER:
        raise NoNormalForm(f"the power {exponent} is too high to expand")
    if exponent < 0:
        if not base:
            raise NoNormalForm("a denominator is identically zero")
        divisors.append(base)
        base, exponent = 1 / base, -exponent
    if exponent * _bits(base) > MOST_BITS:
        raise NoNormalForm("its numbers have too many digits")
    if exponent == 0:
        return base - base + 1  # also for the base 0, as SymPy has it
    result = base
    for bit in bin(exponent)[3:]:
        result = _folded(mul, [result, result])
        result = _folded(mul, [result, base]) if bit == "1" else result
    return result

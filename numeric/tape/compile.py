"""From SymPy expressions to a straight-line program, by walking the unexpanded DAG once.

Equal subexpressions become one instruction (hash-consing on operation and operands), so a
de Casteljau scheme of degree n costs n(n + 1)/2 interpolations, however large it prints.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite
from typing import Any

import sympy as sp

from symbolic.dag import postorder
from symbolic.errors import BadType, BadValue, shown


class quotient_or_zero(sp.Function):
    """a/b, and 0 where b = 0: so the Cox-de Boor recurrence reads 0/0 at repeated knots.

    >>> x = sp.Symbol("x")
    >>> quotient_or_zero(1, 0), quotient_or_zero(3, 2), quotient_or_zero(1, x).subs(x, 0)
    (0, 3/2, 0)
    """

    @classmethod
    def eval(cls, a: Any, b: Any) -> Any:
        """Return the value where b is a number."""
        if b.is_number:
            return sp.S.Zero if b.is_zero else a / b
        return None


_FUNCTIONS = {sp.sin: "sin", sp.cos: "cos", sp.tan: "tan", sp.exp: "exp", sp.log: "log",
              sp.Abs: "abs", sp.atan2: "atan2", sp.Min: "min", sp.Max: "max",
              quotient_or_zero: "ratio"}  # fmt: skip
_LARGEST_SAFE_INTEGER = 2**53 - 1  # JSON numbers are doubles in the browser

Node = tuple[Any, ...]


class Program:
    """Hash-consed nodes: ("input", name), ("constant", number) or (operation, operands...)."""

    def __init__(self, inputs: Iterable[sp.Symbol]) -> None:
        self.nodes: list[Node] = []
        self._number: dict[Node, int] = {}
        self._of: dict[int, int] = {}  # id of an expression -> number of its node
        self._alive: list[sp.Expr] = []  # or ids could be handed out again
        self.inputs = {symbol.name: self._put(("input", symbol.name)) for symbol in inputs}

    def add(self, expressions: Sequence[sp.Expr]) -> list[int]:
        """Add expressions and return the number of the node that computes each of them."""
        self._alive.extend(expressions)
        for node in postorder(expressions):
            if isinstance(node, sp.Expr) and id(node) not in self._of:
                self._of[id(node)] = self._node(node)
        return [self._of[id(expression)] for expression in expressions]

    def live(self, roots: Iterable[int]) -> list[int]:
        """Return the nodes needed for the roots, operands first.

        Of two operands the one with the longer way to the inputs comes first, so that few
        intermediate values wait for their use at the same time (Sethi and Ullman, JACM 17, 1970).
        """
        height = [0] * len(self.nodes)
        for i in range(len(self.nodes)):  # operands have smaller numbers
            height[i] = 1 + max((height[j] for j in self._operands(i)), default=0)
        order: dict[int, None] = {}
        stack = [(i, False) for i in reversed(list(roots))]
        while stack:
            i, operands_done = stack.pop()
            if i in order:
                continue
            if operands_done:
                order[i] = None
                continue
            stack.append((i, True))
            stack.extend((j, False) for j in sorted(self._operands(i), key=height.__getitem__))
        return list(order)

    def _operands(self, i: int) -> tuple[int, ...]:
        operation, *operands = self.nodes[i]
        return () if operation in ("input", "constant") else tuple(operands)

    def _put(self, node: Node) -> int:
        if node[0] in ("add", "mul") and node[1] > node[2]:
            node = (node[0], node[2], node[1])
        if node not in self._number:
            self._number[node] = len(self.nodes)
            self.nodes.append(node)
        return self._number[node]

    def _constant(self, value: sp.Expr) -> int:
        return self._put(("constant", _json_number(value)))

    def _node(self, expression: sp.Expr) -> int:
        if expression.is_Symbol:
            return self._input(expression)
        if expression.is_number and not expression.args:
            return self._constant(expression)
        if expression.is_Add:
            return self._sum(expression)
        if expression.is_Mul:
            product = self._quotient(expression)
            return self._put(("neg", product)) if _is_negative(expression) else product
        if expression.is_Pow:
            return self._power(expression, expression.exp)
        if expression.func is sp.atan:  # SymPy makes it of atan2 where the second one is positive
            return self._put(("atan2", self._of[id(expression.args[0])], self._constant(sp.S.One)))
        if expression.func is sp.Heaviside and expression.args[1] == 1:  # 1 from zero on
            return self._put(("step", self._of[id(expression.args[0])]))
        name = _FUNCTIONS.get(expression.func)
        if name is None and expression.is_number:
            return self._constant(expression)
        if name is None:
            raise BadValue(
                "an expression in + - * / ** sqrt sin cos tan exp log Abs atan atan2 Min Max, "
                "Heaviside(x, 1)",
                f"{expression.func.__name__} in {shown(expression)}",
                "Rewrite it with these, or evaluate it first.",
            )
        operands = [self._of[id(argument)] for argument in expression.args]
        return self._fold(name, operands) if len(operands) > 1 else self._put((name, *operands))

    def _input(self, symbol: sp.Symbol) -> int:
        if symbol.name not in self.inputs:
            known = ", ".join(self.inputs) or "none"
            raise BadValue(
                f"expressions in the inputs ({known})",
                f"the symbol {symbol.name}",
                "Add it to the inputs, or substitute a value.",
            )
        return self.inputs[symbol.name]

    def _sum(self, expression: sp.Expr) -> int:
        """Add the positive terms, then subtract the ones with a negative coefficient."""
        plus, minus = [], []
        for term in expression.args:
            if not _is_negative(term):
                plus.append(self._of[id(term)])
            else:
                minus.append(self._quotient(term) if term.is_Mul else self._constant(-term))
        if not plus:
            return self._put(("neg", self._fold("add", minus)))
        total = self._fold("add", plus)
        for number in minus:
            total = self._put(("sub", total, number))
        return total

    def _quotient(self, product: sp.Expr) -> int:
        """Multiply the numerators without sign, then divide by the product of the denominators."""
        above, below = [], []
        for factor in product.args:
            if factor.is_Rational:
                if abs(factor) != 1:
                    above.append(self._constant(abs(factor)))
            elif factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative:
                below.append(self._power(factor, -factor.exp))
            else:
                above.append(self._of[id(factor)])
        result = self._fold("mul", above) if above else self._constant(sp.S.One)
        return self._put(("div", result, self._fold("mul", below))) if below else result

    def _power(self, power: sp.Pow, exponent: sp.Expr) -> int:
        base = self._of[id(power.base)]
        if exponent.is_Rational and exponent.is_negative:
            positive = self._power(power, -exponent)
            return self._put(("div", self._constant(sp.S.One), positive))
        if exponent.is_zero:
            return self._constant(sp.S.One)
        if exponent.is_Integer and exponent <= 64:
            return self._whole_power(base, int(exponent))
        if exponent.is_Rational and exponent.q == 2 and exponent <= 64:
            root = self._put(("sqrt", base))
            return self._whole_power(root, int(exponent.p))
        number = self._constant(exponent) if exponent.is_Rational else self._of[id(power.exp)]
        return self._put(("pow", base, number))

    def _whole_power(self, base: int, exponent: int) -> int:
        if exponent == 1:
            return base
        half = self._whole_power(base, exponent // 2)
        square = self._put(("mul", half, half))
        return self._put(("mul", square, base)) if exponent % 2 else square

    def _fold(self, operation: str, numbers: Sequence[int]) -> int:
        total = numbers[0]
        for number in numbers[1:]:
            total = self._put((operation, total, number))
        return total


def _is_negative(term: sp.Expr) -> bool:
    """Tell whether an odd number of a term's rational factors is negative."""
    factors = term.args if term.is_Mul else (term,)
    return sum(bool(f.is_Rational and f.is_negative) for f in factors) % 2 == 1


def _json_number(value: sp.Expr) -> float | tuple[int, int]:
    """Return a rational as a whole number or an exact pair (p, q), other reals as a float."""
    if not value.is_real or not value.is_finite or not isfinite(_as_float(value)):
        raise BadType(
            "real constants below 1.8e308", shown(value), "Leave complex and huge numbers out."
        )
    if value.is_Integer and abs(value) <= _LARGEST_SAFE_INTEGER:
        return int(value)
    if value.is_Rational and max(abs(value.p), value.q) <= _LARGEST_SAFE_INTEGER:
        return (int(value.p), int(value.q))
    return _as_float(value)


def _as_float(value: sp.Expr) -> float:
    try:
        return float(value)
    except (TypeError, OverflowError):
        return float("nan")

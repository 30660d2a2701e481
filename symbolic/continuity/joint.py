"""The verdict on a joint: `continuity_at(left, right)` and what it returns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import sympy as sp

from ..exact import Point
from ..proofs.derivation import Derivation
from ..proofs.verdict import Undecided

Order: TypeAlias = int | sp.Expr  # oo is one


@dataclass(frozen=True, eq=False, repr=False)
class Continuity:
    """How smoothly two segments join; prints as a verdict in words.

    Attributes
    ----------
    parametric : int or oo
        The largest k for which the joint is C^k; -1 for a gap, oo where the right segment
        continues the same curve with the same parameter.
    geometric : int, oo or Undecided
        The largest k for which it is G^k; oo where both segments follow one curve, however
        parametrized. Undecided with the reason, as above order 1 where a first derivative is zero.
    geometric_at_least : int or oo
        What is certain of the geometric order; the same number unless it is undecided.
    residuals : tuple of points
        right^(j)(0) - ratio^j left^(j)(1), j = 0, 1, ...; C^k means that those up to k are zero.
    betas : tuple of Expr
        beta1, beta2, ... of the connection matrix, as far as the joint is G^k.
    tangents : (left, right)
        The one-sided unit tangents, in the direction of travel; None for a single point.
    """

    parametric: Order
    geometric: Order | Undecided
    geometric_at_least: Order
    residuals: tuple[Point, ...]
    betas: tuple[sp.Expr, ...]
    tangents: tuple[Point | None, Point | None]
    derive: Callable[[Continuity], Derivation]

    @cached_property
    def derivation(self) -> Derivation:
        """The derivatives on both sides and what they show; `.verify()` checks every step."""
        return self.derive(self)

    def __str__(self) -> str:
        if self.parametric == -1:
            sentences = [f"There is a gap of {_row(self.residuals[0])}: neither C^0 nor G^0."]
        else:
            sentences = [self._parametric_words(), self._geometric_words()]
        return " ".join(filter(None, [*sentences, self._symbols_words()]))

    def __repr__(self) -> str:
        return str(self)

    def _parametric_words(self) -> str:
        if self.parametric == sp.oo:
            return "One and the same curve goes on: C^oo."
        k = int(self.parametric)
        agree = f"The derivatives agree up to order {k}" if k else "The segments meet"
        difference = _row(self.residuals[k + 1])
        return f"{agree}: C^{k}. The derivatives of order {k + 1} differ by {difference}."

    def _geometric_words(self) -> str:
        if isinstance(self.geometric, Undecided):
            known = self.geometric_at_least
            return f"G^{known} at least; whether more is undecided: {self.geometric.why}."
        if self.geometric == sp.oo:
            return "Both follow one curve near the joint: G^oo."
        if self.geometric > 0:
            same = "The unit tangents agree" if self.geometric == 1 else (
                f"After a change of parameter the derivatives agree up to order {self.geometric}"
            )  # fmt: skip
            return f"{same}: G^{self.geometric}, not G^{self.geometric + 1}."
        before, after = self.tangents
        if before is None or after is None:
            return "G^0."
        how = "are opposite" if all(a == -b for a, b in zip(before, after, strict=True)) else (
            f"differ, {_row(before)} before and {_row(after)} after"
        )  # fmt: skip
        why = "" if self.parametric == 0 else (
            " The first derivative is zero at the joint, so C^1 says nothing about the direction."
        )  # fmt: skip
        return f"The unit tangents {how}: G^0, not G^1.{why}"

    def _symbols_words(self) -> str:
        vectors = [*self.residuals, *(tangent for tangent in self.tangents if tangent)]
        names = sorted({str(s) for row in vectors for c in row for s in c.free_symbols})
        if not names:
            return ""
        return f"This holds for all values of {', '.join(names)} but special ones."


def _row(vector: Point) -> str:
    return f"({', '.join(map(str, vector))})"

"""The three possible outcomes of a proof, each of them saying why."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import log10

import sympy as sp

from ..errors import written


@dataclass(frozen=True)
class Verdict:
    """What is known about a claim; true in a condition only when it is proved.

    Attributes
    ----------
    diagnosis : str
        For a learner's answer: what is right or wrong about it, in a sentence or two.
    """

    diagnosis: str = field(default="", kw_only=True)

    def __bool__(self) -> bool:
        return isinstance(self, Proved)

    def __repr__(self) -> str:
        return self.diagnosis or str(self)


@dataclass(frozen=True, repr=False)
class Proved(Verdict):
    """The claim holds: both sides have the same normal form.

    >>> Proved("polynomials in t with rational coefficients")
    Proved: equal as polynomials in t with rational coefficients.
    """

    kind: str

    def __str__(self) -> str:
        return f"Proved: equal as {self.kind}."


@dataclass(frozen=True, repr=False)
class Refuted(Verdict):
    """The claim is false: at the witness the two sides differ.

    Attributes
    ----------
    witness : mapping of Symbol to number
        Values of the symbols, all exact, at which both sides are defined.
    left, right : Expr
        The two sides there.
    where : str
        Which entry of a matrix or list differs; empty for single expressions.
    """

    witness: Mapping[sp.Symbol, sp.Expr]
    left: sp.Expr
    right: sp.Expr
    where: str = ""

    def __str__(self) -> str:
        place = f" in {self.where}" if self.where else ""
        values = ", ".join(f"{name} = {written(value)}" for name, value in self.witness.items())
        at = f" at {values}" if values else ""
        left, right = shown_number(self.left), shown_number(self.right)
        return f"Refuted{place}:{at} the left side is {left} and the right side {right}."


def shown_number(value: sp.Expr) -> str:
    """Return a number as text; one with hundreds of digits only by its size.

    >>> shown_number(sp.Integer(10)**400)
    'a number of about 401 digits'
    """
    bits = max(abs(value.p), value.q).bit_length() if value.is_Rational else 0
    return f"a number of about {1 + int(bits * log10(2))} digits" if bits > 1000 else written(value)


@dataclass(frozen=True, repr=False)
class Undecided(Verdict):
    """Neither proved nor refuted, and why."""

    why: str

    def __str__(self) -> str:
        return f"Undecided: {self.why}."

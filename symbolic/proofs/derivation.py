"""Derivations: equalities with reasons, every one of them checked by machine."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from .proof import prove
from .verdict import Proved, Refuted, Verdict

_MARKS = {Proved: r"\checkmark", Refuted: r"\times"}


@dataclass(frozen=True, repr=False)
class Step:
    r"""One line of a derivation: left = right, because of something.

    The two sides are kept apart, since SymPy's `Eq` evaluates itself away.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> step = Step((1 - t)**2 + 2*t*(1 - t), 1 - t**2, "the binomial theorem")
    >>> step.verify()
    Proved: equal as polynomials in t with rational coefficients.
    >>> print(Step((1 - t)*t, t - t**2, "expand"))
    t*(1 - t) = -t**2 + t, because expand
    """

    left: Any
    right: Any
    because: str

    @cached_property
    def verdict(self) -> Verdict:
        """The verdict on this step, computed once."""
        return prove(self.left, self.right)

    def verify(self) -> Verdict:
        """Return the machine's verdict on left = right."""
        return self.verdict

    def __str__(self) -> str:
        return f"{_linear(self.left)} = {_linear(self.right)}, because {self.because}"

    def __repr__(self) -> str:
        return f"{self} ({type(self.verdict).__name__.lower()})"

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex()}$"

    def latex(self) -> str:
        """Return the equation and a tick (or a cross, or a question mark) as LaTeX."""
        mark = _MARKS.get(type(self.verdict), "?")
        return rf"{sp.latex(self.left)} = {sp.latex(self.right)} \quad {mark}"


@dataclass(frozen=True, repr=False)
class Derivation:
    """A titled sequence of steps; prints as LaTeX in a notebook and as plain lines elsewhere.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> short = Derivation("Expanding", (Step((1 - t)*t, t - t**2, "expand"),))
    >>> short.is_proved
    True
    >>> short
    Expanding
    1. t*(1 - t) = -t**2 + t, because expand (proved)
    """

    title: str
    steps: tuple[Step, ...]

    def verify(self) -> list[Verdict]:
        """Return the verdict on every step; `is_proved` sums them up."""
        return [step.verify() for step in self.steps]

    @property
    def is_proved(self) -> bool:
        """Whether every single step is proved."""
        return all(self.verify())

    def __str__(self) -> str:
        lines = (f"{i}. {step}" for i, step in enumerate(self.steps, 1))
        return "\n".join((self.title, *lines))

    def __repr__(self) -> str:
        lines = (f"{i}. {step!r}" for i, step in enumerate(self.steps, 1))
        return "\n".join((self.title, *lines))

    def _repr_latex_(self) -> str:
        lines = [rf"&\textbf{{{_escaped(self.title)}}}"]
        for i, step in enumerate(self.steps, 1):
            lines.append(rf"&\text{{{i}. {_escaped(step.because)}:}}")
            lines.append(rf"&\qquad {step.latex()}")
        rows = r" \\[4pt] ".join(lines)
        return rf"$\displaystyle \begin{{aligned}} {rows} \end{{aligned}}$"


def _linear(side: Any) -> str:
    """One line of text for a screen reader: matrices row by row in brackets.

    >>> t = sp.Symbol("t")
    >>> _linear(sp.Subs(sp.Derivative(t**2, t), t, 1))
    'd/dt (t**2) at t = 1'
    """
    if isinstance(side, sp.Subs):
        return f"{_linear(side.expr)} at {side.variables[0]} = {side.point[0]}"
    if isinstance(side, sp.Derivative):
        variable, order = side.variable_count[0]
        power = f"^{order}" if order > 1 else ""
        return f"d{power}/d{variable}{power} ({side.expr})"
    if isinstance(side, sp.MatMul):
        return " * ".join(_linear(factor) for factor in side.args)
    if isinstance(side, sp.MatrixBase):
        return str(side.tolist())
    return str(side)


def _escaped(text: str) -> str:
    special = {"\\": r"\backslash ", "$": r"\$", "%": r"\%", "&": r"\&", "#": r"\#", "_": r"\_"}
    special |= {"{": r"\{", "}": r"\}", "^": r"\wedge ", "~": r"\sim "}
    return "".join(special.get(character, character) for character in text)

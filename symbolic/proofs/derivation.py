"""Derivations: equalities with reasons, every one of them checked by machine."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import sympy as sp

from ..errors import TOO_LONG, written
from .linear_text import linear_text
from .proof import prove
from .verdict import Proved, Refuted, Verdict


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
    t (1 - t) = -t^2 + t, because expand
    >>> print(Step((1 - t)*t, t**2, "expand"))
    t (1 - t) is NOT equal to t^2: at t = 1 the left side is 0 and the right side 1 (claimed because expand)
    """  # noqa: E501

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
        left, right, verdict = linear_text(self.left), linear_text(self.right), self.verdict
        if isinstance(verdict, Proved):
            return f"{left} = {right}, because {self.because}"
        relation = "is NOT equal to" if isinstance(verdict, Refuted) else "is NOT PROVED equal to"
        return f"{left} {relation} {right}: {_reason(verdict)} (claimed because {self.because})"

    def __repr__(self) -> str:
        return f"{self} ({type(self.verdict).__name__.lower()})"

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex()}$"

    def latex(self) -> str:
        r"""Return the equation and a tick as LaTeX.

        A step that is not proved has a crossed or questioned equals sign instead, and says so in
        words, with the witness or the reason.
        """
        left, right, verdict = _latex(self.left), _latex(self.right), self.verdict
        if isinstance(verdict, Proved):
            return rf"{left} = {right} \quad \checkmark"
        relation = r"\neq" if isinstance(verdict, Refuted) else r"\overset{?}{=}"
        word = type(verdict).__name__.lower()
        return rf"{left} {relation} {right} \quad \text{{({word}: {_escaped(_reason(verdict))})}}"


def _latex(side: Any) -> str:
    text = written(side, sp.latex)
    return rf"\text{{{text}}}" if text == TOO_LONG else text


def _reason(verdict: Verdict) -> str:
    """Return what a verdict says after its name."""
    return str(replace(verdict, diagnosis="")).partition(": ")[2].rstrip(".")


@dataclass(frozen=True, repr=False)
class Derivation:
    """A titled sequence of steps; prints as LaTeX in a notebook and as plain lines elsewhere.

    `source` names where the argument can be read. A derivation with a step that is not proved says
    so in its title.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> short = Derivation("Expanding", (Step((1 - t)*t, t - t**2, "expand"),))
    >>> short.is_proved
    True
    >>> short
    Expanding
    1. t (1 - t) = -t^2 + t, because expand (proved)
    """

    title: str
    steps: tuple[Step, ...]
    source: str = ""

    def verify(self) -> list[Verdict]:
        """Return the verdict on every step; `is_proved` sums them up."""
        return [step.verify() for step in self.steps]

    @property
    def is_proved(self) -> bool:
        """Whether every single step is proved."""
        return all(self.verify())

    @property
    def heading(self) -> str:
        """The title, the source, and a warning if some step is not proved."""
        source = f" [{self.source}]" if self.source else ""
        count = sum(not verdict for verdict in self.verify())
        warning = f" (NOT PROVED: {count} of {len(self.steps)} steps fail)" if count else ""
        return f"{self.title}{source}{warning}"

    def __str__(self) -> str:
        lines = (f"{i}. {step}" for i, step in enumerate(self.steps, 1))
        return "\n".join((self.heading, *lines))

    def __repr__(self) -> str:
        lines = (f"{i}. {step!r}" for i, step in enumerate(self.steps, 1))
        return "\n".join((self.heading, *lines))

    def _repr_latex_(self) -> str:
        lines = [rf"&\textbf{{{_escaped(self.heading)}}}"]
        for i, step in enumerate(self.steps, 1):
            lines.append(rf"&\text{{{i}. {_escaped(step.because)}:}}")
            lines.append(rf"&\qquad {step.latex()}")
        rows = r" \\[4pt] ".join(lines)
        return rf"$\displaystyle \begin{{aligned}} {rows} \end{{aligned}}$"


def _escaped(text: str) -> str:
    special = {"\\": r"\backslash ", "$": r"\$", "%": r"\%", "&": r"\&", "#": r"\#", "_": r"\_"}
    special |= {"{": r"\{", "}": r"\}", "^": r"\wedge ", "~": r"\sim "}
    return "".join(special.get(character, character) for character in text)

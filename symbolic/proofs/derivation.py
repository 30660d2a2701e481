"""Derivations: equalities with reasons, every one of them checked by machine."""

from __future__ import annotations

import re
from dataclasses import dataclass
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
    place = f"in {verdict.where} " if isinstance(verdict, Refuted) and verdict.where else ""
    return place + str(verdict).partition(": ")[2].rstrip(".")


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
        """Whether every single step is proved, and there is one."""
        return bool(self.steps) and all(self.verify())

    @property
    def heading(self) -> str:
        """The title, the source, and a warning if some step is not proved."""
        source = f" [{self.source}]" if self.source else ""
        count = sum(not verdict for verdict in self.verify())
        warning = f" (NOT PROVED: {count} of {len(self.steps)} steps fail)" if count else ""
        warning = warning if self.steps else " (NOT PROVED: it has no steps)"
        return f"{self.title}{source}{warning}"

    def __str__(self) -> str:
        lines = (f"{i}. {step}" for i, step in enumerate(self.steps, 1))
        return "\n".join((self.heading, *lines))

    def __repr__(self) -> str:
        lines = (f"{i}. {step!r}" for i, step in enumerate(self.steps, 1))
        return "\n".join((self.heading, *lines))

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex()}$"

    def latex(self) -> str:
        """Return the title and all steps with their reasons as one aligned block of LaTeX."""
        lines = [rf"&\textbf{{{_escaped(self.heading)}}}"]
        for i, step in enumerate(self.steps, 1):
            lines.append(rf"&\text{{{i}. {_escaped(step.because)}:}}")
            lines.append(rf"&\qquad {step.latex()}")
        rows = r" \\[4pt] ".join(lines)
        return rf"\begin{{aligned}} {rows} \end{{aligned}}"


def _escaped(text: str) -> str:
    r"""Return words for \text: MathJax takes \$, \{, \} and formulas there, nothing else.

    >>> _escaped("50% of C^2 in P_0")
    '50$\\%$ of C$^{2}$ in P$\\_$0'
    >>> print(_escaped("s'' of Runge's curve"))
    s$''$ of Runge's curve
    """
    special = {"$": r"\$", "{": r"\{", "}": r"\}", "^": r"$\wedge$", "~": r"$\sim$"}
    special |= {"\\": r"$\backslash$", **{c: rf"$\{c}$" for c in "%&#_"}}
    parts = _POWER.split(text)  # words and exponents in turn
    words = ["".join(special.get(c, c) for c in part) for part in parts[::2]]
    words = [_PRIMES.sub(r"$\1$", word) for word in words]
    exponents = [f"$^{{{exponent}}}$" for exponent in parts[1::2]]
    return "".join(w + e for w, e in zip(words, [*exponents, ""], strict=True))


_PRIMES = re.compile(r"(?<=\b[a-z])('+)(?![a-z])")  # s'' would become s and a closing quote
_POWER = re.compile(r"\^([A-Za-z0-9]+|-[0-9]+)")

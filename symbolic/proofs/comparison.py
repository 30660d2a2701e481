"""Comparing two expressions without corners: proved, refuted by a witness, or undecided."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from .generators import Generator, NoNormalForm
from .normal_form import NormalForms
from .size import named
from .verdict import Proved, Undecided, Verdict
from .witness import (
    Windows,
    algebraic_witness,
    enclosed_witness,
    free_symbols,
    is_somewhere_defined,
    numbers_in,
)


def compared(
    forms: NormalForms, places: tuple[int, int], sides: Sequence[sp.Expr], windows: Windows
) -> Verdict:
    """Decide whether the two expressions at these places of some normal forms are equal.

    Symbols in `windows` are confined to open intervals; an identity there is one everywhere, and
    a witness is taken from there.
    """
    try:
        return _verdict(forms, places, sides, [forms.element(p) for p in places], windows)
    except NoNormalForm as reason:
        return Undecided(str(reason))
    except RecursionError:  # SymPy's own traversals
        return Undecided("an expression is nested too deeply")


def _verdict(
    forms: NormalForms,
    places: tuple[int, int],
    sides: Sequence[sp.Expr],
    elements: Sequence[Any],
    windows: Windows,
) -> Verdict:
    difference, divisors = forms.difference(*elements), forms.divisors(*places)
    leaves = forms.leaves(*places)
    independent = forms.generators.are_independent(leaves)
    generators = [forms.generators.listed[i] for i in sorted(leaves)]
    if not all(divisors):
        return Undecided("a denominator is identically zero")
    if not difference:
        if independent or is_somewhere_defined(sides, windows):
            return Proved(_kind(generators, bool(divisors)))
        return Undecided("equal in form, but it is not certain where both sides are defined")
    if independent and not any(
        g.kind == "angle" and g.expression.free_symbols & set(windows) for g in generators
    ):
        witness = algebraic_witness(forms.generators, elements, [difference, *divisors], windows)
        others = {s: next(numbers_in(windows.get(s))) for s in free_symbols(sides)}
        return replace(witness, witness={**others, **witness.witness})
    found = enclosed_witness(sides[0], sides[1], windows)
    if found is not None:  # a refutation is false in a condition
        return found
    return Undecided(f"equal only if something is known about {_names(generators)}")


def _names(generators: Sequence[Generator]) -> str:
    unknown = [g for g in generators if g.kind in ("angle", "other")]
    return ", ".join(sorted({named(g.expression) for g in unknown}))


def _kind(generators: Sequence[Generator], divides: bool) -> str:
    """Name the structure in which two expressions were compared."""
    roots = [g for g in generators if g.kind == "number" and g.expression is not sp.pi]
    names = sorted(
        dict.fromkeys(named(g.expression) for g in generators if g not in roots), key=len
    )
    if not names:
        return "numbers"
    if len(names) > 6:
        names = [*names[:3], "...", names[-1]]
    form = "rational functions" if divides else "polynomials"
    field = "algebraic" if roots else "rational"
    return f"{form} in {', '.join(names)} with {field} coefficients"

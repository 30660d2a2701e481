"""Checking somebody's blossom: which of the three axioms fails, and where it shows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from ..dag import substitute, symbols_in
from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list, by_name, exact
from ..proofs.generators import NoNormalForm
from ..proofs.proof import prove
from ..proofs.side import evaluated
from ..proofs.verdict import Refuted, Undecided, Verdict
from .blossom import blossom


def check_blossom(
    candidate: Any,
    polynomial: Any,
    arguments: Sequence[sp.Symbol] | None = None,
    t: sp.Symbol = PARAMETER,
) -> Verdict:
    r"""Decide whether a candidate is the blossom of a polynomial, axiom by axiom.

    The blossom with n arguments is the only f that is multi-affine, f(..., (1-w)a + wb, ...) =
    (1-w) f(..., a, ...) + w f(..., b, ...), symmetric, and has f(t, ..., t) = F(t).

    Parameters
    ----------
    candidate : expression, or a list of expressions (one per coordinate)
    polynomial : polynomial in t, or a list of the same length
    arguments : list of Symbol, optional
        The arguments of the candidate; by default its symbols that do not occur in the
        polynomial, by name. Give them when the candidate does not mention all of them.
    t : Symbol

    Returns
    -------
    Verdict
        `Proved`; or `Refuted`, where the diagnosis names the axioms that fail, `where` the first
        of them, and the witness gives values at which its two sides differ; or `Undecided`, if no
        axiom fails but for some of them it is not known whether they hold.

    Raises
    ------
    BadValue, BadType
        For lists of different lengths, or arguments that are not a list of different symbols.
    NotExact
        For floats.

    Examples
    --------
    >>> a, b, t = sp.symbols("a b t")
    >>> check_blossom(a*b, t**2)
    Proved: multi-affine, symmetric, and on the diagonal the polynomial: this is the blossom.
    >>> print(check_blossom(a**2/2 + b**2/2, t**2).diagnosis)
    Not multi-affine: it is not affine in a.
    >>> print(check_blossom((a + 2*b)/3, t, [a, b]).diagnosis)
    Not symmetric: exchanging a and b changes the value.
    """
    expected = _coordinates(polynomial)
    try:
        given = tuple(evaluated(e, keep_operators=False) for e in _coordinates(candidate))
    except NoNormalForm as reason:
        return Undecided(str(reason))
    if len(given) != len(expected):
        raise BadValue(
            f"{len(expected)} coordinates, as the polynomial has",
            f"{len(given)}",
            "Give one expression per coordinate.",
        )
    blossom(list(expected), t)  # refuses what is no polynomial
    u = _arguments(given, expected, arguments, t)
    variable = by_name(t)
    if variable not in u and variable in symbols_in(given):
        renamed = substitute(given, {variable: sp.Symbol(f"{t.name}_1")})
        verdict = prove(renamed, list(given))
        if not verdict:
            return replace(verdict, diagnosis=_not_polar(given, expected, t))
        given = tuple(renamed)  # it cancels
    return _by_axioms(_claims(given, expected, u, variable))


_AXIOMS = {
    "Not multi-affine": "the first axiom, multi-affine",
    "Not symmetric": "the second axiom, symmetric",
    "Wrong diagonal": "the third axiom, the diagonal",
}
_RIGHT = "Proved: multi-affine, symmetric, and on the diagonal the polynomial: this is the blossom."


def _by_axioms(claims: Iterable[tuple[str, str, list[sp.Expr], list[sp.Expr]]]) -> Verdict:
    """Sum up the verdicts on all claims: what is refuted first, then what is not known."""
    failures: dict[str, Refuted] = {}
    undecided: Undecided | None = None
    for axiom, sentence, left, right in claims:
        if axiom in failures:
            continue
        verdict = prove(left, right)
        if isinstance(verdict, Refuted):
            failures[axiom] = replace(
                verdict, where=_AXIOMS[axiom], diagnosis=f"{axiom}: {sentence}."
            )
        elif isinstance(verdict, Undecided):
            because = f"{_AXIOMS[axiom].capitalize()}, could not be decided: {verdict.why}."
            undecided = replace(verdict, diagnosis=because)
    if failures:
        diagnosis = " ".join(refuted.diagnosis for refuted in failures.values())
        return replace(next(iter(failures.values())), diagnosis=diagnosis)
    return replace(verdict, diagnosis=_RIGHT) if undecided is None else undecided


def _not_polar(given: Sequence[sp.Expr], expected: Sequence[sp.Expr], t: sp.Symbol) -> str:
    """Answer a candidate that still depends on the parameter of the polynomial."""
    if prove(list(given), list(expected)):
        return "This is the polynomial itself: a blossom has one argument per degree."
    return f"It still contains {t}: a blossom has arguments of its own, one per degree."


def _claims(
    f: Sequence[sp.Expr], polynomial: Sequence[sp.Expr], u: Sequence[sp.Symbol], t: sp.Symbol
) -> Iterator[tuple[str, str, list[sp.Expr], list[sp.Expr]]]:
    """Yield (axiom if it fails, how, left sides, right sides), argument by argument."""
    w = sp.Symbol("w_affine")
    for x in u:
        a, b = sp.Symbol(f"{x}_a"), sp.Symbol(f"{x}_b")
        mixed = substitute(f, {x: (1 - w) * a + w * b})
        ends = zip(substitute(f, {x: a}), substitute(f, {x: b}), strict=True)
        yield ("Not multi-affine", f"it is not affine in {x}", mixed,
               [(1 - w) * p + w * q for p, q in ends])  # fmt: skip
    for x, y in zip(u, u[1:], strict=False):
        yield ("Not symmetric", f"exchanging {x} and {y} changes the value",
               substitute(f, {x: y, y: x}), list(f))  # fmt: skip
    equal = ", ".join([str(t)] * len(u))
    yield ("Wrong diagonal", f"f({equal}) is not the polynomial",
           substitute(f, dict.fromkeys(u, t)), list(polynomial))  # fmt: skip


def _coordinates(value: Any) -> tuple[sp.Expr, ...]:
    listed = as_list(value)
    return tuple(by_name(exact(e)) for e in (listed if listed is not None else [value]))


def _arguments(
    given: Sequence[sp.Expr],
    expected: Sequence[sp.Expr],
    arguments: Sequence[sp.Symbol] | None,
    t: sp.Symbol,
) -> list[sp.Symbol]:
    if arguments is None:
        free = symbols_in(given) - symbols_in((*expected, by_name(t)))
        return sorted(free, key=lambda s: (len(s.name), s.name))
    listed = as_list(arguments)
    if listed is None:
        raise BadType("a list of symbols", shown(arguments), "Write symbols('u1:4').")
    symbols = [by_name(x) for x in listed if isinstance(x, sp.Symbol)]
    if len({*symbols}) < len(listed):
        raise BadValue("different symbols as arguments", shown(arguments), "Write symbols('u1:4').")
    return symbols

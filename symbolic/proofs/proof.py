"""Deciding equality exactly: `prove(left, right)`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from typing import Any

import sympy as sp

from ..errors import BadType
from .assumptions import as_declared
from .comparison import compared
from .generators import NoNormalForm
from .normal_form import NormalForms
from .pieces import compared_in_pieces
from .side import Side, evaluated, has_corners, read_side
from .verdict import Proved, Refuted, Undecided, Verdict

_TOO_DEEP = Undecided("an expression is nested too deeply")


def prove(left: Any, right: Any) -> Verdict:
    """Decide whether two expressions, matrices or lists of expressions are equal.

    Both sides are brought to a normal form in one polynomial ring or fraction field, in which
    roots and the sines and cosines of base angles obey their relations. Symbols are matched by
    name (witnesses respect what was declared about them); quotients are compared wherever both
    sides are defined. The variable of piecewise expressions (also Abs, Max, Min) is real: they are
    compared on every interval between break points and at each of these. An equality is never
    concluded from samples; what algebra cannot decide, such as exp(t) = t, is refuted by enclosing
    both sides in intervals at a few points.

    Parameters
    ----------
    left, right : numbers, SymPy expressions, matrices, or (nested) lists of these

    Returns
    -------
    Proved, Refuted or Undecided
        `Refuted` carries a witness: values of the symbols at which the sides differ.

    Raises
    ------
    BadType
        If the two sides do not have the same shape, or are text or equations.
    NotExact
        If one side contains a float.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> prove((1 - t)**2 + 2*t*(1 - t) + t**2, 1)
    Proved: equal as polynomials in t with rational coefficients.
    >>> prove(3*t*(1 - t)**2, 3*t**2*(1 - t))
    Refuted: at t = 1/3 the left side is 4/9 and the right side 2/9.
    >>> prove(sp.cos(2*t), 1 - 2*sp.sin(t)**2)
    Proved: equal as polynomials in cos(t), sin(t) with rational coefficients.
    >>> prove(sp.Abs(t), t)
    Refuted: at t = -1 the left side is 1 and the right side -1.
    >>> prove(sp.exp(t), 1 + t + t**2/2)
    Refuted: at t = 1 the left side is E and the right side 5/2.
    >>> prove(sp.exp(2*t), sp.exp(t)**2 + sp.log(t) - sp.log(2*t) + sp.log(2))
    Undecided: equal only if something is known about exp(2*t), log(2), log(2*t), log(t).
    """
    return prove_sides(read_side(left), read_side(right))


def prove_sides(left: Side, right: Side) -> Verdict:
    """Decide as `prove` does, for sides that are read already."""
    if left.shape != right.shape:
        raise BadType(
            f"two sides of one shape, here {shape_in_words(left.shape)} as on the left",
            f"{shape_in_words(right.shape)} on the right",
            "Compare like with like.",
        )
    verdicts: list[Verdict] = []
    places = product(*map(range, left.shape))
    for place, verdict in zip(places, _verdicts(left.scalars, right.scalars), strict=False):
        if isinstance(verdict, Refuted):
            return replace(verdict, where=_place_in_words(place))
        verdicts.append(verdict)
    undecided = [verdict for verdict in verdicts if not verdict]
    kinds = [verdict.kind for verdict in verdicts if isinstance(verdict, Proved)]
    return undecided[0] if undecided else Proved(max(kinds, key=len, default="empty lists"))


def _verdicts(left: Sequence[sp.Expr], right: Sequence[sp.Expr]) -> Iterator[Verdict]:
    """Yield the verdict on every pair; the normal forms of all smooth ones share one ring."""
    pairs: list[tuple[sp.Expr, sp.Expr] | Undecided] = []
    for a, b in zip(left, right, strict=True):
        smooth_pair = not has_corners((a, b))
        try:
            pairs.append((evaluated(a, smooth_pair), evaluated(b, smooth_pair)))
        except NoNormalForm as reason:
            pairs.append(Undecided(str(reason)))
        except RecursionError:  # SymPy's own traversals
            pairs.append(_TOO_DEEP)
    smooth = [pair for pair in pairs if isinstance(pair, tuple) and not has_corners(pair)]
    try:
        forms = NormalForms([side for pair in smooth for side in pair])
    except RecursionError:
        yield from [_TOO_DEEP] * len(pairs)
        return
    place = 0
    for given, pair in zip(zip(left, right, strict=True), pairs, strict=True):
        verdict: Verdict
        if isinstance(pair, Undecided):
            verdict = pair
        elif has_corners(pair):
            verdict = _in_pieces(pair)
        else:
            verdict = compared(forms, (place, place + 1), pair, {})
            place += 2
        yield as_declared(verdict, given, _in_pieces) if isinstance(verdict, Refuted) else verdict


def _in_pieces(pair: tuple[sp.Expr, sp.Expr]) -> Verdict:
    try:
        return compared_in_pieces(pair)
    except NoNormalForm as reason:
        return Undecided(str(reason))
    except RecursionError:
        return _TOO_DEEP


def _place_in_words(place: tuple[int, ...]) -> str:
    names = ("entry",) if len(place) == 1 else ("row", "column")
    if not place or len(place) > 2:
        return f"entry {tuple(i + 1 for i in place)}" if place else ""
    return ", ".join(f"{name} {i + 1}" for name, i in zip(names, place, strict=True))


def shape_in_words(size: tuple[int, ...]) -> str:
    """Say a shape as a person would.

    >>> shape_in_words(()), shape_in_words((3,)), shape_in_words((4, 4))
    ('one expression', 'a list of 3', '4x4 entries')
    """
    if not size:
        return "one expression"
    return f"a list of {size[0]}" if len(size) == 1 else "x".join(map(str, size)) + " entries"

"""Deciding equality exactly: `prove(left, right)`."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count, product
from typing import Any

import sympy as sp

from ..errors import BadType
from .normal_form import NoNormalForm, NormalForms, normal_forms
from .side import Side, evaluated, read_side
from .verdict import Proved, Refuted, Undecided, Verdict


def prove(left: Any, right: Any) -> Verdict:
    """Decide whether two expressions, matrices or lists of expressions are equal.

    Both sides are brought to a normal form in one polynomial ring or fraction field. Symbols are
    matched by name; quotients are compared as rational functions, that is wherever both sides are
    defined. Nothing is ever sampled: an equality is proved or refuted by algebra.

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
    >>> prove(sp.sin(t)**2 + sp.cos(t)**2, 1)
    Undecided: equal only if something is known about cos(t), sin(t).
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
    for place, a, b in zip(places, left.scalars, right.scalars, strict=True):
        verdicts.append(_decide(a, b, place))
        if isinstance(verdicts[-1], Refuted):
            return verdicts[-1]
    undecided = [verdict for verdict in verdicts if not verdict]
    kinds = [verdict.kind for verdict in verdicts if isinstance(verdict, Proved)]
    return undecided[0] if undecided else Proved(max(kinds, key=len, default="empty lists"))


def _decide(left: sp.Expr, right: sp.Expr, place: tuple[int, ...]) -> Verdict:
    try:
        forms = normal_forms([evaluated(left), evaluated(right)])
    except NoNormalForm as reason:
        return Undecided(str(reason))
    except RecursionError:  # SymPy's own traversals
        return Undecided("an expression is nested too deeply")
    a, b = forms.elements
    difference = a - b  # over algebraic numbers equal quotients may be written differently
    if not difference:
        return Proved(forms.kind)
    if forms.opaque:
        unknown = ", ".join(sorted(str(g) for g in forms.generators if not g.is_Symbol))
        return Undecided(f"equal only if something is known about {unknown}")
    values = _witness(forms, difference)
    return Refuted(
        dict(zip(forms.generators, map(forms.domain.to_sympy, values), strict=False)),
        forms.domain.to_sympy(_value(a, values)),
        forms.domain.to_sympy(_value(b, values)),
        _place_in_words(place),
    )


def _witness(forms: NormalForms, difference: Any) -> list[Any]:
    """Find values of the generators, one after the other, at which the difference is not zero.

    A polynomial that is not zero has finitely many roots in its first variable, so some small
    rational value keeps it, and every divisor, from vanishing identically.
    """
    nonzero = [part for e in (difference, *forms.divisors) for part in _numer_denom(e)]
    values: list[Any] = []
    while values == [] or hasattr(nonzero[0], "ring"):
        for number in _small_rationals():
            value = forms.domain.convert(number)
            left = [polynomial.evaluate(polynomial.ring.gens[0], value) for polynomial in nonzero]
            if all(left):
                values.append(value)
                nonzero = left
                break
    return values


def _small_rationals() -> Iterator[sp.Rational]:
    """Yield 0, 1, 1/2, 1/3, ... in [0, 1], where parameters live; after a while integers too."""
    yield from (sp.Integer(0), sp.Integer(1))
    for n in count(2):
        yield from (sp.Rational(k, n) for k in range(1, n) if sp.igcd(k, n) == 1)
        if n > 4:
            yield from (sp.Integer(n - 3), sp.Integer(4 - n))


def _numer_denom(element: Any) -> tuple[Any, ...]:
    return (element.numer, element.denom) if hasattr(element, "numer") else (element,)


def _value(element: Any, values: list[Any]) -> Any:
    parts = [part(*values) for part in _numer_denom(element)]
    return parts[0] / parts[1] if len(parts) == 2 else parts[0]


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

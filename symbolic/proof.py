"""Deciding equality exactly: `prove(left, right)`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import count
from typing import Any

import sympy as sp
from sympy.logic.boolalg import Boolean

from .dag import postorder
from .errors import BadType, shown
from .exact import exact
from .normal_form import NoNormalForm, NormalForms, normal_forms
from .verdict import Proved, Refuted, Undecided, Verdict

_EVALUATED = (sp.Derivative, sp.Subs, sp.Sum, sp.Product, sp.Integral)


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
    shape_left, shape_right = shape(left), shape(right)
    if shape_left != shape_right:
        raise BadType(
            f"two sides of one shape, here {_shape_in_words(shape_left)} as on the left",
            f"{_shape_in_words(shape_right)} on the right",
            "Compare like with like.",
        )
    verdicts = []
    for (place, a), (_, b) in zip(entries(left), entries(right), strict=True):
        verdicts.append(_decide(a, b, place))
        if isinstance(verdicts[-1], Refuted):
            return verdicts[-1]
    undecided = [verdict for verdict in verdicts if not verdict]
    kinds = [verdict.kind for verdict in verdicts if isinstance(verdict, Proved)]
    return undecided[0] if undecided else Proved(max(kinds, key=len, default="empty lists"))


def shape(side: Any) -> tuple[int, ...]:
    """Return the shape of one side: () for an expression, (rows, columns) for a matrix."""
    if isinstance(side, sp.MatrixBase | sp.MatrixExpr):
        return tuple(int(size) for size in side.shape)
    if isinstance(side, Boolean) and not isinstance(side, sp.Expr):
        raise BadType("an expression", shown(side), "Give its left and right side separately.")
    if isinstance(side, str | bytes | sp.Expr) or not isinstance(side, Iterable):
        return ()
    shapes = [shape(entry) for entry in side]
    if len(set(shapes)) > 1:
        raise BadType("a list of entries of one kind", shown(side), "Make its rows equally long.")
    return (len(shapes), *(shapes[0] if shapes else ()))


def entries(side: Any, place: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], sp.Expr]]:
    """Yield every scalar of one side with its 0-based position, row by row."""
    if isinstance(side, sp.MatrixExpr):
        side = side.doit()
    if isinstance(side, sp.MatrixBase):
        side = side.tolist()
    if isinstance(side, str | bytes | sp.Expr) or not isinstance(side, Iterable):
        yield place, _evaluated(exact(side))
    else:
        for i, entry in enumerate(side):
            yield from entries(entry, (*place, i))


def _evaluated(expression: sp.Expr) -> sp.Expr:
    if any(isinstance(node, _EVALUATED) for node in postorder([expression])):
        return exact(expression.doit())
    return expression


def _decide(left: sp.Expr, right: sp.Expr, place: tuple[int, ...]) -> Verdict:
    try:
        forms = normal_forms([left, right])
    except NoNormalForm as reason:
        return Undecided(str(reason))
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


def _shape_in_words(size: tuple[int, ...]) -> str:
    if not size:
        return "one expression"
    return f"{size[0]} entries" if len(size) == 1 else "x".join(map(str, size))

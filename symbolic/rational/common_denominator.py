"""Plane and space curves as polynomials over one denominator: c(t) = (X(t), Y(t), ...) / W(t)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce
from typing import Any

import sympy as sp
from sympy.polys.densearith import dup_exquo
from sympy.polys.densebasic import dup_strip
from sympy.polys.domains.domain import Domain
from sympy.polys.euclidtools import dup_gcd

from ..curves.conversion import polynomial_to_bezier
from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list
from ..polynomials import Coefficients, expression, polynomials
from ..real_numbers import real
from .homogeneous import decidable_field
from .rational_bezier import RationalBezier


def over_one_denominator(
    curve: RationalBezier | Any, parameter: sp.Symbol = PARAMETER
) -> tuple[Domain, list[Coefficients]]:
    """Return X, Y, ..., W of a curve as coefficients in one field, without common factor.

    Parameters
    ----------
    curve : RationalBezier, or one rational function of the parameter per coordinate

    Raises
    ------
    BadValue, BadType, NotExact
        For coordinates that are no rational functions of the parameter, with numbers, roots and
        other symbols as coefficients.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> field, rows = over_one_denominator([(1 - t**2)/(1 + t**2), 2*t/(1 + t**2)])
    >>> [list(map(field.to_sympy, row)) for row in rows]
    [[-1, 0, 1], [2, 0], [1, 0, 1]]
    """
    if isinstance(curve, RationalBezier):
        numerators, denominator = curve.fractions
        decidable_field([*sum(curve.points, ()), *curve.weights])
        field, found = polynomials((*numerators, denominator), PARAMETER)
    else:
        field, found = _of_expressions(_read(curve), parameter)
    if _have_nothing_in_common(found, field):
        return field, found
    common = reduce(lambda a, b: dup_gcd(a, b, field), found)
    return field, [dup_exquo(p, common, field) if p else [] for p in found]


def _have_nothing_in_common(forms: list[Coefficients], field: Domain) -> bool:
    """Prove it with numbers for the symbols, where no root at infinity is in common either."""
    return any(
        len(reduce(lambda a, b: dup_gcd(a, b, numbers), some)) == 1
        and max(map(len, some)) == max(map(len, forms))
        for numbers, some in with_numbers(forms, field)
    )


def with_numbers(
    forms: list[Coefficients], field: Domain
) -> Iterator[tuple[Domain, list[Coefficients]]]:
    """Yield a few examples of polynomials with symbols, small rationals put in their places.

    What is in general is so for all values but exceptional ones; what one example excludes, such as
    a common factor, is excluded in general. Without symbols the polynomials are their own example.
    """
    if not field.is_FractionField:
        yield field, forms
        return
    numbers = field.domain
    for start in (2, 5, 11):
        values = [numbers(k**3 + start) / numbers(k + 3) for k in range(len(field.symbols))]
        try:
            yield (
                numbers,
                [dup_strip([c.numer(*values) / c.denom(*values) for c in p]) for p in forms],
            )
        except ZeroDivisionError:
            continue


def rational_to_bezier(curve: Any, t: sp.Symbol = PARAMETER) -> RationalBezier:
    r"""Return the rational Bezier curve over [0, 1] of a curve given by rational functions.

    Points and weights come from the Bernstein coefficients of the numerators and of their common
    denominator; the degree is the highest of theirs.

    Parameters
    ----------
    curve : one rational function of t per coordinate
    t : Symbol

    Raises
    ------
    BadValue
        If the denominator vanishes at 0 or 1, or a coordinate is no rational function of t.

    Examples
    --------
    >>> u = sp.Symbol("u")
    >>> rational_to_bezier([(1 - u**2)/(1 + u**2), 2*u/(1 + u**2)], u)
    RationalBezier(points=((1, 0), (1, 1), (0, 1)), weights=(1, 1, 2))
    """
    field, found = over_one_denominator(curve, t)
    if max(map(len, found)) < 2:
        raise BadValue("a curve", "one point", "Its coordinates should contain the parameter.")
    numerators = [expression(p, field, PARAMETER) for p in found]
    return RationalBezier.from_homogeneous(polynomial_to_bezier(numerators, PARAMETER))


def _read(curve: Any) -> list[sp.Expr]:
    entries = as_list(curve)
    if not entries:
        raise BadType(
            "a RationalBezier, or a list of coordinates",
            shown(curve),
            "Write [t, t**2], or bezier(2).curve(points); a NURBS curve has one for every span.",
        )
    return [real(entry, "coordinates") for entry in entries]


def _of_expressions(
    coordinates: Sequence[sp.Expr], t: sp.Symbol
) -> tuple[Domain, list[Coefficients]]:
    if not isinstance(t, sp.Symbol):
        raise BadType("the parameter as a Symbol", shown(t), 'Write Symbol("u").')
    t = sp.Symbol(t.name)
    field, elements = decidable_field([*coordinates, t])  # t last: the field has it in any case
    ring = field.field.ring
    denominator = reduce(lambda a, b: a.lcm(b), [e.denom for e in elements])
    whole = [e.numer * denominator.exquo(e.denom) for e in elements[:-1]]
    return _in_one_variable([*whole, denominator], ring, ring.symbols.index(t))


def _in_one_variable(
    elements: Sequence[Any], ring: Any, place: int
) -> tuple[Domain, list[Coefficients]]:
    """Read polynomials in several symbols as polynomials in one of them, over the others' field."""
    others = [symbol for i, symbol in enumerate(ring.symbols) if i != place]
    field = ring.domain.frac_field(*others) if others else ring.domain

    def coefficients(element: Any) -> Coefficients:
        parts: dict[int, dict[tuple[int, ...], Any]] = {}
        for powers, c in element.terms():
            rest = powers[:place] + powers[place + 1 :]
            parts.setdefault(powers[place], {})[rest] = c
        return [coefficient(parts.get(k, {})) for k in range(max(parts, default=-1), -1, -1)]

    def coefficient(part: dict[tuple[int, ...], Any]) -> Any:
        if not others:
            return part.get((), field.zero)
        return field(field.field.ring.from_dict(part))

    return field, [coefficients(element) for element in elements]

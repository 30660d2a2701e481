"""The blossom of a polynomial: its symmetric, multi-affine twin with one argument per degree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from operator import mul
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..dag import symbols_in
from ..errors import BadValue, shown
from ..exact import PARAMETER, Point, as_list, by_name, exact, whole_number
from ..names import unused_letter
from ..parameter_interval import read_interval
from ..polynomials import polynomials
from ..proofs.derivation import Derivation, Step
from ..written import plus, times


@dataclass(frozen=True, eq=False, repr=False)
class Blossom:
    r"""The unique symmetric, multi-affine f with f(t, ..., t) = F(t); call it with n arguments.

    f(u_1, ..., u_n) = sum_k c_k e_k(u_1, ..., u_n) / C(n, k) for F(t) = sum_k c_k t^k, with e_k
    the elementary symmetric polynomials, which a recurrence gives in O(n^2) operations. `blossom`
    makes one.

    Attributes
    ----------
    degree : int
        The number n of arguments; F may have a lower degree.
    variable : Symbol
    coordinates : tuple of Expr
        F, one polynomial per coordinate.
    is_curve : bool
        Whether values are points (tuples), not single expressions.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> f = blossom([1 + 3*t**2 - t**3, 1 + 3*t - t**3])
    >>> f(0, 0, 1)
    (1, 2)
    >>> f.control_points()
    ((1, 1), (1, 2), (2, 3), (3, 3))
    """

    degree: int
    variable: sp.Symbol
    coordinates: tuple[sp.Expr, ...]
    is_curve: bool
    field: Domain
    coefficients: tuple[Sequence[Any], ...]  # c_k / C(n, k) in the field, k = 0 ... n

    def __call__(self, *arguments: Any) -> Any:
        """Return f(u_1, ..., u_n): an expression, or for a curve a point.

        Raises
        ------
        BadValue
            If there are not exactly n arguments.
        """
        if len(arguments) != self.degree:
            raise BadValue(
                f"{self.degree} arguments, one per degree",
                f"{len(arguments)}",
                "Give the degree when you make the blossom: blossom(expr, t, degree=3).",
            )
        listed = [exact(u) for u in arguments]
        if all(u.is_Rational for u in listed):
            numbers = [self.field.convert(sp.QQ.from_sympy(u)) for u in listed]
            e = _elementary(numbers, self.field.one)
            values = tuple(
                self.field.to_sympy(sum(map(mul, row, e), self.field.zero))
                for row in self.coefficients
            )
        else:
            e = _elementary(listed, sp.S.One)
            values = tuple(
                sp.Add(*(self.field.to_sympy(c) * x for c, x in zip(row, e, strict=True) if c))
                for row in self.coefficients
            )
        return values if self.is_curve else values[0]

    def control_points(self, r: Any = 0, s: Any = 1) -> tuple[Point, ...]:
        """Return the Bezier points over [r, s]: point i is f(r, ..., r, s, ..., s), i times s.

        Examples
        --------
        >>> t = sp.Symbol("t")
        >>> blossom(t**2).control_points(-1, 1)
        ((1,), (-1,), (1,))
        """
        r, s = read_interval((r, s))
        n = self.degree
        values = [self(*[r] * (n - i), *[s] * i) for i in range(n + 1)]
        return tuple(v if self.is_curve else (v,) for v in values)

    def expression(self, *symbols: sp.Symbol) -> Any:
        """Return f written out, as a sum of products of its arguments u1, ..., un.

        It has up to 2^n terms; calling the blossom keeps them nested.

        Examples
        --------
        >>> t = sp.Symbol("t")
        >>> blossom(3*t**2 - t**3, degree=3).expression()
        -u1*u2*u3 + u1*u2 + u1*u3 + u2*u3
        """
        nested = self(*(symbols or self.arguments))
        return tuple(map(sp.expand, nested)) if self.is_curve else sp.expand(nested)

    @cached_property
    def arguments(self) -> tuple[sp.Symbol, ...]:
        """Symbols u1, ..., un for the arguments, other than those in the polynomial."""
        letter = unused_letter("uvw", (self.variable, *self.coordinates))
        return tuple(sp.symbols(f"{letter}1:{self.degree + 1}"))

    def certificate(self) -> Derivation:
        """Return the proof that this is the blossom: symmetric, multi-affine, F on the diagonal.

        Exchanging two neighbours and rotating all arguments generate every permutation, so two
        steps prove symmetry; then affine in one argument is affine in each.

        Examples
        --------
        >>> t = sp.Symbol("t")
        >>> blossom(t**3 - t).certificate().is_proved
        True
        """
        u = self.arguments
        f = self(*u)
        steps = []
        if self.degree > 1:
            exchanged = _at(f, u[:2], u[1::-1])
            steps.append(Step(exchanged, f, "two arguments exchanged"))
        if self.degree > 2:
            rotated = _at(f, u, (*u[1:], u[0]))
            steps.append(Step(rotated, f, "all arguments rotated: symmetric"))
        if self.degree:
            a, b, w = (sp.Symbol(f"{u[0]}_{x}") for x in ("a", "b", "w"))
            mixed = _at(f, u[:1], [(1 - w) * a + w * b])
            split = _weighted(w, self(a, *u[1:]), self(b, *u[1:]))
            steps.append(Step(mixed, split, f"affine in {u[0]}, so by symmetry in each argument"))
        diagonal = _at(f, u, [self.variable] * self.degree)
        given = self.coordinates if self.is_curve else self.coordinates[0]
        steps.append(Step(diagonal, given, "on the diagonal it is the polynomial itself"))
        return Derivation(f"The blossom with {self.degree} arguments: the three axioms",
                          tuple(steps), "Ramshaw, Blossoming, 1987")  # fmt: skip

    def __repr__(self) -> str:
        polynomial = ", ".join(map(str, self.coordinates))
        return f"<blossom with {self.degree} arguments of ({polynomial})>"


def blossom(expr: Any, t: sp.Symbol | None = None, degree: int | None = None) -> Blossom:
    """Return the blossom (polar form) of a polynomial, or of a curve coordinate by coordinate.

    Parameters
    ----------
    expr : polynomial in t, or a list of polynomials (one per coordinate)
    t : Symbol, optional
        The variable; by default t. Needed, or else the degree, where the polynomial has other
        symbols and no t.
    degree : int, optional
        The number of arguments; by default the degree of the polynomial. A polynomial has one
        blossom for every number of arguments from its degree on.

    Raises
    ------
    BadValue
        If expr is not a polynomial in t, or has a higher degree than asked for.

    Notes
    -----
    Ramshaw, *Blossoming*, 1987; de Casteljau, *Formes a poles*, 1985.

    Examples
    --------
    >>> t, a, b, c = sp.symbols("t a b c")
    >>> blossom(t**2, degree=3).expression(a, b, c)
    a*b/3 + a*c/3 + b*c/3
    """
    listed = as_list(expr)
    coordinates = tuple(by_name(exact(e)) for e in (listed if listed is not None else [expr]))
    if not coordinates:
        raise BadValue("at least one polynomial", "an empty list", "Write blossom([t, t**2], t).")
    variable = _variable(t, coordinates if degree is None else ())
    field, rows = polynomials(coordinates, variable)
    lowest = max(0, *(len(row) - 1 for row in rows))
    n = lowest if degree is None else whole_number(degree)
    if n is None or n < lowest:
        raise BadValue(
            f"a degree of at least {lowest}, that of the polynomial",
            shown(degree),
            "A polynomial of degree n needs n arguments or more.",
        )
    scaled = tuple(
        [c / field(int(sp.binomial(n, k))) for k, c in enumerate(_ascending(row, n, field))]
        for row in rows
    )
    return Blossom(n, variable, coordinates, listed is not None, field, scaled)


def _variable(t: Any, coordinates: Sequence[sp.Expr]) -> sp.Symbol:
    """Return the variable; coordinates without a t are refused if it was not named."""
    if t is None:
        others = sorted(map(str, symbols_in(coordinates) - {PARAMETER}))
        if others and PARAMETER not in symbols_in(coordinates):
            raise BadValue(
                f"a polynomial in {PARAMETER}, or its variable named",
                f"one in {', '.join(others)}",
                f"Write blossom(expr, {others[0]}) for a polynomial in {others[0]}.",
            )
        return PARAMETER
    if not isinstance(t, sp.Symbol):
        raise BadValue("a symbol as variable", shown(t), "Write blossom(expr, Symbol('t')).")
    return by_name(t)


def _ascending(row: Sequence[Any], n: int, field: Domain) -> list[Any]:
    return [*reversed(row), *[field.zero] * (n + 1 - len(row))]


def _elementary(arguments: Sequence[Any], one: Any) -> list[Any]:
    """Return e_0, ..., e_n of n arguments: adding u turns e_k into e_k + u e_{k-1}."""
    e = [one]
    for u in arguments:
        e = [one, *(a + u * b for a, b in zip([*e[1:], one - one], e, strict=True))]
    return e


def _weighted(w: sp.Symbol, left: Any, right: Any) -> Any:
    if isinstance(left, tuple):
        return tuple(_weighted(w, a, b) for a, b in zip(left, right, strict=True))
    return plus(times(1 - w, left), times(w, right))  # fmt: skip


def _at(value: Any, variables: Sequence[sp.Symbol], places: Sequence[sp.Expr]) -> Any:
    """Return a value of the blossom with others of its arguments: written, not carried out."""
    if isinstance(value, tuple):
        return tuple(_at(coordinate, variables, places) for coordinate in value)
    return sp.Subs(value, variables, places) if variables else value

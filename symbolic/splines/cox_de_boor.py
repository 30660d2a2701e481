"""The basis functions of B-splines: one polynomial per span, and how the recursion builds them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..errors import BadValue, shown
from ..exact import PARAMETER, whole_number
from ..polynomials import expression
from ..proofs.derivation import Step
from ..written import plus, times
from .knots import KnotVector
from .weights import power_rows


@dataclass(frozen=True, eq=False, repr=False)
class Piece:
    """A function on one span [start, end): a polynomial in t. Unpacks as (start, end, polynomial).

    Attributes
    ----------
    span : int
        The index j of the span [u_j, u_{j+1}).
    coefficients : tuple of elements of `field`, those of t^p, ..., t, 1
    """

    span: int
    start: sp.Expr
    end: sp.Expr
    coefficients: tuple[Any, ...]
    field: Domain

    @cached_property
    def polynomial(self) -> sp.Expr:
        """The polynomial in t."""
        return expression(self.coefficients, self.field, PARAMETER)

    def __iter__(self) -> Iterator[sp.Expr]:
        return iter((self.start, self.end, self.polynomial))

    def __repr__(self) -> str:
        return f"{self.polynomial} on [{self.start}, {self.end})"


Pieces = tuple[Piece, ...]


def basis_functions(knots: KnotVector) -> tuple[Pieces, ...]:
    r"""Return every basis function as its pieces, one per non-empty span of its support.

    N_{i,0} = 1 on [u_i, u_{i+1}), and with 0/0 := 0

    N_{i,p} = (t - u_i)/(u_{i+p} - u_i) N_{i,p-1}
    + (u_{i+p+1} - t)/(u_{i+p+1} - u_{i+1}) N_{i+1,p-1}.

    Examples
    --------
    >>> basis_functions(KnotVector([0, 1, 2, 3], 1))[0]
    (t on [0, 1), 2 - t on [1, 2))
    """
    field, u = knots.field, knots.knots
    pieces: list[list[Piece]] = [[] for _ in range(knots.point_count)]
    for j in knots.all_spans:
        rows = power_rows(knots, j, knots.degree, field.zero, field.one)
        columns = zip(*(weights for _, weights in rows), strict=True)
        for i, column in enumerate(columns, j - knots.degree):
            if 0 <= i < knots.point_count:
                pieces[i].append(Piece(j, u[j], u[j + 1], column, field))
    return tuple(map(tuple, pieces))


def piecewise(knots: KnotVector, pieces: Pieces) -> sp.Piecewise:
    """Return pieces as a Piecewise, zero elsewhere: spans half-open, the domain's last one closed.

    A span that begins where the domain ends is open there, so that the functions still sum to one;
    the last span of all is closed too.
    """
    t, end_of_domain, last = PARAMETER, knots.domain[1], knots.knots[-1]
    branches = []
    for start, end, polynomial in pieces:
        above = (start < t) if start == end_of_domain else (start <= t)
        below = (t <= end) if end in (end_of_domain, last) else (t < end)
        branches.append((polynomial, sp.And(above, below)))
    return sp.Piecewise(*branches, (sp.S.Zero, True), evaluate=False)  # they are disjoint already


@dataclass(frozen=True)
class Entry:
    """One entry N_{i,r} of the triangle on a span, and the weights it gives the two below it.

    Attributes
    ----------
    index, degree : int
    left, right : Expr
        The weights of N_{i,r-1} and N_{i+1,r-1}; zero where the recursion says 0/0.
    polynomial : Expr
        N_{i,r} on the span.
    """

    index: int
    degree: int
    left: sp.Expr
    right: sp.Expr
    polynomial: sp.Expr

    @property
    def name(self) -> str:
        """Its name, such as N_2,1 for index 2 and degree 1."""
        return f"N_{self.index},{self.degree}"

    def __str__(self) -> str:
        if not self.degree:
            return f"{self.name} = {self.polynomial}"
        below = f"N_{self.index},{self.degree - 1}", f"N_{self.index + 1},{self.degree - 1}"
        terms = [f"({w})*{b}" for w, b in zip((self.left, self.right), below, strict=True) if w]
        return f"{self.name} = {' + '.join(terms) or 0} = {self.polynomial}"

    def latex(self) -> str:
        """Return the recursion and its result as a line of an aligned block of LaTeX."""
        i, r, value = self.index, self.degree, sp.latex(self.polynomial)
        below = f"N_{{{i},{r - 1}}}", f"N_{{{i + 1},{r - 1}}}"
        terms = [rf"\left({sp.latex(w)}\right) {b}"
                 for w, b in zip((self.left, self.right), below, strict=True) if w]  # fmt: skip
        recursion = f" = {' + '.join(terms)}" if terms else ""
        return f"N_{{{i},{r}}} &{recursion} = {value}"


@dataclass(frozen=True, repr=False)
class Triangle:
    """The triangle of Cox and de Boor on one span: levels[r] holds N_{j-r,r}, ..., N_{j,r}."""

    span: int
    levels: tuple[tuple[Entry, ...], ...]

    def __str__(self) -> str:
        return "\n".join(str(entry) for level in self.levels for entry in level)

    def __repr__(self) -> str:
        return str(self)

    def _repr_latex_(self) -> str:
        lines = [entry.latex() for level in self.levels for entry in level]
        rows = r" \\ ".join(lines)
        return rf"$\displaystyle \begin{{aligned}} {rows} \end{{aligned}}$"


def triangle(knots: KnotVector, span: Any) -> Triangle:
    """Return the recursion of Cox and de Boor on one span of the domain, level by level.

    Raises
    ------
    BadValue
        If the index is not one of the non-empty spans.

    Notes
    -----
    Cox 1972; de Boor, *On calculating with B-splines*, 1972.

    Examples
    --------
    >>> print(triangle(KnotVector([0, 1, 2, 3], 1), 1))
    N_1,0 = 1
    N_0,1 = (2 - t)*N_1,0 = 2 - t
    N_1,1 = (t - 1)*N_1,0 = t - 1
    """
    knots.interval(span)
    return _triangle(knots, int(span), knots.field.zero, knots.field.one)


def _triangle(knots: KnotVector, span: int, origin: Any, unit: Any) -> Triangle:
    """Return the triangle in the parameter t of which origin + unit * t runs over the knots."""
    field = knots.field
    x = expression((unit, origin), field, PARAMETER)
    levels = []
    for r in range(knots.degree + 1):
        rows = power_rows(knots, span, r, origin, unit)
        columns = zip(*(weights for _, weights in rows), strict=True)
        levels.append(
            tuple(
                Entry(i, r, *_weights(knots, i, r, span, x), expression(column, field, PARAMETER))
                for i, column in enumerate(columns, span - r)
            )
        )
    return Triangle(span, tuple(levels))


def _weights(knots: KnotVector, i: int, r: int, span: int, x: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the recursion's two weights on a span; those of functions that are zero there are 0.

    This covers 0/0 := 0, since a function over an empty interval is zero everywhere.
    """
    u = knots.knots
    left = (x - u[i]) / (u[i + r] - u[i]) if r and i > span - r else sp.S.Zero
    right = (u[i + r + 1] - x) / (u[i + r + 1] - u[i + 1]) if r and i < span else sp.S.Zero
    return left, right


def local_triangle(knots: KnotVector, span: int) -> Triangle:
    """Return the triangle in the local parameter: t in [0, 1] runs over the span."""
    start, end = knots.elements[span], knots.elements[span + 1]
    return _triangle(knots, span, start, end - start)


def triangle_steps(levels: tuple[tuple[Entry, ...], ...]) -> list[Step]:
    """Return the recursion on a span as steps: every entry from the two below it."""
    steps = []
    for below, level in zip(levels, levels[1:], strict=False):
        known = {entry.index: entry.polynomial for entry in below}
        for entry in level:
            terms = [
                times(weight, known[i])
                for weight, i in ((entry.left, entry.index), (entry.right, entry.index + 1))
                if i in known
            ]
            side = plus(*terms) if len(terms) > 1 else terms[0]
            steps.append(
                Step(side, entry.polynomial, f"the recursion of Cox and de Boor for {entry.name}")
            )
    return steps


def function_index(knots: KnotVector, index: Any) -> int:
    """Return the index of a basis function, or say which there are."""
    i = whole_number(index)
    if i is None or not 0 <= i < knots.point_count:
        raise BadValue(
            f"the index 0 ... {knots.point_count - 1} of a basis function",
            shown(index),
            "There is one function for every control point.",
        )
    return i

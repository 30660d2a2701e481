"""Which basis a matrix belongs to, and in which of the printed conventions it stands."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, Literal

import sympy as sp

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, by_name
from ..exact_matrix import dense
from ..fields import common_field
from ..proofs.side import read_side
from .basis import Basis
from .recognise import CONSTRAINTS, candidates

Powers = Literal["descending", "ascending"]
Layout = Literal["TMG", "GMT"]
_POWERS: tuple[Powers, ...] = ("descending", "ascending")
_LAYOUTS: tuple[Layout, ...] = ("TMG", "GMT")


@dataclass(frozen=True, repr=False)
class Identification:
    """A basis and the convention in which its matrix is the one asked about.

    Attributes
    ----------
    basis : Basis
    powers, layout, geometry : as in `Basis.matrix_as`
        The order of the powers of t, the order of the product, and the order of G.
    factor : Expr
        By which the matrix is too large: 6 if 1/6 stands in front of it.
    """

    basis: Basis
    powers: Powers
    layout: Layout
    geometry: tuple[str, ...]
    factor: sp.Expr = sp.S.One

    @property
    def matrix(self) -> sp.ImmutableMatrix:
        """The matrix, rebuilt from the basis and the convention."""
        return self.factor * self.basis.matrix_as(self.powers, self.layout, self.geometry)

    def __str__(self) -> str:
        n = self.basis.degree
        names = [f"t^{k}" if k > 1 else "t" for k in range(n, 0, -1)] + ["1"]
        names = [*names[:2], "...", *names[-2:]] if n > 5 else names
        powers = " ".join(names if self.powers == "descending" else names[::-1])
        entries = ", ".join(self.geometry)
        start = f"{self.basis.name}: c(t) = " + ("" if self.factor == 1 else f"{1 / self.factor} ")
        if self.layout == "TMG":
            return f"{start}[{powers}] M G with the column G = ({entries})"
        return f"{start}G M [{powers}]^T with the row G = ({entries})"

    def __repr__(self) -> str:
        return f"<{self}>"


def identify(matrix: Any) -> list[Identification]:
    r"""Return every known basis and convention that has this matrix, the most specific ones first.

    Known are the families (Bernstein, Hermite, uniform B-spline, Catmull-Rom with any knots,
    cardinal, Kochanek-Bartels, monomial, Lagrange); and, if it is none of these, every basis that
    has values and derivatives at some parameters as its geometry. Parameters of a family are solved
    for exactly. Every candidate reproduces the matrix; that of no known basis gives an empty list.

    Parameters
    ----------
    matrix : square matrix of numbers, roots and symbols
        In any order of powers and geometry, written for c = T M G or c = G M T. If it is that of
        no basis, a common factor may have been left out of it: then 1/6 M, say, is recognised.

    Returns
    -------
    list of Identification
        A symmetric matrix, such as that of the Bernstein basis, belongs to both layouts. Knots of
        Catmull-Rom are given with t_1 = 0 and t_2 = 1, since only their ratios count.

    Raises
    ------
    BadType, BadValue, NotExact
        For other things than an exact matrix, and for a matrix that contains t.

    Examples
    --------
    >>> from symbolic import hermite
    >>> print(*identify(hermite().matrix_as("ascending", "GMT")), sep="\n")
    Hermite basis of degree 3: c(t) = G M [1 t t^2 t^3]^T with the row G = (P0, P1, T0, T1)
    >>> T = sp.Symbol("T")
    >>> print(identify([[(T - 1)/2, (T + 3)/2, -(T + 3)/2, (1 - T)/2], [1 - T, -(T + 5)/2, T + 2,
    ...                 (T - 1)/2], [(T - 1)/2, 0, (1 - T)/2, 0], [0, 1, 0, 0]])[0].basis.name)
    cardinal basis with tension T
    """
    rows = _rows(matrix)
    size = len(rows)
    if size < 2 or size != len(rows[0]):
        return []
    return _identified(rows, scaled=False) or _identified(rows, scaled=True)


def _identified(rows: Sequence[Sequence[sp.Expr]], scaled: bool) -> list[Identification]:
    found = []
    for layout, powers in product(_LAYOUTS, _POWERS):
        canonical = rows if layout == "TMG" else [list(row) for row in zip(*rows, strict=True)]
        canonical = canonical if powers == "descending" else canonical[::-1]
        factor = _factor(canonical) if scaled else sp.S.One
        if not factor:
            continue
        unscaled = [[entry / factor for entry in row] for row in canonical] if scaled else canonical
        for rank, basis, order in candidates(dense(unscaled)):
            candidate = Identification(basis, powers, layout, order, factor)
            if _equal(candidate.matrix, rows):
                standard = order == tuple(entry.name for entry in basis.geometry)
                key = (rank, not standard, powers == "ascending", layout == "GMT")
                found.append((key, candidate))
    found.sort(key=lambda pair: pair[0])
    named = [candidate for (rank, *_), candidate in found if rank < CONSTRAINTS]
    return named or [candidate for _, candidate in found]


def _factor(canonical: Sequence[Sequence[sp.Expr]]) -> sp.Expr:
    """Return the sum of the constant terms, which is c(0) = 1 where all points are 1."""
    field, elements = common_field(canonical[-1])
    return field.to_sympy(sum(elements, field.zero))


def _rows(matrix: Any) -> list[list[sp.Expr]]:
    side = read_side(matrix)
    if len(side.shape) != 2 or not side.scalars:
        raise BadType("a matrix", shown(matrix), "Give a SymPy matrix or a list of rows.")
    scalars = [by_name(scalar) for scalar in side.scalars]
    if any(PARAMETER in scalar.free_symbols for scalar in scalars):
        raise BadValue(
            f"a matrix without the parameter {PARAMETER}",
            shown(matrix),
            "Give the basis matrix, not the functions; or call the symbol otherwise.",
        )
    columns = side.shape[1]
    return [scalars[i : i + columns] for i in range(0, len(scalars), columns)]


def _equal(candidate: sp.ImmutableMatrix, rows: Sequence[Sequence[sp.Expr]]) -> bool:
    given = [entry for row in rows for entry in row]
    _, elements = common_field([*candidate.flat(), *given])
    pairs = zip(elements[: len(given)], elements[len(given) :], strict=True)
    return not any(a - b for a, b in pairs)

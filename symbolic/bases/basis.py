"""A basis of curves: the noun that every spline family returns."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list, control_points
from ..exact_matrix import dense, inverse, product, to_matrix
from ..proofs.derivation import Derivation


@dataclass(frozen=True)
class Geometry:
    """One entry of a geometry vector: its symbol, and whether it is a point or a vector.

    A point moves along when the whole curve is translated; a vector (a tangent, say) does not.
    """

    symbol: sp.Symbol
    kind: Literal["point", "vector"]

    @property
    def name(self) -> str:
        """The symbol's name, such as P0 or T1."""
        return str(self.symbol.name)

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, eq=False, repr=False)
class Basis:
    r"""Curves of one degree in terms of a geometry vector, c(t) = [t^n ... t 1] M G.

    Families (`bezier`, `hermite`, ...) and `basis_from` return one.

    Attributes
    ----------
    name : str
    geometry : tuple of Geometry
        The entries of G, in order.

    Examples
    --------
    >>> from symbolic import bezier, hermite
    >>> hermite().functions
    (2*t**3 - 3*t**2 + 1, -2*t**3 + 3*t**2, t**3 - 2*t**2 + t, t**3 - t**2)
    >>> hermite().curve([[0, 0], [1, 0], [0, 3], [0, 3]])
    (-2*t**3 + 3*t**2, 6*t**3 - 9*t**2 + 3*t)
    """

    name: str
    geometry: tuple[Geometry, ...]
    coefficients: DomainMatrix = field(metadata={"layout": "TMG, descending powers"})
    derive: Callable[[Basis], Derivation]

    @property
    def parameter(self) -> sp.Symbol:
        """The parameter t, a symbol without assumptions."""
        return PARAMETER

    @property
    def degree(self) -> int:
        """The degree n of the curves."""
        return int(self.coefficients.shape[0]) - 1

    @cached_property
    def matrix(self) -> sp.ImmutableMatrix:
        """The basis matrix M of c(t) = [t^n ... t 1] M G, exact, shape (n + 1, len(G))."""
        return to_matrix(self.coefficients)

    @cached_property
    def functions(self) -> tuple[sp.Expr, ...]:
        """The blending functions, polynomials in t, aligned with G."""
        powers = self.powers
        columns = range(self.matrix.cols)
        return tuple(
            sp.Add(*(m * p for m, p in zip(self.matrix.col(j), powers, strict=True)))
            for j in columns
        )

    @property
    def powers(self) -> tuple[sp.Expr, ...]:
        """The row [t^n ... t 1]."""
        return tuple(PARAMETER**k for k in range(self.degree, -1, -1))

    @cached_property
    def derivation(self) -> Derivation:
        """How the matrix comes about, step by step; `.verify()` checks every step."""
        return self.derive(self)

    def matrix_as(
        self,
        powers: Literal["descending", "ascending"] = "descending",
        layout: Literal["TMG", "GMT"] = "TMG",
        geometry: Sequence[str | sp.Symbol] | None = None,
    ) -> sp.ImmutableMatrix:
        """Return the basis matrix as another book prints it.

        Parameters
        ----------
        powers : "descending" or "ascending"
            Whether T runs over t^n ... t 1 or 1 t ... t^n.
        layout : "TMG" or "GMT"
            c = T M G with T a row and G a column, or c = G M T with G a row and T a column.
        geometry : all names (or symbols) of G in another order, optional
            Such as ("P0", "T0", "T1", "P1"). By default the order of `geometry`.

        Raises
        ------
        BadValue, BadType
            For another word, or names that are not those of G.

        Examples
        --------
        >>> from symbolic import bezier
        >>> bezier(1).matrix_as(powers="ascending")
        Matrix([
        [ 1, 0],
        [-1, 1]])
        >>> from symbolic import hermite
        >>> hermite().matrix_as(geometry=("P0", "T0", "T1", "P1")).row(0)
        Matrix([[2, 1, 1, -2]])
        """
        _one_of("powers", powers, ("descending", "ascending"))
        _one_of("layout", layout, ("TMG", "GMT"))
        matrix = self.matrix if powers == "descending" else self.matrix[::-1, :]
        if geometry is not None:
            matrix = matrix[:, self._places(geometry)]
        return matrix if layout == "TMG" else matrix.T

    def _places(self, order: Any) -> list[int]:
        """Return where the entries of G stand that are listed in another order."""
        listed = as_list(order)
        if listed is None:
            raise BadType("a list of names", shown(order), "Write ('P0', 'P1', 'T0', 'T1').")
        names = [entry.name for entry in self.geometry]
        asked = [str(getattr(entry, "name", entry)) for entry in listed]
        if sorted(asked) != sorted(names):
            raise BadValue(
                f"{', '.join(names)} in some order",
                shown(asked),
                f"Name every entry of the geometry vector of {self.name} once.",
            )
        return [names.index(name) for name in asked]

    def to(self, other: Basis) -> sp.ImmutableMatrix:
        """Return the conversion matrix C: geometry of `other` = C * geometry of `self`.

        C = M_other^-1 M_self, so that both describe the same curve.

        Raises
        ------
        BadValue
            If the degrees differ, or `other` cannot represent every curve of its degree.

        Examples
        --------
        >>> from symbolic import bezier, hermite
        >>> bezier(3).to(hermite())
        Matrix([
        [ 1, 0,  0, 0],
        [ 0, 0,  0, 1],
        [-3, 3,  0, 0],
        [ 0, 0, -3, 3]])
        """
        if not isinstance(other, Basis):
            raise BadType("a basis", shown(other), "Write for example hermite().to(bezier(3)).")
        if self.degree != other.degree:
            raise BadValue(
                f"another basis of degree {self.degree}, as {self.name}",
                f"{other.name}",
                "Convert between bases of one degree.",
            )
        rows, columns = other.coefficients.shape
        if rows != columns or not other.coefficients.det():
            raise BadValue(
                "a basis whose geometry determines every curve of its degree",
                f"{other.name} with a singular matrix",
                "Convert to Bezier or another complete basis.",
            )
        return to_matrix(product(inverse(other.coefficients), self.coefficients))

    def curve(self, points: Any) -> tuple[sp.Expr, ...]:
        """Return the exact curve for a geometry vector, one polynomial in t per coordinate.

        Parameters
        ----------
        points : rows, shape (len(geometry), dim)
            Points and vectors in the order of `geometry`; see `exact_points` for what is read.

        Raises
        ------
        BadValue
            If the number of rows is not that of the geometry vector.
        """
        rows = control_points(points)
        self.require_rows(len(rows))
        coefficients = self.matrix * sp.ImmutableMatrix(rows)
        return tuple(
            sp.Add(*(c * p for c, p in zip(coefficients.col(j), self.powers, strict=True)))
            for j in range(coefficients.cols)
        )

    def require_rows(self, count: int) -> None:
        """Raise `BadValue` unless a geometry vector of this basis has so many rows."""
        if count != len(self.geometry):
            raise BadValue(
                f"{len(self.geometry)} rows ({', '.join(map(str, self.geometry))})",
                f"{count}",
                f"Give one row for every entry of the geometry vector of {self.name}.",
            )

    def __reduce__(self) -> tuple[Any, ...]:
        # Bases cross process borders; SymPy's elements of fraction fields cannot be pickled.
        return _rebuilt, (self.name, self.geometry, self.matrix, self.derive)

    def __repr__(self) -> str:
        return f"<{self.name}: degree {self.degree}, G = ({', '.join(map(str, self.geometry))})>"

    def _repr_latex_(self) -> str:
        column = sp.ImmutableMatrix([entry.symbol for entry in self.geometry])
        row = sp.ImmutableMatrix([self.powers])
        parts = " ".join(sp.latex(part) for part in (row, self.matrix, column))
        return rf"$\displaystyle \mathbf c(t) = {parts}$"


def _rebuilt(name: str, geometry: Any, matrix: sp.ImmutableMatrix, derive: Any) -> Basis:
    return Basis(name, geometry, dense(matrix.tolist()), derive)


def _one_of(name: str, value: Any, choices: tuple[str, ...]) -> None:
    if not isinstance(value, str) or value not in choices:
        raise BadValue(
            f"{name} to be {' or '.join(map(repr, choices))}", shown(value), "Choose one of these."
        )

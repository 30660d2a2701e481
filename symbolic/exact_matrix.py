"""The exact linear algebra behind bases: small dense matrices over QQ or QQ(parameters).

SymPy's dense DomainMatrix is used throughout (with FLINT below it where installed): the inverse
of the degree 7 Hermite constraints takes microseconds there, milliseconds with `Matrix.inv`.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from .fields import common_field


def dense(rows: Sequence[Sequence[sp.Expr | int]]) -> DomainMatrix:
    """Return rows of exact expressions as a dense matrix over the smallest field that fits.

    >>> dense([[sp.Integer(1), sp.Rational(1, 2)]]).domain
    QQ
    """
    field, elements = common_field(entry + sp.S.Zero for row in rows for entry in row)
    shape = (len(rows), len(rows[0]) if rows else 0)
    return DomainMatrix.from_list_flat(elements, shape, field).to_dense()


def product(left: DomainMatrix, right: DomainMatrix) -> DomainMatrix:
    """Return left * right over a common field."""
    left, right = left.unify(right)
    return (left * right).to_dense()


def to_matrix(matrix: DomainMatrix) -> sp.ImmutableMatrix:
    """Return the matrix as SymPy's public immutable type."""
    return sp.ImmutableMatrix(matrix.to_Matrix())


def solution(matrix: DomainMatrix, column: DomainMatrix) -> DomainMatrix | None:
    """Return the unique x with matrix * x = column, or None if there is none or not just one.

    >>> solution(dense([[1, 1], [1, -1]]), dense([[3], [1]])).to_Matrix()
    Matrix([
    [2],
    [1]])
    """
    matrix, column = matrix.unify(column)
    reduced, pivots = matrix.hstack(column).rref()
    unknowns = matrix.shape[1]
    if pivots != tuple(range(unknowns)):
        return None
    return reduced[:unknowns, unknowns:].to_dense()

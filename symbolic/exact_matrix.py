"""The exact linear algebra behind bases: small dense matrices over QQ or QQ(parameters).

SymPy's dense DomainMatrix is used throughout (with FLINT below it where installed): the inverse
of the degree 7 Hermite constraints takes microseconds there, milliseconds with `Matrix.inv`.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.ddm import DDM

from .fields import common_field


def dense(rows: Sequence[Sequence[sp.Expr | int]]) -> DomainMatrix:
    """Return rows of exact expressions as a dense matrix over the smallest field that fits.

    >>> dense([[sp.Integer(1), sp.Rational(1, 2)]]).domain
    QQ
    """
    entries = [entry for row in rows for entry in row]
    shape = (len(rows), len(rows[0]) if rows else 0)
    if all(type(entry) is int for entry in entries):
        field, elements = sp.QQ, [sp.QQ(entry) for entry in entries]
    else:
        field, elements = common_field(sp.S.Zero + entry for entry in entries)
    return DomainMatrix.from_list_flat(elements, shape, field).to_dense()


def product(left: DomainMatrix, right: DomainMatrix) -> DomainMatrix:
    """Return left * right over a common field."""
    left, right = left.unify(right)
    return (left * right).to_dense()


def inverse(matrix: DomainMatrix) -> DomainMatrix:
    """Return the inverse; of rationals without FLINT by integers, twice as fast as by fractions.

    Raises
    ------
    DMNonInvertibleMatrixError
        For a singular matrix.

    Examples
    --------
    >>> inverse(dense([[1, 1], [0, 2]])).to_Matrix()
    Matrix([
    [1, -1/2],
    [0,  1/2]])
    """
    matrix = matrix.to_dense()
    if matrix.domain != sp.QQ or not isinstance(matrix.rep, DDM):
        return matrix.inv().to_dense()
    scale, integers = matrix.clear_denoms_rowwise(convert=True)
    numerators, common = integers.inv_den()
    factors = [sp.QQ(f) / sp.QQ(common) for f in scale.diagonal()]
    rows = numerators.to_dense().to_list()
    scaled = [sp.QQ(x) * f for row in rows for x, f in zip(row, factors, strict=True)]
    return DomainMatrix.from_list_flat(scaled, matrix.shape, sp.QQ).to_dense()


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

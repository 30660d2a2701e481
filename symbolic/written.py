"""Sums and products as they are written: not carried out, so that a reader sees their parts."""

from __future__ import annotations

from typing import Any

import sympy as sp


def plus(*terms: Any) -> sp.Add:
    """Return a sum whose terms stay as they are.

    >>> t = sp.Symbol("t")
    >>> plus(1 - t, t)
    t + (1 - t)
    """
    return sp.Add(*terms, evaluate=False)


def times(*factors: Any) -> Any:
    """Return a product whose factors stay as they are; of matrices, if one of them is a matrix.

    >>> t = sp.Symbol("t")
    >>> times(2, 1 - t)
    2*(1 - t)
    """
    of_matrices = any(isinstance(factor, sp.MatrixBase | sp.MatrixExpr) for factor in factors)
    return (sp.MatMul if of_matrices else sp.Mul)(*factors, evaluate=False)

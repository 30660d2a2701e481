"""Mistakes that can be made in any exercise, derived from the right answer."""

from __future__ import annotations

from itertools import permutations
from typing import Any

import sympy as sp
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError

from ..dag import substitute, symbols_in
from ..errors import BadValue
from ..exact import PARAMETER
from ..exact_matrix import dense, inverse, to_matrix
from ..proofs.generators import NoNormalForm
from ..proofs.side import evaluated, read_side


def typical_mistakes(expected: Any) -> dict[str, Any]:
    """Return the wrong answers that typical mistakes lead to, by the sentence that names them.

    A square SymPy matrix is taken for a basis matrix, a list of rows for points. Wrong answers
    that happen to be right (a symmetric matrix transposed) are left out.

    >>> t = sp.Symbol("t")
    >>> typical_mistakes((1 - t)**2)["The sign is reversed."]
    -(1 - t)**2
    """
    right = read_side(expected)
    size = right.shape
    if len(size) == 2:
        matrix = sp.ImmutableMatrix(*size, right.scalars)
        square = isinstance(expected, sp.MatrixBase) and size[0] == size[1]
        found = _of_matrices(matrix) if square else _of_points(matrix)
        found["All signs are reversed."] = -matrix
    elif size == ():
        try:  # evaluated, symbols have no assumptions
            matrix = evaluated(right.scalars[0], keep_operators=False)
        except NoNormalForm:
            return {}
        found = _of_expressions(matrix)
    else:
        return {}
    return {sentence: wrong for sentence, wrong in found.items() if wrong != matrix}


def _of_matrices(matrix: sp.ImmutableMatrix) -> dict[str, Any]:
    found = {
        "This is the transpose: rows and columns are exchanged.": matrix.T,
        "The rows stand in reverse order; for a basis matrix, compare the order of the powers of "
        "t.": matrix[::-1, :],
        "The columns stand in reverse order; for a basis matrix, compare the order of the "
        "geometry vector.": matrix[:, ::-1],
        "This is the transpose, with its columns in reverse order.": matrix[::-1, :].T,
    }
    if matrix.rows <= 5:
        for order in list(permutations(range(matrix.cols)))[1:]:
            places = ", ".join(str(i + 1) for i in order)
            found.setdefault(
                f"The columns are right but stand in another order ({places}); for a basis matrix, "
                "compare the order of the geometry vector.", matrix[:, list(order)],
            )  # fmt: skip
    inverted = _inverse(matrix)
    if inverted is not None:
        found["This is the inverse of the matrix asked for."] = inverted
    return found


def _inverse(matrix: sp.ImmutableMatrix) -> sp.ImmutableMatrix | None:
    """Return the inverse of a matrix of numbers, if there is one."""
    try:
        numbers = dense(matrix.tolist())
        # Over rational functions an inverse can take long.
        return None if numbers.domain.is_FractionField else to_matrix(inverse(numbers))
    except (BadValue, DMNonInvertibleMatrixError):
        return None


def _of_points(points: sp.ImmutableMatrix) -> dict[str, Any]:
    found = {"These are the right points in reverse order.": points[::-1, :]}
    if points.cols == 2:
        found["The coordinates are exchanged: x comes first."] = points[:, ::-1]
    return found


def _of_expressions(expression: sp.Expr) -> dict[str, Any]:
    found = {"The sign is reversed.": -expression}
    if PARAMETER in symbols_in([expression]):
        (mirrored,) = substitute([expression], {PARAMETER: 1 - PARAMETER})
        found["t and 1 - t are exchanged: at t = 0 you are at the wrong end."] = mirrored
    return found

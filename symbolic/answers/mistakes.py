"""Mistakes that can be made in any exercise, derived from the right answer."""

from __future__ import annotations

from itertools import permutations
from typing import Any

import sympy as sp

from ..exact import PARAMETER
from ..proofs.side import read_side


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
        matrix = right.scalars[0]
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
    if not matrix.free_symbols and matrix.det() != 0:
        found["This is the inverse of the matrix asked for."] = matrix.inv()
    return found


def _of_points(points: sp.ImmutableMatrix) -> dict[str, Any]:
    found = {"These are the right points in reverse order.": points[::-1, :]}
    if points.cols == 2:
        found["The coordinates are exchanged: x comes first."] = points[:, ::-1]
    return found


def _of_expressions(expression: sp.Expr) -> dict[str, Any]:
    found = {"The sign is reversed.": -expression}
    if PARAMETER in expression.free_symbols:
        found["t and 1 - t are exchanged: at t = 0 you are at the wrong end."] = expression.subs(
            PARAMETER, 1 - PARAMETER
        )
    return found

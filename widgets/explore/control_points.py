"""Control points as explorers take them."""

from __future__ import annotations

from typing import Any

import numpy as np

from numeric import float_points, real_number
from symbolic.errors import BadValue, OutsideDomain, shown

HIGHEST_DEGREE = 8  # nine points still fit a screen, and nine colours can be told apart


def control_points(points: Any) -> np.ndarray:
    """Return two to nine control points in the plane, shape (n + 1, 2).

    Raises
    ------
    BadValue, BadType
        As `float_points`, for points not in the plane, and for too few or too many.
    """
    rows = float_points(points)
    if rows.shape[1] != 2 or not 2 <= len(rows) <= HIGHEST_DEGREE + 1:
        raise BadValue(
            f"2 to {HIGHEST_DEGREE + 1} control points in the plane, shape (n + 1, 2)",
            f"shape {rows.shape}",
            "Leave some out, or split the curve into parts.",
        )
    return rows


def so_many_points(points: Any, count: int, expected: str, hint: str) -> np.ndarray:
    """Return control points in the plane, exactly `count` of them."""
    rows = control_points(points)
    if len(rows) != count:
        raise BadValue(expected, f"{len(rows)}", hint)
    return rows


def cubic_points(points: Any) -> np.ndarray:
    """Return the four control points of a cubic in the plane, shape (4, 2)."""
    return so_many_points(points, 4, "four control points of a cubic", "Elevate the degree.")


def unit_parameter(t: Any) -> float:
    """Return a parameter in [0, 1] as a float."""
    number = real_number(t, "t")
    if not 0 <= number <= 1:
        raise OutsideDomain("t in [0, 1]", shown(t), "Both ends belong to it.")
    return number

"""The usual knot vectors: uniform, and clamped at the ends (Bezier curves among them)."""

from __future__ import annotations

from typing import Any

from ..bases.degree import degree_from
from ..errors import BadValue, shown
from ..exact import as_list, whole_number
from .knots import KnotVector


def uniform_knots(point_count: int, degree: int) -> KnotVector:
    """Return the knots 0, 1, 2, ... for so many control points.

    Examples
    --------
    >>> uniform_knots(4, 3).knots
    (0, 1, 2, 3, 4, 5, 6, 7)
    """
    count, p = _sizes(point_count, degree)
    return KnotVector(range(count + p + 1), p)


def clamped_knots(point_count: int, degree: int, interior: Any = None) -> KnotVector:
    """Return knots whose first and last are repeated degree + 1 times.

    The curve starts at its first control point and ends at its last. Without interior knots these
    are 1, 2, ... between 0 and the number of spans; degree + 1 points give Bezier curves on [0, 1].

    Parameters
    ----------
    point_count, degree : int
    interior : list of knots, optional
        The point_count - degree - 1 knots strictly inside (0, 1).

    Raises
    ------
    BadValue
        If there are fewer points than degree + 1, or another number of interior knots.

    Examples
    --------
    >>> clamped_knots(4, 3).knots, clamped_knots(5, 2).knots
    ((0, 0, 0, 0, 1, 1, 1, 1), (0, 0, 0, 1, 2, 3, 3, 3))
    """
    count, p = _sizes(point_count, degree)
    inside = count - p - 1
    given = list(range(1, inside + 1)) if interior is None else as_list(interior)
    if given is None or len(given) != inside:
        raise BadValue(
            f"{inside} interior knots for {count} points of degree {p}",
            shown(interior),
            "Every interior knot adds one control point.",
        )
    end = inside + 1 if interior is None else 1
    return KnotVector([0] * (p + 1) + given + [end] * (p + 1), p)


def _sizes(point_count: Any, degree: Any) -> tuple[int, int]:
    count, p = whole_number(point_count), degree_from(degree, 0)
    if count is None or count < p + 1:
        raise BadValue(
            f"at least {p + 1} control points for degree {p}", shown(point_count), "Add points."
        )
    return count, p

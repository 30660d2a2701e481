"""Reading a degree."""

from __future__ import annotations

from typing import Any

from ..errors import BadValue, shown
from ..exact import whole_number


def degree_from(n: Any, lowest: int) -> int:
    """Return a degree as an int, not below the lowest one.

    Raises
    ------
    BadValue
        If n is not a whole number, or too low.

    >>> degree_from(3, lowest=1)
    3
    """
    degree = whole_number(n)
    if degree is None or degree < lowest:
        first = ", ".join(str(lowest + i) for i in range(3))
        raise BadValue(
            f"a degree {first}, ...", shown(n), "A curve of degree n has n + 1 control points."
        )
    return degree

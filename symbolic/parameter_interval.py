"""Reading parameter intervals."""

from __future__ import annotations

from typing import Any

import sympy as sp

from .errors import BadValue, shown
from .exact import as_list, exact
from .signs import sign


def read_interval(interval: Any) -> tuple[sp.Expr, sp.Expr]:
    """Return the ends of an interval that is not a single point.

    Raises
    ------
    BadValue
        For anything but two different ends.

    Examples
    --------
    >>> read_interval((0, 1))
    (0, 1)
    """
    ends = as_list(interval)
    if ends is None or len(ends) != 2 or sign(exact(ends[1]) - exact(ends[0])) == 0:
        raise BadValue("an interval (r, s) with r != s", shown(interval), "Write (0, 1).")
    return exact(ends[0]), exact(ends[1])

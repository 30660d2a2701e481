"""Reading real numbers, and expressions that stand for real numbers."""

from __future__ import annotations

from typing import Any

import sympy as sp

from .dag import postorder
from .errors import BadValue, shown
from .exact import by_name, exact
from .radicals import is_radical


def real(value: Any, name: str = "numbers") -> sp.Expr:
    """Return a number or expression exactly, its symbols by name and standing for real numbers.

    Raises
    ------
    BadValue
        For i, roots of negative numbers, and symbols declared to be imaginary, or to be zero.
    BadType, NotExact
        As in `exact`.

    Examples
    --------
    >>> real(sp.Symbol("a", positive=True) + 1) == sp.Symbol("a") + 1
    True
    """
    given = exact(value)
    for node in postorder([given]):
        if is_radical(node) and (node is sp.I or node.base.is_negative):
            raise BadValue(f"real {name}", shown(given), "Leave complex numbers out.")
        if node.is_Symbol and node.is_real is False:
            raise BadValue(f"real {name}", f"{node}, declared not to be", "Leave it out.")
        if node.is_Symbol and node.is_zero:
            raise BadValue("free symbols", f"{node}, declared to be zero", "Write 0.")
    return by_name(given)

"""Parameters of bases: exact real numbers made of roots, and symbols of names of their own."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..dag import postorder
from ..errors import BadValue, shown
from ..exact import PARAMETER, by_name, exact
from ..fields import HIGHEST_ALGEBRAIC_DEGREE, common_field, is_radical
from ..signs import sign


def parameter_from(given: Any) -> sp.Expr:
    """Read a parameter of numbers, roots and symbols: of these, zero can be told for certain.

    Raises
    ------
    BadValue
        For functions, pi, imaginary numbers, divisions by zero, and the curve's own parameter t.
    """
    expression = exact(given)
    if expression.is_Rational:
        return expression
    expression = by_name(expression)
    common_field([expression])  # refuses functions, pi, and divisions by zero
    nodes = postorder([expression])
    imaginary = any(node.is_number and node.is_real is False for node in nodes)
    if imaginary or PARAMETER in expression.free_symbols:
        raise BadValue(
            "a parameter made of numbers, roots and other symbols than t",
            shown(given),
            "Use a rational number or a symbol such as a.",
        )
    return expression


def increasing_parameters(given: Sequence[Any]) -> tuple[sp.Expr, ...]:
    """Read parameters that increase; symbols are assumed to, unless the others contradict it.

    Raises
    ------
    BadValue
        As in `parameter_from`, and where a parameter is not larger than an earlier one.

    Examples
    --------
    >>> a = sp.Symbol("a")
    >>> increasing_parameters([0, a, 2 * a])
    (0, a, 2*a)
    """
    read = tuple(map(parameter_from, given))
    are_numbers = not any(parameter.free_symbols for parameter in read)
    for j, later in enumerate(read):
        # Numbers increase if neighbours do; symbols between them can hide a decrease.
        for earlier in read[j - 1 : j] if are_numbers else read[:j]:
            if sign(later - earlier) in (0, -1):
                raise BadValue(
                    "increasing knots",
                    f"{earlier} and then {later}",
                    "Sort them; of equal ones leave one out.",
                )
    return read


def refuse_clash(parameters: Iterable[sp.Expr], entries: Sequence[sp.Symbol]) -> None:
    """Raise `BadValue` where a symbol is both a parameter of a basis and an entry of G, or t."""
    used = {symbol for expression in parameters for symbol in expression.free_symbols}
    if clash := sorted(map(str, used.intersection((PARAMETER, *entries)))):
        raise BadValue(
            f"parameters of other names than {PARAMETER} and {', '.join(map(str, entries))}",
            f"{' and '.join(clash)}",
            "Call the parameter by another name.",
        )


def refuse_high_roots(field: Domain) -> None:
    """Refuse roots that stand as free generators: a zero made of them would not be seen."""
    roots = [str(g) for g in getattr(field, "symbols", ()) if is_radical(g)]
    if roots:
        raise BadValue(
            f"roots that together generate a field of degree at most {HIGHEST_ALGEBRAIC_DEGREE}",
            ", ".join(roots),
            "Put symbols in their place.",
        )

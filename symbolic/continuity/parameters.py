"""Reading what describes a joint: orders, interval ratios, betas."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list, by_name, exact, whole_number
from ..signs import sign


def read_degree(n: Any, lowest: int = 1) -> int:
    """Return the degree of a segment, or raise `BadValue`."""
    degree = whole_number(n)
    if degree is None or degree < lowest:
        first = ", ".join(str(lowest + i) for i in range(3))
        raise BadValue(f"a degree {first}, ...", shown(n), "A single point is no segment.")
    return degree


def read_order(k: Any, highest: int | None = None) -> int:
    """Return an order of continuity 0, 1, ..., at most `highest`.

    Raises
    ------
    BadValue
        For other values; above the degree a control point is missing for the condition.
    """
    order = whole_number(k)
    if order is None or order < 0:
        raise BadValue("an order of continuity 0, 1, 2, ...", shown(k), "C^1 has the order 1.")
    if highest is not None and order > highest:
        raise BadValue(
            f"an order up to the degree {highest}",
            f"{order}",
            "A condition of order k is about k + 1 control points: raise the degree.",
        )
    return order


def read_positive(value: Any, name: str) -> sp.Expr:
    """Return a positive number, or an expression with symbols taken to be positive.

    Symbols lose their assumptions, since they are matched by name.

    Raises
    ------
    BadValue
        For zero, negative and complex numbers, and expressions known not to be positive.
    NotExact, BadType
        As in `exact`.

    Examples
    --------
    >>> read_positive(sp.Rational(1, 2), "ratio"), read_positive(sp.Symbol("r"), "ratio")
    (1/2, r)
    """
    number = read_real(value, name)
    if sign(number) in (0, -1) or exact(value).is_positive is False:
        raise BadValue(
            f"a positive {name}",
            shown(number),
            "Otherwise the next segment would run back, or stand still.",
        )
    return number


def read_real(value: Any, name: str) -> sp.Expr:
    """Return a real number or expression without the parameter of curves.

    Raises
    ------
    BadValue
        For complex numbers, and for expressions in t.
    NotExact, BadType
        As in `exact`.
    """
    given = exact(value)
    number = by_name(given)
    if PARAMETER in number.free_symbols:
        raise BadValue(
            f"{name} without the curve's own parameter {PARAMETER}",
            shown(given),
            "Call it by another name.",
        )
    if given.is_real is False or (not number.free_symbols and sign(number) is None):
        raise BadValue(f"{name} real", shown(given), "Segments have real parameters.")
    return number


def read_betas(k: int, betas: Any) -> tuple[sp.Expr, ...]:
    """Return the shape parameters beta_1 > 0, beta_2, ..., beta_k.

    Raises
    ------
    BadType, BadValue
        For anything but k of them, the first positive.

    Examples
    --------
    >>> read_betas(2, [2, sp.Symbol("b")])
    (2, b)
    """
    given = as_list(betas)
    if given is None:
        raise BadType("the betas as a list", shown(betas), "Write (beta1, beta2), one an order.")
    if len(given) != k:
        raise BadValue(
            f"{k} betas, one for each order from 1 to {k}",
            f"{len(given)}",
            "Give beta1, beta2, ...; zeros count.",
        )
    rest = (read_real(beta, f"beta{i}") for i, beta in enumerate(given[1:], 2))
    return tuple([read_positive(beta, "beta1") for beta in given[:1]] + list(rest))


def refuse_names(expressions: Sequence[sp.Expr], taken: Sequence[sp.Symbol]) -> None:
    """Raise `BadValue` if expressions use the names of control points."""
    clash = {s for e in expressions for s in e.free_symbols} & {*taken}
    if clash:
        raise BadValue(
            "symbols other than those of the control points",
            ", ".join(sorted(map(str, clash))),
            "Call them by another name.",
        )


def refuse_dimensions(left: int, right: int) -> None:
    """Raise `BadValue` unless both segments have one dimension."""
    if left != right:
        raise BadValue(
            "two segments of one dimension",
            f"the dimensions {left} and {right}",
            "Give both the same number of coordinates.",
        )

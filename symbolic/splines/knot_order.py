"""Reading knots: exact, real, and in order as far as it can be told."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list, by_name, exact
from ..fields import common_field
from ..signs import sign


def read_knots(knots: Any, degree: int) -> tuple[sp.Expr, ...]:
    """Return knots as exact expressions, enough of them and without the curve's parameter."""
    listed = as_list(knots)
    if listed is None:
        raise BadType("a list of knots", shown(knots), "Write [0, 0, 1, 2, 2].")
    read = tuple(by_name(exact(knot)) for knot in listed)
    if len(read) < 2 * degree + 2:
        raise BadValue(
            f"at least {2 * degree + 2} knots for degree {degree}",
            f"{len(read)}",
            "There are as many knots as control points, and degree + 1 more.",
        )
    if any(PARAMETER in knot.free_symbols for knot in read):
        raise BadValue(
            f"knots without the parameter {PARAMETER}",
            shown(list(read)),
            "Call it by another name.",
        )
    return read


def in_order(knots: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """Return the knots, equal ones as the same expression, or say where they decrease."""
    field, elements = common_field(knots)
    ordered = list(knots)
    for j in range(1, len(knots)):
        # Numbers are in order if neighbours are; symbols between them can hide a decrease.
        for i in range(j - 1, -1, -1) if field.is_FractionField else (j - 1,):
            side = _sign_in(field, elements[j] - elements[i])
            if side == 0:
                ordered[j] = ordered[i]
            if side == -1 or (side == 0 and ordered[j - 1] != ordered[j]):
                raise BadValue(
                    "knots that do not decrease",
                    f"u_{j} = {knots[j]} after u_{j - 1} = {knots[j - 1]}"
                    if i == j - 1 or side == 0
                    else f"u_{j} = {knots[j]} after u_{i} = {knots[i]}",
                    "Sort them.",
                )
    return tuple(ordered)


def _sign_in(field: Domain, difference: Any) -> int | None:
    if field is sp.QQ or field == sp.QQ:
        return (difference > 0) - (difference < 0)
    if not difference:
        return 0
    number = field.to_sympy(difference)
    if number.free_symbols:
        return None
    side = sign(number)
    if side is None:
        raise BadValue("real knots", f"a difference of {number}", "Knots lie on the real line.")
    return side

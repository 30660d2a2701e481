"""Points with weights as homogeneous rows (w x, w y, ..., w), and back.

A control point of weight zero lies at infinity: only its direction counts. It is given, and shown,
as a vector v, and its homogeneous row is (v, 0) (Piegl, *On the use of infinite control points in
CAGD*, 1987).
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from itertools import accumulate
from typing import Any, NamedTuple

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, Point, as_list, exact_points
from ..fields import common_field
from ..real_numbers import real
from ..signs import sign


class HullWarning(UserWarning):
    """The curve need not lie in the convex hull of its control points."""


def read_weighted(points: Any, weights: Any) -> tuple[tuple[Point, ...], Point]:
    """Read control points and their weights exactly, symbols by name.

    Raises
    ------
    BadValue, BadType, NotExact
        For points as in `exact_points`, a number of weights that differs from that of the points,
        weights that are all zero, a first or last weight of zero, complex numbers, and the
        symbol t.
    """
    rows = tuple(tuple(real(c, "coordinates") for c in row) for row in exact_points(points))
    entries = as_list(weights)
    if entries is None:
        raise BadType("weights as a list", shown(weights), "Give one for every point: [1, 2, 1].")
    numbers = tuple(real(weight, "weights") for weight in entries)
    if len(numbers) != len(rows):
        raise BadValue(
            f"{len(rows)} weights, one for every control point",
            f"{len(numbers)}",
            "A weight of 1 leaves a point as it is.",
        )
    if any(PARAMETER in entry.free_symbols for entry in (*numbers, *sum(rows, ()))):
        raise BadValue(
            "control points and weights without the parameter t",
            "some that contain it",
            "Use another symbol.",
        )
    signs = [sign(weight) for weight in numbers]
    _require_curve(signs)
    return rows, tuple(sp.S.Zero if s == 0 else w for s, w in zip(signs, numbers, strict=True))


def warn_of_hull(weights: Sequence[sp.Expr], stacklevel: int) -> None:
    """Warn unless all weights that are numbers have one sign, and none is zero."""
    signs = {sign(weight) for weight in weights}
    if 0 in signs or signs >= {1, -1}:
        what = "a weight is zero" if 0 in signs else "the weights have different signs"
        warnings.warn(
            f"{what}: the curve need not lie in the convex hull of its control points",
            HullWarning,
            stacklevel=stacklevel + 1,
        )


def lifted(points: Sequence[Point], weights: Sequence[sp.Expr]) -> tuple[Point, ...]:
    """Return the homogeneous rows (w x, w y, ..., w); (v, 0) for a vector v of weight 0.

    >>> lifted([(sp.S(1), sp.S(2))], [sp.S(3)])
    ((3, 6, 3),)
    """
    return tuple(
        (*(w * x for x in row), w) if w != 0 else (*row, w)
        for row, w in zip(points, weights, strict=True)
    )


def projected(rows: Sequence[Point]) -> tuple[tuple[Point, ...], Point]:
    """Return points and weights of homogeneous rows; the vector where the weight is zero.

    Numbers are divided in their field; quotients with symbols stay as they are.

    >>> projected([(sp.S(3), sp.S(6), sp.S(3)), (sp.S(1), sp.S(0), sp.S(0))])
    (((1, 2), (1, 0)), (3, 0))
    """
    weights = tuple(sp.S.Zero if sign(row[-1]) == 0 else row[-1] for row in rows)
    flat = [entry for row in rows for entry in row]
    if any(entry.free_symbols for entry in flat):
        pairs = zip(rows, weights, strict=True)
        return tuple(tuple(x / w if w != 0 else x for x in row[:-1]) for row, w in pairs), weights
    field, elements = common_field(flat)
    rest = iter(elements)
    values = [[next(rest) for _ in row] for row in rows]
    points = [
        tuple(field.to_sympy(x / value[-1] if w != 0 else x) for x in value[:-1])
        for value, w in zip(values, weights, strict=True)
    ]
    return tuple(points), tuple(
        field.to_sympy(value[-1]) if w != 0 else w for value, w in zip(values, weights, strict=True)
    )


class RationalLevels(NamedTuple):
    """A triangle of intermediate points: points[r][i] has the weight weights[r][i]."""

    points: tuple[tuple[Point, ...], ...]
    weights: tuple[Point, ...]


def projected_levels(levels: Sequence[Sequence[Point]]) -> RationalLevels:
    """Return the points and weights of a triangle of homogeneous rows, level by level."""
    points, weights = projected([row for level in levels for row in level])
    ends = list(accumulate(map(len, levels)))
    parts = [slice(end - len(level), end) for end, level in zip(ends, levels, strict=True)]
    return RationalLevels(tuple(points[i] for i in parts), tuple(weights[i] for i in parts))


def quotient(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    """Return a/b in the field of both, so that common factors and roots leave the denominator.

    >>> quotient(sp.S(1), 1 + sp.sqrt(2))
    -1 + sqrt(2)
    """
    field, (left, right) = common_field([a, b])
    return field.to_sympy(left / right)


def decidable_field(expressions: Iterable[sp.Expr]) -> tuple[Domain, list[Any]]:
    """Return a common field in which zero is always seen: roots are numbers there, not symbols.

    Raises
    ------
    BadValue
        For roots whose field has too high a degree, and as in `common_field`.
    """
    field, elements = common_field(expressions)
    if field.is_FractionField and not all(s.is_Symbol for s in field.symbols):
        raise BadValue("fewer different roots", f"{field}", "Their field has too high a degree.")
    return field, elements


def _require_curve(signs: Sequence[int | None]) -> None:
    if all(s == 0 for s in signs):
        raise BadValue("weights that are not all zero", "only zeros", "Use 1 for every point.")
    if 0 in (signs[0], signs[-1]):
        raise BadValue(
            "a first and last weight other than zero",
            "a curve that begins or ends at infinity",
            "Only inner control points may lie at infinity; subdivide the curve elsewhere.",
        )

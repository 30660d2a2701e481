"""Reading two segments that meet: their Taylor coefficients at the joint, in one field."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import comb
from typing import Any

import sympy as sp
from sympy.polys.densetools import dup_shift
from sympy.polys.domains.domain import Domain

from ..bases.bezier import bezier
from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list, exact_points
from ..polynomials import Coefficients, polynomials
from ..real_numbers import real
from .parameters import read_positive, refuse_dimensions

Vector = list[Any]
Given = tuple[Any, ...]
"""Control points as rows, or coordinates as expressions in t."""


@dataclass(frozen=True, eq=False)
class Segment:
    """One segment over [0, 1]: numerators and denominators as series in t - joint, lowest first.

    Attributes
    ----------
    given : rows, or expressions
        Control points, or the coordinates.
    degree : int
        Of the homogeneous form, or a bound for it.
    """

    given: Given
    degree: int
    numerators: list[Coefficients]
    denominators: list[Coefficients]
    field: Domain

    @cached_property
    def curve(self) -> tuple[sp.Expr, ...]:
        """The coordinates as expressions in t."""
        if isinstance(self.given[0], tuple):
            return bezier(self.degree).curve(self.given)
        return self.given

    @property
    def is_polynomial(self) -> bool:
        """Whether no coordinate has a denominator."""
        return all(len(below) == 1 for below in self.denominators)

    def series(self, highest: int) -> list[Vector]:
        """Return the Taylor coefficients of order 0 to `highest` at the joint."""
        columns = [
            _quotient(above, below, highest, self.field)
            for above, below in zip(self.numerators, self.denominators, strict=True)
        ]
        return [list(row) for row in zip(*columns, strict=True)]


def read_segments(left: Any, right: Any, ratio: Any) -> tuple[Segment, Segment, Any]:
    """Return the left segment around t = 1, the right one around t = 0, and the ratio.

    Raises
    ------
    BadValue, BadType, NotExact
        For segments that are neither control points nor coordinates in t, of different
        dimension, a single point, not real, or not defined at the joint.
    """
    first, second = _read(left), _read(right)
    scale = read_positive(ratio, "ratio of the intervals")
    parts = [_parts(first), _parts(second)]
    field, rows = polynomials([*parts[0], *parts[1], scale], PARAMETER)
    if field.is_FractionField and not all(s.is_Symbol for s in field.symbols):
        raise BadValue(
            "numbers from a field of small degree",
            f"numbers with {', '.join(map(str, field.symbols))}",
            "With so many roots zero cannot be told for certain: use fewer.",
        )
    count = len(parts[0])
    segments = [
        _segment(given, some, at, field)
        for given, some, at in ((first, rows[:count], 1), (second, rows[count:-1], 0))
    ]
    refuse_dimensions(*(len(segment.numerators) for segment in segments))
    return segments[0], segments[1], rows[-1][0]


def _read(value: Any) -> Given:
    entries = as_list(value)
    if not entries:
        raise BadType(
            "control points as rows, or coordinates as expressions in t",
            shown(value),
            "Write [[0, 0], [1, 2], [3, 0]], or (t, t**2); of a rational curve, curve.curve().",
        )
    if as_list(entries[0]) is not None:
        return _read_points(entries)
    curve = tuple(real(entry, "coordinates") for entry in entries)
    if not any(PARAMETER in c.free_symbols for c in curve):
        raise BadValue(
            f"coordinates as expressions in {PARAMETER}, or control points as rows",
            shown(value),
            "Write [[0], [1], [3]] for control points on a line, [[0, 0], [1, 2]] in the plane.",
        )
    return curve


def _read_points(entries: Sequence[Any]) -> Given:
    points = tuple(tuple(real(c, "coordinates") for c in row) for row in exact_points(entries))
    if len(points) < 2:
        raise BadValue("at least two control points", "one", "A single point is no segment.")
    if any(PARAMETER in c.free_symbols for row in points for c in row):
        raise BadValue(
            f"control points without the curve's own parameter {PARAMETER}",
            shown(points),
            "Call it by another name; a curve is a flat tuple such as (t, t**2).",
        )
    return points


def _parts(given: Given) -> list[sp.Expr]:
    """Return the coordinates of all points, or the numerators and then the denominators."""
    if isinstance(given[0], tuple):
        return [c for row in given for c in row]
    quotients = [
        (c, sp.S.One) if c.is_polynomial(PARAMETER) else sp.fraction(sp.together(c)) for c in given
    ]
    return [above for above, _ in quotients] + [below for _, below in quotients]


def _segment(given: Given, rows: list[Coefficients], at: int, field: Domain) -> Segment:
    if isinstance(given[0], tuple):
        dim, n = len(given[0]), len(given) - 1
        values = [row[0] if row else field.zero for row in rows]
        series = [_differences(values[x::dim], at, field) for x in range(dim)]
        return Segment(given, n, series, [[field.one]] * dim, field)
    half = len(rows) // 2
    different = {tuple(row): len(row) - 1 for row in rows[half:]}
    below = sum(different.values())
    excess = max(len(a) - len(b) for a, b in zip(rows[:half], rows[half:], strict=True))
    series = [dup_shift(row, field(at), field)[::-1] for row in rows]
    if not all(row[0] for row in series[half:]):
        raise BadValue(
            "a curve that is defined at the joint",
            shown(given),
            "Cancel common factors; a curve that goes to infinity has no joint there.",
        )
    return Segment(given, below + max(0, excess), series[:half], series[half:], field)


def _differences(values: list[Any], at: int, field: Domain) -> Coefficients:
    """Return the Taylor coefficients of a Bezier polynomial at its start or end."""
    n, found = len(values) - 1, []
    for j in range(n + 1):
        found.append(values[-1 if at else 0] * field(comb(n, j)))
        values = [b - a for a, b in zip(values, values[1:], strict=False)]
    return found


def _quotient(above: Coefficients, below: Coefficients, highest: int, field: Domain) -> list[Any]:
    """Divide two power series."""
    found: list[Any] = []
    for j in range(highest + 1):
        rest = above[j] if j < len(above) else field.zero
        for m in range(1, min(j, len(below) - 1) + 1):
            rest -= below[m] * found[j - m]
        found.append(rest / below[0])
    return found

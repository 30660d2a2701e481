"""C2 cubic splines through given points, over any knots, with four kinds of end conditions."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, get_args

import sympy as sp

from ..bases.bezier import bezier
from ..bases.hermite import hermite
from ..bases.parameters import increasing_parameters
from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, Point, as_list, control_points
from ..fields import common_field
from ..proofs.derivation import Derivation
from ..signs import sign
from ..splines.conversion import Segment
from .conditions import Ends, spline_derivation
from .slopes import spline_slopes

t = PARAMETER


@dataclass(frozen=True, eq=False, repr=False)
class InterpolatingSpline:
    """A C2 cubic spline through points; `interpolating_spline` makes one.

    Attributes
    ----------
    points, knots : the data; point i is taken at knot i
    slopes : tuple of rows
        The first derivative at every knot.
    accelerations : tuple of rows
        The second derivative at every knot (the moments); it is linear in between.
    ends : the end conditions
    """

    points: tuple[Point, ...]
    knots: tuple[sp.Expr, ...]
    slopes: tuple[Point, ...]
    accelerations: tuple[Point, ...]
    ends: Ends

    @cached_property
    def bezier_points(self) -> tuple[tuple[Point, ...], ...]:
        """The four Bezier control points of every span: p_i, p_i + h m_i/3, ..., p_{i+1}."""
        return tuple(
            _bezier(*data, start, end)
            for data, (start, end) in zip(
                zip(pairwise(self.points), pairwise(self.slopes), strict=True),
                pairwise(self.knots),
                strict=True,
            )
        )

    @cached_property
    def pieces(self) -> tuple[Segment, ...]:
        """The spline on every span: cubics in t itself, written around the start of the span."""
        return tuple(
            Segment(start, end, _cubics(p, q, start, end))
            for p, q, (start, end) in zip(
                pairwise(self.points), pairwise(self.slopes), pairwise(self.knots), strict=True
            )
        )

    @cached_property
    def energy(self) -> sp.Expr:
        """The integral of |x''|^2: the sum of h/3 (M_i^2 + M_i M_{i+1} + M_{i+1}^2)."""
        spans = zip(pairwise(self.knots), pairwise(self.accelerations), strict=True)
        return sp.Add(
            *(
                energy_of_span(end - start, p, q)
                for (start, end), (left, right) in spans
                for p, q in zip(left, right, strict=True)
            )
        )

    @cached_property
    def derivation(self) -> Derivation:
        """The proof that it passes through the points, is C2, and meets its end conditions."""
        return spline_derivation(self.pieces, self.points, self.slopes, self.ends)

    def __repr__(self) -> str:
        return f"<{self.ends} cubic spline through {len(self.points)} points>"


def interpolating_spline(
    points: Any, knots: Any = None, ends: Ends = "natural", tangents: Any = None
) -> InterpolatingSpline:
    r"""Return the C2 cubic spline through the points, point i at knot i.

    Parameters
    ----------
    points : rows, shape (n + 1, dim), n >= 1
    knots : list of n + 1 increasing numbers or symbols, optional
        0, 1, ..., n by default; `chord_knots` makes them from the distances of the points.
    ends : "natural" (no second derivative), "clamped" (first derivatives given), "periodic" (first
        and second derivatives agree; the last point equals the first), or "not-a-knot" (the second
        knot and the last but one could be left out)
    tangents : two rows, for "clamped" only

    Raises
    ------
    BadValue
        For knots that do not increase or are too few, tangents missing or not asked for, a
        periodic spline whose ends differ, fewer than three points for it, fewer than four for
        "not-a-knot".
    BadType, NotExact
        For points and knots that cannot be read exactly.

    Notes
    -----
    de Boor, *A Practical Guide to Splines*, chapter IV.

    Examples
    --------
    >>> spline = interpolating_spline([[0], [1], [0]])
    >>> spline.slopes
    ((3/2,), (0,), (-3/2,))
    >>> spline.energy
    6
    >>> spline.derivation.is_proved
    True
    """
    rows = control_points(points)
    parameters = _knots(knots, len(rows))
    given = _tangents(tangents, ends, len(rows[0]))
    _refuse_unfit(rows, ends)
    dim = len(rows[0])
    field, elements = common_field((*parameters, *(x for row in (*rows, *given) for x in row)))
    u, rest = elements[: len(rows)], elements[len(rows) :]
    data = [rest[i : i + dim] for i in range(0, len(rest), dim)]
    gaps = [b - a for a, b in pairwise(u)]
    chords = [[(y - x) / gap for x, y in zip(p, q, strict=True)]
              for gap, (p, q) in zip(gaps, pairwise(data[: len(rows)]), strict=True)]  # fmt: skip
    slopes = spline_slopes(gaps, chords, ends, data[len(rows) :], field.one)
    spans = zip(gaps, chords, pairwise(slopes), strict=True)
    second = [_acceleration(gap, chord, m, n) for gap, chord, (m, n) in spans]
    second.append(_acceleration(-gaps[-1], chords[-1], slopes[-1], slopes[-2]))
    m, a = (tuple(tuple(map(field.to_sympy, x)) for x in xs) for xs in (slopes, second))
    return InterpolatingSpline(rows, parameters, m, a, ends)


def energy_of_span(gap: sp.Expr, left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """Return the integral of the square of a linear function with these values at both ends.

    >>> energy_of_span(sp.Integer(2), sp.Integer(0), sp.Integer(3))
    6
    """
    return gap * (left**2 + left * right + right**2) / 3


def _acceleration(gap: Any, chord: Any, here: Any, there: Any) -> list[Any]:
    """Return the second derivative at one end of a span; seen from there the gap has a sign."""
    return [(6 * d - 4 * m - 2 * n) / gap for d, m, n in zip(chord, here, there, strict=True)]


def _knots(knots: Any, count: int) -> tuple[sp.Expr, ...]:
    listed = as_list(knots) if knots is not None else list(range(count))
    if listed is None:
        raise BadType("a list of knots", shown(knots), "Write [0, 1, 3].")
    if len(listed) != count or count < 2:
        raise BadValue(
            "one knot per point, and at least two of them",
            f"{len(listed)} knots for {count} points",
            "Point i is taken at knot i.",
        )
    return increasing_parameters(listed)


def _tangents(tangents: Any, ends: Any, dim: int) -> tuple[Point, ...]:
    if not isinstance(ends, str) or ends not in get_args(Ends):
        raise BadValue(f"ends as one of {', '.join(get_args(Ends))}", shown(ends), "Choose one.")
    if (tangents is None) == (ends == "clamped"):
        raise BadValue(
            "tangents=(first, last) for clamped ends, and for these only",
            f"ends={ends!r} {'without' if tangents is None else 'with'} tangents",
            'Write ends="clamped", tangents=[[1, 0], [0, 1]].',
        )
    rows = control_points(tangents) if tangents is not None else ()
    if rows and (len(rows), len(rows[0])) != (2, dim):
        raise BadValue(f"two tangents of dimension {dim}", shown(tangents), "One row for each end.")
    return rows


def _refuse_unfit(rows: tuple[Point, ...], ends: Ends) -> None:
    least = {"periodic": 3, "not-a-knot": 4}.get(ends, 2)
    if len(rows) < least:
        raise BadValue(
            f"at least {least} points for {ends} ends",
            f"{len(rows)}",
            "Natural ends need only two.",
        )
    if ends == "periodic" and any(sign(a - b) != 0 for a, b in zip(rows[0], rows[-1], strict=True)):
        raise BadValue(
            "a last point equal to the first, for periodic ends",
            f"{rows[0]} and {rows[-1]}",
            "Append the first point once more.",
        )


def _hermite_data(ends: Any, slopes: Any, gap: sp.Expr) -> sp.Matrix:
    """Return the geometry vector of a span in its local parameter, in which slopes grow by h."""
    return sp.Matrix([*ends, *([gap * m for m in slope] for slope in slopes)])


def _bezier(ends: Any, slopes: Any, start: sp.Expr, end: sp.Expr) -> tuple[Point, ...]:
    data = _hermite_data(ends, slopes, end - start)
    return tuple(map(tuple, (hermite(3).to(bezier(3)) * data).tolist()))


def _cubics(ends: Any, slopes: Any, start: sp.Expr, end: sp.Expr) -> tuple[sp.Expr, ...]:
    gap = end - start
    local = hermite(3).matrix * _hermite_data(ends, slopes, gap)
    scaled = [sp.Pow(gap, -k) for k in (3, 2, 1, 0)]
    powers = [(t - start) ** k for k in (3, 2, 1, 0)]
    return tuple(
        sp.Add(*(c * s * p for c, s, p in zip(local.col(j), scaled, powers, strict=True)))
        for j in range(local.cols)
    )

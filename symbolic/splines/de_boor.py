"""De Boor's algorithm: a point of a B-spline curve by repeated linear interpolation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from ..exact import PARAMETER, Point, by_name, exact
from ..proofs.derivation import Derivation, Step
from .knots import KnotVector
from .weights import combined, control_symbols, power_rows, read_points

Levels = tuple[tuple[Point, ...], ...]
Labels = tuple[tuple[tuple[sp.Expr, ...], ...], ...]


def de_boor(knots: KnotVector, points: Any, t: Any, span: Any = None) -> Levels:
    r"""Return all intermediate points of de Boor's algorithm on the span of t.

    d_i^0 are the control points, and with a = (t - u_i)/(u_{i+p+1-r} - u_i)

    d_i^r = (1 - a) d_{i-1}^{r-1} + a d_i^{r-1},   i = j - p + r, ..., j.

    The entry levels[r][k] is d_{j-p+r+k}^r, and levels[p][0] the point of the curve. Symbolic
    results stay unexpanded and share their subexpressions.

    Parameters
    ----------
    points : rows, shape (n + 1, dim)
    t : number in the domain; or any expression, if the span is given
    span : int, optional
        The index j; the curve's polynomial there is then evaluated at any t.

    Raises
    ------
    OutsideDomain
        If t lies outside the domain, and no span is given.
    BadValue
        If symbols leave the span open, or the number of points is wrong.

    Notes
    -----
    de Boor, *On calculating with B-splines*, 1972. Inserting t until it has multiplicity p gives
    the same points (Boehm 1980).

    Examples
    --------
    >>> knots = KnotVector([0, 0, 0, 1, 2, 2, 2], 2)
    >>> de_boor(knots, [[0, 0], [1, 2], [3, 2], [4, 0]], 1)[1:]
    (((2, 2), (3, 2)), ((2, 2),))
    """
    rows = read_points(knots, points)
    t = by_name(exact(t))
    j = span_of(knots, t, span)
    p, u = knots.degree, knots.knots
    levels = [rows[j - p : j + 1]]
    for r in range(1, p + 1):
        level = []
        for k, (left, right) in enumerate(zip(levels[-1], levels[-1][1:], strict=False)):
            i = j - p + r + k
            a = (t - u[i]) / (u[i + p + 1 - r] - u[i])
            level.append(tuple((1 - a) * x + a * y for x, y in zip(left, right, strict=True)))
        levels.append(tuple(level))
    return tuple(levels)


def span_of(knots: KnotVector, t: Any, span: Any) -> int:
    """Return the span that is given, or else the one in which t lies."""
    if span is None:
        return knots.span(t)
    knots.interval(span)
    return int(span)


def labels(knots: KnotVector, span: Any, t: Any = PARAMETER) -> Labels:
    r"""Return for every point of de Boor's triangle the arguments that the blossom has there.

    d_i^r = f(t, ..., t, u_{i+1}, ..., u_{i+p-r}), with r times t; laid out as `de_boor`.

    Notes
    -----
    Ramshaw, *Blossoms are polar forms*, 1989.

    Examples
    --------
    >>> labels(KnotVector([0, 0, 0, 1, 2, 2, 2], 2), 3)
    (((0, 1), (1, 2), (2, 2)), ((t, 1), (t, 2)), ((t, t),))
    """
    knots.interval(span)
    j, p, at = int(span), knots.degree, by_name(exact(t))
    return tuple(
        tuple((*[at] * r, *knots.knots[i + 1 : i + p - r + 1]) for i in range(j - p + r, j + 1))
        for r in range(p + 1)
    )


def point_names(knots: KnotVector, span: Any) -> tuple[tuple[sp.Symbol, ...], ...]:
    """Return symbols d_i^r that name the points of de Boor's triangle; laid out as `de_boor`.

    >>> point_names(KnotVector([0, 0, 0, 1, 2, 2, 2], 2), 3)[1]
    (d_2^1, d_3^1)
    """
    knots.interval(span)
    j, p = int(span), knots.degree
    return tuple(
        tuple(sp.Symbol(f"d_{i}^{r}") for i in range(j - p + r, j + 1)) for r in range(p + 1)
    )


def de_boor_derivation(knots: KnotVector, span: Any) -> Derivation:
    """Return de Boor's algorithm as steps: every new point, and the blossom value it is.

    Examples
    --------
    >>> de_boor_derivation(KnotVector([0, 0, 0, 1, 2, 2, 2], 2), 3).is_proved
    True
    """
    knots.interval(span)
    j, p, t = int(span), knots.degree, PARAMETER
    points = control_symbols(knots)
    levels = de_boor(knots, [[point] for point in points], t, j)
    arguments = labels(knots, j)
    names = point_names(knots, j)
    steps = []
    for r in range(1, p + 1):
        for i, (value,), label, name in zip(
            range(j - p + r, j + 1), levels[r], arguments[r], names[r], strict=True
        ):
            written = _by_powers(knots, j, r, knots.elements[i + 1 : i + p - r + 1], points)
            said = ", ".join(map(str, label))
            steps.append(
                Step(value, written,
                     f"{name} from two points of level {r - 1}: the blossom value f({said})")
            )  # fmt: skip
    where = f"[{knots.knots[j]}, {knots.knots[j + 1]}]"
    return Derivation(f"De Boor's algorithm on the span {where}", tuple(steps),
                      "de Boor 1972; Ramshaw, Blossoms are polar forms, 1989")  # fmt: skip


def _by_powers(
    knots: KnotVector, span: int, r: int, fixed: Sequence[Any], points: Sequence[sp.Symbol]
) -> sp.Expr:
    """Return f(t, ..., t, fixed), with r times t, as a sum of powers of t."""
    rows = power_rows(knots, span, r, knots.field.zero, knots.field.one, fixed)
    coefficients = combined(knots, rows, [(point,) for point in points])
    return sp.Add(*(c * PARAMETER ** (r - k) for k, (c,) in enumerate(coefficients)))

"""Curves cut, joined, reversed and moved: affine maps of their rows of control points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symbolic.errors import BadType, BadValue, OutsideDomain, shown

from ..bernstein import form
from ..points import real_array, real_number
from .making import common_rows, finite_rows, read_breaks

if TYPE_CHECKING:
    from ..curve import Curve

# Ends count as met within this fraction of the curves' size: some roundings.
MEETING = 1e-12


def split(curve: Curve, t: Any) -> tuple[Curve, Curve]:
    """Return the parts of the curve before and after t, by de Casteljau's algorithm.

    Raises
    ------
    OutsideDomain, BadValue
        Unless t lies inside the domain, and not at an end of it.

    Examples
    --------
    >>> from numeric import Curve
    >>> left, right = Curve.from_bezier([[0, 0], [1, 2], [2, 0]]).split(0.5)
    >>> left.points.tolist(), right.domain
    ([[[0.0, 0.0], [0.5, 1.0], [1.0, 1.0]]], (0.5, 1.0))
    """
    at = _inside(curve, t)
    start, end = curve.domain
    if at in (start, end):
        raise BadValue(
            f"t between {start:g} and {end:g}", f"{at:g}, an end", "There is nothing on one side."
        )
    i = int(curve.spans.segment(np.array([at]))[0])
    rows, breaks = curve.rows, curve.breaks
    if at == breaks[i]:
        return curve.with_rows(rows[:i], breaks[: i + 1]), curve.with_rows(rows[i:], breaks[i:])
    left, right = form.split(rows[i : i + 1], (at - breaks[i]) / (breaks[i + 1] - breaks[i]))
    return (
        curve.with_rows(np.concatenate([rows[:i], left]), np.append(breaks[: i + 1], at)),
        curve.with_rows(np.concatenate([right, rows[i + 1 :]]), np.insert(breaks[i + 1 :], 0, at)),
    )


def restrict(curve: Curve, start: Any, end: Any) -> Curve:
    """Return the part of the curve on [start, end].

    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2], [2, 0]]).restrict(0.25, 0.5)(0.5)
    array([1., 1.])
    """
    a, b = _inside(curve, start), _inside(curve, end)
    if not a < b:
        raise BadValue("start < end", f"{a:g} and {b:g}", "Reverse the curve to run backwards.")
    breaks = curve.breaks
    first = int(curve.spans.segment(np.array([a]))[0])
    last = max(int(np.searchsorted(breaks, b)) - 1, first)
    held, ends = curve.rows[first : last + 1].copy(), breaks[first : last + 2].copy()
    low, high = np.clip(([a, b] - ends[[0, -2]]) / (ends[[1, -1]] - ends[[0, -2]]), 0, 1)
    if len(held) == 1:
        held = form.part(held, low, high)
    else:
        held[:1], held[-1:] = form.part(held[:1], low, 1.0), form.part(held[-1:], 0.0, high)
    ends[[0, -1]] = a, b
    return curve.with_rows(held, ends)


def join(*curves: Curve) -> Curve:
    """Return curves, each starting where the one before ends, as one.

    Its domain starts as that of the first; the others are shifted to follow. Lower degrees
    are raised, and it is rational if one of them is.

    Raises
    ------
    BadValue
        For a gap, or curves of different dimensions.

    Examples
    --------
    >>> from numeric import Curve
    >>> line = Curve.from_bezier([[0, 0], [1, 1]])
    >>> Curve.join(line, Curve.from_bezier([[1, 1], [2, 2], [3, 0]], (5, 7)))
    <Curve: 2 segments of degree 2 in 2D on [0, 3]>
    """
    if not curves or not all(hasattr(curve, "with_rows") for curve in curves):
        raise BadType("curves", shown(curves), "Write Curve.join(first, second).")
    rows, rational = common_rows([(curve.rows, curve.rational) for curve in curves])
    for k, (one, other) in enumerate(zip(curves, curves[1:], strict=False)):
        size = max(float(np.abs(c.points).max()) for c in (one, other))
        gap = float(np.abs(one(one.domain[1]) - other(other.domain[0])).max())
        if gap > MEETING * size:
            raise BadValue(
                "curves that start where the one before ends",
                f"a gap of {gap:g} between curves {k} and {k + 1}",
                "Move one of them, or put a line in between.",
            )
    breaks = curves[0].breaks
    for curve in curves[1:]:
        breaks = np.append(breaks, breaks[-1] + (curve.breaks[1:] - curve.breaks[0]))
    return type(curves[0])(rows, read_breaks(breaks, len(rows)), rational)


def reverse(curve: Curve) -> Curve:
    """Return the curve run backwards: c(start + end - t).

    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2]], domain=(1, 3)).reverse()(1)
    array([1., 2.])
    """
    start, end = curve.domain
    breaks = start + (end - curve.breaks[::-1])
    return curve.with_rows(curve.rows[::-1, ::-1].copy(), _moved(breaks, start, end))


def transform(curve: Curve, matrix: Any, offset: Any = None) -> Curve:
    """Return the image under the affine map x -> matrix x + offset.

    Parameters
    ----------
    matrix : number, or rows (k, dim); it may change the dimension
    offset : k numbers, optional

    Examples
    --------
    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2]]).transform([[0, 1], [1, 0]], [5, 0])(1)
    array([7., 1.])
    """
    linear = real_array(matrix, "a matrix")
    shift = real_array(0 if offset is None else offset, "an offset")
    if not (np.isfinite(linear).all() and np.isfinite(shift).all()):
        raise BadValue("finite numbers", shown((matrix, offset)), "Mend the map.")
    if linear.ndim == 0:
        linear = linear * np.eye(curve.dim)
    if (
        linear.ndim != 2
        or not len(linear)
        or linear.shape[1] != curve.dim
        or shift.shape not in ((), linear.shape[:1])
    ):
        raise BadValue(
            f"a matrix of {curve.dim} columns, and an offset with an entry for each of its rows",
            f"shapes {linear.shape} and {shift.shape}",
            "The map is x -> matrix x + offset.",
        )
    rows = curve.rows
    shift = np.broadcast_to(shift, linear.shape[:1])
    with np.errstate(over="ignore", invalid="ignore"):
        if not curve.rational:
            return curve.with_rows(finite_rows(rows @ linear.T + shift), curve.breaks)
        w = rows[..., -1:]
        moved = np.concatenate([rows[..., :-1] @ linear.T + w * shift, w], 2)
    return curve.with_rows(finite_rows(moved), curve.breaks)


def reparametrize(curve: Curve, domain: Any) -> Curve:
    """Return the same points on another domain (start, end); breaks keep their proportions.

    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2]]).reparametrize((0, 10))(5)
    array([0.5, 1. ])
    """
    ends = real_array(domain, "a domain")
    if ends.shape != (2,):
        raise BadValue("(start, end)", shown(domain), "Give two numbers.")
    read_breaks(ends, 1)
    start, end = curve.domain
    breaks = ends[0] + (curve.breaks - start) / (end - start) * (ends[1] - ends[0])
    return curve.with_rows(curve.rows, _moved(breaks, *ends))


def elevate(curve: Curve, by: int = 1) -> Curve:
    """Return the same curve written with degree n + by.

    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [2, 2]]).elevate().points.tolist()
    [[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]]
    """
    if isinstance(by, bool) or not isinstance(by, int | np.integer) or by < 0:
        raise BadValue("a number of degrees, 0, 1, 2, ...", shown(by), "Give a whole number.")
    return curve.with_rows(form.elevate(curve.rows, by), curve.breaks)


def _moved(breaks: np.ndarray, start: float, end: float) -> np.ndarray:
    """Return breaks moved to the domain (start, end), or raise where two of them meet there."""
    breaks[[0, -1]] = start, end
    if not (np.diff(breaks) > 0).all():
        raise BadValue(
            "segments that have a length on the new domain",
            f"one too short to be told from a point of [{start:g}, {end:g}]",
            "Keep it near 0, where floats are dense, or leave it out.",
        )
    return breaks


def _inside(curve: Curve, t: Any) -> float:
    at = real_number(t, "t")
    start, end = curve.domain
    if not start <= at <= end:
        raise OutsideDomain(f"t in [{start:g}, {end:g}]", f"{at:g}", "Stay inside the domain.")
    return at

"""Parameters at given lengths along a curve."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symbolic.errors import BadValue, OutsideDomain, shown

from ..bernstein.balance import before
from ..points import real_array
from .length import LENGTH
from .scale import parameters
from .speed import Speed, Stretches, gauss_rule, speed, stretches

if TYPE_CHECKING:
    from ..curve import Curve

TABLE = 1e-13  # tolerance of the lengths between which parameters are looked for
MOST_STEPS = 100
CHUNK = 1024  # parameters at a time: each takes as many speeds as there are nodes


def parameter_at_length(curve: Curve, s: Any) -> np.ndarray:
    """Return the parameters t at which the curve's length from its start is s.

    Parameters
    ----------
    s : number or array of any shape, in [0, length]
        NaN gives NaN. What exceeds the length by 1e-9 of it, as `length` may, is the end.

    Returns
    -------
    array, shape of s
        0 gives the start of the domain and the length its end.

    Raises
    ------
    OutsideDomain
        If some s is negative or larger than the length.

    Examples
    --------
    >>> from numeric import Curve
    >>> line = Curve.from_bezier([[0, 0], [0, 0], [3, 4]])  # at t it has come t^2 of its way
    >>> line.parameter_at_length([0, 1.25, 5])
    array([0. , 0.5, 1. ])
    """
    s = real_array(s, "lengths")
    speeds = speed(curve)
    table = stretches(speeds, TABLE)
    total = float(table.length.sum())
    scaled = s.ravel() / speeds.scale
    outside = (scaled < 0) | (scaled > total * (1 + LENGTH))
    if outside.any():
        raise OutsideDomain(
            f"lengths in [0, {total * speeds.scale:g}]",
            f"{s.ravel()[outside][0]}",
            "The last is the length of the curve.",
        )
    return _inverse(curve, speeds, table, scaled).reshape(s.shape)


def parameters_by_arc_length(curve: Curve, count: Any) -> np.ndarray:
    """Return parameters between which the curve has equal lengths, both ends among them.

    Parameters
    ----------
    count : int, at least 2

    Returns
    -------
    array, shape (count,)
        For a curve of length zero, parameters with equal distances.

    Examples
    --------
    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [0, 0], [4, 0]]).parameters_by_arc_length(5).round(6)
    array([0.      , 0.5     , 0.707107, 0.866025, 1.      ])
    """
    if isinstance(count, bool) or not isinstance(count, int | np.integer) or count < 2:
        raise BadValue(
            "a number of parameters, 2, 3, ...", shown(count), "Both ends are among them."
        )
    speeds = speed(curve)
    table = stretches(speeds, TABLE)
    total = table.length.sum()
    if total == 0:
        return np.linspace(*curve.domain, int(count))
    return _inverse(curve, speeds, table, np.linspace(0, total, int(count)))


def _inverse(curve: Curve, speeds: Speed, table: Stretches, s: np.ndarray) -> np.ndarray:
    """Return the parameters at lengths s, a chunk at a time."""
    ends = np.cumsum(table.length)
    out = np.full(len(s), np.nan)
    inside = np.flatnonzero((s > 0) & (s < ends[-1]))
    for first in range(0, len(inside), CHUNK):
        chosen = inside[first : first + CHUNK]
        k = np.searchsorted(ends, s[chosen], side="right")
        rest = s[chosen] - (ends[k] - table.length[k])
        u = _within(speeds, table, k, rest)
        u = before(u, speeds.c[table.segment[k]])
        out[chosen] = parameters(curve, table.segment[k], u)
    out[s >= ends[-1]] = curve.domain[1]
    out[s <= 0] = curve.domain[0]
    return out


def _within(speeds: Speed, table: Stretches, k: np.ndarray, rest: np.ndarray) -> np.ndarray:
    """Return u at length `rest` from the start of stretch k: Newton's steps, or halvings.

    The length to u is Gauss's rule on [start, u], and its derivative is the speed.
    """
    nodes, weights = gauss_rule()
    segment, start, width = table.segment[k], table.start[k], table.width[k]
    low, high = np.zeros(len(k)), width.copy()
    x = width * np.clip(rest / table.length[k], 0, 1)
    busy = np.arange(len(k))
    for _ in range(MOST_STEPS):
        at, rows = x[busy], segment[busy]
        places = start[busy, None] + at[:, None] * np.append(nodes, 1.0)
        v = speeds.at(np.repeat(rows, len(nodes) + 1), places.ravel()).reshape(places.shape)
        over = at * (v[:, :-1] @ weights) - rest[busy]
        low[busy] = np.where(over < 0, at, low[busy])
        high[busy] = np.where(over < 0, high[busy], at)
        with np.errstate(all="ignore"):
            step = at - over / v[:, -1]
        a, b = low[busy], high[busy]
        x[busy] = np.where((step >= a) & (step <= b), step, (a + b) / 2)
        small = 2e-16 * (start[busy] + at)
        busy = busy[~((np.abs(x[busy] - at) <= small) | (b - a <= small) | (over == 0))]
        if not len(busy):
            break
    return start + x

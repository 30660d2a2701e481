"""SciPy's splines: BSpline, PPoly and BPoly, both ways, with values of any dimension."""

from __future__ import annotations

from typing import Any

import numpy as np

from symbolic.errors import BadType, BadValue, shown

from ..bernstein.form import from_powers, to_powers
from ..curve import Curve

TINY = float(np.finfo(float).tiny)


def from_scipy(spline: Any) -> Curve:
    """Return the curve of a `BSpline`, `PPoly` or `BPoly` of `scipy.interpolate`.

    CubicSpline, PchipInterpolator and others are PPoly, too. A spline with numbers as values gives
    a curve in 1D. The domain is that on which SciPy does not extrapolate; pieces of length zero
    are left out.

    Raises
    ------
    BadValue
        For values that are matrices, NaN or infinity, and where numbers overflow.
    BadType
        For what is none of these splines, and complex coefficients.

    Notes
    -----
    The coefficients of a BPoly are taken as they are, bit for bit. Those of a BSpline become Bezier
    points by de Boor's algorithm, by affine combinations alone; those of a PPoly by the exact
    change of basis, each rounded some times.

    Examples
    --------
    >>> from scipy.interpolate import PPoly
    >>> from_scipy(PPoly([[1], [0], [0]], [0, 2])).points.tolist()
    [[[0.0], [0.0], [4.0]]]
    """
    from scipy.interpolate import BPoly, BSpline, PPoly

    if isinstance(spline, BSpline):
        count = len(spline.t) - spline.k - 1  # SciPy allows for more coefficients than it uses
        return Curve.from_bspline(_columns(spline.c[:count], 1), spline.t, spline.k)
    if not isinstance(spline, PPoly | BPoly):
        raise BadType(
            "a BSpline, PPoly or BPoly of scipy.interpolate", shown(spline),
            "Of (t, c, k) make BSpline(t, c, k) first.",
        )  # fmt: skip
    rows = np.moveaxis(_columns(spline.c, 2), 0, 1)
    x = np.array(spline.x)
    lengths = np.diff(x)
    rows, lengths = rows[lengths != 0], lengths[lengths != 0]
    x = x[np.append(True, np.diff(x) != 0)]
    if isinstance(spline, PPoly):
        rows = from_powers(_by_powers(np.multiply, rows[:, ::-1], lengths))
    if len(x) > 1 and x[0] > x[-1]:  # SciPy's x may decrease: every piece runs backwards
        rows, x = rows[::-1, ::-1], x[::-1]
    return Curve.from_bezier(rows, x)


def to_scipy(curve: Curve, kind: Any) -> Any:
    """Return a polynomial curve as a `BSpline`, `PPoly` or `BPoly` of `scipy.interpolate`.

    Parameters
    ----------
    kind : BSpline, PPoly or BPoly, the class itself

    Returns
    -------
    spline with the same domain, and breaks at the same places
        Its values are points of shape (dim,). It extrapolates outside the domain as SciPy does.

    Raises
    ------
    BadValue
        For a rational curve; where numbers overflow or vanish as coefficients of powers.
    BadType
        For what is no curve, and another kind.

    Notes
    -----
    BPoly and BSpline hold the control points bit for bit. The knots of the BSpline have the
    multiplicity n at breaks where the segments meet bit for bit, so that SciPy can differentiate
    it, and n + 1 elsewhere and at the ends. As a PPoly the coefficients are rounded, and what they
    stand for loses digits as the degree grows: 2e-14 of the largest control point at degree 5,
    3e-7 at degree 20.

    Examples
    --------
    >>> from scipy.interpolate import BSpline
    >>> curve = Curve.from_bezier([[[0.0], [1.0]], [[1.0], [5.0]]], domain=(0, 2))
    >>> to_scipy(curve, BSpline).t.tolist()
    [0.0, 0.0, 1.0, 2.0, 2.0]
    """
    from scipy.interpolate import BPoly, BSpline, PPoly

    if not isinstance(curve, Curve):
        raise BadType("a curve", shown(curve), "Make one with Curve.from_bezier.")
    if not any(kind is known for known in (BPoly, BSpline, PPoly)):
        raise BadType(
            "the class BSpline, PPoly or BPoly of scipy.interpolate", shown(kind),
            "Write to_scipy(curve, BSpline).",
        )  # fmt: skip
    if curve.rational:
        raise BadValue(
            "a polynomial curve, since SciPy has no rational ones", repr(curve),
            "Make Curve(curve.homogeneous, curve.breaks), and divide by its last coordinate.",
        )  # fmt: skip
    breaks, rows = curve.breaks.copy(), curve.rows
    if kind is BSpline:
        return BSpline(*_knots_and_points(rows, breaks), curve.degree)
    if kind is PPoly:
        rows = _by_powers(np.divide, to_powers(rows), np.diff(breaks))[:, ::-1]
    return kind(np.moveaxis(rows, 0, 1).copy(), breaks)


def _knots_and_points(rows: np.ndarray, breaks: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    n = rows.shape[1] - 1
    meets = (rows[1:, 0] == rows[:-1, -1]).all(axis=1) & (n > 0)
    times = np.concatenate([[n + 1], n + 1 - meets, [n + 1]])
    kept = np.ones(rows.shape[:2], dtype=bool)
    kept[1:, 0] = ~meets
    return np.repeat(breaks, times), rows[kept]


def _columns(c: Any, axes: int) -> np.ndarray:
    """Return coefficients with the coordinates of a point along one last axis."""
    c = np.asarray(c)
    if c.dtype.kind == "c":
        raise BadType("real coefficients", "complex ones", "Stack their real and imaginary parts.")
    if c.ndim > axes + 1:
        raise BadValue(
            "a spline with numbers or points as values",
            f"values of shape {c.shape[axes:]}",
            "Flatten them to one axis.",
        )
    return c if c.ndim == axes + 1 else c[..., None]


def _by_powers(operation: np.ufunc, rows: np.ndarray, lengths: np.ndarray) -> np.ndarray:
    """Return coefficients (m, n + 1, dim), number k of them k times multiplied by a length.

    Or divided, where that is the operation. Step by step nothing overflows on the way.
    """
    out, factor = rows.copy(), lengths[:, None, None]
    with np.errstate(all="ignore"):
        for k in range(1, rows.shape[1]):
            operation(out[:, k:], factor, out=out[:, k:])
    lost = ~np.isfinite(out) & np.isfinite(rows)
    if operation is np.divide:  # multiplied by a large power of x later, so that it is not small
        lost |= (np.abs(out) < TINY) & (np.abs(rows) >= TINY)
    if lost.any():
        raise BadValue(
            "pieces of moderate length",
            f"one of length {abs(lengths[lost.any(axis=(1, 2))][0]):g}, whose powers overflow",
            "Scale the breaks, with Curve.reparametrize, or use BPoly.",
        )
    return out

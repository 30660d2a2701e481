"""Derivatives of curves by their parameter, as curves and point by point."""

from __future__ import annotations

from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np

from symbolic.errors import BadValue, shown

from ..bernstein import form
from .making import factor_power, finite_rows

if TYPE_CHECKING:
    from ..curve import Curve


def derivative_rows(rows: np.ndarray, breaks: np.ndarray) -> np.ndarray:
    """Return the rows of the derivative by t: by u, divided by the segment's length."""
    with np.errstate(over="ignore", invalid="ignore"):
        return finite_rows(form.derivative(rows) / form.along_rows(np.diff(breaks), rows))


def derivative(curve: Curve) -> Curve:
    """Return the derivative by the curve's parameter, a curve (hodograph).

    Of a polynomial curve it has degree n - 1 and control points n (P_{i+1} - P_i) / h on a
    segment of length h; of a rational one degree 2n.

    Raises
    ------
    BadValue
        If a coefficient is too large for a float, as on segments of length 1e-320.

    Examples
    --------
    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2], [2, 0]], domain=(0, 2)).derivative()(0)
    array([1., 2.])
    """
    if not curve.rational:
        return curve.with_rows(derivative_rows(curve.rows, curve.breaks), curve.breaks)
    held = np.ldexp(curve.rows, -factor_power(curve.rows[..., -1])[..., None])
    rows = derivative_rows(held, curve.breaks)
    n, w = held[..., :-1], held[..., -1:]
    with np.errstate(over="ignore", invalid="ignore"):
        above = form.product(rows[..., :-1], w) - form.product(n, rows[..., -1:])
        below = form.product(w, w)
        above = form.elevate(above, below.shape[1] - above.shape[1])
    return curve.with_rows(finite_rows(np.concatenate([above, below], axis=2)), curve.breaks)


def derivatives(curve: Curve, t: Any, order: Any, extrapolate: bool = False) -> list[np.ndarray]:
    """Return the points and the derivatives of order 1, ..., `order` at parameters t.

    A t outside the domain is an error, unless it may extrapolate, as when the curve is called.

    Returns
    -------
    list of order + 1 arrays, each of shape t.shape + (dim,)

    Notes
    -----
    From w p = N and Leibniz' rule, w p^(k) = N^(k) - sum over i = 1, ..., k of
    C(k, i) w^(i) p^(k-i) (Piegl and Tiller, The NURBS Book, A4.2).

    Examples
    --------
    >>> from numeric import Curve
    >>> arc = Curve.from_bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 1, 2])
    >>> arc.derivatives(0, 2)
    [array([1., 0.]), array([0., 2.]), array([-4.,  0.])]
    """
    if isinstance(order, bool) or not isinstance(order, int | np.integer) or order < 0:
        raise BadValue("an order of derivative, 0, 1, 2, ...", shown(order), "Give a whole number.")
    flat = type(curve)(curve.homogeneous, curve.breaks) if curve.rational else curve
    found = [flat(t, extrapolate)]
    for _ in range(order):
        flat = flat.derivative()
        found.append(flat(t, extrapolate))
    if not curve.rational:
        return found
    numerators, w = [f[..., :-1] for f in found], [f[..., -1:] for f in found]
    points: list[np.ndarray] = []
    for k in range(order + 1):
        value = numerators[k]
        for i in range(1, k + 1):
            value = value - comb(k, i) * w[i] * points[k - i]
        points.append(value / w[0])
    return points

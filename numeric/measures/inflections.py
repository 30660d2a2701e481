"""Where a plane curve turns from one side to the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from symbolic.errors import BadValue

from ..bernstein import form
from ..bernstein.evaluation import values_at
from ..bernstein.roots import EPSILON, roots
from .scale import parameters, unit

if TYPE_CHECKING:
    from ..curve import Curve


def inflections(curve: Curve) -> np.ndarray:
    """Return the parameters where the signed curvature of a plane curve changes its sign.

    Between them it has the sign of det(c', c''), or of w det(H, H', H'') for the homogeneous
    rows H of a rational curve: polynomials whose roots are found on all segments at once.

    Returns
    -------
    array of increasing parameters
        A change of sign across a break counts; a zero without a change does not. Where a straight
        stretch lies between, the parameter is its end.

    Raises
    ------
    BadValue
        Unless the curve has dimension 2.

    Notes
    -----
    Curvature that a rounding of the control points could bring about counts as zero, so a straight
    line has no inflection.

    Examples
    --------
    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 1], [2, -1], [3, 0]]).inflections()
    array([0.5])
    """
    if curve.dim != 2:
        raise BadValue(
            "a curve in the plane", f"one of dimension {curve.dim}",
            "Elsewhere curvature has no sign; project the curve first.",
        )  # fmt: skip
    if curve.degree < 2:
        return np.empty(0)
    f, noise = _turning(curve)
    found = roots(f, noise)
    # Between roots a sign: of the value of largest size at three places.
    m = len(f)
    segment = np.concatenate([np.arange(m), found.row])
    start = np.concatenate([np.zeros(m), found.u])
    order = np.lexsort((start, segment))
    segment, start = segment[order], start[order]
    end = np.append(start[1:], 1.0)
    end[np.append(np.diff(segment) > 0, True)] = 1.0
    value = np.zeros(len(start))
    for share in (0.25, 0.5, 0.75):
        other = values_at(f[segment][..., None], start + share * (end - start))[:, 0]
        value = np.where(np.abs(other) > np.abs(value), other, value)
    sign = np.where(np.abs(value) > noise[segment], np.sign(value), 0)
    signed = np.flatnonzero(sign)
    turned = signed[1:][np.diff(sign[signed]) != 0]
    return parameters(curve, segment[turned], start[turned])


def _turning(curve: Curve) -> tuple[np.ndarray, np.ndarray]:
    """Return the coefficients of the polynomials that have the curvature's sign, and their noise.

    The noise is what roundings of the coordinates, as they were given, do to the coefficients.
    """
    rows, start, _ = unit(curve)
    n = curve.degree
    size = np.abs(rows[..., :2] if not curve.rational else rows).max(axis=(1, 2))
    size = size + np.abs(start).max()
    first, second = form.derivative(rows), form.derivative(form.derivative(rows))
    steep, bent = np.abs(first).max(axis=(1, 2)), np.abs(second).max(axis=(1, 2))
    error = 2 * n * EPSILON * size
    if not curve.rational:
        return _det(first, second), error * (bent + 2 * n * steep)
    w = rows[..., 2]
    x, y = rows[..., 0], rows[..., 1]
    f = form.product(w, _det(first, second))
    f += form.product(x, _det(first[..., [1, 2]], second[..., [1, 2]]))
    f += form.product(y, _det(first[..., [2, 0]], second[..., [2, 0]]))
    extent = np.abs(rows).max(axis=(1, 2))
    noise = error * (steep * bent + extent * (bent + 2 * n * steep))
    return f * np.sign(w[:, :1]), noise


def _det(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return form.product(a[..., 0], b[..., 1]) - form.product(a[..., 1], b[..., 0])

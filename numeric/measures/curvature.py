"""Curvature, and the parameters where it changes sign."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from symbolic.errors import BadValue

from ..bernstein import form
from ..curves.making import USUAL_POWER
from ..points import real_array
from ..tape.runner import CHUNK

if TYPE_CHECKING:
    from ..curve import Curve

# Speeds below this fraction of what they are summed up from are rounding errors of zero.
VANISHING = 64 * float(np.finfo(float).eps)


def curvature(curve: Curve, t: Any) -> np.ndarray:
    """Return the curvature at parameters t; in the plane with its sign.

    In the plane det(c', c'') / |c'|^3, positive where the curve turns from x to y; in other
    dimensions |c'' - (c'' . T) T| / |c'|^2 with the unit tangent T, never negative.

    Parameters
    ----------
    t : number or array of any shape

    Returns
    -------
    array, shape of t
        NaN where t is NaN and where the speed vanishes, within rounding: at a cusp the curvature
        has no value. At a break the later segment counts.

    Raises
    ------
    BadValue
        For a curve on a line, of dimension 1.
    OutsideDomain
        If some t is outside the domain.

    Examples
    --------
    >>> from numeric import Curve
    >>> from symbolic import circle
    >>> Curve.from_nurbs(circle(radius=2)).curvature([0.1, 0.6]).round(12)
    array([0.5, 0.5])
    """
    if curve.dim == 1:
        raise BadValue(
            "a curve of dimension 2 or more",
            "one of dimension 1",
            "Add a coordinate, as in (t, x).",
        )
    t = real_array(t, "parameters")
    at, out = t.ravel(), np.empty(t.size)
    power = int(np.frexp(curve.domain[1] - curve.domain[0])[1])
    if abs(power) > USUAL_POWER:  # rounds nothing, and curvature does not depend on the domain
        curve(at)  # refuses what is outside
        curve = curve.with_rows(curve.rows, np.ldexp(curve.breaks, -power))
        at = np.ldexp(at, -power)
    many = max(CHUNK, 4 * len(curve))  # a chunk takes derivatives of all segments
    for first in range(0, len(at), many):
        out[first : first + many] = _values(curve, at[first : first + many])
    return out.reshape(t.shape)


def _values(curve: Curve, t: np.ndarray) -> np.ndarray:
    c, first, second = curve.derivatives(t, 2)
    with np.errstate(all="ignore"):
        length = _norm(first)
        tangent = first / length[..., None]
        bend = second / length[..., None]  # divided twice: no square overflows
        if curve.dim == 2:
            value = tangent[..., 0] * bend[..., 1] - tangent[..., 1] * bend[..., 0]
        else:
            along = np.einsum("...i,...i->...", tangent, bend)
            value = _norm(bend - along[..., None] * tangent)
        return np.where(length > _blur(curve, t, c), value / length, np.nan)


def _norm(vectors: np.ndarray) -> np.ndarray:
    size = np.abs(vectors).max(axis=-1)
    scaled = vectors / np.where(size > 0, size, 1)[..., None]
    return size * np.sqrt(np.einsum("...i,...i->...", scaled, scaled))


def _blur(curve: Curve, t: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Return the rounding error of the speed at t: that of N' - w' c, divided by w."""
    slopes = np.abs(form.derivative(curve.rows)).max(axis=1)
    slopes /= form.along_rows(np.diff(curve.breaks), slopes)
    segment = curve.spans.segment(t.ravel()).reshape(t.shape)
    error: np.ndarray = slopes[:, : curve.dim].max(axis=1)[segment]
    if curve.rational:
        w = type(curve)(curve.rows[..., -1:], curve.breaks)(t)[..., 0]
        error = (error + slopes[:, -1][segment] * np.abs(c).max(axis=-1)) / np.abs(w)
    return VANISHING * error

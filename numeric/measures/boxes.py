"""Boxes around curves: tight ones from exact extrema, quick ones from control points."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..bernstein import form
from ..bernstein.evaluation import values_at
from ..bernstein.roots import roots
from .scale import plain, row_scales

if TYPE_CHECKING:
    from ..curve import Curve


def bounding_box(curve: Curve) -> np.ndarray:
    """Return the smallest box with sides along the axes that contains the curve.

    A coordinate N/w is extreme at an end of a segment or where N' w - N w' = 0; for a polynomial
    curve w = 1. All segments are solved at once, except those whose control points lie within
    the ends of all of them.

    Returns
    -------
    array, shape (2, dim)
        The least and the greatest value of every coordinate; the curve attains them. A point
        that is evaluated may lie outside by a rounding error.

    Examples
    --------
    >>> from numeric import Curve
    >>> Curve.from_bezier([[0, 0], [1, 2], [3, 2], [4, 0]]).bounding_box()
    array([[0. , 0. ],
           [4. , 1.5]])
    """
    rows = curve.rows
    ends = plain(rows[:, [0, -1]].reshape(-1, rows.shape[2]), curve.dim)
    box = np.stack([ends.min(axis=0), ends.max(axis=0)])
    low, high = control_boxes(rows, curve.dim)
    segment, axis = np.nonzero((low < box[0]) | (high > box[1]))
    wanted = rows[segment]
    scalar = wanted[np.arange(len(segment)), :, axis][..., None]  # one coordinate, and w if any
    scalar = np.concatenate([scalar, wanted[..., curve.dim :]], axis=2)
    found = roots(_slope(scalar))
    values = plain(values_at(scalar[found.row], found.u), 1)[:, 0]
    np.minimum.at(box[0], axis[found.row], values)
    np.maximum.at(box[1], axis[found.row], values)
    return box


def control_boxes(rows: np.ndarray, dim: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the least and greatest coordinates, (m, dim) each, of boxes that hold the segments.

    They are those of the control points; without end where weights are not all of one sign, for
    then the curve may leave its control polygon's hull.
    """
    if rows.shape[2] == dim:
        return rows.min(axis=1), rows.max(axis=1)
    w = rows[..., dim:]
    one_sign = np.abs(np.sign(w).sum(axis=1)) == w.shape[1]
    points = rows[..., :dim] / np.where(w == 0, 1, w)
    low = np.where(one_sign, points.min(axis=1), -np.inf)
    return low, np.where(one_sign, points.max(axis=1), np.inf)


def _slope(scalar: np.ndarray) -> np.ndarray:
    """Return the numerator of the derivative of functions (m, n + 1, 1), or N and w (.., 2)."""
    n, *below = (column / row_scales(column)[:, None] for column in np.moveaxis(scalar, 2, 0))
    if not below:
        return form.derivative(n)
    w = below[0]
    return form.product(form.derivative(n), w) - form.product(n, form.derivative(w))

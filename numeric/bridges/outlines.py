"""Curves as contours, and the segments of many contours as few curves."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from symbolic.errors import BadType, BadValue, shown

from ..bernstein.form import split
from ..curve import Curve
from ..curves.pieces import MEETING
from .contour import Contour, rows_by_kind

APPROXIMATE = (
    "Approximate it by lines: with p = curve.flatten(tolerance), Contour(p, [1] * (len(p) - 1))."
)
HALVINGS = 60  # of a segment whose weights have both signs: its ends are then one point


def as_contours(value: Any) -> tuple[Contour, ...]:
    """Return the contours of a curve, a contour, or a list or tuple of these.

    A curve is cut where its segments do not meet within rounding; a part that ends exactly where
    it starts is closed (of a rational curve, whose points are quotients, within their rounding).
    Segments whose weights are not all of one sign are halved until they are.
    """
    if isinstance(value, Contour):
        return (value,)
    if isinstance(value, Curve):
        return tuple(_parts(value))
    if isinstance(value, list | tuple):
        return tuple(contour for part in value for contour in as_contours(part))
    raise BadType("a curve or contours", shown(value), "Make one with Curve.from_bezier.")


def segments_by_degree(contours: Any) -> tuple[Curve, ...]:
    """Return all segments of some contours, one curve for every degree among them.

    What is measured on a whole page of letters takes few calls that way. The segments keep their
    order, and do not meet where others were in between.

    Examples
    --------
    >>> contour = Contour([[0, 0], [1, 0], [1, 2], [0, 0], [5, 5]], [1, 2, 1])
    >>> segments_by_degree(contour)[0]
    <Curve: 2 segments of degree 1 in 2D on [0, 2]>
    """
    return tuple(
        Curve(rows, np.arange(len(rows) + 1.0), rational)
        for rows, rational, _ in rows_by_kind(as_contours(contours))
    )


def up_to_cubic(value: Any, place: str) -> tuple[Contour, ...]:
    """Return the contours of a value for a place that holds lines, quadratics and cubics only."""
    contours = as_contours(value)
    for contour in contours:
        rational = contour.weights is not None
        if rational or contour.degrees.max(initial=1) > 3:
            raise no_room(place, "", int(contour.degrees.max()), rational)
    return contours


def no_room(place: str, more: str, degree: int, rational: bool) -> BadValue:
    """Return the error for a segment that a format cannot hold."""
    return BadValue(
        f"lines, quadratics{' and' if not more else ','} cubics{more} for {place}",
        f"{'rational ' if rational else ''}segments of degree {degree}",
        APPROXIMATE,
    )


def _parts(curve: Curve) -> Iterator[Contour]:
    if curve.dim != 2:
        raise BadValue(
            "a curve in the plane", f"one in {curve.dim}D", "Project it with Curve.transform."
        )
    rows = _of_one_sign(curve.rows) if curve.rational else curve.rows
    with np.errstate(all="ignore"):  # contours refuse what is not finite
        points = rows[..., :2] / rows[..., 2:] if curve.rational else rows
        weights = _standard(rows[..., 2]) if curve.rational else None
        gaps = np.abs(points[1:, 0] - points[:-1, -1]).max(axis=1) > MEETING * np.abs(points).max()
    separate = gaps | (curve.degree == 0)  # points, each by itself
    cuts = [0, *(np.flatnonzero(separate) + 1).tolist(), len(points)]
    for a, b in pairwise(cuts):
        vertices = np.concatenate([points[a, :1], points[a:b, 1:].reshape(-1, 2)])
        degrees = np.full(b - a if curve.degree else 0, curve.degree)
        slack = 2.0**-50 * np.abs(vertices[0]) * curve.rational
        closed = curve.degree > 0 and bool((np.abs(vertices[0] - vertices[-1]) <= slack).all())
        if closed:
            vertices[-1] = vertices[0]
        own = None if weights is None else np.append(1.0, weights[a:b, 1:])
        yield Contour(vertices, degrees, closed, own)


def _standard(weights: np.ndarray) -> np.ndarray:
    """Return weights (m, n + 1) of one sign in standard form, 1 at both ends.

    A change of parameter u -> u/(u + (1 - u)/r) multiplies weight i by r^i, and a common factor
    moves no point: r = (w_0/w_n)^(1/n).
    """
    n = weights.shape[1] - 1
    out = weights / weights[:, :1]
    if n:
        out *= (1 / out[:, n:]) ** (np.arange(n + 1) / n)
    out[:, [0, n]] = 1
    return out


def _of_one_sign(rows: np.ndarray) -> np.ndarray:
    """Return homogeneous rows with those segments halved that have weights of both signs or 0.

    Their weight functions have no zero, and by halving their weights come as near to it as one
    likes.
    """
    for _ in range(HALVINGS):
        mixed = (rows[..., -1] * np.sign(rows[:, :1, -1]) <= 0).any(axis=1)
        if not mixed.any():
            break
        first = np.flatnonzero(mixed) + np.arange(mixed.sum())
        halves = np.repeat(rows, 1 + mixed, axis=0)
        halves[first], halves[first + 1] = split(rows[mixed])
        rows = halves
    return rows

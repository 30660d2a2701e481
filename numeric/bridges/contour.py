"""What drawing programs call a path: contours of lines, quadratics, cubics and arcs in a row.

A `Curve` has one degree. To raise the degree of a line rounds its points, so that a path read
from a file and written again would no longer be the same; a `Contour` leaves every segment as it
is. A path is a tuple of contours.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from symbolic.errors import BadType, BadValue, shown

from ..curve import Curve
from ..curves.making import common_rows
from ..points import float_points, real_array

Point = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Contour:
    """Bezier segments of any degrees in the plane, each starting where the one before ends.

    Attributes
    ----------
    vertices : array, shape (1 + sum of degrees, 2)
        The start, and then for every segment its further control points. A contour without
        segments is a point.
    degrees : array of whole numbers from 1 on, one for every segment
    closed : bool
        Whether the end is joined to the start, at the same place. A last line that is drawn by
        closing alone in SVG, matplotlib or a font is a segment like any other here.
    weights : array with a number > 0 for every vertex, or None if all segments are polynomial
        A rational segment stands in standard form: the weights of its ends are 1. Every one with
        positive weights has such a form (Farin, *Curves and Surfaces for CAGD*).

    Examples
    --------
    >>> Contour([[0, 0], [1, 0], [1, 2], [0, 0]], [1, 2], closed=True).curve
    <Curve: 2 segments of degree 2 in 2D on [0, 2]>
    """

    vertices: Any
    degrees: Any
    closed: bool = False
    weights: Any = None

    def __post_init__(self) -> None:
        vertices, degrees = float_points(self.vertices), _degrees(self.degrees)
        if vertices.shape[1] != 2:
            raise BadValue(
                "points in the plane", f"{vertices.shape[1]} coordinates",
                "Project them with Curve.transform.",
            )  # fmt: skip
        if degrees.sum() + 1 != len(vertices):
            raise BadValue(
                "a start, and as many further vertices as the degrees add up to",
                f"{len(vertices)} vertices and degrees {shown(degrees[:40].tolist())}",
                "A line has degree 1 and one further vertex.",
            )
        if not isinstance(self.closed, bool | np.bool_):
            raise BadType("closed=True or closed=False", shown(self.closed), "Give one of them.")
        if self.closed and (vertices[0] != vertices[-1]).any():
            raise BadValue(
                "a closed contour that ends where it starts",
                f"{vertices[0]} and {vertices[-1]}",
                "Add a line back to the start.",
            )
        if self.closed:
            vertices[-1] = vertices[0]  # the same zeros, too: what is left out can be put back
        weights = self.weights
        if weights is not None:
            weights = _weights(weights, degrees)
        for array in (vertices, degrees, weights):
            if array is not None:
                array.flags.writeable = False
        self.__dict__.update(
            vertices=vertices, degrees=degrees, closed=bool(self.closed), weights=weights
        )

    @property
    def starts(self) -> np.ndarray:
        """The number of every segment's first vertex."""
        return np.cumsum(self.degrees) - self.degrees

    @property
    def curve(self) -> Curve:
        """One curve on [0, segments], of the highest degree; lower ones are raised to it."""
        groups = list(rows_by_kind([self])) or [(self.vertices[None], False, np.zeros(1))]
        rows, rational = common_rows([(rows, rational) for rows, rational, _ in groups])
        order = np.argsort(np.concatenate([numbers for *_, numbers in groups]), kind="stable")
        return Curve(rows[order], np.arange(len(rows) + 1.0), rational)

    @property
    def implied_line(self) -> bool:
        """Whether the last segment is a line that closing draws, if it is left out."""
        return bool(
            self.closed
            and len(self.degrees)
            and self.degrees[-1] == 1
            and (self.vertices[-2] != self.vertices[-1]).any()
        )

    @property
    def rational(self) -> np.ndarray:
        """Whether a segment has weights other than 1, for every segment."""
        if self.weights is None or not len(self.degrees):
            return np.zeros(len(self.degrees), dtype=bool)
        return np.logical_or.reduceat(self.weights[1:] != 1, self.starts)


def rows_by_kind(contours: Iterable[Contour]) -> Iterator[tuple[np.ndarray, bool, np.ndarray]]:
    """Yield the rows of all segments of one degree, whether homogeneous, and which ones they are.

    Segments with weights 1 are polynomial, also beside others that are not.
    """
    contours = [contour for contour in contours if len(contour.degrees)]
    if not contours:
        return
    counts = [len(contour.vertices) for contour in contours]
    vertices = np.concatenate([contour.vertices for contour in contours])
    degrees = np.concatenate([contour.degrees for contour in contours])
    first = np.repeat(np.cumsum(counts) - counts, [len(contour.degrees) for contour in contours])
    starts = first + np.concatenate([contour.starts for contour in contours])
    weights = np.ones(len(vertices))
    for contour, end in zip(contours, np.cumsum(counts), strict=True):
        if contour.weights is not None:
            weights[end - len(contour.weights) : end] = contour.weights
    for degree in np.unique(degrees):
        numbers = np.flatnonzero(degrees == degree)
        held = starts[numbers, None] + np.arange(degree + 1)
        rows, w = vertices[held], weights[held][..., None]
        rational = (w != 1).any(axis=(1, 2))
        if not rational.all():
            yield rows[~rational], False, numbers[~rational]
        if rational.any():
            rows, w = rows[rational], w[rational]
            w = np.ldexp(w, -np.frexp(w.max(axis=1, keepdims=True))[1])  # no product overflows
            yield np.concatenate([w * rows, w], axis=2), True, numbers[rational]


def _degrees(degrees: Any) -> np.ndarray:
    numbers = real_array(degrees, "degrees")
    # Above 1e9 no vertices could match, and a sum of few could be too large for an integer.
    if numbers.ndim != 1 or not ((numbers >= 1) & (numbers < 1e9) & (numbers % 1 == 0)).all():
        raise BadValue(
            "degrees as a list of whole numbers from 1 on", shown(degrees), "Lines have degree 1."
        )
    return numbers.astype(np.intp)


def _weights(weights: Any, degrees: np.ndarray) -> np.ndarray | None:
    """Return the weights of a contour as an array, or None if all are 1."""
    numbers = np.array(real_array(weights, "weights"))
    ends = np.concatenate([[0], np.cumsum(degrees)])
    if (
        numbers.shape != (ends[-1] + 1,)
        or not ((numbers > 0) & (numbers < np.inf)).all()
        or (numbers[ends] != 1).any()
    ):
        raise BadValue(
            f"{ends[-1] + 1} positive weights, one for every vertex and 1 at the ends of segments",
            shown(weights),
            "Split the curve until its weights are positive, and bring it to standard form.",
        )
    return numbers if (numbers != 1).any() else None

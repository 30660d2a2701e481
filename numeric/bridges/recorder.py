"""Contours out of drawing commands: move here, segments to there, close."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .contour import Contour, Point


class Recorder:
    """Gathers commands as SVG and fonts have them, and makes contours of them.

    After `close` the next segment starts where the closed contour did, as in SVG.
    """

    def __init__(self) -> None:
        self.here: Point = (0.0, 0.0)
        self._start: Point | None = None  # of the contour now drawn, or just closed
        self._coordinates: list[float] = []  # x and y of its vertices by turns
        self._degrees: list[int] = []
        self._weights: dict[int, float] = {}  # by the number of the vertex
        self._contours: list[Contour] = []

    def move(self, point: Point) -> None:
        """Begin a contour at a point."""
        self._finish()
        self._start = self.here = point
        self._coordinates += point

    def segments(self, degree: int, coordinates: Sequence[float]) -> None:
        """Add segments of one degree by the x and y of their further control points."""
        if not self._coordinates:
            self._coordinates += self.here
        self._coordinates += coordinates
        self._degrees += [degree] * (len(coordinates) // (2 * degree))
        self.here = coordinates[-2], coordinates[-1]

    def conic(self, handle: Point, weight: float, end: Point) -> None:
        """Add a rational quadratic in standard form."""
        self.segments(2, (*handle, *end))
        self._weights[len(self._coordinates) // 2 - 2] = weight

    @property
    def started(self) -> bool:
        """Whether there is a point to draw from."""
        return self._start is not None

    def close(self) -> None:
        """Close the contour, by a line unless it is back at its start."""
        assert self._start is not None
        if self.here != self._start:
            self.segments(1, self._start)
        if not self._coordinates:
            self._coordinates += self.here
        self._finish(closed=True)

    def contours(self) -> tuple[Contour, ...]:
        """Return what was drawn so far."""
        self._finish()
        return tuple(self._contours)

    def _finish(self, closed: bool = False) -> None:
        if not self._coordinates:
            return
        vertices = np.array(self._coordinates, dtype=float).reshape(-1, 2)
        weights = None
        if self._weights:
            weights = np.ones(len(vertices))
            weights[list(self._weights)] = list(self._weights.values())
        self._contours.append(Contour(vertices, self._degrees, closed, weights))
        self._coordinates, self._degrees, self._weights = [], [], {}

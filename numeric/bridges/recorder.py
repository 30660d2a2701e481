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
        self._vertices: list[Point] = []
        self._degrees: list[int] = []
        self._weights: dict[int, float] = {}
        self._contours: list[Contour] = []

    def move(self, point: Point) -> None:
        """Begin a contour at a point."""
        self._finish()
        self._start = self.here = point
        self._vertices.append(point)

    def segments(self, degree: int, points: Sequence[Point]) -> None:
        """Add segments of one degree with the given further control points."""
        if not self._vertices:
            self._vertices.append(self.here)
        self._vertices += points
        self._degrees += [degree] * (len(points) // degree)
        self.here = points[-1]

    def conic(self, handle: Point, weight: float, end: Point) -> None:
        """Add a rational quadratic in standard form."""
        self.segments(2, (handle, end))
        self._weights[len(self._vertices) - 2] = weight

    @property
    def started(self) -> bool:
        """Whether there is a point to draw from."""
        return self._start is not None

    def close(self) -> None:
        """Close the contour, by a line unless it is back at its start."""
        assert self._start is not None
        if self.here != self._start:
            self.segments(1, [self._start])
        if not self._vertices:
            self._vertices.append(self.here)
        self.here = self._start
        self._finish(closed=True)

    def contours(self) -> tuple[Contour, ...]:
        """Return what was drawn so far."""
        self._finish()
        return tuple(self._contours)

    def _finish(self, closed: bool = False) -> None:
        if not self._vertices:
            return
        weights = None
        if self._weights:
            weights = np.ones(len(self._vertices))
            weights[list(self._weights)] = list(self._weights.values())
        vertices = np.array(self._vertices, dtype=float)
        self._contours.append(Contour(vertices, self._degrees, closed, weights))
        self._vertices, self._degrees, self._weights = [], [], {}

"""SVG path data, read into contours and written from them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from symbolic.errors import BadValue

from .contour import Contour, Point
from .outlines import as_contours, no_room
from .recorder import Recorder
from .svg_arcs import EPSILON, WELL_SHAPED, arc_of, arc_pieces, halves
from .svg_grammar import ARGUMENTS, commands

DEGREES = {"L": 1, "Q": 2, "C": 3}
LETTERS = {degree: letter for letter, degree in DEGREES.items()}
Bend = tuple[int, Point]  # a segment's degree, and its last control point before the end


def from_svg(text: str) -> tuple[Contour, ...]:
    """Return the contours that SVG path data draws, the attribute d of an element <path>.

    All of SVG 1.1 and 2 is read. Coordinates are taken as they are, with y downwards on a screen.
    Lines and Bezier segments keep their numbers bit for bit where commands are absolute; arcs
    become rational quadratics of at most a quarter turn. As SVG prescribes, an arc whose ends are
    equal is left out, one with a radius 0 is a line, and too small radii are scaled up.

    Raises
    ------
    BadValue
        For text that is no path data, with the position. A browser would draw what comes before.
    BadType
        For what is no text.

    Examples
    --------
    >>> triangle, arc = from_svg("M0 0H1V1z m2 0 a1 1 0 011 1")
    >>> triangle.vertices.tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]
    >>> arc.curve
    <Curve: 1 rational segment of degree 2 in 2D on [0, 1]>
    """
    recorder = Recorder()
    before: Bend | None = None
    for letter, numbers, at in commands(text):
        kind, relative = letter.upper(), letter.islower()
        if kind != "M" and not recorder.started:
            raise BadValue(
                f"M or m as the first command, at character {at}", letter, "Begin with a point."
            )
        if kind == "Z":
            recorder.close()
            before = None
        elif letter in DEGREES:  # many at once, since nothing depends on where they start
            points = _pairs(numbers)
            recorder.segments(DEGREES[letter], points)
            before = DEGREES[letter], points[-2] if len(points) > 1 else points[-1]
        else:
            for i in range(0, len(numbers), ARGUMENTS[kind]):
                part = numbers[i : i + ARGUMENTS[kind]]
                each = "L" if kind == "M" and i else kind
                before = _draw(recorder, before, each, part, relative, at)
    return recorder.contours()


def to_svg(curves: Any) -> str:
    """Return SVG path data of a curve, a contour, or a list or tuple of these.

    Every number is the shortest that reads back as the same float, so that lines, quadratics and
    cubics lose nothing. Arcs of ellipses become A commands of at most a third of a turn: longer
    ones would lose digits, since at half a turn the radii hardly tell where the centre is. SVG
    holds shapes: breaks, and how fast a rational curve is run through, are no part of it.

    Raises
    ------
    BadValue
        For degrees above 3, and rational segments that are not arcs of ellipses.
    BadType
        For what is no curve.

    Examples
    --------
    >>> from numeric import Curve
    >>> to_svg(Curve.from_bezier([[0, 0], [0.5, 2], [1, 0]]))
    'M0 0 Q0.5 2 1 0'
    >>> to_svg(from_svg("m1.5.5h1v1z"))
    'M1.5 0.5 L2.5 0.5 2.5 1.5 Z'
    """
    return " ".join(_contour_text(contour) for contour in as_contours(curves))


def _draw(
    recorder: Recorder, before: Bend | None, kind: str, part: list[float], relative: bool, at: int
) -> Bend | None:
    """Draw one segment or move, and return what S or T would mirror after it."""
    here = recorder.here
    if kind == "H":
        part = [part[0], 0.0 if relative else here[1]]
    elif kind == "V":
        part = [0.0 if relative else here[0], part[0]]
    coordinates = part[-2:] if kind == "A" else part
    if relative:
        coordinates = [n + here[k % 2] for k, n in enumerate(coordinates)]
    points = _pairs(coordinates)
    if kind in "ST":
        mirrors = before and before[0] == (3 if kind == "S" else 2)
        x, y = before[1] if before and mirrors else here
        points.insert(0, (2 * here[0] - x, 2 * here[1] - y))
    if kind == "M":
        recorder.move(points[0])
    elif kind == "A":
        _draw_arc(recorder, part, points[0], at)
    else:
        recorder.segments(len(points), points)
        return len(points), (points[-2] if len(points) > 1 else here)
    return None


def _draw_arc(recorder: Recorder, part: list[float], end: Point, at: int) -> None:
    rx, ry, rotation, large, sweep = part[:5]
    if end == recorder.here:
        return
    if not rx or not ry:
        recorder.segments(1, [end])
        return
    pieces = arc_pieces(recorder.here, end, (rx, ry), rotation, large == 1, sweep == 1)
    if pieces is None:
        raise BadValue(
            f"an arc of moderate size at character {at}",
            f"radii {rx:g} and {ry:g}, end {end}",
            "Its numbers overflow; scale the path.",
        )
    for handle, weight, stop in pieces:
        recorder.conic(handle, weight, stop)


def _contour_text(contour: Contour) -> str:
    start = here = contour.vertices[0].tolist()
    last = ""
    words = ["M" + _numbers(start)]
    segments = list(contour.segments())
    for points, weights in segments[:-1] if contour.implied_line else segments:
        for letter, numbers in _segment_commands(here, points, weights):
            words.append(("" if letter == last else letter) + _numbers(numbers))
            last = letter
        here = points[-1]
    return " ".join(words) + (" Z" if contour.closed else "")


def _segment_commands(
    here: Point, points: list[Point], weights: list[float] | None
) -> Iterator[tuple[str, list[float]]]:
    degree = len(points)
    if degree > 3 or (weights and degree == 3):
        raise no_room("SVG", " and arcs of ellipses", degree, bool(weights))
    if weights and abs(weights[0] - 1) > 4 * EPSILON:
        yield from _arc_commands(here, points[0], points[1], weights[0])
    else:
        yield LETTERS[degree], [n for point in points for n in point]


def _arc_commands(
    start: Point, handle: Point, end: Point, weight: float
) -> Iterator[tuple[str, list[float]]]:
    pieces = [(start, handle, end, weight)]
    if weight < WELL_SHAPED:
        pieces = halves(*pieces[0])
    for piece in pieces:
        arc = arc_of(*piece) if weight < 1 else None
        if arc is None:
            kind = "an arc of a hyperbola" if weight > 1 else "a flat arc"
            raise BadValue(
                "arcs of ellipses for SVG",
                f"{kind} from {_numbers(start)} to {_numbers(end)}",
                "Approximate it: make a curve of the points that Curve.flatten(tolerance) finds.",
            )
        rx, ry, rotation, sweep = arc
        yield "A", [rx, ry, rotation, 0, sweep, *piece[2]]


def _pairs(numbers: list[float]) -> list[Point]:
    return list(zip(numbers[::2], numbers[1::2], strict=True))


def _numbers(numbers: Any) -> str:
    """Return the shortest texts that read back as the same floats; whole numbers without .0."""
    return " ".join([repr(n).removesuffix(".0") for n in numbers])

"""SVG path data, read into contours and written from them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import Any

from symbolic.errors import BadValue

from .contour import Contour, Point
from .outlines import APPROXIMATE, as_contours, no_room
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
            recorder.segments(DEGREES[letter], numbers)
            before = _bend(DEGREES[letter], numbers)
        else:
            count = ARGUMENTS[letter]
            for i in range(0, len(numbers), count):
                part = numbers[i : i + count]
                each = "L" if kind == "M" and i else kind
                before = _draw(recorder, before, each, part, relative, at)
    return recorder.contours()


def to_svg(curves: Any) -> str:
    """Return SVG path data of a curve, a contour, or a list or tuple of these.

    Every number is the shortest that reads back as the same float, so that lines, quadratics and
    cubics lose nothing. Arcs of ellipses become A commands of at most a third of a turn: longer
    ones would lose digits, since at half a turn the radii hardly tell where the centre is. They
    come back within some roundings of the ellipse's size times the ratio of its axes, since a
    rounded rotation moves the centre that far. SVG holds shapes: breaks, and how fast a rational
    curve is run through, are no part of it.

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
    if kind in "ST":
        mirrors = before and before[0] == (3 if kind == "S" else 2)
        x, y = before[1] if before and mirrors else here
        coordinates = [2 * here[0] - x, 2 * here[1] - y, *coordinates]
    if kind == "M":
        recorder.move((coordinates[0], coordinates[1]))
    elif kind == "A":
        _draw_arc(recorder, part, (coordinates[0], coordinates[1]), at)
    else:
        degree = len(coordinates) // 2
        recorder.segments(degree, coordinates)
        return _bend(degree, coordinates)
    return None


def _bend(degree: int, coordinates: list[float]) -> Bend | None:
    return (degree, (coordinates[-4], coordinates[-3])) if degree > 1 else None


def _draw_arc(recorder: Recorder, part: list[float], end: Point, at: int) -> None:
    rx, ry, rotation, large, sweep = part[:5]
    if end == recorder.here:
        return
    if not rx or not ry:
        recorder.segments(1, end)
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
    kinds = list(zip(contour.degrees.tolist(), contour.rational.tolist(), strict=True))
    if contour.implied_line:
        kinds.pop()
    words = _words(contour.vertices.ravel().tolist())
    texts = ["M" + " ".join(words[:2])]
    at = 0  # the vertex where the next segment starts
    for (degree, rational), run in groupby(kinds):
        end = at + degree * len(list(run))
        if degree > 3 or (rational and degree == 3):
            raise no_room("SVG", " and arcs of ellipses", degree, rational)
        if rational:
            texts += _conic_texts(contour, at, end)
        else:
            texts.append(LETTERS[degree] + " ".join(words[2 * at + 2 : 2 * end + 2]))
        at = end
    return " ".join(texts) + (" Z" if contour.closed else "")


def _conic_texts(contour: Contour, at: int, end: int) -> Iterator[str]:
    """Yield the commands of the rational quadratics from vertex `at` to vertex `end`."""
    assert contour.weights is not None
    points = contour.vertices[at : end + 1].tolist()
    for i, weight in enumerate(contour.weights[at + 1 : end : 2].tolist()):
        start, handle, stop = points[2 * i : 2 * i + 3]
        if abs(weight - 1) <= 4 * EPSILON:
            yield "Q" + " ".join(_words([*handle, *stop]))
            continue
        if weight > 1:
            raise _no_arc("an arc of a hyperbola", start, stop)
        pieces = [(start, handle, stop, weight)]
        for piece in halves(*pieces[0]) if weight < WELL_SHAPED else pieces:
            arc = arc_of(*piece)
            if arc:
                yield "A" + " ".join(_words([*arc[:3], 0, arc[3], *piece[2]]))
            elif all(min(a, b) <= x <= max(a, b) for a, x, b in zip(*piece[:3], strict=True)):
                yield "L" + " ".join(_words([*piece[2]]))
            else:
                raise _no_arc("a flat arc that turns back", start, stop)


def _no_arc(kind: str, start: Point, end: Point) -> BadValue:
    return BadValue("arcs of ellipses for SVG", f"{kind} from {start} to {end}", APPROXIMATE)


def _words(numbers: list[float]) -> list[str]:
    """Return the shortest texts that read back as the same floats; whole numbers without .0."""
    return [repr(n).removesuffix(".0") for n in numbers]

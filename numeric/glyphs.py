"""Outlines of letters: real Bezier curves, read from TrueType fonts with exact coordinates.

A TrueType contour is a closed list of points, each on or off the curve. An off-curve point is
the middle control point of a quadratic; between two off-curve points in a row the format leaves
out the on-curve point half-way, and `Glyph.contours` puts it back.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from symbolic.errors import BadValue

from .fonts import glyph_name, open_font, readable

Point = tuple[Fraction, Fraction]
Segment = tuple[Point, ...]


@dataclass(frozen=True)
class Glyph:
    """The outline of one character, in font units.

    Attributes
    ----------
    character, font : str
    units_per_em : int
        Font units per em square (the height of a line of type).
    points : tuple of contours
        As the font stores them: (x, y, on_curve) for every point.

    Examples
    --------
    >>> letter = glyph("o")
    >>> len(letter.contours)
    2
    >>> {len(segment) for contour in letter.contours for segment in contour}
    {3}
    """

    character: str
    font: str
    units_per_em: int
    points: tuple[tuple[tuple[int, int, bool], ...], ...]

    @cached_property
    def contours(self) -> tuple[tuple[Segment, ...], ...]:
        """Closed contours as Bezier segments: 2 control points for a line, 3 for a quadratic.

        Every segment starts where the one before ends; coordinates are exact fractions.
        """
        return tuple(_segments(contour) for contour in self.points if len(contour) > 1)


def glyph(character: str, font: str = "DejaVu Sans") -> Glyph:
    """Read the outline of one character.

    Parameters
    ----------
    character : str of length 1
    font : str
        The name of a TrueType font that matplotlib ships, or the path of a .ttf file.

    Raises
    ------
    BadValue
        For more or less than one character, a font that is not found or is not TrueType, and a
        character that the font does not have.
    """
    tables = open_font(font)
    name = glyph_name(character, tables, font)
    if "glyf" not in tables:
        raise BadValue(
            "a font with TrueType outlines", str(font),
            "numeric.bridges.from_font reads cubic ones (CFF), too.",
        )  # fmt: skip
    with readable(font):
        outlines = tables["glyf"]
        coordinates, ends, on_curve = outlines[name].getCoordinates(outlines)[:3]
        points = [(x, y, bool(on & 1)) for (x, y), on in zip(coordinates, on_curve, strict=True)]
    starts = [0, *(end + 1 for end in ends)]
    contours = (tuple(points[a : b + 1]) for a, b in zip(starts, ends, strict=False))
    return Glyph(character, font, tables["head"].unitsPerEm, tuple(contours))


def _segments(contour: tuple[tuple[int, int, bool], ...]) -> tuple[Segment, ...]:
    points = _with_implied_points(contour)
    first = next(i for i, (_, on) in enumerate(points) if on)
    points = [*points[first:], *points[: first + 1]]  # closed, from an on-curve point to itself
    segments: list[Segment] = []
    segment: list[Point] = []
    for point, on in points:
        segment.append(point)
        if on and len(segment) > 1:
            segments.append(tuple(segment))
            segment = [point]
    return tuple(s for s in segments if len(s) > 2 or s[0] != s[1])


def _with_implied_points(contour: tuple[tuple[int, int, bool], ...]) -> list[tuple[Point, bool]]:
    """Insert the on-curve midpoint between every two off-curve points in a row, cyclically."""
    points: list[tuple[Point, bool]] = []
    for (ax, ay, a_on), (bx, by, b_on) in zip(contour, contour[1:] + contour[:1], strict=True):
        points.append(((Fraction(ax), Fraction(ay)), a_on))
        if not a_on and not b_on:
            points.append(((Fraction(ax + bx, 2), Fraction(ay + by, 2)), True))
    return points

"""Outlines of letters, read and written by the pens of fontTools."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from symbolic.errors import BadType, BadValue, shown

from ..fonts import glyph_name, open_font, readable
from .contour import Contour
from .outlines import up_to_cubic
from .recorder import Recorder


def from_font(character: str, font: str = "DejaVu Sans") -> tuple[Contour, ...]:
    """Return the outline of one character, in font units with y upwards.

    TrueType outlines have quadratics, PostScript ones (CFF, mostly .otf) cubics. `numeric.glyph`
    tells more of a TrueType outline: exact fractions, and its points as the font stores them.

    Parameters
    ----------
    character : str of length 1
    font : str
        The name of a font that matplotlib ships, or the path of a .ttf or .otf file.

    Raises
    ------
    BadValue
        For more or less than one character, a font that is not found, damaged or without outlines,
        and a character that the font does not have.

    Examples
    --------
    >>> [len(contour.degrees) for contour in from_font("i")]
    [4, 4]
    """
    tables = open_font(font)
    name = glyph_name(character, tables, font)
    with readable(font):
        return from_glyph(tables.getGlyphSet()[name])


def from_glyph(glyph: Any) -> tuple[Contour, ...]:
    """Return the outline that a glyph of fontTools draws; components are resolved.

    Parameters
    ----------
    glyph : object with the method draw(pen)
        Such as TTFont(file).getGlyphSet()["a"]. Glyphs with components have a `glyphSet`.

    Raises
    ------
    BadValue
        For components that are missing.
    BadType
        For what does not draw.

    Examples
    --------
    >>> glyphs = open_font("DejaVu Sans").getGlyphSet()
    >>> len(from_glyph(glyphs["aring"]))
    4
    """
    if not hasattr(glyph, "draw"):
        raise BadType("a glyph with draw(pen)", shown(glyph), "Such as font.getGlyphSet()['a'].")
    from fontTools.pens.basePen import MissingComponentError

    recorder = Recorder()
    try:
        glyph.draw(_reading_pen()(getattr(glyph, "glyphSet", {}), recorder))
    except MissingComponentError as error:
        raise BadValue(
            "a glyph whose components are in its glyphSet", f"one without {error}",
            "Take it from font.getGlyphSet().",
        ) from None  # fmt: skip
    return recorder.contours()


def draw(curves: Any, pen: Any) -> None:
    """Draw a curve, a contour, or a list or tuple of these, with a pen of fontTools.

    Coordinates are handed over as they are; a pen that builds a font rounds them to whole units.

    Raises
    ------
    BadValue
        For degrees above 3, and rational segments.
    BadType
        For what is no curve, or no pen.

    Examples
    --------
    >>> from numeric import Curve
    >>> from fontTools.pens.recordingPen import RecordingPen
    >>> pen = RecordingPen()
    >>> draw(Curve.from_bezier([[0, 0], [2, 4], [4, 0]]), pen)
    >>> pen.value[1]
    ('qCurveTo', ((2.0, 4.0), (4.0, 0.0)))
    """
    if not hasattr(pen, "qCurveTo"):
        raise BadType("a pen of fontTools", shown(pen), "Such as TTGlyphPen(None).")
    steps = {1: pen.lineTo, 2: pen.qCurveTo, 3: pen.curveTo}
    for contour in up_to_cubic(curves, "fonts"):
        points = [tuple(point) for point in contour.vertices.tolist()]
        degrees = contour.degrees[:-1] if contour.implied_line else contour.degrees
        pen.moveTo(points[0])
        for degree, start in zip(degrees.tolist(), contour.starts.tolist(), strict=False):
            steps[degree](*points[start + 1 : start + degree + 1])
        (pen.closePath if contour.closed else pen.endPath)()


@lru_cache(maxsize=1)
def _reading_pen() -> type:
    from fontTools.pens.basePen import BasePen

    class ReadingPen(BasePen):
        """Hands to a recorder what is left when components and implied points are resolved."""

        skipMissingComponents = False  # nothing is left out without a word

        def __init__(self, glyph_set: Any, recorder: Recorder) -> None:
            super().__init__(glyph_set)
            self._moveTo = recorder.move
            self._lineTo = lambda end: recorder.segments(1, end)
            self._qCurveToOne = lambda handle, end: recorder.segments(2, (*handle, *end))
            self._curveToOne = lambda one, two, end: recorder.segments(3, (*one, *two, *end))
            self._closePath = recorder.close

    return ReadingPen

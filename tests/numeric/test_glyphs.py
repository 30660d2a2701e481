"""Glyph outlines, against matplotlib's own reading of the same fonts."""

import pathlib
from fractions import Fraction

import matplotlib
import numpy as np
import pytest
from matplotlib.ft2font import FT2Font, LoadFlags
from matplotlib.path import Path

from numeric import glyph
from symbolic import BadValue

FONTS = pathlib.Path(matplotlib.get_data_path()) / "fonts" / "ttf"


def outline_by_freetype(character, file):
    """Control points in font units, contour by contour, as FreeType gives them."""
    font = FT2Font(str(FONTS / file))
    font.set_size(font.units_per_EM, 72)
    font.load_char(ord(character), flags=LoadFlags.NO_SCALE)
    vertices, codes = font.get_path()
    return vertices * 64, codes  # get_path divides by 64, also where nothing was scaled


@pytest.mark.parametrize("character", list("aegOS8&@%") + ["é", "ß", "Ω", "i"])
def test_control_points_are_those_of_freetype(character):
    """FreeType works in whole font units here, so its implied points are cut to integers."""
    vertices, codes = outline_by_freetype(character, "DejaVuSans.ttf")
    theirs = {tuple(v) for v, code in zip(vertices, codes, strict=True) if code != Path.CLOSEPOLY}
    segments = [segment for contour in glyph(character).contours for segment in contour]
    ours = {(int(x), int(y)) for segment in segments for x, y in segment}
    assert theirs == ours


@pytest.mark.parametrize("file", ["DejaVuSans.ttf", "DejaVuSerif-Italic.ttf", "cmr10.ttf"])
def test_every_contour_of_every_glyph_is_closed(file):
    font = FT2Font(str(FONTS / file))
    for code in sorted(font.get_charmap())[:400]:
        for contour in glyph(chr(code), str(FONTS / file)).contours:
            for segment, following in zip(contour, contour[1:] + contour[:1], strict=True):
                assert len(segment) in (2, 3)
                assert segment[-1] == following[0]
                assert all(isinstance(c, Fraction) for point in segment for c in point)


def test_implied_points_lie_half_way():
    letter = glyph("o")
    stored = {(x, y) for contour in letter.points for x, y, on in contour if on}
    for contour in letter.contours:
        for (_, handle, end), (_, following, _) in zip(contour, contour[1:], strict=False):
            if end not in stored:
                assert np.array_equal(2 * np.array(end), np.array(handle) + np.array(following))


def test_a_space_has_no_contours():
    assert glyph(" ").contours == ()


def test_a_path_is_a_font_too():
    assert glyph("a", str(FONTS / "DejaVuSans.ttf")).contours == glyph("a").contours


@pytest.mark.parametrize(("character", "font", "said"), [
    ("ab", "DejaVu Sans", "one character"),
    ("", "DejaVu Sans", "one character"),
    (7, "DejaVu Sans", "one character"),
    ("a", "Comic Sans", "ships DejaVuSans"),
    ("a", "/no/such/font.ttf", "TrueType font"),
    ("\u4e2d", "DejaVu Sans", "U\\+4E2D"),
])  # fmt: skip
def test_bad_input(character, font, said):
    with pytest.raises(BadValue, match=said):
        glyph(character, font)


def test_a_file_that_is_no_font(tmp_path):
    (tmp_path / "broken.ttf").write_bytes(b"not a font at all")
    with pytest.raises(BadValue, match="TrueType font file"):
        glyph("a", str(tmp_path / "broken.ttf"))

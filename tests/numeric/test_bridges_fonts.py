"""Glyphs by fontTools: TrueType and PostScript outlines, damaged fonts, pens."""

import pathlib

import matplotlib
import numpy as np
import pytest
from fontTools.fontBuilder import FontBuilder
from fontTools.pens.recordingPen import RecordingPen
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from hypothesis import given, settings

from contours import bits, paths
from numeric import Curve, glyph
from numeric.bridges import Contour, draw, from_font, from_glyph
from numeric.fonts import open_font
from symbolic import BadType, BadValue, circle

FONTS = pathlib.Path(matplotlib.get_data_path()) / "fonts" / "ttf"
LEAF = Contour([[0, 0], [50, 100], [100, 100], [150, 0], [0, 0]], [3, 1], closed=True)
DROP = Contour([[0, 0], [50, 100], [100, 0], [0, 0]], [2, 1], closed=True)


def font_file(path, outline, pen):
    """Write a font whose letter A is an outline, as PostScript or TrueType."""
    names = [".notdef", "A"]
    builder = FontBuilder(1000, isTTF=pen is TTGlyphPen)
    builder.setupGlyphOrder(names)
    builder.setupCharacterMap({65: "A"})
    if pen is TTGlyphPen:
        pens = {name: TTGlyphPen(None) for name in names}
        draw(outline, pens["A"])
        builder.setupGlyf({name: pens[name].glyph() for name in names})
    else:
        pens = {name: T2CharStringPen(600, None) for name in names}
        draw(outline, pens["A"])
        strings = {name: pens[name].getCharString() for name in names}
        builder.setupCFF("Test", {}, strings, {})
    builder.setupHorizontalMetrics(dict.fromkeys(names, (600, 0)))
    builder.setupHorizontalHeader()
    builder.setupNameTable({})
    builder.setupOS2()
    builder.setupPost()
    builder.save(path)
    return str(path)


@pytest.mark.parametrize(("name", "outline", "pen"), [
    ("a.otf", LEAF, T2CharStringPen), ("a.ttf", DROP, TTGlyphPen)
])  # fmt: skip
def test_a_font_written_and_read(tmp_path, name, outline, pen):
    file = font_file(tmp_path / name, outline, pen)
    (back,) = from_font("A", file)
    assert back.closed and sorted(back.degrees) == sorted(outline.degrees)
    at = {tuple(v) for v in back.vertices.tolist()}
    assert at == {tuple(v) for v in outline.vertices.tolist()}
    assert abs(back.curve.length() - outline.curve.length()) < 1e-9


def test_fractions_of_cubic_outlines_are_asked_for_elsewhere(tmp_path):
    file = font_file(tmp_path / "a.otf", LEAF, T2CharStringPen)
    with pytest.raises(BadValue, match="numeric.bridges.from_font"):
        glyph("A", file)


@pytest.mark.parametrize("character", list("aegOS8&@%i \u00e9\u00df\u03a9"))
def test_true_type_outlines_are_those_of_glyph(character):
    """All exact: fractions of 1/2 are floats."""
    contours = from_font(character)
    exact = glyph(character).contours
    assert len(contours) == len(exact)
    for ours, theirs in zip(contours, exact, strict=True):
        vertices = [theirs[0][0], *(point for segment in theirs for point in segment[1:])]
        degrees = [len(segment) - 1 for segment in theirs]
        # They may start elsewhere on the closed contour.
        ends = {tuple(map(float, p)) for p in vertices}
        assert {tuple(v) for v in ours.vertices.tolist()} == ends
        assert sorted(ours.degrees) == sorted(degrees) and ours.closed


def test_components_are_resolved_and_none_left_out():
    glyphs = open_font("DejaVu Sans").getGlyphSet()
    ring, letter = from_glyph(glyphs["aring"]), from_glyph(glyphs["a"])
    assert len(ring) > len(letter)
    assert bits(ring[: len(letter)]) == bits(letter)

    class Alone:
        def draw(self, pen):
            pen.addComponent("missing", (1, 0, 0, 1, 0, 0))

    with pytest.raises(BadValue, match="components"):
        from_glyph(Alone())


@settings(max_examples=60, deadline=None)
@given(paths)
def test_what_a_pen_draws_comes_back_bit_for_bit(drawn):
    pen = RecordingPen()
    draw(drawn, pen)

    class Glyph:
        def draw(self, other):
            pen.replay(other)

    assert bits(from_glyph(Glyph())) == bits(drawn)


@pytest.mark.parametrize(("curve", "said"), [
    (Curve.from_bezier([[0, 0]] * 5), "degree 4"),
    (Curve.from_nurbs(circle()), "rational"),
    (Curve.from_bezier([[0], [1]]), "in the plane"),
])  # fmt: skip
def test_what_a_font_cannot_hold(curve, said):
    with pytest.raises(BadValue, match=said):
        draw(curve, RecordingPen())


def test_what_is_no_pen_and_no_glyph():
    with pytest.raises(BadType, match="a pen"):
        draw(LEAF, None)
    with pytest.raises(BadType, match="a glyph"):
        from_glyph("a")


@pytest.mark.parametrize(("character", "font", "said"), [
    ("ab", "DejaVu Sans", "one character"),
    (None, "DejaVu Sans", "one character"),
    ("a", "Comic Sans", "ships DejaVuSans"),
    ("a", None, "name or path"),
    ("\u4e2d", "DejaVu Sans", "U\\+4E2D"),
])  # fmt: skip
def test_bad_input(character, font, said):
    with pytest.raises(BadValue, match=said):
        from_font(character, font)


@pytest.mark.parametrize("name", ["STIXSizOneSymReg.ttf", "leaf.otf"])
def test_a_damaged_font_is_read_or_refused(tmp_path, name):
    """Bytes changed at random, and files cut short, fail with one kind of error."""
    if name == "leaf.otf":
        whole = pathlib.Path(font_file(tmp_path / name, LEAF, T2CharStringPen)).read_bytes()
        character = "A"
    else:
        whole, character = (FONTS / name).read_bytes(), "("
    rng = np.random.default_rng(5)
    refused = 0
    for k in range(60):
        data = bytearray(whole)
        for at in rng.integers(0, len(data), 40 if k % 3 else 0):
            data[at] = rng.integers(256)
        file = tmp_path / f"{k}{name[-4:]}"
        file.write_bytes(data[: rng.integers(len(data))] if k % 3 == 0 else data)
        for read in (from_font, glyph):
            try:
                read(character, str(file))
            except BadValue:
                refused += read is from_font
    assert refused > 10

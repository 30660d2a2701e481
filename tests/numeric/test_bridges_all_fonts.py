"""Every glyph of every font that matplotlib ships: read, flattened, measured, through SVG."""

import io
import logging
import pathlib

import matplotlib
import numpy as np
import pytest
from fontTools.ttLib import TTFont

from contours import bits
from numeric.bridges import from_glyph, from_svg, segments_by_degree, to_svg

FILES = sorted((pathlib.Path(matplotlib.get_data_path()) / "fonts" / "ttf").glob("*.ttf"))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_every_glyph(file, monkeypatch):
    monkeypatch.setattr(logging.getLogger("fontTools"), "disabled", True)  # odd dates in STIX
    glyphs = TTFont(io.BytesIO(file.read_bytes()), lazy=True).getGlyphSet()
    contours = [contour for name in glyphs for contour in from_glyph(glyphs[name])]
    assert contours and all(contour.closed for contour in contours)
    different = list({(c.vertices.tobytes(), *c.degrees): c for c in contours}.values())
    assert bits(from_svg(to_svg(different))) == bits(different)
    measured = [measures(curve) for curve in segments_by_degree(different)]
    assert {degree for degree, *_ in measured} <= {1, 2}
    for _, chords, polyline, length, polygon in measured:
        assert 0 < chords <= polyline <= length * (1 + 1e-9) <= polygon * (1 + 2e-9)


def measures(curve):
    """Return four lengths of all segments: chords <= flattened <= the curve <= its polygon."""
    low, high = curve.bounding_box()
    points = curve.flatten(2.0)
    assert (points.min(axis=0) >= low - 1e-9).all() and (points.max(axis=0) <= high + 1e-9).all()
    sizes = [curve.points[:, [0, -1]], curve.points]
    chords, polygon = (np.hypot(*np.moveaxis(np.diff(p, axis=1), 2, 0)).sum() for p in sizes)
    return curve.degree, chords, along(curve, points), curve.length(), polygon


def along(curve, points):
    """Return the length of a flattened curve without its gaps, where a parameter stands twice."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    return steps[np.diff(curve.flat_parameters(2.0)) > 0].sum()

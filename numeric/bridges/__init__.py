"""Curves to and from SVG, matplotlib, fonts, SciPy and JSON, and nothing lost on the way."""

from .contour import Contour
from .fonts import draw, from_font, from_glyph
from .json_text import from_json, to_json
from .matplotlib_paths import from_matplotlib, to_matplotlib
from .outlines import segments_by_degree
from .scipy_splines import from_scipy, to_scipy
from .svg import from_svg, to_svg

__all__ = [
    "Contour",
    "draw",
    "from_font",
    "from_glyph",
    "from_json",
    "from_matplotlib",
    "from_scipy",
    "from_svg",
    "segments_by_degree",
    "to_json",
    "to_matplotlib",
    "to_scipy",
    "to_svg",
]

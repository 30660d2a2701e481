"""Curves to and from SVG, matplotlib, fonts, SciPy and JSON, and nothing lost on the way.

SVG, matplotlib and fonts draw paths: tuples of contours, whose segments have any degrees. What
reads them returns these, what writes them takes curves as well.

Examples
--------
A letter as an SVG path, and half a circle from one.

>>> to_svg(from_font("l"))
'M193 1556 L377 1556 377 0 193 0 Z'
>>> from_svg("M0 0a1 1 0 0 0 2 0")[0].curve
<Curve: 2 rational segments of degree 2 in 2D on [0, 2]>
"""

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

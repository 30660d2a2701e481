"""Float64 kernels: the tape that runs derived formulas, piecewise curves, glyph outlines.

Curves come from other formats and go to them by `numeric.bridges`.
"""

from .curve import Curve
from .glyphs import Glyph, glyph
from .intersections.segments import intersect_segments
from .points import float_points, real_number
from .tape.compile import quotient_or_zero
from .tape.tape import Tape, compile_tape, flattened

__all__ = [
    "Curve",
    "Glyph",
    "Tape",
    "compile_tape",
    "flattened",
    "float_points",
    "glyph",
    "intersect_segments",
    "quotient_or_zero",
    "real_number",
]

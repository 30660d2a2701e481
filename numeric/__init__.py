"""Float64 kernels: the tape that runs derived formulas, piecewise curves, glyph outlines."""

from .curve import Curve
from .glyphs import Glyph, glyph
from .points import float_points, real_number
from .tape.tape import Tape, compile_tape, flattened

__all__ = [
    "Curve",
    "Glyph",
    "Tape",
    "compile_tape",
    "flattened",
    "float_points",
    "glyph",
    "real_number",
]

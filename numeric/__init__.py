"""Float64 kernels: the tape that runs derived formulas, piecewise curves, glyph outlines."""

from .curve import Curve
from .glyphs import Glyph, glyph
from .points import float_points
from .tape import Tape, compile_tape

__all__ = ["Curve", "Glyph", "Tape", "compile_tape", "float_points", "glyph"]

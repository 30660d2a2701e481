"""Explorers: functions that build a scene and return it as a live figure, one per topic."""

from .bezier_properties import bezier_properties
from .blossom import blossom
from .bspline import bspline
from .continuity import continuity
from .de_casteljau import de_casteljau
from .hodograph import hodograph
from .interpolation import interpolation
from .knot_insertion import knot_insertion
from .kochanek_bartels import kochanek_bartels
from .rational import rational
from .subdivision import subdivision

__all__ = [
    "bezier_properties",
    "blossom",
    "bspline",
    "continuity",
    "de_casteljau",
    "hodograph",
    "interpolation",
    "knot_insertion",
    "kochanek_bartels",
    "rational",
    "subdivision",
]

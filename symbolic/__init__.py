"""Exact mathematics of curves: bases, de Casteljau, derivations, proofs, checks of answers.

Every name a user needs is listed here; points are rows, results are exact.
"""

from .answers.check import check
from .bases.basis import Basis, Geometry
from .bases.bezier import bernstein, bezier
from .bases.catmull_rom import catmull_rom
from .bases.chord_knots import chord_knots
from .bases.constraints import Condition, derivative, value
from .bases.from_constraints import basis_from
from .bases.hermite import hermite
from .bases.kochanek_bartels import cardinal, kochanek_bartels
from .bases.lagrange import lagrange
from .bases.monomial import monomial
from .bases.uniform_bspline import uniform_bspline
from .blossoms.blossom import Blossom, blossom
from .blossoms.candidate import check_blossom
from .curves.conversion import polynomial_to_bezier
from .curves.de_casteljau import de_casteljau, polar_levels, restrict, subdivide
from .curves.degree import Reduction, elevate_degree, reduce_degree
from .curves.hodograph import antiderivative, hodograph
from .curves.properties import bezier_properties
from .errors import BadType, BadValue, NotExact, OutsideDomain, UnsolvableConstraints
from .proofs.derivation import Derivation, Step
from .proofs.proof import prove
from .proofs.verdict import Proved, Refuted, Undecided, Verdict
from .splines.bspline import BSpline
from .splines.ends import (
    closed_derivation,
    multiple_vertex_derivation,
    phantom_derivation,
    phantom_ends,
    repeat_ends,
    wrap_points,
)
from .splines.knots import KnotVector, clamped_knots, uniform_knots

FAMILIES = {"Bezier": bezier, "Hermite": hermite}
"""The spline families by name; the laws in the tests run over all of them."""

__all__ = [
    "FAMILIES",
    "BSpline",
    "BadType",
    "BadValue",
    "Basis",
    "Blossom",
    "Condition",
    "Derivation",
    "Geometry",
    "KnotVector",
    "NotExact",
    "OutsideDomain",
    "Proved",
    "Reduction",
    "Refuted",
    "Step",
    "Undecided",
    "UnsolvableConstraints",
    "Verdict",
    "antiderivative",
    "basis_from",
    "bernstein",
    "bezier",
    "bezier_properties",
    "blossom",
    "cardinal",
    "catmull_rom",
    "check",
    "check_blossom",
    "chord_knots",
    "clamped_knots",
    "closed_derivation",
    "de_casteljau",
    "derivative",
    "elevate_degree",
    "hermite",
    "hodograph",
    "kochanek_bartels",
    "lagrange",
    "monomial",
    "multiple_vertex_derivation",
    "phantom_derivation",
    "phantom_ends",
    "polar_levels",
    "polynomial_to_bezier",
    "prove",
    "reduce_degree",
    "repeat_ends",
    "restrict",
    "subdivide",
    "uniform_bspline",
    "uniform_knots",
    "value",
    "wrap_points",
]

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
from .bases.identify import Identification, identify
from .bases.kochanek_bartels import cardinal, kochanek_bartels
from .bases.lagrange import lagrange
from .bases.monomial import monomial
from .bases.uniform_bspline import uniform_bspline
from .blossoms.blossom import Blossom, blossom
from .blossoms.candidate import check_blossom
from .continuity.conditions import JointConditions
from .continuity.connection import connection_matrix
from .continuity.continuity_at import continuity_at
from .continuity.geometric import geometric_continuity
from .continuity.joint import Continuity
from .continuity.parametric import a_frame, parametric_continuity
from .continuity.properties import joint_properties
from .curves.algorithms import bezier_algorithms, subdivision_matrices
from .curves.conversion import polynomial_to_bezier
from .curves.de_casteljau import de_casteljau, polar_levels, restrict, subdivide
from .curves.degree import Reduction, elevate_degree, reduce_degree
from .curves.hodograph import antiderivative, hodograph
from .curves.properties import bezier_properties
from .errors import BadType, BadValue, NotExact, OutsideDomain, UnsolvableConstraints
from .interpolation.cubic_spline import InterpolatingSpline, interpolating_spline
from .interpolation.energy import minimum_acceleration
from .interpolation.oscillation import lebesgue_function, runge_phenomenon
from .proofs.derivation import Derivation, Step
from .proofs.proof import prove
from .proofs.verdict import Proved, Refuted, Undecided, Verdict
from .rational.arcs import arc, arc_between, on_circle
from .rational.circle import circle
from .rational.common_denominator import rational_to_bezier
from .rational.conics import Conic, conic_through, conic_type
from .rational.homogeneous import HullWarning, RationalLevels
from .rational.implicit import ImplicitCurve, implicitize
from .rational.nurbs import NURBS
from .rational.properties import rational_properties
from .rational.rational_bezier import RationalBezier
from .splines.bspline import BSpline
from .splines.ends import (
    closed_derivation,
    multiple_vertex_derivation,
    phantom_derivation,
    phantom_ends,
    repeat_ends,
    wrap_points,
)
from .splines.knots import KnotVector
from .splines.standard_knots import clamped_knots, uniform_knots

FAMILIES = {
    "Bezier": bezier,
    "Hermite": hermite,
    "monomial": monomial,
    "Lagrange": lagrange,
    "uniform B-spline": uniform_bspline,
    "Catmull-Rom": catmull_rom,
    "cardinal": cardinal,
    "Kochanek-Bartels": kochanek_bartels,
}
"""The spline families by name; the laws in the tests run over all of them."""

__all__ = [
    "FAMILIES",
    "NURBS",
    "BSpline",
    "BadType",
    "BadValue",
    "Basis",
    "Blossom",
    "Condition",
    "Conic",
    "Continuity",
    "Derivation",
    "Geometry",
    "HullWarning",
    "Identification",
    "ImplicitCurve",
    "InterpolatingSpline",
    "JointConditions",
    "KnotVector",
    "NotExact",
    "OutsideDomain",
    "Proved",
    "RationalBezier",
    "RationalLevels",
    "Reduction",
    "Refuted",
    "Step",
    "Undecided",
    "UnsolvableConstraints",
    "Verdict",
    "a_frame",
    "antiderivative",
    "arc",
    "arc_between",
    "basis_from",
    "bernstein",
    "bezier",
    "bezier_algorithms",
    "bezier_properties",
    "blossom",
    "cardinal",
    "catmull_rom",
    "check",
    "check_blossom",
    "chord_knots",
    "circle",
    "clamped_knots",
    "closed_derivation",
    "conic_through",
    "conic_type",
    "connection_matrix",
    "continuity_at",
    "de_casteljau",
    "derivative",
    "elevate_degree",
    "geometric_continuity",
    "hermite",
    "hodograph",
    "identify",
    "implicitize",
    "interpolating_spline",
    "joint_properties",
    "kochanek_bartels",
    "lagrange",
    "lebesgue_function",
    "minimum_acceleration",
    "monomial",
    "multiple_vertex_derivation",
    "on_circle",
    "parametric_continuity",
    "phantom_derivation",
    "phantom_ends",
    "polar_levels",
    "polynomial_to_bezier",
    "prove",
    "rational_properties",
    "rational_to_bezier",
    "reduce_degree",
    "repeat_ends",
    "restrict",
    "runge_phenomenon",
    "subdivide",
    "subdivision_matrices",
    "uniform_bspline",
    "uniform_knots",
    "value",
    "wrap_points",
]

"""Exact mathematics of curves: bases, de Casteljau, derivations, proofs, checks of answers.

Every name a user needs is listed here; points are rows, results are exact.
"""

from .basis import Basis, Geometry
from .bezier import bernstein, bezier
from .check import check
from .constraints import Condition, derivative, value
from .de_casteljau import de_casteljau, subdivide
from .derivation import Derivation, Step
from .errors import BadType, BadValue, NotExact, OutsideDomain, UnsolvableConstraints
from .from_constraints import basis_from
from .hermite import hermite
from .proof import prove
from .verdict import Proved, Refuted, Undecided, Verdict

FAMILIES = {"Bezier": bezier, "Hermite": hermite}
"""The spline families by name; the laws in the tests run over all of them."""

__all__ = [
    "FAMILIES",
    "BadType",
    "BadValue",
    "Basis",
    "Condition",
    "Derivation",
    "Geometry",
    "NotExact",
    "OutsideDomain",
    "Proved",
    "Refuted",
    "Step",
    "Undecided",
    "UnsolvableConstraints",
    "Verdict",
    "basis_from",
    "bernstein",
    "bezier",
    "check",
    "de_casteljau",
    "derivative",
    "hermite",
    "prove",
    "subdivide",
    "value",
]

"""Exact mathematics of curves: bases, de Casteljau, derivations, proofs, checks of answers.

Every name a user needs is listed here; points are rows, results are exact.
"""

from .answers.check import check
from .bases.basis import Basis, Geometry
from .bases.bezier import bernstein, bezier
from .bases.constraints import Condition, derivative, value
from .bases.from_constraints import basis_from
from .bases.hermite import hermite
from .curves.de_casteljau import de_casteljau, subdivide
from .errors import BadType, BadValue, NotExact, OutsideDomain, UnsolvableConstraints
from .proofs.derivation import Derivation, Step
from .proofs.proof import prove
from .proofs.verdict import Proved, Refuted, Undecided, Verdict

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

"""Every derivation the package offers, for the tests that hold all of them to account.

A room adds its derivations here: a name, and a function without arguments that builds one. Keep
degrees small: every step is corrupted in several ways and decided again.
"""

from collections.abc import Callable

import sympy as sp

from symbolic import (
    Derivation,
    bezier,
    bezier_properties,
    blossom,
    continuity_at,
    geometric_continuity,
    hermite,
    interpolating_spline,
    joint_properties,
    minimum_acceleration,
    parametric_continuity,
    runge_phenomenon,
)

DERIVATIONS: list[tuple[str, Callable[[], Derivation]]] = [
    ("Bezier 3", lambda: bezier(3).derivation),
    ("Hermite 3", lambda: hermite(3).derivation),
    ("Hermite 5", lambda: hermite(5).derivation),
]

t = sp.Symbol("t")
DERIVATIONS += [
    (f"Bezier curve: {name}", lambda name=name: bezier_properties(3)[name])
    for name in bezier_properties(3)
]
DERIVATIONS += [
    ("Blossom of a cubic", lambda: blossom(t**3 - 2 * t + 5).certificate()),
    ("Blossom of a curve", lambda: blossom([t**2, 1 - t]).certificate()),
]
DERIVATIONS += [
    (f"Cubic spline with {ends} ends", lambda ends=ends: cubic_spline(ends).derivation)
    for ends in ("natural", "clamped", "periodic", "not-a-knot")
]
DERIVATIONS += [
    ("Least acceleration", lambda: minimum_acceleration(interpolating_spline([[0], [1], [0]]))),
    ("Runge's function", lambda: runge_phenomenon(3)),
]


def cubic_spline(ends):
    """Return a spline through points whose data are no accident."""
    tangents = [[1], [-2]] if ends == "clamped" else None
    return interpolating_spline([[0], [1], [3], [0]], [0, 1, 3, 4], ends, tangents)


r, b1, b2 = sp.symbols("r b1 b2")
CUBIC = [[0, 0], [1, 3], [3, 3], [4, 2]]
JOINTS = {
    "a gap": [[5, 2], [6, 2]],
    "a corner": [[4, 2], [5, 2], [6, 0]],
    "a fold": [[4, 2], [3, 3], [3, 0]],
    "in line": [[4, 2], [6, 0], [7, 0]],
}
DERIVATIONS += [
    *((f"Joints: {name}", lambda name=name: joint_properties(2)[name])
      for name in joint_properties(2)),
    *((f"Joint: {name}", lambda name=name: continuity_at(CUBIC, JOINTS[name]).derivation)
      for name in JOINTS),
    ("C^2 joint", lambda: parametric_continuity(3, 2, r).derivation),
    ("G^2 joint", lambda: geometric_continuity(3, 2, (b1, b2)).derivation),
]  # fmt: skip

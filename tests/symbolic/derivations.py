"""Every derivation the package offers, for the tests that hold all of them to account.

A room adds its derivations here: a name, and a function without arguments that builds one. Keep
degrees small: every step is corrupted in several ways and decided again.
"""

from collections.abc import Callable

import sympy as sp

from symbolic import (
    NURBS,
    BSpline,
    Derivation,
    RationalBezier,
    arc,
    basis_from,
    bezier,
    bezier_algorithms,
    bezier_properties,
    blossom,
    cardinal,
    catmull_rom,
    chord_knots,
    closed_derivation,
    conic_type,
    continuity_at,
    derivative,
    geometric_continuity,
    hermite,
    implicitize,
    interpolating_spline,
    joint_properties,
    kochanek_bartels,
    lagrange,
    minimum_acceleration,
    monomial,
    multiple_vertex_derivation,
    on_circle,
    parametric_continuity,
    phantom_derivation,
    rational_properties,
    restrict,
    runge_phenomenon,
    uniform_bspline,
    value,
)

t, a, b, r, b1, b2 = sp.symbols("t a b r b1 b2")
DERIVATIONS: list[tuple[str, Callable[[], Derivation]]] = [
    ("Bezier 3", lambda: bezier(3).derivation),
    ("Hermite 3", lambda: hermite(3).derivation),
    ("Hermite 5", lambda: hermite(5).derivation),
    ("Monomials", lambda: monomial(3).derivation),
    ("Lagrange", lambda: lagrange([0, sp.Rational(1, 3), 2]).derivation),
    ("Lagrange over symbols", lambda: lagrange([0, sp.Symbol("a"), 1]).derivation),
    ("Uniform B-spline", lambda: uniform_bspline(3).derivation),
    ("Catmull-Rom", lambda: catmull_rom().derivation),
    ("Catmull-Rom over symbolic knots", lambda: catmull_rom([-a, 0, 1, 1 + b]).derivation),
    ("Catmull-Rom over chordal knots", lambda: catmull_rom(CHORDAL).derivation),
    ("Cardinal spline", lambda: cardinal(sp.Symbol("T")).derivation),
    ("Values and a slope", lambda: basis_from([value(0), derivative(0), value(2)]).derivation),
    ("Kochanek-Bartels", lambda: kochanek_bartels(*sp.symbols("T C B")).derivation),
]
CHORDAL = chord_knots([[0, 0], [1, 2], [3, 1], [4, 7]], 1)

DERIVATIONS += [
    (f"Bezier curve: {name}", lambda name=name: bezier_properties(3)[name])
    for name in bezier_properties(3)
]
DERIVATIONS += [
    (f"Bezier algorithm: {name}", lambda name=name: bezier_algorithms(3)[name])
    for name in bezier_algorithms(3)
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
    *((f"Least acceleration with {ends} ends",
       lambda ends=ends: minimum_acceleration(cubic_spline(ends)))
      for ends in ("natural", "clamped", "periodic")),
    ("Runge's function", lambda: runge_phenomenon(3)),
]  # fmt: skip


def cubic_spline(ends):
    """Return a spline through points whose data are no accident."""
    tangents = [[1], [-2]] if ends == "clamped" else None
    return interpolating_spline([[0], [1], [3], [0]], [0, 1, 3, 4], ends, tangents)


CUBIC = [[0, 0], [1, 3], [3, 3], [4, 2]]
JOINTS = {
    "a gap": [[5, 2], [6, 2]],
    "a corner": [[4, 2], [5, 2], [6, 0]],
    "a fold": [[4, 2], [3, 3], [3, 0]],
    "in line": [[4, 2], [6, 0], [7, 0]],
    "the same curve": restrict(CUBIC, 1, 2),
    "a symbol": [[4, 2], [4 + r, 2 - r], [7, 0]],
    "a rational curve": (4 + t / (1 + t), 2 - t),
    "a cusp": (4 - t**2, 2 + t**3),
}
DERIVATIONS += [
    *((f"Joints: {name}", lambda name=name: joint_properties(2)[name])
      for name in joint_properties(2)),
    *((f"Joint: {name}", lambda name=name: continuity_at(CUBIC, JOINTS[name]).derivation)
      for name in JOINTS),
    ("C^2 joint", lambda: parametric_continuity(3, 2, r).derivation),
    ("G^2 joint", lambda: geometric_continuity(3, 2, (b1, b2)).derivation),
]  # fmt: skip

QUADRATIC = BSpline([0, 0, 0, 1, 1, 3, 4, 4, 4], 2)
DERIVATIONS += [
    ("B-splines with a double knot", lambda: QUADRATIC.derivation),
    ("B-splines over symbolic knots", lambda: BSpline([0, 0, a, a + b, 5, 5], 1).derivation),
    ("Span of a B-spline", lambda: BSpline([0, 1, 3, 4, 6, 7, 9, 9], 3).span_basis(3).derivation),
    ("De Boor's algorithm", lambda: QUADRATIC.de_boor_derivation(4)),
    ("Knot insertion", lambda: QUADRATIC.insertion_derivation(2)),
    ("Knot insertion at a symbol", lambda: BSpline([0, 0, a, 5, 5], 1).insertion_derivation(a)),
    ("Derivatives of B-splines", lambda: QUADRATIC.derivative_derivation(4)),
    ("A triple knot", lambda: BSpline([0, 0, 0, 1, 1, 1, 2, 2, 2], 2).continuity_derivation(1)),
    ("Rendering a B-spline", lambda: BSpline(range(7), 2).discretization_derivation(2)),
    ("Multiple vertices", multiple_vertex_derivation),
    ("Phantom vertices", phantom_derivation),
    ("A closed B-spline curve", closed_derivation),
]  # fmt: skip

QUARTER = [[1, 0], [1, 1], [0, 1]]
CONICS = [
    ("A parabola", QUARTER, [1, 1, 1]),
    ("An ellipse", [[2, 0], [2, 1], [0, 1]], [1, 1, 2]),
    ("A point", [[1, 2], [1, 2], [1, 2]], [1, 1, 2]),
]
DERIVATIONS += [
    *((f"Rational curves: {name}", lambda name=name: rational_properties(2)[name])
      for name in rational_properties(2)),
    ("A quarter of a circle", lambda: on_circle(arc(0))),
    ("A circle from weights", lambda: conic_type(QUARTER, [1, 1, 2]).derivation),
    *((f"{name} from weights", lambda points=points, weights=weights:
       conic_type(points, weights).derivation) for name, points, weights in CONICS),
    ("A hyperbola from weights", lambda: conic_type(QUARTER, [1, 3, 2]).derivation),
    ("A line from weights", lambda: conic_type([[0, 0], [1, 1], [3, 3]], [1, 2, 3]).derivation),
    ("A NURBS curve", lambda: NURBS([0, 0, 0, 1, 2, 2, 2], 2, [*QUARTER, [3, 1]],
                                    [1, 2, 3, 1]).derivation),
    ("Equation of the circle", lambda: implicitize(RationalBezier(QUARTER, [1, 1, 2])).derivation),
    ("Equation of a cubic", lambda: implicitize([t**2 - 1, t**3 - t]).derivation),
    ("Equation of a curve traced twice", lambda: implicitize([t**2, t**4 + t**2]).derivation),
]  # fmt: skip

"""What is said of joints, as statements that are proved for a given degree."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from ..bases.bezier import bernstein
from ..exact import PARAMETER
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .conditions import combination, derivative_at, difference
from .continuity_at import continuity_at
from .parameters import read_degree
from .parametric import a_frame, parametric_continuity

RATIO = sp.Symbol("r")
_SOURCE = "Farin, Curves and Surfaces for CAGD"


def joint_properties(n: int) -> dict[str, Derivation]:
    """Return the derivations of all properties below for degree n >= 2, by name.

    Raises
    ------
    BadValue
        If n is not an integer above 1.

    Examples
    --------
    >>> properties = joint_properties(3)
    >>> list(properties)[:2]
    ['C^k is G^k where the first derivative is not zero', 'C^k is not G^1 where it is zero']
    >>> all(derivation.is_proved for derivation in properties.values())
    True
    """
    degree = read_degree(n, lowest=2)
    return {name: derive(degree) for name, derive in PROPERTIES.items()}


def parametric_is_geometric(n: int) -> Derivation:
    """Return the proof that C^k is G^k, with beta1 the ratio of the intervals, the others zero.

    >>> parametric_is_geometric(2).is_proved
    True
    """
    t, points = PARAMETER, sp.symbols(f"P0:{n + 1}")
    curve = combination(points, bernstein(n))
    moved = curve.subs(t, 1 + RATIO * t)
    steps = [
        Step(derivative_at(moved, j, 0), RATIO**j * derivative_at(curve, j, 1),
             f"the change of parameter 1 + r t, r > 0, makes derivative {j} of this segment that "
             "of the next")
        for j in range(n + 1)
    ]  # fmt: skip
    return Derivation(f"C^k joints of degree {n} with p'(1) != 0 are G^k", tuple(steps), _SOURCE)


def cusp(n: int = 3) -> Derivation:
    """Return the counterexample (t^2, t^3): smooth in its parameter, its unit tangent jumps.

    >>> cusp().steps[-1].left, cusp().steps[-1].right
    (Matrix([[2, 0]]), -Matrix([[-2, 0]]))
    """
    t = PARAMETER
    return continuity_at(((t - 1) ** 2, (t - 1) ** 3), (t**2, t**3)).derivation


def a_frame_closes(n: int) -> Derivation:
    """Return the proof that a C^1 joint is C^2 exactly if d^- = d^+.

    >>> a_frame_closes(2).is_proved
    True
    """
    first, second = parametric_continuity(n, 1, RATIO), parametric_continuity(n, 2, RATIO)
    following = [[q] for q in (*first.points, *first.next[2:])]
    (before,), (after,) = a_frame([[p] for p in first.given], following, RATIO)
    residual = second.conditions[2][1] - difference([q for (q,) in following[:3]])
    product = times(RATIO, plus(after, -before))
    why = "r (d+ - d-) is what the second differences of a C^1 joint lack to C^2"
    return Derivation(
        f"The A-frame of a C^1 joint of degree {n}", (Step(product, residual, why),), _SOURCE
    )


def one_polynomial(n: int) -> Derivation:
    """Return the proof that a C^n joint of degree n has no freedom left: two cubics are one.

    >>> print(one_polynomial(1).title)
    C^1 joint of Bezier segments of degree 1
    """
    return parametric_continuity(n, n, RATIO).derivation


def last_derivative(n: int) -> Derivation:
    """Return the proof that derivative n is constant: a quadratic has one acceleration.

    >>> print(last_derivative(2).steps[0].right)
    2*(P0 - 2*P1 + P2)
    """
    points = sp.symbols(f"P0:{n + 1}")
    curve = combination(points, bernstein(n))
    value = combination([sp.factorial(n)], [difference(points)])
    why = f"{n}! times the highest difference of the control points, for every t"
    return Derivation(
        f"Derivative {n} of degree {n}",
        (Step(sp.Derivative(curve, (PARAMETER, n)), value, why),),
        _SOURCE,
    )


PROPERTIES: dict[str, Callable[[int], Derivation]] = {
    "C^k is G^k where the first derivative is not zero": parametric_is_geometric,
    "C^k is not G^1 where it is zero": cusp,
    "C^2 is d^- = d^+": a_frame_closes,
    "C^n joints of degree n are one polynomial": one_polynomial,
    "the last derivative is constant": last_derivative,
}

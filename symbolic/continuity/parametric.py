"""Parametric continuity C^k: derivatives agree, so both segments follow one polynomial so far."""

from __future__ import annotations

from functools import partial
from typing import Any

import sympy as sp

from ..bases.bezier import bernstein
from ..curves.de_casteljau import subdivide
from ..dag import substitute
from ..errors import BadValue
from ..exact import PARAMETER, Point, control_points
from ..proofs.derivation import Derivation, Step
from .conditions import JointConditions, combination, derivative_steps, solution_steps
from .parameters import (
    read_degree,
    read_order,
    read_positive,
    refuse_dimensions,
    refuse_names,
)


def parametric_continuity(n: int, k: int, ratio: Any = 1) -> JointConditions:
    r"""Return the conditions for a C^k joint of two Bezier segments of degree n.

    q^(j)(0) = ratio^j p^(j)(1), j = 0 ... k; hence Q_j = b(1, ..., 1, 1 + ratio, ..., 1 + ratio)
    with j arguments 1 + ratio, b the blossom of p: the next segment continues the same polynomial
    as far as k tells.

    Parameters
    ----------
    n : int >= 1
    k : int, 0 <= k <= n
        For k = n nothing is left to choose: both segments are one polynomial.
    ratio : number or expression
        The length of the next segment's parameter interval by that of this one's, positive; a
        symbol is taken to be.

    Raises
    ------
    BadValue, BadType, NotExact
        For a degree or order out of range, a ratio that is not positive, or that uses t or the
        names of the control points.

    Notes
    -----
    Farin, *Curves and Surfaces for CAGD*, sections on C^r joints (E. Staerk's theorem, 1976).

    Examples
    --------
    >>> parametric_continuity(3, 2).points
    (P3, -P2 + 2*P3, P1 - 4*P2 + 4*P3)
    >>> r = sp.Symbol("r")
    >>> parametric_continuity(3, 1, r).conditions[1]
    (-Q0 + Q1, r*(-P2 + P3))
    >>> parametric_continuity(3, 2, r).derivation.is_proved
    True
    """
    degree = read_degree(n)
    order = read_order(k, degree)
    scale = read_positive(ratio, "ratio of the intervals")
    betas = (scale, *(sp.S.Zero for _ in range(order)))[:order]
    joint = JointConditions(degree, order, betas, partial(_derivation, scale=scale))
    refuse_names([scale], [*joint.given, *joint.next])
    return joint


def a_frame(left: Any, right: Any, ratio: Any = 1) -> tuple[Point, Point]:
    r"""Return the A-frame points d^- and d^+ of two segments; at a C^1 joint, C^2 is d^- = d^+.

    d^- = p_{n-1} + ratio (p_{n-1} - p_{n-2}) prolongs the last but one leg of the left segment,
    d^+ = q_1 + (q_1 - q_2) / ratio the second leg of the right one backwards.

    Parameters
    ----------
    left, right : rows, shape (n + 1, dim), n >= 2
        Control points of two Bezier segments of one degree.
    ratio : number or expression
        The length of the right parameter interval by that of the left one, positive.

    Raises
    ------
    BadValue
        For different degrees or dimensions, a degree below 2, a ratio that is not positive.
    BadType, NotExact
        As in `exact_points`.

    Examples
    --------
    >>> a_frame([[0, 0], [0, 2], [2, 2], [3, 1]], [[3, 1], [4, 0], [4, -2], [6, -2]])
    ((4, 2), (4, 2))
    """
    p, q = control_points(left), control_points(right)
    scale = read_positive(ratio, "ratio of the intervals")
    refuse_dimensions(len(p[0]), len(q[0]))
    if len(p) != len(q):
        raise BadValue(
            "two segments of one degree",
            f"the degrees {len(p) - 1} and {len(q) - 1}",
            "Raise the lower one with elevate_degree; the curve stays the same.",
        )
    if len(p) < 3:
        raise BadValue("segments of degree 2 or more", f"{len(p) - 1}", "Use elevate_degree.")
    before = tuple(b + scale * (b - a) for a, b in zip(p[-3], p[-2], strict=True))
    after = tuple(a + (a - b) / scale for a, b in zip(q[1], q[2], strict=True))
    return before, after


def _derivation(joint: JointConditions, scale: sp.Expr) -> Derivation:
    n, t = joint.degree, PARAMETER
    # The right part of the curve split at 1 + ratio, read backwards, is the prolongation.
    blossom = [point[0] for point in subdivide([[p] for p in joint.given], 1 + scale)[1]][::-1]
    steps = [
        *derivative_steps(joint),
        *solution_steps(joint),
        *(Step(level, point, f"Q{j} is the blossom value with {j} of {n} arguments {1 + scale}, "
               "the others 1, by de Casteljau")
          for j, (level, point) in enumerate(zip(blossom, joint.points, strict=False))
          if level != point),
    ]  # fmt: skip
    if joint.order >= 2:
        before, after = a_frame([[p] for p in joint.given], [[q] for q in joint.next], scale)
        found = substitute(after, dict(zip(joint.next, joint.points, strict=False)))
        steps.append(
            Step(found[0], before[0], "the A-frame: d+ of the next segment is d- of this one")
        )
    if joint.order == n:
        following = combination(joint.points, bernstein(n))
        this = combination(joint.given, bernstein(n))
        steps.append(
            Step(following, sp.Subs(this, t, 1 + scale * t),
                 "no control point is left to choose: the next segment is the same polynomial")
        )  # fmt: skip
    return Derivation(
        f"C^{joint.order} joint of Bezier segments of degree {n}",
        tuple(steps),
        "Farin, Curves and Surfaces for CAGD",
    )

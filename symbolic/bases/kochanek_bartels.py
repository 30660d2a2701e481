"""Cardinal and Kochanek-Bartels curves: through their inner points, with adjustable tangents."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache, partial
from typing import Any

import sympy as sp

from ..exact import by_name, exact
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .basis import Basis
from .constraints import derivative, value
from .from_constraints import basis_of
from .parameters import parameter_from, refuse_clash

_POINTS = sp.symbols("P0:4")


def cardinal(tension: Any) -> Basis:
    r"""Return the basis of a cardinal spline's segment from P1 to P2, with G = (P0, P1, P2, P3).

    c'(0) = (1 - T)/2 (P2 - P0) and c'(1) = (1 - T)/2 (P3 - P1). T = 0 is Catmull-Rom, T = 1 makes
    the curve stop at every point.

    Parameters
    ----------
    tension : number or expression in symbols

    Raises
    ------
    BadValue
        If the tension contains t or a control point.
    BadType, NotExact
        If it cannot be read exactly.

    Examples
    --------
    >>> from symbolic import catmull_rom
    >>> cardinal(0).matrix == catmull_rom().matrix
    True
    >>> cardinal(sp.Symbol("T")).functions[3]
    t**3*(1/2 - T/2) + t**2*(T/2 - 1/2)
    """
    return _cardinal(_parameter(tension))


def kochanek_bartels(tension: Any, continuity: Any, bias: Any) -> Basis:
    r"""Return the basis of a Kochanek-Bartels segment from P1 to P2, with G = (P0, P1, P2, P3).

    The tangents are, with the signs of the paper of 1984,

    c'(0) = (1 - T)/2 ((1 + B)(1 + C)(P1 - P0) + (1 - B)(1 - C)(P2 - P1)), outgoing at P1, and
    c'(1) = (1 - T)/2 ((1 + B)(1 - C)(P2 - P1) + (1 - B)(1 + C)(P3 - P2)), incoming at P2.

    Two segments join with one tangent for all points just if C = 0 or T = 1. Some lecture notes
    and textbooks write (1 - gamma) where the paper has (1 + C): their continuity parameter has the
    opposite sign, gamma = -C.

    Parameters
    ----------
    tension, continuity, bias : numbers or expressions in symbols
        T, C and B; usually in [-1, 1]. C = B = 0 is the cardinal spline.

    Raises
    ------
    BadValue
        If a parameter contains t or a control point.
    BadType, NotExact
        If it cannot be read exactly.

    Notes
    -----
    Kochanek and Bartels, "Interpolating splines with local tension, continuity, and bias control",
    SIGGRAPH 1984.

    Examples
    --------
    >>> kochanek_bartels(0, 0, 0).matrix == cardinal(0).matrix
    True
    >>> kochanek_bartels(*sp.symbols("T C B")).derivation.is_proved
    True
    """
    return _kochanek_bartels(
        _parameter(tension),
        _parameter(continuity),
        _parameter(bias),
    )


@lru_cache(maxsize=64)
def _cardinal(tension: sp.Expr) -> Basis:
    p0, p1, p2, p3 = _POINTS
    factor = (1 - tension) / 2
    return _segment(
        factor * (p2 - p0), factor * (p3 - p1), f"cardinal basis with tension {tension}"
    )


@lru_cache(maxsize=64)
def _kochanek_bartels(tension: sp.Expr, continuity: sp.Expr, bias: sp.Expr) -> Basis:
    basis = _segment(
        _outgoing(tension, continuity, bias, *_POINTS[:3]),
        _incoming(tension, continuity, bias, *_POINTS[1:]),
        "Kochanek-Bartels basis with "
        f"tension {tension}, continuity {continuity} and bias {bias}",
    )  # fmt: skip
    parameters = (tension, continuity, bias)
    return replace(basis, derive=partial(_derivation, derive=basis.derive, parameters=parameters))


def _segment(start: sp.Expr, end: sp.Expr, name: str) -> Basis:
    # Tension 1 leaves P0 and P3 without influence; they are entries of G nevertheless.
    conditions = (value(0), value(1), derivative(0), derivative(1))
    return basis_of(conditions, (_POINTS[1], _POINTS[2], start, end), _POINTS, name)


def _outgoing(t: sp.Expr, c: sp.Expr, b: sp.Expr, before: Any, at: Any, after: Any) -> sp.Expr:
    """Return the paper's DD, the tangent with which a segment leaves a point."""
    return (1 - t) / 2 * ((1 + b) * (1 + c) * (at - before) + (1 - b) * (1 - c) * (after - at))


def _incoming(t: sp.Expr, c: sp.Expr, b: sp.Expr, before: Any, at: Any, after: Any) -> sp.Expr:
    """Return the paper's DS, the tangent with which a segment arrives at a point."""
    return (1 - t) / 2 * ((1 + b) * (1 - c) * (at - before) + (1 - b) * (1 + c) * (after - at))


def _derivation(
    basis: Basis, derive: Any, parameters: tuple[sp.Expr, sp.Expr, sp.Expr]
) -> Derivation:
    """Return the constraints' derivation, and what the tangents at a joint differ by."""
    tension, continuity, bias = parameters
    before, at, after, _ = _POINTS
    derivation: Derivation = derive(basis)
    outgoing = _outgoing(*parameters, before, at, after)
    difference = plus(outgoing, times(-1, _incoming(*parameters, before, at, after)))
    factored = (1 - tension) * continuity * ((1 + bias) * (at - before) - (1 - bias) * (after - at))
    because = (
        "at the joint P1 the outgoing tangent less the incoming one: zero for all points just if "
        "continuity = 0 or tension = 1, then the curve is C^1"
    )
    return replace(derivation, steps=(*derivation.steps, Step(difference, factored, because)))


def _parameter(given: Any) -> sp.Expr:
    expression = by_name(exact(given))
    refuse_clash([expression], _POINTS)
    return parameter_from(expression)

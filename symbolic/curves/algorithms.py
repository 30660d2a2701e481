"""Why the algorithms on Bezier curves are right, as derivations for any given degree."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from ..bases.bezier import bernstein, bezier
from ..dag import substitute
from ..exact import PARAMETER, exact
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .de_casteljau import subdivide
from .degree import elevate_degree
from .hodograph import hodograph
from .properties import bezier_curve

t = PARAMETER


def bezier_algorithms(n: int) -> dict[str, Derivation]:
    """Return why the algorithms on Bezier curves of degree n >= 1 are right, by name.

    The hodograph, the derivatives from de Casteljau's scheme, subdivision, degree elevation, and
    the integral.

    Raises
    ------
    BadValue
        If n is not a positive integer.

    Examples
    --------
    >>> derivations = bezier_algorithms(2)
    >>> list(derivations)[:3]
    ['hodograph', 'derivatives from the scheme', 'subdivision']
    >>> all(derivation.is_proved for derivation in derivations.values())
    True
    """
    degree = bezier(n).degree
    return {name: derive(degree) for name, derive in ALGORITHMS.items()}


def subdivision_matrices(n: int, u: Any) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """Return S_L and S_R: the control points of the parts [0, u] and [u, 1] are S_L P and S_R P.

    Row i of S_L holds B_0^i(u), ..., B_i^i(u); row i of S_R holds B_0^{n-i}(u), ... from column i.

    Raises
    ------
    BadValue, BadType, NotExact
        If n is not a positive integer, or u cannot be read exactly.

    Examples
    --------
    >>> subdivision_matrices(2, sp.Rational(1, 2))[0]
    Matrix([
    [  1,   0,   0],
    [1/2, 1/2,   0],
    [1/4, 1/2, 1/4]])
    """
    size = bezier(n).degree + 1
    rows = [substitute(bernstein(i), {t: exact(u)}) for i in range(size)]
    left = [[*row, *[sp.S.Zero] * (size - len(row))] for row in rows]
    right = [[*[sp.S.Zero] * (size - len(row)), *row] for row in reversed(rows)]
    return sp.ImmutableMatrix(left), sp.ImmutableMatrix(right)


def _hodograph(n: int) -> Derivation:
    points, lower = _points(n), bernstein(n - 1)
    curve = bezier_curve(n, points)
    legs = [row[0] for row in hodograph([[p] for p in points])]
    steps = []
    for i, weight in enumerate(bernstein(n)):
        terms = [*lower[max(i - 1, 0) : i], *(-w for w in lower[i : i + 1])]
        slope = times(n, plus(*terms))
        steps.append(Step(sp.Derivative(weight, t), slope, f"weight {i}: the product rule, with "
                          f"i C({n}, i) = {n} C({n - 1}, i - 1)"))  # fmt: skip
    because = f"collected by the weights of degree {n - 1}: {n} times the legs of the polygon"
    steps.append(Step(sp.Derivative(curve, t), bezier_curve(n - 1, legs), because))
    return Derivation(f"The hodograph of a Bezier curve of degree {n}", tuple(steps), _FARIN)


def _derivatives_from_the_scheme(n: int) -> Derivation:
    """c'(t) = n (b_1^{n-1} - b_0^{n-1}), c''(t) = n (n-1)(b_2^{n-2} - 2 b_1^{n-2} + b_0^{n-2})."""
    points = _points(n)
    curve = bezier_curve(n, points)

    def b(i: int, r: int) -> sp.Expr:
        return bezier_curve(r, points[i : i + r + 1])

    steps = [Step(sp.Derivative(curve, t), n * (b(1, n - 1) - b(0, n - 1)),
                  f"{n} times the chord between the two points before the last")]  # fmt: skip
    if n > 1:
        second = n * (n - 1) * (b(2, n - 2) - 2 * b(1, n - 2) + b(0, n - 2))
        because = f"{n} times {n - 1} times a second difference, two levels before the last"
        steps.append(Step(sp.Derivative(curve, (t, 2)), second, because))
    return Derivation(f"Derivatives from de Casteljau's scheme, degree {n}", tuple(steps), _FARIN)


def _subdivision(n: int) -> Derivation:
    u, points = sp.Symbol("u"), _points(n)
    curve, column = bezier_curve(n, points), sp.ImmutableMatrix(points)
    steps = []
    names = (("S_L", u * t, "[0, u]"), ("S_R", u + (1 - u) * t, "[u, 1]"))
    parts = zip(subdivision_matrices(n, u), subdivide([[p] for p in points], u), names, strict=True)
    for matrix, part, (name, along, interval) in parts:
        rows = [row[0] for row in part]
        steps += [
            Step(times(matrix, column), sp.ImmutableMatrix(rows),
                 f"{name} P is an outer edge of de Casteljau's triangle at u"),
            Step(matrix * sp.ones(n + 1, 1), sp.ones(n + 1, 1), f"every row of {name} sums to one"),
            Step(bezier_curve(n, rows), substitute([curve], {t: along})[0],
                 f"these points give the curve over {interval}"),
        ]  # fmt: skip
    return Derivation(f"Subdivision of a Bezier curve of degree {n}", tuple(steps), _FARIN)


def _degree_elevation(n: int) -> Derivation:
    points, higher = _points(n), bernstein(n + 1)
    raised = [row[0] for row in elevate_degree([[p] for p in points])]
    steps = []
    for i, weight in enumerate(bernstein(n)):
        share = sp.Rational(n + 1 - i, n + 1)
        rest = sp.Rational(i + 1, n + 1)
        steps.append(Step(times(1 - t, weight), times(share, higher[i]), f"weight {i} times 1 - t"))
        steps.append(Step(times(t, weight), times(rest, higher[i + 1]), f"weight {i} times t"))
    steps.append(Step(bezier_curve(n, points), bezier_curve(n + 1, raised),
                      "(1 - t) + t = 1 times the curve has these points"))  # fmt: skip
    return Derivation(f"Degree elevation from {n} to {n + 1}", tuple(steps), _FARIN)


def _integral(n: int) -> Derivation:
    points = _points(n)
    area = sp.Rational(1, n + 1)
    return Derivation(
        f"The integral of a Bezier curve of degree {n}",
        (
            *(Step(sp.Integral(weight, (t, 0, 1)), area, f"weight {i}: all areas are equal")
              for i, weight in enumerate(bernstein(n))),
            Step(sp.Integral(bezier_curve(n, points), (t, 0, 1)), area * plus(*points),
                 "the integral over [0, 1] is the mean of the control points"),
        ),
        _FARIN,
    )  # fmt: skip


ALGORITHMS: dict[str, Callable[[int], Derivation]] = {
    "hodograph": _hodograph,
    "derivatives from the scheme": _derivatives_from_the_scheme,
    "subdivision": _subdivision,
    "degree elevation": _degree_elevation,
    "integral": _integral,
}

_FARIN = "Farin, Curves and Surfaces for CAGD, chapters 4 to 6"


def _points(n: int) -> tuple[sp.Symbol, ...]:
    return tuple(sp.symbols(f"P0:{n + 1}"))

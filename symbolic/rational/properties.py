"""What weights do, as derivations for any given degree."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from ..bases.bezier import bernstein
from ..errors import BadValue, shown
from ..exact import PARAMETER, whole_number
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .without_weights import no_polynomial_circle, polynomial_conics

t = PARAMETER


def rational_properties(n: int) -> dict[str, Derivation]:
    """Return the derivations of all properties below for degree n >= 1, by name.

    Raises
    ------
    BadValue
        If n is not a positive integer.

    Examples
    --------
    >>> properties = rational_properties(2)
    >>> list(properties)[:3]
    ['equal weights', 'rational de Casteljau', 'weight attraction']
    >>> all(derivation.is_proved for derivation in properties.values())
    True
    """
    degree = whole_number(n)
    if degree is None or degree < 1:
        raise BadValue("a degree 1, 2, 3, ...", shown(n), "Two control points are the fewest.")
    return {name: derive(degree) for name, derive in PROPERTIES.items()}


def equal_weights(n: int = 2) -> Derivation:
    """Return the derivation that equal weights give the polynomial Bezier curve.

    >>> equal_weights(3).is_proved
    True
    """
    functions, points, w = bernstein(n), _points(n), sp.Symbol("w")
    denominator = plus(*(w * b for b in functions))
    numerator = sp.Add(*(w * p * b for p, b in zip(points, functions, strict=True)))
    return Derivation(
        "Equal weights",
        (
            Step(denominator, w, "the Bernstein polynomials sum to one"),
            Step(numerator / denominator, _sum(points, functions), "the weight w cancels"),
        ),
        "Piegl and Tiller, The NURBS Book, section 1.4",
    )


def rational_de_casteljau(n: int = 2) -> Derivation:
    r"""Return the rational de Casteljau algorithm as steps: weights and points, level by level.

    w_0^r = (1 - t) w_0^{r-1} + t w_1^{r-1}, and b_0^r is the mean of b_0^{r-1} and b_1^{r-1} with
    the weights (1 - t) w_0^{r-1} and t w_1^{r-1} (Farin 1983).

    >>> rational_de_casteljau().is_proved
    True
    """
    points, weights = _points(n), _weights(n)
    lifted = [w * p for w, p in zip(weights, points, strict=True)]
    steps = []
    for r in range(1, n + 1):
        w0, w1, w = (_sum(weights[i:], bernstein(k)) for i, k in ((0, r - 1), (1, r - 1), (0, r)))
        h0, h1, h = (_sum(lifted[i:], bernstein(k)) for i, k in ((0, r - 1), (1, r - 1), (0, r)))
        mean = (1 - t) * w0 / w * (h0 / w0) + t * w1 / w * (h1 / w1)
        if r > 1:
            blend = sp.Add(times(1 - t, w0), times(t, w1))
            steps.append(Step(blend, w, f"level {r}: the weight, by de Casteljau for numbers"))
        steps.append(
            Step(mean, h / w, f"level {r}: the mean of two points of level {r - 1}; its "
                 "coefficients (1 - t) w_0/w and t w_1/w sum to one")
        )  # fmt: skip
    return Derivation("The rational de Casteljau algorithm", tuple(steps), "Farin 1983")


def weight_attraction(n: int = 2, i: int = 1) -> Derivation:
    r"""Return the derivation that a larger weight moves the curve straight towards its point.

    dc/dw_i = B_i/W (p_i - c), with W the sum of w_j B_j; and for a change of any size h,
    c(w_i + h) - c = h B_i/(W + h B_i) (p_i - c).

    >>> weight_attraction(2, 1).is_proved
    True
    """
    functions, points, weights = bernstein(n), _points(n), _weights(n)
    place = whole_number(i)
    if place is None or not 0 <= place <= n:
        raise BadValue(f"the index of a control point, 0 to {n}", shown(i), "Choose one of these.")
    w, b, p, h = weights[place], functions[place], points[place], sp.Symbol("h")
    denominator = _sum(weights, functions)
    numerator = _sum([v * q for v, q in zip(weights, points, strict=True)], functions)
    rest, others = sp.symbols("N W")  # what has no w_i in it; the proof does not depend on it
    below = others + w * b
    c, more = (rest + w * b * p) / below, (rest + (w + h) * b * p) / (below + h * b)
    name, point = f"w{place}", f"P{place}"
    return Derivation(
        f"The weight {name} attracts the curve",
        (
            Step(sp.Derivative(numerator, w), b * p, f"only one term of the numerator has {name}"),
            Step(sp.Derivative(denominator, w), b, f"and only one of the denominator has {name}"),
            Step(sp.Derivative(c, w), b / below * (p - c),
                 f"the quotient rule, N and W being the terms without {name}: the velocity points "
                 f"from the curve to {point}"),
            Step(more - c, h * b / (below + h * b) * (p - c),
                 f"any change h of {name} moves the point along its line to {point}"),
        ),
        "Piegl and Tiller, The NURBS Book, chapter 4",
    )  # fmt: skip


def reparametrization(n: int = 2) -> Derivation:
    r"""Return the derivation that the weights c^i w_i give the same curve.

    With s = c t/(1 - t + c t), B_i^n(s) = c^i B_i^n(t)/(1 - t + c t)^n: a common factor.

    >>> reparametrization(2).is_proved
    True
    """
    functions, c = bernstein(n), sp.Symbol("c")
    moved = c * t / (1 - t + c * t)
    factor = (1 - t + c * t) ** n
    steps = [
        Step(sp.Subs(b, t, moved), c**i * b / factor, f"B_{i} at c t/(1 - t + c t)")
        for i, b in enumerate(functions)
    ]
    denominator = _sum(_weights(n), functions)
    scaled = _sum([c**i * w for i, w in enumerate(_weights(n))], functions)
    steps.append(
        Step(sp.Subs(denominator, t, moved), scaled / factor,
             f"the denominator has the weights c^i w_i, over (1 - t + c t)^{n}; so has the "
             "numerator, and the factor cancels")
    )  # fmt: skip
    title = "Weights in geometric progression do not change the curve"
    return Derivation(title, tuple(steps), "Farin, Curves and Surfaces for CAGD, chapter 13")


def projective_invariance(n: int = 2) -> Derivation:
    """Return the derivation that a projective map of the control points maps a plane curve.

    The 3x3 matrix acts on homogeneous rows (w x, w y, w), so weights change as well.

    >>> projective_invariance(2).is_proved
    True
    """
    functions = sp.ImmutableMatrix([bernstein(n)])
    names = [f"{letter}{i}" for i in range(n + 1) for letter in ("X", "Y", "w")]
    rows = sp.ImmutableMatrix(n + 1, 3, list(map(sp.Symbol, names)))
    m = sp.ImmutableMatrix(3, 3, [sp.Symbol(f"m{i}{j}") for i in range(3) for j in range(3)])
    point = sp.symbols("X Y W")
    image = [sp.Add(*(m[i, j] * point[j] for j in range(3))) for i in range(3)]
    x, y = (point[0] / point[2], point[1] / point[2])
    below = m[2, 0] * x + m[2, 1] * y + m[2, 2]
    mapped = [(m[i, 0] * x + m[i, 1] * y + m[i, 2]) / below for i in range(2)]
    return Derivation(
        "Projective invariance",
        (
            Step(times(functions, rows * m.T),
                 times(functions * rows, m.T),
                 "in homogeneous coordinates the map is linear: mapping the control points maps "
                 "(X, Y, W), the sums with Bernstein polynomials"),
            Step([image[0] / image[2], image[1] / image[2]], mapped,
                 "the image of (X, Y, W), projected, is the projective map of (X/W, Y/W)"),
        ),
        "Farin, Curves and Surfaces for CAGD, chapter 13",
    )  # fmt: skip


PROPERTIES: dict[str, Callable[[int], Derivation]] = {
    "equal weights": equal_weights,
    "rational de Casteljau": rational_de_casteljau,
    "weight attraction": weight_attraction,
    "reparametrization": reparametrization,
    "projective invariance": projective_invariance,
    "no polynomial circle": no_polynomial_circle,
    "polynomial conics": polynomial_conics,
}
"""What rational curves of every degree satisfy, and polynomial ones cannot."""


def _sum(values: Any, functions: tuple[sp.Expr, ...]) -> sp.Expr:
    return sp.Add(*(v * b for v, b in zip(values, functions, strict=False)))


def _points(n: int) -> tuple[sp.Symbol, ...]:
    return sp.symbols(f"P0:{n + 1}")


def _weights(n: int) -> tuple[sp.Symbol, ...]:
    return sp.symbols(f"w0:{n + 1}")

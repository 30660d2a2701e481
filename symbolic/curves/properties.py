"""The properties of Bezier curves as statements that are proved, for any given degree."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from ..bases.bezier import bernstein
from ..bases.degree import degree_from
from ..exact import PARAMETER
from ..proofs.derivation import Derivation, Step
from ..written import plus, times

t = PARAMETER
_SOURCE = "Farin, Curves and Surfaces for CAGD, chapters 4 and 5"


def bezier_properties(n: int) -> dict[str, Derivation]:
    """Return the properties of Bezier curves of degree n >= 1, each with its proof, by name.

    Partition of unity, end points, symmetry, affine invariance, barycentric combinations, parameter
    transformation, linear precision, pseudo-local maximum (weight i is largest at i/n), and
    non-negativity, whence the convex hull.

    Raises
    ------
    BadValue
        If n is not a positive integer.

    Examples
    --------
    >>> properties = bezier_properties(3)
    >>> list(properties)[:3]
    ['partition of unity', 'end points', 'symmetry']
    >>> all(derivation.is_proved for derivation in properties.values())
    True
    """
    degree = degree_from(n, 1)
    return {name: derive(degree) for name, derive in PROPERTIES.items()}


def partition_of_unity(n: int) -> Derivation:
    """Return the proof that the Bernstein polynomials sum to one: ((1 - t) + t)^n = 1.

    >>> print(partition_of_unity(1).steps[1])
    t + (1 - t) = 1, because the two terms cancel
    """
    total = plus(*_weights(n))
    binomial = sp.Pow(plus(1 - t, t), n, evaluate=False)
    return Derivation(
        f"Partition of unity, degree {n}",
        (
            Step(binomial, total, "the binomial theorem"),
            Step(binomial.base, sp.S.One, "the two terms cancel"),
            Step(total, sp.S.One, "one to any power is one"),
        ),
        _SOURCE,
    )


def end_points(n: int) -> Derivation:
    """Return the proof that the curve begins at P0 and ends at Pn.

    >>> end_points(2).is_proved
    True
    """
    points = _points(n)
    curve = _curve(_weights(n), points)
    return Derivation(
        f"End point interpolation, degree {n}",
        (
            Step(sp.Subs(curve, t, 0), points[0], "at t = 0 all weights but the first vanish"),
            Step(sp.Subs(curve, t, 1), points[n], "at t = 1 all weights but the last vanish"),
        ),
        _SOURCE,
    )


def symmetry(n: int) -> Derivation:
    """Return the proof that reversed control points give the curve run through backwards.

    >>> symmetry(2).is_proved
    True
    """
    weights, points = _weights(n), _points(n)
    mirrored = [sp.Subs(weight, t, 1 - t) for weight in weights]
    return Derivation(
        f"Symmetry, degree {n}",
        (
            *(Step(mirrored[n - i], weights[i], f"weight {i} at t is weight {n - i} at 1 - t")
              for i in range(n + 1)),
            Step(sp.Subs(_curve(weights, points), t, 1 - t), _curve(weights, points[::-1]),
                 "the reversed control points give the same curve, from the other end"),
        ), _SOURCE,
    )  # fmt: skip


def affine_invariance(n: int) -> Derivation:
    """Return the proof that mapping the control points by A x + d maps the curve by A x + d.

    One row of the map is enough, the others are alike: x, y goes to a x + b y + d.

    >>> affine_invariance(2).is_proved
    True
    """
    weights = _weights(n)
    a, b, d = sp.symbols("a b d")
    x, y = sp.symbols(f"x0:{n + 1}"), sp.symbols(f"y0:{n + 1}")
    mapped = [a * p + b * q + d for p, q in zip(x, y, strict=True)]
    total = plus(*weights)
    return Derivation(
        f"Affine invariance, degree {n}",
        (
            Step(_curve(weights, mapped),
                 a * _curve(weights, x) + b * _curve(weights, y) + d * total,
                 "sums and factors move out of a sum of weighted points"),
            Step(total, sp.S.One, "the weights sum to one"),
            Step(_curve(weights, mapped), a * _curve(weights, x) + b * _curve(weights, y) + d,
                 "the curve of the mapped points is the mapped curve"),
        ), _SOURCE,
    )  # fmt: skip


def barycentric_combinations(n: int) -> Derivation:
    """Return the proof that blending two control polygons blends their curves.

    >>> barycentric_combinations(2).is_proved
    True
    """
    weights, a = _weights(n), sp.Symbol("a")
    p, q = _points(n), sp.symbols(f"Q0:{n + 1}")
    blended = [a * x + (1 - a) * y for x, y in zip(p, q, strict=True)]
    because = "sums and factors move out of a sum of weighted points"
    return Derivation(
        f"Barycentric combinations, degree {n}",
        (Step(_curve(weights, blended), a * _curve(weights, p) + (1 - a) * _curve(weights, q),
              because),), _SOURCE,
    )  # fmt: skip


def parameter_transformation(n: int) -> Derivation:
    """Return the proof that the same control points over any interval [r, s] give the same curve.

    >>> parameter_transformation(2).is_proved
    True
    """
    r, s = sp.symbols("r s")
    along = r + (s - r) * t
    steps = [
        Step(sp.Subs((t - r) / (s - r), t, along), t, "the share of [r, s] before r + (s - r) t"),
        Step(sp.Subs((s - t) / (s - r), t, along), 1 - t, "the share of [r, s] after it"),
    ]
    for i, weight in enumerate(_weights(n)):
        over = sp.binomial(n, i) * (t - r) ** i * (s - t) ** (n - i) / (s - r) ** n
        steps.append(
            Step(
                sp.Subs(over, t, along),
                weight,
                f"weight {i} over [r, s] at r + (s - r) t is that over [0, 1] at t",
            )
        )
    return Derivation(
        f"Invariance under affine parameter transformations, degree {n}", tuple(steps), _SOURCE
    )  # fmt: skip


def linear_precision(n: int) -> Derivation:
    """Return the proof that equally spaced points on a line give the line, at constant speed.

    >>> linear_precision(3).is_proved
    True
    """
    weights, lower = _weights(n), bernstein(n - 1)
    terms = [times(sp.Rational(i, n), weights[i]) for i in range(1, n + 1)]
    p, q = sp.symbols("P Q")
    spaced = [p + sp.Rational(i, n) * (q - p) for i in range(n + 1)]
    return Derivation(
        f"Linear precision, degree {n}",
        (
            *(Step(term, times(t, w), f"{i}/{n} C({n}, {i}) = C({n - 1}, {i - 1})")
              for i, (term, w) in enumerate(zip(terms, lower, strict=True), 1)),
            Step(plus(*terms), t, "t times the weights of one degree less, which sum to one"),
            Step(_curve(weights, spaced), p + t * (q - p),
                 "equally spaced points from P to Q give the segment from P to Q"),
        ), _SOURCE,
    )  # fmt: skip


def pseudo_local_maximum(n: int) -> Derivation:
    """Return the proof that weight i is largest at t = i/n, among all t in [0, 1].

    The derivative is a product whose other factors are not negative on [0, 1], so its sign is that
    of i - n t: the weight rises up to i/n and falls from there on.

    >>> pseudo_local_maximum(3).is_proved
    True
    """
    steps = []
    for i, weight in enumerate(_weights(n)):
        if i == 0:
            slope = -n * (1 - t) ** (n - 1)
            because = "not positive on [0, 1]: it falls from its maximum at 0"
        elif i == n:
            slope = n * t ** (n - 1)
            because = "not negative on [0, 1]: it rises to its maximum at 1"
        else:
            slope = sp.binomial(n, i) * t ** (i - 1) * (1 - t) ** (n - i - 1) * (i - n * t)
            because = (
                f"its sign on [0, 1] is that of {i} - {n} t: it rises up to {i}/{n}, then falls"
            )
        steps.append(Step(sp.Derivative(weight, t), slope, because))
        largest = sp.Rational(i**i * (n - i) ** (n - i), n**n) * sp.binomial(n, i)
        steps.append(Step(sp.Subs(weight, t, sp.Rational(i, n)), largest, f"its value at {i}/{n}"))
    return Derivation(f"Weight i is largest at i/n, degree {n}", tuple(steps), _SOURCE)


def non_negativity(n: int) -> Derivation:
    """Return the proof that no weight is negative on [0, 1], whence the convex hull property.

    For u >= 0 the parameter t = u/(1 + u) runs over [0, 1), and the weights there are quotients
    without any minus sign; at t = 1 they are 0 or 1.

    >>> non_negativity(2).is_proved
    True
    """
    u = sp.Symbol("u")
    steps = []
    for i, weight in enumerate(_weights(n)):
        steps.append(
            Step(sp.Subs(weight, t, u / (1 + u)), sp.binomial(n, i) * u**i / (1 + u) ** n,
                 f"weight {i} at t = u/(1 + u): no minus sign is left, so it is not negative")
        )  # fmt: skip
        steps.append(Step(sp.Subs(weight, t, 1), sp.Integer(int(i == n)), f"weight {i} at t = 1"))
    return Derivation(f"Weights are not negative on [0, 1], degree {n}", tuple(steps), _SOURCE)


PROPERTIES: dict[str, Callable[[int], Derivation]] = {
    "partition of unity": partition_of_unity,
    "end points": end_points,
    "symmetry": symmetry,
    "affine invariance": affine_invariance,
    "barycentric combinations": barycentric_combinations,
    "parameter transformation": parameter_transformation,
    "linear precision": linear_precision,
    "pseudo-local maximum": pseudo_local_maximum,
    "non-negativity": non_negativity,
}


def _weights(n: int) -> tuple[sp.Expr, ...]:
    return bernstein(degree_from(n, 1))


def _points(n: int) -> tuple[sp.Symbol, ...]:
    return tuple(sp.symbols(f"P0:{n + 1}"))


def bezier_curve(n: int, points: Sequence[sp.Expr]) -> sp.Expr:
    """Return one coordinate of a Bezier curve as the sum of its points, each times its weight.

    >>> bezier_curve(1, sp.symbols("p q"))
    p*(1 - t) + q*t
    """
    return _curve(bernstein(n), points)


def _curve(weights: Sequence[sp.Expr], points: Sequence[sp.Expr]) -> sp.Expr:
    return sp.Add(*(w * p for w, p in zip(weights, points, strict=True)))

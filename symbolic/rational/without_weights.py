"""What polynomial curves cannot be: circles, ellipses and hyperbolas."""

from __future__ import annotations

import sympy as sp

from ..bases.bezier import bernstein
from ..exact import PARAMETER
from ..proofs.derivation import Derivation, Step

t = PARAMETER


def no_polynomial_circle(n: int = 3) -> Derivation:
    """Return the derivation that no polynomial curve of degree n runs on a circle.

    x(t)^2 + y(t)^2 = 1 with real coefficients makes the leading ones zero, one after the other.

    >>> no_polynomial_circle(2).is_proved
    True
    """
    a, b = sp.symbols(f"a0:{n + 1}"), sp.symbols(f"b0:{n + 1}")
    steps = [
        Step(_leading(_polynomial(a, k) ** 2 + _polynomial(b, k) ** 2, 2 * k),
             a[k] ** 2 + b[k] ** 2,
             f"the coefficient of t^{2 * k} in x^2 + y^2. In 1 it is 0; the sum of two real "
             f"squares is 0 only for a{k} = b{k} = 0")
        for k in range(n, 0, -1)
    ]  # fmt: skip
    steps.append(
        Step(sp.Subs(_polynomial(a, 1), a[1], 0), a[0],
             "x is constant, and so is y: the curve is one point, and no arc")
    )  # fmt: skip
    title = f"No polynomial curve of degree {n} is a circular arc"
    return Derivation(title, tuple(steps), "Piegl and Tiller, The NURBS Book, section 1.4")


def polynomial_conics(n: int = 2) -> Derivation:
    """Return the derivation which conics are polynomial curves: the parabola, and no other.

    Books that count the parabola among those that need weights are wrong: y = x^2 is the curve
    with the control points (0, 0), (1/2, 0), (1, 1).

    >>> polynomial_conics().is_proved
    True
    """
    a, b = sp.symbols(f"a0:{n + 1}"), sp.symbols(f"b0:{n + 1}")
    x, y, r, s = sp.symbols("x y r s")
    functions = bernstein(2)
    half = sp.Rational(1, 2)
    return Derivation(
        "Which conics are polynomial curves",
        (
            Step(functions[2], sp.Pow(half * functions[1] + functions[2], 2),
                 "the parabola is one: y = x^2 for the control points (0, 0), (1/2, 0), (1, 1)"),
            Step(_leading((_polynomial(a, n) / r) ** 2 + (_polynomial(b, n) / s) ** 2, 2 * n),
                 (a[n] / r) ** 2 + (b[n] / s) ** 2,
                 f"the ellipse (x/r)^2 + (y/s)^2 = 1 of real half-axes is none: the coefficient of "
                 f"t^{2 * n} would have to be 0, so a{n} = b{n} = 0, down to constants"),
            Step((x / r) ** 2 - (y / s) ** 2, (x / r - y / s) * (x / r + y / s),
                 "the hyperbola is none: two polynomials with the product 1"),
            *(Step(_leading(_polynomial(a, n) * _polynomial(b, m), n + m), a[n] * b[m],
                   f"factors of degrees {n} and {m} have the coefficient a{n} b{m} of t^{n + m}, "
                   "which is not 0; in 1 it is. So the degrees are 0, and the curve a point")
              for m in range(n + 1)),
        ),
        "Piegl and Tiller, The NURBS Book, section 1.4",
    )  # fmt: skip


def _leading(polynomial: sp.Expr, k: int) -> sp.Expr:
    """Return the coefficient of t^k as what it is: the derivative at 0, divided by k!."""
    return sp.Subs(sp.Derivative(polynomial, (t, k)), t, 0) / sp.factorial(k)


def _polynomial(coefficients: tuple[sp.Symbol, ...], n: int) -> sp.Expr:
    return sp.Add(*(c * t**k for k, c in enumerate(coefficients[: n + 1])))

"""Why a curve satisfies its implicit equation, step by step."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations

import sympy as sp

from ..exact import PARAMETER
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .bezout import bezout_matrix
from .homogeneous import quotient

_OTHER = sp.Symbol("s")
_LARGEST_DETERMINANT = 3  # written out; beyond that it has 24 terms


def derive(
    equation: sp.Expr, symbols: tuple[sp.Symbol, sp.Symbol], parts: Sequence[sp.Expr], n: int
) -> Derivation:
    """Return the derivation of the equation of the curve (X/W, Y/W), for parts X, Y, W."""
    t, s = PARAMETER, sp.Dummy("s") if _OTHER in equation.free_symbols else _OTHER
    x, y = symbols
    big_x, big_y, w = parts
    f, g = x * w - big_x, y * w - big_y
    rows = sp.ImmutableMatrix(
        bezout_matrix(
            [[_coefficient(p, k) for k in range(n + 1)] for p in parts],
            lambda e: sp.expand(e[0] * x + e[1] * y + e[2]),
        )
    )
    powers = [sp.ImmutableMatrix([[u**k for k in range(n)]]) for u in (t, s)]
    cayley = times(sp.ImmutableMatrix([[t - s]]), powers[0], rows, powers[1].T)
    crossed = f * g.subs(t, s) - f.subs(t, s) * g
    steps = [Step(sp.ImmutableMatrix([[crossed]]), cayley,
                  "Bezout's matrix, without its factor t - s: where x W - X and y W - Y have a "
                  "common root t, the row of powers of t times the matrix is zero")]  # fmt: skip
    if 1 < n <= _LARGEST_DETERMINANT:
        steps.append(_determinant_step(rows, equation, symbols))
    steps.append(_substitution(equation, symbols, parts))
    source = "Sederberg, Anderson and Goldman 1984; the matrix in Cayley's form"
    return Derivation(f"From the parameter to the equation {equation} = 0", tuple(steps), source)


def _coefficient(part: sp.Expr, k: int) -> sp.Expr:
    return sp.Poly(part, PARAMETER).coeff_monomial(PARAMETER**k)


def _determinant_step(
    rows: sp.ImmutableMatrix, equation: sp.Expr, symbols: tuple[sp.Symbol, sp.Symbol]
) -> Step:
    n = rows.rows
    signed = [(sp.LeviCivita(*order), order) for order in permutations(range(n))]
    products = [s * sp.Mul(*(rows[i, j] for i, j in enumerate(order))) for s, order in signed]
    products = [product for product in products if product != 0]
    f, whole = (sp.Poly(e, *symbols) for e in (equation, sp.Add(*products)))
    power = n // f.total_degree()
    factor = quotient(whole.LC(), f.LC() ** power)
    return Step(
        plus(*products),
        equation**power if factor == 1 else times(factor, equation**power),
        "its determinant" + (", a power: the curve is traced more than once" if power > 1 else ""),
    )


def _substitution(
    equation: sp.Expr, symbols: tuple[sp.Symbol, sp.Symbol], parts: Sequence[sp.Expr]
) -> Step:
    """The homogeneous equation at X, Y, W: the equation times a power of W."""
    polynomial = sp.Poly(equation, *symbols)
    degree, (x, y, w) = polynomial.total_degree(), parts
    terms = [c * x**i * y**j * w ** (degree - i - j) for (i, j), c in polynomial.terms()]
    times = "" if w == 1 else f", times W^{degree}"
    because = f"x = X/W and y = Y/W put in{times}: every point of the curve satisfies the equation"
    return Step(plus(*terms), sp.S.Zero, because)

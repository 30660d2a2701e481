"""The implicit equation of a plane rational curve: a resultant, with the parameter eliminated."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property, reduce
from math import comb
from typing import Any

import sympy as sp
from sympy.polys.densearith import dup_mul_ground, dup_sub
from sympy.polys.densetools import dup_eval
from sympy.polys.domains.domain import Domain
from sympy.polys.euclidtools import dup_gcd
from sympy.polys.factortools import dup_factor_list
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER
from ..polynomials import Coefficients, expression, polynomials
from ..proofs.derivation import Derivation
from .arcs import plane_point
from .bezout import bezout_matrix, determinant
from .common_denominator import over_one_denominator, with_numbers
from .homogeneous import decidable_field
from .implicit_derivation import derive

HIGHEST_DEGREE = 16  # a few seconds
HIGHEST_DEGREE_WITH_SYMBOLS = 10
_MOST_POWERS = 2000  # products of n symbols: those of the general quartic, but not of the quintic
_X, _Y = sp.symbols("x y")


@dataclass(frozen=True, repr=False)
class ImplicitCurve:
    """A plane curve as the zeros of a polynomial, and how its parametrization runs over it.

    Attributes
    ----------
    polynomial : Expr
        In `x` and `y`, without repeated factors; with integer coefficients without common divisor
        where the curve has rational ones.
    x, y : Symbol
    degree : int
        The degree of the polynomial.
    tracing_number : int
        How many parameters lead to a point in general: 1 for a proper parametrization. The degree
        of the parametrization is `degree * tracing_number`.
    parts : (X, Y, W)
        The curve (X/W, Y/W): polynomials in t without common factor.
    """

    polynomial: sp.Expr
    x: sp.Symbol
    y: sp.Symbol
    degree: int
    tracing_number: int
    parts: tuple[sp.Expr, ...] = field(compare=False)

    def __repr__(self) -> str:
        times = f", traced {self.tracing_number} times" if self.tracing_number > 1 else ""
        return f"<{self.polynomial} = 0{times}>"

    @cached_property
    def derivation(self) -> Derivation:
        """Bezout's matrix, and the proof that the curve satisfies the equation."""
        n = self.degree * self.tracing_number
        return derive(self.polynomial, (self.x, self.y), self.parts, n)

    def inversion(self, point: Any) -> tuple[sp.Expr, ...]:
        """Return all real parameters at which the curve runs through a point, in order.

        They are the common roots of x W - X and y W - Y: none if the curve misses the point,
        several at double points, oo if the point is the limit for t to infinity.

        Raises
        ------
        BadValue
            For points with symbols, and for parameters that are not in the field of the
            coefficients, if that is not the rational numbers.

        Examples
        --------
        >>> t = sp.Symbol("t")
        >>> circle = implicitize([(1 - t**2)/(1 + t**2), 2*t/(1 + t**2)])
        >>> circle.inversion([sp.Rational(3, 5), sp.Rational(4, 5)])
        (1/2,)
        >>> circle.inversion([-1, 0]), circle.inversion([0, 0])
        ((oo,), ())
        """
        row = plane_point(point)
        point_and_curve = (*row, *self.parts)
        if any(symbol != PARAMETER for e in point_and_curve for symbol in e.free_symbols):
            raise BadValue("a curve and a point without symbols", shown(row), "Put numbers in.")
        decidable_field(point_and_curve)
        domain, (*coordinates, p, q, w) = polynomials(point_and_curve, PARAMETER)
        x, y = (c[0] if c else domain.zero for c in coordinates)
        common, at_infinity = _common_root_form([p, q, w], x, y, domain)
        return (*_real_roots(common, domain), *([sp.oo] if at_infinity else []))


def implicitize(curve: Any, x: sp.Symbol = _X, y: sp.Symbol = _Y) -> ImplicitCurve:
    r"""Return the implicit equation f(x, y) = 0 of a plane polynomial or rational curve.

    For c = (X/W, Y/W) of degree n, without common factor of all three, the determinant of Bezout's
    matrix of x W - X and y W - Y is f to the power of the tracing number, up to a constant.

    Parameters
    ----------
    curve : two rational functions of t, or a plane RationalBezier
    x, y : Symbol
        The coordinates in the equation.

    Raises
    ------
    BadValue
        For curves not in the plane, a curve that is a point, symbols x and y that the curve
        contains, and equations with too many terms.

    Notes
    -----
    Sederberg, Anderson and Goldman, *Implicit representation of parametric curves and surfaces*,
    1984. It needs no Groebner basis, and degree 8 takes a fraction of a second.

    Examples
    --------
    >>> t = sp.Symbol("t")
    >>> implicitize([(1 - t**2)/(1 + t**2), 2*t/(1 + t**2)])
    <x**2 + y**2 - 1 = 0>
    >>> implicitize([t**2, t**4])
    <x**2 - y = 0, traced 2 times>
    """
    x, y = _coordinates(x, y)
    domain, forms = over_one_denominator(curve)
    if len(forms) != 3:
        raise BadValue(
            "a curve in the plane", f"{len(forms) - 1} coordinates", "Project it to a plane."
        )
    n = max(map(len, forms)) - 1
    if n < 1:
        raise BadValue("a curve", "one point", "Its coordinates should contain t.")
    _refuse_large(n, domain)
    if {x, y} & {s for p in forms for c in p for s in domain.to_sympy(c).free_symbols}:
        raise BadValue(
            f"a curve without the symbols {x} and {y}",
            "one that contains them",
            "Give implicitize(curve, x, y) other symbols.",
        )
    coefficients, whole = _without_denominators(forms, domain)
    ring = PolyRing([x, y], coefficients, lex)
    gx, gy = ring.gens
    ascending = [[coefficients.zero] * (n + 1 - len(p)) + p for p in whole]
    rows = bezout_matrix([p[::-1] for p in ascending], lambda e: gx * e[0] + gy * e[1] + e[2])
    f = determinant(rows, ring).set_ring(ring.clone(domain=domain))
    if not _is_proper(forms, domain):
        f = f.sqf_part()
    degree = max(sum(powers) for powers in f.monoms())
    polynomial = _primitive(f, domain).as_expr(x, y)
    parts = tuple(expression(p, domain, PARAMETER) for p in forms)
    return ImplicitCurve(polynomial, x, y, degree, n // degree, parts)


def _refuse_large(n: int, domain: Domain) -> None:
    symbols = len(domain.symbols) if domain.is_FractionField else 0
    highest = HIGHEST_DEGREE_WITH_SYMBOLS if symbols else HIGHEST_DEGREE
    if n > highest:
        raise BadValue(
            f"a curve of degree {highest} or less" + (" where it has symbols" if symbols else ""),
            f"degree {n}",
            "Beyond that the equation has hundreds of terms; reduce the degree first.",
        )
    if comb(n + symbols, n) > _MOST_POWERS:
        raise BadValue(
            f"fewer symbols in a curve of degree {n}",
            f"{symbols}",
            "The equation has many thousands of terms; put numbers in the place of symbols.",
        )


def _coordinates(x: Any, y: Any) -> tuple[sp.Symbol, sp.Symbol]:
    if not (isinstance(x, sp.Symbol) and isinstance(y, sp.Symbol)):
        raise BadType("two symbols", f"{shown(x)} and {shown(y)}", "Leave them out for x and y.")
    x, y = sp.Symbol(x.name), sp.Symbol(y.name)
    if x == y or PARAMETER in (x, y):
        raise BadValue("two symbols other than t", f"{x} and {y}", "Leave them out for x and y.")
    return x, y


def _without_denominators(
    forms: list[Coefficients], domain: Domain
) -> tuple[Domain, list[Coefficients]]:
    """Return the same curve's X, Y, W over polynomials in the symbols, if there are some."""
    if not domain.is_FractionField:
        return domain, forms
    ring = domain.get_ring()
    common = reduce(lambda a, b: a.lcm(b), (c.denom for p in forms for c in p))
    return ring, [[ring(c.numer * common.exquo(c.denom)) for c in p] for p in forms]


def _common_root_form(
    forms: list[Coefficients], x: Any, y: Any, domain: Domain
) -> tuple[Coefficients, int]:
    """Return the gcd of x W - X and y W - Y, and how often infinity is a common root."""
    p, q, w = forms
    f = dup_sub(dup_mul_ground(w, x, domain), p, domain)
    g = dup_sub(dup_mul_ground(w, y, domain), q, domain)
    return dup_gcd(f, g, domain), max(map(len, forms)) - max(len(f), len(g))


def _is_proper(forms: list[Coefficients], domain: Domain) -> bool:
    """Tell whether some point of the curve has one parameter only; then almost all have.

    The number of parameters of a point, counted with infinity and multiplicity, is the tracing
    number or larger; so one point with one parameter is a proof. With symbols one example is: it
    has Bezout's determinant, and so a power in it, from the general curve.
    """
    n = max(map(len, forms)) - 1
    for numbers, example in with_numbers(forms, domain):
        for s in map(numbers, range(2, 8)):
            x, y, w = (dup_eval(p, s, numbers) for p in example)
            if w and _parameters_of(example, x / w, y / w, n, numbers) == 1:
                return True
    return False


def _parameters_of(forms: list[Coefficients], x: Any, y: Any, n: int, domain: Domain) -> int:
    """Count the parameters of a point with multiplicity, infinity included, for formal degree n."""
    common, at_infinity = _common_root_form(forms, x, y, domain)
    return len(common) - 1 + at_infinity + n + 1 - max(map(len, forms))


def _primitive(f: Any, domain: Domain) -> Any:
    """Return f over the integers (or over polynomials in the symbols) without common divisor."""
    f = f.monic()
    if domain.is_Algebraic:
        numbers = {powers: domain.to_sympy(c) for powers, c in f.terms()}
        if not all(c.is_Rational for c in numbers.values()):
            return f
        domain = sp.QQ
        f = f.ring.clone(domain=domain).from_dict(
            {k: domain.from_sympy(c) for k, c in numbers.items()}
        )
    _, f = f.clear_denoms()
    whole = f.set_ring(f.ring.clone(domain=domain.get_ring()))
    return whole.primitive()[1]


def _real_roots(polynomial: Coefficients, domain: Domain) -> list[sp.Expr]:
    if domain.is_QQ:
        found = sp.Poly(polynomial, PARAMETER, domain=domain).real_roots() if polynomial[1:] else []
        return list(dict.fromkeys(found))
    _, factors = dup_factor_list(polynomial, domain)
    if any(len(factor) > 2 for factor, _ in factors):
        raise BadValue(
            f"parameters in {domain}",
            f"the roots of {expression(polynomial, domain, PARAMETER)}",
            "They are roots of this polynomial.",
        )
    roots = [domain.to_sympy(-b / a) for (a, b), _ in factors]
    return sorted(roots, key=lambda root: root.evalf(30))

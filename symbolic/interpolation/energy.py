"""Cubic splines accelerate least: the theorem, with both terms of the energy computed exactly."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import sympy as sp

from ..bases.hermite import hermite
from ..dag import substitute
from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER
from ..names import unused_letter
from ..proofs.derivation import Derivation, Step
from ..written import plus
from .cubic_spline import InterpolatingSpline, energy_of_span

t = PARAMETER
_SOURCE = "Holladay 1957; de Boor, A Practical Guide to Splines, chapter V"


def minimum_acceleration(spline: InterpolatingSpline) -> Derivation:
    r"""Return the proof that no C2 curve through the same points accelerates less.

    Let f = s + g be any other interpolant, so that g vanishes at the knots. On every span s'' is
    linear, and integrating s'' g'' by parts leaves only s'' g' at the ends of the span. Over all
    spans these terms cancel but for the two outermost, which the end conditions remove. Hence

        integral |f''|^2 = integral |s''|^2 + integral |g''|^2 >= integral |s''|^2.

    Here g is the general piecewise quintic of class C2 that vanishes at the knots, with slopes
    d0, d1, ... and second derivatives e0, e1, ... there (for clamped ends d0 = 0, ...; for
    periodic ones the last equal the first). The spans use nothing else about g.

    Parameters
    ----------
    spline : InterpolatingSpline
        With natural, clamped or periodic ends; one derivation covers all its coordinates.

    Raises
    ------
    BadValue
        For "not-a-knot" ends, which minimize nothing.
    BadType
        For anything but an interpolating spline.

    Notes
    -----
    Holladay, *A smoothest curve approximation*, 1957; de Boor, *A Practical Guide to Splines*, V.

    Examples
    --------
    >>> from symbolic import interpolating_spline
    >>> proof = minimum_acceleration(interpolating_spline([[0], [1], [0]]))
    >>> proof.is_proved
    True
    """
    if not isinstance(spline, InterpolatingSpline):
        raise BadType("an interpolating spline", shown(spline), "Make it by interpolating_spline.")
    if spline.ends == "not-a-knot":
        raise BadValue(
            "natural, clamped or periodic ends", "not-a-knot ends",
            "A spline with these minimizes nothing: others accelerate less.",
        )  # fmt: skip
    f, g = sp.symbols("s'' g''")
    because = "the energy of s + g is that of s, twice the integral of s'' g'', and that of g"
    steps = [Step((f + g) ** 2, f**2 + 2 * f * g + g**2, because)]
    for axis in range(len(spline.points[0])):
        steps.extend(_of_coordinate(spline, axis))
    return Derivation(f"The {spline.ends} cubic spline accelerates least", tuple(steps), _SOURCE)


def _of_coordinate(spline: InterpolatingSpline, axis: int) -> list[Step]:
    name = f"coordinate {axis + 1}: " if len(spline.points[0]) > 1 else ""
    given = [row[axis] for row in spline.accelerations]
    if spline.ends == "periodic":
        given[-1] = given[0]  # equal, though perhaps not written so
    d, e = _freedoms(spline)
    # What holds for all moments and gaps holds for these; with roots integrals would be unreadable.
    letters = [unused_letter(letters, (*d, *e, *_data(spline))) for letters in ("Mm", "hl")]
    moments = _named(given, letters[0])
    gaps = _named([b - a for a, b in pairwise(spline.knots)], letters[1])
    steps: list[Step] = []
    of_s, mixed, of_g = [], [], []
    for i, (piece, gap) in enumerate(zip(spline.pieces, gaps, strict=True)):
        of_s.append(energy_of_span(gap, moments[i], moments[i + 1]))
        mixed.append(moments[i + 1] * d[i + 1] - moments[i] * d[i])
        of_g.append(_energy_of_g(gap, d[i : i + 2], e[i : i + 2]))
        bend = _acceleration(gap, d[i : i + 2], e[i : i + 2])
        line = moments[i] + (moments[i + 1] - moments[i]) * t / gap
        actual = {moments[i]: given[i], moments[i + 1]: given[i + 1], gap: piece.end - piece.start}
        renamed = {x: value for x, value in actual.items() if x != value}
        (moved,) = substitute([line], {t: t - piece.start, **renamed})
        span = f"{name}span {i + 1}: "
        values = ", ".join(f"{x} = {value}" for x, value in renamed.items())
        steps += [
            Step(sp.Derivative(piece.coordinates[axis], (t, 2)), moved,
                 span + "s'' is linear" + (f"; from here on {values}" if values else "")),
            Step(_integral(line**2, gap), of_s[i],
                 span + "the energy of s; t is counted from the start of the span"),
            Step(_integral(line * bend, gap), mixed[i],
                 span + "by parts, of s'' g'' only s'' g' at both ends is left"),
            Step(_integral(bend**2, gap), of_g[i],
                 span + "the energy of g, the integral of a square and so not negative"),
        ]  # fmt: skip
    because = f"{name}over all spans the mixed terms cancel, by the {spline.ends} ends"
    steps.append(Step(plus(*mixed), sp.S.Zero, because))
    if not any(part.free_symbols for part in of_s):  # with symbols the sums would fill pages
        parts = [part for x, y, z in zip(of_s, mixed, of_g, strict=True) for part in (x, 2 * y, z)]
        because = f"{name}over all spans, the energy of s + g is that of s plus that of g: not less"
        steps.append(Step(plus(*parts), plus(sp.Add(*of_s), sp.Add(*of_g)), because))
    return steps


def _freedoms(spline: InterpolatingSpline) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Return slopes and second derivatives of g at the knots, as its end conditions leave them."""
    count, data = len(spline.knots), _data(spline)
    d, e = (
        list(sp.symbols(f"{unused_letter(letters, data)}0:{count}")) for letters in ("dv", "ew")
    )
    if spline.ends == "clamped":
        d[0] = d[-1] = sp.S.Zero
    if spline.ends == "periodic":
        d[-1], e[-1] = d[0], e[0]
    return d, e


def _data(spline: InterpolatingSpline) -> list[sp.Expr]:
    rows = (*spline.points, *spline.slopes)
    return [*spline.knots, *(coordinate for row in rows for coordinate in row)]


def _named(values: Sequence[sp.Expr], letter: str) -> list[sp.Expr]:
    """Return rational numbers as they are, and one symbol for each other value."""
    names = {value: sp.Symbol(f"{letter}{i}") for i, value in reversed(list(enumerate(values)))}
    return [value if value.is_Rational else names[value] for value in values]


def _acceleration(gap: sp.Expr, d: list[sp.Expr], e: list[sp.Expr]) -> sp.Expr:
    """Return g'' on a span of this length, t counted from its start.

    g is the quintic that vanishes at both ends, with slopes d and second derivatives e there.
    """
    data = (d[0] / gap, d[1] / gap, e[0], e[1])
    weights = substitute(_quintic_accelerations(), {t: t / gap})
    return sp.Add(*(w * x for w, x in zip(weights, data, strict=True)))


def _energy_of_g(gap: sp.Expr, d: list[sp.Expr], e: list[sp.Expr]) -> sp.Expr:
    """Return the integral of g''^2 over a span, a quadratic form in its freedoms."""
    data = (d[0] / gap, d[1] / gap, e[0], e[1])
    weights = [sp.Poly(w, t) for w in _quintic_accelerations()]
    products = ((a * b, x * y) for a, x in zip(weights, data, strict=True)
                for b, y in zip(weights, data, strict=True))  # fmt: skip
    return gap * sp.Add(*(w.integrate(t).eval(1) * xy for w, xy in products))


@lru_cache(maxsize=1)
def _quintic_accelerations() -> tuple[sp.Expr, ...]:
    return tuple(f.diff(t, 2) for f in hermite(5).functions[2:])


def _integral(f: sp.Expr, gap: sp.Expr) -> sp.Integral:
    return sp.Integral(f, (t, 0, gap))

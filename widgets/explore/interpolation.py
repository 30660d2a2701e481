"""Interpolation: Lagrange's oscillation, the natural spline, and a spline with local control."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp

from symbolic import catmull_rom, interpolating_spline, lagrange
from symbolic.dag import substitute
from symbolic.errors import BadValue

from ..figure import Figure
from ..scene import Scene
from .control_points import control_points

POINTS = ((0, 1), (1, 1.5), (2, 1), (3, 3), (4, 1), (5, 1.25), (6, 1))
STEPS = (
    "Seven points, and one polynomial of degree 6 through all of them: it swings at the ends.",
    "The natural cubic spline: pieces of degree 3, C^2 at the points. Every point moves all of it.",
    "Catmull-Rom: a cubic from four neighbours, C^1. A point moves four pieces at most.",
)
Pieces = list[tuple[Any, Any, list[sp.Expr]]]  # (start, end, one function for every point)


def interpolation(points: Any = POINTS) -> Figure:
    """Explore curves through given points: drag one and see how far its influence reaches.

    The dashed curve is how it was at first; the second drawing is the share of every point.

    Parameters
    ----------
    points : rows, shape (n + 1, 2), from 3 to 9 of them

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, too few or too many.

    Examples
    --------
    >>> fig = interpolation([[0, 0], [1, 1], [2, 0]])
    >>> sorted(fig.values)
    ['P', 'step']
    """
    rows = control_points(points)
    if len(rows) < 3:
        raise BadValue("3 to 9 points", f"{len(rows)}", "Two points are joined by a line.")
    scene = Scene(
        "Interpolation",
        "A curve through given points: the Lagrange polynomial, the natural cubic spline and the "
        "Catmull-Rom spline, each with the share that every point has in it.",
    )
    p = scene.points(rows, name="P")
    n = len(rows) - 1
    shares = scene.view("shares", (-0.1, n + 0.1), (-0.85, 1.4), title="Share of every point")
    scene.steps(STEPS)
    start = [[sp.Rational(float(c)) for c in row] for row in rows]
    for step, pieces in enumerate((_lagrange(n), _natural(n), _catmull_rom(n))):
        look: dict[str, Any] = {"since": step, "until": step}
        u = sp.Symbol("u")
        _draw(scene, pieces, start, u, color="muted", dashed=True, **look)
        _draw(scene, pieces, p, u, width=3, **look)
        for i in range(n + 1):
            graphs = [(a + (b - a) * u, _at(f[i], a, b, u)) for a, b, f in pieces]
            scene.curve(graphs, (u, 0, 1), samples=33, color=i, view=shares, **look)
    _ask(scene)
    return Figure(scene)


def _at(function: sp.Expr, start: Any, end: Any, u: sp.Symbol) -> sp.Expr:
    """Return a function of t on [start, end] as one of u on [0, 1]."""
    return substitute([function], {sp.Symbol("t"): start + (end - start) * u})[0]


def _draw(scene: Scene, pieces: Pieces, points: Any, u: sp.Symbol, **look: Any) -> None:
    """Draw the pieces: sums of the points times their functions."""
    curves = [
        [sum(x * _at(f, a, b, u) for x, f in zip(xs, functions, strict=True))
         for xs in zip(*points, strict=True)]
        for a, b, functions in pieces
    ]  # fmt: skip
    look = {"color": "curve", **look}
    scene.curve(curves, (u, 0, 1), samples=33, **look)


@lru_cache
def _lagrange(n: int) -> Pieces:
    functions = list(lagrange(list(range(n + 1))).functions)
    return [(i, i + 1, functions) for i in range(n)]


@lru_cache
def _natural(n: int) -> Pieces:
    """Return the splines through 1 at one point and 0 at the others: the shares of the points."""
    splines = [
        interpolating_spline([[int(i == k)] for i in range(n + 1)], list(range(n + 1))).pieces
        for k in range(n + 1)
    ]
    return [(i, i + 1, [pieces[i].coordinates[0] for pieces in splines]) for i in range(n)]


@lru_cache
def _catmull_rom(n: int) -> Pieces:
    """Return its pieces, with the first and last point's neighbours mirrored: 2 P_0 - P_1."""
    t, cubics = sp.Symbol("t"), catmull_rom().functions
    pieces: Pieces = []
    for i in range(n):
        functions = [sp.S.Zero] * (n + 1)
        for k, cubic in zip(range(i - 1, i + 3), cubics, strict=True):
            moved = substitute([cubic], {t: t - i})[0]
            mirror = {-1: (0, 1), n + 1: (n, n - 1)}.get(k)
            for place, share in [(k, 1)] if mirror is None else [(mirror[0], 2), (mirror[1], -1)]:
                functions[place] += share * moved
        pieces.append((i, i + 1, functions))
    return pieces


def _ask(scene: Scene) -> None:
    t = sp.Symbol("t")
    first, middle, last = lagrange([0, 1, 2]).functions
    scene.question(
        "For the nodes 0, 1, 2: write the Lagrange function that is 1 at t = 1 and 0 at 0 and 2.",
        middle, [t], until=0,
        mistakes={"It has the right zeros, but is not 1 at t = 1: divide by its value there.":
                      t * (t - 2),
                  "That is 1 at t = 0.": first, "That is 1 at t = 2.": last},
        hint="Not yet. Its zeros are 0 and 2; what remains is a factor that makes it 1 at t = 1.",
    )  # fmt: skip
    left = interpolating_spline([[0], [1], [0]], [0, 1, 2]).pieces[0].coordinates[0]
    scene.question(
        "The natural spline through 0, 1, 0 at t = 0, 1, 2: write its first piece.",
        left, [t], since=1, until=1,
        mistakes={"That is the parabola through them: its second derivative at 0 is not 0.":
                      2 * t - t**2},
        hint="Not yet. It is a t - b t^3: the second derivative is 0 at t = 0, the slope 0 at 1.",
    )  # fmt: skip
    scene.question(
        "Catmull-Rom: the tangent at P_i is a multiple of P_{i+1} - P_{i-1}. Which multiple?",
        sp.Rational(1, 2), since=2,
        mistakes={"From P_{i-1} to P_{i+1} the parameter grows by 2, not by 1.": sp.Integer(1)},
        hint="Not yet. It is the mean of both legs' differences.",
    )  # fmt: skip

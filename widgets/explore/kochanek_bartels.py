"""Kochanek-Bartels splines: tension, continuity and bias, and the tangents they make."""

from __future__ import annotations

from typing import Any

import sympy as sp

from symbolic import kochanek_bartels as basis_of
from symbolic.errors import BadValue

from ..figure import Figure
from ..scene import Scene
from .control_points import control_points

POINTS = ((0, 1), (1, 4), (4, 5), (6, 1), (9, 2), (10, 5))
STEPS = (
    "The curve passes through its inner points. What do tension, continuity and bias change?",
    "Tangents, half as long. Leaving P_i: (1 - T)/2 ((1 + B)(1 + C)(P_i - P_{i-1}) + "
    "(1 - B)(1 - C)(P_{i+1} - P_i)). Arriving: with -C in place of C.",
    "Dashed: C = B = 0, the cardinal spline of this T. Pale: T = 0 as well, Catmull-Rom.",
)
LETTERS = T, C, B = sp.symbols("T C B")
WORDS = ("tension", "continuity", "bias")
t = sp.Symbol("t")
Points = list[tuple[Any, Any]]


def kochanek_bartels(points: Any = POINTS) -> Figure:
    """Explore Kochanek-Bartels splines: drag points and sliders, and see what tangents they make.

    Linked by colour: the points, the tangents on both sides of every inner point, and the
    blending functions of the middle segment.

    Parameters
    ----------
    points : rows, shape (n, 2)
        Four to nine; the curve runs from the second to the last but one.

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, too few or too many.

    Examples
    --------
    >>> fig = kochanek_bartels()
    >>> sorted(fig.values)
    ['B', 'C', 'P', 'T', 'step']
    """
    rows = control_points(points)
    if len(rows) < 4:
        raise BadValue("four points or more", f"{len(rows)}", "A segment needs two neighbours.")
    scene = Scene(
        "Kochanek-Bartels splines",
        "A curve through its inner points, the tangents with which it arrives at each and leaves "
        "it, and the blending functions of its middle segment.",
    )
    p = scene.points(rows, name="P")
    for letter, word in zip(LETTERS, WORDS, strict=True):
        scene.slider(letter.name, -1, 1, value=0, label=f"{letter} {word}")
    scene.steps(STEPS)
    middle = (len(p) - 2) // 2
    scene.polyline(p, color="muted", width=1)
    scene.curve(_segments(p, T, 0, 0), (t, 0, 1), dashed=True, since=2, until=2)
    scene.curve(_segments(p, 0, 0, 0), (t, 0, 1), color="muted", width=4, since=2, until=2)
    segments = _segments(p, T, C, B)
    scene.curve(segments, (t, 0, 1), width=3)
    scene.curve(segments[middle - 1], (t, 0, 1), color="accent", width=3)
    for i in range(1, len(p) - 1):
        arriving, leaving = ([d / 2 for d in tangent] for tangent in tangents(p, i, T, C, B))
        before = [a - d for a, d in zip(p[i], arriving, strict=True)]
        after = [a + d for a, d in zip(p[i], leaving, strict=True)]
        scene.arrows([[before, p[i]], [p[i], after]], color=i, width=3, since=1)
    _functions(scene, middle)
    _verdicts(scene, p, middle)
    _ask(scene, p, middle)
    return Figure(scene)


def tangents(p: Points, i: int, *parameters: Any) -> tuple[list[Any], list[Any]]:
    """Return the tangents with which the curve arrives at an inner point and leaves it.

    They are derivatives of the segments' blending functions, which give nothing to the point
    farthest away.
    """
    functions = basis_of(*parameters).functions
    ends = [[sp.factor(f.diff(t).subs(t, end)) for f in functions] for end in (1, 0)]
    return (_combined(ends[0][1:], p[i - 1 : i + 2]), _combined(ends[1][:3], p[i - 1 : i + 2]))


def _combined(weights: Any, points: Points) -> list[Any]:
    return [
        sum(w * x for w, x in zip(weights, xs, strict=True)) for xs in zip(*points, strict=True)
    ]


def _segments(p: Points, *parameters: Any) -> list[list[Any]]:
    functions = basis_of(*parameters).functions
    return [_combined(functions, p[i : i + 4]) for i in range(len(p) - 3)]


def _functions(scene: Scene, middle: int) -> None:
    view = scene.view("functions", (0, 1), (-0.75, 1.75),
                      title=f"Blending functions from P_{middle} to P_{middle + 1}")  # fmt: skip
    for i, function in enumerate(basis_of(T, C, B).functions, middle - 1):
        scene.curve((t, function), (t, 0, 1), color=i, width=3, view=view)


def _verdicts(scene: Scene, p: Points, i: int) -> None:
    arriving, leaving = tangents(p, i, T, C, B)
    scene.readout(f"Arriving at P_{i}", arriving)
    scene.readout(f"Leaving P_{i}", leaving)
    scene.statement(f"C^1 at P_{i}", [b - a for a, b in zip(arriving, leaving, strict=True)])


def _ask(scene: Scene, p: Points, i: int) -> None:
    alike = "both tangents alike, so they stay equal."
    scene.question(
        "Before you try: which of T, C, B breaks C^1 at the inner points? Type its letter.", C,
        LETTERS, until=0, mistakes={f"T shortens {alike}": T, f"B turns {alike}": B},
        hint="Not yet. Two of them do the same to the tangents before and after a point.",
    )  # fmt: skip
    half = sp.Rational(1, 2)
    arriving, leaving = tangents(p, i, 0, half, 0)
    smooth = tangents(p, i, 0, 0, 0)[0]
    scene.question(
        f"T = B = 0, C = 1/2: with which tangent does the curve leave P_{i}? Type (x, y).",
        leaving, since=1, until=1,
        mistakes={
            "That one arrives; some books have the opposite sign of C, here (1 + C) goes with "
            "the leg before.": arriving,
            "That is the arrow, half of the tangent.": [d / 2 for d in leaving],
            "That is the tangent for C = 0, of Catmull-Rom.": smooth,
            "Halve it: (1 - T)/2 stands before both legs.": [2 * d for d in leaving],
        },
        hint=f"Not yet. It is 1/2 (3/2 (P_{i} - P_{i - 1}) + 1/2 (P_{i + 1} - P_{i})).",
    )  # fmt: skip
    scene.question(
        "For which T are all tangents zero, whatever C and B are?", sp.Integer(1), since=2,
        mistakes={"That is Catmull-Rom for C = B = 0: half the chord of the neighbours.":
                      sp.Integer(0),
                  "That doubles the tangents.": sp.Integer(-1)},
        hint="Not yet. All tangents have the factor (1 - T)/2.",
    )  # fmt: skip

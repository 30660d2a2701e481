"""The blossom of a cubic: three arguments, and a label for every point of the triangle."""

from __future__ import annotations

from typing import Any

import sympy as sp

from symbolic import blossom as blossom_of
from symbolic import check_blossom, polar_levels

from ..figure import Figure
from ..scene import Scene
from .control_points import cubic_points
from .de_casteljau import CUBIC

INTERVAL = R, S = 0, 4
LETTERS = "uvw"
LERPS = [(level, i) for level in (1, 2, 3) for i in range(4 - level)]
_COLOURS = (4, 6, 5)  # of the arguments; 0 to 3 are the control points
_ALL, _OTHER = len(LERPS), len(LERPS) + 1  # steps: all interpolations, and those of w, v, u
t = sp.Symbol("t")
ARGUMENTS = sp.symbols([*LETTERS])


def blossom(points: Any = CUBIC) -> Figure:
    """Explore the blossom b(u, v, w) of a cubic: step one interpolation at a time.

    Linked by colour: the control points, which are values of the blossom over [r, s] = [0, 4],
    the triangle of labels with their shares, and the lines that each argument makes.

    Parameters
    ----------
    points : rows, shape (4, 2)

    Raises
    ------
    BadValue, BadType
        For points that cannot be read, not in the plane, or not four.

    Examples
    --------
    >>> fig = blossom()
    >>> sorted(fig.values)
    ['b', 'step', 'u', 'v', 'w']
    """
    scene = Scene(
        f"Blossom of a cubic, r = {R}, s = {S}",
        "A cubic Bezier curve whose control points are values of its blossom, and the triangle "
        "of interpolations with u, v and w that leads to the value b(u,v,w).",
    )
    rows = cubic_points(points)
    b = scene.points(rows, name="b", labels=[label(0, i) for i in range(4)])
    arguments = [scene.slider(name, R, S, value=k) for k, name in enumerate(LETTERS, 1)]
    scene.steps(_captions(), first=1)
    scene.polyline(b)
    scene.curve(value(b, t, t, t), (t, R, S), color="muted", width=3)
    levels = polar_levels(b, arguments, INTERVAL)
    _draw(scene, levels)
    _draw_other_order(scene, polar_levels(b, arguments[::-1], INTERVAL))
    scene.dots([levels[3][0]], ["curve"], [label(3, 0)], radius=6, since=_ALL)

    shares = polar_levels(sp.eye(4).tolist(), arguments, INTERVAL)
    entries = [(0, i) for i in range(4)] + LERPS
    froms = [0] * 4 + [k for k, _ in enumerate(LERPS, 1)]
    scene.scheme(levels, [label(*entry) for entry in entries], froms,
                 [row for level in shares for row in level])  # fmt: skip
    scene.weights(list(shares[3][0]), [label(0, i) for i in range(4)],
                  title="Share of every control point in b(u,v,w)")  # fmt: skip
    scene.readout("b(u,v,w)", levels[3][0])
    _ask(scene, b)
    return Figure(scene)


def label(level: int, i: int, letters: str = LETTERS) -> str:
    """Return the name of a point of the triangle.

    >>> label(0, 1), label(2, 0), label(1, 1, "wvu")
    ('b(r,r,s)', 'b(r,u,v)', 'b(r,w,s)')
    """
    inner = sorted(letters[:level])
    return f"b({','.join(['r'] * (3 - level - i) + inner + ['s'] * i)})"


def value(b: Any, *arguments: Any) -> list[Any]:
    """Return the value of the blossom of control points over [r, s]."""
    return list(polar_levels(b, arguments, INTERVAL)[3][0])


def _draw(scene: Scene, levels: Any) -> None:
    for k, (level, i) in enumerate(LERPS, 1):
        colour = _COLOURS[level - 1]
        scene.polyline(levels[level - 1][i : i + 2], color="accent", width=4, since=k, until=k)
        if i:
            scene.polyline(levels[level][i - 1 : i + 1], color=colour, since=k, until=_ALL)
            scene.polyline(levels[level][i - 1 : i + 1], color="muted", since=_OTHER, until=_OTHER)
        if level < 3:
            scene.dots([levels[level][i]], [colour], [label(level, i)], since=k, until=_ALL)


def _draw_other_order(scene: Scene, levels: Any) -> None:
    letters = LETTERS[::-1]
    for level in (1, 2):
        colour = _COLOURS[3 - level]
        names = [label(level, i, letters) for i in range(4 - level)]
        scene.polyline(levels[level], color=colour, since=_OTHER, until=_OTHER)
        scene.dots(levels[level], [colour] * len(names), names, since=_OTHER, until=_OTHER)


def _captions() -> list[str]:
    captions = ["Control points are values of the blossom: r and s in every order give the same."]
    for level, i in LERPS:
        u = LETTERS[level - 1]
        left, right = label(level - 1, i), label(level - 1, i + 1)
        captions.append(f"{label(level, i)} = ((s - {u}) {left} + ({u} - r) {right}) / (s - r)")
    captions[-1] += "; on the curve if u = v = w"
    return [*captions, "Symmetric: in the order w, v, u the way is another, the end is the same."]


def _ask(scene: Scene, b: Any) -> None:
    scene.question(
        "Before you step on: fill in the label b(0,1,4). Type (x, y).", value(b, 0, 1, 4), until=1,
        mistakes={
            "That is b(0,3,4): at u = r you are at the left end of the leg, b(r,r,s).":
                value(b, 0, 3, 4),
            "That is b(0,0,1), on the first leg: b(0,1,4) has an s.": value(b, 0, 0, 1),
            "That is b(1,4,4), on the last leg: b(0,1,4) has an r.": value(b, 1, 4, 4),
            "That is b(1,1,1), a point of the curve.": value(b, 1, 1, 1),
        },
        hint="Not yet. It lies between b(0,0,4) and b(0,4,4), which differ in one argument only.",
    )  # fmt: skip
    scene.question(
        "Fill in the label b(4,0,4). Type (x, y).", value(b, 4, 0, 4), since=2, until=_ALL - 1,
        mistakes={"That is b(0,0,4): count how often r = 0 and s = 4 occur.": value(b, 0, 0, 4),
                  "That is b(4,4,4), the end of the curve.": value(b, 4, 4, 4)},
        hint="Not yet. The blossom is symmetric: in which order do the labels have 0, 4, 4?",
    )  # fmt: skip
    cubic = t**3 - 6 * t**2 + 3 * t
    scene.question(
        "Give your own blossom: type the polar form of F(t) = t^3 - 6t^2 + 3t in u, v, w.",
        blossom_of(cubic, t)(*ARGUMENTS), ARGUMENTS, since=_ALL, mistakes=known_mistakes(cubic),
        hint="Not yet. Every term must be affine in each argument, the whole symmetric, and "
        "u = v = w = t must give F(t).",
    )  # fmt: skip


def known_mistakes(cubic: sp.Expr) -> dict[str, sp.Expr]:
    """Return wrong polar forms of a cubic by the axiom they break, and how they come about."""
    u, v, w = ARGUMENTS
    e = (1, u + v + w, u * v + u * w + v * w, u * v * w)
    mean = (u + v + w) / 3
    coefficients = sp.Poly(cubic, t).all_coeffs()[::-1]

    def replaced(powers: Any) -> sp.Expr:
        return sum((c * p for c, p in zip(coefficients, powers, strict=True)), sp.S.Zero)

    right = blossom_of(cubic, t)(u, v, w)
    wrong = {
        "For t^2 take all products of two arguments, for t all arguments.":
            replaced((1, u, u * v, u * v * w)),
        "Take products of different arguments, not the mean of their powers.":
            replaced([(u**k + v**k + w**k) / 3 for k in range(4)]),
        "That is F at the mean of the arguments.": cubic.subs(t, mean),
        "That is F itself, in one argument.": cubic.subs(t, u),
        "Only the terms of t^3 and t are right.": replaced((1, mean, u**2, e[3])),
        "Divide by the number of products: three for t^2, three for t.": replaced(e),
        "Divide by the number of products for t^2 as well.": replaced((1, mean, e[2], e[3])),
        "Divide by the number of arguments for t as well.": replaced((1, e[1], e[2] / 3, e[3])),
        "All signs are reversed.": -right,
    }  # fmt: skip
    return {
        f"{check_blossom(form, cubic, [*ARGUMENTS]).diagnosis} {why}": form
        for why, form in wrong.items()
    }

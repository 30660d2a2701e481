"""What a C2 cubic spline has to meet, as verified steps: the points, smooth joints, its ends."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import sympy as sp

from ..exact import PARAMETER, Point
from ..proofs.derivation import Derivation, Step
from ..splines.conversion import Segment

Ends = Literal["natural", "clamped", "periodic", "not-a-knot"]
t = PARAMETER


def spline_derivation(
    pieces: Sequence[Segment], points: Sequence[Point], slopes: Sequence[Point], ends: Ends
) -> Derivation:
    """Return the proof that these cubics meet every condition of the spline through the points."""
    return Derivation(
        f"The {ends} cubic spline through {len(points)} points",
        (*_interpolates(pieces, points), *_is_smooth(pieces), *_END_STEPS[ends](pieces, slopes)),
        "de Boor, A Practical Guide to Splines, chapter IV",
    )


def _interpolates(pieces: Sequence[Segment], points: Sequence[Point]) -> list[Step]:
    return [
        Step(_at(piece, 0, end), _row(points[j]), f"span {i + 1} at {end} is point {j}")
        for i, piece in enumerate(pieces)
        for j, end in ((i, piece.start), (i + 1, piece.end))
    ]


def _is_smooth(pieces: Sequence[Segment]) -> list[Step]:
    return [
        Step(_at(left, order, left.end), _at(right, order, left.end),
             f"the {word} derivatives on both sides of {left.end} agree")
        for left, right in pairwise(pieces)
        for order, word in ((1, "first"), (2, "second"))
    ]  # fmt: skip


def _natural(pieces: Sequence[Segment], _: Sequence[Point]) -> list[Step]:
    zero = sp.ImmutableMatrix(sp.zeros(1, len(pieces[0].coordinates)))
    return [Step(_at(piece, 2, end), zero, f"natural: no second derivative at {end}")
            for piece, end in _outermost(pieces)]  # fmt: skip


def _clamped(pieces: Sequence[Segment], slopes: Sequence[Point]) -> list[Step]:
    given = (slopes[0], slopes[-1])
    return [Step(_at(piece, 1, end), _row(slope), f"clamped: the slope given at {end}")
            for (piece, end), slope in zip(_outermost(pieces), given, strict=True)]  # fmt: skip


def _periodic(pieces: Sequence[Segment], _: Sequence[Point]) -> list[Step]:
    first, last = pieces[0], pieces[-1]
    return [Step(_at(last, order, last.end), _at(first, order, first.start),
                 f"periodic: the {word} derivatives at both ends agree")
            for order, word in ((1, "first"), (2, "second"))]  # fmt: skip


def _not_a_knot(pieces: Sequence[Segment], _: Sequence[Point]) -> list[Step]:
    return [Step(_at(left, 3, left.end), _at(right, 3, left.end),
                 f"not a knot: even the third derivatives agree at {left.end}")
            for left, right in (pieces[:2], pieces[-2:])]  # fmt: skip


_END_STEPS = {
    "natural": _natural, "clamped": _clamped, "periodic": _periodic, "not-a-knot": _not_a_knot,
}  # fmt: skip


def _outermost(pieces: Sequence[Segment]) -> list[tuple[Segment, sp.Expr]]:
    return [(pieces[0], pieces[0].start), (pieces[-1], pieces[-1].end)]


def _at(piece: Segment, order: int, place: sp.Expr) -> sp.ImmutableMatrix:
    inner = [sp.Derivative(x, (t, order)) if order else x for x in piece.coordinates]
    return sp.ImmutableMatrix([[sp.Subs(x, t, place) for x in inner]])


def _row(point: Point) -> sp.ImmutableMatrix:
    return sp.ImmutableMatrix([list(point)])

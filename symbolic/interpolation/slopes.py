"""The equations for the slopes of a C2 cubic spline: one per interior knot, and two end conditions.

With gaps h_i, chord slopes d_i = (p_{i+1} - p_i)/h_i and slopes m_i, both second derivatives at
an interior knot agree if

    m_{i-1}/h_{i-1} + 2 m_i (1/h_{i-1} + 1/h_i) + m_{i+1}/h_i = 3 (d_{i-1}/h_{i-1} + d_i/h_i)

(de Boor, *A Practical Guide to Splines*, chapter IV).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .tridiagonal import Row, solve_cyclic, solve_tridiagonal

Vector = Sequence[Any]


def spline_slopes(
    gaps: Sequence[Any], chords: Sequence[Vector], ends: str, tangents: Sequence[Vector], one: Any
) -> list[list[Any]]:
    """Return the slopes at all knots, elements of the field of the gaps.

    Parameters
    ----------
    gaps, chords : n each
    ends : "natural", "clamped", "periodic" or "not-a-knot"
    tangents : the first and the last slope, for "clamped" only
    one : the field's one
    """
    a = [one / gap for gap in gaps]
    inner = [_smooth(a[i - 1], a[i], chords[i - 1], chords[i]) for i in range(1, len(a))]
    if ends == "periodic":
        slopes = solve_cyclic([_smooth(a[-1], a[0], chords[-1], chords[0]), *inner])
        return [*slopes, slopes[0]]
    if ends == "clamped":
        first, last = (Row(a[0] - a[0], a[0] / a[0], a[0] - a[0], t) for t in tangents)
    elif ends == "natural":
        first, last = (_free(a[0], chords[0]), _free(a[0], chords[-1]))
    else:
        first = _one_cubic(a[0], a[1], chords[0], chords[1])
        last = _one_cubic(a[-1], a[-2], chords[-1], chords[-2])
    return solve_tridiagonal([first, *inner, _mirrored(last)])


def _smooth(a: Any, b: Any, left: Vector, right: Vector) -> Row:
    return Row(a, 2 * (a + b), b, [3 * (a * p + b * q) for p, q in zip(left, right, strict=True)])


def _free(a: Any, chord: Vector) -> Row:
    """No second derivative at the end: 2 m_0 + m_1 = 3 d_0."""
    one = a / a
    return Row(one - one, 2 * one, one, [3 * d for d in chord])


def _one_cubic(a: Any, b: Any, chord: Vector, following: Vector) -> Row:
    """The third derivatives at the second knot agree; m_2 is eliminated by its own equation."""
    right = [
        (a * (2 * a + 3 * b) * p + b * b * q) / (a + b)
        for p, q in zip(chord, following, strict=True)
    ]
    return Row(a - a, a, a + b, right)


def _mirrored(row: Row) -> Row:
    return Row(row.after, row.here, row.before, row.right)

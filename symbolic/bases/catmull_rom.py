"""Catmull-Rom curves: through their inner points, by the pyramid of Barry and Goldman."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache, partial
from itertools import pairwise
from typing import Any

import sympy as sp
from sympy.polys.densearith import dup_add, dup_mul
from sympy.polys.domains.domain import Domain
from sympy.polys.matrices import DomainMatrix

from ..dag import postorder
from ..errors import BadType, BadValue, shown
from ..exact import PARAMETER, as_list
from ..fields import common_field, is_radical
from ..names import unused_letter
from ..polynomials import Coefficients, expression
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .basis import Basis, Geometry
from .constraints import Condition, derivative, value
from .parameters import increasing_parameters, refuse_clash

_UNIFORM = tuple(sp.Integer(k) for k in (-1, 0, 1, 2))
_POINTS = sp.symbols("P0:4")
# The knots between which each point of the pyramid interpolates, level by level.
_PYRAMID = (((0, 1), (1, 2), (2, 3)), ((0, 2), (1, 3)), ((1, 2),))


def catmull_rom(knots: Any = None) -> Basis:
    r"""Return the basis of a Catmull-Rom segment from P1 to P2, with G = (P0, P1, P2, P3).

    The uniform curve has the tangents (P2 - P0)/2 and (P3 - P1)/2 at its ends. With knots
    t_0 < t_1 < t_2 < t_3 it interpolates the points linearly three times (Barry and Goldman):
    P_i and P_{i+1} over [t_i, t_{i+1}]; two neighbours of these over [t_i, t_{i+2}]; and the last
    two over [t_1, t_2]. The parameter t is local, in [0, 1]: the pyramid is evaluated at
    u = t_1 + (t_2 - t_1) t, and derivatives are those with respect to t.

    Parameters
    ----------
    knots : list of four exact parameters, optional
        Numbers, roots, or symbols (assumed to increase); `chord_knots` makes centripetal and
        chordal ones. By default uniform. Only the ratios of the gaps matter.

    Raises
    ------
    BadValue
        If there are not four knots, or they do not increase.
    BadType, NotExact
        For other things than exact parameters.

    Notes
    -----
    Catmull and Rom, "A class of local interpolating splines", 1974; Barry and Goldman, "A recursive
    evaluation algorithm for a class of Catmull-Rom splines", SIGGRAPH 1988.

    Examples
    --------
    >>> 2 * catmull_rom().matrix
    Matrix([
    [-1,  3, -3,  1],
    [ 2, -5,  4, -1],
    [-1,  0,  1,  0],
    [ 0,  2,  0,  0]])
    >>> catmull_rom([0, 2, 3, 5]).functions[0]
    -t**3/6 + t**2/3 - t/6
    """
    return _catmull_rom(_UNIFORM if knots is None else _knots_from(knots))


def _knots_from(knots: Any) -> tuple[sp.Expr, ...]:
    listed = as_list(knots)
    if listed is None:
        raise BadType("a list of four knots", shown(knots), "Write [0, 1, 3, 4].")
    if len(listed) != 4:
        raise BadValue(
            "four knots, one for each of P0, P1, P2, P3",
            f"{len(listed)}",
            "Give each segment the knots of its own four points.",
        )
    read = increasing_parameters(listed)
    refuse_clash(read, _POINTS)
    return read


@lru_cache(maxsize=64)
def _catmull_rom(knots: tuple[sp.Expr, ...]) -> Basis:
    field, elements = common_field(knots)
    (columns,) = _levels(field, elements)[-1]
    padded = [[field.zero] * (4 - len(column)) + column for column in columns]
    flat = [column[k] for k in range(4) for column in padded]
    uniform = knots == _UNIFORM
    return Basis(
        "uniform Catmull-Rom basis" if uniform
        else f"Catmull-Rom basis with knots {', '.join(map(str, knots))}",
        tuple(Geometry(symbol, "point") for symbol in _POINTS),
        DomainMatrix.from_list_flat(flat, (4, 4), field).to_dense(),
        partial(_derivation, knots=knots),
    )  # fmt: skip


def _levels(field: Domain, knots: Sequence[Any]) -> list[list[list[Coefficients]]]:
    """Return the pyramid: levels of points, each the four functions of t that weigh P0 ... P3."""
    points = [[[field.one] if i == j else [] for j in range(4)] for i in range(4)]
    levels = [points]
    for intervals in _PYRAMID:
        below = levels[-1]
        level = []
        for i, (first, last) in enumerate(intervals):
            left, right = _weights(knots, first, last)
            level.append([
                dup_add(dup_mul(left, a, field),
                        dup_mul(right, b, field), field)
                for a, b in zip(below[i], below[i + 1], strict=True)
            ])  # fmt: skip
        levels.append(level)
    return levels


def _weights(knots: Sequence[Any], first: int, last: int) -> tuple[list[Any], list[Any]]:
    """Return (t_last - u)/(t_last - t_first) and (u - t_first)/(t_last - t_first), linear in t."""
    length, step = knots[last] - knots[first], knots[2] - knots[1]
    return (
        [-step / length, (knots[last] - knots[1]) / length],
        [step / length, (knots[1] - knots[first]) / length],
    )


def _derivation(basis: Basis, knots: tuple[sp.Expr, ...]) -> Derivation:
    title = f"{basis.name}: from Barry and Goldman's pyramid to the matrix"
    if any(is_radical(node) for node in postorder(knots)):
        # What holds for all gaps holds for these too; with roots the lines would be unreadable.
        letter = unused_letter("hd", knots)
        gaps = [sp.Symbol(f"{letter}{i}") for i in range(3)]
        given = ", ".join(f"{h} = {b - a}" for h, (a, b) in zip(gaps, pairwise(knots), strict=True))
        title += f", in the gaps {given}"
        knots = (-gaps[0], sp.S.Zero, gaps[1], gaps[1] + gaps[2])
        basis = _catmull_rom(knots)
    field, elements = common_field(knots)
    return Derivation(
        title,
        (
            *_pyramid_steps(field, elements, knots),
            Step(times(sp.ImmutableMatrix([basis.powers]), basis.matrix),
                 sp.ImmutableMatrix([basis.functions]),
                 "the weights of the four points in the last one, collected by powers of t"),
            Step(_condition(value(0), basis), sp.ImmutableMatrix([_POINTS[1]]), "it starts at P1"),
            Step(_condition(value(1), basis), sp.ImmutableMatrix([_POINTS[2]]), "it ends at P2"),
            *_tangent_steps(basis, knots),
            Step(plus(*basis.functions), sp.S.One,
                 "the weights sum to one, so the curve moves along with its control points"),
        ), "Catmull and Rom 1974; Barry and Goldman 1988",
    )  # fmt: skip


def _pyramid_steps(field: Domain, elements: Sequence[Any], knots: Sequence[sp.Expr]) -> list[Step]:
    def written(functions: list[Coefficients]) -> sp.Expr:
        weights = [expression(f, field, PARAMETER) for f in functions]
        return sp.Add(*(w * p for w, p in zip(weights, _POINTS, strict=True)))

    levels = [[written(functions) for functions in level] for level in _levels(field, elements)]
    steps = []
    for r, intervals in enumerate(_PYRAMID):
        for i, (first, last) in enumerate(intervals):
            a, b = _written_weights(knots, first, last)
            left, right = levels[r][i], levels[r][i + 1]
            because = (
                f"level {r + 1}: between two points of level {r}, linear over "
                f"[t_{first}, t_{last}] at u = t_1 + (t_2 - t_1) t"
            )
            interpolated = plus(times(a, left), times(b, right))
            steps.append(Step(interpolated, levels[r + 1][i], because))
    return steps


def _written_weights(knots: Sequence[sp.Expr], first: int, last: int) -> tuple[sp.Expr, sp.Expr]:
    """Return (t_last - u)/(t_last - t_first) and (u - t_first)/(t_last - t_first) as written."""
    u = knots[1] + (knots[2] - knots[1]) * PARAMETER
    length = sp.Pow(knots[last] - knots[first], -1, evaluate=False)
    before = plus(knots[last], times(sp.S.NegativeOne, u))
    after = plus(u, -knots[first]) if knots[first] else u
    return times(before, length), times(after, length)


def _condition(condition: Condition, basis: Basis) -> sp.MatMul:
    """Return a condition's row times the matrix times the points: [1 1 1 1] M G is c(1)."""
    row, points = sp.ImmutableMatrix([condition.row(3)]), sp.ImmutableMatrix(_POINTS)
    return times(row, basis.matrix, points)


def _tangent_steps(basis: Basis, knots: Sequence[sp.Expr]) -> list[Step]:
    """Return the tangents by the points and gaps, and that equal gaps make them half a chord."""
    gaps = [b - a for a, b in pairwise(knots)]
    h = sp.Symbol("h")
    steps = []
    for at, equal in ((0, (_POINTS[2] - _POINTS[0]) / 2), (1, (_POINTS[3] - _POINTS[1]) / 2)):
        steps += [
            Step(_condition(derivative(at), basis), sp.ImmutableMatrix([_tangent(at, gaps)]),
                 f"the tangent at t = {at}: the divided differences before and after, less the one "
                 "across"),
            Step(_tangent(at, [h, h, h]), equal,
                 "for equal gaps h: half the chord of the neighbours, the uniform Catmull-Rom"),
        ]  # fmt: skip
    return steps


def _tangent(at: int, gaps: Sequence[sp.Expr]) -> sp.Expr:
    before, after = gaps[at], gaps[at + 1]
    p, q, r = _POINTS[at : at + 3]
    slopes = [times(q - p, 1 / before), times(p - r, 1 / (before + after)),
              times(r - q, 1 / after)]  # fmt: skip
    return times(gaps[1], plus(*slopes))

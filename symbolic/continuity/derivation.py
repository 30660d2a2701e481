"""What a verdict on a joint rests on, as steps: residuals, betas, directions, and what fails."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import combinations
from math import factorial
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..exact import PARAMETER
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .conditions import derivative_at
from .connection import chain_rows
from .contact import first_not_zero, multiple
from .joint import Continuity
from .segments import Given, Segment, Vector, read_segments


def joint_derivation(joint: Continuity, left: Given, right: Given, ratio: sp.Expr) -> Derivation:
    """Return the steps behind a verdict; each states a value, its reason what follows from it."""
    before, after, _ = read_segments(left, right, ratio)  # fields cannot be pickled, these can
    steps = _residual_steps(joint, before, after, ratio)
    if joint.parametric == sp.oo:
        steps.append(_one_curve(before, after, ratio, "one curve, before the joint and after"))
    if joint.parametric != -1 and None not in joint.tangents:
        steps += _geometric_steps(joint, before, after)
    return Derivation(
        "Continuity at a joint",
        tuple(steps),
        "Barsky and DeRose, Geometric continuity of parametric curves, 1989",
    )


def _residual_steps(
    joint: Continuity, before: Segment, after: Segment, ratio: sp.Expr
) -> list[Step]:
    steps = []
    for j, residual in enumerate(joint.residuals):
        values = [
            derivative_at(right, j, 0) - times(ratio**j, derivative_at(left, j, 1))
            for left, right in zip(before.curve, after.curve, strict=True)
        ]
        fails = joint.parametric == j - 1
        verdict = f"not zero, so not C^{j}" if fails else f"zero, so C^{j}"
        steps.append(Step(_row(values), _row(residual), f"the residual of order {j} is {verdict}"))
        if fails:
            break
    return steps


def _geometric_steps(joint: Continuity, before: Segment, after: Segment) -> list[Step]:
    field, known = before.field, len(joint.betas)
    highest = max(before.degree, after.degree, known + 1)
    p, q = _derivatives(before, highest), _derivatives(after, highest)
    if not known:
        return _direction_steps(before, after, p, q)
    if joint.parametric == sp.oo:
        return []
    rows = chain_rows([*map(field.from_sympy, joint.betas), field.zero], field)
    steps = [
        Step(_row([derivative_at(c, j, 0) for c in after.curve]), _sums(rows[j], p, field),
             f"derivative {j} by those of the left segment, with beta{j} = {beta}: G^{j}")
        for j, beta in enumerate(joint.betas, 1)
    ]  # fmt: skip
    if joint.geometric == sp.oo:
        steps[-1:] = _beyond(steps[-1], before, after, joint.betas)
    if joint.geometric == known:
        j = known + 1
        rest = [
            q[j][x] - sum((rows[j][i] * p[i][x] for i in range(2, j + 1)), field.zero)
            for x in range(len(p[0]))
        ]
        why = f"no beta{j}: the rest of derivative {j} is not along the tangent, so not G^{j}"
        steps.append(_parallel_step(rest, p[1], field, why))
    return steps


def _beyond(last: Step, before: Segment, after: Segment, betas: Sequence[sp.Expr]) -> list[Step]:
    """Say why the segments agree beyond the last beta that is shown."""
    m, n, field = before.degree, after.degree, before.field
    speed = field.from_sympy(betas[0])
    pairs = zip(before.series(m + n), after.series(m + n), strict=True)
    if all(y == speed**j * x for j, rows in enumerate(pairs) for x, y in zip(*rows, strict=True)):
        why = f"one curve at another speed, {betas[0]} times as fast: G^oo"
        return [last, _one_curve(before, after, betas[0], why)]
    why = f"{last.because}. Followed up to G^{m * n}: by Bezout's theorem different curves of "
    why += f"degrees {m} and {n} touch less closely, so both follow one: G^oo"
    return [replace(last, because=why)]


def _one_curve(before: Segment, after: Segment, speed: sp.Expr, why: str) -> Step:
    moved = [sp.Subs(c, PARAMETER, 1 + speed * PARAMETER) for c in before.curve]
    return Step(_row(moved), _row(after.curve), why)


def _direction_steps(
    before: Segment, after: Segment, p: Sequence[Vector], q: Sequence[Vector]
) -> list[Step]:
    steps, directions = [], []
    for segment, series, at, side in ((before, p, 1, "left"), (after, q, 0, "right")):
        order = first_not_zero(series) or 0  # there is one, as there is a tangent
        for j in range(1, order + 1):
            value = _row([segment.field.to_sympy(c) for c in series[j]])
            first = ", the first that is not zero" if j == order > 1 else ""
            left = _row([derivative_at(c, j, at) for c in segment.curve])
            steps.append(Step(left, value, f"derivative {j} on the {side}{first}"))
        turned = at == 1 and order % 2 == 0
        directions.append([-c for c in series[order]] if turned else series[order])
    why = "the one-sided direction after the joint by that before it; on the left every derivative "
    why += "of even order counts negative"
    steps.append(_parallel_step(directions[1], directions[0], before.field, why))
    return steps


def _parallel_step(vector: Vector, of: Vector, field: Domain, why: str) -> Step:
    """State vector = c * of, or a determinant that is not zero."""
    e = field.to_sympy
    factor = multiple(vector, of, field)
    if factor is not None:
        side = times(e(factor), _row(map(e, of)))
        return Step(_row(map(e, vector)), side, why)
    x, y = next(
        (x, y) for x, y in combinations(range(len(of)), 2) if vector[x] * of[y] - vector[y] * of[x]
    )
    determinant = plus(times(e(vector[x]), e(of[y])), times(-e(vector[y]), e(of[x])))
    value = e(vector[x] * of[y] - vector[y] * of[x])
    return Step(determinant, value, f"{why}: their determinant is not zero")


def _sums(row: Sequence[Any], p: Sequence[Vector], field: Domain) -> sp.ImmutableMatrix:
    """Return sum M_ji p^(i)(1) with its terms kept apart."""
    e = field.to_sympy
    columns = [
        [times(e(m), e(p[i][x])) for i, m in enumerate(row) if m and any(p[i])]
        for x in range(len(p[0]))
    ]
    return _row([sp.Add(*terms, evaluate=len(terms) < 2) for terms in columns])


def _derivatives(segment: Segment, highest: int) -> list[Vector]:
    return [
        [segment.field(factorial(j)) * c for c in vector]
        for j, vector in enumerate(segment.series(highest))
    ]


def _row(entries: Iterable[sp.Expr]) -> sp.ImmutableMatrix:
    return sp.ImmutableMatrix([list(entries)])

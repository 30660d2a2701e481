"""Bernstein and power form as formulas, compiled to tapes that run on any number of rows."""

from __future__ import annotations

from functools import lru_cache
from math import comb

import numpy as np
import sympy as sp

from ..tape.runner import CHUNK, Plan, Runner
from ..tape.tape import Tape, compile_tape


@lru_cache(maxsize=256)
def point_tape(degree: int, columns: int, rational: bool, horner: bool) -> Tape:
    """Return the tape of a point at u, from coefficients in the order c_{0,0}, c_{0,1}, ...

    Horner's rule takes the coefficients of 1, u, ..., u^n. The Bernstein form takes control
    points; its error does not grow with the degree (Volk and Schumaker, CAGD 1986). The last
    column of a rational curve is its denominator.
    """
    u = sp.Symbol("u")
    names = [sp.symbols(f"c{k}_:{columns}") for k in range(degree + 1)]
    form = _horner if horner else _bernstein
    values = [form(column, u) for column in zip(*names, strict=True)]
    if rational:
        values = [value / values[-1] for value in values[:-1]]
    return compile_tape({"point": values}, [*sum(names, ()), u])


@lru_cache(maxsize=256)
def point_plan(degree: int, columns: int, rational: bool, horner: bool, one: bool) -> Plan:
    """Return the plan of `point_tape` at arrays of u, for the coefficients of one segment.

    Or else of many: then they are fetched, as arrays like u.
    """
    tape = point_tape(degree, columns, rational, horner)
    count = (degree + 1) * columns
    return Plan(tape, [() if one else (1,)] * count + [(1,)], () if one else range(count))


def _horner(coefficients: tuple[sp.Symbol, ...], u: sp.Symbol) -> sp.Expr:
    value = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        value = value * u + coefficient
    return value


def _bernstein(points: tuple[sp.Symbol, ...], u: sp.Symbol) -> sp.Expr:
    """Return sum C(n, i) u^i (1 - u)^(n - i) P_i, with powers of 1 - u taken along the way."""
    n, v = len(points) - 1, 1 - u
    value, power = points[0], sp.S.One
    for i in range(1, n + 1):
        power = power * u
        value = value * v + comb(n, i) * points[i] * power
    return value


def values_at(rows: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Return the value of every row (m, n + 1, columns) at its own u, shape (m, columns).

    >>> values_at(np.array([[[0.0], [2.0], [0.0]], [[0.0], [1.0], [2.0]]]), np.array([0.5, 0.25]))
    array([[1. ],
           [0.5]])
    """
    count, points, columns = rows.shape
    out = np.empty((columns, count))
    table = rows.reshape(count, points * columns).T
    plan = point_plan(points - 1, columns, False, False, False)
    for start in range(0, count, CHUNK):
        part = slice(start, start + CHUNK)
        coefficients = [lambda into, row=row: row for row in table[:, part]]
        Runner(plan, len(u[part])).run([*coefficients, u[part]], out[:, part])
    return out.T

"""The spline families and the laws that each of them owes; `test_laws.py` calls them in.

A new family joins by a line in `FAMILIES` in `symbolic/__init__.py` and one here. What a family
does not owe is left out on purpose: a cardinal spline leaves the convex hull, so no positivity.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy import Rational as R

from symbolic import (
    Basis,
    bezier,
    cardinal,
    catmull_rom,
    chord_knots,
    hermite,
    kochanek_bartels,
    lagrange,
    monomial,
    uniform_bspline,
)

ALWAYS = {"derivation", "partition of unity", "affine invariance", "conventions", "identify"}
"""Owed by all: the weights of points sum to one, the curve moves along with its geometry."""


@dataclass(frozen=True)
class Family:
    """Instances of a family, and what holds for each of them."""

    bases: Sequence[Basis]
    laws: set[str]
    ends: Callable[[Basis], tuple[str, str]] | None = None
    reversed: Callable[[list[Any]], list[Any]] | None = None  # the geometry of c(1 - t)


def first_and_last(basis):
    return basis.geometry[0].name, basis.geometry[-1].name


def turned(rows):
    """The r-th derivatives at the two ends change places, and sign if r is odd."""
    return [[(-1) ** (i // 2) * x for x in rows[i ^ 1]] for i in range(len(rows))]


T, C, B, a, b = sp.symbols("T C B a b")
POINTS = [[0, 0], [1, 2], [3, 1], [4, 7]]
OWED = {
    "Bezier": Family(
        [bezier(n) for n in (1, 2, 3, 4, 7, 12)],
        ALWAYS | {"ends", "symmetry", "positivity", "round trip"},
        first_and_last, lambda rows: rows[::-1]),
    "Hermite": Family(
        [hermite(n) for n in (1, 3, 5, 7, 11)],
        ALWAYS | {"ends", "symmetry", "round trip"}, lambda basis: ("P0", "P1"), turned),
    "monomial": Family([monomial(n) for n in (1, 2, 3, 7, 12)], ALWAYS | {"round trip"}),
    "Lagrange": Family(
        [*(lagrange([R(i, n) for i in range(n + 1)]) for n in (1, 2, 3, 7, 12)),
         lagrange([0, sp.sqrt(2) / 3, 1 - sp.sqrt(2) / 3, 1]), lagrange([0, sp.Symbol("a"), 1])],
        ALWAYS | {"ends", "round trip"}, first_and_last),
    "uniform B-spline": Family(
        [uniform_bspline(n) for n in (1, 2, 3, 4, 7, 12)],
        ALWAYS | {"symmetry", "positivity", "round trip"}, reversed=lambda rows: rows[::-1]),
    "Catmull-Rom": Family(
        [catmull_rom(), catmull_rom([0, 2, 3, 5]), catmull_rom([-a, 0, 1, 1 + b]),
         catmull_rom(chord_knots(POINTS, 1))],
        ALWAYS | {"ends", "round trip"}, lambda basis: ("P1", "P2")),
    "cardinal": Family(
        [cardinal(T), cardinal(R(1, 3)), cardinal(-1)],
        ALWAYS | {"ends", "symmetry", "round trip"},
        lambda basis: ("P1", "P2"), lambda rows: rows[::-1]),
    "Kochanek-Bartels": Family(
        [kochanek_bartels(T, C, B), kochanek_bartels(R(1, 2), -1, R(1, 3)),
         kochanek_bartels(0, sp.sqrt(2), 0)],
        ALWAYS | {"ends"}, lambda basis: ("P1", "P2")),
}  # fmt: skip


def owing(law):
    """Return every family and instance that owes a law, as pairs."""
    return [(family, basis) for family in OWED.values() if law in family.laws
            for basis in family.bases]  # fmt: skip

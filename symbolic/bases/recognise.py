"""Bases that could have a given matrix: by their columns, tangents, or the inverse's rows.

Nothing here has to be certain: whoever asks compares each candidate's matrix with the given one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import count
from math import factorial
from typing import Any

from sympy import prime
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError

from ..errors import BadValue
from .basis import Basis
from .bezier import bezier
from .catmull_rom import catmull_rom
from .constraints import Condition, row_of_powers
from .from_constraints import basis_from
from .hermite import hermite
from .kochanek_bartels import cardinal, kochanek_bartels
from .lagrange import lagrange
from .monomial import monomial
from .uniform_bspline import uniform_bspline

Candidate = tuple[int, Basis, tuple[str, ...]]
"""Its rank (0 is most specific), a basis, and the names of G in the order of the columns."""

_FIXED, _CARDINAL, _KNOTS, _KOCHANEK_BARTELS, _LAGRANGE, CONSTRAINTS = range(0, 60, 10)


def candidates(matrix: DomainMatrix) -> Iterator[Candidate]:
    """Yield bases for a square matrix M of c(t) = [t^n ... t 1] M G, with any order of columns.

    >>> from symbolic.exact_matrix import dense
    >>> (_, basis, order), = candidates(dense([[1, -1], [-1, 2]]))
    >>> basis, order
    (<Lagrange basis with nodes 2, 1: degree 1, G = (P0, P1)>, ('P0', 'P1'))
    """
    fixed = list(_fixed(matrix))
    yield from fixed
    if matrix.shape[0] == 4:
        along = ("P0", "P1", "P2", "P3")
        for rank, basis, order in _through_inner_points(matrix):
            # The Bernstein matrix with its points exchanged is one too, by a coincidence.
            if order == along or not fixed:
                yield rank, basis, order
    if _conditions(_at_a_sample(matrix)):
        yield from _given_by_conditions(_conditions(matrix))


def _fixed(matrix: DomainMatrix) -> Iterator[Candidate]:
    """Yield the families without parameters that have the same columns in some order."""
    n = matrix.shape[0] - 1
    families = [bezier(n), uniform_bspline(n), monomial(n)]
    families += [hermite(n)] if n % 2 else []
    families += [catmull_rom()] if n == 3 else []
    for rank, basis in enumerate(families, _FIXED):
        given, known = matrix.unify(basis.coefficients)
        columns, wanted = _columns(known), _columns(given)
        places = [columns.index(column) for column in wanted if column in columns]
        if sorted(places) == list(range(n + 1)):
            yield rank, basis, tuple(basis.geometry[i].name for i in places)


def _columns(matrix: DomainMatrix) -> list[list[Any]]:
    return matrix.transpose().to_list()


def _through_inner_points(matrix: DomainMatrix) -> Iterator[Candidate]:
    """Yield cubics from P1 to P2 whose tangents there are combinations of three neighbours."""
    field = matrix.domain
    cubes, squares, start, at_0 = matrix.to_list()
    at_1 = [sum(column, field.zero) for column in _columns(matrix)]
    end = [3 * a + 2 * b + c for a, b, c in zip(cubes, squares, start, strict=True)]
    p1, p2 = _unit(at_0, field.one), _unit(at_1, field.one)
    if p1 is None or p2 is None or p1 == p2:
        return
    # Where P0 and P3 have no influence, P0 is the column next to P1.
    rest = sorted({0, 1, 2, 3} - {p1, p2}, key=lambda i: abs(i - p1))
    for p0, p3 in (rest, rest[::-1]):
        if not start[p3] and not end[p0]:
            names = {p0: "P0", p1: "P1", p2: "P2", p3: "P3"}
            order = tuple(names[i] for i in range(4))
            tangents = (-start[p0], start[p2], -end[p1], end[p3])
            for rank, make in _with_tangents(field, *tangents):
                try:
                    yield rank, make(), order
                except BadValue:  # knots that do not increase, parameters named as points
                    continue
            return


def _unit(row: Sequence[Any], one: Any) -> int | None:
    """Return the place of the one in a row of zeros and a one."""
    places = [i for i, entry in enumerate(row) if entry]
    return places[0] if len(places) == 1 and _same(row[places[0]], one) else None


def _same(a: Any, b: Any) -> bool:
    """Compare two elements: over algebraic numbers equal quotients may be written differently."""
    return not (a - b)


def _with_tangents(
    field: Any, x: Any, y: Any, z: Any, w: Any
) -> Iterator[tuple[int, Callable[[], Basis]]]:
    """Solve for parameters: c'(0) = x (P1 - P0) + y (P2 - P1), c'(1) = z (P2 - P1) + w (P3 - P2).

    Kochanek-Bartels has x + y + z + w = 2 (1 - T), x + z = (1 - T)(1 + B), x + w = (1 - T)(1 + C),
    which fit each of them if x y = z w. Catmull-Rom with the gaps a, 1, d has y = a/(1 + a) and
    z = d/(1 + d); the others fit if x y = (1 - y)^2 and w z = (1 - z)^2.
    """
    half = (x + y + z + w) / 2  # 1 - T
    tension = field.to_sympy(field.one - half)
    cardinals = _same(x, y) and _same(y, z) and _same(z, w)
    if cardinals:
        yield _CARDINAL, partial(cardinal, tension)
    if half and _same(x * y, z * w):
        continuity, bias = (field.to_sympy(pair / half - field.one) for pair in (x + w, x + z))
        yield _KOCHANEK_BARTELS, partial(kochanek_bartels, tension, continuity, bias)
    elif not any((x, y, z, w)):
        yield _KOCHANEK_BARTELS, partial(kochanek_bartels, 1, 0, 0)
    one = field.one
    fits = _same(x * y, (one - y) ** 2) and _same(w * z, (one - z) ** 2)
    if fits and x and w and not cardinals:
        knots = (-y / (one - y), field.zero, one, one / (one - z))
        yield _KNOTS, partial(catmull_rom, [field.to_sympy(knot) for knot in knots])


def _given_by_conditions(conditions: Sequence[Condition]) -> Iterator[Candidate]:
    """Yield the basis of which every entry of G is a value or derivative."""
    try:
        if any(condition.order for condition in conditions):
            name = f"basis from {', '.join(map(str, conditions))}"
            rank, basis = CONSTRAINTS, basis_from(conditions, name=name)
        else:
            rank, basis = _LAGRANGE, lagrange([condition.at for condition in conditions])
    except BadValue:  # equal nodes, or roots of too high a degree
        return
    yield rank, basis, tuple(entry.name for entry in basis.geometry)


def _conditions(matrix: DomainMatrix) -> list[Condition]:
    """Return what the rows of the inverse say about the coefficients; nothing if one says nothing.

    >>> from symbolic.exact_matrix import dense
    >>> print(*_conditions(dense([[1, -1], [0, 1]])))
    c(1) c(0)
    """
    conditions = [_condition(row[::-1], matrix.domain) for row in _inverse_up_to_factors(matrix)]
    read = [condition for condition in conditions if condition is not None]
    return read if len(read) == len(conditions) else []


def _inverse_up_to_factors(matrix: DomainMatrix) -> list[list[Any]]:
    """Return the rows of the inverse, each times some factor; none if there is no inverse.

    Rational functions are inverted as polynomials: in their field every sum looks for a divisor.
    """
    try:
        if not matrix.domain.is_FractionField:
            return list(matrix.inv().to_list())
        _, polynomials = matrix.transpose().clear_denoms_rowwise(convert=True)
        inverse, _ = polynomials.transpose().inv_den()
        return list(inverse.convert_to(matrix.domain).to_list())
    except DMNonInvertibleMatrixError:
        return []


def _at_a_sample(matrix: DomainMatrix) -> DomainMatrix:
    """Return the matrix with numbers for its symbols: what holds for all numbers, holds for these.

    The numbers are arbitrary; should a denominator vanish for them, others are taken.
    """
    field = matrix.domain
    if not field.is_FractionField:
        return matrix
    entries = matrix.to_list_flat()
    for shift in count(2):
        numbers = [field.domain.convert(prime(k + shift) ** 2) for k in range(field.ngens)]
        denominators = [entry.denom(*numbers) for entry in entries]
        if all(denominators):
            values = [e.numer(*numbers) / d for e, d in zip(entries, denominators, strict=True)]
            return DomainMatrix.from_list_flat(values, matrix.shape, field.domain).to_dense()
    raise AssertionError("a denominator that vanishes everywhere")


def _condition(row: Sequence[Any], field: Any) -> Condition | None:
    """Read a row over the coefficients of 1, t, t^2, ... as a derivative, up to a factor.

    The r-th derivative at a has r! for t^r, its first entry, and then (r + 1)! a.
    """
    order = next((k for k, entry in enumerate(row) if entry), None)
    if order is None:
        return None
    last = order == len(row) - 1  # the same everywhere: call it the derivative at 0
    at = field.zero if last else row[order + 1] / row[order] / (order + 1)
    factor = row[order] / factorial(order)
    expected = row_of_powers(at, order, len(row) - 1, field.zero, field.one)[::-1]
    same = all(_same(factor * a, b) for a, b in zip(expected, row, strict=True))
    return Condition(field.to_sympy(at), order) if same else None

"""The verdict on two given segments: the exact orders C^k and G^k of their joint."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from math import factorial
from typing import Any, NamedTuple

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..dag import postorder, substitute
from ..exact import Point, as_list, by_name, exact
from ..proofs.verdict import Undecided
from ..signs import sign
from .contact import first_not_zero, multiple, reparametrization
from .derivation import joint_derivation
from .joint import Continuity, Order
from .segments import Segment, Vector, read_segments

HIGHEST_ORDER = 144  # contact is followed so far: two curves of degree 12
HIGHEST_ORDER_WITH_SYMBOLS = 8


def continuity_at(left: Any, right: Any, ratio: Any = 1) -> Continuity:
    r"""Return how smoothly two segments join, exactly: the order of C^k and that of G^k.

    C^k: right^(j)(0) = ratio^j left^(j)(1) for j <= k. G^k: the same after a change of parameter
    with a positive first derivative. Where a first derivative is zero the one-sided unit tangents
    decide on G^1, and C^1 does not imply it; above order 1 such a joint is Undecided.

    Parameters
    ----------
    left, right : rows of control points, or tuples of coordinates as expressions in t
        Bezier segments of any degree >= 1, or polynomial or rational curves over [0, 1]; the left
        one is met at t = 1, the right one at t = 0. With symbols, the orders are those for all
        their values but exceptional ones.
    ratio : number or expression
        The length of the right parameter interval by that of the left one, positive; a symbol is
        taken to be.

    Raises
    ------
    BadValue
        For different dimensions, a single point, complex coordinates, curves not defined at the
        joint, a ratio that is not positive.
    BadType, NotExact
        For what cannot be read as a segment, and for floats.

    Notes
    -----
    G^oo is certain after finitely many orders. Two different branches of algebraic curves of
    degrees m and n meet with multiplicity m n at most (Bezout), so they are not G^(m n).
    B. Barsky and T. DeRose, *Geometric continuity of parametric curves*, IEEE CG&A 9(6), 1989.

    Examples
    --------
    >>> joint = continuity_at([[0, 0], [1, 1], [2, 1]], [[2, 1], [4, 1], [5, 0]])
    >>> for sentence in str(joint).split(". "):
    ...     print(sentence)
    The segments meet: C^0
    The derivatives of order 1 differ by (2, 0)
    The unit tangents agree: G^1, not G^2.
    >>> joint.parametric, joint.geometric, joint.betas
    (0, 1, (2,))
    >>> t = sp.Symbol("t")
    >>> cusp = continuity_at(((t - 1)**2, (t - 1)**3), (t**2, t**3))
    >>> cusp.parametric, cusp.geometric, cusp.tangents
    (oo, 0, ((-1, 0), (1, 0)))
    """
    before, after, scale = read_segments(left, right, ratio)
    field, same = before.field, _order_of_identity(before, after)
    highest = max(same, _order_to_follow(before, after))
    p, q = before.series(highest), after.series(highest)
    differences = _differences(p[: same + 1], q, scale, field)
    failing = next((j for j, row in enumerate(differences) if any(row)), None)
    incoming, outgoing = _direction(p, left=True), _direction(q, left=False)
    signs = _Signs(scale, field, _declared_positive([left, right, ratio]))
    turn = _turn(incoming, outgoing, signs)
    geometric: Order | Undecided = -1
    least: Order = -1
    betas: list[Any] = []
    if failing != 0:
        geometric, least, betas = _geometric(before, after, p, q, turn)
    return Continuity(
        sp.oo if failing is None else failing - 1,
        geometric,
        least,
        tuple(_point(row, field) for row in differences),
        _point(betas, field),
        _tangents(incoming, outgoing, turn, field),
        partial(
            joint_derivation, left=before.given, right=after.given, ratio=field.to_sympy(scale)
        ),
    )


def _turn(incoming: Vector | None, outgoing: Vector | None, signs: _Signs) -> Turn | None:
    if incoming is None or outgoing is None:
        return None
    factor = multiple(outgoing, incoming, signs.field)
    return Turn(factor, None if factor is None else signs.of(factor))


def _geometric(
    before: Segment,
    after: Segment,
    p: Sequence[Vector],
    q: Sequence[Vector],
    turn: Turn | None,
) -> tuple[Order | Undecided, Order, list[Any]]:
    """Return the geometric order of segments that meet, what is certain of it, and the betas."""
    field = before.field
    if turn is None:
        return Undecided("a segment that is a single point has no tangent"), 0, []
    factor = turn.factor
    if factor is None or turn.sign == -1:
        return 0, 0, []
    if turn.sign is None:
        return Undecided(f"the sign of {field.to_sympy(factor)} decides on G^1"), 0, []
    if not (any(p[1]) and any(q[1])):
        return Undecided("a first derivative is zero at the joint"), 1, []
    shown = max(before.degree, after.degree)
    same = _order_of_identity(before, after)
    if not any(map(any, _differences(p[: same + 1], q, factor, field))):
        return sp.oo, sp.oo, [factor, *[field.zero] * (shown - 1)]
    highest = _order_to_follow(before, after)
    phi = reparametrization(
        p, q, field, highest, before.degree if before.is_polynomial else highest
    )
    betas = [field(factorial(j)) * c for j, c in enumerate(phi, 1)]
    if len(phi) < highest:
        return len(phi), len(phi), betas
    if highest == before.degree * after.degree:
        return sp.oo, sp.oo, betas[:shown]
    return Undecided(f"contact was followed up to order {highest} only"), highest, betas[:shown]


def _order_of_identity(before: Segment, after: Segment) -> int:
    """Curves that agree up to this order are the same: a difference cannot have so many zeros."""
    degrees = before.degree, after.degree
    return max(degrees) if before.is_polynomial and after.is_polynomial else sum(degrees)


def _order_to_follow(before: Segment, after: Segment) -> int:
    most = HIGHEST_ORDER_WITH_SYMBOLS if before.field.is_FractionField else HIGHEST_ORDER
    return min(most, before.degree * after.degree)


def _differences(
    p: Sequence[Vector], q: Sequence[Vector], scale: Any, field: Domain
) -> list[Vector]:
    """Return the derivatives q^(j)(0) - scale^j p^(j)(1)."""
    power, found = field.one, []
    for j, (a, b) in enumerate(zip(p, q, strict=False)):
        found.append([field(factorial(j)) * (y - power * x) for x, y in zip(a, b, strict=True)])
        power *= scale
    return found


def _direction(series: Sequence[Vector], left: bool) -> Vector | None:
    """Return a vector along the one-sided tangent, in the direction of travel; None for a point.

    Near the joint, p'(1 - s) is (-s)^(m-1) times the first derivative p^(m)(1) that is not zero.
    """
    order = first_not_zero(series)
    if order is None:
        return None
    return [-c for c in series[order]] if left and order % 2 == 0 else series[order]


def _tangents(
    incoming: Vector | None, outgoing: Vector | None, turn: Turn | None, field: Domain
) -> tuple[Point | None, Point | None]:
    """Return the unit tangents; equal and opposite ones are equal and opposite expressions."""
    before, after = _unit(incoming, field), _unit(outgoing, field)
    if turn and turn.sign and before:
        after = tuple(turn.sign * c for c in before)
    return before, after


def _unit(direction: Vector | None, field: Domain) -> Point | None:
    if direction is None:
        return None
    length = sp.sqrt(field.to_sympy(sum((c * c for c in direction), field.zero)))
    return tuple(field.to_sympy(c) / length for c in direction)


def _point(vector: Vector, field: Domain) -> Point:
    return tuple(field.to_sympy(c) for c in vector)


class Turn(NamedTuple):
    """The direction after a joint is `factor` times that before it; None if it is no multiple."""

    factor: Any | None
    sign: int | None


class _Signs(NamedTuple):
    """How signs are told: the ratio is positive, and symbols may be declared to be."""

    ratio: Any
    field: Domain
    declared: dict[sp.Symbol, sp.Symbol]

    def of(self, value: Any) -> int | None:
        if not value - self.ratio:
            return 1
        number = self.field.to_sympy(value)
        found = sign(number)
        if found is None:
            number = substitute([number], self.declared)[0]
            return 1 if number.is_positive else -1 if number.is_negative else None
        return found


def _declared_positive(values: Any) -> dict[sp.Symbol, sp.Symbol]:
    entries = as_list(values)
    if entries is None:
        nodes = postorder([exact(values)])
        return {by_name(node): node for node in nodes if node.is_Symbol and node.is_positive}
    return {plain: s for entry in entries for plain, s in _declared_positive(entry).items()}

"""Knot vectors: where the polynomial pieces of a spline meet, and how often each knot counts."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..bases.degree import degree_from
from ..errors import BadValue, OutsideDomain, shown
from ..exact import by_name, exact, whole_number
from ..fields import common_field
from ..signs import sign
from .knot_order import in_order, read_knots


@dataclass(frozen=True, init=False, repr=False)
class KnotVector:
    r"""Knots u_0 <= u_1 <= ... <= u_m of splines of degree p, with m = n + p + 1.

    There are n + 1 control points; the domain is [u_p, u_{n+1}]. The spans [u_j, u_{j+1}) are
    half-open, the last one of the domain is closed. Knots with symbols are assumed to increase as
    written wherever their order cannot be decided; equal ones are one multiple knot.

    Parameters
    ----------
    knots : list of exact numbers or expressions, at least 2p + 2 of them
    degree : int >= 0

    Raises
    ------
    BadValue
        For decreasing knots, too few, more than p + 1 equal ones, a domain of length zero, knots
        that are not real, or that contain the parameter t.
    BadType, NotExact
        As in `exact`.

    Notes
    -----
    de Boor, *A Practical Guide to Splines*, chapter IX. Some books leave out the first and the
    last knot, which influence no curve on the domain.

    Examples
    --------
    >>> KnotVector([0, 0, 0, 1, 2, 2, 2], 2)
    <KnotVector of degree 2: 0, 0, 0, 1, 2, 2, 2; 4 control points, domain [0, 2]>
    """

    knots: tuple[sp.Expr, ...]
    degree: int

    def __init__(self, knots: Any, degree: Any) -> None:
        p = degree_from(degree, 0)
        read = read_knots(knots, p)
        object.__setattr__(self, "degree", p)
        object.__setattr__(self, "knots", in_order(read))
        self._refuse_multiplicity()
        if self.knots[p] == self.knots[len(read) - p - 1]:
            raise BadValue(
                "a domain [u_p, u_{n+1}] of positive length",
                f"u_{p} = u_{len(read) - p - 1} = {self.knots[p]}",
                "Add a larger knot.",
            )

    @cached_property
    def _elements(self) -> tuple[Domain, tuple[Any, ...]]:
        field, elements = common_field(self.knots)
        return field, tuple(elements)

    @property
    def field(self) -> Domain:
        """The smallest field that holds the knots."""
        return self._elements[0]

    @property
    def elements(self) -> tuple[Any, ...]:
        """The knots as elements of `field`."""
        return self._elements[1]

    @property
    def point_count(self) -> int:
        """The number n + 1 of control points: len(knots) - degree - 1."""
        return len(self.knots) - self.degree - 1

    @property
    def domain(self) -> tuple[sp.Expr, sp.Expr]:
        """The interval [u_p, u_{n+1}] on which the functions sum to one."""
        return self.knots[self.degree], self.knots[self.point_count]

    @cached_property
    def spans(self) -> tuple[int, ...]:
        """The indices j of the spans [u_j, u_{j+1}] in the domain that are not empty."""
        return tuple(j for j in self.all_spans if self.degree <= j < self.point_count)

    @cached_property
    def all_spans(self) -> tuple[int, ...]:
        """The same for the whole knot vector; outside the domain functions are missing."""
        u = self.knots
        return tuple(j for j in range(len(u) - 1) if u[j] != u[j + 1])

    def interval(self, span: Any) -> tuple[sp.Expr, sp.Expr]:
        """Return the ends u_j, u_{j+1} of a span of the domain that is not empty.

        Raises
        ------
        BadValue
            If the index j is not in `spans`.
        """
        j = whole_number(span)
        if j is None or j not in self.spans:
            raise BadValue(
                f"the index of a non-empty span of the domain: {', '.join(map(str, self.spans))}",
                shown(span),
                "Span j runs from u_j to u_{j+1}.",
            )
        return self.knots[j], self.knots[j + 1]

    def multiplicity(self, t: Any) -> int:
        """Return how many knots equal t; 0 where t is no knot.

        >>> KnotVector([0, 0, 1, 1, 2, 2], 1).multiplicity(1)
        2
        """
        at = by_name(exact(t))
        if at in self.knots:  # equal knots are stored as one expression
            return self.knots.count(at)
        return sum(1 for knot in self.knots if sign(at - knot) == 0)

    def continuity(self, t: Any) -> Any:
        """Return the order k of continuity C^k that a multiplicity leaves: degree - multiplicity.

        -1 means that the spline may jump; where t is no knot, it is one polynomial: oo.

        >>> KnotVector([0, 0, 0, 1, 1, 2, 2, 2], 2).continuity(1)
        0
        """
        count = self.multiplicity(t)
        return self.degree - count if count else sp.oo

    def greville(self) -> tuple[sp.Expr, ...]:
        """Return the Greville abscissae (u_{i+1} + ... + u_{i+p}) / p, one per control point.

        With them as control points the curve is t itself. Degree 0 has the middle of each span.

        >>> KnotVector([0, 0, 0, 1, 2, 2, 2], 2).greville()
        (0, 1/2, 3/2, 2)
        """
        p, u = self.degree, self.elements
        windows = [u[i + 1 : i + p + 1] if p else u[i : i + 2] for i in range(self.point_count)]
        field = self.field
        return tuple(field.to_sympy(sum(w, field.zero) / field(len(w))) for w in windows)

    def span(self, t: Any) -> int:
        """Return the index j of the span u_j <= t < u_{j+1}; at the domain's end the last one.

        Raises
        ------
        OutsideDomain
            If t lies outside the domain.
        BadValue
            If symbols leave it open where t lies.

        Examples
        --------
        >>> knots = KnotVector([0, 0, 0, 1, 2, 2, 2], 2)
        >>> knots.span(0), knots.span(1), knots.span(2)
        (2, 3, 3)
        """
        return min(self.index_before(t), self.spans[-1])

    def index_before(self, t: Any) -> int:
        """Return the largest k with u_k <= t, for t in the domain; errors as in `span`."""
        at = by_name(exact(t))
        signs = self._sides(at)
        first, last = self.degree, self.point_count
        if signs[first] == -1 or signs[last] == 1:
            raise OutsideDomain(
                f"a parameter in the domain [{self.domain[0]}, {self.domain[1]}]",
                shown(at),
                "Only there do the basis functions sum to one.",
            )
        if None in signs[first : last + 1]:
            raise BadValue(
                "a parameter whose place among the knots is known",
                f"{shown(at)} among {', '.join(map(str, self.knots))}",
                "Say in which span it lies (span=...), or take a knot itself.",
            )
        return max(k for k, s in enumerate(signs) if s is not None and s >= 0)

    def place_of(self, t: Any, span: Any = None) -> int:
        """Return the index of the last knot before a new knot t: that of its span, if given."""
        if span is None:
            return self.index_before(t)
        start, end = self.interval(span)
        at = by_name(exact(t))
        if sign(at - start) == -1 or sign(end - at) in (-1, 0):
            raise BadValue(
                f"a parameter in the span [{start}, {end})", shown(at), "Leave out the span."
            )
        return int(span)

    def _sides(self, at: sp.Expr) -> list[int | None]:
        """Return the sign of t - u_k for every knot, filled in from the knots around it."""
        signs = [sign(at - knot) for knot in self.knots]
        known = [k for k, s in enumerate(signs) if s is not None]
        for k, s in enumerate(signs):
            # Right of some knot means right of all before it; of those equal to it, too.
            if s is None and any(i > k and (signs[i] or 0) >= 0 for i in known):
                signs[k] = 1
            elif s is None and any(i < k and (signs[i] or 0) <= 0 for i in known):
                signs[k] = -1
        return signs

    def insert(self, t: Any, times: int = 1, span: Any = None) -> KnotVector:
        """Return the knot vector with t inserted so many times.

        A symbol whose place is not known is taken to lie inside the span given.

        Raises
        ------
        BadValue, OutsideDomain
            As in `span`; and if a knot would occur more than degree + 1 times.

        Examples
        --------
        >>> KnotVector([0, 0, 1, 2, 2], 1).insert(1).knots
        (0, 0, 1, 1, 2, 2)
        """
        count = whole_number(times)
        if count is None or count < 0:
            raise BadValue("a number of times 0, 1, 2, ...", shown(times), "Insert once or more.")
        k = self.place_of(t, span)
        at = by_name(exact(t))
        count = min(count, self.degree + 2)  # that many are refused, as more would be
        return KnotVector((*self.knots[: k + 1], *[at] * count, *self.knots[k + 1 :]), self.degree)

    def counts(self) -> dict[str, int]:
        """Return the numbers of everything, by name, with n + 1 points and order k = degree + 1.

        Spans in the domain are the non-empty ones, n - k + 2 if all knots are simple; continuity
        is the lowest at a knot inside the domain, k - 2 if they are simple.

        >>> KnotVector(range(8), 3).counts()["spans_in_domain"]
        1
        """
        n, k = self.point_count - 1, self.degree + 1
        inside = [u for u in self.knots[k:-k] if u not in self.domain]
        return {
            "control_points": n + 1,
            "degree": k - 1,
            "order": k,
            "knots": n + k + 1,
            "knot_intervals": n + k,
            "knots_outside_each_side": k - 1,
            "spans_in_domain": len(self.spans),
            "points_per_span": k,
            "spans_per_point_max": k,
            "knots_per_function": k + 1,
            "intervals_per_function": k,
            "continuity": min((int(self.continuity(u)) for u in inside), default=k - 2),
            **{f"functions_of_order_{r}": n + k + 1 - r for r in range(1, k + 1)},
        }

    def _refuse_multiplicity(self) -> None:
        for knot in dict.fromkeys(self.knots):
            if self.knots.count(knot) > self.degree + 1:
                raise BadValue(
                    f"knots of multiplicity at most degree + 1 = {self.degree + 1}",
                    f"{self.knots.count(knot)} times {knot}",
                    "More would leave a function that is zero everywhere.",
                )

    def __reduce__(self) -> tuple[type, tuple[Any, ...]]:
        return type(self), (self.knots, self.degree)  # SymPy's fields cannot be pickled

    def __repr__(self) -> str:
        a, b = self.domain
        return (
            f"<KnotVector of degree {self.degree}: {', '.join(map(str, self.knots))}; "
            f"{self.point_count} control points, domain [{a}, {b}]>"
        )

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle \mathbf u = {sp.latex(sp.Tuple(*self.knots))}$"

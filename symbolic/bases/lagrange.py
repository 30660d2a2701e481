"""Lagrange curves: the points through which a polynomial curve goes at given parameters."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache, partial
from math import prod
from typing import Any, NoReturn

import sympy as sp
from sympy.polys.domains.domain import Domain
from sympy.polys.matrices import DomainMatrix

from ..errors import BadType, BadValue, shown
from ..exact import as_list
from ..fields import common_field
from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .basis import Basis, Geometry
from .constraints import value
from .parameters import parameter_from, refuse_clash, refuse_high_roots


def lagrange(nodes: Any) -> Basis:
    r"""Return the Lagrange basis of degree n for the nodes (u_0, ..., u_n), with G = (P0, ..., Pn).

    L_i(t) = prod over j != i of (t - u_j)/(u_i - u_j). The curve goes through P_i at t = u_i.

    Parameters
    ----------
    nodes : list of n + 1 >= 2 different exact parameters
        Rational numbers, roots, or symbols other than t; symbols are assumed to differ.

    Raises
    ------
    BadValue
        If there are fewer than two nodes, or two are equal.
    BadType, NotExact
        For other things than a list of exact parameters.

    Notes
    -----
    J. L. Lagrange, 1795; Farin, *Curves and Surfaces for CAGD*, section 7.2.

    Examples
    --------
    >>> lagrange([0, 1]).functions
    (1 - t, t)
    >>> lagrange([0, sp.Rational(1, 2), 1]).curve([[0], [1], [0]])
    (-4*t**2 + 4*t,)
    """
    listed = as_list(nodes)
    if listed is None:
        raise BadType("a list of nodes", shown(nodes), "Write [0, Rational(1, 2), 1].")
    if len(listed) < 2:
        raise BadValue("at least two nodes", shown(nodes), "A line has two: [0, 1].")
    read = tuple(map(parameter_from, listed))
    refuse_clash(read, sp.symbols(f"P0:{len(read)}"))
    return _lagrange(read)


@lru_cache(maxsize=32)
def _lagrange(nodes: tuple[sp.Expr, ...]) -> Basis:
    field, elements = common_field(nodes)
    refuse_high_roots(field)
    columns = []
    for i, u in enumerate(elements):
        scale = prod((u - v for j, v in enumerate(elements) if j != i), start=field.one)
        if not scale:
            _refuse_equal(nodes, elements)
        others = elements[:i] + elements[i + 1 :]
        columns.append([c / scale for c in _with_roots(others, field)])
    size = len(nodes)
    flat = [columns[j][i] for i in range(size) for j in range(size)]
    geometry = tuple(Geometry(symbol, "point") for symbol in sp.symbols(f"P0:{size}"))
    return Basis(
        f"Lagrange basis with nodes {', '.join(map(str, nodes))}",
        geometry,
        DomainMatrix.from_list_flat(flat, (size, size), field).to_dense(),
        partial(_derivation, nodes=nodes),
    )


def _with_roots(roots: Sequence[Any], field: Domain) -> list[Any]:
    """Return the coefficients of the product of (t - u) over the roots u, highest power first."""
    result = [field.one]
    for u in roots:
        shifted, held = [*result, field.zero], [field.zero, *result]
        result = [a - u * b for a, b in zip(shifted, held, strict=True)]
    return result


def _refuse_equal(nodes: Sequence[sp.Expr], elements: Sequence[Any]) -> NoReturn:
    i, j = next(
        (i, j) for j in range(len(nodes)) for i in range(j) if not elements[i] - elements[j]
    )
    raise BadValue(
        "different nodes",
        f"{nodes[i]} as u_{i} and u_{j}",
        "A curve has one point per parameter; for a tangent there use basis_from.",
    )


def _derivation(basis: Basis, nodes: tuple[sp.Expr, ...]) -> Derivation:
    t, n = basis.parameter, basis.degree
    field, elements = common_field(nodes)
    steps = []
    for i, own in enumerate(nodes):
        numerator = times(*(t - u for u in nodes[:i] + nodes[i + 1 :]))
        differences = [elements[i] - u for u in elements[:i] + elements[i + 1 :]]
        scale = times(*map(field.to_sympy, differences))
        at_node = sp.Subs(numerator, t, own)
        steps += [
            Step(at_node, scale, f"one factor for every other node, not zero at {own}"),
            Step(times(numerator, sp.Pow(scale, -1, evaluate=False)),
                 basis.functions[i], f"scaled to one at {own}: the function L_{i} of P{i}"),
        ]  # fmt: skip
    values = sp.ImmutableMatrix([value(u).row(n) for u in nodes])
    one = sp.ImmutableMatrix(sp.eye(n + 1))
    powers = sp.ImmutableMatrix([basis.powers])
    return Derivation(
        f"{basis.name}: from the zeros to the matrix",
        (
            *steps,
            Step(times(powers, basis.matrix),
                 sp.ImmutableMatrix([basis.functions]), "their coefficients make the matrix"),
            Step(times(values, basis.matrix), one,
                 "Kronecker delta: row j has the values at node u_j, one for P_j and zero else"),
            Step(plus(*basis.functions), sp.S.One,
                 "a polynomial of degree n that is one at n + 1 nodes is one everywhere"),
        ), "Farin, Curves and Surfaces for CAGD",
    )  # fmt: skip

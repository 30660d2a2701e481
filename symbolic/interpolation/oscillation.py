"""Why one polynomial through many points is a bad idea: it oscillates, and how much."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp

from ..bases.lagrange import lagrange
from ..errors import BadValue, shown
from ..exact import PARAMETER, as_list, exact, whole_number
from ..proofs.derivation import Derivation, Step
from ..signs import sign
from ..splines.conversion import Segment
from ..written import plus

t = PARAMETER


def lebesgue_function(nodes: Any) -> tuple[Segment, ...]:
    r"""Return sum_i |L_i(t)|, how far one polynomial may swing when all its data lie in [-1, 1].

    Between two neighbouring nodes no Lagrange polynomial changes its sign, so on each span the sum
    of their absolute values is one polynomial: L_i counts with (-1)^k, k the number of nodes
    between node i and the span. It is 1 at the nodes; in between it grows like 2^n for equally
    spaced nodes, largest in the outermost spans.

    Parameters
    ----------
    nodes : increasing numbers, at least two

    Raises
    ------
    BadValue
        For nodes that do not increase, or symbols whose order is not known.

    Notes
    -----
    Trefethen, *Approximation Theory and Approximation Practice*, chapter 15.

    Examples
    --------
    >>> first, last = lebesgue_function([0, 1, 2])
    >>> first
    Segment(start=0, end=1, coordinates=(-t**2 + t + 1,))
    >>> first.coordinates[0].subs(t, sp.Rational(1, 2))
    5/4
    """
    u = [exact(node) for node in as_list(nodes) or ()]
    if len(u) < 2 or any(sign(b - a) != 1 for a, b in pairwise(u)):
        raise BadValue("two or more increasing numbers as nodes", shown(nodes), "Sort them.")
    basis = lagrange(u)
    n = len(u) - 1
    pieces = []
    for k, (start, end) in enumerate(pairwise(u)):
        signs = sp.Matrix([(-1) ** (k - i if i <= k else i - k - 1) for i in range(n + 1)])
        coefficients = basis.matrix * signs
        total = sp.Add(*(c * p for c, p in zip(coefficients, basis.powers, strict=True)))
        pieces.append(Segment(start, end, (total,)))
    return tuple(pieces)


def runge_phenomenon(n: int) -> Derivation:
    r"""Return exact figures for 1/(1 + 25 t^2), interpolated at n + 1 equally spaced nodes.

    The nodes run from -1 to 1. The last step is the error in the middle of the last span: for n = 5
    a tenth of the function's largest value, for n = 10 one and a half of it, for n = 20 forty.

    Raises
    ------
    BadValue
        If n is not a positive integer.

    Notes
    -----
    Runge, *Ueber empirische Funktionen und die Interpolation zwischen aequidistanten Ordinaten*,
    1901.

    Examples
    --------
    >>> runge_phenomenon(4).is_proved
    True
    >>> [round(float(runge_phenomenon(n).steps[-1].right), 2) for n in (5, 10, 20)]
    [-0.11, 1.53, -39.99]
    """
    degree = whole_number(n)
    if degree is None or degree < 1:
        raise BadValue("a degree 1, 2, 3, ...", shown(n), "n + 1 nodes are taken.")
    nodes = [sp.Rational(2 * i, degree) - 1 for i in range(degree + 1)]
    polynomial = lagrange(nodes).curve([[_runge(node)] for node in nodes])[0]
    middle = (nodes[-2] + nodes[-1]) / 2
    value = sp.Poly(polynomial, t).eval(middle)
    return Derivation(
        f"Runge's function and one polynomial of degree {degree}",
        (
            *(Step(sp.Subs(polynomial, t, node), _runge(node), f"the polynomial meets it at {node}")
              for node in nodes),
            Step(sp.Subs(polynomial, t, middle), value, "but in the middle of the last span"),
            Step(plus(value, -_runge(middle)), value - _runge(middle),
                 "less the function itself: its error there"),
        ), "Runge 1901",
    )  # fmt: skip


def _runge(x: sp.Expr) -> sp.Expr:
    return 1 / (1 + 25 * x**2)

"""The connection matrix: how a change of parameter acts on derivatives (chain rule of any order).

Where the next segment is q(u) = p(phi(u)) near the joint u = 0, with phi(0) = 1 and the
derivatives beta_1, beta_2, ... of phi, its derivatives are those of p times one lower triangular
matrix. Its entries are Bell polynomials (formula of Faa di Bruno); they are read off here from
the powers of the series phi(u) - 1 = beta_1 u + beta_2 u^2/2! + ...
"""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain

from ..fields import common_field
from .parameters import read_betas, read_order

Rows = list[list[Any]]


def connection_matrix(k: int, betas: Any) -> sp.ImmutableMatrix:
    r"""Return the matrix M with (q, q', ..., q^(k))(0) = M (p, p', ..., p^(k))(1).

    M_00 = 1 and M_ji = sum_m C(j-1, m-1) beta_m M_(j-m)(i-1): q' = beta1 p',
    q'' = beta1^2 p'' + beta2 p', q''' = beta1^3 p''' + 3 beta1 beta2 p'' + beta3 p', ...

    Parameters
    ----------
    k : int >= 0
    betas : (beta1, ..., betak)
        The derivatives of p's parameter by q's parameter at the joint, in the convention of
        Barsky and DeRose; beta1 > 0. Symbols may be used; one as beta1 is taken to be positive.

    Returns
    -------
    ImmutableMatrix, shape (k + 1, k + 1)
        Row j belongs to q^(j), column i to p^(i).

    Raises
    ------
    BadValue, BadType, NotExact
        For a negative order, another number of betas than k, or beta1 <= 0.

    Notes
    -----
    B. Barsky and T. DeRose, *Geometric continuity of parametric curves*, IEEE CG&A 9(6), 1989.

    Examples
    --------
    >>> connection_matrix(3, sp.symbols("b1:4"))
    Matrix([
    [1,  0,       0,     0],
    [0, b1,       0,     0],
    [0, b2,   b1**2,     0],
    [0, b3, 3*b1*b2, b1**3]])
    """
    order = read_order(k)
    field, given = common_field(read_betas(order, betas))
    rows = chain_rows(given, field)
    return sp.ImmutableMatrix(
        order + 1, order + 1, lambda j, i: field.to_sympy(rows[j][i]) if i <= j else sp.S.Zero
    )


def chain_rows(betas: Sequence[Any], field: Domain) -> Rows:
    """Return the rows of the connection matrix for betas in a field, row j with j + 1 entries."""
    phi = [field.zero, *(b / field(factorial(m)) for m, b in enumerate(betas, 1))]
    powers: Rows = []
    while len(powers) < len(phi):
        powers.append(next_powers(powers, phi, field))
    return [
        [c * field(factorial(j) // factorial(i)) for i, c in enumerate(row)]
        for j, row in enumerate(powers)
    ]


def next_powers(powers: Rows, phi: Sequence[Any], field: Domain, highest: int = 10**9) -> list[Any]:
    """Return the coefficients of u^j in phi^0, phi^1, ..., phi^j, given those of the lower u^j.

    >>> list(map(int, next_powers([[1], [0, 2]], [0, 2, 3], sp.QQ)))
    [0, 3, 4]
    """
    j = len(powers)
    if j == 0:
        return [field.one]
    row = [field.zero, phi[j]]
    for i in range(2, min(j, highest) + 1):
        row.append(sum((phi[m] * powers[j - m][i - 1] for m in range(1, j - i + 2)), field.zero))
    return row

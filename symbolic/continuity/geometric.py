"""Geometric continuity G^k: parametric continuity after a change of one segment's parameter."""

from __future__ import annotations

from math import comb, perm
from typing import Any

import sympy as sp

from ..proofs.derivation import Derivation, Step
from ..written import plus, times
from .conditions import JointConditions, derivative_steps, difference, solution_steps
from .connection import connection_matrix
from .parameters import read_betas, read_degree, read_order, refuse_names


def geometric_continuity(n: int, k: int, betas: Any) -> JointConditions:
    r"""Return the conditions for a G^k joint of two Bezier segments of degree n.

    q^(j)(0) = M_j1 p'(1) + ... + M_jj p^(j)(1), with the connection matrix M of the betas (see
    `connection_matrix`). A joint of segments with p'(1) != 0 is G^k if they hold for some betas
    with beta1 > 0.

    Parameters
    ----------
    n : int >= 1
    k : int, 0 <= k <= n
    betas : (beta1, ..., betak)
        The derivatives of p's parameter by q's, q' = beta1 p', q'' = beta1^2 p'' + beta2 p', ...
        (Barsky and DeRose); beta1 > 0. The betas (ratio, 0, ..., 0) are C^k.

    Raises
    ------
    BadValue, BadType, NotExact
        For a degree or order out of range, another number of betas than k, beta1 <= 0, and
        betas that use t or the names of the control points.

    Notes
    -----
    B. Barsky and T. DeRose, *Geometric continuity of parametric curves*, IEEE CG&A 9(6), 1989.

    Examples
    --------
    >>> b1, b2 = sp.symbols("b1 b2")
    >>> print(geometric_continuity(3, 2, (b1, b2)))
    Q0 = P3
    -Q0 + Q1 = b1*(-P2 + P3)
    Q0 - 2*Q1 + Q2 = b1**2*(P1 - 2*P2 + P3) + b2*(-P2 + P3)/2
    >>> geometric_continuity(3, 2, (b1, b2)).derivation.is_proved
    True
    """
    degree = read_degree(n)
    order = read_order(k, degree)
    joint = JointConditions(degree, order, read_betas(order, betas), _derivation)
    refuse_names(joint.betas, [*joint.given, *joint.next])
    return joint


def _derivation(joint: JointConditions) -> Derivation:
    n, k = joint.degree, joint.order
    matrix = connection_matrix(k, joint.betas)
    ends = [sp.Mul(perm(n, i), difference(joint.given[n - i :])) for i in range(k + 1)]
    asked = [sp.Mul(perm(n, j), right) for j, (_, right) in enumerate(joint.conditions)]
    steps = [
        *derivative_steps(joint),
        *chain_steps(matrix, joint.betas),
        Step(times(matrix, sp.ImmutableMatrix(ends)),
             sp.ImmutableMatrix(asked),
             "the matrix times the derivatives of this segment: those asked of the next one"),
        *solution_steps(joint),
    ]  # fmt: skip
    return Derivation(
        f"G^{k} joint of Bezier segments of degree {n}",
        tuple(steps),
        "Barsky and DeRose, Geometric continuity of parametric curves, 1989",
    )


def chain_steps(matrix: sp.ImmutableMatrix, betas: tuple[sp.Expr, ...]) -> list[Step]:
    """Return one step for each row of a connection matrix, from the rows above it.

    Differentiating q' = phi' p'(phi) another j - 1 times by Leibniz' rule gives
    M_ji = sum over m of C(j-1, m-1) beta_m M_(j-m)(i-1).
    """
    steps = []
    for j in range(1, matrix.rows):
        row = [
            plus(
                *(times(comb(j - 1, m - 1), betas[m - 1], matrix[j - m, i - 1])
                  for m in range(1, j - i + 2)))
            for i in range(1, j + 1)
        ]  # fmt: skip
        steps.append(
            Step(sp.ImmutableMatrix([row]), matrix[j : j + 1, 1 : j + 1],
                 f"chain rule: derivative {j} of p(phi(u)) by derivatives of p, from the lower "
                 "ones by Leibniz' rule")
        )  # fmt: skip
    return steps

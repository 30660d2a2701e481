"""The continuity explorer's verdicts and questions, against the exact verdict on a joint."""

import itertools

import numpy as np
import pytest
import sympy as sp

from symbolic import BadValue, continuity_at
from tests.widgets.explored import inputs, verdicts
from widgets import explore

JOINTS = {
    "not even G^1": [[5, 3], [6, 3], [8, 3], [9, 5]],
    "G^1 only": [[5, 3], [6, 2.5], [8, 3], [9, 5]],
    "C^1": [[5, 3], [7, 2], [8, 3], [9, 5]],
    "C^2": [[5, 3], [7, 2], [9, 2 - 2], [9, 5]],
    "a gap": [[5, 3.5], [6, 2.5], [8, 3], [9, 5]],
}


@pytest.mark.parametrize("name", JOINTS)
def test_verdicts_are_those_of_the_exact_core(checker, name):
    fig = explore.continuity()
    fig["Q"] = JOINTS[name]
    for ratio in (1, 2):
        fig["r"] = ratio
        left, right = ([[sp.Rational(float(c)) for c in row] for row in fig[g]] for g in "PQ")
        exact = continuity_at(left, right, ratio=ratio)
        told = verdicts(fig, checker)
        held = [told[f"C^{k}"] for k in range(3)]
        assert len(list(itertools.takewhile(bool, held))) - 1 == min(exact.parametric, 2)


def test_g1_with_the_right_beta_is_seen(checker):
    fig = explore.continuity()
    assert verdicts(fig, checker) == {
        "C^0": True,
        "C^1": False,
        "C^2": False,
        "G^1": True,
        "G^2": False,
    }
    fig["beta1"] = 1
    assert not verdicts(fig, checker)["G^1"]


def test_both_questions(checker):
    fig = explore.continuity()
    first, second = fig.scene["questions"]
    fig["r"] = 2
    assert checker(first, "(9, 1)", inputs(fig))["right"]
    assert "equal intervals only" in checker(first, "(7, 2)", inputs(fig))["message"]
    assert "length 1/r" in checker(first, "(6, 5/2)", inputs(fig))["message"]
    p = np.array(fig["P"])
    q2 = p[3] + 2 * 2 * (p[3] - p[2]) + 4 * (p[3] - 2 * p[2] + p[1])  # Q_2 = Q_0 + 2 r b' + r^2 b''
    assert checker(second, f"({q2[0]}, {q2[1]})", inputs(fig))["right"]


def test_coincident_points_show_nothing_false():
    fig = explore.continuity([[0, 0]] * 4, [[0, 0]] * 4)
    assert fig.picture().axes  # where there is no curvature there is no comb


@pytest.mark.parametrize("points", [[[0, 0], [1, 1], [2, 2]], [[i, i] for i in range(5)]])
def test_segments_are_cubic(points):
    with pytest.raises(BadValue, match="four control points"):
        explore.continuity(points)

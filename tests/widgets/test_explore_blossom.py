"""The blossom explorer against the exact blossom, and its answers by the axioms they break."""

from itertools import permutations

import numpy as np
import pytest
import sympy as sp

from symbolic import BadValue, bernstein, check_blossom
from symbolic import blossom as blossom_of
from tests.widgets.explored import inputs, outputs
from widgets import explore
from widgets.explore.blossom import known_mistakes

t = sp.Symbol("t")
CUBIC = t**3 - 6 * t**2 + 3 * t


def oracle(fig):
    """Return the blossom of the figure's curve, from its power form on [0, 4]."""
    rows = [[sp.Rational(float(c)) for c in row] for row in fig["b"]]
    functions = [f.subs(t, t / 4) for f in bernstein(3)]
    return blossom_of(
        [sum(f * row[k] for f, row in zip(functions, rows, strict=True)) for k in (0, 1)], t, 3
    )


@pytest.mark.parametrize("arguments", [(1, 2, 3), (0, 4, 0), (2, 2, 2), (0.625, 3.5, 1.25)])
def test_every_label_tells_the_value_of_its_point(arguments):
    fig = explore.blossom()
    fig["b"] = [[0, 0], [-1, 3], [6, 2.5], [5, 1]]
    for name, value in zip("uvw", arguments, strict=True):
        fig[name] = value
    exact, found = oracle(fig), outputs(fig)
    named = dict(zip("uvw", map(sp.Rational, arguments), strict=True)) | {"r": 0, "s": 4}
    checked = set()
    for mark in fig.scene["marks"]:
        if mark["kind"] in ("dots", "scheme"):
            for name, point in zip(mark["labels"], found[mark["output"]], strict=True):
                expected = exact(*(named[letter] for letter in name[2:-1].split(",")))
                np.testing.assert_allclose(point, np.array(expected, dtype=float), atol=1e-12)
                checked.add(name)
    assert len(checked) == 15  # ten in the triangle, five in the other order


def test_shares_make_the_points():
    fig = explore.blossom()
    found = outputs(fig)
    scheme = next(m for m in fig.scene["marks"] if m["kind"] == "scheme")
    np.testing.assert_allclose(found[scheme["weights"]] @ fig["b"], found[scheme["output"]])


def test_missing_labels(checker):
    first, second, _ = explore.blossom().scene["questions"]
    fig = explore.blossom([[0, 0], [1, 4], [5, 5], [8, 1]])
    here = inputs(fig)
    exact = oracle(fig)
    assert checker(first, str(exact(0, 1, 4)), here)["right"]
    for wrong in [(0, 3, 4), (0, 0, 1), (1, 4, 4), (1, 1, 1)]:
        told = checker(first, str(exact(*wrong)), here)["message"]
        assert told.startswith(f"That is b({','.join(map(str, wrong))})")
    assert checker(second, str(exact(0, 4, 4)), here)["right"]
    assert "how often" in checker(second, str(exact(0, 0, 4)), here)["message"]


@pytest.mark.parametrize("typed", [
    "uvw - 2uv - 2uw - 2vw + u + v + w", "uvw - 2(u v + (u + v) w) + (u + v + w)",
])  # fmt: skip
def test_the_polar_form_in_any_shape(checker, typed):
    question = explore.blossom().scene["questions"][2]
    verdict = checker(question, typed, {"u": 1, "v": 2, "w": 3})
    assert verdict["right"] and "2 values of u times 2 values of v" in verdict["message"]


WRONG = {
    "uvw - 6uv + 3u": "Not symmetric",
    "(u^3 + v^3 + w^3)/3 - 2(u^2 + v^2 + w^2) + u + v + w": "Not multi-affine",
    "((u+v+w)/3)^3 - 6((u+v+w)/3)^2 + u + v + w": "Not multi-affine",
    "u^3 - 6u^2 + 3u": "Not multi-affine",
    "uvw - 6(uv + uw + vw) + 3(u + v + w)": "Wrong diagonal",
    "uvw - 6(uv + uw + vw) + u + v + w": "Wrong diagonal",
    "-uvw + 2(uv + uw + vw) - u - v - w": "Wrong diagonal",
}


@pytest.mark.parametrize("typed", WRONG)
def test_wrong_polar_forms_break_the_axiom_they_are_told_to(checker, typed):
    question = explore.blossom().scene["questions"][2]
    assert checker(question, typed)["message"].startswith(WRONG[typed])


def test_known_mistakes_are_wrong_and_tell_every_axiom():
    arguments = sp.symbols("u v w")
    found = known_mistakes(CUBIC)
    axioms = set()
    for message, form in found.items():
        verdict = check_blossom(form, CUBIC, [*arguments])
        assert not verdict and message.startswith(verdict.diagnosis)
        axioms.add(message.split(":")[0])
    assert axioms == {"Not multi-affine", "Not symmetric", "Wrong diagonal"}


@pytest.mark.parametrize("letters", list(permutations((0, 1.5, 4))))
def test_the_value_is_symmetric(letters):
    fig = explore.blossom()
    for name, value in zip("uvw", letters, strict=True):
        fig[name] = value
    readout = next(m for m in fig.scene["marks"] if m["kind"] == "readout")
    np.testing.assert_allclose(outputs(fig)[readout["output"]], [2.5, 4.375])


def test_coincident_points_stay_where_they_are():
    fig = explore.blossom([[2, 1]] * 4)
    found = outputs(fig)
    drawn = [found[m["output"]] for m in fig.scene["marks"] if m["kind"] in ("path", "dots")]
    assert all(np.abs(points.reshape(-1, 2) - [2, 1]).max() < 1e-12 for points in drawn)
    assert fig.picture().axes


@pytest.mark.parametrize("points", [[[0, 0], [1, 1], [2, 2]], [[i, i] for i in range(5)]])
def test_the_curve_is_a_cubic(points):
    with pytest.raises(BadValue, match="four control points"):
        explore.blossom(points)

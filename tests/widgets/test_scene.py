"""Scenes are data: inputs and marks compiled to one tape, and everything checked on the way."""

import json

import numpy as np
import pytest
import sympy as sp

from numeric import Tape
from symbolic import BadType, BadValue, de_casteljau
from widgets import Scene
from widgets.extent import evaluate, initial_state, snap_for


def parabola():
    scene = Scene("A parabola", "A parabola with its control polygon.")
    points = scene.points([[0, 0], [2, 3], [4, 0]])
    t = scene.slider("t", 0, 1, value=0.25)
    levels = de_casteljau(points, t)
    scene.polyline(points)
    scene.curve(levels[-1][0], t)
    scene.dots(levels[-1])
    return scene


def outputs_of(scene):
    data = scene.to_json()
    return data, evaluate(data, initial_state(data), Tape.from_json(data["tape"]))


def test_a_scene_is_plain_json():
    data = parabola().to_json()
    assert json.loads(json.dumps(data, allow_nan=False)) == data


def test_the_tapes_inputs_are_points_then_sliders_then_axes():
    scene = Scene()
    scene.slider("s", 0, 1)
    (a, _), (b, _) = scene.points([[0, 0], [1, 1]], name="A"), scene.points([[2, 2], [3, 3]], "B")
    scene.curve([a[0] + b[0], sp.Symbol("u")], (sp.Symbol("u"), 0, 1))
    names = scene.to_json()["tape"]["inputs"]
    assert names == ["A0_x", "A0_y", "A1_x", "A1_y", "B0_x", "B0_y", "B1_x", "B1_y", "s", "axis 0"]


def test_marks_are_evaluated_at_the_first_state():
    _, outputs = outputs_of(parabola())
    polygon, curve, dot = outputs.values()
    assert polygon.tolist() == [[0, 0], [2, 3], [4, 0]]
    assert dot.tolist() == [[1, 1.125]]
    t = np.linspace(0, 1, len(curve))
    np.testing.assert_allclose(curve[:, 0], np.stack([4 * t, 6 * t * (1 - t)], -1), atol=1e-14)


def test_curves_over_one_range_share_one_axis_and_pieces_are_joined():
    scene, u = Scene(), sp.Symbol("u")
    scene.curve([u, u], (u, 0, 1))
    scene.curve([[u, 0], [1, u], [1 - u, 1]], (u, 0, 1), closed=True, fill=True, pieces=[3])
    data, outputs = outputs_of(scene)
    assert len(data["axes"]) == 1
    assert [value.shape for value in outputs.values()] == [(129, 1, 2), (129, 3, 2)]


def test_a_view_shows_everything_in_it_and_room_around():
    data, _ = outputs_of(parabola())
    (low_x, high_x), (low_y, high_y) = data["views"][0]["x"], data["views"][0]["y"]
    assert low_x < 0 < 4 < high_x
    assert low_y < 0 < 3 < high_y


@pytest.mark.parametrize("values", [[[1, 1]], [[0, 0], [0, 0]], [[0, 5], [9, 5]]])
def test_flat_and_single_points_still_have_a_view(values):
    scene = Scene()
    scene.points(values)
    view = scene.to_json()["views"][0]
    assert view["x"][0] < view["x"][1]
    assert view["y"][0] < view["y"][1]


def test_points_where_nothing_is_finite_do_not_spoil_the_view():
    scene, u = Scene(), sp.Symbol("u")
    scene.points([[0, 0], [1, 1]])
    scene.curve([u, 1 / u], (u, 0, 1))
    assert np.isfinite(scene.to_json()["views"][0]["y"]).all()


@pytest.mark.parametrize("extent", [1e-3, 1, 7, 8, 100, 1500])
def test_points_snap_to_a_power_of_two(extent):
    snap = snap_for(np.array([[0, 0], [extent, extent / 2]]))
    assert np.log2(snap) % 1 == 0
    assert extent / 96 <= snap <= extent / 48


def test_ten_points_have_braced_labels():
    scene = Scene()
    scene.points([[i, 0] for i in range(11)])
    assert scene.to_json()["points"][0]["labels"][10] == "P_{10}"


@pytest.mark.parametrize(("build", "error", "said"), [
    (lambda s: s.points([]), BadValue, "rows"),
    (lambda s: s.points([[0, 0], [1]]), BadValue, "one dimension"),
    (lambda s: s.points([1, 2]), BadValue, "shape"),
    (lambda s: s.points([[0, 0, 0]]), BadValue, "plane"),
    (lambda s: s.points([[float("nan"), 0]]), BadValue, "finite"),
    (lambda s: s.points([["a", "b"]]), BadType, "never parsed"),
    (lambda s: s.points([[0, 0]], name="step"), BadValue, "Taken"),
    (lambda s: s.points([[0, 0]], name="two words"), BadValue, "word"),
    (lambda s: (s.slider("t", 0, 1), s.slider("t", 0, 1)), BadValue, "Taken are .*t"),
    (lambda s: s.steps(["only one"], first=1), BadValue, "from 0 to 0"),
    (lambda s: s.slider("t", 1, 0), BadValue, "low <= value <= high"),
    (lambda s: s.slider("t", 0, 1, value=2), BadValue, "low <= value <= high"),
    (lambda s: s.curve([0, 0], sp.Symbol("q")), BadValue, "slider"),
    (lambda s: s.polyline([[0, 0]], colour="red"), BadType, "colour"),
    (lambda s: s.polyline([[0, 0]], color="red"), BadValue, "construction"),
    (lambda s: s.polyline([]), BadValue, "empty"),
    (lambda s: s.polyline([0, 1]), BadValue, "each .x, y."),
    (lambda s: s.polyline([[0, 0, 0]]), BadValue, "each .x, y."),
    (lambda s: s.arrows([[0, 0], [1, 1]]), BadValue, "arrows"),
    (lambda s: s.dots([[0, 0], [1, 1]], colors=[1]), BadValue, "2 colours"),
    (lambda s: s.dots([[0, 0]], labels=["a", "b"]), BadValue, "1 labels"),
    (lambda s: s.dots([[0, 0]], view=7), BadValue, "view from 0 to 0"),
    (lambda s: s.points([[0, 0]], view=1), BadValue, "view from 0 to 0"),
    (lambda s: s.points([[0, 0]], labels=["a", "b"]), BadValue, "1 labels"),
    (lambda s: s.points([[0, 0]], labels="a"), BadType, "list of texts"),
    (lambda s: s.points([[0, 0]], snap=0), BadValue, "positive snap"),
    (lambda s: s.points([[1e300, 0]]), BadValue, "up to 1e"),
    (lambda s: (s.points([[0, 0]]), s.slider("P0_x", 0, 1)), BadValue, "P0_x"),
    (lambda s: s.slider("_esm", 0, 1), BadValue, "word"),
    (lambda s: s.slider(sp.Symbol("t"), 0, 1), BadType, "text as name"),
    (lambda s: s.slider("t", "0", 1), BadType, "real numbers"),
    (lambda s: s.slider("t", 0, float("inf")), BadValue, "finite"),
    (lambda s: s.curve([0, 0], (sp.Symbol("u"), 1, 0)), BadValue, "low < high"),
    (lambda s: s.curve([0, 0], (sp.Symbol("u"), 0, 1), samples=1), BadValue, "samples"),
    (lambda s: s.curve([0, 0, 0], (sp.Symbol("u"), 0, 1)), BadValue, "each .x, y."),
    (lambda s: s.view("v", (1, 0), (0, 1)), BadValue, "low < high"),
    (lambda s: Scene(5), BadType, "text as title"),
])  # fmt: skip
def test_bad_input(build, error, said):
    with pytest.raises(error, match=said):
        build(Scene())


def test_a_symbol_that_is_no_input_is_named():
    scene = Scene()
    scene.dots([[sp.Symbol("forgotten"), 0]])
    with pytest.raises(BadValue, match="forgotten"):
        scene.to_json()

"""The one widget class, without a browser: values, HTML, pictures."""

import inspect
import json
import re

import numpy as np
import pytest
from ipywidgets import FloatSlider, HBox, link

from symbolic import BadType, BadValue, OutsideDomain
from widgets import Figure, Scene, explore
from widgets import figure as figure_module


@pytest.fixture
def fig():
    return explore.de_casteljau([[0, 0], [2, 4], [4, 0]], t=0.25)


def test_values_are_arrays_numbers_and_the_step(fig):
    values = fig.values
    assert values["b"].tolist() == [[0, 0], [2, 4], [4, 0]]
    assert values["t"] == 0.25
    assert values["step"] == 3


def test_setting_an_input_is_seen_by_observers(fig):
    seen = []
    fig.observe(
        lambda change: seen.append((change["name"], change["new"])), ["t", "points", "step"]
    )
    fig["t"] = 0.5
    fig["b"] = [[1, 1], [2, 4], [4, 0]]
    fig["step"] = 1
    assert [name for name, _ in seen] == ["t", "points", "step"]
    assert fig["b"][0].tolist() == [1, 1]


def test_ordinary_widgets_link_to_a_slider(fig):
    slider = FloatSlider(min=0, max=1)
    link((slider, "value"), (fig, "t"))
    slider.value = 0.75
    assert fig["t"] == 0.75
    assert HBox([slider, fig]).children[1] is fig


@pytest.mark.parametrize(("name", "value", "error", "said"), [
    ("t", 1.5, OutsideDomain, r"t in \[0, 1\]"),
    ("t", float("nan"), BadValue, "nan"),
    ("t", "0.5", BadType, "real numbers"),
    ("t", None, BadType, "real numbers"),
    ("b", [[0, 0]], BadValue, "3 points"),
    ("b", [[0, 0], [1], [2, 2]], BadValue, "one dimension"),
    ("b", [["0", "0"]] * 3, BadType, "never parsed"),
    ("q", 1, BadValue, "one of b, t, step"),
    ("step", 99, BadValue, "0 to 3"),
])  # fmt: skip
def test_bad_values_are_refused_and_nothing_changes(fig, name, value, error, said):
    before = json.dumps(fig.points), fig["t"], fig["step"]
    with pytest.raises(error, match=said):
        fig[name] = value
    assert (json.dumps(fig.points), fig["t"], fig["step"]) == before


def test_asking_for_an_unknown_input_names_the_known_ones(fig):
    with pytest.raises(BadValue, match="one of b, t, step"):
        fig["nothing"]


def test_html_is_one_self_contained_page_that_cannot_be_broken_out_of():
    scene = Scene("</script><script>alert(1)</script>", 'a "quoted" <b>description</b>')
    scene.points([[0, 0], [1, 1]], labels=["</script>", "<!--"])
    html = Figure(scene).html()
    assert not re.search(r"""(?:src|href)\s*=\s*["'](?!data:)""", html)
    assert "<script>alert" not in html
    assert html.count("</script>") == 2
    state = re.search(r'data-figure-state="figure">(.*?)</script>', html)[1]
    assert json.loads(state)["scene"]["points"][0]["labels"] == ["</script>", "<!--"]


def test_html_opens_in_the_state_that_python_has(fig):
    fig["t"] = 0.75
    state = json.loads(re.search(r'data-figure-state="figure">(.*?)</script>', fig.html())[1])
    assert state["sliders"] == {"t": 0.75}


def test_outputs_carry_the_widget_and_a_page_for_readers_without_one(fig):
    data, _ = fig._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in data
    html = data["text/html"]
    assert html.index("<img") < html.index("<iframe")
    assert 'sandbox="allow-scripts"' in html


@pytest.mark.parametrize("label", ["$a_0$", "b^{", "a_", "__p_0", "\\frac", "50%", "x_{1,2}"])
def test_any_text_may_be_a_label(label):
    scene = Scene()
    scene.points([[0, 0], [1, 1]], labels=[label, "b"])
    scene.dots([[0, 1]], labels=[label])
    fig = Figure(scene)
    fig.picture().canvas.draw()
    assert "$" not in fig.scene["points"][0]["labels"][0]


def test_a_mark_is_gone_after_its_last_step():
    scene = Scene()
    scene.steps(["a", "b"], first=1)
    scene.dots([[0, 0]], until=0)
    fig = Figure(scene)
    assert len(fig.picture().axes[0].collections) == 0
    fig["step"] = 0
    assert len(fig.picture().axes[0].collections) == 1


def test_a_closed_figure_can_still_be_looked_at(fig):
    fig.close()
    assert fig.picture().axes
    assert "casteljau-figure" in fig.html()
    assert repr(fig).startswith("<Figure")


def test_a_figure_says_what_it_is(fig):
    assert repr(fig) == '<Figure "De Casteljau\'s construction": b, t, step>'
    assert "t" in fig
    assert "q" not in fig


def test_pictures_show_what_is_visible_at_a_step(fig, artefacts):
    for step in (0, 3):
        fig["step"] = step
        picture = fig.picture()
        assert len(picture.axes) == 1
        dots = picture.axes[0].collections
        assert len(dots) == (1 if step == 0 else 4)
        picture.savefig(artefacts / f"picture_step{step}.png")
    fig.picture(theme="dark").savefig(artefacts / "picture_dark.png")


@pytest.mark.parametrize("ending", ["html", "svg", "pdf", "png"])
def test_a_figure_is_saved_by_the_paths_ending(fig, tmp_path, ending):
    fig.save(tmp_path / f"figure.{ending}")
    assert (tmp_path / f"figure.{ending}").stat().st_size > 1000
    with pytest.raises(BadValue, match=".html, .svg, .pdf or .png"):
        fig.save(tmp_path / "figure.docx")


@pytest.mark.parametrize("scene", [None, {}, "scene", 3])
def test_a_figure_wants_a_scene(scene):
    with pytest.raises(BadType, match="a Scene"):
        Figure(scene)


@pytest.mark.parametrize("name", ["layout", "observe", "scene"])
def test_sliders_do_not_hide_parts_of_the_widget(name):
    scene = Scene()
    with pytest.raises(BadValue, match="Taken|parts of a widget"):
        scene.slider(name, 0, 1)
        Figure(scene)


def test_a_front_end_of_another_version_is_refused(monkeypatch, tmp_path):
    (tmp_path / "figure.mjs").write_text("/* casteljau 0.0.0 */\nnothing")
    monkeypatch.setattr(figure_module, "_STATIC", tmp_path)
    figure_module.bundle.cache_clear()
    for name in ("figure.mjs", "missing.mjs"):
        with pytest.raises(BadValue, match="front end of casteljau"):
            figure_module.bundle(name)
    figure_module.bundle.cache_clear()


EXPLORERS = [getattr(explore, name) for name in explore.__all__]


def taking(argument):
    """Return the explorers that have an argument of this name."""
    return [e for e in EXPLORERS if argument in inspect.signature(e).parameters]


@pytest.mark.parametrize("explorer", EXPLORERS)
def test_every_explorer_is_worth_looking_at(explorer, artefacts):
    fig = explorer()
    fig.save(artefacts / f"{explorer.__name__}.png")
    fig.save(artefacts / f"{explorer.__name__}.html")
    assert fig.scene["title"]
    assert len(fig.scene["description"]) > 30
    assert fig.scene["questions"] or explorer is explore.subdivision


OF_ANY_DEGREE = [explore.de_casteljau, explore.subdivision]


@pytest.mark.parametrize("explorer", OF_ANY_DEGREE)
@pytest.mark.parametrize("degree", range(1, 9))
def test_every_degree_up_to_eight(explorer, degree):
    points = [[i, (3 * i) % 5] for i in range(degree + 1)]
    fig = explorer(points, t=0.5)
    assert fig["b"].tolist() == points
    assert fig.picture().axes


@pytest.mark.parametrize("explorer", taking("points"))
@pytest.mark.parametrize(("points", "error"), [
    ([], BadValue), ([[0, 0]], BadValue), ([[0, 0], [1]], BadValue), ([0, 1], BadValue),
    ([[0, 0, 0], [1, 1, 1]], BadValue), ([[0, float("nan")], [1, 1]], BadValue),
    ([["0", "0"], ["1", "1"]], BadType), ([[i, i] for i in range(10)], BadValue),
])  # fmt: skip
def test_bad_points(explorer, points, error):
    with pytest.raises(error, match="Expected"):
        explorer(points)


@pytest.mark.parametrize("explorer", taking("t"))
@pytest.mark.parametrize("t", [-0.5, 99, float("nan"), "1/2"])
def test_bad_parameters(explorer, t):
    with pytest.raises((BadValue, BadType), match="Expected"):
        explorer(t=t)


def test_the_scheme_shows_exact_shares_of_every_control_point(fig):
    from numeric import Tape
    from widgets.extent import evaluate

    scheme = next(m for m in fig.scene["marks"] if m["kind"] == "scheme")
    tape = Tape.from_json(fig.scene["tape"])
    outputs = evaluate(fig.scene, fig.values, tape)
    shares, points = outputs[scheme["weights"]], outputs[scheme["output"]]
    np.testing.assert_allclose(shares.sum(axis=1), 1)
    np.testing.assert_allclose(shares @ fig["b"], points, atol=1e-15)
    assert shares[-1].tolist() == [0.5625, 0.375, 0.0625]


def test_subdivision_keeps_to_its_depth():
    with pytest.raises(BadValue, match="0 to 6"):
        explore.subdivision(depth=9)
    assert len(explore.subdivision(depth=2).scene["steps"]) == 3

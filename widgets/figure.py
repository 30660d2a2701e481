"""The one widget class: a scene made live."""

from __future__ import annotations

import base64
import io
from functools import lru_cache
from pathlib import Path
from typing import Any

import anywidget
import numpy as np
import traitlets

from numeric import float_points, real_number
from symbolic.errors import BadType, BadValue, OutsideDomain, shown
from symbolic.exact import whole_number

from .extent import initial_state
from .picture import draw
from .scene import Scene
from .standalone import embedded, page
from .version import VERSION

_POSTER_COLOURS = 48  # lines, letters and their soft edges; a fifth of the size of all colours
_STATIC = Path(__file__).parent / "static"


@lru_cache
def bundle(name: str) -> str:
    """Return a built front-end file's text; it must carry this package's version.

    Raises
    ------
    BadValue
        If the front end was not built, or by another version.
    """
    path = _STATIC / name
    text = path.read_text(encoding="utf-8") if path.is_file() else "nothing"
    if not text.startswith(f"/* casteljau {VERSION} */"):
        raise BadValue(
            f"the front end of casteljau {VERSION} in {path.name}",
            shown(text.split("\n", 1)[0], 40),
            "Install the package again: pip install casteljau, or make lab in a clone.",
        )
    return text


class Figure(anywidget.AnyWidget):
    """A live figure: movable points and sliders in the browser, their values in Python.

    Every slider is a trait of its own (``observe``, ``link`` and ``jslink`` work as with any
    widget), all points are the trait `points`, the current step is `step`.

    Parameters
    ----------
    scene : Scene

    Examples
    --------
    >>> scene = Scene("A segment")
    >>> P = scene.points([[0, 0], [4, 2]])
    >>> t = scene.slider("t", 0, 1)
    >>> scene.dots([[(1 - t)*a + t*b for a, b in zip(*P)]])
    >>> fig = Figure(scene)
    >>> fig["t"] = 0.25
    >>> fig["P"] = [[0, 0], [8, 2]]
    >>> fig.values["t"], fig["P"][1]
    (0.25, array([8., 2.]))
    """

    scene = traitlets.Dict().tag(sync=True)
    points = traitlets.Dict().tag(sync=True)
    step = traitlets.Int(0, min=0).tag(sync=True)

    def __init__(self, scene: Scene) -> None:
        if not isinstance(scene, Scene):
            raise BadType("a Scene", shown(scene), "Make one: scene = Scene(); scene.points(...).")
        data = scene.to_json()
        self._refuse_taken([slider["name"] for slider in data["sliders"]])
        super().__init__(
            _esm=bundle("figure.mjs"),
            scene=data,
            points={group["name"]: group["values"] for group in data["points"]},
            step=data["step"],
        )
        self.add_traits(
            **{
                slider["name"]: traitlets.Float(
                    slider["value"], min=slider["low"], max=slider["high"]
                ).tag(sync=True)
                for slider in data["sliders"]
            }
        )

    def __getitem__(self, name: str) -> Any:
        """Return a slider's value, the points of a group as an array, or the step."""
        values = self.values
        if name not in values:
            raise self._unknown(name)
        return values[name]

    def __setitem__(self, name: str, value: Any) -> None:
        """Move a slider, the points of a group, or go to a step."""
        if name in self.points:
            rows = float_points(value)
            if rows.shape != (len(self.points[name]), 2):
                raise BadValue(
                    f"{len(self.points[name])} points in the plane", f"shape {rows.shape}",
                    "A figure's points can move, but not grow in number.",
                )  # fmt: skip
            self.points = {**self.points, name: rows.tolist()}
        elif name == "step":
            self._go_to(value)
        else:
            self._slide(name, value)

    @property
    def values(self) -> dict[str, Any]:
        """All inputs as they stand now: point groups as (n, 2) arrays, sliders, and the step."""
        points = {name: np.array(rows, dtype=float) for name, rows in self.points.items()}
        return {**points, **self._sliders(), "step": self.step}

    def html(self) -> str:
        """Return a self-contained page: it works from a file, with no kernel and no network."""
        return page(self._state(), bundle("figure.page.js"), self._poster())

    def picture(self, theme: str = "light") -> Any:
        """Return the figure as it stands now as a matplotlib Figure."""
        return draw(self.scene, {**initial_state(self.scene), **self.values}, self.step, theme)

    def save(self, path: str | Path) -> None:
        """Write the figure as a live .html page, or as a picture (.svg, .pdf, .png).

        Raises
        ------
        BadValue
            For any other ending.
        """
        path = Path(path).expanduser()
        if path.suffix == ".html":
            path.write_text(self.html(), encoding="utf-8")
        elif path.suffix in (".svg", ".pdf", ".png"):
            self.picture().savefig(path)
        else:
            raise BadValue(
                "a path ending in .html, .svg, .pdf or .png", shown(str(path)), "Choose one."
            )

    def __contains__(self, name: object) -> bool:
        return name in self.values

    def __repr__(self) -> str:
        return f"<Figure {self.scene['title']!r}: {', '.join(self.values)}>"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        bundle_ = super()._repr_mimebundle_(**kwargs)
        if not bundle_:
            return bundle_
        data, metadata = bundle_ if isinstance(bundle_, tuple) else (bundle_, {})
        return {**data, "text/html": embedded(self.html(), self._poster())}, metadata

    def _state(self) -> dict[str, Any]:
        return {"scene": self.scene, "points": self.points, "step": self.step,
                "sliders": self._sliders()}  # fmt: skip

    def _sliders(self) -> dict[str, float]:
        return {s["name"]: getattr(self, s["name"]) for s in self.scene["sliders"]}

    def _poster(self) -> str:
        """Return an <img> of the figure as it stands, for readers without scripts."""
        from PIL import Image  # matplotlib's own dependency

        drawn, small = io.BytesIO(), io.BytesIO()
        self.picture().savefig(drawn, format="png", dpi=96)
        picture = (
            Image.open(drawn).convert("RGB").quantize(_POSTER_COLOURS, dither=Image.Dither.NONE)
        )
        picture.save(small, format="png", optimize=True)
        return _image(base64.b64encode(small.getvalue()).decode(), self.scene["description"])

    def _refuse_taken(self, names: list[str]) -> None:
        taken = [name for name in names if hasattr(type(self), name)]
        if taken:
            raise BadValue(
                "sliders named differently from the parts of a widget",
                ", ".join(taken), "Choose another name, such as t.",
            )  # fmt: skip

    def _go_to(self, step: Any) -> None:
        last = max(0, len(self.scene["steps"]) - 1)
        if whole_number(step) not in range(last + 1):
            raise OutsideDomain(f"a step from 0 to {last}", shown(step), "Choose one of these.")
        self.step = int(step)

    def _slide(self, name: str, value: Any) -> None:
        slider = next((s for s in self.scene["sliders"] if s["name"] == name), None)
        if slider is None:
            raise self._unknown(name)
        number = real_number(value, name)
        if not slider["low"] <= number <= slider["high"]:
            raise OutsideDomain(
                f"{name} in [{slider['low']:g}, {slider['high']:g}]",
                f"{value}", "Both ends belong to it.",
            )  # fmt: skip
        setattr(self, name, number)

    def _unknown(self, name: str) -> BadValue:
        return BadValue(
            f"one of {', '.join(self.values)}", shown(name), "These are the figure's inputs."
        )


def _image(data: str, description: str) -> str:
    from html import escape

    source = f"data:image/png;base64,{data}"
    return f'<img src="{source}" alt="{escape(description)}" style="max-width: 100%">'

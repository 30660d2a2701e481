"""A scene: what a live figure shows, as data made from SymPy expressions.

A scene has inputs (movable points, sliders) and marks (curves, polylines, dots, panels), which are
expressions in these inputs. It is compiled to one tape, which the browser evaluates at every
frame and matplotlib once. An author writes no coordinates transform, no event handler.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from numeric import compile_tape, real_number
from symbolic.errors import BadValue, shown
from symbolic.exact import whole_number

from .extent import fit_views, snap_for
from .marks import Colour, Marks
from .palette import PALETTE
from .questions import HINT, question_data
from .reading import colours, plane_points, positive, span, text
from .reading import labels as read_labels
from .version import VERSION

Points = list[tuple[sp.Symbol, sp.Symbol]]
_RESERVED = {"scene", "points", "step"}


class Scene(Marks):
    """Inputs and marks of a figure; `Figure(scene)` makes it live.

    Parameters
    ----------
    title : str
        The figure's heading, also for screen readers.
    description : str
        What there is to see, in a sentence or two: the text alternative of the picture.

    Examples
    --------
    >>> from symbolic import de_casteljau
    >>> scene = Scene("A parabola")
    >>> P = scene.points([[0, 0], [2, 3], [4, 0]])
    >>> t = scene.slider("t", 0, 1)
    >>> levels = de_casteljau(P, t)
    >>> scene.polyline(P), scene.curve(levels[-1][0], t), scene.dots(levels[-1])
    (None, None, None)
    """

    def __init__(self, title: str = "", description: str = "") -> None:
        super().__init__()
        self.title = text(title, "title")
        self.description = text(description, "description") or title
        self.captions: list[str] = []
        self.first_step = 0
        self._views = [
            {"name": "plane", "title": "", "x": None, "y": None, "equal": True, "axes": True}
        ]
        self._points: list[dict[str, Any]] = []
        self._questions: list[dict[str, Any]] = []

    def points(
        self,
        values: Any,
        name: str = "P",
        labels: Sequence[str] | None = None,
        colors: Sequence[Colour] | None = None,
        snap: float | None = None,
        view: int = 0,
        along: str | None = None,
        since: int = 0,
        until: int | None = None,
    ) -> Points:
        """Add movable points and return their coordinates as pairs of symbols.

        Parameters
        ----------
        values : rows, shape (n, 2)
            Where the points stand first.
        name : str
            Under which the figure keeps them: ``fig[name]``.
        labels : n texts, by default name_0, name_1, ...; "b_0^1" has a sub- and a superscript
        colors : n colours; by default a colour of its own for every point
        snap : float, optional
            Points move on multiples of it, by default a power of two that suits their extent
            (1/8 for a figure about 8 units wide), so that their coordinates are exact.
        along : "x", optional
            Points move to the left and right only, as knots on an axis do.
        since, until : steps at which they are there

        Raises
        ------
        BadValue, BadType
            For points as in `float_points`, not in the plane, or a name that is taken.
        """
        rows = plane_points(values)
        numbers = range(len(rows))
        symbols = [(sp.Symbol(f"{name}{i}_x"), sp.Symbol(f"{name}{i}_y")) for i in numbers]
        self._refuse_taken(name, [symbol.name for pair in symbols for symbol in pair])
        labels = labels or [f"{name}_{{{i}}}" if i > 9 else f"{name}_{i}" for i in numbers]
        self._points.append({
            "name": name, "view": self._view_number(view), "from": since, "until": until,
            "labels": read_labels(labels, len(rows)),
            "colors": colours(numbers if colors is None else colors, len(rows)),
            "values": rows.tolist(),
            "snap": snap_for(rows) if snap is None else positive(snap, "snap"),
            "along": _direction(along),
        })  # fmt: skip
        at = len(self._inputs) - len(self._sliders)  # points come before the sliders
        self._inputs[at:at] = [symbol for pair in symbols for symbol in pair]
        return symbols

    def slider(
        self,
        name: str,
        low: float,
        high: float,
        value: float | None = None,
        snap: float | None = None,
        label: str | None = None,
    ) -> sp.Symbol:
        """Add a slider that can also be played, and return its symbol.

        Raises
        ------
        BadValue
            If low < high does not hold, the value is outside, or the name is taken.
        """
        low, high = real_number(low, "low"), real_number(high, "high")
        value = low + (high - low) / 2 if value is None else real_number(value, name)
        if not low <= value <= high or low == high:
            raise BadValue(
                "low <= value <= high with low < high",
                f"low {low:g}, value {value:g}, high {high:g}",
                "Give the slider a range that contains its value.",
            )
        self._refuse_taken(name, [name])
        self._sliders.append({
            "name": name, "label": label or name, "low": low, "high": high, "value": value,
            "snap": (high - low) / 64 if snap is None else positive(snap, "snap"), "play": True,
        })  # fmt: skip
        self._inputs.append(sp.Symbol(name))
        return self._inputs[-1]

    def steps(self, captions: Sequence[str], first: int = 0) -> None:
        """Give the figure steps; marks appear `since` and disappear after `until` a step."""
        if whole_number(first) not in range(len(captions)):
            raise BadValue(
                f"a first step from 0 to {len(captions) - 1}", shown(first), "Choose one of these."
            )
        self.captions = [text(caption, "caption") for caption in captions]
        self.first_step = int(first)

    def question(
        self,
        prompt: str,
        answer: Any,
        variables: Sequence[sp.Symbol] = (),
        mistakes: Mapping[str, Any] | None = None,
        hint: str = HINT,
        since: int = 0,
        until: int | None = None,
    ) -> None:
        """Ask a question; what a learner types is checked exactly, without a kernel.

        Parameters
        ----------
        prompt : str
        answer : expression or list of them (a point, a row, a matrix row by row)
            In the figure's inputs and the variables: quotients of polynomials with exact
            coefficients.
        variables : symbols that a learner may type, such as t; else the answer is numbers
            One with the name of an input stands for any value, not for the input's.
        mistakes : {what to say: wrong answer}
        hint : str
            What to say about any other wrong answer.
        since, until : steps at which it is asked, one at a time

        Raises
        ------
        BadValue, BadType
            For answers that cannot be checked exactly, and mistakes that are right.

        Examples
        --------
        >>> scene = Scene()
        >>> a, b = scene.points([[0, 0], [4, 2]])
        >>> half = [(p + q) / 2 for p, q in zip(a, b)]
        >>> scene.question("Where is the middle?", half, mistakes={"That is their sum.":
        ...                [p + q for p, q in zip(a, b)]})
        """
        data = question_data(prompt, answer, self._inputs, variables, mistakes or {}, hint)
        self._questions.append({**data, "from": since, "until": until})

    def view(self, name: str, x: Any, y: Any, title: str = "", equal: bool = False) -> int:
        """Add a second drawing over given ranges and return its number, for ``view=``."""
        self._views.append({
            "name": text(name, "name"), "title": text(title, "title"),
            "x": list(span(*x)), "y": list(span(*y)),
            "equal": equal, "axes": True,
        })  # fmt: skip
        return len(self._views) - 1

    def to_json(self) -> dict[str, Any]:
        """Return the scene as JSON data, the only thing a figure's front end is given."""
        tape = compile_tape(self._outputs, [*self._inputs, *self._axis_symbols])
        scene = {
            "version": VERSION, "title": self.title, "description": self.description,
            "palette": PALETTE, "views": [dict(view) for view in self._views],
            "points": self._points, "sliders": self._sliders, "steps": self.captions,
            "step": self.first_step, "axes": self._axes, "tape": tape.to_json(),
            "marks": self._marks, "questions": self._questions,
        }  # fmt: skip
        fit_views(scene, tape)
        return scene

    def _refuse_taken(self, name: str, inputs: list[str]) -> None:
        taken = {entry["name"] for entry in (*self._points, *self._sliders)} | _RESERVED
        clash = {symbol.name for symbol in self._inputs} & set(inputs)
        word = text(name, "name").isidentifier() and not name.startswith("_")
        if not word or name in taken or clash:
            taken |= clash
            raise BadValue(
                "a new name that is a word", shown(name), f"Taken are {', '.join(sorted(taken))}."
            )


def _direction(along: Any) -> str | None:
    if along not in (None, "x"):
        raise BadValue('along="x" or nothing', shown(along), "Points move everywhere else.")
    return along

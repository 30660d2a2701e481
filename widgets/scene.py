"""A scene: what a live figure shows, as data made from SymPy expressions.

A scene has inputs (movable points, sliders) and marks (curves, polylines, dots, panels), which are
expressions in these inputs. It is compiled to one tape, which the browser evaluates at every
frame and matplotlib once. An author writes no coordinates transform, no event handler.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from numeric import compile_tape, float_points
from symbolic.dag import substitute
from symbolic.errors import BadType, BadValue, shown
from symbolic.exact import exact

from .extent import fit_views, snap_for
from .palette import PALETTE
from .version import VERSION

Points = list[tuple[sp.Symbol, sp.Symbol]]
Colour = int | str
_RESERVED = {"scene", "points", "step"}
_SAMPLES = 129  # smooth on a screen 1000 pixels wide; a cubic's chord error is below 1/8 pixel


class Scene:
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
        self.title = title
        self.description = description or title
        self.captions: list[str] = []
        self.first_step = 0
        self._views: list[dict[str, Any]] = [
            {"name": "plane", "title": "", "x": None, "y": None, "equal": True, "axes": True}
        ]
        self._points: list[dict[str, Any]] = []
        self._sliders: list[dict[str, Any]] = []
        self._axes: list[dict[str, Any]] = []
        self._marks: list[dict[str, Any]] = []
        self._inputs: list[sp.Symbol] = []
        self._axis_symbols: list[sp.Symbol] = []
        self._outputs: dict[str, Any] = {}

    # inputs

    def points(
        self,
        values: Any,
        name: str = "P",
        labels: Sequence[str] | None = None,
        colors: Sequence[Colour] | None = None,
        snap: float | None = None,
        view: int = 0,
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

        Raises
        ------
        BadValue, BadType
            For points as in `float_points`, not in the plane, or a name that is taken.
        """
        rows = float_points(values)
        if rows.shape[1] != 2:
            raise BadValue(
                "points in the plane, shape (n, 2)", f"shape {rows.shape}", "Give x and y."
            )
        self._refuse_taken(name)
        labels = labels or [f"{name}_{{{i}}}" if i > 9 else f"{name}_{i}" for i in range(len(rows))]
        self._points.append({
            "name": name, "view": view, "labels": list(labels),
            "colors": list(colors if colors is not None else range(len(rows))),
            "values": rows.tolist(), "snap": snap_for(rows) if snap is None else float(snap),
        })  # fmt: skip
        symbols = [sp.symbols(f"{name}{i}_x {name}{i}_y") for i in range(len(rows))]
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
        low, high = float(low), float(high)
        value = low + (high - low) / 2 if value is None else float(value)
        if not low <= value <= high or low == high:
            raise BadValue(
                "low <= value <= high with low < high",
                f"low {low:g}, value {value:g}, high {high:g}",
                "Give the slider a range that contains its value.",
            )
        self._refuse_taken(name)
        self._sliders.append({
            "name": name, "label": label or name, "low": low, "high": high, "value": value,
            "snap": (high - low) / 64 if snap is None else float(snap), "play": True,
        })  # fmt: skip
        self._inputs.append(sp.Symbol(name))
        return self._inputs[-1]

    def steps(self, captions: Sequence[str], first: int = 0) -> None:
        """Give the figure steps; marks appear `since` and disappear after `until` a step."""
        if first not in range(len(captions)):
            raise BadValue(
                f"a first step from 0 to {len(captions) - 1}", shown(first), "Choose one of these."
            )
        self.captions = list(captions)
        self.first_step = first

    def view(self, name: str, x: Any, y: Any, title: str = "", equal: bool = False) -> int:
        """Add a second drawing over given ranges and return its number, for ``view=``."""
        self._views.append({
            "name": name, "title": title, "x": [float(v) for v in x], "y": [float(v) for v in y],
            "equal": equal, "axes": True,
        })  # fmt: skip
        return len(self._views) - 1

    # marks

    def curve(
        self,
        expressions: Any,
        over: sp.Symbol | tuple[sp.Symbol, Any, Any],
        color: Colour = "curve",
        samples: int = _SAMPLES,
        **look: Any,
    ) -> None:
        """Draw a curve: a pair of expressions, or a list of pairs joined end to end.

        Parameters
        ----------
        expressions : (x, y), or list of these
        over : a slider's symbol, swept over its range, or (symbol, low, high)
        color, samples, width, dashed, fill, closed, pieces, view, since, until
            `pieces` counts the joined pairs per closed contour; `since` and `until` are steps.
        """
        symbol, low, high = over if isinstance(over, tuple) else self._range(over)
        joined = isinstance(expressions[0], list | tuple)
        flat = [e for pair in (expressions if joined else [expressions]) for e in pair]
        axis = self._axis(float(low), float(high), samples)
        swept = substitute([_expression(e) for e in flat], {symbol: self._axis_symbols[axis]})
        self._mark("path", list(zip(swept[::2], swept[1::2], strict=True)), look,
                   color=color, axis=axis)  # fmt: skip

    def polyline(self, points: Any, color: Colour = "construction", **look: Any) -> None:
        """Draw straight lines from point to point; looks as in `curve`."""
        self._mark("path", points, look, color=color, axis=None)

    def dots(
        self,
        points: Any,
        colors: Sequence[Colour] | None = None,
        labels: Sequence[str] | None = None,
        **look: Any,
    ) -> None:
        """Draw points that follow from others and cannot be moved."""
        count = len(points)
        self._mark("dots", points, look, colors=list(colors or ["construction"] * count),
                   labels=None if labels is None else list(labels))  # fmt: skip

    def arrows(self, arrows: Any, color: Colour = "construction", **look: Any) -> None:
        """Draw arrows, each a pair (from, to) of points."""
        self._mark("arrows", arrows, look, color=color)

    def readout(self, label: str, expressions: Any) -> None:
        """Show a number, or the coordinates of a point, below the drawing."""
        self._mark("readout", expressions, {}, label=label)

    def weights(self, expressions: Any, labels: Sequence[str], title: str = "") -> None:
        """Show a row of shares in the colours of the control points."""
        self._mark("weights", expressions, {}, labels=list(labels), title=title,
                   colors=list(range(len(labels))))  # fmt: skip

    def scheme(self, levels: Any, labels: Sequence[str], froms: Sequence[int], shares: Any) -> None:
        """Show a triangular scheme of points, with the share of every control point in each."""
        name = f"m{len(self._outputs)}"
        self._outputs[name] = shares
        self._mark("scheme", [p for level in levels for p in level], {}, weights=name,
                   sizes=[len(level) for level in levels], labels=list(labels),
                   froms=list(froms), colors=list(range(len(levels[0]))))  # fmt: skip

    # the result

    def to_json(self) -> dict[str, Any]:
        """Return the scene as JSON data, the only thing a figure's front end is given."""
        tape = compile_tape(self._outputs, [*self._inputs, *self._axis_symbols])
        scene = {
            "version": VERSION, "title": self.title, "description": self.description,
            "palette": PALETTE, "views": [dict(view) for view in self._views],
            "points": self._points, "sliders": self._sliders, "steps": self.captions,
            "step": self.first_step, "axes": self._axes, "tape": tape.to_json(),
            "marks": self._marks,
        }  # fmt: skip
        fit_views(scene, tape)
        return scene

    def _mark(self, kind: str, output: Any, look: dict[str, Any], **fields: Any) -> None:
        name = f"m{len(self._outputs)}"
        allowed = _LOOKS.get(kind, {})
        unknown = set(look) - set(allowed)
        if unknown:
            raise BadType(
                f"looks of a {kind}: {', '.join(allowed)}", ", ".join(sorted(unknown)),
                "Use one of these.",
            )  # fmt: skip
        mark = {"kind": kind, "output": name, **fields, **allowed, **look}
        if "since" in mark:
            mark["from"] = mark.pop("since")
        self._outputs[name] = output
        self._marks.append(mark)

    def _range(self, symbol: sp.Symbol) -> tuple[sp.Symbol, float, float]:
        for slider in self._sliders:
            if isinstance(symbol, sp.Symbol) and slider["name"] == symbol.name:
                return symbol, slider["low"], slider["high"]
        raise BadValue(
            "a slider's symbol, or (symbol, low, high)",
            shown(symbol),
            "Say over which range the curve is drawn.",
        )

    def _axis(self, low: float, high: float, count: int) -> int:
        axis = {"low": low, "high": high, "count": int(count)}
        if axis not in self._axes:
            self._axes.append(axis)
            self._axis_symbols.append(sp.Symbol(f"axis{len(self._axis_symbols)}"))
        return self._axes.index(axis)

    def _refuse_taken(self, name: str) -> None:
        taken = {entry["name"] for entry in (*self._points, *self._sliders)} | _RESERVED
        if not str(name).isidentifier() or name in taken:
            raise BadValue(
                "a new name that is a word", shown(name), f"Taken are {', '.join(sorted(taken))}."
            )


_STEPS = {"view": 0, "since": 0, "until": None}
_LOOKS: dict[str, dict[str, Any]] = {
    "path": {**_STEPS, "width": 2, "dashed": False, "fill": False, "closed": False, "pieces": None},
    "dots": {**_STEPS, "radius": 4},
    "arrows": {**_STEPS, "width": 2},
}


def _expression(value: Any) -> sp.Expr:
    return value if isinstance(value, sp.Expr) else exact(value)

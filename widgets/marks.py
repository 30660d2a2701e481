"""The marks of a scene: what can be drawn, each an expression in the scene's inputs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from numeric import flattened
from symbolic.dag import substitute
from symbolic.errors import BadType, BadValue, shown
from symbolic.exact import whole_number

from .questions import exact_tape
from .reading import colours, output_size, span, text
from .reading import labels as read_labels

Colour = int | str  # index of a control point's colour, or the name of a role
_SAMPLES = 129  # smooth on a screen 1000 pixels wide; a cubic's chord error is below 1/8 pixel
_STEPS = {"view": 0, "since": 0, "until": None}
_LOOKS: dict[str, dict[str, Any]] = {
    "path": {**_STEPS, "width": 2, "dashed": False, "fill": False, "closed": False, "pieces": None},
    "dots": {**_STEPS, "radius": 4},
    "arrows": {**_STEPS, "width": 2},
    "hull": _STEPS,
    "readout": {"since": 0, "until": None},
    "statement": {"since": 0, "until": None},
}


class Marks:
    """The methods of a `Scene` that draw something.

    Coordinates are SymPy expressions, or lists of them; colours an index into the palette of
    control points or a role (curve, construction, muted, accent).
    """

    def __init__(self) -> None:
        self._views: list[dict[str, Any]] = []
        self._sliders: list[dict[str, Any]] = []
        self._axes: list[dict[str, Any]] = []
        self._axis_symbols: list[sp.Symbol] = []
        self._marks: list[dict[str, Any]] = []
        self._outputs: dict[str, Any] = {}
        self._inputs: list[sp.Symbol] = []

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
        shape, flat = flattened(expressions)
        output_size("path", expressions if len(shape) == 2 else [expressions])
        axis = self._axis(*span(low, high), samples)
        swept = substitute(flat, {symbol: self._axis_symbols[axis]})
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
        count = output_size("dots", points)
        self._mark("dots", points, look, labels=read_labels(labels, count),
                   colors=colours(colors or ["construction"] * count, count))  # fmt: skip

    def arrows(self, arrows: Any, color: Colour = "construction", **look: Any) -> None:
        """Draw arrows, each a pair (from, to) of points."""
        self._mark("arrows", arrows, look, color=color)

    def hull(self, points: Any, color: Colour = "construction", **look: Any) -> None:
        """Fill the convex hull of points; looks are view, since, until."""
        self._mark("hull", points, look, color=color)

    def readout(self, label: str, expressions: Any, **look: Any) -> None:
        """Show a number, or a point, below the drawing; looks are the steps since and until."""
        self._mark("readout", expressions, look, label=text(label, "label"))

    def statement(self, label: str, residuals: Any, **look: Any) -> None:
        """Say whether residuals are exactly zero as the figure stands, or by how much they fail.

        They are quotients of polynomials in the figure's inputs; `since` and `until` are steps.
        """
        self._mark("statement", residuals, look, label=text(label, "label"),
                   tape=exact_tape({"residuals": residuals}, self._inputs))  # fmt: skip

    def weights(self, expressions: Any, labels: Sequence[str], title: str = "") -> None:
        """Show a row of shares in the colours of the control points."""
        count = output_size("weights", expressions)
        self._mark("weights", expressions, {}, labels=read_labels(labels, count),
                   title=text(title, "title"), colors=list(range(count)))  # fmt: skip

    def scheme(self, levels: Any, labels: Sequence[str], froms: Sequence[int], shares: Any) -> None:
        """Show a triangular scheme of points, with the share of every control point in each."""
        name = f"m{len(self._outputs)}"
        self._outputs[name] = shares
        self._mark("scheme", [p for level in levels for p in level], {}, weights=name,
                   sizes=[len(level) for level in levels], labels=list(labels),
                   froms=list(froms), colors=list(range(len(levels[0]))))  # fmt: skip

    def _mark(self, kind: str, output: Any, look: dict[str, Any], **fields: Any) -> None:
        name = f"m{len(self._outputs)}"
        allowed = _LOOKS.get(kind, {})
        unknown = set(look) - set(allowed)
        if unknown:
            raise BadType(
                f"looks of a {kind}: {', '.join(allowed)}", ", ".join(sorted(unknown)),
                "Use one of these.",
            )  # fmt: skip
        output_size(kind, output)
        if "color" in fields:
            fields["color"] = colours(fields["color"], 1)[0]
        if "view" in allowed:
            look = {**look, "view": self._view_number(look.get("view", 0))}
        mark = {"kind": kind, "output": name, **fields, **allowed, **look}
        if "since" in mark:
            mark["from"] = mark.pop("since")
        self._outputs[name] = output
        self._marks.append(mark)

    def _view_number(self, view: Any) -> int:
        if whole_number(view) not in range(len(self._views)):
            raise BadValue(
                f"a view from 0 to {len(self._views) - 1}", shown(view), "Add it with scene.view."
            )
        return int(view)

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
        if whole_number(count) not in range(2, 10_001):
            raise BadValue("2 to 10000 samples", shown(count), "A curve needs its two ends.")
        axis = {"low": low, "high": high, "count": int(count)}
        if axis not in self._axes:
            self._axes.append(axis)
            # No name of an input has a space, so it cannot be taken.
            self._axis_symbols.append(sp.Symbol(f"axis {len(self._axis_symbols)}"))
        return self._axes.index(axis)

"""The part of the plane a drawing shows: everything in it, and room to drag."""

from __future__ import annotations

from typing import Any

import numpy as np

from numeric import Tape

_MARGIN = 0.12


def evaluate(scene: dict[str, Any], state: dict[str, Any], tape: Tape) -> dict[str, np.ndarray]:
    """Run a scene's tape in NumPy: outputs by name, sampled ones with the samples first.

    `state` holds the points by group name, and the sliders by name.
    """
    inputs: list[Any] = []
    for group in scene["points"]:
        inputs += [float(v) for row in state[group["name"]] for v in row]
    inputs += [float(state[slider["name"]]) for slider in scene["sliders"]]
    first = [axis["low"] for axis in scene["axes"]]
    outputs = tape.run([*inputs, *first])
    for number, axis in enumerate(scene["axes"]):
        samples: list[Any] = list(first)
        samples[number] = np.linspace(axis["low"], axis["high"], axis["count"])
        swept = tape.run([*inputs, *samples])
        names = [m["output"] for m in scene["marks"] if m.get("axis") == number]
        outputs |= {name: swept[name] for name in names}
    return outputs


def initial_state(scene: dict[str, Any]) -> dict[str, Any]:
    """Return the state a figure opens with, as `evaluate` takes it."""
    state = {group["name"]: group["values"] for group in scene["points"]}
    return state | {slider["name"]: slider["value"] for slider in scene["sliders"]}


def fit_views(scene: dict[str, Any], tape: Tape) -> None:
    """Fill in the ranges of views that have none, from all that is drawn in them."""
    if all(view["x"] is not None for view in scene["views"]):
        return
    outputs = evaluate(scene, initial_state(scene), tape)
    for number, view in enumerate(scene["views"]):
        if view["x"] is None:
            held = [
                np.reshape(g["values"], (-1, 2)) for g in scene["points"] if g["view"] == number
            ]
            drawn = [
                outputs[m["output"]].reshape(-1, 2)
                for m in scene["marks"]
                if m.get("view") == number
            ]
            view["x"], view["y"] = _ranges(
                *(np.concatenate([*p, np.empty((0, 2))]) for p in (held, drawn))
            )


def _ranges(held: np.ndarray, drawn: np.ndarray) -> tuple[list[float], list[float]]:
    """Return ranges for movable points and what is drawn, as far as that is near to them."""
    if len(held):
        near = float(np.ptp(held, axis=0).max() / 4) or np.inf
        beyond = (drawn < held.min(axis=0) - near) | (drawn > held.max(axis=0) + near)
        drawn = drawn[~beyond.any(axis=1)]
    points = np.concatenate([held, drawn])
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        return [0.0, 1.0], [0.0, 1.0]
    low, high = points.min(axis=0), points.max(axis=0)
    extent = float((high - low).max()) or 1.0
    # A flat drawing still gets a third of its width as height: points want to be dragged there.
    missing = np.maximum(0, 0.4 * extent - (high - low)) / 2
    low, high = low - missing - _MARGIN * extent, high + missing + _MARGIN * extent
    return [float(low[0]), float(high[0])], [float(low[1]), float(high[1])]


def snap_for(rows: np.ndarray) -> float:
    """Return the power of two by which points of this extent move: 1/8 for 8 units.

    >>> snap_for(np.array([[0, 0], [8, 3]])), snap_for(np.array([[0, 0], [1500, 900]]))
    (0.125, 16.0)
    """
    extent = float(np.ptp(rows, axis=0).max()) or 8.0
    return float(2.0 ** np.floor(np.log2(extent / 48)))

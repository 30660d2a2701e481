"""A scene drawn by matplotlib: posters, print, and slides."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np

from numeric import Tape
from symbolic.errors import BadValue, shown

from .extent import evaluate
from .palette import colour

_SCRIPTED = re.compile(r"[A-Za-z]+'?([_^]([A-Za-z0-9]|\{[A-Za-z0-9, ]+\}))+")
_MOST_LABELS = 40  # more cannot be read, and each costs matplotlib some 10 ms
_BACKGROUND = {"light": "#ffffff", "dark": "#111418"}


def draw(scene: dict[str, Any], state: dict[str, Any], step: int, theme: str = "light") -> Any:
    """Return a matplotlib Figure of a scene in a given state.

    No pyplot: the figure belongs to the caller, and no back end is touched.
    """
    from matplotlib.figure import Figure

    if theme not in _BACKGROUND:
        raise BadValue("the theme light or dark", shown(theme), "Choose one of these.")
    outputs = evaluate(scene, state, Tape.from_json(scene["tape"]))
    views = scene["views"]
    picture = Figure(figsize=(6.4 * len(views), 4.4), layout="constrained")
    picture.set_facecolor(_BACKGROUND[theme])
    axes = picture.subplots(1, len(views), squeeze=False)[0]
    for number, (axis, view) in enumerate(zip(axes, views, strict=True)):
        _frame(axis, view, theme)
        for order, mark in enumerate(scene["marks"]):
            if mark.get("view") == number and _visible(mark, step):
                _KINDS[mark["kind"]](axis, mark, outputs[mark["output"]], theme, order)
        for group in scene["points"]:
            if group["view"] == number and _visible(group, step):
                _handles(axis, group, np.asarray(state[group["name"]]), theme)
    if scene["title"]:
        picture.suptitle(scene["title"], color=colour("curve", theme), fontsize=12)
    return picture


def _visible(shown: dict[str, Any], step: int) -> bool:
    until = shown.get("until")
    return bool(shown.get("from", 0) <= step and (until is None or step <= until))


def _frame(axis: Any, view: dict[str, Any], theme: str) -> None:
    axis.set(xlim=view["x"], ylim=view["y"], facecolor=_BACKGROUND[theme])
    if view["equal"]:
        axis.set_aspect("equal", adjustable="box")
    axis.grid(color=colour("muted", theme), linewidth=0.5)
    axis.tick_params(colors=colour("construction", theme), labelsize=8, length=0)
    for spine in axis.spines.values():
        spine.set_visible(False)
    if view["title"]:
        axis.set_title(_math(view["title"]), color=colour("curve", theme), fontsize=10)


def _path(axis: Any, mark: dict[str, Any], output: np.ndarray, theme: str, order: int) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    rows = output if mark["axis"] is None else np.swapaxes(output, 0, 1)
    rows = rows.reshape(len(rows), -1, 2)  # pieces of one point, for a polyline
    ends = np.cumsum(mark["pieces"] or [len(rows)])
    subpaths = [part.reshape(-1, 2) for part in np.split(rows, ends[:-1])]
    path = Path.make_compound_path(*(_subpath(Path, p, mark["closed"]) for p in subpaths))
    line = colour(mark["color"], theme)
    axis.add_patch(
        PathPatch(
            path, edgecolor=line, facecolor=line + "22" if mark["fill"] else "none",
            linewidth=mark["width"] * 0.75, linestyle="--" if mark["dashed"] else "-",
            capstyle="round", joinstyle="round", zorder=2 + order / 1000,
        )
    )  # fmt: skip


def _subpath(path: Any, points: np.ndarray, closed: bool) -> Any:
    if closed:
        points = np.concatenate([points, points[:1]])
    return path(points, closed=closed)


def _dots(axis: Any, mark: dict[str, Any], output: np.ndarray, theme: str, order: int) -> None:
    colors = [colour(c, theme) for c in mark["colors"]]
    axis.scatter(*output.T, s=(mark["radius"] * 1.5) ** 2, c=colors, zorder=4 + order / 1000)
    labels = (mark["labels"] or ()) if len(output) <= _MOST_LABELS else ()
    for label, point, text in zip(labels, output, colors, strict=False):
        if np.isfinite(point).all():
            _label(axis, label, point, text)


def _arrows(axis: Any, mark: dict[str, Any], output: np.ndarray, theme: str, order: int) -> None:
    for start, end in output:
        axis.annotate(
            "", xy=end, xytext=start, zorder=3,
            arrowprops={"arrowstyle": "-|>", "color": colour(mark["color"], theme),
                        "linewidth": mark["width"] * 0.75, "shrinkA": 0, "shrinkB": 6},
        )  # fmt: skip


def _hull(axis: Any, mark: dict[str, Any], output: np.ndarray, theme: str, order: int) -> None:
    line = colour(mark["color"], theme)
    axis.fill(*_convex_hull(output).T, facecolor=line + "22", edgecolor=line, linewidth=1.5,
              zorder=2 + order / 1000)  # fmt: skip


def _convex_hull(points: np.ndarray) -> np.ndarray:
    """Return the corners of the convex hull, by Andrew's monotone chain.

    >>> _convex_hull(np.array([[0, 0], [1, 1], [2, 0], [1, 3]])).tolist()
    [[0, 0], [2, 0], [1, 3]]
    """
    corners: list[Any] = []
    for ordered in (sorted(points.tolist()), sorted(points.tolist(), reverse=True)):
        chain: list[Any] = []
        for p in ordered:
            while len(chain) > 1 and not _turns_left(chain[-2], chain[-1], p):
                chain.pop()
            chain.append(p)
        corners += chain[:-1]
    return np.array(corners)


def _turns_left(a: Any, b: Any, c: Any) -> bool:
    return bool((b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]))


def _handles(axis: Any, group: dict[str, Any], points: np.ndarray, theme: str) -> None:
    """Draw movable points as squares, so that shape alone tells them from fixed ones."""
    colors = [colour(c, theme) for c in group["colors"]]
    axis.scatter(*points.T, s=64, marker="s", facecolors=_BACKGROUND[theme], edgecolors=colors,
                 linewidths=2, zorder=6)  # fmt: skip
    labels = group["labels"] if len(points) <= _MOST_LABELS else ()
    for label, point, text in zip(labels, points, colors, strict=False):
        _label(axis, label, point, text)


def _label(axis: Any, label: str, point: np.ndarray, color: str) -> None:
    """Write a label beside a point, away from the middle, where the lines are."""
    from matplotlib.patheffects import withStroke

    halo = withStroke(linewidth=3, foreground=axis.get_facecolor())
    outwards = point - [np.mean(axis.get_xlim()), np.mean(axis.get_ylim())]
    shift = 14 * outwards / (np.hypot(*outwards) or 1)
    shown_label = _math(label)
    axis.annotate(shown_label, point, parse_math=shown_label != label, xytext=shift,
                  textcoords="offset points", ha="center", va="center", color=color, fontsize=12,
                  math_fontfamily="stix", path_effects=[halo], zorder=7)  # fmt: skip


def _math(label: str) -> str:
    """Turn the labels' notation into mathtext: b_0^1 to $b_0^1$, plain words stay.

    >>> _math("b_0^1"), _math("left part")
    ('$b_0^1$', 'left part')
    """
    return f"${label}$" if _SCRIPTED.fullmatch(label) else label


_KINDS: dict[str, Callable[..., None]] = {
    "path": _path, "hull": _hull, "dots": _dots, "arrows": _arrows,
}  # fmt: skip

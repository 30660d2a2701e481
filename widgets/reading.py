"""Reading what the author of a scene gives, so that mistakes are told where they are made."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from numeric import flattened, float_points, real_number
from symbolic.errors import BadType, BadValue, shown
from symbolic.exact import whole_number

from .palette import PALETTE

_LARGEST = 1e12  # coordinates beyond lose the eighths that points snap to
_ROLES = [role for role in PALETTE["light"] if role != "points"]
# The shape of a mark's output; None stands for any number of rows.
_SHAPES: dict[str, tuple[int | None, ...]] = {
    "path": (None, 2), "hull": (None, 2), "dots": (None, 2), "arrows": (None, 2, 2),
    "scheme": (None, 2), "weights": (None,),
}  # fmt: skip


def plane_points(values: Any) -> np.ndarray:
    """Return points of the plane, shape (n, 2), of a size that a drawing can show."""
    rows = float_points(values)
    if rows.shape[1] != 2 or np.abs(rows).max() > _LARGEST:
        raise BadValue(
            f"points in the plane, shape (n, 2), up to {_LARGEST:g}",
            f"shape {rows.shape}, up to {np.abs(rows).max():g}",
            "Give x and y, in units that suit the figure.",
        )
    return rows


def output_size(kind: str, output: Any) -> int:
    """Return how many rows a mark's output has, once its shape is right."""
    shape, _ = flattened(output)
    wanted = _SHAPES.get(kind)
    fits = wanted is None or (
        len(shape) == len(wanted)
        and all(w in (None, s) for w, s in zip(wanted, shape, strict=True))
    )
    if not fits:
        rows = "n" if wanted else ""
        inner = ", ".join(str(size) for size in (wanted or ())[1:])
        raise BadValue(
            f"expressions of shape ({rows}, {inner}) for {kind}",
            f"shape {shape}", "Give a list of points, each (x, y).",
        )  # fmt: skip
    return shape[0] if shape else 1


def colours(given: Any, count: int) -> list[int | str]:
    """Return one colour for each of `count` things: an index into the palette, or a role."""
    listed = list(given) if isinstance(given, list | tuple | range) else [given]
    for one in listed:
        index = whole_number(one)
        if (index is None or index < 0) and not (isinstance(one, str) and one in _ROLES):
            raise BadValue(
                f"a colour: 0, 1, 2, ... or {', '.join(_ROLES)}", shown(one), "Choose one."
            )
    return [c if isinstance(c, str) else int(c) for c in _one_each("colours", listed, count)]


def labels(given: Sequence[str] | None, count: int) -> list[str] | None:
    """Return one label for each of `count` things, without the dollars of TeX."""
    if given is None:
        return None
    if isinstance(given, str) or not all(isinstance(label, str) for label in given):
        raise BadType("a list of texts as labels", shown(given), 'Write ["b_0", "b_1"].')
    return [label.strip("$") for label in _one_each("labels", list(given), count)]


def positive(value: Any, what: str) -> float:
    """Return a positive finite number."""
    number = real_number(value, what)
    if number <= 0:
        raise BadValue(f"a positive {what}", shown(value), "Leave it away for the usual one.")
    return number


def span(low: Any, high: Any) -> tuple[float, float]:
    """Return a range of finite numbers, low < high."""
    ends = real_number(low, "low"), real_number(high, "high")
    if not ends[0] < ends[1]:
        raise BadValue("low < high", f"{ends[0]:g} and {ends[1]:g}", "Exchange them.")
    return ends


def text(value: Any, what: str) -> str:
    """Return a text."""
    if not isinstance(value, str):
        raise BadType(f"a text as {what}", shown(value), "Put it in quotes.")
    return value


def _one_each(what: str, given: list[Any], count: int) -> list[Any]:
    if len(given) != count:
        raise BadValue(f"{count} {what}", f"{len(given)}", "Give one for each.")
    return given

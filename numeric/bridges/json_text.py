"""Curves and contours as plain JSON: their own attributes, lists of numbers."""

from __future__ import annotations

import json
from typing import Any, NoReturn

import numpy as np

from symbolic.errors import BadType, BadValue, shown

from ..curve import Curve
from ..curves.making import read_breaks
from .contour import Contour

CURVE, CONTOUR = ("rows", "breaks", "rational"), ("vertices", "degrees", "closed", "weights")


def to_json(curves: Any) -> str:
    """Return JSON text of a curve, a contour, or a list or tuple of these.

    An object holds the attributes of a `Curve`, "rows", "breaks" and "rational", or those of a
    `Contour`, "vertices", "degrees", "closed" and "weights". Every number is the shortest that
    reads back as the same float: nothing is lost.

    Raises
    ------
    BadValue
        For numbers that overflowed to infinity.
    BadType
        For anything else.

    Examples
    --------
    >>> to_json(Curve.from_bezier([[0, 0], [1, 2]]))
    '{"rows": [[[0.0, 0.0], [1.0, 2.0]]], "breaks": [0.0, 1.0], "rational": false}'
    """
    if isinstance(curves, list | tuple):
        return json.dumps([_plain(curve) for curve in curves])
    return json.dumps(_plain(curves))


def from_json(data: Any) -> Any:
    """Return what `to_json` wrote, from its text or from what `json.loads` made of that.

    Everything is checked, so that data may come from anyone. A list gives a tuple.

    Raises
    ------
    BadValue
        For text that is no JSON, names that are missing or unknown, arrays of another shape, and
        whatever no curve can be made of.
    BadType
        For other types, such as text in place of a number.

    Examples
    --------
    >>> from_json('{"rows": [[[0, 0], [1, 2]]], "breaks": [0, 1], "rational": false}')(0.5)
    array([0.5, 1. ])
    """
    if isinstance(data, str | bytes | bytearray):
        data = _loaded(data)
    if isinstance(data, list | tuple):
        return tuple(_made(entry) for entry in data)
    return _made(data)


def _plain(value: Any) -> dict[str, Any]:
    if not isinstance(value, Curve | Contour):
        raise BadType("a curve or contours", shown(value), "Make one with Curve.from_bezier.")
    names = CURVE if isinstance(value, Curve) else CONTOUR
    held = {name: getattr(value, name) for name in names}
    if not all(np.isfinite(v).all() for v in held.values() if isinstance(v, np.ndarray)):
        raise BadValue("finite numbers for JSON", repr(value), "Something overflowed: scale it.")
    return {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in held.items()}


def _loaded(text: str | bytes | bytearray) -> Any:
    def refuse(constant: str) -> NoReturn:
        raise BadValue("finite numbers in JSON", constant, "Leave such points out.")

    try:
        return json.loads(text, parse_constant=refuse)
    except BadValue:
        raise
    except (ValueError, RecursionError) as error:  # also digits or brackets by the thousands
        raise BadValue("JSON text", f"{shown(text)} ({error})", "Write it with to_json.") from None


def _made(data: Any) -> Curve | Contour:
    if not isinstance(data, dict):
        raise BadType("a JSON object of a curve", shown(data), "Write it with to_json.")
    names = CONTOUR if "vertices" in data else CURVE
    if set(data) != set(names):
        raise BadValue(
            f"the names {', '.join(names)}", shown(sorted(map(str, data))), "Write it with to_json."
        )
    flag = names[2]
    if not isinstance(data[flag], bool):
        raise BadType(f'true or false as "{flag}"', shown(data[flag]), "Write it with to_json.")
    if names is CONTOUR:
        weights = None if data["weights"] is None else _numbers(data, "weights", 1)
        vertices, degrees = _numbers(data, "vertices", 2), _numbers(data, "degrees", 1)
        return Contour(vertices, degrees, data["closed"], weights)
    rows, breaks = _numbers(data, "rows", 3), _numbers(data, "breaks", 1)
    if not rows.size or rows.shape[2] <= data["rational"] or len(breaks) != len(rows) + 1:
        raise BadValue(
            "rows for one segment or more, at least one coordinate, and one break more than "
            "segments",
            f"shapes {rows.shape} and {breaks.shape}",
            "Write it with to_json.",
        )
    return Curve(rows, read_breaks(breaks, len(rows)), data["rational"])


def _numbers(data: dict[str, Any], name: str, axes: int) -> np.ndarray:
    """Return nested lists of finite numbers as an array with this number of axes."""
    try:
        entries = np.array(data[name], dtype=object)
    except ValueError:
        entries = np.empty(0, dtype=object)
    if entries.ndim != axes:
        raise BadValue(
            f'"{name}" as numbers in lists {axes} deep, all of one length', shown(data[name]),
            "Write it with to_json.",
        )  # fmt: skip
    wrong = [entry for entry in entries.flat if type(entry) not in (int, float)]
    if wrong:
        raise BadType(f'numbers in "{name}"', shown(wrong[0]), "Write it with to_json.")
    try:
        array = entries.astype(float)
    except OverflowError:
        array = np.array(np.inf)
    if not np.isfinite(array).all():
        raise BadValue(f'numbers below 1.8e308 in "{name}"', "a larger one", "Scale the curve.")
    return array

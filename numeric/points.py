"""Reading control points as float64 arrays, with the same care as `symbolic` reads them exactly."""

from __future__ import annotations

from typing import Any

import numpy as np

from symbolic.errors import BadType, BadValue, shown


def float_points(points: Any) -> np.ndarray:
    """Return control points as a float64 array of rows, shape (n, dim).

    Lists, tuples, Fractions, SymPy numbers and arrays are accepted.

    Raises
    ------
    BadValue
        For no points, ragged rows, a flat list of numbers, NaN or infinity.
    BadType
        For text, complex numbers, and expressions that are not numbers.

    Examples
    --------
    >>> from fractions import Fraction
    >>> float_points([(0, 1), (Fraction(1, 2), 2)])
    array([[0. , 1. ],
           [0.5, 2. ]])
    """
    array = _array(points)
    if array.ndim != 2:
        raise BadValue(
            "control points as rows, shape (n, dim)",
            f"shape {array.shape}",
            "Write [[0], [1], [3]] for points on a line, [[0, 0], [1, 2]] in the plane.",
        )
    if not array.size:
        raise BadValue("at least one control point", "none", "Give rows like [[0, 0], [1, 2]].")
    if not np.isfinite(array).all():
        row, column = np.argwhere(~np.isfinite(array))[0]
        raise BadValue(
            "finite coordinates",
            f"{array[row, column]} in point {row}, coordinate {column}",
            "Leave such points out.",
        )
    return array


def real_array(values: Any, what: str) -> np.ndarray:
    """Return a number or numbers in any nesting as a float64 array; NaN passes.

    An array of float64 is returned as it is, not copied.

    >>> real_array([1, 2.5], "parameters")
    array([1. , 2.5])
    """
    try:
        array = np.asarray(values)
        foreign = array.dtype.kind == "O" and any(
            entry is None or isinstance(entry, str | bytes | bool) for entry in array.flat
        )
        if array.dtype.kind in "iufO" and not foreign:
            return array.astype(float, copy=False)
    except OverflowError:  # of an int or Fraction
        raise _too_large(values) from None
    except (TypeError, ValueError):
        pass
    raise BadType(f"real numbers as {what}", shown(values), "Give a number or an array of numbers.")


def real_number(value: Any, what: str) -> float:
    """Return one finite number as a float.

    >>> from fractions import Fraction
    >>> real_number(Fraction(3, 8), "t")
    0.375
    """
    array = real_array(value, what)
    if array.ndim or not np.isfinite(array):
        raise BadValue(f"a finite number as {what}", shown(value), "Give one number.")
    return float(array)


def _array(points: Any) -> np.ndarray:
    if isinstance(points, np.ndarray) and points.dtype.kind in "iuf":
        return points.astype(float)
    if hasattr(points, "tolist"):
        points = points.tolist()
    try:
        entries = np.array(points, dtype=object)
    except ValueError:
        raise _ragged(points) from None
    flat = entries.ravel()
    if any(entry is None or isinstance(entry, str | bytes | bool) for entry in flat):
        raise BadType("numbers as coordinates", shown(points), "Text is never parsed.")
    if any(isinstance(entry, list | tuple) for entry in flat):
        raise _ragged(points)
    try:
        return entries.astype(float)
    except OverflowError:  # of an int or Fraction
        raise _too_large(points) from None
    except (TypeError, ValueError):
        raise BadType(
            "real numbers as coordinates", shown(points), "Substitute values for symbols first."
        ) from None


def _ragged(points: Any) -> BadValue:
    return BadValue(
        "control points of one dimension",
        shown(points),
        "Give every point the same number of coordinates.",
    )


def _too_large(values: Any) -> BadValue:
    return BadValue("numbers that floats can hold", shown(values), "Scale them below 1.8e308.")

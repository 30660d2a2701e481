"""The operations a tape may use: the one table that the compiler, NumPy and the browser share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np


def _step(x: Any, out: Any = None) -> Any:
    """Return 1 where x >= 0, else 0; NaN gives NaN."""
    return np.heaviside(x, 1.0, out=out)


def _ratio(a: Any, b: Any, out: Any = None) -> Any:
    """Return a/b, and 0 where b is 0: what 0/0 means in the recurrence of B-splines."""
    none = np.asarray(b) == 0
    out = np.divide(a, b, out=out)
    if np.ndim(out) == 0:
        return np.where(none, 0.0, out)[()]
    np.copyto(out, 0.0, where=none)
    return out


UNARY: dict[str, Callable[..., Any]] = {
    "neg": np.negative,
    "sqrt": np.sqrt,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "exp": np.exp,
    "log": np.log,
    "abs": np.abs,
    "step": _step,
}
BINARY: dict[str, Callable[..., Any]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "div": np.divide,
    "pow": np.power,
    "atan2": np.arctan2,
    "min": np.minimum,
    "max": np.maximum,
    "ratio": _ratio,
}
KERNELS = UNARY | BINARY
ARITY = dict.fromkeys(UNARY, 1) | dict.fromkeys(BINARY, 2)

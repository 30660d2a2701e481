"""The operations a tape may use: the one table that the compiler, NumPy and the browser share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

UNARY: dict[str, Callable[..., Any]] = {
    "neg": np.negative,
    "sqrt": np.sqrt,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "exp": np.exp,
    "log": np.log,
    "abs": np.abs,
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
}
KERNELS = UNARY | BINARY
ARITY = dict.fromkeys(UNARY, 1) | dict.fromkeys(BINARY, 2)

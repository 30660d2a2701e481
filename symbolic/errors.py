"""Every error this package raises: what was expected, what came, and how to mend it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

TOO_LONG = "(numbers of thousands of digits)"


class _Explained(Exception):
    """An error made of three facts, so that none of them can be forgotten."""

    def __init__(self, expected: str, received: str, remedy: str) -> None:
        self.expected, self.received, self.remedy = expected, received, remedy
        super().__init__(f"Expected {expected}, received {received}. {remedy}")

    def __reduce__(self) -> tuple[type, tuple[str, str, str]]:
        # Errors cross process borders (kernels, workers); the message alone would not rebuild.
        return type(self), (self.expected, self.received, self.remedy)


class BadValue(_Explained, ValueError):
    """A value of the right type that cannot be used."""


class BadType(_Explained, TypeError):
    """A value of a type that cannot be used."""


class NotExact(BadType):
    """A float where exact mathematics needs a rational number."""


class OutsideDomain(BadValue):
    """A parameter outside the interval on which a curve is defined."""


class UnsolvableConstraints(BadValue):
    """Constraints that contradict each other or do not determine a curve."""


def shown(value: object, limit: int = 80) -> str:
    """Return a short one-line picture of any value, for error messages.

    Expressions that share their parts would take forever to print: they are only named.

    >>> shown("a" * 200, limit=12)
    "'aaaaaaaa..."
    """
    if _is_long(value):
        return f"a long {type(value).__name__}"
    text = " ".join(written(value, repr).split())
    return text if len(text) <= limit else text[: limit - 3] + "..."


def _is_long(value: object, limit: int = 5000) -> bool:
    """Tell whether a list or expression has many parts, shared ones counted where they occur."""
    stack, count = [value], 0
    while stack and count <= limit:
        node = stack.pop()
        parts = node if isinstance(node, list | tuple) else getattr(node, "args", ())
        if isinstance(parts, list | tuple):
            stack.extend(parts)
        count += 1
    return count > limit


def written(value: object, printer: Callable[[Any], str] = str) -> str:
    """Return a value as text, also where Python refuses to write its numbers out.

    >>> written(3), written(10**5000)
    ('3', '(numbers of thousands of digits)')
    """
    try:
        return printer(value)
    except ValueError:  # beyond sys.get_int_max_str_digits(), since writing takes so long
        return TOO_LONG

"""The grammar of SVG path data (SVG 2, section 9.3.9): commands and their numbers.

Every pattern is possessive, that is, never tries again what it has matched: time grows linearly.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import isfinite

from symbolic.errors import BadType, BadValue, shown

_UPPER = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
ARGUMENTS = _UPPER | {letter.lower(): count for letter, count in _UPPER.items()}

_SPACES = r"[ \t\n\f\r]*+"
_SEPARATOR = rf"{_SPACES},?+{_SPACES}"
_ONE = r"[+-]?+(?>[0-9]++\.?+[0-9]*+|\.[0-9]++)(?:[eE][+-]?+[0-9]++)?+"
SPACES = re.compile(_SPACES)
SEPARATOR = re.compile(_SEPARATOR)
NUMBER = re.compile(_ONE)
NUMBERS = re.compile(rf"{_SPACES}{_ONE}(?:{_SEPARATOR}{_ONE})*+{_SPACES}")
FLAG = re.compile("[01]")

# Flags need no separators: a1 1 0 00.5.5 is two radii, a rotation, two flags and a point.
ARC = [(NUMBER, "a number")] * 3 + [(FLAG, "a flag, 0 or 1")] * 2 + [(NUMBER, "a number")] * 2


def commands(text: str) -> Iterator[tuple[str, list[float], int]]:
    """Yield every command's letter, its numbers, and the position of the letter.

    Raises
    ------
    BadValue
        Where the text leaves the grammar: at which character, and what was expected there.

    Examples
    --------
    >>> list(commands("M1.5.5-3,4z"))
    [('M', [1.5, 0.5, -3.0, 4.0], 0), ('z', [], 10)]
    """
    if not isinstance(text, str):
        raise BadType("path data as text", shown(text), 'Such as "M0 0 L1 2".')
    at = _skip(SPACES, text, 0)
    while at < len(text):
        letter = text[at]
        count = ARGUMENTS.get(letter)
        if count is None:
            raise _unexpected(text, at, "a command, one letter of MLHVCSQTAZ")
        if letter in "Aa":
            numbers, end = _arcs(text, at + 1)
        elif count:
            numbers, end = _numbers(text, at + 1, count)
        else:
            numbers, end = [], at + 1
        if not all(map(isfinite, numbers)):
            raise _unexpected(text, at, "numbers below 1.8e308 in this command")
        yield letter, numbers, at
        at = _skip(SPACES, text, end)


def _numbers(text: str, at: int, count: int) -> tuple[list[float], int]:
    found = NUMBERS.match(text, at)
    if not found:
        raise _unexpected(text, _skip(SPACES, text, at), "a number")
    numbers = list(map(float, NUMBER.findall(found[0])))
    if len(numbers) % count:
        missing = count - len(numbers) % count
        end = _skip(SEPARATOR, text, found.end())
        raise _unexpected(text, end, f"{missing} more number{'s' if missing > 1 else ''}")
    return numbers, found.end()


def _arcs(text: str, at: int) -> tuple[list[float], int]:
    numbers: list[float] = []
    end, start = at, _skip(SPACES, text, at)
    while not numbers or NUMBER.match(text, start):
        for pattern, what in ARC:
            found = pattern.match(text, start)
            if not found:
                raise _unexpected(text, start, f"{what} of an arc")
            numbers.append(float(found[0]))
            end = found.end()
            start = _skip(SEPARATOR, text, end)
    return numbers, end


def _skip(pattern: re.Pattern[str], text: str, at: int) -> int:
    found = pattern.match(text, at)
    return found.end() if found else at


def _unexpected(text: str, at: int, expected: str) -> BadValue:
    received = shown(text[at : at + 20]) if at < len(text) else "the end"
    return BadValue(
        f"{expected} at character {at}", received, "See the SVG specification's chapter on paths."
    )

"""Names for symbols of our own that are not those of the reader's symbols."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from .dag import symbols_in


def unused_letter(letters: str, expressions: Iterable[sp.Basic]) -> str:
    """Return the first of the letters with which no symbol begins; doubled, if all are taken.

    >>> a, u1, v = sp.symbols("a u1 v")
    >>> unused_letter("uvw", [a + u1, v]), unused_letter("uv", [u1*v])
    ('w', 'uu')
    """
    taken = {symbol.name for symbol in symbols_in(expressions)}
    times = 1
    while True:
        for letter in letters:
            if not any(name.startswith(letter * times) for name in taken):
                return letter * times
        times += 1

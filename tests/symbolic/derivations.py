"""Every derivation the package offers, for the tests that hold all of them to account.

A room adds its derivations here: a name, and a function without arguments that builds one. Keep
degrees small: every step is corrupted in several ways and decided again.
"""

from collections.abc import Callable

from symbolic import Derivation, bezier, hermite

DERIVATIONS: list[tuple[str, Callable[[], Derivation]]] = [
    ("Bezier 3", lambda: bezier(3).derivation),
    ("Hermite 3", lambda: hermite(3).derivation),
    ("Hermite 5", lambda: hermite(5).derivation),
]

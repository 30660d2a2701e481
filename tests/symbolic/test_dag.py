"""Rewriting expressions as graphs."""

import sympy as sp

from symbolic.dag import substitute

t, x = sp.symbols("t x")


def test_what_was_put_in_is_not_replaced_again():
    """1 - (1 - t) collapses to t, which must stay."""
    assert substitute([3 * t * (1 - t) ** 2], {t: 1 - t}) == [3 * t**2 * (1 - t)]
    assert substitute([t + x], {t: x, x: t}) == [t + x]
    assert substitute([x - t], {t: x, x: t}) == [t - x]

"""High degrees: what the Bernstein form keeps and the power form loses, as documented."""

from functools import cache

import numpy as np
import pytest

from benchmarks.stability import worst_errors
from numeric.curves.evaluation import HORNER_DEGREE

# At `HORNER_DEGREE`: float64 and float32 in Bernstein form, then in power form.
DOCUMENTED = {3: (3e-16, 2e-7, 6e-16, 6e-7), 7: (5e-16, 3e-7, 4e-14, 2e-5),
              12: (6e-16, 3e-7, 5e-12, 8e-3), 25: (2e-15, 6e-7, 2e-5, np.inf)}  # fmt: skip
COLUMNS = [("Bernstein", "float64"), ("Bernstein", "float32"),
           ("powers", "float64"), ("powers", "float32")]  # fmt: skip


@cache
def errors(degree):
    return worst_errors(degree, np.random.default_rng(degree))


@pytest.mark.parametrize("degree", DOCUMENTED)
def test_the_documented_errors_hold_within_a_factor_of_two(degree):
    for column, bound in zip(COLUMNS, DOCUMENTED[degree], strict=True):
        assert errors(degree)[column] <= 2 * bound, column


@pytest.mark.parametrize("degree", [2, 15, 25])
def test_the_bernstein_form_loses_no_digits(degree):
    assert errors(degree)["Bernstein", "float64"] < 10 * 2.3e-16
    assert errors(degree)["Bernstein", "float32"] < 10 * 1.2e-7


def test_the_power_form_loses_them_with_the_degree():
    lost = {
        n: errors(n)["powers", "float64"] / errors(n)["Bernstein", "float64"] for n in (7, 15, 25)
    }
    assert 10 < lost[7] < 1e3 < lost[15] < lost[25] and lost[25] > 1e8
    assert errors(25)["powers", "float32"] > 1 > errors(HORNER_DEGREE)["powers", "float32"]

"""High degrees: what the Bernstein form keeps and the power form loses, as documented."""

from fractions import Fraction
from functools import cache

import numpy as np
import pytest

from benchmarks.stability import worst_errors
from numeric import Curve
from numeric.curves.evaluation import HORNER_DEGREE
from symbolic import RationalBezier

# At `HORNER_DEGREE`: float64 and float32 in Bernstein form, then in power form.
DOCUMENTED = {3: (4e-16, 3e-7, 3e-15, 2e-6), 7: (8e-16, 4e-7, 3e-13, 2e-4),
              12: (1e-15, 5e-7, 3e-11, 2e-2), 25: (2e-15, 1e-6, 1e-4, np.inf)}  # fmt: skip
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


@pytest.mark.parametrize("spread", [1, 4, 12])
@pytest.mark.parametrize("degree", [1, 3, HORNER_DEGREE, HORNER_DEGREE + 1])
def test_weights_of_very_different_sizes_lose_no_digits(degree, spread):
    """By powers, a point where weights are small would have the error of the largest one."""
    random = np.random.default_rng(spread)
    weights = 10 ** random.uniform(-spread, spread, degree + 1)
    points = random.uniform(-1, 1, (degree + 1, 2))
    exact = RationalBezier([[Fraction(x) for x in p] for p in points.tolist()],
                           [Fraction(w) for w in weights.tolist()])  # fmt: skip
    curve = Curve.from_bezier(points, weights=weights)
    at = [k / 32 for k in range(33)]
    expected = [[float(x) for x in exact.de_casteljau(Fraction(u)).points[-1][0]] for u in at]
    np.testing.assert_allclose(curve(at), expected, rtol=0, atol=4e-15 if spread > 1 else 4e-13)

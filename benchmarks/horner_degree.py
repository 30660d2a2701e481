"""Up to which degree is Horner's rule accurate enough? The measurement behind HORNER_DEGREE.

The largest error against exact rational values, relative to the largest control point, over
random control points and the alternating ones, which are the worst case of the power form.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from numeric.curve import Curve
from numeric.curves import evaluation as module
from symbolic import de_casteljau

PARAMETERS = [Fraction(k / 37) for k in range(38)]  # floats, taken exactly


def polygons(degree: int, random: np.random.Generator) -> list[list[Fraction]]:
    """Return the alternating control polygon and some random ones."""
    alternating = [Fraction((-1) ** i) for i in range(degree + 1)]
    drawn = random.uniform(-1, 1, (8, degree + 1)).tolist()
    return [alternating, *([Fraction(v) for v in row] for row in drawn)]


def worst_error(points: list[Fraction], exact: list[float]) -> float:
    """Return the largest error of a curve with these control points, relative to them."""
    ours = Curve.from_bezier([[p] for p in points])([float(t) for t in PARAMETERS])[:, 0]
    return float(np.abs(ours - exact).max() / max(abs(float(p)) for p in points))


def main() -> None:
    """Print a line a degree: the error of Horner's rule and of the Bernstein form."""
    chosen, random = module.HORNER_DEGREE, np.random.default_rng(0)
    print(f"{'degree':>6} {'Horner':>9} {'Bernstein':>9}")
    for degree in range(1, 26):
        errors = {0: 0.0, 99: 0.0}
        for points in polygons(degree, random):
            rows = [[p] for p in points]
            exact = [float(de_casteljau(rows, t)[-1][0][0]) for t in PARAMETERS]
            for highest in errors:
                module.HORNER_DEGREE = highest
                errors[highest] = max(errors[highest], worst_error(points, exact))
        mark = "  <- Curve uses Horner up to here" if degree == chosen else ""
        print(f"{degree:6} {errors[99]:9.1e} {errors[0]:9.1e}{mark}")


if __name__ == "__main__":
    main()

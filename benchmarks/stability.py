"""How many digits are lost at high degree, in Bernstein and in power form: float64 and float32.

The largest error against exact rational values, relative to the largest control point, over
random control points and the alternating ones, which are the worst case of the power form. It is
the measurement behind `HORNER_DEGREE`. `--picture FILE` draws it.
"""

from __future__ import annotations

import argparse
from fractions import Fraction
from typing import Any

import numpy as np
import sympy as sp

from numeric.bernstein.evaluation import point_tape
from numeric.curves.evaluation import HORNER_DEGREE
from numeric.tape.operations import KERNELS
from symbolic import bezier, de_casteljau

PARAMETERS = [Fraction(k / 37) for k in range(38)]  # floats, taken exactly
DEGREES = range(1, 26)
FORMS = {"Bernstein": False, "powers": True}
FLOATS = {"float64": np.float64, "float32": np.float32}


def polygons(degree: int, random: np.random.Generator) -> list[list[Fraction]]:
    """Return the alternating control polygon and some random ones, exact in either precision."""
    alternating = [Fraction((-1) ** i) for i in range(degree + 1)]
    drawn = random.uniform(-1, 1, (8, degree + 1)).astype(np.float32).tolist()
    return [alternating, *([Fraction(v) for v in row] for row in drawn)]


def evaluate(points: list[Fraction], horner: bool, kind: Any, t: np.ndarray) -> np.ndarray:
    """Return values of the tape that curves run, in a precision; powers are exact, then rounded."""
    numbers = points
    if horner:
        exact = bezier(len(points) - 1).matrix_as(powers="ascending") @ _column(points)
        numbers = [Fraction(int(x.p), int(x.q)) for x in exact]
    tape = point_tape(len(points) - 1, 1, False, horner)
    registers = [kind(float(n)) for n in numbers] + [t.astype(kind)]
    registers += [kind(c[0]) / kind(c[1]) if isinstance(c, tuple) else kind(c)
                  for c in tape.constants]  # fmt: skip
    for operation, *operands in tape.instructions:
        registers.append(KERNELS[operation](*(registers[r] for r in operands)))
    (output,) = tape.outputs.values()
    return np.asarray(registers[output.registers[0]], float)


def worst_errors(degree: int, random: np.random.Generator) -> dict[tuple[str, str], float]:
    """Return the largest relative error of either form in either precision."""
    errors = dict.fromkeys(((form, name) for form in FORMS for name in FLOATS), 0.0)
    for points in polygons(degree, random):
        rows = [[p] for p in points]
        size = max(abs(float(p)) for p in points)
        for name, kind in FLOATS.items():
            t = np.array([float(u) for u in PARAMETERS]).astype(kind)
            exact = [float(de_casteljau(rows, Fraction(float(u)))[-1][0][0]) for u in t]
            for form, horner in FORMS.items():
                found = evaluate(points, horner, kind, t)
                error = float(np.abs(found - exact).max()) / size
                errors[form, name] = max(errors[form, name], error)
    return errors


def _column(points: list[Fraction]) -> Any:
    return sp.Matrix([sp.Rational(p.numerator, p.denominator) for p in points])


def draw(errors: dict[int, dict[tuple[str, str], float]], file: str) -> None:
    """Save the errors as curves over the degree, on a logarithmic axis."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    colours = {"Bernstein": "#0072b2", "powers": "#d55e00"}
    for form, kind in next(iter(errors.values())):
        values = [max(told[form, kind], 1e-18) for told in errors.values()]
        style = "-" if kind == "float64" else "--"
        axes.plot(list(errors), values, style, color=colours[form], marker="o", markersize=3,
                  label=f"{form}, {kind}")  # fmt: skip
    axes.axvline(HORNER_DEGREE + 0.5, color="#6f6f6f", linewidth=0.8)
    axes.text(HORNER_DEGREE + 0.7, 1e1, "Curve changes to Bernstein", fontsize=8, color="#6f6f6f")
    axes.set(yscale="log", xlabel="degree", ylabel="largest error / largest control point")
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(fontsize=8, frameon=False)
    figure.savefig(file, dpi=150)
    plt.close(figure)


def main() -> None:
    """Print a line a degree."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--picture", help="file for a picture, such as a.png")
    picture = parser.parse_args().picture
    random = np.random.default_rng(0)
    columns = [(form, kind) for kind in FLOATS for form in FORMS]
    print(f"{'degree':>6}" + "".join(f" {f'{form}, {kind}':>18}" for form, kind in columns))
    errors = {}
    for degree in DEGREES:
        errors[degree] = worst_errors(degree, random)
        mark = "  <- Curve takes powers up to here" if degree == HORNER_DEGREE else ""
        print(f"{degree:6}" + "".join(f" {errors[degree][c]:18.1e}" for c in columns) + mark)
    if picture:
        draw(errors, picture)


if __name__ == "__main__":
    main()

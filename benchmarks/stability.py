"""How many digits are lost at high degree, in Bernstein and in power form: float64 and float32.

The largest error against exact rational values, relative to the largest control point, over
random control points and the alternating ones, which are the worst case of the power form: its
coefficients, made of them in the same precision, are up to 3^n times larger. It is the measurement
behind `HORNER_DEGREE`. `--picture FILE` draws it.
"""

from __future__ import annotations

import argparse
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import Any

import numpy as np

from numeric.bernstein.evaluation import point_tape
from numeric.curves.evaluation import HORNER_DEGREE
from numeric.tape.operations import KERNELS
from symbolic import bezier

PARAMETERS = np.arange(38) / 37
DEGREES = range(1, 26)
FORMS = {"Bernstein": False, "powers": True}
FLOATS = {"float64": np.float64, "float32": np.float32}


def polygons(degree: int, random: np.random.Generator) -> np.ndarray:
    """Return control points of size 1 a row: alternating ones, with random signs, and random."""
    alternating = np.outer(random.uniform(0.5, 1, 8), (-1.0) ** np.arange(degree + 1))
    signs = random.choice([-1.0, 1.0], (8, degree + 1)) * random.uniform(0.5, 1, (8, 1))
    return np.concatenate([alternating, signs, random.uniform(-1, 1, (8, degree + 1))])


def evaluate(points: np.ndarray, horner: bool, kind: Any, t: np.ndarray) -> np.ndarray:
    """Return values of the tape that curves run, in the precision of `points` and `t`."""
    n = len(points) - 1
    numbers = power_matrix(n).astype(kind) @ points if horner else points
    tape = point_tape(n, 1, False, horner)
    registers = [*numbers, t]
    registers += [kind(c[0]) / kind(c[1]) if isinstance(c, tuple) else kind(c)
                  for c in tape.constants]  # fmt: skip
    for operation, *operands in tape.instructions:
        registers.append(KERNELS[operation](*(registers[r] for r in operands)))
    (output,) = tape.outputs.values()
    return np.asarray(registers[output.registers[0]])


@lru_cache
def power_matrix(degree: int) -> np.ndarray:
    """Return the derived matrix that takes control points to coefficients of 1, t, ..., t^n."""
    return np.array(bezier(degree).matrix_as(powers="ascending").tolist(), dtype=float)


def exact_values(points: np.ndarray, t: np.ndarray) -> list[Fraction]:
    """Return sum C(n, i) u^i (1 - u)^(n - i) P_i at floats that are taken as they are."""
    n, exact = len(points) - 1, [Fraction(float(p)) for p in points]
    return [
        sum((comb(n, i) * u**i * (1 - u) ** (n - i) * p for i, p in enumerate(exact)), Fraction(0))
        for u in (Fraction(float(number)) for number in t)
    ]


def worst_errors(degree: int, random: np.random.Generator) -> dict[tuple[str, str], float]:
    """Return the largest relative error of either form in either precision."""
    errors = dict.fromkeys(((form, name) for form in FORMS for name in FLOATS), 0.0)
    for polygon in polygons(degree, random):
        for name, kind in FLOATS.items():
            points, t = polygon.astype(kind), PARAMETERS.astype(kind)
            exact = exact_values(points, t)
            size = float(np.abs(points).max())
            for form, horner in FORMS.items():
                found = evaluate(points, horner, kind, t)
                told = [abs(Fraction(float(v)) - e) for v, e in zip(found, exact, strict=True)]
                errors[form, name] = max(errors[form, name], float(max(told)) / size)
    return errors


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

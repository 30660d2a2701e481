"""One tape, three readers: NumPy, SymPy's lambdify and JavaScript agree."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from numeric import Tape, compile_tape, quotient_or_zero
from symbolic import BadType, BadValue, de_casteljau

ROOT = Path(__file__).parents[2]
x, y, t = INPUTS = sp.symbols("x y t", real=True)


class Node:
    """The browser's interpreter, run by Node over a pipe: one JSON line in, one line out."""

    def __init__(self, node):
        script = ROOT / "tests" / "front_end" / "run_tape.mjs"
        self.process = subprocess.Popen(
            [node, str(script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def run(self, tape, inputs, axes=()):
        job = {"tape": tape.to_json(), "axes": list(axes), "inputs": inputs}
        self.process.stdin.write(json.dumps(job) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def close(self):
        self.process.communicate()


@pytest.fixture(scope="module")
def javascript(node):
    interpreter = Node(node)
    yield interpreter
    interpreter.close()


def numbers(values):
    return np.array([float(value) for value in values])


leaves = st.one_of(
    st.sampled_from(INPUTS), st.fractions(-3, 3, max_denominator=9).map(sp.Rational), st.just(sp.pi)
)


def _bounded(a):
    """Return a bounded function: the sine of a huge number is all rounding, in every language."""
    return a / (a**2 + 1)


def _combine(children):
    pair = st.tuples(children, children)
    return st.one_of(
        pair.map(lambda ab: ab[0] + ab[1]),
        pair.map(lambda ab: ab[0] - ab[1]),
        pair.map(lambda ab: ab[0] * ab[1]),
        pair.map(lambda ab: ab[0] / (ab[1] ** 2 + 1)),
        pair.map(lambda ab: sp.atan2(ab[0], ab[1] ** 2 + 1)),
        pair.map(lambda ab: sp.Min(ab[0], ab[1])),
        pair.map(lambda ab: sp.Max(ab[0], ab[1])),
        pair.map(lambda ab: quotient_or_zero(ab[0], sp.Max(ab[1], 0) ** 2)),
        children.map(lambda a: sp.Heaviside(a + sp.Rational(1, 7), 1)),
        children.map(lambda a: a**3 / (a**4 + 1)),
        children.map(lambda a: sp.sqrt(a**2 + 1)),
        children.map(lambda a: (a**2 + 2) ** sp.Rational(-3, 2)),
        children.map(lambda a: sp.sin(_bounded(a)) - sp.cos(_bounded(a))),
        children.map(lambda a: sp.log(sp.Abs(a) + 1)),
        children.map(lambda a: sp.exp(-(a**2))),
    )


expressions = st.recursive(leaves, _combine, max_leaves=8)
values = st.floats(-2, 2).map(lambda v: round(v, 6))


@settings(max_examples=200, deadline=None)
@given(st.lists(expressions, min_size=1, max_size=4), st.tuples(values, values, values))
def test_numpy_lambdify_and_javascript_agree(javascript, formulas, at):
    tape = compile_tape({"f": formulas}, INPUTS)
    ours = tape.run(at)["f"]
    floats = [sp.N(f, 17) for f in formulas]  # NumPy has no square root of a large integer
    modules = [{"quotient_or_zero": lambda a, b: a / b if b else 0.0}, "numpy"]
    reference = numbers(sp.lambdify(INPUTS, floats, modules, cse=True)(*at))
    scale = np.maximum(1, np.abs(reference))
    np.testing.assert_allclose(ours / scale, reference / scale, rtol=0, atol=1e-12)
    theirs = numbers(javascript.run(tape, [list(at)])[0]["f"])
    np.testing.assert_allclose(theirs / scale, ours / scale, rtol=0, atol=1e-12)


@pytest.mark.parametrize("n", [1, 3, 7, 12])
def test_a_curve_swept_over_an_axis_is_the_same_everywhere(javascript, n):
    points = [sp.symbols(f"P{i}_x P{i}_y") for i in range(n + 1)]
    inputs = [*(c for p in points for c in p), t]
    tape = compile_tape({"curve": de_casteljau(points, t)[-1][0]}, inputs)
    rng = np.random.default_rng(n)
    at = rng.uniform(-1, 1, 2 * (n + 1))
    samples = np.linspace(0, 1, 33)
    ours = tape.run([*at, samples])["curve"]
    theirs = javascript.run(tape, [at.tolist()], [{"low": 0, "high": 1, "count": 33}])[0]["curve"]
    np.testing.assert_allclose(numbers(theirs).reshape(33, 2), ours, rtol=0, atol=1e-14)
    weights = np.array([[float(sp.binomial(n, i)) * u**i * (1 - u) ** (n - i)
                         for i in range(n + 1)] for u in samples])  # fmt: skip
    np.testing.assert_allclose(ours, weights @ at.reshape(-1, 2), rtol=0, atol=1e-13)


def test_division_by_zero_is_infinite_or_not_a_number_in_both(javascript):
    tape = compile_tape({"f": [1 / x, x / x**2, sp.log(x)]}, [x])
    assert not np.isfinite(tape.run([0.0])["f"]).any()
    assert not np.isfinite(numbers(javascript.run(tape, [[0.0]])[0]["f"])).any()


def test_steps_and_quotients_at_the_edge(javascript):
    tape = compile_tape({"f": [sp.Heaviside(x, 1), quotient_or_zero(y, x)]}, [x, y])
    at = [[0.0, 0.0], [0.0, 5.0], [-0.0, 1.0], [-0.25, 1.0], [2.0, 3.0], [np.nan, 1.0]]
    ours = np.array([tape.run(list(row))["f"] for row in at])
    expected = [[1, 0], [1, 0], [1, 0], [0, -4], [1, 1.5], [np.nan, np.nan]]
    np.testing.assert_array_equal(ours, expected)
    together = tape.run([np.array(column) for column in zip(*at, strict=True)])["f"]
    np.testing.assert_array_equal(together, expected)
    theirs = javascript.run(tape, at[:-1])
    np.testing.assert_array_equal([numbers(row["f"]) for row in theirs], expected[:-1])


@settings(max_examples=100, deadline=None)
@given(st.lists(expressions, min_size=1, max_size=3))
def test_json_loses_nothing(formulas):
    tape = compile_tape({"f": formulas}, INPUTS)
    text = json.dumps(tape.to_json(), allow_nan=False)
    assert Tape.from_json(json.loads(text)) == tape


@pytest.mark.parametrize("n", [2, 3, 8, 20])
def test_a_scheme_costs_its_interpolations_and_no_more(n):
    """n(n + 1)/2 lerps of 3 operations and dimension 2, and 1 - t once."""
    points = [sp.symbols(f"P{i}_x P{i}_y") for i in range(n + 1)]
    levels = de_casteljau(points, t)
    inputs = [*(c for p in points for c in p), t]
    tape = compile_tape({f"level{r}": level for r, level in enumerate(levels)}, inputs)
    assert len(tape.instructions) == 3 * n * (n + 1) + 1


def test_work_is_shared_between_outputs_and_dead_work_is_dropped():
    tape = compile_tape({"a": (x + y) ** 2, "b": (x + y) ** 2 + 1}, [x, y])
    assert [instruction[0] for instruction in tape.instructions] == ["add", "mul", "add"]


def test_deeply_nested_negative_terms_stay_cheap():
    e = x
    for _ in range(300):
        e = 1 - t * e
    assert len(compile_tape({"e": e}, [x, t]).instructions) == 600


def test_values_broadcast():
    tape = compile_tape({"m": [[x, y], [x + y, sp.Integer(1)]], "s": x * y}, [x, y])
    outputs = tape.run({"x": np.ones((4, 1)), "y": np.arange(3)})
    assert outputs["m"].shape == (4, 3, 2, 2)
    assert outputs["s"].shape == (4, 3)


@pytest.mark.parametrize(("outputs", "inputs", "error", "said"), [
    ({"f": x + t}, [x], BadValue, "the symbol t"),
    ({"f": sp.gamma(x)}, [x], BadValue, "gamma"),
    ({"f": sp.Piecewise((x, x > 0), (0, True))}, [x], BadValue, "Piecewise"),
    ({"f": x + sp.I}, [x], BadType, "real"),
    ({"f": [[x], [x, x]]}, [x], BadValue, "equal length"),
    ({"f": "x + 1"}, [x], BadType, "never parsed"),
    ({"f": x}, [x, x], BadType, "distinct"),
    ({"f": x}, ["x"], BadType, "symbols"),
])  # fmt: skip
def test_bad_input(outputs, inputs, error, said):
    with pytest.raises(error, match=said):
        compile_tape(outputs, inputs)


@pytest.mark.parametrize("given_values", [[1.0], {"x": 1.0}, {"x": 1, "y": 2, "z": 3}, [1, 2, 3]])
def test_wrong_number_of_values(given_values):
    with pytest.raises(BadValue, match="x, y"):
        compile_tape({"f": x + y}, [x, y]).run(given_values)


@pytest.mark.parametrize("factors", [
    (x, -1), (x, -2, y), (-1, -1, x), (-1, x + 1, -1), (sp.Rational(1, 2), x, sp.Rational(-1, 3)),
], ids=str)  # fmt: skip
def test_signs_of_products_that_sympy_left_alone(factors):
    product = sp.Mul(*factors, evaluate=False)
    expected = float(np.prod([float(sp.sympify(f).subs({x: 5, y: 3})) for f in factors]))
    tape = compile_tape({"p": product, "s": sp.Add(1, product, evaluate=False)}, [x, y])
    outputs = tape.run([5.0, 3.0])
    assert outputs["p"] == pytest.approx(expected)
    assert outputs["s"] == pytest.approx(1 + expected)


def test_a_power_of_zero_is_one():
    assert compile_tape({"f": sp.Pow(x, 0, evaluate=False)}, [x]).run([0.0])["f"] == 1


@pytest.mark.parametrize("outputs", [{"f": sp.Integer(10) ** 400 * x}, {"f": []}])
def test_what_no_json_number_and_no_array_can_hold(outputs):
    with pytest.raises((BadType, BadValue), match="Expected"):
        compile_tape(outputs, [x])


@pytest.mark.parametrize("given_value", ["5", None, 1j, True])
def test_values_that_are_not_numbers(given_value):
    with pytest.raises(BadType, match="real numbers"):
        compile_tape({"f": x}, [x]).run([given_value])

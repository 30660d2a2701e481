"""A tape run in chunks gives what it gives at once, and allocates little more than its result."""

import tracemalloc

import numpy as np
import pytest
import sympy as sp

from numeric import compile_tape
from numeric.curve import Curve
from numeric.tape.runner import CHUNK
from symbolic import de_casteljau

u, v, a = sp.symbols("u v a")
SIZES = [0, 1, CHUNK - 1, CHUNK, CHUNK + 1, 3 * CHUNK + 5]


def surface():
    """Return a tape that shares work between outputs, repeats one, and passes an input through."""
    level = de_casteljau([[0, 0], [1, 2], [2, 0], [3, a]], u)[-1][0]
    return compile_tape(
        {"patch": [x * (1 - v) + v * v for x in level], "u": u, "same": [level[0], level[0]],
         "constant": sp.Rational(1, 3), "sum": level[0] + v},
        [u, v, a],
    )  # fmt: skip


def directly(x, y, height):
    s = 1 - x
    first = 3 * s * s * x + 6 * s * x * x + 3 * x**3
    second = 6 * s * s * x + height * x**3
    common = np.broadcast(x, y, height).shape
    first, second, y = (np.broadcast_to(part, common) for part in (first, second, y))
    return {
        "patch": np.stack([first * (1 - y) + y * y, second * (1 - y) + y * y], axis=-1),
        "u": np.broadcast_to(x, common),
        "same": np.stack([first, first], axis=-1),
        "constant": np.full(common, 1 / 3),
        "sum": first + y,
    }


def assert_same(found, expected):
    for name, values in expected.items():
        assert found[name].shape == values.shape
        np.testing.assert_allclose(found[name], values, rtol=0, atol=1e-14, err_msg=name)


@pytest.mark.parametrize("size", SIZES)
def test_any_number_of_parameters(size):
    x = np.linspace(0, 1, size)
    assert_same(surface().run([x, x[::-1], 2.0]), directly(x, x[::-1], np.float64(2)))


@pytest.mark.parametrize("shapes", [
    ((300, 1), (1, 200), ()), ((3, CHUNK), (3, 1), (1,)), ((CHUNK + 3, 1), (1, 3), ()),
    ((2, 3, 1), (1, 1, CHUNK), (3, 1)), ((), (), ()), ((1, 1), (), ()), ((CHUNK * 2, 1), (), ()),
    ((40, 1, 50), (1, 60, 1), (1, 1, 50)),
])  # fmt: skip
def test_grids_of_parameters(shapes):
    random = np.random.default_rng(0)
    x, y, height = (random.random(shape) for shape in shapes)
    assert_same(surface().run([x, y, height]), directly(x, y, height))


def peak_beyond(result_size, work):
    work()
    tracemalloc.start()
    work()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return peak - result_size


@pytest.mark.parametrize("degree", [3, 12])
@pytest.mark.parametrize("segments", [1, 1000])
def test_no_temporary_is_larger_than_the_points_and_a_chunk(degree, segments):
    random = np.random.default_rng(1)
    curve = Curve.from_bezier(random.random((segments, degree + 1, 2)))
    t = random.random(2_000_000)
    registers = 8 * CHUNK * (4 * (degree + 1) + 20)  # what a chunk holds at once
    assert peak_beyond(16 * len(t), lambda: curve(t)) < registers < 8 * len(t)
    assert peak_beyond(16 * len(t), lambda: curve(np.sort(t))) < registers + 8 * len(t)


def test_a_buffer_is_used_again_once_its_value_is_not_needed():
    chain = u
    for k in range(200):
        chain = sp.sin(chain) * u + sp.Rational(k, 7)
    tape = compile_tape({"y": chain}, [u])
    t = np.linspace(0, 1, CHUNK)
    assert len(tape.instructions) > 500
    assert peak_beyond(t.nbytes, lambda: tape.run([t])) < 4 * t.nbytes


def test_long_ways_are_gone_first():
    terms = sum((u + k) * sp.sin(u + k) for k in range(2, 40))
    nested = u
    for k in range(2, 40):
        nested = (nested + k) * v + sp.cos(u + k) * k
    t = np.linspace(0, 1, CHUNK)
    tape = compile_tape({"y": nested}, [u, v])
    assert peak_beyond(t.nbytes, lambda: tape.run([t, t])) < 6 * t.nbytes
    assert len(compile_tape({"y": terms}, [u]).instructions) == 4 * 38 - 1

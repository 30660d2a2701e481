"""JSON: nothing lost, and nothing believed."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from contours import bits, contours
from numeric import Curve
from numeric.bridges import Contour, from_json, from_svg, to_json
from symbolic import BadType, BadValue, circle

CURVE = {"rows": [[[0, 0], [1, 2]]], "breaks": [0, 1], "rational": False}
CONTOUR = {"vertices": [[0, 0], [1, 2]], "degrees": [1], "closed": False, "weights": None}


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 25), st.integers(1, 4), st.integers(1, 4), st.integers(0, 999))
def test_curves_come_back_bit_for_bit(degree, dim, count, seed):
    rng = np.random.default_rng(seed)
    rows = np.ldexp(rng.normal(size=(count, degree + 1, dim)), rng.integers(-500, 500))
    weights = rng.uniform(0.1, 3, (count, degree + 1)) if seed % 2 else None
    curve = Curve.from_bezier(rows, np.cumsum(rng.uniform(0.1, 1, count + 1)), weights)
    text = to_json(curve)
    for data in (text, text.encode(), json.loads(text)):
        back = from_json(data)
        assert back.rows.tobytes() == curve.rows.tobytes()
        assert back.breaks.tobytes() == curve.breaks.tobytes()
        assert back.rational is curve.rational


@settings(max_examples=60, deadline=None)
@given(st.lists(contours(highest=5), max_size=3))
def test_contours_come_back_bit_for_bit(drawn):
    assert bits(from_json(to_json(drawn))) == bits(drawn)


def test_curves_and_contours_in_a_list():
    mixed = [Curve.from_nurbs(circle()), *from_svg("M0 0a1 1 0 0 0 1 1")]
    curve, contour = from_json(to_json(mixed))
    assert curve.rational and bits([contour]) == bits(mixed[1:])
    assert from_json("[]") == ()


def test_whole_numbers_are_read():
    assert from_json(CURVE)(1).tolist() == [1, 2]
    assert isinstance(from_json(CONTOUR), Contour)


@pytest.mark.parametrize("text", [
    "", "{", "nul", "[1,", "{'rows': 1}", "\ud800", "[" * 100_000, '{"a":' * 100_000, "9" * 5000,
    b"\xff\xfe\xff", '{"rows": [[[NaN]]], "breaks": [0, 1], "rational": false}', "-Infinity",
])  # fmt: skip
def test_what_is_no_json(text):
    with pytest.raises(BadValue, match="JSON"):
        from_json(text)


@pytest.mark.parametrize("data", [None, 3, "3", "null", "true", [3], [[CURVE]], {1, 2}, '"a"'])
def test_what_is_no_object(data):
    with pytest.raises(BadType, match="a JSON object of a curve"):
        from_json(data)


DEEP = []
for _ in range(500):
    DEEP = [DEEP]

WRONG = [None, "1", True, {}, [], [[]], [[[]]], [None], ["1"], [1, [2]], [[1], [2, 3]], 1e400,
         [10**400], [[10**400, 0]], [[[10**400, 0]]], [True, False], [[True, 0]], [[["a", 0]]],
         [float("nan")], [[float("inf"), 0]], [1j], -1, [-1], [0.5], [1, 0], [0, 0], DEEP, [DEEP],
         [[[1]]] * 3, [1, 2, 3]]  # fmt: skip


@pytest.mark.parametrize("name", [*CURVE, *CONTOUR])
@pytest.mark.parametrize("wrong", WRONG, ids=lambda value: str(value)[:20])
def test_a_wrong_entry_is_named(name, wrong):
    whole = CURVE if name in CURVE else CONTOUR
    if (name, wrong) in [("rational", True), ("weights", None)]:
        assert isinstance(from_json(whole | {name: whole[name]}), Curve | Contour)
        return
    with pytest.raises((BadValue, BadType)) as raised:
        from_json(whole | {name: wrong})
    assert len(str(raised.value)) < 500


@pytest.mark.parametrize("name", [*CURVE, *CONTOUR])
def test_names_are_checked(name):
    whole = CURVE if name in CURVE else CONTOUR
    with pytest.raises(BadValue, match="the names"):
        from_json({key: value for key, value in whole.items() if key != name})
    with pytest.raises(BadValue, match="the names"):
        from_json(whole | {"extra": 1})


def test_what_curves_refuse_is_refused():
    with pytest.raises(BadValue, match="weight function"):
        from_json({"rows": [[[0, 1], [1, -1]]], "breaks": [0, 1], "rational": True})
    with pytest.raises(BadValue, match="at least one coordinate"):
        from_json({"rows": [[[1], [1]]], "breaks": [0, 1], "rational": True})
    with pytest.raises(BadValue, match="ends where it starts"):
        from_json(CONTOUR | {"closed": True})


leaves = st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=3)
trees = st.recursive(leaves, lambda t: st.lists(t, max_size=4) | st.dictionaries(
    st.sampled_from([*CURVE, *CONTOUR]), t, max_size=4), max_leaves=12)  # fmt: skip


@settings(max_examples=150, deadline=None)
@given(trees | st.fixed_dictionaries(dict.fromkeys(CURVE, trees))
       | st.fixed_dictionaries(dict.fromkeys(CONTOUR, trees)))  # fmt: skip
def test_any_data_is_read_or_refused(data):
    try:
        from_json(data)
    except (BadValue, BadType):
        return


def test_infinity_is_not_written():
    with pytest.raises(BadValue, match="finite numbers for JSON"):
        to_json(Curve(np.array([[[np.inf], [1.0]]]), np.array([0.0, 1.0])))


@pytest.mark.parametrize("value", [None, 3, "M0 0", [3], [[Curve.from_bezier([[0, 0]])]]])
def test_what_is_not_written(value):
    with pytest.raises(BadType, match="a curve or contours"):
        to_json(value)

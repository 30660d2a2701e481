"""SVG path data: its grammar, its examples, arcs against the specification, and round trips."""

from contextlib import suppress
from math import cos, pi, sin, sqrt

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from contours import bits, paths
from numeric import Curve
from numeric.bridges import Contour, from_svg, to_svg
from symbolic import BadType, BadValue, circle

fast = settings(max_examples=120, deadline=None)


def read(text):
    return [(c.vertices.tolist(), c.degrees.tolist(), c.closed) for c in from_svg(text)]


@pytest.mark.parametrize(("text", "expected"), [
    ("", []),
    (" \t\r\n\f", []),
    ("M1 2", [([[1, 2]], [], False)]),
    ("m1 2z", [([[1, 2]], [], True)]),
    ("M1 2 3 4", [([[1, 2], [3, 4]], [1], False)]),
    ("m1 2 3 4", [([[1, 2], [4, 6]], [1], False)]),
    ("m1,2,3,4-5-6", [([[1, 2], [4, 6], [-1, 0]], [1, 1], False)]),
    ("M0.6.5", [([[0.6, 0.5]], [], False)]),
    ("M.5.5.5.5", [([[0.5, 0.5], [0.5, 0.5]], [1], False)]),
    ("M100-200", [([[100, -200]], [], False)]),
    ("M+1+2", [([[1, 2]], [], False)]),
    ("M1e2-3E-1", [([[100, -0.3]], [], False)]),
    ("M1.e1 2.", [([[10, 2]], [], False)]),  # SVG 1.1 has digits before a point alone
    ("M1 2H3V4h1v1", [([[1, 2], [3, 2], [3, 4], [4, 4], [4, 5]], [1] * 4, False)]),
    ("M1 2H3 4 5", [([[1, 2], [3, 2], [4, 2], [5, 2]], [1] * 3, False)]),
    ("M0 0L1 1z", [([[0, 0], [1, 1], [0, 0]], [1, 1], True)]),
    ("M0 0L1 1 0 0z", [([[0, 0], [1, 1], [0, 0]], [1, 1], True)]),
    ("M0 0L1 1zL2 2", [([[0, 0], [1, 1], [0, 0]], [1, 1], True), ([[0, 0], [2, 2]], [1], False)]),
    ("M1 1l1 1zm1 1l1 0", [
        ([[1, 1], [2, 2], [1, 1]], [1, 1], True), ([[2, 2], [3, 2]], [1], False)
    ]),
    ("M0 0M1 1L2 2", [([[0, 0]], [], False), ([[1, 1], [2, 2]], [1], False)]),
    ("M0 0C1 0 1 1 0 1S-1 2 0 2", [
        ([[0, 0], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 2], [0, 2]], [3, 3], False)
    ]),
    ("M0 0s1 1 2 0", [([[0, 0], [0, 0], [1, 1], [2, 0]], [3], False)]),
    ("M0 0Q9 9 1 1S2 2 3 3", [([[0, 0], [9, 9], [1, 1], [1, 1], [2, 2], [3, 3]], [2, 3], False)]),
    ("M0 0q1 1 2 0t2 0 2 0", [
        ([[0, 0], [1, 1], [2, 0], [3, -1], [4, 0], [5, 1], [6, 0]], [2, 2, 2], False)
    ]),
    ("M0 0C9 9 9 9 1 1T3 3", [([[0, 0], [9, 9], [9, 9], [1, 1], [1, 1], [3, 3]], [3, 2], False)]),
    ("M1 1T2 2", [([[1, 1], [1, 1], [2, 2]], [2], False)]),
    ("M0 0c1 0 1 1 0 1 1 0 1 1 0 1", [
        ([[0, 0], [1, 0], [1, 1], [0, 1], [1, 1], [1, 2], [0, 2]], [3, 3], False)
    ]),
    ("M0 0a1 1 0 1 1 0 0", [([[0, 0]], [], False)]),  # an arc to where it is
    ("M0 0a0 1 0 1 1 1 0", [([[0, 0], [1, 0]], [1], False)]),  # a radius of 0
])  # fmt: skip
def test_the_grammar(text, expected):
    assert read(text) == expected


@pytest.mark.parametrize(("text", "said"), [
    ("L1 1", "M or m as the first command, at character 0"),
    ("z", "M or m as the first command"),
    ("1 2", "a command"),
    ("M", "a number at character 1, received the end"),
    ("M1", "1 more number at character 2, received the end"),
    ("M1 2 3", "1 more number"),
    ("M1 2,", "a command"),
    ("M,1 2", "a number"),
    ("M1,,2", "1 more number at character 3"),
    ("M1 2C1 2 3 4", "2 more numbers"),
    ("M1 2 X", "a command"),
    ("M1 2z3", "a command"),
    ("M1 2 zz L", "a number"),
    ("M1e 2", "1 more number at character 2"),
    ("M+-1 2", "a number"),
    ("M. 2", "a number"),
    ("M1 2 a1 1 0 2 0 1 1", "a flag, 0 or 1 of an arc at character 12"),
    ("M1 2 a1 1 0 0 0 1", "a number of an arc"),
    ("M1 2 a1 1 0 0", "a flag"),
    ("M1 2 a1 1 0 0.5 0 1 1", "a flag"),
    ("M1 2 L NaN 1", "a number"),
    ("M1 2 L inf 1", "a number"),
    ("M1e999 2", "1.8e308"),
    ("M\u0661 2", "a number"),  # a digit, but not one of SVG's
    ("M1\u00a02", "1 more number"),  # a space, but not one of SVG's
    ("M0 0\u017f1 1 2 2", "a command"),  # the long s, whose capital is S
    ("M1e308 0l1e308 0", "finite"),
    ("M0 0A1e-320 1 0 0 0 1 1", "moderate size"),
])  # fmt: skip
def test_what_leaves_the_grammar(text, said):
    with pytest.raises(BadValue, match=said):
        from_svg(text)


@pytest.mark.parametrize("text", [None, 3, b"M0 0", ["M0 0"]])
def test_what_is_no_text(text):
    with pytest.raises(BadType, match="text"):
        from_svg(text)


@pytest.mark.parametrize("text", [
    "M 100 100 L 300 100 L 200 300 z",
    "M100,200 C100,100 250,100 250,200 S400,300 400,200",
    "M200,300 Q400,50 600,300 T1000,300",
    "M300,200 h-150 a150,150 0 1,0 150,-150 z",
    "M275,175 v-150 a150,150 0 0,0 -150,150 z",
    "M600,350 l 50,-25 a25,25 -30 0,1 50,-25 l 50,-25 a25,50 -30 0,1 50,-25 l 50,-25 "
    "a25,75 -30 0,1 50,-25 l 50,-25 a25,100 -30 0,1 50,-25 l 50,-25",
])  # fmt: skip
def test_the_examples_of_the_specification_come_back(text):
    path = from_svg(text)
    again = from_svg(to_svg(path))
    for one, other in zip(path, again, strict=True):
        t = np.linspace(0, len(one.degrees), 33)
        np.testing.assert_allclose(one.curve(t), other.curve(t), rtol=0, atol=1e-11)


@fast
@given(paths)
def test_lines_quadratics_and_cubics_come_back_bit_for_bit(drawn):
    assert bits(from_svg(to_svg(drawn))) == bits(drawn)


PIECES = list("MLHVCSQTAZmlhvcsqtaz0123456789+-.,eE \t\n") + ["1e9", "a1 1 0 01", "-1e-3", "\u0663"]


@settings(max_examples=250, deadline=None)
@given(st.text() | st.lists(st.sampled_from(PIECES)).map("".join).map("M0 0".__add__))
def test_any_text_is_read_or_refused(text):
    try:
        path = from_svg(text)
    except BadValue:
        return
    for contour in path:
        assert np.isfinite(contour.vertices).all()


@fast
@given(st.integers(0, 400))
def test_truncated_text_is_read_or_refused(cut):
    text = "M600,350l50-25a25,25-30 0,1 50-25S1 2 3 4.5e1T5 6zm1 1h3v-2c1 2 3 4 5 6Q1 2 3 4Z" * 5
    try:
        from_svg(text[:cut])
    except BadValue as error:
        assert "at character" in str(error)


@pytest.mark.parametrize("part", [
    "M0 0", "z", "L1 1", "1 ", "1", "-", ".", ".1", "1e", "a1 1 0 011 1", " ", ",", "e1", "\n,",
])  # fmt: skip
def test_long_repetition_takes_linear_time(part):
    """Anything quadratic would take hours with two million characters."""
    text = "M0 0L1" + part * (600_000 // len(part))
    with suppress(BadValue):
        from_svg(text)


def centre_form(start, end, radii, rotation, large, sweep):
    """SVG 2, appendix B.2.4 and B.2.5, to the letter, in 60 digits."""
    (x1, y1), (x2, y2) = (map(mpmath.mpf, p) for p in (start, end))
    rx, ry = (abs(mpmath.mpf(r)) for r in radii)
    phi = mpmath.radians(mpmath.mpf(rotation))
    c, s = mpmath.cos(phi), mpmath.sin(phi)
    dx, dy = (x1 - x2) / 2, (y1 - y2) / 2
    xp, yp = c * dx + s * dy, -s * dx + c * dy
    excess = (xp / rx) ** 2 + (yp / ry) ** 2
    if excess > 1:
        rx, ry = mpmath.sqrt(excess) * rx, mpmath.sqrt(excess) * ry
    square = (rx * ry) ** 2 / ((rx * yp) ** 2 + (ry * xp) ** 2) - 1
    factor = mpmath.sqrt(max(square, 0)) * (-1 if large == sweep else 1)
    cxp, cyp = factor * rx * yp / ry, -factor * ry * xp / rx
    cx, cy = c * cxp - s * cyp + (x1 + x2) / 2, s * cxp + c * cyp + (y1 + y2) / 2
    theta = mpmath.atan2((yp - cyp) / ry, (xp - cxp) / rx)
    turn = mpmath.atan2((-yp - cyp) / ry, (-xp - cxp) / rx) - theta
    if sweep and turn < 0:
        turn += 2 * mpmath.pi
    if not sweep and turn > 0:
        turn -= 2 * mpmath.pi
    return (cx, cy), (rx, ry), (c, s), theta, turn, excess


@settings(max_examples=200, deadline=None)
@given(
    st.tuples(*[st.integers(-50, 50).map(lambda k: k / 8)] * 4),
    st.tuples(st.floats(0.01, 100), st.floats(0.01, 100)) | st.just((1.0, 1.0)),
    st.floats(-400, 400) | st.sampled_from([0.0, 90.0, 180.0, -30.0]),
    st.booleans(),
    st.booleans(),
)
def test_arcs_are_those_of_the_specification(ends, radii, rotation, large, sweep):
    start, end = ends[:2], ends[2:]
    assume(start != end)
    with mpmath.workdps(60):
        centre, scaled, (c, s), theta, turn, excess = centre_form(
            start, end, radii, rotation, large, sweep
        )
        numbers = [*radii, rotation, int(large), int(sweep), *end]
        (contour,) = from_svg("M{} {}A".format(*start) + " ".join(map(repr, numbers)))
        count = len(contour.degrees)
        assert count == max(int(mpmath.ceil(abs(turn) / (mpmath.pi / 2) - 1e-6)), 1)
        # Near a half turn an error e of a radius moves the centre by e over this root.
        root = max(float(mpmath.sqrt(abs(1 - excess))), 1e-8) if excess < 1 else 1e-8
        root = 1 if excess > 1 + 1e-9 else root
        bound = 1e-14 * float(max(scaled) / min(scaled)) / root * float(max(scaled))
        passed = []
        for x, y in contour.curve(np.linspace(0, count, 8 * count + 1)):
            px, py = x - centre[0], y - centre[1]
            u, v = (c * px + s * py) / scaled[0], (c * py - s * px) / scaled[1]
            off = abs(mpmath.hypot(u, v) - 1) * min(scaled)
            assert off <= bound + 1e-14 * (abs(x) + abs(y))
            passed.append(mpmath.atan2(v, u))
        # The angle runs one way, from the first to the last.
        steps = [float(mpmath.fmod(b - a + 5 * mpmath.pi, 2 * mpmath.pi) - mpmath.pi) for a, b in
                 zip(passed, passed[1:], strict=False)]  # fmt: skip
        slack = 1e-6
        assert all(step * (1 if sweep else -1) > -slack for step in steps)
        assert abs(sum(steps) - float(turn)) < slack + 2 * bound / float(min(scaled))
    assert contour.vertices[0].tolist() == list(start)
    assert contour.vertices[-1].tolist() == list(end)


@pytest.mark.parametrize("sweep", [0, 1])
@pytest.mark.parametrize("large", [0, 1])
def test_four_arcs_through_the_same_ends(large, sweep):
    """The four arcs of the figure in the specification, by hand: circles around (0, 0), (1, 1)."""
    (contour,) = from_svg(f"M1 0A1 1 0 {large} {sweep} 0 1")
    centre = [0, 0] if large != sweep else [1, 1]
    t = np.linspace(0, len(contour.degrees), 33)
    np.testing.assert_allclose(np.hypot(*(contour.curve(t) - centre).T), 1, atol=1e-15, rtol=0)
    length = np.hypot(*np.diff(contour.curve(np.linspace(0, t[-1], 4001)), axis=0).T).sum()
    assert abs(length - (3 if large else 1) * pi / 2) < 1e-5


def test_too_small_radii_are_scaled_up_to_a_half_turn():
    (contour,) = from_svg("M0 0A.5 1 0 0 1 8 0")
    assert len(contour.degrees) == 2
    np.testing.assert_allclose(contour.vertices[2], [4, -8], atol=1e-14)


def ellipse_point(angle, a, b, turn):
    x, y = a * cos(angle), b * sin(angle)
    return cos(turn) * x - sin(turn) * y, sin(turn) * x + cos(turn) * y


@fast
@given(
    st.floats(1e-3, 1), st.floats(-7, 7), st.floats(-4, 4), st.floats(0.05, 1.57),
    st.sampled_from([1e-150, 1e-9, 1.0, 1e10, 1e150]),
)  # fmt: skip
def test_arcs_of_ellipses_go_through_svg_within_roundings(ratio, turn, angle, half, scale):
    """Weights, points and handles of an affine image of a circular arc, there and back."""
    start, end = (ellipse_point(angle + k * half, 1, ratio, turn) for k in (-1, 1))
    handle = ellipse_point(angle, 1 / cos(half), ratio / cos(half), turn)
    points = scale * np.array([start, handle, end])
    (back,) = from_svg(to_svg(Contour(points, [2], False, [1, cos(half), 1])))
    bound = 1e-14 * scale / ratio
    pieces = len(back.degrees)
    middles = angle + half * (2 * np.arange(pieces) + 1 - pieces) / pieces
    expected = scale * np.array([ellipse_point(middle, 1, ratio, turn) for middle in middles])
    found = back.curve(np.arange(pieces) + 0.5)
    np.testing.assert_allclose(found, expected, rtol=0, atol=bound)
    if pieces == 1:
        np.testing.assert_allclose(back.vertices, points, rtol=0, atol=bound)
        assert abs(back.weights[1] - cos(half)) < bound / scale


@pytest.mark.parametrize("half", [1.2, 1.5, 1.57, 1.5707, 1.570796])
def test_arcs_of_nearly_half_a_turn_keep_all_their_digits(half):
    """Written as one A they would lose some: its radii hardly tell where the centre is."""
    for angle in np.linspace(0, 6, 25):
        points = [ellipse_point(angle + k * half, 3, 3, 0) for k in (-1, 0, 1)]
        points[1] = ellipse_point(angle, 3 / cos(half), 3 / cos(half), 0)
        (back,) = from_svg(to_svg(Contour(points, [2], False, [1, cos(half), 1])))
        distance = np.hypot(*back.curve(np.linspace(0, len(back.degrees), 21)).T)
        np.testing.assert_allclose(distance, 3, rtol=0, atol=2e-14)


def test_a_circle_comes_back():
    text = to_svg(Curve.from_nurbs(circle()))
    assert text.endswith("Z")
    arcs = [arc.split()[:5] for arc in text.split("A")[1:]]
    assert len(arcs) == 4
    assert all(rx == ry and rest == ["0", "0", "1"] for rx, ry, *rest in arcs)
    (back,) = from_svg(text)
    points = Curve.from_nurbs(circle()).points.reshape(-1, 2)[[0, 1, 2, 4, 5, 7, 8, 10, 11]]
    np.testing.assert_allclose(back.vertices, points, rtol=0, atol=4e-16)
    np.testing.assert_allclose(back.weights[1::2], sqrt(0.5), rtol=1e-15)


@pytest.mark.parametrize("weight", [1 - 1e-15, 1 - 1e-12, 1 - 1e-8, 1 - 1e-4, 1 + 4e-16])
def test_nearly_parabolas_keep_their_shape(weight):
    points = np.array([[0, 0], [3, 5], [7, 1.0]])
    (back,) = from_svg(to_svg(Contour(points, [2], False, [1, weight, 1])))
    t = np.linspace(0, 1, 9)
    curve = Curve.from_bezier(points, weights=[1, weight, 1])
    np.testing.assert_allclose(back.curve(t), curve(t), rtol=0, atol=1e-13)


@pytest.mark.parametrize(("curve", "said"), [
    (Curve.from_bezier([[0, 0]] * 5), "degree 4"),
    (Curve.from_bezier([[0, 0], [1, 1], [2, 0], [3, 3]], weights=[1, 2, 1, 1]), "rational .* 3"),
    (Curve.from_bezier([[0, 0], [1, 1], [2, 0]], weights=[1, 2, 1]), "hyperbola"),
    (Curve.from_bezier([[0, 0], [3, 0], [2, 0]], weights=[1, 0.5, 1]), "flat arc"),
])  # fmt: skip
def test_what_svg_cannot_hold(curve, said):
    with pytest.raises(BadValue, match=said) as raised:
        to_svg(curve)
    assert "curve.flatten" in str(raised.value)
    p = curve.flatten(0.01)  # the remedy, as it is told
    assert to_svg(Contour(p, [1] * (len(p) - 1)))


@pytest.mark.parametrize("weight", [1e-300, 0.3, 0.6])
def test_huge_arcs(weight):
    points = np.array([[0, 0], [8e307, 8e307], [1.6e308, 0]])
    (back,) = from_svg(to_svg(Contour(points, [2], False, [1, weight, 1])))
    one = Contour(points / 2**1000, [2], False, [1, weight, 1])
    (expected,) = from_svg(to_svg(one))
    np.testing.assert_allclose(back.vertices / 2**1000, expected.vertices, rtol=1e-12, atol=1e-2)


def test_radii_that_overflow_are_refused():
    points = np.array([[0, 0], [5e299, 1e300], [1e300, 0]])
    with pytest.raises(BadValue, match="radii below 1e308"):
        to_svg(Contour(points, [2], False, [1, 1 - 1e-15, 1]))


def test_a_rational_line_is_a_line():
    assert to_svg(Curve.from_bezier([[0, 0], [1, 2]], weights=[1, 5])) == "M0 0 L1 2"


@pytest.mark.parametrize(("points", "expected"), [
    ([[0, 0], [1, 3], [2, 6]], "M0 0 L2 6"),
    ([[1, 1], [1, 1], [2, 2]], "M1 1 L2 2"),
    ([[1, 1], [1, 1], [1, 1]], "M1 1 L1 1 Z"),
])  # fmt: skip
@pytest.mark.parametrize("weight", [0.6, 0.99])
def test_flat_arcs_that_do_not_turn_back_are_lines(points, weight, expected):
    assert to_svg(Curve.from_bezier(points, weights=[1, weight, 1])) == expected


def test_many_segments():
    points = np.random.default_rng(0).normal(size=(30_001, 2))
    contour = Contour(points, [3] * 10_000)
    assert bits(from_svg(to_svg(contour))) == bits([contour])

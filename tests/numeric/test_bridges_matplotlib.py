"""matplotlib's paths: those it ships, every code, and round trips bit for bit."""

import numpy as np
import pytest
from hypothesis import given, settings
from matplotlib.path import Path
from matplotlib.textpath import TextPath
from matplotlib.transforms import Affine2D

from contours import bits, paths
from numeric import Curve
from numeric.bridges import from_matplotlib, segments_by_degree, to_matplotlib
from symbolic import BadType, BadValue, circle

M, L, Q, C, Z, STOP = Path.MOVETO, Path.LINETO, Path.CURVE3, Path.CURVE4, Path.CLOSEPOLY, Path.STOP


def path(codes, vertices=None):
    vertices = [[i, i * i] for i in range(len(codes))] if vertices is None else vertices
    made = Path(np.array(vertices, dtype=float), [M] * len(codes))
    made.codes = np.array(codes)  # also codes that Path would refuse at first
    return made


def shape(contours):
    return [(c.vertices[:, 0].tolist(), c.degrees.tolist(), c.closed) for c in contours]


@pytest.mark.parametrize(("codes", "expected"), [
    ([M], [([0], [], False)]),
    ([M, L, L], [([0, 1, 2], [1, 1], False)]),
    ([M, Q, Q, Q, Q, L, C, C, C], [([*range(9)], [2, 2, 1, 3], False)]),
    ([M, L, L, Z], [([0, 1, 2, 0], [1, 1, 1], True)]),
    ([M, Z], [([0], [], True)]),
    ([M, M, L], [([0], [], False), ([1, 2], [1], False)]),
    ([M, L, Z, M, L], [([0, 1, 0], [1, 1], True), ([3, 4], [1], False)]),
    ([M, L, Z, L, Z], [([0, 1, 0], [1, 1], True), ([0, 3, 0], [1, 1], True)]),
    ([M, L, Z, Z], [([0, 1, 0], [1, 1], True), ([0], [], True)]),
    ([M, L, STOP, L, L], [([0, 1], [1], False)]),
    ([STOP, L], []),
])  # fmt: skip
def test_codes(codes, expected):
    assert shape(from_matplotlib(path(codes))) == expected


def test_without_codes_a_path_is_a_polyline():
    assert shape(from_matplotlib(Path([[0, 0], [1, 1], [2, 0]]))) == [([0, 1, 2], [1, 1], False)]
    assert from_matplotlib(Path(np.empty((0, 2)))) == ()
    (square,) = from_matplotlib(Path([[0, 0], [1, 0], [1, 1], [9, 9]], closed=True))
    assert square.vertices.tolist() == [[0, 0], [1, 0], [1, 1], [0, 0]] and square.closed


def test_vertices_that_matplotlib_ignores_may_be_anything():
    nan = float("nan")
    drawn = path([M, L, Z, STOP, L], [[0, 0], [1, 1], [nan, nan], [nan, 0], [0, nan]])
    assert shape(from_matplotlib(drawn)) == [([0, 1, 0], [1, 1], True)]


@pytest.mark.parametrize(("codes", "said"), [
    ([L, L], "first one MOVETO"),
    ([M, 7], "code 7 at vertex 1"),
    ([M, Q], "2 vertices for every CURVE3"),
    ([M, Q, Q, Q, L], "CURVE3, received another number from vertex 1"),
    ([M, C, C, L], "3 vertices for every CURVE4"),
    ([M, C, C, Z], "3 vertices for every CURVE4"),
])  # fmt: skip
def test_wrong_codes(codes, said):
    with pytest.raises(BadValue, match=said):
        from_matplotlib(path(codes))


def test_gaps_are_refused():
    with pytest.raises(BadValue, match="finite coordinates"):
        from_matplotlib(Path([[0, 0], [np.nan, 1], [2, 0]]))


@pytest.mark.parametrize("value", [None, [[0, 0]], "M0 0", Curve.from_bezier([[0, 0]])])
def test_what_is_no_path(value):
    with pytest.raises(BadType, match="matplotlib Path"):
        from_matplotlib(value)


@settings(max_examples=100, deadline=None)
@given(paths)
def test_lines_quadratics_and_cubics_come_back_bit_for_bit(drawn):
    assert bits(from_matplotlib(to_matplotlib(drawn))) == bits(drawn)


SHIPPED = {
    "circle": Path.unit_circle(),
    "half circle": Path.unit_circle_righthalf(),
    "arc": Path.arc(20, 250),
    "wedge": Path.wedge(-30, 100),
    "star": Path.unit_regular_star(5),
    "polygon": Path.unit_regular_polygon(7),
    "rectangle": Path.unit_rectangle(),
    "hatch": Path.hatch("xO*"),
    "text": TextPath((0, 0), "B\u00e9zier &8", size=12),
    "transformed": Affine2D().rotate(1).transform_path(Path.unit_circle()),
    "compound": Path.make_compound_path(Path.unit_circle(), Path.unit_rectangle()),
}


@pytest.mark.parametrize("name", SHIPPED)
def test_paths_of_matplotlib(name):
    """They come back with the same segments, and cover the same box."""
    given = SHIPPED[name]
    contours = from_matplotlib(given)
    assert bits(from_matplotlib(to_matplotlib(contours))) == bits(contours)
    drawn, again = (
        [(tuple(v), int(code)) for v, code in path.iter_segments(simplify=False)]
        for path in (given, to_matplotlib(contours))
    )
    assert [s for s in drawn if s[1] in (Q, C)] == [s for s in again if s[1] in (Q, C)]
    corners = {tuple(vertex) for contour in contours for vertex in contour.vertices.tolist()}
    assert {v for v, code in drawn if code in (M, L)} <= corners
    boxes = np.array([curve.bounding_box() for curve in segments_by_degree(contours)])
    box = given.get_extents().get_points()
    np.testing.assert_allclose(boxes[:, 0].min(axis=0), box[0], atol=1e-12)
    np.testing.assert_allclose(boxes[:, 1].max(axis=0), box[1], atol=1e-12)


def test_a_path_can_be_changed_and_no_curve_with_it():
    contours = from_matplotlib(Path.unit_rectangle())  # itself read-only
    made = to_matplotlib(contours)
    made.vertices[:] = 7
    made.codes[1] = M
    assert contours[0].vertices[1].tolist() == [1, 0]
    assert len(to_matplotlib([]).vertices) == 0


@pytest.mark.parametrize(("curve", "said"), [
    (Curve.from_bezier([[0, 0]] * 5), "degree 4"),
    (Curve.from_nurbs(circle()), "rational segments of degree 2"),
    (Curve.from_bezier([[0, 0, 0], [1, 1, 1]]), "in the plane"),
])  # fmt: skip
def test_what_a_path_cannot_hold(curve, said):
    with pytest.raises(BadValue, match=said):
        to_matplotlib(curve)

"""Laws of B-splines over random rational knots of any multiplicity, with SciPy as an oracle."""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import interpolate
from sympy import Rational as R

from symbolic import (
    BadValue,
    BSpline,
    KnotVector,
    bezier,
    clamped_knots,
    de_casteljau,
    phantom_ends,
    prove,
    repeat_ends,
    uniform_bspline,
    uniform_knots,
    wrap_points,
)
from symbolic.dag import postorder
from symbolic.splines import weights
from symbolic.splines.conversion import bezier_rows

t = sp.Symbol("t")
few = settings(max_examples=25)


@st.composite
def knot_vectors(draw, lowest=0, highest=5):
    """Knots of every multiplicity up to degree + 1, clamped at the ends, half, or not at all."""
    p = draw(st.integers(lowest, highest))
    values = draw(st.lists(st.fractions(-3, 3, max_denominator=6), min_size=2, max_size=6,
                           unique=True))  # fmt: skip
    knots = [v for v in sorted(values) for _ in range(draw(st.integers(1, p + 1)))]
    start, end = min(values) - 1, max(values) + 1
    while len(knots) < 2 * p + 2:
        knots = [start, *knots, end]
        start, end = start - Fraction(1, 2), end + Fraction(1, 3)
    if knots[p] == knots[len(knots) - p - 1]:
        knots = [start] * (p + 1) + [end] * (p + 1)
    return KnotVector(knots, p)


def points_for(knots, draw, dim=1):
    coordinate = st.fractions(-4, 4, max_denominator=5)
    row = st.lists(coordinate, min_size=dim, max_size=dim)
    return draw(st.lists(row, min_size=knots.point_count, max_size=knots.point_count))


def parameters_in(knots, draw):
    share = draw(st.fractions(0, 1, max_denominator=8))
    a, b = knots.domain
    at = draw(st.sampled_from(knots.knots))
    return at if a <= at <= b and draw(st.booleans()) else a + (b - a) * R(str(share))


def exactly(value):
    return R(value.numerator, value.denominator)


def value_of(segments, at):
    """Return the curve's point: spans are half-open, the last one closed."""
    hit = [s for s in segments if s.start <= at < s.end] or [segments[-1]]
    return tuple(c.subs(t, at) for c in hit[0].coordinates)


def floats(values):
    return np.array([float(v) for v in values])


@few
@given(knot_vectors(), st.data())
def test_de_boor_the_polynomials_the_piecewise_form_and_scipy_agree(knots, data):
    spline, points = BSpline(knots), points_for(knots, data.draw)
    at = parameters_in(knots, data.draw)
    point = spline.de_boor(points, at)[-1][0]
    assert point == value_of(spline.curve(points), at)
    values = [f.subs(t, at) for f in spline.to_piecewise()]
    assert sum(values) == 1 and min(values) >= 0
    assert sum(v * exactly(p[0]) for v, p in zip(values, points, strict=True)) == point[0]
    scipy = interpolate.BSpline(floats(knots.knots), floats([p[0] for p in points]), knots.degree)
    if at not in knots.knots:  # a float knot may round to the other side
        assert float(scipy(float(at))) == pytest.approx(float(point[0]), rel=1e-9, abs=1e-9)


@few
@given(knot_vectors(), st.data())
def test_insertion_and_refinement_keep_the_curve(knots, data):
    spline, points = BSpline(knots), points_for(knots, data.draw)
    new = []
    for _ in range(data.draw(st.integers(1, 3))):
        at = parameters_in(knots.insert(new[0]) if new else knots, data.draw)
        trial = spline.knots
        if all(trial.multiplicity(x) + [*new, at].count(x) <= knots.degree + 1 for x in [*new, at]):
            new.append(at)
    boehm, boehm_points = spline, points
    for at in new:
        boehm, boehm_points = boehm.insert(boehm_points, at)
    oslo, oslo_points = spline.refine(points, new)
    assert boehm == oslo and (not new or boehm_points == oslo_points)
    before = spline.curve(points)
    for segment in oslo.curve(oslo_points):
        assert [segment.coordinates] == [
            s.coordinates for s in before if s.start <= segment.start and segment.end <= s.end
        ]
    matrix = spline.refinement_matrix(new) * sp.Matrix([[exactly(x) for x in p] for p in points])
    assert [tuple(matrix.row(i)) for i in range(matrix.rows)] == [
        tuple(map(sp.S, p)) for p in oslo_points
    ]


@few
@given(knot_vectors(), st.data())
def test_the_bezier_segments_the_span_bases_and_the_blossom_are_the_curve(knots, data):
    spline, points = BSpline(knots), points_for(knots, data.draw, dim=2)
    curve, parts = spline.curve(points), spline.to_bezier(points)
    assert len(curve) == len(parts) == len(knots.spans)
    for j, segment, part in zip(knots.spans, curve, parts, strict=True):
        assert (segment.start, segment.end) == (part.start, part.end) == knots.interval(j)
        local = (t - part.start) / (part.end - part.start)
        assert prove(de_casteljau(part.points, local)[-1][0], segment.coordinates)
        p = knots.degree
        own = spline.span_basis(j).curve(points[j - p : j + 1])
        whole = part.start + (part.end - part.start) * t
        assert prove(own, [c.subs(t, whole) for c in segment.coordinates])
        f = spline.blossom(points, j)
        for i in range(j - p, j + 1):  # Ramshaw: the control point is the value at its knots
            assert f(*knots.knots[i + 1 : i + p + 1]) == tuple(map(exactly, points[i]))


@few
@given(knot_vectors(), st.data())
def test_derivatives_and_integrals(knots, data):
    spline, points = BSpline(knots), points_for(knots, data.draw)
    curve = spline.curve(points)
    for order in range(knots.degree + 2):
        derived, own = spline.derivative(points, order)
        assert [(s.start, s.end, s.coordinates) for s in derived.curve(own)] == [
            (s.start, s.end, tuple(sp.diff(c, t, order).expand() for c in s.coordinates))
            for s in curve
        ]
    integral, sums = spline.antiderivative(points)
    start, end = knots.domain
    assert integral.degree == knots.degree + 1
    assert value_of(integral.curve(sums), start) == (0,)
    again, back = integral.derivative(sums)
    assert [s.coordinates for s in again.curve(back)] == [s.coordinates for s in curve]
    area = sum(sp.integrate(s.coordinates[0], (t, s.start, s.end)) for s in curve)
    assert spline.integral(points) == (area,)
    middle = (start + end) / 2
    left, right = spline.integral(points, end=middle), spline.integral(points, middle)
    assert left[0] + right[0] == area and spline.integral(points, end, start) == (-area,)


def test_integrals_of_numbers_without_a_known_field_and_of_many_roots():
    spline = BSpline([0, 0, 0, 1, 2, 2, 2], 2)
    assert spline.integral([[sp.pi], [1], [2], [3]]) == (sp.pi / 3 + 3,)
    (part,) = spline.integral([[1]] * 4, 0, sp.pi / 3)
    assert sp.expand(part) == sp.pi / 3
    gaps = [sp.sqrt(1 + k * k) for k in range(7)]
    knots = [sum(gaps[:k]) for k in range(8)]  # seven roots: quotients of them grow fast
    spline, points = BSpline(knots, 2), [[1], [2], [4], [8], [16]]
    pieces = spline.to_bezier(points)  # the mean of the control points is that of a curve
    expected = sum(float((end - start) * sum(p[0] for p in ps) / 3) for start, end, ps in pieces)
    assert abs(float(spline.integral(points)[0]) - expected) < 1e-12 * expected


@few
@given(knot_vectors())
def test_a_knot_of_multiplicity_m_leaves_degree_minus_m_derivatives(knots):
    spline = BSpline(knots)
    for j in knots.spans[1:]:
        at = knots.knots[j]
        jumps, smooth = spline.jumps(at), knots.continuity(at)
        assert smooth == knots.degree - knots.multiplicity(at)
        zero = [not any(jumps.row(r)) for r in range(knots.degree + 1)]
        assert all(zero[: smooth + 1]) and not zero[smooth + 1]


@few
@given(knot_vectors(lowest=1))
def test_greville_abscissae_reproduce_the_parameter(knots):
    curve = BSpline(knots).curve([[x] for x in knots.greville()])
    assert {segment.coordinates for segment in curve} == {(t,)}


@few
@given(knot_vectors(highest=4))
def test_functions_are_divided_differences_of_truncated_powers(knots):
    """N_i = (u_{i+p+1} - u_i) [u_i, ..., u_{i+p+1}] (u - t)_+^p, de Boor's definition."""
    p, x = knots.degree, sp.Symbol("x")
    for i, pieces in enumerate(BSpline(knots).functions):
        for start, end, polynomial in pieces:

            def power(u, order, above=start):
                if u <= above:  # truncated: the span lies right of the knot
                    return sp.S.Zero
                return sp.diff((x - t) ** p, x, order).subs(x, u) / sp.factorial(order)

            own = list(knots.knots[i : i + p + 2])
            column = [power(u, 0) for u in own]
            for r in range(1, p + 2):
                column = [
                    power(own[k], r) if own[k + r] == own[k]
                    else (column[k + 1] - column[k]) / (own[k + r] - own[k])
                    for k in range(len(own) - r)
                ]  # fmt: skip
            assert prove((own[-1] - own[0]) * column[0], polynomial)
            assert (start, end) == (knots.knots[pieces[0].span], end) or start > own[0]


def test_scipy_agrees_on_derivatives_antiderivatives_and_insertion():
    knots = [0, 0, 0, 0, R(1, 3), R(1, 3), R(1, 2), 2, 3, 3, 3, 3]
    points = [[R(k * k, 3) - k] for k in range(8)]
    spline = BSpline(knots, 3)
    scipy = interpolate.BSpline(floats(knots), floats([p[0] for p in points]), 3)
    grid = [R(k, 7) for k in range(1, 21)]
    for order in (1, 2):
        derived, own = spline.derivative(points, order)
        mine = floats(derived.de_boor(own, x)[-1][0][0] for x in grid)
        assert mine == pytest.approx(scipy.derivative(order)(floats(grid)), rel=1e-12, abs=1e-11)
    integral, sums = spline.antiderivative(points)
    mine = floats(integral.de_boor(sums, x)[-1][0][0] for x in grid)
    assert mine == pytest.approx(scipy.antiderivative()(floats(grid)), rel=1e-12, abs=1e-12)
    finer, new = spline.insert(points, R(5, 7), times=2)
    theirs = interpolate.insert(5 / 7, scipy, m=2)
    assert floats(p[0] for p in new) == pytest.approx(theirs.c[: len(new)], rel=1e-12)
    assert floats(finer.knots.knots) == pytest.approx(theirs.t, rel=1e-15)


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8])
def test_the_span_matrix_of_uniform_knots_is_the_uniform_basis(n):
    spline = BSpline(uniform_knots(n + 3, n))
    for j in spline.knots.spans:
        assert spline.span_matrix(j) == uniform_bspline(n).matrix
    assert BSpline(clamped_knots(n + 1, n)).span_matrix(n) == bezier(n).matrix


def test_symbolic_knots():
    """The matrix of Qin 2000 over free knots becomes every other one by substitution."""
    u = sp.symbols("u0:8")
    spline = BSpline(u, 3)
    matrix = spline.span_matrix(3)
    assert matrix.subs(dict(zip(u, range(8), strict=True))) == uniform_bspline(3).matrix
    other = [0, R(1, 2), 1, 3, 4, 6, 7, 7]
    assert matrix.subs(dict(zip(u, other, strict=True))) == BSpline(other, 3).span_matrix(3)
    assert spline.span_basis(3).derivation.is_proved
    assert prove(sum(spline.span_basis(3).functions), 1)


def test_symbolic_knots_of_several_multiplicities():
    a, b = sp.symbols("a b")
    spline = BSpline([0, 0, 0, a, a, b, 1, 1, 1], 2)
    assert spline.knots.multiplicity(a) == 2 and spline.knots.continuity(a) == 0
    assert spline.knots.spans == (2, 4, 5) and spline.knots.span(a) == 4
    assert spline.continuity_derivation(a).is_proved
    assert spline.insertion_derivation(b).is_proved
    assert spline.derivation.is_proved
    points = [[x] for x in sp.symbols("P0:6")]
    finer, new = spline.insert(points, b)
    assert finer.refine(new, [a])[0].knots.multiplicity(a) == 3
    assert prove(spline.refine(points, [b])[1], new)


@pytest.mark.parametrize(("knots", "degree"), [
    ("00aab111", 2), ("aaaabcdddd", 3), ("000abc999", 2), ("01abc89", 1),
])  # fmt: skip
def test_factored_quotients_are_what_the_field_of_fractions_says(knots, degree, monkeypatch):
    """Rational functions as knots, too, for which the quotients are not used."""
    a, b = sp.symbols("a b")
    values = {"a": a / 3, "b": b / 7 + 1, "c": (b + 9) / 2, "d": 3 * b + 7}
    listed = [values.get(k, sp.S(int(k)) if k.isdigit() else None) for k in knots]
    spline = KnotVector(listed, degree)
    for j in spline.all_spans:
        rows = [bezier_rows(spline, j)]
        with monkeypatch.context() as patch:
            patch.setattr(weights, "as_polynomials", lambda *_: None)
            rows.append(bezier_rows(spline, j))
        for (_, mine), (_, theirs) in zip(*rows, strict=True):
            for i, (x, y) in enumerate(zip(mine, theirs, strict=True), j - degree):
                assert x == y or not 0 <= i < spline.point_count


def test_numbers_without_a_field_are_points_too():
    """Such as pi: they stay as they are written."""
    curve = BSpline([0, 0, 1, 1], 1).curve([[sp.pi], [sp.sin(1)]])
    assert prove(curve[0].coordinates[0], sp.pi * (1 - t) + sp.sin(1) * t)


def test_radicals_as_knots_and_points():
    root = sp.sqrt(2)
    spline = BSpline([0, 0, 0, root, 2, 2, 2], 2)
    assert spline.knots.span(R(3, 2)) == 3 and spline.knots.span(R(7, 5)) == 2
    curve = spline.curve([[0], [root], [1], [sp.sqrt(3)]])
    assert prove(curve[0].coordinates[0].subs(t, root), curve[1].coordinates[0].subs(t, root))
    assert KnotVector([0, 0, sp.sqrt(8), 2 * root, 3, 3], 1).multiplicity(sp.sqrt(8)) == 2


def test_de_boor_keeps_symbols_shared_and_unexpanded():
    p = 8
    rows = [[x] for x in sp.symbols(f"P0:{p + 1}")]
    levels = BSpline(uniform_knots(p + 1, p)).de_boor(rows, t, span=p)
    assert len(list(postorder([levels[-1][0][0]]))) < 12 * p * p  # a tree has 2^p leaves
    assert [len(level) for level in levels] == list(range(p + 1, 0, -1))


def test_labels_name_the_blossom_values_of_the_triangle():
    spline = BSpline([0, 1, 3, 4, 6, 7, 9, 10], 3)
    points = [[0, 1], [2, 3], [5, 1], [6, 0]]
    at = R(9, 2)
    f, levels = spline.blossom(points, 3), spline.de_boor(points, at)
    for level, labels in zip(levels, spline.labels(3, at), strict=True):
        assert level == tuple(f(*label) for label in labels)
    assert spline.labels(3)[1] == ((t, 3, 4), (t, 4, 6), (t, 6, 7))


def test_ends_of_uniform_cubics():
    points = [[0, 0], [1, 2], [3, 2], [4, 0], [6, 1]]

    def ends(rows):
        spline = BSpline(uniform_knots(len(rows), 3))
        curve = spline.curve(rows)
        return value_of(curve, spline.knots.domain[0]), value_of(curve, spline.knots.domain[1])

    assert ends(phantom_ends(points)) == ((0, 0), (6, 1)) == ends(repeat_ends(points, 3))
    start, end = ends(wrap_points(points, 3))
    assert start == end
    assert ends(repeat_ends(points, 2))[0] == (R(1, 6), R(1, 3))


def test_coincident_points_are_not_multiple_knots():
    """A double vertex keeps C^2; a double knot keeps the degree and loses one derivative."""
    points = [[x] for x in (0, 1, 1, 3, 5)]
    vertex = BSpline(range(9), 3)
    knot = BSpline([0, 1, 2, 3, 4, 4, 5, 6, 7], 3)
    assert vertex.knots.continuity(4) == 2 and knot.knots.continuity(4) == 1
    for spline in (vertex, knot):
        assert max(sp.degree(s.coordinates[0], t) for s in spline.curve(points)) == 3


def test_twenty_knots_of_degree_three_are_one_polynomial_per_span():
    functions = BSpline(range(20), 3).functions
    assert len(functions) == 16 and {len(pieces) for pieces in functions} == {4}
    assert all(
        prove(a.polynomial.subs(t, t - i), b.polynomial)
        for i in (1, 15)
        for a, b in zip(functions[0], functions[i], strict=True)
    )


@few
@given(st.data())
def test_segments_have_the_coefficients_of_scipys_piecewise_polynomials(data):
    knots = data.draw(knot_vectors(lowest=1))
    points = points_for(knots, data.draw)
    spline = BSpline(knots)
    oracle = interpolate.PPoly.from_spline(
        interpolate.BSpline(np.array(knots.knots, float), np.array(points, float)[:, 0],
                            knots.degree))  # fmt: skip
    for segment in spline.curve(points):
        local = sp.Poly(segment.coordinates[0].subs(t, t + segment.start), t)
        ours = [local.coeff_monomial(t**k) for k in range(knots.degree, -1, -1)]
        span = int(np.flatnonzero(np.isclose(oracle.x, float(segment.start)))[-1])
        assert np.array(ours, float) == pytest.approx(oracle.c[:, span], rel=1e-9, abs=1e-9)


def test_a_symbol_is_inserted_where_its_span_is_given():
    u, points = sp.Symbol("u"), [[p] for p in sp.symbols("P0:4")]
    spline = BSpline([0, 0, 0, 1, 3, 3, 3], 2)
    for span, inside in ((2, R(1, 2)), (3, R(5, 2))):
        for times in (1, 2):
            refined, rows = spline.insert(points, u, times, span=span)
            asked, expected = spline.insert(points, inside, times)
            assert tuple(k.subs(u, inside) for k in refined.knots.knots) == asked.knots.knots
            assert prove([p[0].subs(u, inside) for p in rows], [p[0] for p in expected])
        assert spline.insertion_derivation(u, span).is_proved
    with pytest.raises(BadValue, match="Say in which span"):
        spline.insert(points, u)
    with pytest.raises(BadValue, match=r"in the span \[0, 1\)"):
        spline.insert(points, 2, span=2)


def test_the_triangle_shows_the_recursion():
    triangle = BSpline([0, 0, 0, 1, 2, 2, 2], 2).triangle(2)
    line = "N_1,2 = (t)*N_1,1 + (1 - t/2)*N_2,1 = -3*t**2/2 + 2*t"
    assert line in repr(triangle)
    assert r"N_{1,2} & = \left(t\right) N_{1,1} + " in triangle._repr_latex_()

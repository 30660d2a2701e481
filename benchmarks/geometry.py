"""Rows of the numeric benchmark that do more than evaluate: flattening, intersections, measures."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from numeric import Curve
from numeric.intersections.segments import intersect_segments

from .peers import package
from .timing import Row, Work

TOLERANCE = 1e-4


def geometry_rows(count: int, rng: np.random.Generator) -> list[Row]:
    """Return all rows: 10 `count` cubics to flatten and measure, `count` pairs to intersect."""
    segments = rng.random((10 * count, 4, 2))
    return [
        flattening_row(segments),
        pair_row(rng),
        pairs_row(count, rng),
        length_row(segments[:count]),
        box_row(segments),
    ]


def flattening_row(segments: np.ndarray) -> Row:
    """Return the row of flattening, by matplotlib's Agg in pixels of two tolerances.

    At that scale its promise is half a pixel. No polyline may be off by more than the tolerance.
    """
    from matplotlib.path import Path

    curve = Curve.from_bezier(segments, np.arange(len(segments) + 1.0))
    scale = 0.5 / TOLERANCE
    codes = np.tile(np.array([1, 4, 4, 4], np.uint8), len(segments))
    path = Path(segments.reshape(-1, 2) * scale, codes)
    by_agg = partial(path.to_polygons, closed_only=False)
    polygons = by_agg()
    vertices, t = curve.flatten(TOLERANCE), curve.flat_parameters(TOLERANCE)
    for i in range(0, len(segments), max(len(segments) // 50, 1)):
        first = np.searchsorted(t, i, side="left") + (i > 0)
        last = np.searchsorted(t, i + 1, side="right") - (i + 1 < len(segments))
        for polyline in (vertices[first:last], polygons[i] / scale):
            off = _deviation(Curve.from_bezier(segments[i]), polyline)
            assert off < 1.05 * TOLERANCE, (i, off)
    works: dict[str, Work] = {
        "ours": partial(curve.flatten, TOLERANCE),
        "matplotlib to_polygons": by_agg,
        "matplotlib cleaned": partial(path.cleaned, curves=False),  # one path, not a list
    }
    return Row(f"flatten {len(segments)} cubics to {TOLERANCE:g}", works, {}, 0.5)


def pair_row(rng: np.random.Generator) -> Row:
    """Return the row of one pair of cubics, the mean over 20 of them."""
    pairs = 20
    row = pairs_row(pairs, rng)
    first, second = rng.random((2, pairs, 4, 2))

    def one_by_one() -> None:
        for i in range(pairs):
            intersect_segments(first[i : i + 1], second[i : i + 1])

    works = row.works | {"ours": one_by_one}
    return Row("intersect two cubics", works, dict.fromkeys(works, 1 / pairs), 10)


def pairs_row(count: int, rng: np.random.Generator) -> Row:
    """Return the row of many pairs of cubics at once; `bezier` takes them one by one."""
    first, second = rng.random((2, count, 4, 2))
    ours = partial(intersect_segments, first, second)
    works: dict[str, Work] = {"ours": ours}
    bezier = package("bezier")
    if bezier is not None:
        curves = [
            [bezier.Curve(np.asfortranarray(points.T), 3) for points in side]
            for side in (first, second)
        ]

        def theirs() -> list[Any]:
            return [one.intersect(other) for one, other in zip(*curves, strict=True)]

        found, expected = ours(), theirs()
        for pair, at in enumerate(expected):
            own = found.pair == pair
            order = np.argsort(at[0])
            assert np.abs(found.u[own] - at[0, order]).max(initial=0) < 1e-9, pair
        works["bezier"] = theirs
    return Row(f"intersect {count} pairs of cubics", works, {}, 1)


def length_row(segments: np.ndarray) -> Row:
    """Return the row of lengths; `bezier` integrates each segment by QUADPACK."""
    works: dict[str, Work] = {"ours": Curve.from_bezier(segments).length}
    bezier = package("bezier")
    if bezier is not None:
        curves = [np.asfortranarray(points.T) for points in segments]

        def theirs() -> float:
            return sum(bezier.Curve(points, 3).length for points in curves)

        assert abs(theirs() / works["ours"]() - 1) < 1e-8  # type: ignore[operator]
        works["bezier"] = theirs
    return Row(f"length of {len(segments)} cubics", works, {})


def box_row(segments: np.ndarray) -> Row:
    """Return the row of the box around many cubics; fontTools takes them one by one."""
    from fontTools.misc.bezierTools import calcCubicBounds

    curve = Curve.from_bezier(segments)
    listed = segments.tolist()

    def theirs() -> list[float]:
        boxes = np.array([calcCubicBounds(*points) for points in listed])
        return [*boxes[:, :2].min(axis=0), *boxes[:, 2:].max(axis=0)]

    assert np.abs(curve.bounding_box().ravel() - theirs()).max() < 1e-12
    return Row(f"box around {len(segments)} cubics",
               {"ours": curve.bounding_box, "fontTools": theirs}, {})  # fmt: skip


def _deviation(curve: Curve, polyline: np.ndarray) -> float:
    """Return how far the curve is from a polyline along it, at 1000 parameters."""
    points = curve(np.linspace(0, 1, 1000))[:, None]
    starts, chords = polyline[:-1], np.diff(polyline, axis=0)
    lengths = (chords**2).sum(axis=1)
    along = ((points - starts) * chords).sum(axis=2) / np.where(lengths == 0, 1, lengths)
    feet = starts + np.clip(along, 0, 1)[..., None] * chords
    return float(np.sqrt(((points - feet) ** 2).sum(axis=2)).min(axis=1).max())

"""Places where segments touch: where pieces stay open however small they are."""

from __future__ import annotations

from itertools import product

import numpy as np

from ..measures.nearest import local_nearest
from .newton import TANGENT, crossing_from, nearest_places, point_and_slopes
from .pieces import NOISE, Pairs, plain, points_at
from .places import Places, clusters

BESIDE = 1e-10  # a distance of segments that cutting into pieces cannot resolve
FEW = 1 << 13  # points whose nearest places are looked for at a time
TOUCH = 2.0**-43  # a distance, of size 1, that counts as none
SHORTEST = 2.0**-26  # parameters of touching places that may be one
SLOW = 1e-3  # part of the greatest speed: so near to a cusp, places are as good as at it


def touching_places(rows: np.ndarray, found: list[tuple[Places, np.ndarray]], dim: int) -> Places:
    """Return every place that `nearest_of_clusters` found once, and whether tangents differ."""
    if not found:
        return Places.none()
    places = Places.all_of([places for places, _ in found])
    distances = np.concatenate([distance for _, distance in found])
    places = _one_of_each_contact(rows, places, distances, dim)
    slopes = point_and_slopes(_columns(rows, places.pair), places.at, dim)[1]
    sizes = np.sqrt((slopes**2).sum(axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = (slopes[:, 0] * slopes[:, 1]).sum(axis=0) / sizes.prod(axis=0)
        transversal = np.sqrt(1 - np.minimum(cosine**2, 1)) > TANGENT
    points = plain(rows[:, places.pair], dim)
    steep = np.abs(np.diff(points, axis=2)).max(axis=(2, 3)) * (rows.shape[2] - 1)
    moving = (sizes > SLOW * steep).all(axis=0)
    return places._replace(transversal=transversal & moving)


def alongside(rows: np.ndarray, pairs: Pairs, dim: int) -> np.ndarray:
    """Return which first pieces are so near to the second segment that cutting will not help."""
    near = np.ones(len(pairs.origin), bool)
    for place in (0.31, 0.69):  # a crossing may be near to one, but not to both
        point = points_at(pairs.rows[0], np.full(len(near), place), dim)
        least = np.full(len(near), np.inf)
        for start in range(0, len(near), FEW):
            part = slice(start, start + FEW)
            few = np.arange(len(near))[part]
            which, _, _, distance, _ = local_nearest(rows[1], point, few, pairs.origin[part])
            np.minimum.at(least, which, distance)
        near &= least <= BESIDE
    return near


def are_points(rows: np.ndarray, dim: int) -> np.ndarray:
    """Return which segments (2, m, n + 1, columns) are no longer than a rounding error, (2, m)."""
    points = plain(rows, dim)
    tiny: np.ndarray = (np.abs(points - points[:, :, :1]) <= NOISE).all(axis=(2, 3))
    return tiny


def places_of_points(rows: np.ndarray, point: np.ndarray, dim: int) -> Places:
    """Return where pairs touch of which one or both segments are points; these at parameter 0."""
    parts = [Places.none()]
    for side in (0, 1):
        pair = np.flatnonzero(point[side] & ~point[:side].any(axis=0))
        given = plain(rows[side, pair, :1], dim)[:, 0]
        which, _, other, distance, _ = local_nearest(
            rows[1 - side, pair], given, np.arange(len(pair)), np.arange(len(pair))
        )
        touch = (distance <= TOUCH) & ((other == 0) | ~point[1 - side, pair[which]])
        at = np.zeros((2, int(touch.sum())))
        at[1 - side] = other[touch]
        none = np.zeros(len(at[0]), bool)
        parts.append(Places(pair[which[touch]], at, np.full(at.shape, SHORTEST), none))
    return Places.all_of(parts).single()


def nearest_of_clusters(
    rows: np.ndarray, parts: list[Pairs], dim: int
) -> list[tuple[Places, np.ndarray]]:
    """Return where pieces that hang together are nearest, if they touch, and the distances."""
    return [_of_clusters(rows, pairs, dim) for pairs in parts if len(pairs.origin)]


def _of_clusters(rows: np.ndarray, pairs: Pairs, dim: int) -> tuple[Places, np.ndarray]:
    cluster = clusters(pairs.origin, pairs.start, np.full(pairs.start.shape, 0.75 * pairs.width))
    _, first, cluster = np.unique(cluster, return_index=True, return_inverse=True)
    low, high = np.full((2, len(first)), 1.0), np.zeros((2, len(first)))
    for side in (0, 1):
        np.minimum.at(low[side], cluster, pairs.start[side])
        np.maximum.at(high[side], cluster, pairs.start[side] + pairs.width)
    origin = pairs.origin[first]
    reach = (high - low) / 2 + 4 * pairs.width
    columns, middle = _columns(rows, origin), (low + high) / 2
    at, distance = crossing_from(columns, middle, reach, dim)
    solved = nearest_places(columns, middle, reach, dim)
    nearest = solved.distance <= np.maximum(distance, NOISE)  # the crossings of nearly equal arcs
    at, distance = np.where(nearest, solved.at, at), np.where(nearest, solved.distance, distance)
    distance = distance + NOISE * 2.0**-8
    for bound in (_ends, _corners):  # exact places are better than others equally near
        exact, place = bound(rows[:, origin], low, high, dim)
        at[:, exact], distance[exact] = place, 0
    touch = np.flatnonzero(distance <= TOUCH)
    places = Places(origin[touch], at[:, touch], reach[:, touch], np.zeros(len(touch), bool))
    return places, distance[touch]


def _ends(
    rows: np.ndarray, low: np.ndarray, high: np.ndarray, dim: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return which segments touch with an end of one, within bounds of parameters, and where."""
    exact, place = np.zeros(low.shape[1], bool), (low + high) / 2
    for side, end in product((0, 1), repeat=2):
        which = np.flatnonzero((low[side] <= end) & (high[side] >= end) & ~exact)
        given, reach = (low[:, which] + high[:, which]) / 2, (high[:, which] - low[:, which]) / 2
        given[side], reach[side] = end, 0
        solved = nearest_places(_columns(rows, which), given, reach, dim)
        which, at = (x[..., solved.distance <= NOISE] for x in (which, solved.at))
        exact[which], place[:, which] = True, at
    return exact, place[:, exact]


def _corners(
    rows: np.ndarray, low: np.ndarray, high: np.ndarray, dim: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return which segments touch with ends of both, within bounds of parameters, and where."""
    ends = plain(rows[:, :, [0, -1]], dim)
    exact, place = np.zeros(low.shape[1], bool), np.zeros(low.shape)
    for one, two in product((0, 1), repeat=2):
        at = np.array([[one], [two]])
        apart = np.abs(ends[0, :, one] - ends[1, :, two]).max(axis=1)
        here = (apart <= NOISE) & ((low <= at) & (at <= high)).all(axis=0)
        exact, place = exact | here, np.where(here, at, place)
    return exact, place[:, exact]


def _one_of_each_contact(
    rows: np.ndarray, places: Places, distances: np.ndarray, dim: int
) -> Places:
    """Return the nearest of places between which the segments are no farther apart.

    In a contact of high order, rounding leaves pieces open in several clusters.
    """
    links = []
    for side in (0, 1):  # neighbours on either segment
        order = np.lexsort((places.at[side], places.pair))
        one, two = order[:-1], order[1:]
        gaps = np.abs(places.at[:, one] - places.at[:, two])
        reach = np.where(np.argmax(gaps, axis=0) == [[0], [1]], 0, gaps / 2)
        between = (places.at[:, one] + places.at[:, two]) / 2
        solved = nearest_places(_columns(rows, places.pair[one]), between, reach, dim)
        same = (places.pair[one] == places.pair[two]) & (solved.distance <= TOUCH)
        links.append([one[same], two[same]])
    contact = _connected(len(places.pair), *np.concatenate(links, axis=1))
    best = np.lexsort((distances, contact))
    return places.chosen(best[np.diff(contact[best], prepend=-1) > 0])


def _connected(count: int, one: np.ndarray, two: np.ndarray) -> np.ndarray:
    """Return for each of `count` nodes the least one that links lead to.

    >>> _connected(5, np.array([3, 1]), np.array([4, 3])).tolist()
    [0, 1, 2, 1, 1]
    """
    least = np.arange(count)
    while True:
        before = least.copy()
        np.minimum.at(least, one, before[two])
        np.minimum.at(least, two, before[one])
        if (least == before).all():
            return least


def _columns(rows: np.ndarray, pair: np.ndarray) -> np.ndarray:
    """Return rows with long axes last, (n + 1, columns, 2, k)."""
    return np.ascontiguousarray(rows[:, pair].transpose(2, 3, 0, 1))

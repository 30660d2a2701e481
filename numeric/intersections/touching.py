"""Places where segments touch: where pieces stay open however small they are."""

from __future__ import annotations

import numpy as np

from ..measures.nearest import local_nearest
from .newton import crossing_from, nearest_places, point_and_slopes
from .pieces import NOISE, Pairs, plain, points_at
from .places import Places, clusters

BESIDE = 1e-10  # a distance of segments that cutting into pieces cannot resolve
FEW = 1 << 13  # points whose nearest places are looked for at a time
TOUCH = 2.0**-43  # a distance, of size 1, that counts as none
SHORTEST = 2.0**-26  # parameters of touching places that may be one
TANGENT = 1e-6  # the sine of an angle between tangents that counts as none


def touching_places(rows: np.ndarray, open_: list[Pairs], dim: int) -> Places:
    """Return the nearest places of what is open at last, if the segments touch there."""
    parts = [_of_clusters(rows, pairs, dim) for pairs in open_ if len(pairs.origin)]
    if not parts:
        return Places.none()
    places = Places.all_of([found for found, _ in parts])
    distances = np.concatenate([distance for _, distance in parts])
    places = _one_of_each_contact(rows, places, distances, dim)
    slopes = point_and_slopes(_columns(rows, places.pair), places.at, dim)[1]
    sizes = np.sqrt((slopes**2).sum(axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = (slopes[:, 0] * slopes[:, 1]).sum(axis=0) / sizes.prod(axis=0)
        transversal = np.sqrt(1 - np.minimum(cosine**2, 1)) > TANGENT
    return places._replace(transversal=transversal)


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


def _of_clusters(rows: np.ndarray, pairs: Pairs, dim: int) -> tuple[Places, np.ndarray]:
    """Return one touching place of pieces that hang together, and the distance there."""
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
    nearest = solved.distance <= np.maximum(distance, TOUCH)  # the crossings of nearly equal arcs
    at, distance = np.where(nearest, solved.at, at), np.where(nearest, solved.distance, distance)
    touch = np.flatnonzero(distance <= TOUCH)
    places = Places(origin[touch], at[:, touch], reach[:, touch], np.zeros(len(touch), bool))
    return places, distance[touch]


def _one_of_each_contact(
    rows: np.ndarray, places: Places, distances: np.ndarray, dim: int
) -> Places:
    """Return the nearest of places between which the segments are no farther apart.

    In a contact of high order, rounding leaves pieces open in several clusters.
    """
    order = np.lexsort((places.at[0], places.pair))
    places, distances = places.chosen(order), distances[order]
    between = (places.at[:, 1:] + places.at[:, :-1]) / 2
    reach = np.abs(np.diff(places.at, axis=1)) / 2
    columns = _columns(rows, places.pair[1:])
    apart = nearest_places(columns, between, reach, dim).distance > TOUCH
    apart |= np.diff(places.pair) != 0
    contact = np.cumsum(np.append(True, apart))[: len(places.pair)]
    best = np.lexsort((distances, contact))
    return places.chosen(best[np.diff(contact[best], prepend=0) > 0])


def _columns(rows: np.ndarray, pair: np.ndarray) -> np.ndarray:
    """Return rows with long axes last, (n + 1, columns, 2, k)."""
    return np.ascontiguousarray(rows[:, pair].transpose(2, 3, 0, 1))

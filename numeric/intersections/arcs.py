"""Arcs that two segments have in common, found by their ends.

Two polynomial or rational segments that coincide on an arc are parts of one algebraic curve. So an
arc they share ends only where one of them ends or turns back: at places where an end of either, or
a point where it halts, lies on the other.
"""

from __future__ import annotations

import numpy as np

from ..bernstein.form import derivative, product
from ..measures.nearest import local_nearest
from .newton import point_and_slopes
from .pieces import plain, points_at
from .shared import SAMPLES, SHORT, Shared, in_pairs

ON = 2.0**-42  # a distance, of size 1, that counts as none
CUSP = 1e-7  # a distance at which a point may yet be on a segment, at a cusp of it
CUSP_STEPS = 16
HALT = 1e-10  # part of the greatest speed: less is none
MANY = 40  # ends of arcs: of curves that halt so often, only those at their own ends are tried


def evident_arcs(rows: np.ndarray, dim: int) -> Shared:
    """Return arcs of pairs (2, m, n + 1, columns) that have both ends in common, if they share any.

    Segments with the same control points, in either order, need not be compared.
    """
    pairs = same_ends(rows, dim)
    if not len(pairs):
        return Shared.none()
    first, second = rows[:, pairs]
    equal = (first == second).all(axis=(1, 2))
    turned = (first == second[:, ::-1]).all(axis=(1, 2)) & ~equal
    u = np.linspace(0, 1, SAMPLES)
    samples = np.repeat([[u, u], [u, u[::-1]]], [equal.sum(), turned.sum()], axis=0)
    evident = Shared(np.concatenate([pairs[equal], pairs[turned]]), samples)
    return Shared.all_of([evident, shared_arcs(rows, pairs[~(equal | turned)], dim)])


def same_ends(rows: np.ndarray, dim: int) -> np.ndarray:
    """Return which pairs (2, m, n + 1, columns) have both ends in common: they may be one arc."""
    first, second = plain(rows[:, :, [0, -1]], dim)
    parallel = np.abs(first - second).max(axis=(1, 2)) <= ON
    opposite = np.abs(first - second[:, ::-1]).max(axis=(1, 2)) <= ON
    return np.flatnonzero(parallel | opposite)


def shared_arcs(rows: np.ndarray, pairs: np.ndarray, dim: int) -> Shared:
    """Return the arcs that pairs of segments, chosen from rows (2, m, n + 1, columns), share.

    Where one of them halts, an arc ends; another may go on.
    """
    if not len(pairs):
        return Shared.none()
    halts = [_halts(rows[side, pairs], dim) for side in (0, 1)]
    number, u, v = _ends_on_the_other(rows[:, pairs], halts, dim)
    i, j = in_pairs(number)
    low, high = np.minimum(v[i], v[j]), np.maximum(v[i], v[j])
    arc = (u[j] - u[i] > SHORT) & (high - low > SHORT)
    arc &= ~_between(halts[0], number[i], u[i], u[j]) & ~_between(halts[1], number[i], low, high)
    i, j = i[arc], j[arc]
    samples = np.stack([np.linspace(u[i], u[j], SAMPLES, axis=1)] * 2, axis=1)
    pair = pairs[number[i]]
    found = _same_points(rows, pair, samples, v[i], v[j], dim)
    return Shared(pair[found], samples[found]).longest()


def _ends_on_the_other(
    rows: np.ndarray, halts: list[tuple[np.ndarray, np.ndarray]], dim: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return (number, u, v) wherever an end of one segment, or a halt, lies on the other one."""
    parts = []
    count = rows.shape[1]
    for side, (number, at) in enumerate(halts):
        inner = len(number)
        number = np.concatenate([number, np.tile(np.arange(count), 2)])
        at = np.concatenate([at, np.repeat([0.0, 1.0], count)])
        which, place = _on(rows[1 - side], points_at(rows[side, number], at, dim), number)
        places = (place, at[which]) if side else (at[which], place)
        parts.append((number[which], *places, which < inner))
    number, u, v, halt = (np.concatenate(column) for column in zip(*parts, strict=True))
    many = np.bincount(number, minlength=1)[number] > MANY
    few = np.flatnonzero(~(halt & many))
    order = few[np.lexsort((v[few], u[few], number[few]))]
    return number[order], u[order], v[order]


def _between(
    halts: tuple[np.ndarray, np.ndarray], number: np.ndarray, low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    """Return whether segment `number` halts between two parameters: there, arcs may turn back."""
    places = halts[0] + halts[1]
    first, last = (np.searchsorted(places, number + u) for u in (low + SHORT, high - SHORT))
    return np.asarray(last > first)


def _halts(rows: np.ndarray, dim: int) -> tuple[np.ndarray, np.ndarray]:
    """Return (row, u), in order, where a segment's speed vanishes inside: at cusps and folds."""
    points, w = rows[..., :dim], rows[..., dim:]
    slopes = derivative(points)
    if w.shape[2]:
        slopes = product(slopes, w) - product(points, derivative(w))
    number = np.arange(len(rows))
    _, row, u, speed, _ = local_nearest(slopes, np.zeros((len(rows), dim)), number, number)
    halts = speed <= HALT * np.abs(slopes).max(axis=(1, 2))[row]
    inner = np.flatnonzero(halts & (u > SHORT) & (u < 1 - SHORT))
    return row[inner], u[inner]


def _same_points(
    rows: np.ndarray, pair: np.ndarray, samples: np.ndarray, v_start: np.ndarray,
    v_end: np.ndarray, dim: int,
) -> np.ndarray:  # fmt: skip
    """Fill in the parameters on the second segment, and return which arcs are shared."""
    count = len(pair)
    inner = samples[:, 0].ravel()
    points = points_at(np.repeat(rows[0, pair], SAMPLES, axis=0), inner, dim)
    which, v = _on(rows[1, pair], points, np.repeat(np.arange(count), SAMPLES))
    low, high = np.minimum(v_start, v_end), np.maximum(v_start, v_end)
    arc = which // SAMPLES
    inside = (v >= low[arc] - SHORT) & (v <= high[arc] + SHORT)
    # Of several places the one nearest to equal spacing: a crossing of the arc with itself.
    expected = np.linspace(v_start, v_end, SAMPLES, axis=1).ravel()
    order = np.lexsort((-np.abs(v - expected[which]), inside))
    found = np.full(count * SAMPLES, np.nan)
    found[which[order]] = np.where(inside, v, np.nan)[order]
    place = found.reshape(count, SAMPLES)
    place[:, 0], place[:, -1] = v_start, v_end
    samples[:, 1] = place
    steps = np.diff(place, axis=1) * np.sign(v_end - v_start)[:, None]
    found = np.flatnonzero((steps > 0).all(axis=1))
    return found[_without_jumps(rows[:, pair[found]], samples[found], dim)]


def _without_jumps(rows: np.ndarray, samples: np.ndarray, dim: int) -> np.ndarray:
    """Return which arcs go from each sample to the next on the second segment, too.

    Where that one runs over the same points twice, samples may change from one time to the other.
    """
    number = np.repeat(np.arange(len(samples)), SAMPLES - 1)
    middle = (samples[:, 1, 1:] + samples[:, 1, :-1]) / 2
    which, u = _on(rows[0], points_at(rows[1, number], middle.ravel(), dim), number)
    low, high = (samples[:, 0, part].ravel()[which] for part in (slice(-1), slice(1, None)))
    there = np.zeros(middle.size, bool)
    there[which[(u >= low - SHORT) & (u <= high + SHORT)]] = True
    return np.asarray(there.reshape(middle.shape).all(axis=1))


def _on(rows: np.ndarray, points: np.ndarray, piece: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (point, u) wherever a point lies on the segment with its number."""
    dim = points.shape[1]
    point, _, u, distance, _ = local_nearest(rows, points, np.arange(len(points)), piece)
    near = distance <= CUSP
    u[near], distance[near] = _at_cusps(rows[piece[point[near]]], points[point[near]], u[near], dim)
    on = distance <= ON
    return point[on], u[on]


def _at_cusps(
    rows: np.ndarray, points: np.ndarray, u: np.ndarray, dim: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return u with better places of points at a cusp or fold, and the distances.

    There the distance grows with the square of u or slower, and the polynomial whose roots are
    the nearest places vanishes to the third order. The points themselves tell more: u moves to the
    nearest point of the tangent, which leaves a half of its error, or two thirds.
    """
    columns = np.stack([rows.transpose(1, 2, 0)] * 2, axis=2)
    with np.errstate(invalid="ignore", divide="ignore"):
        for _ in range(CUSP_STEPS):
            there, slope, _ = point_and_slopes(columns, np.stack([u, u]), dim)
            step = ((points.T - there[:, 0]) * slope[:, 0]).sum(axis=0)
            step = np.nan_to_num(step / (slope[:, 0] ** 2).sum(axis=0), posinf=0, neginf=0)
            u = np.clip(u + step, 0, 1)
    apart = points_at(rows, u, dim) - points
    return u, np.sqrt((apart**2).sum(axis=1))

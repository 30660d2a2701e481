"""Newton's method for crossings and for nearest places of many pairs of pieces at once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .pieces import NOISE

STEPS = 8
BLURRED = 2.0**-20  # a crossing is told if its parameters on the segments are known so well,
CLEAR = 2.0**-4  # and on pieces: else neighbours would each seem to have one
TANGENT = 1e-6  # the sine of an angle between tangents that counts as none
SETTLED = 1e-9  # a step as short as this is the last but one: errors are squared


class Solved(NamedTuple):
    """Places on pairs of pieces.

    Attributes
    ----------
    at : array, shape (2, k)
        Parameters in [0, 1] on both pieces.
    error : array, shape (2, k)
        How far off rounding may leave them.
    distance : array, shape (k,)
        Of the two points.
    transversal : array of bool, shape (k,)
        Whether tangents differ, by more than rounding hides.
    """

    at: np.ndarray
    error: np.ndarray
    distance: np.ndarray
    transversal: np.ndarray


def crossings(rows: np.ndarray, width: float, dim: int) -> tuple[np.ndarray, Solved]:
    """Return which pairs of pieces (2, k, n + 1, columns) are found to cross, and where.

    A pair that is not found may still cross. Steps solve for where the tangents meet; in space,
    for where they are nearest to each other.
    """
    columns = np.ascontiguousarray(rows.transpose(2, 3, 0, 1))  # long axes last
    at = np.full(rows.shape[:2], 0.5)
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            points, slopes, _ = point_and_slopes(columns, at, dim)
            step = _step(points, slopes)
            at = np.minimum(np.maximum(at + step, -0.5), 1.5)
            if np.abs(step).max(initial=0) <= SETTLED:
                break
        lengths, sine = _lengths(slopes)
        error = NOISE * lengths
        settled = np.abs(step) <= np.maximum(SETTLED, error)
        inside = (at >= -error) & (at <= 1 + error) & (error < min(CLEAR, BLURRED / width))
        at = np.minimum(np.maximum(at, 0), 1)
        points = point_and_slopes(columns, at, dim)[0]
        distance = np.sqrt(((points[:, 0] - points[:, 1]) ** 2).sum(axis=0))
        met = (settled & inside).all(axis=0) & (distance <= 4 * NOISE)
        degree = rows.shape[2] - 1  # steps to a root of this order are so many times too short
        error = np.maximum(error, degree * distance * lengths)
    return met, Solved(at[:, met], error[:, met], distance[met], sine[met] > TANGENT)


def crossing_from(
    columns: np.ndarray, at: np.ndarray, reach: np.ndarray, dim: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return where tangents lead from given places, within reach of them, and the distance."""
    given = at
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            points, slopes, _ = point_and_slopes(columns, at, dim)
            step = np.nan_to_num(_step(points, slopes), posinf=0, neginf=0)
            at = np.clip(np.clip(at + step, given - reach, given + reach), 0, 1)
        points = point_and_slopes(columns, at, dim)[0]
    return at, np.sqrt(((points[:, 0] - points[:, 1]) ** 2).sum(axis=0))


def point_and_slopes(
    columns: np.ndarray, at: np.ndarray, dim: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return points and first two derivatives, (dim, 2, k) each, by de Casteljau's algorithm.

    Parameters
    ----------
    columns : array, shape (n + 1, columns, 2, k)
    at : array, shape (2, k)
    """
    n = len(columns) - 1
    level, first, second = columns, np.zeros_like(columns[0]), np.zeros_like(columns[0])
    rest = 1 - at
    for r in range(n, 0, -1):
        if r == 2:
            second = n * (n - 1) * (level[2] - 2 * level[1] + level[0])
        if r == 1:
            first = n * (level[1] - level[0])
        level = rest * level[:-1] + at * level[1:]
    value = level[0]
    if len(value) == dim:
        return value, first, second
    w = value[dim:]
    point = value[:dim] / w
    slope = (first[:dim] - point * first[dim:]) / w
    return point, slope, (second[:dim] - 2 * slope * first[dim:] - point * second[dim:]) / w


def _step(points: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Return the step to where the tangents meet, or are nearest to each other, (2, k)."""
    apart = points[:, 1] - points[:, 0]
    a, b = slopes[:, 0], slopes[:, 1]
    if len(a) == 2:
        cross = a[0] * b[1] - a[1] * b[0]
        return (
            np.stack([apart[0] * b[1] - apart[1] * b[0], apart[0] * a[1] - apart[1] * a[0]]) / cross
        )
    aa, ab, bb = (a * a).sum(axis=0), (a * b).sum(axis=0), (b * b).sum(axis=0)
    ar, br = (a * apart).sum(axis=0), (b * apart).sum(axis=0)
    return np.stack([ar * bb - br * ab, ar * ab - br * aa]) / (aa * bb - ab * ab)


def _lengths(slopes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return how far a crossing moves for an error of 1 across the other curve, and the sine."""
    squares = (slopes * slopes).sum(axis=0)
    product = (slopes[:, 0] * slopes[:, 1]).sum(axis=0)
    area = np.sqrt(squares[0] * squares[1] - product * product)
    sizes = np.sqrt(squares)
    return sizes[::-1] / area, area / sizes[0] / sizes[1]


def nearest_places(columns: np.ndarray, at: np.ndarray, reach: np.ndarray, dim: int) -> Solved:
    """Return where two curves come nearest to each other, near given places.

    They are nearest where their tangents are parallel and the difference is across them. Where
    that has no single solution, at a cusp or a contact of higher order, each point is moved in
    turn to the nearest one of the other tangent. The best place within `reach` of the given one
    is returned, found or not.
    """
    given = best = at
    least = np.full(at.shape[1], np.inf)
    with np.errstate(all="ignore"):
        for k in range(3 * STEPS):
            points, first, second = point_and_slopes(columns, at, dim)
            apart = points[:, 0] - points[:, 1]
            distance = np.sqrt((apart**2).sum(axis=0))
            better = distance < least
            best, least = np.where(better, at, best), np.where(better, distance, least)
            if k < STEPS:
                step = _parallel_step(apart, first, second)
            elif k == STEPS:
                at, step = best, np.zeros_like(at)
            else:
                step = np.zeros_like(at)
                side = k % 2
                slope = first[:, side]
                step[side] = (apart * slope).sum(axis=0) / (slope**2).sum(axis=0)
                step[0] *= -1
            step = np.nan_to_num(step, posinf=0, neginf=0)
            at = np.clip(np.clip(at + step, given - reach, given + reach), 0, 1)
    return Solved(best, np.broadcast_to(reach, best.shape), least, np.zeros(len(least), bool))


def _parallel_step(apart: np.ndarray, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Return Newton's step for c' x d' = 0 and (c - d) . c' = 0; in space, for both (c - d) . ."""
    (a, b), (aa, bb) = np.moveaxis(first, 1, 0), np.moveaxis(second, 1, 0)
    f = (apart * a).sum(axis=0)
    f_u, f_v = (a * a + apart * aa).sum(axis=0), -(a * b).sum(axis=0)
    if len(a) == 2:
        g = a[0] * b[1] - a[1] * b[0]
        g_u, g_v = aa[0] * b[1] - aa[1] * b[0], a[0] * bb[1] - a[1] * bb[0]
    else:
        g = (apart * b).sum(axis=0)
        g_u, g_v = (a * b).sum(axis=0), (apart * bb - b * b).sum(axis=0)
    determinant = f_u * g_v - f_v * g_u
    return np.stack([f_v * g - f * g_v, f * g_u - f_u * g]) / determinant

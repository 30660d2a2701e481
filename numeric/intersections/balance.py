"""Places and arcs of segments in even parameters, led back to those of before."""

from __future__ import annotations

import numpy as np

from ..bernstein.balance import before
from .places import Places
from .shared import SAMPLES, Shared


def unbalanced(places: Places, c: np.ndarray) -> Places:
    """Return places with their parameters of before."""
    c = c[:, places.pair]
    slope = c / (1 - places.at + c * places.at) ** 2
    return places._replace(at=before(places.at, c), error=places.error * slope)


def unbalanced_arcs(arcs: Shared, c: np.ndarray) -> Shared:
    """Return arcs with their parameters of before, again equally spaced on the first segment."""
    c = c[:, arcs.pair]
    if (c == 1).all():
        return arcs
    ends = before(arcs.samples[:, :, [0, -1]], c.T[..., None])
    u = np.linspace(ends[:, 0, 0], ends[:, 0, 1], SAMPLES, axis=1)
    number = np.repeat(np.arange(len(arcs.pair)), SAMPLES)
    v = arcs.on_arc(number, before(u, 1 / c[0, :, None]).ravel())[0].reshape(u.shape)
    v = before(v, c[1, :, None])
    v[:, 0], v[:, -1] = ends[:, 1].T
    return arcs._replace(samples=np.stack([u, v], axis=1))

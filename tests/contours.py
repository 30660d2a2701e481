"""Contours for hypothesis: any degrees and floats, closed or not, points, zeros of both signs."""

import numpy as np
from hypothesis import strategies as st

from numeric.bridges import Contour

coordinates = st.floats(-1e150, 1e150) | st.integers(-9, 9).map(float) | st.sampled_from([-0.0])


@st.composite
def contours(draw, highest=3):
    degrees = draw(st.lists(st.integers(1, highest), max_size=6))
    count = 1 + sum(degrees)
    pairs = st.lists(st.tuples(coordinates, coordinates), min_size=count, max_size=count)
    vertices = draw(pairs)
    closed = draw(st.booleans())
    if closed:
        vertices[-1] = vertices[0]
    return Contour(np.array(vertices), degrees, closed)


paths = st.lists(contours(), max_size=4)


def bits(contours):
    """All that a path is, such that only the very same floats are equal."""
    return [
        (
            c.vertices.tobytes(),
            c.degrees.tolist(),
            c.closed,
            None if c.weights is None else c.weights.tobytes(),
        )
        for c in contours
    ]

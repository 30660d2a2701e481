"""Elliptical arcs: SVG's end points, radii and flags, and rational quadratic Bezier segments.

A circular arc of half angle alpha < pi is a rational quadratic with weights 1, cos(alpha), 1 (Piegl
and Tiller, The NURBS Book, section 7.3), and so is every affine image of it.
"""

from __future__ import annotations

from math import (
    asin,
    atan2,
    ceil,
    cos,
    degrees,
    fmod,
    frexp,
    hypot,
    isfinite,
    ldexp,
    pi,
    radians,
    sin,
    sqrt,
)

from symbolic.errors import BadValue

from .contour import Point

# Above this weight a chord and the radii tell the centre well. At a half turn, weight 0, an error
# e of a radius moves the centre by the square root of e.
WELL_SHAPED = 0.5
EPSILON = 2.0**-52


def arc_pieces(
    start: Point, end: Point, radii: Point, rotation: float, large: bool, sweep: bool
) -> list[tuple[Point, float, Point]] | None:
    """Return an SVG arc as rational quadratics of at most a quarter turn each.

    The ends are different points, and the radii not zero. Radii that are too small to reach from
    one to the other are scaled up, as SVG wants it. Every piece is its middle control point, the
    weight of that, and its end. None if numbers overflow on the way.

    Notes
    -----
    The ellipse becomes a unit circle, the chord from start to end 2h. The point at angle theta
    from the middle of the arc of angle 2 phi is, seen from the chord's middle, sin(theta) along the
    chord and cos(theta) - cos(phi) across it. So large radii cost no digits, as they would by way
    of the centre (SVG 2, appendix B.2.4).

    Examples
    --------
    >>> arc_pieces((1, 0), (0, 1), (2, 1), 0, False, True)[0][2]
    (0, 1)
    """
    angle = radians(fmod(rotation, 360))
    c, s = cos(angle), sin(angle)
    rx, ry = abs(radii[0]), abs(radii[1])
    dx, dy = end[0] / 2 - start[0] / 2, end[1] / 2 - start[1] / 2
    hx, hy = (c * dx + s * dy) / rx, (c * dy - s * dx) / ry
    half = hypot(hx, hy)
    if not 0 < half < float("inf"):
        return None
    scale = max(half, 1.0)
    ex, ey = hx / half * scale * rx, hy / half * scale * ry  # along the chord
    side = 1 if sweep else -1
    nx, ny = side * hy / half * scale * rx, -side * hx / half * scale * ry  # across, outwards
    middle = start[0] + dx, start[1] + dy

    def place(along: float, across: float) -> Point:
        x, y = along * ex + across * nx, along * ey + across * ny
        return middle[0] + (c * x - s * y), middle[1] + (s * x + c * y)

    phi = asin(min(half, 1.0))
    phi = pi - phi if large else phi
    count = max(ceil(phi / (pi / 4) - 1e-9), 1)  # pieces of at most a quarter turn
    alpha = phi / count
    weight = cos(alpha)
    bulge = 2 * sin(alpha / 2) ** 2 / weight  # 1/weight - 1
    pieces = []
    for k in range(count):
        theta = (2 * k + 1 - count) * alpha
        across = _cosines(theta, phi) + cos(theta) * bulge
        handle = place(sin(theta) / weight, across)
        theta += alpha
        stop = end if k == count - 1 else place(sin(theta), _cosines(theta, phi))
        pieces.append((handle, weight, stop))
    return pieces if all(isfinite(x) for p, _, q in pieces for x in (*p, *q)) else None


def arc_of(start: Point, handle: Point, end: Point, weight: float) -> tuple[float, ...] | None:
    """Return radii, rotation in degrees and the sweep flag of a rational quadratic, 0 < weight < 1.

    None if the arc is flat, within the rounding of its coordinates. With M the middle of start and
    end, a = w (P1 - M)/(1 - w^2) and b = (P2 - P0)/(2 sqrt(1 - w^2)) are conjugate half diameters:
    images of (1, 0) and (0, 1) under the map from the unit circle. Its singular values are the
    radii. BadValue if these overflow.

    Examples
    --------
    >>> [round(n, 12) for n in arc_of((2, 0), (2, 1), (0, 1), 0.5**0.5)]
    [2.0, 1.0, 0.0, 1]
    """
    power = frexp(max(map(abs, (*start, *handle, *end))))[1]
    (x0, y0), (x1, y1), (x2, y2) = (
        (ldexp(x, -power), ldexp(y, -power)) for x, y in (start, handle, end)
    )  # of size 1: no product overflows or vanishes
    hx, hy = x1 - (x0 + x2) / 2, y1 - (y0 + y2) / 2
    cx, cy = (x2 - x0) / 2, (y2 - y0) / 2
    if not abs(hx * cy - hy * cx) > 8 * EPSILON * hypot(cx, cy):
        return None
    square = (1 - weight) * (1 + weight)
    ax, ay = weight * hx / square, weight * hy / square
    bx, by = cx / sqrt(square), cy / sqrt(square)
    area = ax * by - ay * bx
    # A 2x2 matrix is the sum of a scaled rotation and a scaled reflection.
    turned, mirrored = atan2(ay - bx, ax + by), atan2(ay + bx, ax - by)
    rx = (hypot(ax + by, ay - bx) + hypot(ax - by, ay + bx)) / 2
    ry = abs(area) / rx
    turn = degrees((turned + mirrored) / 2)
    if rx - ry <= 8 * EPSILON * rx:  # a circle within rounding, which has no axes
        ry, turn = rx, 0.0
    if frexp(rx)[1] + power > 1024:
        raise BadValue("an arc with radii below 1e308", "a larger one", "Scale the curve.")
    return ldexp(rx, power), ldexp(ry, power), turn, int(area > 0)


def halves(
    start: Point, handle: Point, end: Point, weight: float
) -> list[tuple[Point, Point, Point, float]]:
    """Return both halves of a rational quadratic with end weights 1, in the same form."""

    def mean(*points: tuple[float, Point]) -> Point:
        total = sum(w for w, _ in points)
        x, y = (sum(w / total * p[i] for w, p in points) for i in (0, 1))
        return x, y

    middle = mean((1, start), (2 * weight, handle), (1, end))
    half = sqrt((1 + weight) / 2)
    return [
        (start, mean((1, start), (weight, handle)), middle, half),
        (middle, mean((weight, handle), (1, end)), end, half),
    ]


def _cosines(theta: float, phi: float) -> float:
    """Return cos(theta) - cos(phi) without cancellation."""
    return 2 * sin((phi + theta) / 2) * sin((phi - theta) / 2)

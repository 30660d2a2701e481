"""matplotlib's Path, read into contours and written from them."""

from __future__ import annotations

from typing import Any

import numpy as np

from symbolic.errors import BadType, BadValue, shown

from .contour import Contour
from .outlines import up_to_cubic

STOP, MOVETO, LINETO, CURVE3, CURVE4, CLOSEPOLY = 0, 1, 2, 3, 4, 79  # as Path.codes has them


def from_matplotlib(path: Any) -> tuple[Contour, ...]:
    """Return the contours that a matplotlib `Path` draws.

    Every number is kept bit for bit. CLOSEPOLY adds a line back to the start unless the contour is
    there; its own vertex is ignored, as matplotlib ignores it. What follows a STOP is not drawn.

    Raises
    ------
    BadValue
        For vertices of NaN or infinity, also where matplotlib would leave a gap, and for codes that
        do not follow each other as they should.
    BadType
        For what is no path.

    Examples
    --------
    >>> from matplotlib.path import Path
    >>> from_matplotlib(Path.unit_rectangle())[0].degrees.tolist()
    [1, 1, 1, 1]
    """
    if not hasattr(path, "vertices") or not hasattr(path, "codes"):
        raise BadType("a matplotlib Path", shown(path), "Give patch.get_path(), or path.vertices.")
    vertices = np.array(path.vertices, dtype=float)
    if path.codes is None:
        return (Contour(vertices, np.ones(len(vertices) - 1)),) if len(vertices) else ()
    codes = np.array(path.codes)
    stops = np.flatnonzero(codes == STOP)
    codes = codes[: stops[0]] if len(stops) else codes
    if not len(codes):
        return ()
    _refuse_wrong_codes(codes)
    # A contour begins at a MOVETO, and after a CLOSEPOLY.
    begins = (codes == MOVETO) | np.append(False, codes[:-1] == CLOSEPOLY)
    starts = np.flatnonzero(begins)
    contours: list[Contour] = []
    for a, b in zip(starts, np.append(starts[1:], len(codes)), strict=True):
        own, points = codes[a:b], vertices[a:b]
        if own[0] != MOVETO:  # it starts where the one just closed did
            own = np.append(MOVETO, own)
            points = np.concatenate([contours[-1].vertices[:1], points])
        contours.append(_contour(own, points))
    return tuple(contours)


def to_matplotlib(curves: Any) -> Any:
    """Return a matplotlib `Path` of a curve, a contour, or a list or tuple of these.

    Every number is kept bit for bit; the path shares no memory with the curves.

    Raises
    ------
    BadValue
        For degrees above 3, and rational segments.
    BadType
        For what is no curve.

    Examples
    --------
    >>> from numeric import Curve
    >>> to_matplotlib(Curve.from_bezier([[0, 0], [0.5, 2], [1, 0]])).codes.tolist()
    [1, 3, 3]
    """
    from matplotlib.path import Path

    vertices: list[Any] = [np.empty((0, 2))]
    codes: list[Any] = [np.empty(0, Path.code_type)]
    for contour in up_to_cubic(curves, "matplotlib"):
        points, degrees = contour.vertices, contour.degrees
        if contour.implied_line:
            points, degrees = points[:-1], degrees[:-1]
        vertices.append(points)
        codes += [[MOVETO], np.repeat(degrees + 1, degrees)]  # the code of degree n is n + 1
        if contour.closed:
            vertices.append(points[:1])
            codes.append([CLOSEPOLY])
    return Path(np.concatenate(vertices), np.concatenate(codes))


def _contour(codes: np.ndarray, vertices: np.ndarray) -> Contour:
    """Return the contour of one MOVETO, segments, and perhaps one CLOSEPOLY."""
    closed = bool(codes[-1] == CLOSEPOLY)
    if closed:
        codes, vertices = codes[:-1], vertices[:-1]
    degrees = codes[1:] - 1
    run = np.cumsum(np.append(0, degrees[:-1] != degrees[1:])) if len(degrees) else degrees
    first = np.searchsorted(run, run)  # where the run of each vertex's code begins
    degrees = degrees[(np.arange(len(degrees)) - first) % degrees == 0]
    if closed and (vertices[0] != vertices[-1]).any():
        vertices, degrees = np.concatenate([vertices, vertices[:1]]), np.append(degrees, 1)
    return Contour(vertices, degrees, closed)


def _refuse_wrong_codes(codes: np.ndarray) -> None:
    """Raise unless codes begin with MOVETO, and curves have all their vertices."""
    known = np.isin(codes, [MOVETO, LINETO, CURVE3, CURVE4, CLOSEPOLY])
    if not known.all() or codes[0] != MOVETO:
        at = int(np.argmin(known))  # 0 if all are known
        raise BadValue(
            "codes MOVETO, LINETO, CURVE3, CURVE4, CLOSEPOLY or STOP, the first one MOVETO",
            f"code {codes[at]} at vertex {at}",
            "Make the path anew with Path(vertices, codes).",
        )
    begins = np.flatnonzero(np.append(True, codes[1:] != codes[:-1]))
    lengths = np.diff(np.append(begins, len(codes)))
    for code in (CURVE3, CURVE4):
        wrong = begins[(codes[begins] == code) & (lengths % (code - 1) != 0)]
        if len(wrong):
            raise BadValue(
                f"{code - 1} vertices for every CURVE{code}",
                f"another number from vertex {wrong[0]} on",
                "A curve has a code for each control point and one for its end.",
            )

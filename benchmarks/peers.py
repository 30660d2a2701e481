"""How other packages evaluate the same curves; None where one is not installed.

Every function returns a work t -> points, of shape (2, len(t)) or (len(t), 2), made ready before
it is timed.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np

Evaluate = Callable[[np.ndarray], Any]


def package(name: str) -> Any:
    """Return a package, or None if it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def by_hand(points: np.ndarray) -> Evaluate:
    """Return what a good few lines of NumPy do for one cubic: Horner's rule in place."""
    matrix = np.array([[1, 0, 0, 0], [-3, 3, 0, 0], [3, -6, 3, 0], [-1, 3, -3, 1]])
    powers = matrix @ points

    def evaluate(t: np.ndarray) -> np.ndarray:
        out = np.empty((2, len(t)))
        for row, (a, b, c, d) in zip(out, powers.T, strict=True):
            np.multiply(t, d, out=row)
            for coefficient in (c, b, a):
                row += coefficient
                if coefficient is not a:
                    row *= t
        return out

    return evaluate


def bezier_curve(points: np.ndarray) -> Evaluate | None:
    """Return the evaluation of one segment by `bezier`, compiled Fortran."""
    bezier = package("bezier")
    if bezier is None:
        return None
    return bezier.Curve(np.asfortranarray(points.T), len(points) - 1).evaluate_multi


def scipy_ppoly(segments: np.ndarray, breaks: np.ndarray) -> Evaluate | None:
    """Return the evaluation of segments by SciPy's power form."""
    scipy = package("scipy.interpolate")
    if scipy is None:
        return None
    return scipy.PPoly.from_bernstein_basis(scipy.BPoly(np.moveaxis(segments, 1, 0), breaks))


def scipy_bspline(points: np.ndarray, knots: np.ndarray, degree: int) -> Evaluate | None:
    """Return the evaluation of a B-spline curve by SciPy."""
    scipy = package("scipy.interpolate")
    return None if scipy is None else scipy.BSpline(knots, points, degree)


def scipy_nurbs(homogeneous: np.ndarray, knots: np.ndarray, degree: int) -> Evaluate | None:
    """Return what SciPy's users do for NURBS: a B-spline of (w x, w y, w), divided by hand."""
    spline = scipy_bspline(homogeneous, knots, degree)
    if spline is None:
        return None

    def evaluate(t: np.ndarray) -> np.ndarray:
        rows = np.asarray(spline(t))
        return rows[:, :-1] / rows[:, -1:]

    return evaluate


def splipy_curve(
    points: np.ndarray, knots: np.ndarray, degree: int, rational: bool = False
) -> Evaluate | None:
    """Return the evaluation by `splipy`, of homogeneous points if rational."""
    splipy = package("splipy")
    if splipy is None:
        return None
    return splipy.Curve(splipy.BSplineBasis(degree + 1, knots), points, rational=rational, raw=True)


def geomdl_curve(
    points: np.ndarray, knots: np.ndarray, degree: int, weights: np.ndarray | None = None
) -> Evaluate | None:
    """Return the evaluation by `geomdl`, pure Python."""
    if package("geomdl") is None:
        return None
    curve = package("geomdl.BSpline" if weights is None else "geomdl.NURBS").Curve()
    curve.degree, curve.ctrlpts = degree, points.tolist()
    if weights is not None:
        curve.weights = weights.tolist()
    curve.knotvector = knots.tolist()
    return lambda t: np.array(curve.evaluate_list(t.tolist()))


def splines_curve(segments: np.ndarray, breaks: np.ndarray) -> Evaluate | None:
    """Return the evaluation of segments by `splines`, a loop in Python."""
    splines = package("splines")
    return None if splines is None else splines.Bernstein(list(segments), breaks.tolist()).evaluate


def nurbspy_curve(
    points: np.ndarray, weights: np.ndarray, knots: np.ndarray, degree: int
) -> Evaluate | None:
    """Return the evaluation of a NURBS curve by `nurbspy`, compiled by Numba."""
    nurbspy = package("nurbspy")
    if nurbspy is None:
        return None
    return nurbspy.NurbsCurve(
        control_points=points.T, weights=weights, degree=degree, knots=knots
    ).get_value

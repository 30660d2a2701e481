"""Draws kernels.png: what can be done with curves in float64."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from numeric import Curve
from numeric.bridges import from_font

BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#8c8c8c"


def flattened(axes):
    """Draw an ampersand, flattened coarsely: vertices stand where it bends."""
    for contour in from_font("&", "DejaVu Serif"):
        curve = contour.curve
        axes.plot(*curve(np.linspace(*curve.domain, 2000)).T, color=GREY, linewidth=1)
        axes.plot(*curve.flatten(12).T, ".-", color=BLUE, linewidth=1, markersize=5)
    axes.set_title("flatten(12), in font units", fontsize=10)


def measured(axes):
    """Draw a spline with its box, inflections, equal arc lengths and nearest points."""
    points = [[0, 0], [1, 3], [3, 3.4], [4, -0.6], [6, -0.4], [7, 2.6], [5.4, 3.4]]
    curve = Curve.from_bspline(points, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], 3)
    axes.plot(*curve(np.linspace(*curve.domain, 500)).T, color=BLUE, linewidth=1.5)
    (left, low), (right, high) = curve.bounding_box()
    box = [left, right, right, left, left], [low, low, high, high, low]
    axes.plot(*box, color=GREY, linewidth=0.8, linestyle="--")
    axes.plot(*curve(curve.parameters_by_arc_length(17)).T, ".", color=BLUE, markersize=7)
    axes.plot(*curve(curve.inflections()).T, "D", color=ORANGE, markersize=6)
    given = np.array([[2, 0.6], [4.8, 2], [3, 4.1]])
    for start, end in zip(given, curve.nearest(given).points, strict=True):
        axes.plot(*np.stack([start, end]).T, "-", color=GREEN, linewidth=1)
    axes.plot(*given.T, "o", color=GREEN, markersize=4)
    axes.set_title("equal arc lengths, inflections, nearest points, box", fontsize=10)


def crossing(axes):
    """Draw the nine intersections of y = T3(x) and x = T3(y), as many as two cubics can have."""
    wave = Curve.from_bezier([[-1, -1], [-1 / 3, 5], [1 / 3, -5], [1, 1]])
    turned = wave.transform([[0, 1], [1, 0]])
    found = wave.intersect(turned)
    for curve in (wave, turned):
        axes.plot(*curve(np.linspace(0, 1, 300)).T, color=BLUE, linewidth=1.5)
    axes.plot(*found.points.T, "o", color=ORANGE, markersize=6)
    axes.set_title(f"intersect: all {len(found.t)} of two cubics", fontsize=10)


figure, panels = plt.subplots(1, 3, figsize=(10.5, 3.4), layout="constrained")
for draw, panel in zip((flattened, measured, crossing), panels, strict=True):
    draw(panel)
    panel.set_aspect("equal")
    panel.axis("off")
figure.savefig(Path(__file__).with_suffix(".png"), dpi=130)

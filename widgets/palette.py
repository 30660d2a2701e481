"""Colours, once for the browser and matplotlib: one per control point, and a few roles.

Nine colours, because explorers go up to degree 8. Each has a contrast of at least 4.5 to the page
(white, or #111418 in the dark), so labels may use them too.
"""

from __future__ import annotations

from typing import Any

PALETTE: dict[str, dict[str, Any]] = {
    "light": {
        "points": ["#0b62c4", "#c2410c", "#15803d", "#a21caf", "#0e7490",
                   "#b91c1c", "#6d28d9", "#854d0e", "#475569"],
        "curve": "#111827",
        "construction": "#64748b",
        "muted": "#cbd5e1",
        "accent": "#a16207",
    },
    "dark": {
        "points": ["#6cb6ff", "#ffa657", "#7ee787", "#f5a3ff", "#5fd7e6",
                   "#ff9d94", "#c4b5fd", "#e3c27a", "#a8b3c4"],
        "curve": "#f3f4f6",
        "construction": "#94a3b8",
        "muted": "#475569",
        "accent": "#facc15",
    },
}  # fmt: skip


def colour(name: int | str, theme: str = "light") -> str:
    """Return a control point's colour by its index, or a role's colour by its name.

    >>> colour(0), colour("curve"), colour(9) == colour(0)
    ('#0b62c4', '#111827', True)
    """
    palette = PALETTE[theme]
    if isinstance(name, int):
        return str(palette["points"][name % len(palette["points"])])
    return str(palette[name])

"""Figures as HTML: one self-contained page, and the same embedded in a notebook's output."""

from __future__ import annotations

import json
from html import escape
from typing import Any

_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ margin: 0 auto; padding: 0.5rem; max-width: 62rem; background: #fff; color: #111827; }}
h1 {{ position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }}
@media (prefers-color-scheme: dark) {{ body {{ background: #111418; color: #f3f4f6; }} }}
</style>
</head>
<body>
<main>
<h1>{title}</h1>
<div class="casteljau-figure" data-figure="figure">{poster}</div>
</main>
<script type="application/json" data-figure-state="figure">{state}</script>
<script>{script}</script>
</body>
</html>
"""

# The picture stands below the live frame: where a notebook is not trusted, its sanitizer takes
# the frame and the styles away, and the picture is what remains to be seen.
_EMBEDDED = (
    '<div style="position: relative; min-height: 46rem">{poster}'
    '<iframe srcdoc="{page}" sandbox="allow-scripts" title="{title}" style="'
    'position: absolute; inset: 0; width: 100%; height: 100%; border: 0"></iframe></div>'
)


def page(state: dict[str, Any], script: str, poster: str) -> str:
    """Return a figure's page; the poster is what readers without scripts see.

    Parameters
    ----------
    state : the scene, the points, the step and the sliders' values
    script : the front end, which mounts the figure
    poster : an <img> element
    """
    title = escape(state["scene"]["title"] or "Figure")
    return _PAGE.format(title=title, poster=poster, state=_inert(state), script=script)


def embedded(document: str, poster: str) -> str:
    """Return a page as a sandboxed frame over its poster, for outputs without a kernel."""
    title = document.split("<title>", 1)[1].split("</title>", 1)[0]
    return _EMBEDDED.format(poster=poster, page=escape(document), title=title)


def _inert(state: dict[str, Any]) -> str:
    """Return JSON that cannot end the script element it stands in, nor start a comment there."""
    return json.dumps(state, separators=(",", ":")).replace("<", "\\u003c")

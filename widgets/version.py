"""The version of the installed package, which the front end must share."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, version

from symbolic.errors import BadValue

try:
    VERSION = version("casteljau")
except PackageNotFoundError:
    raise BadValue(
        "casteljau to be installed", "only its folder", "Run: pip install -e . (or make lab)."
    ) from None

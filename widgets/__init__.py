"""Live figures: scenes made from SymPy expressions, one widget class, and ready explorers."""

from . import explore
from .figure import Figure
from .scene import Scene

__all__ = ["Figure", "Scene", "explore"]

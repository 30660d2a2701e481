"""Straight-line programs: from SymPy expressions to plain data, run by NumPy and the browser."""

"""Blossoms (polar forms): the symmetric multi-affine maps behind Bezier curves and splines."""

"""Bezier curves given by control points: evaluate, split, differentiate, raise and reduce."""

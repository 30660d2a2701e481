"""Rational curves: weights, conics, circles, NURBS, and the equations of plane curves."""

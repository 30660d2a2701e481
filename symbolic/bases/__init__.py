"""Spline families as bases of curves: c(t) = [t^n ... t 1] M G."""

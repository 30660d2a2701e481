"""Piecewise polynomial and rational curves: made, evaluated, cut, joined and moved."""

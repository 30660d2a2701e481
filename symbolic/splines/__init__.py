"""Knot vectors and B-splines: functions, curves, insertion, conversion, derivatives, ends."""

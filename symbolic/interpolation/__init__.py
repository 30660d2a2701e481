"""Curves through given points: cubic splines, what they minimize, and how polynomials oscillate."""

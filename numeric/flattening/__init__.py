"""Curves as polylines that stay within a tolerance of them."""

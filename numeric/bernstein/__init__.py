"""Polynomials by their Bernstein coefficients, many at once: parts, products, roots."""

"""Verdicts on equalities, and derivations made of proved steps."""

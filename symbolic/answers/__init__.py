"""Checking somebody's answer: right, wrong and why, or undecided."""

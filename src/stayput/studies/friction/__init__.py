"""Sliding and the coefficients of friction (the paper, §4.2)."""

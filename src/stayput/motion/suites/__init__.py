"""Suites of motions: synthetic families, a user's own records, target spectra."""

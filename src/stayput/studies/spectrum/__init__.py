"""Overturning and rocking spectra."""

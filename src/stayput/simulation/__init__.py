"""Simulation of one case, or of many on threads or a Dask cluster."""

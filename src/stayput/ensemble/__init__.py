"""Many cases at once: grids and columns of them, over threads here or a Dask cluster."""

from stayput.ensemble.boundary import overturning_map, trace_boundary
from stayput.ensemble.many import simulate_many
from stayput.ensemble.sweep import sweep

__all__ = ["overturning_map", "simulate_many", "sweep", "trace_boundary"]

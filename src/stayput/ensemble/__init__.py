"""Many cases at once: grids and columns of them, over threads here or a Dask cluster."""

from stayput.ensemble.many import simulate_many
from stayput.ensemble.sweep import sweep

__all__ = ["simulate_many", "sweep"]

"""How it moves: one case, or many over threads here or a Dask cluster."""

"""
The paper, §4.2: friction
=========================

The paper's §4.2: which coefficient of friction matters more?
"""

# %%
# The study, on a coarser grid than `stayput study friction` has.
import numpy as np

from stayput import studies

found = studies.friction(amplitudes=np.arange(5.0, 11.1, 0.5), frequencies=np.arange(1.5, 4.6, 0.5))
print(found.tables["The nearest sine for each model, with its three slides [cm]"].to_string(index=False))

# %%
# Its data are an xarray.Dataset, its figures Matplotlib's.
assert found.data.sizes["case"] > 1000
assert {"map", "search", "effects"} <= found.figures.keys()
figure = found.figures["map"]

# %%
# No sine gives the paper's three slides.
nearest = found.tables["The nearest sine for each model, with its three slides [cm]"]
assert (nearest["largest deviation [%]"].dropna() > 5.0).all()

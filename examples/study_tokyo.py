"""
A test of devices
=================

A test of devices: what holds a chest and a cupboard?
"""

# %%
# Seven devices alone and four pairs, every way that a piece may face, under the built-in motion.
from stayput import studies

found = studies.tokyo(samples=4, variations=False)
print(found.tables["The published result beside ours"].to_string(index=False))

# %%
# Which devices let the cupboard overturn at full strength, over all facings?
overturned = found.data["overturned"].sel(body="cupboard", level=1.0).mean(("facing", "sample"))
for device, share in zip(overturned["device"].values, overturned.values, strict=True):
    print(f"{device}: {100 * share:.0f} %")

# %%
# Poles at a ceiling that bears much hold it better than mats do.
strong, mats = "poles 200 N, ceiling 1000 N", "mats 30 × 30 × 3 mm"
assert float(overturned.sel(device=strong)) <= float(overturned.sel(device=mats))
figure = found.figures["outcomes"]

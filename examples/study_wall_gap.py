"""
The paper, §4.4 and §4.5: distance to the wall
==============================================

The paper's §4.4 and §4.5: how near to the wall is safe?
"""

# %%
# A map of width over distance under a sine.
import numpy as np

from stayput import studies

found = studies.wall_gap(
    widths=np.arange(0.8, 1.61, 0.1), gaps=np.arange(0.0, 0.5, 0.02), amplitudes=(5.0,), frequencies=(0.8,)
)
figure = found.figures["map"]
fallen = found.data.overturned.sel(contact="paper", wall="left")
print("Nearest wall that turns it over, under the paper's rules:")
for width in fallen["body.width"].values:
    gaps = fallen["gap"].values[fallen.sel({"body.width": width}).values]
    print(f"  b = {width:.1f} m:", f"{gaps.min():.2f} m" if len(gaps) else "none")

# %%
# The paper's rule: wider than 1 m and nearer than 15 % of the width, none turns over.
wide = fallen.where(fallen["body.width"] > 1.05, drop=True)
assert not wide.where(wide["gap"] < 0.15 * wide["body.width"]).fillna(0).any()

# %%
# The same bodies under a record, here the built-in one: Table 4.3.
record = studies.wall_gap_record(gaps=np.arange(0.0, 1.0, 0.05))
print(record.tables["T or N and the wall distances [m], law 'paper'"].iloc[:, :4].to_string(index=False))

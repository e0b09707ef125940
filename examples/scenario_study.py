"""
A scenario file, varied
=======================

One scenario file, three distances to the wall: the file's rules, Python's loops.
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt

import stayput as sp

scenario = sp.read(Path(sys.argv[0]).with_name("bookcase.toml"))
tables = scenario.model_dump(exclude_none=True)
found = {}
for gap in (0.0, 0.02, 0.20):
    tables["room"]["left_wall"] = {"gap": gap}
    found[gap] = sp.Scenario.parse(tables).case().run()
    print(f"gap {gap:.2f} m: {found[gap].outcome}, {found[gap].wall_impacts} wall impacts")

as_read = scenario.case().run()
assert found[0.02].overturn_time == as_read.overturn_time  # the same inputs give the same bits
assert found[0.02].outcome is as_read.outcome
assert all(run.outcome is not sp.Outcome.FAILED for run in found.values())

# %%
# The tilt at each distance.
figure, axis = plt.subplots(layout="constrained")
for gap, run in found.items():
    axis.plot(run.time, run.tilt, label=f"{100 * gap:.0f} cm from the wall")
axis.set(xlabel="time [s]", ylabel="tilt [rad]")
axis.legend()

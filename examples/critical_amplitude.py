"""
How strong must a shake be to overturn a block?
===============================================

How strong must one sine wave be to overturn a block? All edges between standing and fallen.
"""

import matplotlib.pyplot as plt
import numpy as np

import stayput as sp

block = sp.Body(width=0.4, height=1.8, mass=100.0)
rough = sp.Room(floor=sp.Floor(static_friction=3.0, kinetic_friction=3.0))
wave = sp.sine(9.80665, frequency=2.0, duration=0.5, quiet=10.0)  # amplitudes are multiples of g

edges = sp.trace_boundary(sp.Case(block, rough, wave), np.linspace(0.3, 1.6, 131))
for amplitude, direction in zip(edges.amplitude.values, edges.direction.values, strict=True):
    print(f"From {amplitude:.4f} g on it", "falls" if direction > 0 else "stands again")

# Bisection between 0.3 and 1.6 g would end at one of these edges, and not say which.
assert list(edges.direction.values) == [1, -1, 1]
assert int(edges.islands) == 1
west = block.width / block.height
assert west < edges.amplitude.values[0]  # rocking starts at b/h, falling later

# %%
# A little below and above each edge: the tilt over time. Between the second edge
# and the third it stands again.
figure, axis = plt.subplots(layout="constrained")
for amplitude in edges.amplitude.values:
    for factor, style in ((0.999, "-"), (1.001, "--")):
        run = sp.simulate(block, rough, wave.scaled(factor * amplitude))
        axis.plot(run.time, np.degrees(run.tilt), style, label=f"{factor * amplitude:.3f} g: {run.outcome}")
axis.set(xlabel="time [s]", ylabel="tilt [°]", xlim=(0.0, 6.0))
axis.legend()

"""
Six hundred cases in one call
=============================

How far from the wall? A bookcase over distances and strengths of shaking, 600 cases in one call.
"""

import matplotlib.pyplot as plt
import numpy as np

import stayput as sp

bookcase = sp.Case(
    sp.Body(width=0.30, height=1.80, mass=200.0),
    sp.Room(floor=sp.Floor.of("wood flooring"), left_wall=sp.Wall(gap=0.02)),
    sp.near_fault(),
)
data = sp.sweep(
    bookcase,
    {
        "room.left_wall.gap": [0.0, 0.02, 0.05, 0.1, 0.2, 0.4],
        "motion.scale": np.linspace(0.2, 1.2, 50),
        "contact": ["coulomb", "paper"],
    },
)

fallen = data.overturned.mean("motion.scale")
print("Fraction of the strengths that overturn it, over the gap [m]")
print(fallen.to_pandas().to_string(float_format="{:.2f}".format))

# No gap saves it from the stronger half of these shakes, under either contact law.
assert (fallen > 0.2).all()

# %%
# Where it falls: each dot is a case.
figure, axis = plt.subplots(layout="constrained")
one_law = data.overturned.sel(contact="coulomb")
for gap in one_law["room.left_wall.gap"].values:
    fell = one_law.sel({"room.left_wall.gap": gap}).astype(bool)
    axis.scatter(
        np.full(fell.size, gap), fell["motion.scale"], c=np.where(fell, "tab:red", "lightgray"), s=12
    )
axis.set(xlabel="distance to the wall [m]", ylabel="factor on the motion", title="red: overturns")

"""
Floors of a building
====================

The same bookcase on several floors of a building, on fixed ground and on isolators.
"""

import matplotlib.pyplot as plt

import stayput as sp

bookcase = sp.Body(width=0.30, height=1.80, mass=200.0)
room = sp.Room(floor=sp.Floor.of("wood flooring"))
ground = sp.near_fault().scaled(0.15)
fixed = sp.Building(storeys=10, structure="RC")
isolated = sp.Building(storeys=10, structure="base-isolated")

found = {}
for building in (fixed, isolated):
    response = building.respond(ground)
    peaks = response.peak_acceleration()
    for storey in range(1, 11, 3):
        run = sp.simulate(bookcase, room, response.floor(storey))
        found[building.structure, storey] = run
        print(f"{building.name}, storey {storey}: {peaks[storey - 1]:.1f} m/s², {run.outcome}")

# Higher floors shake more; on isolators no floor shakes enough to tilt the bookcase.
assert fixed.floor_motion(ground, 1).pga == ground.pga
assert fixed.floor_motion(ground, 10).pga > 1.5 * ground.pga
assert found["RC", 10].peak_tilt > found["RC", 1].peak_tilt
assert all(found["base-isolated", storey].peak_tilt == 0.0 for storey in range(1, 11, 3))
assert response.energy["x"].imbalance < 1e-3

# %%
# How far the bookcase tilts on each floor.
figure, axis = plt.subplots(layout="constrained")
for building in (fixed, isolated):
    storeys = [storey for structure, storey in found if structure == building.structure]
    tilts = [found[building.structure, storey].peak_tilt for storey in storeys]
    axis.plot(tilts, storeys, "o-", label=building.name)
axis.set(xlabel="largest tilt of the bookcase [rad]", ylabel="storey", yticks=storeys)
axis.legend()

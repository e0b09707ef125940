"""The same bookcase on several floors of a building, on fixed ground and on isolators."""

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

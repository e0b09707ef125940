"""
A bookcase falls
================

A full bookcase with its back to a wall, in a near-fault earthquake: what happens, told and drawn.
"""

import tempfile
from pathlib import Path

import stayput as sp

bookcase = sp.Body(width=0.30, height=1.80, mass=200.0)
room = sp.Room(floor=sp.Floor.of("wood flooring"), left_wall=sp.Wall(gap=0.02))
run = sp.simulate(bookcase, room, sp.near_fault())

print(f"{run.outcome} after {run.overturn_time:.1f} s, with {run.wall_impacts} hits on the wall")
with tempfile.TemporaryDirectory() as folder:
    picture = Path(folder) / "bookcase.png"
    run.figure().savefig(picture)
    film = run.animate(Path(folder) / "bookcase.html")
    assert picture.stat().st_size > 10_000
    assert film.stat().st_size > 10_000

# It rocks back against the wall, is thrown off it, and falls into the room.
assert run.overturned
assert run.wall_impacts >= 1
assert run.tilt[-1] > 0.0
assert 6.0 < run.overturn_time < 12.0

# %%
# The histories: the floor's acceleration, the tilt and the slide.
figure = run.figure()

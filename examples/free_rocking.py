"""
Free rocking
============

A block let go at half its critical angle rocks on: impacts beside those of the rocking equation.
"""

import math

import stayput as sp

block = sp.Body(width=0.2, height=0.8, mass=50.0)
angle = block.slenderness[1]
rough = sp.Room(floor=sp.Floor(static_friction=2.0, kinetic_friction=2.0))
still = sp.sine(amplitude=0.0, frequency=1.0, duration=2.0)
run = sp.simulate(block, rough, still, initial=sp.State(tilt=0.5 * angle), gravity=9.81)

impacts = [event.time for event in run.events if event.kind is sp.EventKind.FLOOR_IMPACT]
print("Impacts [s]:", ", ".join(f"{time:.4f}" for time in impacts[:3]))

# To the first impact: T/4 = acosh(1 / (1 - θ0/α)) / p, p² = 3g/4R, for small angles (Housner 1963).
radius = 0.5 * math.hypot(block.width, block.height)
quarter = math.acosh(1.0 / (1.0 - 0.5)) / math.sqrt(3.0 * 9.81 / (4.0 * radius))
assert math.isclose(impacts[0], quarter, rel_tol=0.01)
assert run.outcome is sp.Outcome.ROCKED

# %%
# Each impact takes energy, and the next swing is shorter.
figure = run.figure()

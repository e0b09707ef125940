"""
What holds a bookcase
=====================

What holds a full bookcase through a strong synthetic motion, and how hard each device is pulled.
"""

import matplotlib.pyplot as plt

import stayput as sp
from stayput.measures import Belt, GelMats, LBracket, LBracketInBoard, TensionPole, WedgeStopper

body = sp.Body(width=0.3, height=1.8, mass=200.0)
room = sp.Room(left_wall=sp.Wall(gap=0.02), ceiling=sp.Ceiling(height=2.3))
motion = sp.near_fault()

choices = [
    (),
    (GelMats(),),
    (Belt(),),
    (LBracketInBoard(),),
    (LBracket(),),
    (WedgeStopper(), TensionPole(count=2)),
]
runs: dict[str, sp.Run] = {}
for measures in choices:
    run = sp.simulate(body, room, motion, measures)
    name = " + ".join(measure.label[0] for measure in measures) or "Nothing"
    runs[name] = run
    print(f"{name}: {run.outcome}")
    for device in run.devices:
        peak = max(device.peak_pull, device.peak_push)
        fate = f"{device.cause} at {device.failure_time:.1f} s" if device.failed else "holds"
        print(f"    {device.label[0]} {device.place}: {peak:.0f} N, {fate}")

# %%
# The tilt with each of them.
figure, axis = plt.subplots(layout="constrained")
for name, run in runs.items():
    axis.plot(run.time, run.tilt, label=name)
axis.set(xlabel="time [s]", ylabel="tilt [rad]", ylim=(-0.4, 0.4))
axis.legend(loc="lower right")

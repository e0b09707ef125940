"""
Intensity from fallen gravestones
=================================

How strong was the shaking of a cemetery? The intensity from the stones that fell and those that stood.
"""

# %%
# Two sizes of gravestones on granite, of which 17 of 30 and 5 of 22 fell.
import matplotlib.pyplot as plt

import stayput as sp

base = sp.Room(sp.Floor(static_friction=0.6, kinetic_friction=0.5))
small = sp.Fallen(sp.Body(0.242, 0.605, 95.0), fell=17, total=30, room=base, name="8 sun")
large = sp.Fallen(sp.Body(0.303, 0.758, 185.0), fell=5, total=22, room=base, name="10 sun")

# %%
# What the stones say, under motions of which one is as good as another.
motions = sp.synthetic_suite("crustal", 24)
found = sp.intensity_from_fallen([small, large], motions=motions, samples=8)
print(f"JMA intensity {found.intensity:.1f}, 95 % interval {found.low:.1f} to {found.high:.1f}")

# %%
# Twice as many stones with the same shares tell little more: one motion shook them all.
twice = [sp.Fallen(kind.body, 2 * kind.fell, 2 * kind.total, base) for kind in (small, large)]
more = sp.intensity_from_fallen(twice, motions=motions, samples=8)
print(f"with twice as many: {more.low:.1f} to {more.high:.1f}")
assert 6.0 < found.intensity < 6.8
assert 0.5 < (more.high - more.low) / (found.high - found.low) < 1.2

# %%
# The intensity with its interval, for both.
figure, axis = plt.subplots(layout="constrained", figsize=(6.4, 2.4))
for place, (name, one) in enumerate({"as found": found, "twice as many": more}.items()):
    axis.plot([one.low, one.high], [place, place], color="tab:blue")
    axis.plot(one.intensity, place, "o", color="tab:blue")
    axis.text(one.high, place, f"  {name}", va="center")
axis.set(xlabel="JMA intensity", yticks=[], ylim=(-0.5, 1.5), xlim=(5.5, 7.5))

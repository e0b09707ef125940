"""
A suite of motions
==================

Forty synthetic motions, scaled to an intensity and to a design spectrum: how much do records vary?
"""

import numpy as np

import stayput as sp

periods = np.array([0.1, 0.2, 0.5, 1.0, 2.0, 5.0])

# %%
# A suite of all families, each motion scaled to the middle of class 6-upper.
suite = sp.synthetic_suite("mixed", count=40, seed=1)
shaken = suite.to_intensity("6-upper")
assert np.allclose(shaken.intensities, 6.25, rtol=0.0, atol=1e-9)
drawn = suite.intensities
print(f"{len(suite)} motions, as drawn: JMA intensity {drawn.min():.1f} to {drawn.max():.1f}")
print("Period [s]      ", *(f"{t:6.2f}" for t in periods))
print("Median Sa [m/s²]", *(f"{sa:6.2f}" for sa in shaken.median(periods)))
print("σ of ln Sa      ", *(f"{sigma:6.2f}" for sigma in shaken.log_std(periods)))
assert (shaken.log_std(periods) > 0.2).all()

# %%
# Motions that meet a design spectrum.
target = sp.japanese_design("very rare", soil=2)
crustal = sp.synthetic_suite("crustal", count=8)
for name, fitted in {
    "one factor each": crustal.to_spectrum(target),
    "spectra matched": crustal.matched(target),
}.items():
    off = fitted.deviation(target)
    print(
        f"{name}: {100 * off.mean:.1f} % off on average, {100 * off.worst:.1f} % at {off.worst_period:.2g} s"
    )
assert off.mean < 0.10
figure = fitted.figure(target=target)

# %%
# The floor comes to rest where it began.
for motion in shaken:
    assert abs(motion.velocity[-1]) < 1e-9
    assert abs(motion.displacement[-1]) < 1e-9

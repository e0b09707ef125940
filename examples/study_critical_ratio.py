"""
The paper, §4.3: critical ratio
===============================

The paper's §4.3: Eq. 4.1 beside our own amplitudes.
"""

# %%
# The critical amplitude over b/h and frequency, and a regression of the paper's form.
from stayput import studies

found = studies.critical_ratio(ratios=[0.2, 0.3, 0.4, 0.5, 0.6], step=0.06)
for table in found.tables.values():
    print(table.to_string(index=False), end="\n\n")

# %%
# What Eq. 4.1 leaves out: the size. Twice as high, and the same b/h: another critical amplitude.
tall = studies.critical_ratio(ratios=[0.2, 0.3, 0.4, 0.5, 0.6], height=2.8, step=0.06)
by_frequency = "Mean deviation of our critical amplitudes by frequency [%]"
off, off_tall = (study.tables[by_frequency]["from Eq. 4.1, size"].mean() for study in (found, tall))
print(f"Mean deviation from Eq. 4.1: {off:.1f} % at 1.4 m, {off_tall:.1f} % at 2.8 m")
assert off < 10.0 < off_tall
figure = found.figures["main"]

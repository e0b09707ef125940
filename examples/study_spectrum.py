"""
Overturning spectra
===================

Overturning spectra: how strong a shake fells which block?
"""

# %%
# Of one sine wave, and of the built-in record.
from stayput import studies

found = studies.spectrum(slenderness=(0.2, 0.3), periods=[1.0, 1.5, 2.0, 2.5], step=0.02)
print(found.summary.to_string(index=False))

# %%
# The figures: pulse, record, rocking.
assert {"pulse", "record", "rocking"} == found.figures.keys()
figure = found.figures["pulse"]

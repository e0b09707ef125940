"""
Which measure keeps a bookcase standing
=======================================

Which measure keeps a bookcase standing in strong shaking, and by how much.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import stayput as sp

scenario = sp.Scenario.parse(
    {
        "title": "Bookcase with its back to a wall",
        "furniture": {"preset": "bookcase"},
        "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}},
        "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 8}},
        "uncertainty": {"samples": 16, "seed": 1},
        "measures": [{"type": "felt_glides"}, {"type": "l_bracket"}],
    }
)
verdict = sp.verify(scenario)

for one in verdict.options:
    overturns = one.probabilities["overturned"]
    print(f"{one.rank}. {one.option.label('en')}: overturns in {overturns.text}")
    if one.curves:
        print(f"   half overturn at JMA intensity {one.capacities[0.5].text}")

# brackets in studs hold what falls without them
assert verdict.best.option.name == "l_bracket"
assert (
    verdict.best.probabilities["overturned"].estimate < verdict.without.probabilities["overturned"].estimate
)
assert verdict.best.change is not None
assert verdict.best.change.clear

with tempfile.TemporaryDirectory() as folder:
    report = verdict.report(Path(folder) / "bookcase.html", "ja")
    print(f"The report has {report.stat().st_size / 1000:.0f} kB.")
    assert "L型金具" in report.read_text(encoding="utf-8")

# %%
# The shares in which it overturns, with their 95 % intervals.
figure, axis = plt.subplots(layout="constrained")
verdict.plot(axis)

"""One scenario file, three distances to the wall: the file's rules, Python's loops."""

from pathlib import Path

import stayput as sp

scenario = sp.read_scenario(Path(__file__).parent / "bookcase.toml")
tables = scenario.model_dump(exclude_none=True)
found = {}
for gap in (0.0, 0.02, 0.20):
    tables["room"]["back_wall"] = {"gap": gap}
    found[gap] = sp.Scenario.parse(tables).case().run()
    print(f"gap {gap:.2f} m: {found[gap].outcome}, {found[gap].wall_impacts} wall impacts")

as_read = scenario.case().run()
assert found[0.02].overturn_time == as_read.overturn_time  # the same inputs give the same bits
assert found[0.02].outcome is as_read.outcome
assert all(run.outcome is not sp.Outcome.FAILED for run in found.values())

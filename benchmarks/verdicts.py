"""Processor seconds of whole verdicts: the first answer, all of it, and the plan of a room.

``python benchmarks/verdicts.py [TURNS]``: each of the scenes below in a process of its own, on one thread,
with imports and motions; medians of so many turns, 3 by default. Beside them stand runs, and half-widths of
the 95 % intervals of what people read first, without anything and of the best.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

if TYPE_CHECKING:
    from stayput.scenario import Scenario
    from stayput.verification import Verdict

EXAMPLES = Path(__file__).parents[1] / "examples"
NAMES = ("bookcase", "kitchen", "bedroom", "office", "shelves")

ALONG = {
    "left_wall": ("bookcase", "bookcase", "bookcase", "cupboard"),
    "far_side_wall": ("bookcase", "bookcase", "refrigerator", "vending machine"),
    "right_wall": ("server rack", "server rack"),
    "near_side_wall": ("chest", "cupboard"),
}
"""Presets along the walls of an office, 1.4 m apart."""


def office() -> dict[str, Any]:
    """Return a room of 8 by 6 m with twelve pieces, three desks and two doors."""
    furniture = [
        {"name": f"{wall} {n}", "preset": preset, "against": wall, "along": 1.2 + 1.4 * n}
        for wall, presets in ALONG.items()
        for n, preset in enumerate(presets)
    ]
    desks = [{"kind": "desk", "name": f"desk {n}", "at": [1.6 + 1.8 * n, 2.6]} for n in range(3)]
    doors = [
        {"name": f"door {n}", "wall": "near_side_wall", "start": 0.2 + 6.6 * n, "width": 0.9}
        for n in range(2)
    ]
    return {"plan": {"width": 8.0, "length": 6.0}, "furniture": furniture, "places": desks, "doors": doors}


def shelves() -> dict[str, Any]:
    """Return five rows of a library, 0.6 m apart, with six runs of each of two options."""
    rows = [
        {"name": f"row {n}", "preset": "bookcase", "at": [0.5 + 0.9 * n, 1.5], "heading": 0.0}
        for n in range(5)
    ]
    held = [{"name": "gel mats", "measures": {row["name"]: [{"type": "gel_mats"}] for row in rows}}]
    shaking = {"intensity": "6-upper", "suite": {"count": 6}}
    return {"furniture": rows, "options": held, "shaking": shaking, "uncertainty": {"samples": 6}}


def scenario_of(name: str) -> Scenario:
    """Return the scenario of a name."""
    import stayput as sp

    made = {"office": office, "shelves": shelves}.get(name)
    if made is None:
        return sp.read(EXAMPLES / f"{name}.toml")
    shaking = {"intensity": "6-upper", "suite": {"count": 40}}
    room = {"floor": "vinyl", "ceiling": {"height": 2.6}}
    return sp.Scenario.parse({"room": room, "shaking": shaking} | made())


def measured(name: str) -> dict[str, float]:
    """Verify a scene in this process; return what it took so far, and how many runs it made."""
    import stayput as sp

    first: list[float] = []

    def note(_: Verdict) -> None:
        first.append(time.process_time())

    scenario = scenario_of(name)
    verdict = sp.verify(scenario, threads=1, progress=False, on_verdict=note)
    found = {"first": first[0], "all": time.process_time(), "runs": float(verdict.runs)}
    for of, option in {"none": verdict.without, "best": verdict.options[0]}.items():
        people = option.people
        chance = option.probabilities["overturned"] if people is None else people.hit.chance
        found[of] = 100.0 * chance.half_width
    if scenario.plan is not None:
        plan = sp.action_plan(verdict, threads=1, progress=False)
        found |= {"plan": time.process_time() - found["all"], "plan runs": float(plan.verdict.runs)}
    return found


def main(turns: int) -> Table:
    """Return the medians of all scenes."""
    table = Table(title=f"processor seconds, medians of {turns}", title_justify="left")
    for heading in ("scene", "first", "all", "runs", "± none [%]", "± best [%]", "plan more", "its runs"):
        table.add_column(heading, justify="right")
    columns = ("first", "all", "runs", "none", "best", "plan", "plan runs")
    for name in NAMES:
        call = [sys.executable, __file__, "of", name]
        each = [json.loads(subprocess.check_output(call)) for _ in range(turns)]
        middle = {of: median(row[of] for row in each) for of in each[0]}
        table.add_row(name, *(f"{middle[of]:.1f}" if of in middle else "" for of in columns))
    return table


if __name__ == "__main__":
    if sys.argv[1:2] == ["of"]:
        print(json.dumps(measured(sys.argv[2])))
    else:
        Console(width=110).print(main(int(sys.argv[1]) if len(sys.argv) > 1 else 3))

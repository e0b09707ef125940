"""Small inventories for the tests of them: three motions, two samples, a few pieces."""

from __future__ import annotations

import hashlib
from contextlib import closing
from typing import TYPE_CHECKING, Any, NamedTuple

import stayput as sp

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.inventory import Assessment


class Plan(NamedTuple):
    """Checked rows, rejects, bodies, facts, and for each row whether its building moves, and its storey."""

    rows: list[dict[str, Any]]
    rejects: list[dict[str, Any]]
    bodies: list[sp.Body]
    facts: dict[str, Any]
    moved: list[tuple[bool, int]]


CITY = """
title = "test"
[room]
floor = "wood flooring"
left_wall = { gap = 0.05 }
ceiling = { height = 2.4 }
[shaking]
intensity = 6.0
suite = { family = "crustal", count = 3, seed = 1 }
[uncertainty]
samples = 6
seed = 1
[buildings.office]
storeys = 4
structure = "steel"
[[measures]]
name = "wedge"
type = "wedge_stopper"
[[measures]]
name = "sheet"
type = "anti_slip_sheet"
"""

HEADER = "id,preset,width,height,mass,floor,gap,building,storey,measures,costs,count,value"


def city(folder: Path, text: str = CITY, name: str = "city.toml") -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


def table(folder: Path, rows: list[str], header: str = HEADER, name: str = "inventory.csv") -> Path:
    file = folder / name
    file.write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    return file


def pieces(count: int, different: int = 10) -> list[str]:
    """Rows of which ``different`` are not alike."""
    bodies = [f"{0.30 + 0.01 * n:.2f},1.8,{50 + n}" for n in range(different)]
    return [f"p{n},,{bodies[n % different]},,,office,{1 + n % 4},,,{1 + n % 3},1000" for n in range(count)]


def rows_of_results(done: Assessment) -> list[dict[str, Any]]:
    """All rows of the results."""
    return done.pieces.to_table().to_pylist()


def digests(folder: Path) -> dict[str, str]:
    """Digest of every file of the results, by its name."""
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and not {"work", ".lock"} & set(path.relative_to(folder).parts)
    }


def planned(folder: Path, file: Path, scenario: str = CITY, columns: Any = None) -> Plan:
    """The plan of a table, made in a folder."""
    from stayput.inventory.columns import read_columns
    from stayput.inventory.folder import Workspace
    from stayput.inventory.plan import REJECTED, make_plan
    from stayput.inventory.scenarios import read_scenarios
    from stayput.inventory.store import Store, ground_of
    from stayput.saved import from_text

    space = folder / "space"
    space.mkdir()
    scenarios = read_scenarios(city(folder, scenario))
    facts = make_plan(
        Workspace(space), file, scenarios, 2**24, lambda count: None, columns=read_columns(columns)
    )
    specs, moved = {}, {}
    with closing(Store(space / "plan.sqlite")) as store:
        rows = [row for part in range(facts["parts"]) for row in store.part(part)]
        rejects = [dict(zip(REJECTED, line, strict=True)) for line in store.rejects()]
        for spec, sites in store.grounds():
            for site, storey in sites:
                for unit, _, piece in store.units_at(site):
                    specs[unit], moved[unit] = piece, (ground_of(spec)[2] is not None, storey)
    first = [row["records"][0] for row in rows]
    return Plan(
        rows, rejects, [from_text(specs[unit])[0] for unit in first], facts, [moved[n] for n in first]
    )


def verified(
    gap: float = 0.05,
    floor: str = "wood flooring",
    wall: str | None = None,
    shaking: dict[str, Any] | None = None,
    furniture: dict[str, Any] | None = None,
    **tables: Any,
) -> sp.Verdict:
    """What a verification says of a bookcase, or other furniture, in the room and the shaking of `CITY`."""
    from stayput.verification import verify

    suite = {"family": "crustal", "count": 3, "seed": 1}
    behind = {"gap": gap} if wall is None else {"gap": gap, "construction": wall}
    scenario = {
        "furniture": furniture or {"preset": "bookcase"},
        "room": {"floor": floor, "left_wall": behind, "ceiling": {"height": 2.4}},
        "shaking": {"intensity": 6.0, "suite": suite, **(shaking or {})},
        "uncertainty": {"samples": 6, "seed": 1},
        **tables,
    }
    return verify(sp.Scenario.parse(scenario), levels=(), progress=False, threads=1)

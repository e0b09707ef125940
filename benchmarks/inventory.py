"""Inventories: throughput beside the bare kernel's, threads and processes, memory, the gain of doing once.

``python benchmarks/inventory.py [PART ...]``: space, speed, whole, processes, large, memory; all by default.
Every part runs in a process of its own, so that its memory is its own. ``--json FILE`` keeps the
numbers.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

CITY = """
{plane}[room]
left_wall = {{ gap = 0.05 }}
ceiling = {{ height = 2.4 }}
[shaking]
{shaking}
[uncertainty]
{samples}
"""

SUITE = 'intensity = "6-upper"\nsuite = { family = "mixed", count = 40, seed = 1 }'
ONE = 'builtin = "near-fault"'

BUILDINGS = ("3 RC", "5 RC", "8 steel", "10 RC", "2 wood")
PRESETS = (
    "bookcase",
    "wardrobe",
    "cupboard",
    "chest",
    "refrigerator",
    "television",
    "server rack",
    "upright piano",
)
FLOORS = ("wood flooring", "vinyl", "carpet")


def city(folder: Path, samples: int | None, shaking: str = SUITE) -> Path:
    """A scenario: in the plane with so many samples, or in space with as many as the race takes."""
    file = folder / "city.toml"
    plane, stated = ("", "") if samples is None else ("dimensions = 2\n", f"samples = {samples}")
    file.write_text(CITY.format(plane=plane, samples=stated, shaking=shaking), encoding="utf-8")
    return file


def different(folder: Path, rows: int) -> Path:
    """An inventory in which no two rows are alike; nothing holds the pieces."""
    file = folder / "different.csv"
    rng = np.random.default_rng(1)
    width, height, friction = (
        rng.uniform(0.3, 0.6, rows),
        rng.uniform(1.2, 2.0, rows),
        rng.uniform(0.2, 0.8, rows),
    )
    with file.open("w", encoding="utf-8") as out:
        out.write("id,width,height,mass,floor\n")
        for n in range(rows):
            out.write(f"p{n},{width[n]:.6f},{height[n]:.6f},100,{friction[n]:.6f};{0.8 * friction[n]:.6f}\n")
    return file


def held(folder: Path, rows: int) -> Path:
    """An inventory of bookcases that all differ, each with two measures to compare."""
    file = folder / "held.csv"
    sizes = np.random.default_rng(1).uniform([0.3, 0.8, 1.2, 40.0], [0.6, 1.2, 2.0, 150.0], (rows, 4))
    with file.open("w", encoding="utf-8") as out:
        out.write("id,width,length,height,mass,measures\n")
        for n, (depth, width, height, mass) in enumerate(sizes.tolist()):
            out.write(f"p{n},{depth:.4f},{width:.4f},{height:.4f},{mass:.1f},l_bracket;belt\n")
    return file


def usual(folder: Path, rows: int) -> Path:
    """An inventory as a company has it: presets on three floors in five kinds of building, two measures."""
    file = folder / "usual.csv"
    rng = np.random.default_rng(1)
    kinds = rng.integers(0, [len(PRESETS), len(FLOORS), len(BUILDINGS), 3], (rows, 4))
    with file.open("w", encoding="utf-8") as out:
        out.write("id,preset,floor,gap,building,storey,measures,costs,count,value\n")
        for n, (preset, floor, building, gap) in enumerate(kinds.tolist()):
            storeys = int(BUILDINGS[building].split()[0])
            out.write(
                f"p{n},{PRESETS[preset]},{FLOORS[floor]},{0.05 * gap:.2f},{BUILDINGS[building]},"
                f"{1 + n % storeys},wedge_stopper;anti_slip_sheet,1500;800,1,50000\n"
            )
    return file


def peak_memory() -> float:
    """Largest memory of this process so far [MiB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def load() -> float:
    return os.getloadavg()[0]


def bare(scenario: Path, table: Path, threads: int) -> tuple[int, float, float]:
    """Runs, seconds and CPU seconds of the kernel alone: rows and motions ready, blocks over threads."""
    from stayput.inventory.header import Header
    from stayput.inventory.items import RowReader
    from stayput.inventory.scenarios import read_scenarios
    from stayput.inventory.tables import open_table
    from stayput.montecarlo.sampling import Settings, draws, rows_of
    from stayput.montecarlo.scaled_motions import ScaledMotions
    from stayput.saved import from_text
    from stayput.simulation.many import plane_shaking, run_rows

    cities = read_scenarios(scenario)
    city = cities.all[0]
    reader, settings = RowReader(cities), Settings.of(city.scenario, len(city.ground), 0.1)
    ground = ScaledMotions(city.ground)
    level = city.scenario.shaking.wanted_intensity
    shakings, scales = [*map(plane_shaking, ground.acting)], ground.factors(level, 1.0)
    drawn = draws(settings.motions, settings.samples, settings.seed)
    rows = []
    with open_table(table) as read:
        header = Header(read.header)
        for number, cells in read.rows:
            (exposure,) = reader.exposures(number, header.cells(cells))
            body, room, _ = from_text(exposure.piece)
            rows.append(rows_of(body, room, (), drawn, settings.gravity))
    cases = np.stack([row.cases.reshape(settings.motions, -1) for row in rows])
    elements = np.stack([row.elements.reshape(settings.motions, cases.shape[2], -1) for row in rows])
    pieces = []
    for motion in range(settings.motions):
        mine = np.ascontiguousarray(cases[:, motion]).ravel()
        mine["scale"] = scales[motion]
        ties = np.ascontiguousarray(elements[:, motion]).reshape(len(mine), -1)
        pieces += [(mine[k : k + 128], ties[k : k + 128], shakings[motion]) for k in range(0, len(mine), 128)]
    run_rows(*pieces[0])
    with ThreadPoolExecutor(threads) as pool:
        began, spent = time.perf_counter(), time.process_time()
        list(pool.map(lambda piece: run_rows(*piece), pieces))
        return cases.size, time.perf_counter() - began, time.process_time() - spent


def assessed(folder: Path, scenario: Path, table: Path, threads: int) -> dict[str, float]:
    """Runs a second of an assessment, while it simulates and as a whole, and CPU time of a run."""
    from stayput.inventory import assess

    began = time.process_time()
    done = assess(table, scenario, folder, threads=threads, progress=False)
    spent = time.process_time() - began
    return {
        "simulating": done.runs / done.simulating,
        "whole": done.runs / done.seconds,
        "CPU ms a run": 1e3 * spent / done.runs,
    }


def warm(folder: Path) -> None:
    from stayput.inventory import assess

    assess(different(folder, 20), city(folder, 40), folder / "warm", progress=False)


def speed(folder: Path) -> list[dict[str, Any]]:
    """Throughput of the simulation beside the bare kernel's, at several threads, in turns."""
    warm(folder)
    scenario, table = city(folder, 160), different(folder, 200)
    found: list[dict[str, Any]] = []
    for threads in (1, 2, 4):
        best = {"bare": 0.0, "simulating": 0.0, "whole": 0.0}
        cpu = {"bare": 1e9, "whole": 1e9}
        for turn in range(2):
            runs, seconds, spent = bare(scenario, table, threads)
            best["bare"] = max(best["bare"], runs / seconds)
            cpu["bare"] = min(cpu["bare"], 1e3 * spent / runs)
            done = assessed(folder / f"{threads}-{turn}", scenario, table, threads)
            best |= {name: max(best[name], done[name]) for name in ("simulating", "whole")}
            cpu["whole"] = min(cpu["whole"], done["CPU ms a run"])
        told = {f"CPU ms a run, {name}": value for name, value in cpu.items()}
        found.append({"threads": threads, "runs": runs, **best, **told, "load": load()})
    return found


def space(folder: Path) -> list[dict[str, Any]]:
    """Rows a second in space: bookcases that all differ, with two measures each, on two threads."""
    from stayput.inventory import assess

    scenario = city(folder, None)
    assess(held(folder, 2), scenario, folder / "warm", threads=2, progress=False)
    began = time.process_time()
    done = assess(held(folder, 40), scenario, folder / "space", threads=2, progress=False)
    spent = time.process_time() - began
    return [
        {
            "rows": 40,
            "runs a row": done.runs / 40,
            "rows/s": 40 / done.seconds,
            "CPU s a row": spent / 40,
            "CPU ms a run": 1e3 * spent / done.runs,
            "load": load(),
        }
    ]


def whole(folder: Path) -> list[dict[str, Any]]:
    """100,000 bodies that all differ; the kernel alone on some of them before and after."""
    warm(folder)
    (folder / "some").mkdir()
    scenario, some, table = city(folder, 40), different(folder / "some", 5_000), different(folder, 100_000)

    def alone() -> float:
        runs, seconds, _ = bare(scenario, some, 4)
        return runs / seconds

    before, done, after = alone(), assessed(folder / "whole", scenario, table, 4), alone()
    return [
        {"bodies": 100_000, "before": before, "after": after, **done, "MiB": peak_memory(), "load": load()}
    ]


def processes(folder: Path) -> list[dict[str, Any]]:
    """Throughput on Dask clusters of one-thread processes."""
    from dask.distributed import Client, LocalCluster

    from stayput.inventory import assess

    scenario = city(folder, 160)
    found = []
    for count in (1, 2, 4):
        with (
            LocalCluster(
                n_workers=count, threads_per_worker=1, dashboard_address=None, host="127.0.0.1"
            ) as made,
            Client(made, set_as_default=False) as client,
        ):
            executor = client.get_executor()
            assess(
                different(folder, 40), scenario, folder / f"warm-{count}", executor=executor, progress=False
            )
            done = assess(
                different(folder, 200), scenario, folder / f"p{count}", executor=executor, progress=False
            )
            found.append({"processes": count, "simulating": done.runs / done.simulating, "load": load()})
    return found


def large(folder: Path) -> list[dict[str, Any]]:
    """100,000 usual pieces under 40 motions with 4 draws each."""
    from stayput.inventory import assess

    done = assess(usual(folder, 100_000), city(folder, 160), folder / "large", progress=False)
    facts = done.facts
    return [
        {
            "rows": facts["pieces"],
            "choices": facts["choices"],
            "units": facts["units"],
            "gain": facts["choices"] / facts["units"],
            "runs": done.runs,
            "simulating": done.runs / done.simulating,
            "seconds": done.seconds,
            "memory": peak_memory(),
            "load": load(),
        }
    ]


def memory(folder: Path, kind: str, rows: int) -> list[dict[str, Any]]:
    """Memory and time of an inventory, under one motion so that the table is what costs."""
    from stayput.inventory import assess

    table = {"usual": usual, "different": different}[kind](folder, rows)
    done = assess(table, city(folder, 1, ONE), folder / "memory", progress=False)
    size = sum(path.stat().st_size for path in (folder / "memory" / "pieces").iterdir())
    return [
        {
            "kind": kind,
            "rows": rows,
            "units": done.facts["units"],
            "seconds": done.seconds,
            "simulating": done.simulating,
            "memory": peak_memory(),
            "bytes a row": size / rows,
            "work bytes a row": sum(
                p.stat().st_size for p in (folder / "memory/work").rglob("*") if p.is_file()
            )
            / rows,
            "load": load(),
        }
    ]


PARTS: dict[str, list[tuple[Any, ...]]] = {
    "space": [("space",)],
    "speed": [("speed",)],
    "whole": [("whole",)],
    "processes": [("processes",)],
    "large": [("large",)],
    "memory": [
        ("memory", kind, str(rows)) for kind in ("usual", "different") for rows in (100_000, 1_000_000)
    ],
}


def alone(arguments: list[str]) -> None:
    """Run one part in this process and print its rows."""
    name, *rest = arguments
    with tempfile.TemporaryDirectory() as folder:
        if name == "memory":
            rows = memory(Path(folder), rest[0], int(rest[1]))
        else:
            parts = (space, speed, whole, processes, large)
            rows = next(part for part in parts if part.__name__ == name)(Path(folder))
    print(json.dumps(rows))


def show(title: str, rows: list[dict[str, Any]]) -> None:
    from rich.console import Console
    from rich.table import Table

    table = Table(title=title)
    for name in rows[0]:
        table.add_column(name, justify="right")
    for row in rows:
        table.add_row(
            *(
                f"{v:,.2f}" if isinstance(v, float) else f"{v:,}" if isinstance(v, int) else v
                for v in row.values()
            )
        )
    Console(width=140).print(table)


def main(arguments: list[str]) -> None:
    keep = None
    if "--json" in arguments:
        place = arguments.index("--json")
        keep = Path(arguments[place + 1])
        arguments = arguments[:place] + arguments[place + 2 :]
    found: dict[str, list[dict[str, Any]]] = {}
    for part in arguments or PARTS:
        for line in PARTS[part]:
            told = subprocess.run(
                [sys.executable, __file__, "--alone", *line], stdout=subprocess.PIPE, check=True
            )
            found.setdefault(part, []).extend(json.loads(told.stdout.splitlines()[-1]))
        show(part, found[part])
        if keep is not None:
            keep.write_text(json.dumps(found, indent=1))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--alone"]:
        alone(sys.argv[2:])
    else:
        main(sys.argv[1:])

"""Inventories: throughput beside the bare kernel's, threads and processes, memory, the gain of doing once.

``python benchmarks/inventory.py [PART ...]``: speed, many, whole, kinds, processes, large, memory; all by
default. Every part runs in a process of its own, so that its memory is its own. ``--json FILE`` keeps the
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
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

CITY = """
[room]
left_wall = {{ gap = 0.05 }}
ceiling = {{ height = 2.4 }}
[shaking]
{shaking}
[uncertainty]
samples = {samples}
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


def city(folder: Path, samples: int, shaking: str = SUITE) -> Path:
    file = folder / "city.toml"
    file.write_text(CITY.format(samples=samples, shaking=shaking), encoding="utf-8")
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
    from stayput.montecarlo.scaled_motions import PreparedFloor, ScaledMotions
    from stayput.saved import from_text
    from stayput.simulation.many import run_rows

    cities = read_scenarios(scenario)
    city = cities.all[0]
    reader, settings = RowReader(cities), Settings.of(city.scenario, len(city.ground), 0.1)
    ground = ScaledMotions(city.ground)
    level = city.scenario.shaking.wanted_intensity
    floor = PreparedFloor.of(ground.acting, ground.factors(level, 1.0))
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
        mine["scale"] = floor.scales[motion]
        ties = np.ascontiguousarray(elements[:, motion]).reshape(len(mine), -1)
        pieces += [
            (mine[k : k + 128], ties[k : k + 128], floor.shakings[motion]) for k in range(0, len(mine), 128)
        ]
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


def many(folder: Path) -> list[dict[str, Any]]:
    """The same of many bodies, both at once on two threads each: what else runs is the same for both."""
    warm(folder)
    found: list[dict[str, Any]] = []
    for bodies, draws in ((10_000, 1), (2_500, 4)):
        scenario, table = city(folder, 40 * draws), different(folder, bodies)
        with ProcessPoolExecutor(2, get_context("spawn")) as pool:
            alone = pool.submit(bare, scenario, table, 2)
            whole = pool.submit(assessed, folder / f"many-{draws}", scenario, table, 2)
            (runs, seconds, spent), done = alone.result(), whole.result()
        told = {"bodies": bodies, "draws": draws, "runs": runs, "bare": runs / seconds, **done}
        found.append({**told, "CPU ms a run, bare": 1e3 * spent / runs, "load": load()})
    return found


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


def kinds(folder: Path) -> list[dict[str, Any]]:
    """Time of a run of a full bookcase by what holds it, on one thread, the best of three."""
    import stayput as sp
    from stayput.inventory.scenarios import read_scenarios
    from stayput.inventory.store import record_type
    from stayput.inventory.work import evaluate
    from stayput.measures import MEASURES
    from stayput.montecarlo.sampling import Settings
    from stayput.montecarlo.scaled_motions import PreparedFloor, ScaledMotions
    from stayput.saved import to_text

    stated = read_scenarios(city(folder, 160)).all[0]
    ground = ScaledMotions(stated.ground)
    floor = PreparedFloor.of(ground.acting, ground.factors(6.25, 1.0))
    settings = Settings.of(stated.scenario, len(stated.ground), 0.1)
    outcome = record_type(settings.motions, settings.samples)
    room = sp.Room(left_wall=sp.Wall(0.05), ceiling=sp.Ceiling(2.4))
    unit = [(0, to_text((sp.Body(0.3, 1.8, 200.0), room, None)))]
    found = []
    for kind in (None, "wedge_stopper", "gel_mats", "belt", "l_bracket", "tension_pole"):
        spec = to_text([MEASURES[kind]()] if kind else [])
        times: list[float] = []
        for _ in range(3):
            began = time.process_time()
            _, runs = evaluate(unit, spec, floor, settings, outcome)
            times.append(1e3 * (time.process_time() - began) / runs)
        found.append({"measure": kind or "none", "CPU ms a run": min(times), "load": load()})
    return found


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
    "speed": [("speed",)],
    "many": [("many",)],
    "whole": [("whole",)],
    "kinds": [("kinds",)],
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
            parts = (speed, many, whole, kinds, processes, large)
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

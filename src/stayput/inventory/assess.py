"""`assess`: an inventory from its table to results; an interrupted assessment is resumed where it stopped."""

from __future__ import annotations

import hashlib
import json
import re
import time
from collections.abc import Generator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import closing, contextmanager
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import stayput
from stayput.catalogue import Language, phrase
from stayput.errors import InputError, instance_of, not_allowed, reason_of, within
from stayput.execution import Pool
from stayput.files import arrow
from stayput.inventory.columns import read_columns
from stayput.inventory.folder import MANIFEST, PLAN, called, check_parts, claimed, input_digest, inputs_of
from stayput.inventory.plan import make_plan
from stayput.inventory.report import report_html
from stayput.inventory.results import PIECES, part_names, write_results
from stayput.inventory.scenarios import Changed, ScenarioFile, read_scenarios
from stayput.inventory.shakemap_files import read_shakemap
from stayput.inventory.store import Store
from stayput.inventory.summary import REJECTS, Summary, export_results, formats_of, summarise, write_rejects
from stayput.inventory.work import Work
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.progress import bar
from stayput.report.summary import attributes

MEMORY = 2 * 2**30
"""Memory that an assessment keeps below [bytes]."""

_UNITS = {"": 1, "k": 2**10, "m": 2**20, "g": 2**30, "t": 2**40}

REPORTS: dict[Language, str] = {"en": "report.html", "ja": "report.ja.html"}
"""The reports in each language: their names do not depend on the language of who runs the command."""


@dataclass(frozen=True, slots=True, eq=False)
class Assessment:
    """The result of an assessment; its tables are in its folder.

    Parameters
    ----------
    folder : Path
        Where they are.
    facts : dict
        Counts of rows, empty rows, pieces, rejects, choices (combinations of piece, measures, floor and
        event) and units (the different ones among them), how the table was read, columns that were not used.
    summary : Summary
        Totals by event, building and storey, and the worst pieces.
    runs : int
        Simulations that this call did.
    seconds : float
        Time that this call took [s].
    simulating : float
        Time of it in which it simulated [s].
    """

    folder: Path
    facts: dict[str, Any]
    summary: Summary
    runs: int
    seconds: float
    simulating: float

    @property
    def pieces(self) -> Any:
        """The results as a dataset of PyArrow: one row a piece and event."""
        return arrow("dataset").dataset(self.folder / PIECES, format="parquet")

    def report(self, language: Language) -> Path:
        """Return the report in a language."""
        return self.folder / REPORTS[language]

    @property
    def rejects(self) -> Any:
        """The rows that were not assessed, as a table of PyArrow: row, id, name, reason, and reason_ja."""
        return arrow("parquet").read_table(self.folder / REJECTS)


def assess(
    inventory: str | Path,
    scenario: str | Path | ScenarioFile,
    out: str | Path,
    *,
    changed: Changed | None = None,
    shakemap: str | Path | None = None,
    field: str | None = None,
    uncertainty: str | Path | None = None,
    columns: str | Path | Mapping[str, Any] | None = None,
    export: str | Sequence[str] = (),
    slide_limit: float = SLIDE_LIMIT,
    threads: int | None = None,
    executor: Executor | None = None,
    memory: float | str = MEMORY,
    progress: bool | None = None,
) -> Assessment:
    """Assess every piece of an inventory, and write the results to a folder.

    Called again with the same inputs it goes on from what is complete, and the results are the same to the
    last byte as if it had never been interrupted, however often and by whatever.

    Parameters
    ----------
    inventory : str or Path
        The table: .csv, .tsv or .txt (with commas, semicolons or tabs; UTF-8, cp932 or UTF-16), .parquet or
        .xlsx (its first sheet); a row a piece.
    scenario : str, Path or ScenarioFile
        A scenario file, or a folder of them: one event each or, with ``[station]``, stations.
    out : str or Path
        Folder of the results; new, empty, or of the same assessment.
    changed : callable, optional
        Called with the tables of each scenario file and its path; what it returns is taken in their place.
    shakemap : str or Path, optional
        How strongly the ground shakes where each piece stands: a grid of USGS ShakeMap (grid.xml), or CSV
        of lat, lon, one of intensity (JMA's), sa_0.3 (Sa at 0.3 s, 5 % damping [g]; any period), pga[%g],
        pgv[cm/s] and mmi, and sigma where it is known.
    field : str, optional
        Which of the map's columns or fields counts, where it has several; of a grid PGV by default.
    uncertainty : str or Path, optional
        The grid's uncertainty.xml: the motions have their strengths out of this scatter.
    columns : str, Path or mapping, optional
        Which of the table's columns is which, where its header does not say it: stayput's names with those
        of the table, as "width=奥行[mm],ignore=備考", a TOML or JSON file, or a mapping.
    export : str or sequence of str
        Further formats of the results, as "csv,geojson": pieces.csv, and pieces.geojson for maps.
    slide_limit : float
        Slide that counts as too far [m].
    threads : int, optional
        As many as there are cores by default.
    executor : concurrent.futures.Executor, optional
        Simulates instead, on processes or on the machines of a cluster; Dask's is ``client.get_executor()``.
        Then `threads` is how many tasks it computes at a time, by default 128.
    memory : float or str
        Memory to stay below, in bytes or such as "2GB".
    progress : bool, optional
        Whether to draw bars on standard error; default on a terminal.

    Raises
    ------
    InputError
        An inventory, scenario or map that cannot be read; a folder that holds something else; a disk that is
        full; an executor that is lost.

    Examples
    --------
    >>> import stayput as sp
    >>> done = sp.assess("examples/city/inventory.csv", "examples/city/city.toml", "out", progress=False)
    """
    began = time.perf_counter()
    limit, memory_bytes = within("verification.slide_limit", slide_limit, 0.0, 1e3, "m"), memory_of(memory)
    arrow()
    for name, path in {"inventory": inventory, "out": out}.items():
        instance_of(name, path, (str, PathLike))
    instance_of("scenario", scenario, (str, PathLike, ScenarioFile))
    table, folder, mapping = Path(inventory), Path(out), read_columns(columns)
    formats = formats_of(export)
    for name, value in {"field": field, "uncertainty": uncertainty}.items():
        if shakemap is None and value is not None:
            raise InputError("scenario.needs_both", "shakemap", name=name, other="shakemap")
    paths = {"inventory": inventory, "shake map": shakemap, "uncertainty": uncertainty}
    files = {name: Path(path) for name, path in paths.items() if path is not None}
    digests = {name: input_digest(name, path) for name, path in files.items()}
    map_path = files.get("shake map")
    shaking = None if map_path is None else read_shakemap(map_path, field, files.get("uncertainty"))
    scenarios = read_scenarios(scenario, shaking, changed)
    inputs = {
        "inventory": digests["inventory"],
        "scenario": [file.digest for file in scenarios.all],
        "shake map": digests.get("shake map"),
        "field": field,
        "uncertainty": digests.get("uncertainty"),
        "columns": [[*map(list, mapping.pairs)], [*mapping.ignored]],
        "slide limit": limit,
    }

    def check_unchanged() -> None:
        for name, path in files.items():
            if input_digest(name, path) != digests[name]:
                raise InputError("inventory.changed", file=called(name), path=path)

    with _full_disk(folder), claimed(folder, inputs) as space:
        with bar(_rows_about(table), "progress.reading", progress, "progress.rows") as advance:
            facts = make_plan(space, table, scenarios, memory_bytes // 16, advance, check_unchanged, mapping)
        if not facts["pieces"]:
            formats = ()  # there is nothing to export
        check_parts(folder / PIECES, set(part_names(facts["parts"])))
        with (
            closing(Store(space.folder / PLAN, memory_bytes // 16)) as store,
            closing(
                Work(store, scenarios, space.folder, slide_limit=limit, floor_memory=memory_bytes // 8)
            ) as work,
        ):
            started = time.perf_counter()
            if work.left:
                units = bar(work.left, "progress.simulating", progress, "progress.units")
                with units as advance, Pool(threads, executor) as pool:
                    work.run(pool, advance)
            simulating = time.perf_counter() - started
            manifest = _manifest(work, limit)
            digest = hashlib.sha256(json.dumps([inputs, stayput.__version__]).encode())
            about = {"stayput": json.dumps({"inputs": digest.hexdigest(), **manifest}, sort_keys=True)}
            rows = facts["pieces"] * len(scenarios.events)
            with bar(rows, "progress.writing", progress, "progress.rows") as advance:
                write_results(folder / PIECES, space, work, about, advance)
            write_rejects(folder, space, store)
        summary = summarise(folder / PIECES)
        summary.write(folder, space, facts["currency"])
        for language, name in REPORTS.items():
            with space.durable(folder / name) as file:
                file.write(report_html(summary, facts, manifest, language).encode())
        export_results(folder, space, formats)
        made = {"inputs": inputs_of(folder), "plan": facts, "assessment": manifest}
        space.write_json(folder / MANIFEST, made)
    return Assessment(folder, facts, summary, work.runs, time.perf_counter() - began, simulating)


def memory_of(value: float | str) -> int:
    """Return a memory in bytes: a number, or a text such as "2GB" or "512 MiB".

    Raises
    ------
    InputError
        Something else, or less than 256 MiB.
    """
    if isinstance(value, str):
        match = re.fullmatch(r"\s*([\d.]+)\s*([kmgt]?)(i?b)?\s*", value, re.IGNORECASE | re.ASCII)
        if match is None or match[1].count(".") > 1 or match[1] == ".":
            raise not_allowed("inventory.memory", repr(value), "inventory.memory_format", "memory")
        value = float(match[1]) * _UNITS[match[2].lower()]
    return int(within("inventory.memory", value, 2**28, 2**50, "bytes"))


@contextmanager
def _full_disk(folder: Path) -> Generator[None]:
    """Turn errors of the disk into an `InputError`."""
    import sqlite3

    try:
        yield
    except (OSError, sqlite3.DatabaseError) as error:
        reason = reason_of(error)
        where = getattr(error, "filename2", None) or getattr(error, "filename", None)
        at = phrase("inventory.at_path", path=repr(str(where))) if where else ""
        raise InputError("inventory.unwritable", "out", folder=folder, reason=reason, at=at) from error


def _rows_about(table: Path) -> int:
    """Return about how many rows a table has, for the bar."""
    if table.suffix.lower() == ".parquet":
        try:
            return int(arrow("parquet").read_metadata(table).num_rows)
        except (OSError, arrow().ArrowInvalid):
            return 1
    with table.open("rb") as file:
        start = file.read(2**18)
    lines = max(start.count(b"\n"), 1)
    return max(1, round(lines * table.stat().st_size / max(len(start), 1)))


def _manifest(work: Work, limit: float) -> dict[str, Any]:
    scenarios, shakemap = work.scenarios, work.scenarios.shakemap
    return {
        "version": stayput.__version__,
        "slide limit": limit,
        "shake map": None if shakemap is None else shakemap.about,
        "scenarios": [
            {
                **attributes(file, "name", "digest"),
                "suite": file.ground.name,
                "synthetic": file.ground.synthetic,
                "intensity": work.strengths(file.name, None)["intensity"] if shakemap is None else None,
                **attributes(settings, "motions", "samples", "seed", "precision"),
            }
            for file, settings in zip(scenarios.all, work.settings, strict=True)
        ],
    }

"""``stayput assess``: every piece of an inventory."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import say
from stayput.cli.flags import LanguageOption, QuietOption, SetOption, ThreadsOption, changed
from stayput.cli.messages import note, print_json, tell_written
from stayput.cli.streams import NAME, file_of, is_stream, table_of_input
from stayput.errors import InputError, absent
from stayput.progress import language_of_bars

if TYPE_CHECKING:
    from stayput.inventory import Assessment
    from stayput.inventory.scenarios import ScenarioFile

CONNECTING = 20.0
"""Time in which a scheduler must answer [s]."""


def assess(
    inventory: Annotated[Path, typer.Argument(metavar="TABLE", help="cli_help.inventory")],
    scenario: Annotated[Path, typer.Option(metavar="FILE|DIR", help="cli_help.events")],
    out: Annotated[Path, typer.Option(metavar="DIR", help="cli_help.assessment_out")],
    settings: SetOption = None,
    shakemap: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.shakemap")] = None,
    field: Annotated[str | None, typer.Option(metavar="NAME", help="cli_help.field")] = None,
    uncertainty: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.uncertainty")] = None,
    columns: Annotated[
        str | None, typer.Option(metavar="NAME=COLUMN,…|FILE", help="cli_help.columns")
    ] = None,
    export: Annotated[str, typer.Option(metavar="FORMATS", help="cli_help.export")] = "",
    slide_limit: Annotated[float, typer.Option(help="cli_help.slide_limit")] = 0.10,
    threads: ThreadsOption = None,
    scheduler: Annotated[str | None, typer.Option(metavar="ADDRESS", help="cli_help.scheduler")] = None,
    memory: Annotated[str, typer.Option(help="cli_help.memory")] = "2GB",
    lang: LanguageOption = "",
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput assess``."""
    from stayput.inventory import assess as run
    from stayput.inventory.summary import formats_of

    def under_flags(tables: Mapping[str, Any], file: Path | None = None) -> dict[str, Any]:
        return changed(tables, {"set": settings or []}, file)

    with _executor(scheduler) as executor:
        assessment = run(
            file_of(str(inventory), "TABLE", ".csv"),
            _scenario_of_input(under_flags) if is_stream(scenario) else scenario,
            out,
            changed=under_flags,
            shakemap=None if shakemap is None else file_of(str(shakemap), "--shakemap", ".csv"),
            field=field,
            uncertainty=uncertainty,
            columns=columns,
            export=export,
            slide_limit=slide_limit,
            threads=threads,
            executor=executor,
            memory=memory,
        )
    if json:
        print_json(_record(assessment))
    else:
        _print(assessment, formats_of(export) if assessment.facts["pieces"] else (), lang)
    if not assessment.facts["pieces"]:
        raise InputError("cli.no_row", rejects=str(assessment.folder / "rejects.csv"))


@contextmanager
def _executor(scheduler: str | None) -> Generator[Executor | None]:
    """Give Dask's executor of the scheduler at an address, and none without one."""
    if scheduler is None:
        yield None
        return
    try:
        from dask.distributed import Client
    except ImportError:
        raise absent("A cluster", "Dask", "cluster") from None
    try:
        client: Any = Client(scheduler, timeout=CONNECTING, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        raise InputError(
            "inventory.no_scheduler", "scheduler", scheduler=repr(scheduler), reason=str(error)
        ) from None
    try:
        note(say("inventory_report.dashboard", language_of_bars(), link=client.dashboard_link))
        if not client.scheduler_info(n_workers=-1)["workers"]:
            note(say("common.no_worker", language_of_bars()))
        yield client.get_executor()
    finally:
        client.close(timeout=5)


def _scenario_of_input(under_flags: Callable[[Mapping[str, Any]], dict[str, Any]]) -> ScenarioFile:
    """Return the scenario on standard input; its paths begin in the working folder."""
    from stayput.inventory.scenarios import scenario_file_of

    return scenario_file_of(under_flags(table_of_input("--scenario")), Path(NAME))


def _record(assessment: Assessment) -> dict[str, object]:
    events = {
        name: {key: number for key, number in total.numbers.items() if key != "rows"}
        for name, total in assessment.summary.events.items()
    }
    return {
        "folder": str(assessment.folder),
        **assessment.facts,
        "events": events,
        "runs": assessment.runs,
        "seconds": assessment.seconds,
    }


def _print(assessment: Assessment, exported: Sequence[str], lang: str) -> None:
    from stayput.inventory.report import printed_lines

    facts, events = assessment.facts, assessment.summary.events
    for line in printed_lines(facts, events, assessment.runs, "geojson" in exported):
        typer.echo(say(line, lang))
    files = (assessment.folder / f"pieces.{name}" for name in exported)
    tell_written(lang, assessment.report("ja" if lang == "ja" else "en"), *files)

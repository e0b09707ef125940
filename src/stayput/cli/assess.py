"""``stayput assess``: every piece of an inventory."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import say
from stayput.cli.flags import OF_LOCALE, LanguageOption, QuietOption, SetOption, ThreadsOption, changed
from stayput.cli.messages import note, print_json, tell_written
from stayput.cli.streams import NAME, file_of, is_stream, table_of_input
from stayput.progress import language_of_bars

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Mapping, Sequence
    from concurrent.futures import Executor

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
    lang: LanguageOption = OF_LOCALE,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput assess``."""
    from stayput.inventory import assess as run
    from stayput.inventory.exports import formats_of

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
        from stayput.errors import InputError

        raise InputError("cli.no_row", rejects=assessment.folder / "rejects.csv")


@contextmanager
def _executor(scheduler: str | None) -> Generator[Executor | None]:
    """Give Dask's executor of the scheduler at an address, and none without one."""
    if scheduler is None:
        yield None
        return
    from stayput.errors import InputError, absent

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
    from stayput.inventory.results import Finding

    events = {
        name: {
            "pieces": total.pieces,
            "expected_overturned": total.fallen,
            **{
                f"share_overturned{which}": total.share(which)
                for which in ("", "_low", "_high", "_best", "_best_low", "_best_high")
            },
            "expected_overturned_best": total.fallen_best,
            "expected_loss": total.loss,
            "expected_loss_best": total.loss_best,
            **{f"pieces_{finding}": total.found[finding] for finding in Finding},
            "contents_out_share": total.share_out,
            "contents_out_share_best": total.share_out_best,
        }
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
    from stayput.inventory.words import (
        counted_phrase,
        empty_told,
        impossible_told,
        narrow_told,
        printed,
        read_as,
        reason_told,
        rows_told,
    )

    def line(key: str, **values: object) -> None:
        typer.echo(say(f"inventory_report.{key}", lang, **values))

    facts = assessment.facts
    rows = counted_phrase(facts["rows"], "row", "行")
    line("printed_read", rows=rows, how=read_as(facts), pieces=f"{facts['pieces']:,}")
    if facts["columns renamed"]:
        line("renamed", columns=", ".join(facts["columns renamed"]))
    if facts["columns not used"]:
        line("not_used", columns=", ".join(facts["columns not used"]))
    if facts["rejects"]:
        line("printed_rejects", rows=counted_phrase(facts["rejects"], "row", "行"))
        for found in facts["rejects alike"]:
            line("reason_of_rows", rows=rows_told(found, lang), reason=reason_told(found, lang))
    if empty := empty_told(facts, lang):
        typer.echo(empty)
    without = facts["pieces"] - facts["with coordinates"]
    if 0 < without < facts["pieces"]:
        line("without_coordinates", pieces=counted_phrase(without, "piece", "点"))
    choices = counted_phrase(facts["choices"], "combination", "通り")
    runs = counted_phrase(assessment.runs, "run", "回")
    line("printed_runs", choices=choices, units=f"{facts['units']:,}", runs=runs)
    for name, total in assessment.summary.events.items():
        for sentence in printed(total, name, lang):
            typer.echo(sentence)
    for sentence in (narrow_told(facts, lang), *impossible_told(facts, lang)):
        if sentence:
            typer.echo(sentence)
    files = (assessment.folder / f"pieces.{name}" for name in exported)
    tell_written(lang, assessment.report("ja" if lang == "ja" else "en"), *files)

"""``stayput assess``: every piece of an inventory."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.catalogue import say
from stayput.cli.flags import QuietOption, ThreadsOption  # noqa: TC001 - Typer reads the annotations
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import note, print_json, tell_written
from stayput.cli.streams import file_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.inventory import Assessment


def assess(
    inventory: Annotated[
        Path,
        typer.Argument(
            metavar="TABLE",
            help="The inventory, a row a piece: .csv, .tsv, .xlsx or .parquet; - is a CSV on standard input.",
        ),
    ],
    scenario: Annotated[
        Path,
        typer.Option(metavar="FILE|DIR", help="A scenario, or a folder of them: events or stations."),
    ],
    out: Annotated[
        Path, typer.Option(metavar="DIR", help="Folder of the results; the same command goes on in it.")
    ],
    shakemap: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="ShakeMap's grid.xml, or CSV of lat, lon and intensity, sa_0.3, pga[%g], pgv[cm/s] or mmi.",
        ),
    ] = None,
    field: Annotated[
        str | None, typer.Option(metavar="NAME", help="Field of the shake map that counts, such as PGV.")
    ] = None,
    uncertainty: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="ShakeMap's uncertainty.xml: scatter of the shaking."),
    ] = None,
    columns: Annotated[
        str | None,
        typer.Option(
            metavar="NAME=COLUMN,…|FILE",
            help="Which columns of the table are which: width=奥行[mm],ignore=備考; or a TOML or JSON file.",
        ),
    ] = None,
    export: Annotated[
        str,
        typer.Option(metavar="FORMATS", help="Results also as csv, geojson and gpkg (for QGIS): csv,gpkg."),
    ] = "",
    slide_limit: Annotated[float, typer.Option(help="Slide that counts as too far [m].")] = 0.10,
    threads: ThreadsOption = None,
    scheduler: Annotated[
        str | None,
        typer.Option(metavar="ADDRESS", help="A Dask scheduler whose workers simulate: tcp://host:8786."),
    ] = None,
    memory: Annotated[str, typer.Option(help="Memory to stay below.")] = "2GB",
    lang: LanguageOption = OF_LOCALE,
    json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
    quiet: QuietOption = False,
) -> None:
    """Assess every piece of an inventory: how likely it overturns, and which measure helps most.

    Interrupted, the same command goes on from what is complete.
    """
    from stayput.inventory import assess as run
    from stayput.inventory.exports import formats_of

    assessment = run(
        file_of(str(inventory), "TABLE", ".csv"),
        scenario,
        out,
        shakemap=None if shakemap is None else file_of(str(shakemap), "--shakemap", ".csv"),
        field=field,
        uncertainty=uncertainty,
        columns=columns,
        export=export,
        slide_limit=slide_limit,
        threads=threads,
        scheduler=scheduler,
        memory=memory,
        say=note,
    )
    if json:
        print_json(_record(assessment))
    else:
        _print(assessment, formats_of(export) if assessment.facts["pieces"] else (), lang)
    if not assessment.facts["pieces"]:
        from stayput.errors import InputError

        raise InputError("cli.no_row", rejects=assessment.folder / "rejects.csv")


def _record(assessment: Assessment) -> dict[str, object]:
    events = {
        name: {
            "pieces": total.pieces,
            "expected_overturned": total.fallen,
            "expected_overturned_best": total.fallen_best,
            "expected_loss": total.loss,
            "expected_loss_best": total.loss_best,
            "pieces_helped": total.helped,
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
    from stayput.inventory.words import counted_phrase, narrow_told, printed, read_as

    def line(key: str, **values: object) -> None:
        typer.echo(say(f"inventory_report.{key}", lang, **values))

    facts = assessment.facts
    rows, how = counted_phrase(facts["rows"], "row", "行"), read_as(facts["read as"])
    line("printed_read", rows=rows, how=how, pieces=f"{facts['pieces']:,}")
    if facts["columns renamed"]:
        line("renamed", columns=", ".join(facts["columns renamed"]))
    if facts["columns not used"]:
        line("not_used", columns=", ".join(facts["columns not used"]))
    if facts["rejects"]:
        line("printed_rejects", rows=counted_phrase(facts["rejects"], "row", "行"))
    without = facts["pieces"] - facts["with coordinates"]
    if 0 < without < facts["pieces"]:
        line("without_coordinates", pieces=counted_phrase(without, "piece", "点"))
    choices = counted_phrase(facts["choices"], "combination", "通り")
    runs = counted_phrase(assessment.runs, "run", "回")
    line("printed_runs", choices=choices, units=f"{facts['units']:,}", runs=runs)
    for name, total in assessment.summary.events.items():
        for sentence in printed(total, name, lang):
            typer.echo(sentence)
    if narrow := narrow_told(facts, lang):
        typer.echo(narrow)
    files = (assessment.folder / f"pieces.{name}" for name in exported)
    tell_written(lang, assessment.report("ja" if lang == "ja" else "en"), *files)

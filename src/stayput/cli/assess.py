"""``stayput assess``: every piece of an inventory."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from stayput.inventory import Assessment


def assess(
    inventory: Annotated[
        Path, typer.Argument(metavar="TABLE", help="The inventory, a row a piece: .csv, .parquet or .xlsx.")
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
        typer.Option(metavar="FILE", help="CSV of lat, lon and intensity (JMA), or sa_0.3 (at 0.3 s) [g]."),
    ] = None,
    slide_limit: Annotated[float, typer.Option(help="Slide that counts as too far [m].")] = 0.10,
    threads: Annotated[int | None, typer.Option(help="Threads; default one for each core.")] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(metavar="ADDRESS", help="A Dask scheduler whose workers simulate: tcp://host:8786."),
    ] = None,
    memory: Annotated[str, typer.Option(help="Memory to stay below.")] = "2GB",
    json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
) -> None:
    """Assess every piece of an inventory: how likely it overturns, and which measure helps most.

    Interrupted, the same command goes on from what is complete.
    """
    from stayput.inventory import assess as run

    done = run(
        inventory,
        scenario,
        out,
        shakemap=shakemap,
        slide_limit=slide_limit,
        threads=threads,
        scheduler=scheduler,
        memory=memory,
        say=lambda text: typer.echo(text, err=True),
    )
    if json:
        import json as writer

        typer.echo(writer.dumps(_record(done), allow_nan=False))
    else:
        _print(done)
    if not done.facts["pieces"]:
        from stayput.errors import InputError

        rejects = done.folder / "rejects.csv"
        raise InputError("cli.no_row", rejects=rejects)


def _record(done: Assessment) -> dict[str, object]:
    events = {
        name: {
            "pieces": total.pieces,
            "expected_overturned": total.fallen,
            "expected_overturned_best": total.fallen_best,
            "expected_loss": total.loss,
            "expected_loss_best": total.loss_best,
            "pieces_helped": total.helped,
        }
        for name, total in done.summary.events.items()
    }
    return {
        "folder": str(done.folder),
        **done.facts,
        "events": events,
        "runs": done.runs,
        "seconds": done.seconds,
    }


def _print(done: Assessment) -> None:
    from stayput.fragility.probabilities import percent
    from stayput.wording import counted

    facts = done.facts
    typer.echo(f"Read {counted(facts['rows'], 'row')} as {facts['read as']}: {facts['pieces']:,} assessed.")
    if facts["columns not used"]:
        typer.echo(f"Columns that were not used: {', '.join(facts['columns not used'])}.")
    if facts["rejects"]:
        typer.echo(f"Not assessed: {counted(facts['rejects'], 'row')}; rejects.csv says why, row by row.")
    different = f"{counted(facts['choices'], 'combination')}, {facts['units']:,} of them different"
    typer.echo(f"{different}; {counted(done.runs, 'run')}.")
    for name, total in done.summary.events.items():
        known = total.pieces > total.unknown
        share = f"{percent(total.share)} %" if known else "all runs were given up"
        pieces = counted(total.pieces, "piece")
        told = f"{name}: expected to overturn: {total.fallen:,.1f} of {pieces} ({share})"
        if total.fallen_best < total.fallen:
            told += f", {total.fallen_best:,.1f} with the best measures"
        elif not total.helped:
            told += "; none of the compared measures helps any of them"
        typer.echo(f"{told}.")
    typer.echo(f"Wrote {done.folder / 'report.html'}")

"""``stayput motion``: what a record says."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.cli.options import Component, TimeStep, Unit  # noqa: TC001 - Typer reads the annotations

if TYPE_CHECKING:
    from stayput.motion import Motion

app = typer.Typer(help="Look at a motion of the floor.", no_args_is_help=True, rich_markup_mode=None)


@app.callback()
def _group() -> None:  # pyright: ignore[reportUnusedFunction] - keeps ``info`` a command of its own
    """Look at a motion of the floor."""


@app.command()
def info(
    motion: Annotated[
        str, typer.Argument(metavar="FILE", help="A record's file; or near-fault, or sine:A,F[,T].")
    ],
    component: Component = None,
    unit: Unit = None,
    dt: TimeStep = None,
    json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Plot acceleration, velocity, displacement: .png, .svg or .pdf."),
    ] = None,
) -> None:
    """Say how long and how strong a motion is, component by component."""
    from stayput.cli.flags import motion_of

    if plot is not None:
        from stayput.report.files import PLOT_SUFFIXES, check_target

        check_target(plot, PLOT_SUFFIXES)
    read = motion_of(motion, component=component, unit=unit, dt=dt)
    if plot is not None:
        from stayput.report.plot import plot_motion

        plot_motion(read, plot)
    if json:
        import json as writer

        typer.echo(writer.dumps(_record(read), allow_nan=False))
    else:
        _print_table(read, plot)


def _record(motion: Motion) -> dict[str, Any]:
    return {
        "name": motion.name,
        "source": motion.source,
        "synthetic": motion.synthetic,
        "dt_s": motion.dt,
        "samples": len(motion),
        "duration_s": motion.duration,
        "components": {
            name: {
                "pga_m_s2": peaks.pga,
                "pgv_m_s": peaks.pgv,
                "pgd_m": peaks.pgd,
                "arias_m_s": peaks.arias,
                "significant_duration_s": peaks.significant_duration,
            }
            for name, peaks in motion.peaks().items()
        },
    }


def _print_table(motion: Motion, plot: Path | None) -> None:
    from rich.console import Console
    from rich.table import Table

    from stayput.report.summary import motion_label

    console = Console(highlight=False, markup=False)
    console.print(motion_label(motion), style="bold")
    console.print(motion.source)
    console.print(f"{len(motion)} samples every {motion.dt:g} s: {motion.duration:g} s")
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("")
    for heading in ("PGA [m/s²]", "PGV [cm/s]", "PGD [cm]", "Arias [m/s]", "D5-95 [s]"):
        table.add_column(heading, justify="right")
    names = {"x": "x (along)", "y": "y (across)", "z": "z (up)"}
    for name, peaks in motion.peaks().items():
        values = (peaks.pga, 100.0 * peaks.pgv, 100.0 * peaks.pgd, peaks.arias, peaks.significant_duration)
        table.add_row(names[name], *(f"{value:.3g}" for value in values))
    console.print(table)
    if plot is not None:
        console.print(f"Wrote {plot}", soft_wrap=True)

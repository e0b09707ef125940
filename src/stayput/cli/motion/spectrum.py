"""``stayput motion spectrum``: response spectra."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.cli.options import Component, MotionText, TimeStep, Unit  # noqa: TC001 - Typer reads them

if TYPE_CHECKING:
    from stayput.motion import Motion
    from stayput.motion.spectrum import ResponseSpectrum

SHOWN = (0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0)
"""Periods of the table that is printed [s]."""


def spectrum(
    motion: MotionText,
    component: Component = None,
    unit: Unit = None,
    dt: TimeStep = None,
    damping: Annotated[float, typer.Option(help="Damping ratio of the oscillators, 0 to 0.95.")] = 0.05,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write the spectra of all components: .csv.")
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Plot them, and the Fourier spectra: .png, .svg, .pdf."),
    ] = None,
) -> None:
    """Print the response spectra of a motion: what it does to oscillators of every period."""
    from stayput.cli.flags import motion_of
    from stayput.files import PLOT_SUFFIXES, check_target
    from stayput.motion.spectrum import PERIODS, response_spectrum

    if out is not None:
        check_target(out, (".csv",))
    if plot is not None:
        check_target(plot, PLOT_SUFFIXES)
    read = motion_of(motion, component=component, unit=unit, dt=dt)
    _print_table(read, {name: response_spectrum(read, SHOWN, damping, name) for name in read.components})
    if out is not None:
        _write(out, {name: response_spectrum(read, PERIODS, damping, name) for name in read.components})
        typer.echo(f"Wrote {out}")
    if plot is not None:
        from stayput.report.spectrum import plot_spectra

        plot_spectra(read, plot, damping)
        typer.echo(f"Wrote {plot}")


def _columns(found: dict[str, ResponseSpectrum]) -> dict[str, list[float]]:
    columns = {"period_s": next(iter(found.values())).periods.tolist()}
    for name, spectrum in found.items():
        columns[f"sa_{name}_m_s2"] = spectrum.sa.tolist()
        columns[f"psv_{name}_m_s"] = spectrum.psv.tolist()
        columns[f"sva_{name}_m_s"] = spectrum.sva.tolist()
        columns[f"sd_{name}_m"] = spectrum.sd.tolist()
    return columns


def _write(out: Path, found: dict[str, ResponseSpectrum]) -> None:
    from stayput.files import draft

    columns = _columns(found)
    rows = [",".join(map(repr, row)) for row in zip(*columns.values(), strict=True)]
    with draft(out) as unfinished:
        unfinished.write_text("\n".join([",".join(columns), *rows, ""]), encoding="utf-8")


def _print_table(motion: Motion, found: dict[str, ResponseSpectrum]) -> None:
    from rich.console import Console
    from rich.table import Table

    from stayput.report.summary import motion_label

    console = Console(highlight=False, markup=False)
    damping = 100.0 * next(iter(found.values())).damping
    console.print(f"{motion_label(motion)}: response spectra, {damping:g} % damping", style="bold")
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("Period [s]", justify="right")
    for name in found:
        for label in (f"Sa {name} [m/s²]", f"ω·Sd {name} [cm/s]"):
            table.add_column(label, justify="right")
    for i, period in enumerate(SHOWN):
        values = [v for s in found.values() for v in (s.sa[i], 100.0 * s.psv[i])]
        table.add_row(f"{period:g}", *(f"{value:.3g}" for value in values))
    console.print(table)

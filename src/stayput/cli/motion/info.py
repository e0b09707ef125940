"""``stayput motion info``: how long and how strong a motion is."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.cli.options import Component, MotionText, TimeStep, Unit  # noqa: TC001 - Typer reads them

if TYPE_CHECKING:
    from stayput.motion import Motion, Peaks
    from stayput.motion.measures import Shaking, SpectralMeasures


def info(
    motion: MotionText,
    component: Component = None,
    unit: Unit = None,
    dt: TimeStep = None,
    json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
) -> None:
    """Say how long and how strong a motion is: its intensities, and its peaks by component."""
    from stayput.cli.flags import motion_of
    from stayput.motion.measures import Shaking, SpectralMeasures

    read = motion_of(motion, component=component, unit=unit, dt=dt)
    told = Shaking.of(read)
    rows = {name: (peaks, SpectralMeasures.of(read, name)) for name, peaks in read.peaks().items()}
    if json:
        import json as writer

        typer.echo(writer.dumps(_record(read, told, rows), allow_nan=False))
    else:
        _print_tables(read, told, rows)


def _number(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _record(motion: Motion, told: Shaking, rows: dict[str, tuple[Peaks, SpectralMeasures]]) -> dict[str, Any]:
    return {
        "name": motion.name,
        "source": motion.source,
        "synthetic": motion.synthetic,
        "dt_s": motion.dt,
        "samples": len(motion),
        "duration_s": motion.duration,
        "jma_intensity": _number(told.intensity),
        "jma_class": told.intensity_class,
        "long_period_sva_m_s": told.long_period_response,
        "long_period_class": told.long_period_class,
        "modified_mercalli": told.mercalli,
        "components": {
            name: {
                "pga_m_s2": peaks.pga,
                "pgv_m_s": peaks.pgv,
                "pgd_m": peaks.pgd,
                "arias_m_s": peaks.arias,
                "cav_m_s": peaks.cav,
                "significant_duration_s": peaks.significant_duration,
                "housner_intensity_m": spectral.housner_intensity,
                "spectrum_intensity_m_s": spectral.spectrum_intensity,
                "predominant_period_s": _number(spectral.predominant_period),
                "mean_period_s": _number(spectral.mean_period),
            }
            for name, (peaks, spectral) in rows.items()
        },
    }


def _print_tables(motion: Motion, told: Shaking, rows: dict[str, tuple[Peaks, SpectralMeasures]]) -> None:
    from rich.console import Console
    from rich.table import Table

    from stayput.report.summary import motion_label

    console = Console(highlight=False, markup=False)
    console.print(motion_label(motion), style="bold")
    console.print(motion.source)
    console.print(f"{len(motion)} samples every {motion.dt:g} s: {motion.duration:g} s")
    console.print(
        f"JMA intensity {told.published:.1f}, class {told.intensity_class}; "
        f"long-period class {told.long_period_class} (Sva {100.0 * told.long_period_response:.3g} cm/s); "
        f"modified Mercalli about {told.mercalli:.1f}"
    )
    names = {"x": "x (along)", "y": "y (across)", "z": "z (up)"}
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("")
    for name in rows:
        table.add_column(names[name], justify="right")
    lines = (
        ("PGA [m/s²]", [peaks.pga for peaks, _ in rows.values()]),
        ("PGV [cm/s]", [100.0 * peaks.pgv for peaks, _ in rows.values()]),
        ("PGD [cm]", [100.0 * peaks.pgd for peaks, _ in rows.values()]),
        ("Arias intensity [m/s]", [peaks.arias for peaks, _ in rows.values()]),
        ("CAV [m/s]", [peaks.cav for peaks, _ in rows.values()]),
        ("Duration D5-95 [s]", [peaks.significant_duration for peaks, _ in rows.values()]),
        ("Housner intensity [m]", [spectral.housner_intensity for _, spectral in rows.values()]),
        ("SI, 20 % [cm/s]", [100.0 * spectral.spectrum_intensity for _, spectral in rows.values()]),
        ("Period of largest Sa [s]", [spectral.predominant_period for _, spectral in rows.values()]),
        ("Mean period Tm [s]", [spectral.mean_period for _, spectral in rows.values()]),
    )
    for label, values in lines:
        table.add_row(label, *(f"{value:.3g}" for value in values))
    console.print(table)

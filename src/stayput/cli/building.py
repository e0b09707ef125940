"""``stayput building``: from the ground's motion to the floors'."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.cli.completion import structures, words
from stayput.cli.flags import ComponentOption, QuietOption, TimeStepOption, UnitOption, motion_of
from stayput.cli.messages import print_json, tell_written
from stayput.cli.shaking import XOption, YOption, ZOption, along
from stayput.cli.streams import check_output, is_stream, to_output, write_text

if TYPE_CHECKING:
    from stayput.building.model import FloorResponse


def building(
    storeys: Annotated[int, typer.Option(help="Number of storeys.")] = 10,
    structure: Annotated[
        str, typer.Option(help="RC, steel, wood or base-isolated.", autocompletion=words(structures))
    ] = "RC",
    period: Annotated[
        float | None,
        typer.Option(
            help="First natural period [s] (of base-isolated: on fixed ground). Default: by height."
        ),
    ] = None,
    damping: Annotated[float | None, typer.Option(help="Damping ratio. Default: by structure.")] = None,
    motion: Annotated[
        str | None,
        typer.Option(
            metavar="MOTION",
            help="A record's file, - (standard input), near-fault, or sine:A,F[,T]. Default: near-fault.",
        ),
    ] = None,
    x: XOption = None,
    y: YOption = None,
    z: ZOption = None,
    component: ComponentOption = None,
    unit: UnitOption = None,
    dt: TimeStepOption = None,
    storey: Annotated[
        list[int] | None,
        typer.Option(help="Storey to write with --out, and to draw the spectrum of; may be repeated."),
    ] = None,
    linear: Annotated[bool, typer.Option("--linear", help="Do not let the storeys yield.")] = False,
    out: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the floor motion of --storey: .csv; - prints it."),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Plot peaks over the storeys, and spectra: .png, .svg or .pdf."),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
    quiet: QuietOption = False,
) -> None:
    """Floor motions of a building: the peaks of every storey, and the motion of one."""
    from stayput.building import Building
    from stayput.errors import InputError
    from stayput.files import PLOT_SUFFIXES, check_apart, check_target

    check_output(out, (".csv",))
    if out is not None and (storey is None or len(storey) != 1):
        raise InputError("cli.out_needs_storey", "--out", out=repr(str(out)))
    instead = to_output({"--out": out}, json)
    if plot is not None:
        check_target(plot, PLOT_SUFFIXES)
    check_apart((out, plot), [Path(file) for file in (motion, x, y, z) if file is not None])
    described = Building(storeys, structure, period, damping, nonlinear=not linear)
    for number in storey or ():
        described.model.place(number)
    ground = along(motion, x) or "near-fault"
    response = described.respond(
        motion_of(ground, "--motion", y=y, z=z, component=component, unit=unit, dt=dt)
    )
    if json:
        print_json(_record(response))
    elif not instead:
        _print_table(response)
    if out is not None and storey:
        write_text(out, response.floor(storey[0]).text(".csv"))
    if plot is not None:
        from stayput.report.building import plot_building

        plot_building(response, plot, storey)
    if not json:
        tell_written([file for file in (out, plot) if not is_stream(file)], beside=instead)


def _record(response: FloorResponse) -> dict[str, Any]:
    import numpy as np

    model = response.model
    return {
        "building": model.name,
        "periods_s": model.periods.tolist(),
        "damping": np.atleast_1d(model.damping).tolist(),
        "nonlinear": model.yields,
        "motion": {"name": response.motion.name, "synthetic": response.motion.synthetic},
        "dt_s": response.dt,
        "storeys": response.storeys.tolist(),
        "components": {
            name: {
                "peak_floor_acceleration_m_s2": response.peak_acceleration(name).tolist(),
                "peak_floor_velocity_m_s": response.peak_velocity(name).tolist(),
                "peak_drift_m": response.peak_drift(name).tolist(),
            }
            for name in response.acceleration
        },
        "energy": {name: _energies(response, name) for name in response.energy},
    }


def _energies(response: FloorResponse, name: str) -> dict[str, float]:
    energy = response.energy[name]
    return {
        "input_j": float(energy.input[-1]),
        "damping_j": float(energy.damping[-1]),
        "plastic_j": float(energy.plastic[-1]),
        "imbalance": energy.imbalance,
    }


def _print_table(response: FloorResponse) -> None:
    from rich.console import Console
    from rich.table import Table

    from stayput.report.names import motion_label

    console = Console(highlight=False, markup=False)
    model = response.model
    kind = "before yielding" if model.yields else "linear"
    console.print(f"{model.name}, T1 = {model.periods[0]:.3g} s, {kind}", style="bold")
    console.print(f"Ground: {motion_label(response.motion)}")
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("Floor")
    for name in response.acceleration:
        for heading in (f"PFA {name} [m/s²]", f"PFV {name} [cm/s]"):
            table.add_column(heading, justify="right")
    ground = response.motion.peaks()
    rows = [("ground", [v for n in response.acceleration for v in (ground[n].pga, 100.0 * ground[n].pgv)])]
    columns = [
        values
        for name in response.acceleration
        for values in (response.peak_acceleration(name), 100.0 * response.peak_velocity(name))
    ]
    rows += [(model.place(s), [values[s - 1] for values in columns]) for s in response.storeys.tolist()]
    for label, values in reversed(rows):
        table.add_row(label, *(f"{value:.3g}" for value in values))
    console.print(table)
    for name, energy in response.energy.items():
        if not energy.input[-1] > 0.0:
            console.print(f"Energy, {name}: none.")
            continue
        yielding = 100.0 * energy.plastic[-1] / energy.input[-1]
        console.print(
            f"Energy, {name}: {yielding:.0f} % of the input went into yielding; "
            f"the balance closes to {energy.imbalance:.1e}."
        )

"""``stayput building``: from the ground's motion to the floors'."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import say
from stayput.cli.completion import structures, words
from stayput.cli.flags import FlagValues, QuietOption, motion_of, reads_records
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import folded, print_json, tell_written
from stayput.cli.shaking import (
    XOption,
    YOption,
    ZOption,
    along,
    scales_motions,
    stated_strength,
)
from stayput.cli.streams import check_output, to_output, write_text

if TYPE_CHECKING:
    from stayput.building.response import FloorResponse


@reads_records
@scales_motions
def building(
    storeys: Annotated[int, typer.Option(help="cli_help.storeys")] = 10,
    structure: Annotated[
        str, typer.Option(help="cli_help.structure", autocompletion=words(structures))
    ] = "RC",
    period: Annotated[
        float | None,
        typer.Option(help="cli_help.period"),
    ] = None,
    damping: Annotated[float | None, typer.Option(help="cli_help.damping")] = None,
    motion: Annotated[
        str | None,
        typer.Option(
            metavar="MOTION",
            help="cli_help.ground_motion",
        ),
    ] = None,
    x: XOption = None,
    y: YOption = None,
    z: ZOption = None,
    *,
    reading: FlagValues,
    strength: FlagValues,
    storey: Annotated[
        list[int] | None,
        typer.Option(help="cli_help.storey_out"),
    ] = None,
    linear: Annotated[bool, typer.Option("--linear", help="cli_help.linear")] = False,
    out: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="cli_help.floor_out"),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="cli_help.plot_building"),
    ] = None,
    lang: LanguageOption = OF_LOCALE,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput building``."""
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
    motion, named = along(motion, x)
    ground = motion or "near-fault"
    response = described.respond(
        motion_of(
            ground,
            named,
            y=y,
            z=z,
            reading=reading,
            **stated_strength(strength),
        )
    )
    if json:
        print_json(_record(response))
    elif not instead:
        _print_table(response, lang)
    if out is not None and storey:
        write_text(out, response.floor(storey[0]).text(".csv"))
    if plot is not None:
        from stayput.report.building import building_title, plot_building

        plot_building(response, plot, storey, title=building_title(response, lang), language=lang)
    if not json:
        tell_written(lang, out, plot, aside=instead)


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


def _print_table(response: FloorResponse, lang: str) -> None:
    from rich.console import Console
    from rich.table import Table

    from stayput.report.names import given_name, motion_label

    console = Console(highlight=False, markup=False)
    model = response.model
    kind = say("plots.yielding" if model.yields else "plots.linear", lang)
    name = given_name(model.name, lang)
    heading = say("cli.building", lang, name=name, period=model.periods[0], kind=kind)
    console.print(heading, style="bold")
    console.print(say("cli.building_ground", lang, motion=motion_label(response.motion, lang)))
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column(say("cli.building_floor", lang))
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
        table.add_row(given_name(label, lang), *(f"{value:.3g}" for value in values))
    console.print(table)
    for name, energy in response.energy.items():
        if not energy.input[-1] > 0.0:
            console.print(say("cli.building_no_energy", lang, component=name))
            continue
        share = 100.0 * energy.plastic[-1] / energy.input[-1]
        said = say("cli.building_energy", lang, component=name, share=share, imbalance=energy.imbalance)
        console.print(folded(said, console.width) if lang == "ja" else said)

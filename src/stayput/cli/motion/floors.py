"""The floors of a building under a motion of the ground: ``stayput motion info --building``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from stayput.catalogue import say
from stayput.cli.flags import table_of
from stayput.cli.messages import folded, print_json

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.building.response import FloorResponse


def respond(tables: Mapping[str, Any]) -> FloorResponse | None:
    """Return what the floors of a building do of which no storey is named; None where there is no such one.

    Parameters
    ----------
    tables : mapping
        Tables of a scenario, whose ``[shaking]`` may have a building.

    Raises
    ------
    InputError
        A value that is not allowed, or a record that cannot be read.
    """
    from stayput.scenario import Scenario

    shaking = table_of(tables, "shaking")
    if "building" not in shaking or "storey" in shaking:
        return None
    table = Scenario.parse({**tables, "shaking": {**shaking, "storey": 1}}).shaking
    assert table.building is not None
    ground = table.model_copy(update={"building": None, "storey": None})
    return table.building.building().respond(ground.motion(Path()))


def print_floors(response: FloorResponse, lang: str, *, json: bool) -> None:
    """Print the peaks of all floors, as a table or as one JSON object."""
    if json:
        print_json(_record(response))
    else:
        _print_table(response, lang)


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

"""The flags that say how the floor is shaken, of every command that takes a scenario file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import typer

from stayput.cli.flags import (
    building_table,
    earthquake_table,
    intensity_value,
    shaking_table,
    spectral_table,
    table_of,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

MotionOption: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--motion",
        metavar="FILE|near-fault|sine:A,F[,T]",
        help="A record's file, the built-in motion, or a sine of A [m/s²], F [Hz] and T [s]; "
        "in the place of the file's whole [shaking].",
    ),
]
ScaleOption: TypeAlias = Annotated[float | None, typer.Option("--scale", help="Factor on the motion.")]
IntensityOption: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--intensity", help="JMA intensity of the ground to scale to: a number, or a class such as 6-upper."
    ),
]
PgaOption: TypeAlias = Annotated[
    float | None, typer.Option("--pga", help="Peak ground acceleration to scale to [m/s²].")
]
PgvOption: TypeAlias = Annotated[
    float | None, typer.Option("--pgv", help="Peak ground velocity to scale to [m/s].")
]
SpectralOption: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--sa",
        metavar="T,VALUE",
        help="Spectral acceleration to scale to, at 5 % damping: period [s] and value [m/s²], such as 0.3,8.",
    ),
]
MercalliOption: TypeAlias = Annotated[
    float | None, typer.Option("--mmi", help="Modified Mercalli intensity to scale to.")
]
EarthquakeOption: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--earthquake",
        metavar="M,KM[,DEPTH[,VS30]][,KIND]",
        help="An earthquake to scale to: magnitude, distance and depth [km], ground [m/s], and where it "
        "breaks (crustal, interface, intraslab), such as 7,20 or 7,60,50,intraslab.",
    ),
]
BuildingOption: TypeAlias = Annotated[
    str | None,
    typer.Option("--building", metavar="STOREYS[,STRUCTURE]", help="The building around it, such as 10,RC."),
]
StoreyOption: TypeAlias = Annotated[
    int | None, typer.Option("--storey", help="The storey it stands on; 1 is the ground floor.")
]
VerticalOption: TypeAlias = Annotated[
    bool | None,
    typer.Option("--vertical/--no-vertical", help="Whether the vertical component acts."),
]


def stated_strength(
    *,
    intensity: str | None,
    pga: float | None,
    pgv: float | None,
    sa: str | None,
    mmi: float | None,
    earthquake: str | None,
) -> dict[str, Any]:
    """Return the keys of a shaking table that flags of strength stand for; None where one is not given.

    Raises
    ------
    InputError
        A flag's text that cannot be read.
    """
    return {
        "intensity": None if intensity is None else intensity_value(intensity),
        "pga": pga,
        "pgv": pgv,
        "sa": None if sa is None else spectral_table(sa),
        "mmi": mmi,
        "earthquake": None if earthquake is None else earthquake_table(earthquake),
    }


def shaken(
    tables: Mapping[str, Any],
    path: Path | None,
    *,
    motion: str | None,
    component: str | None,
    unit: str | None,
    dt: float | None,
    scale: float | None,
    intensity: str | None,
    pga: float | None,
    pgv: float | None,
    sa: str | None,
    mmi: float | None,
    earthquake: str | None,
    building: str | None,
    storey: int | None,
    vertical: bool | None,
) -> dict[str, Any]:
    """Return a scenario's tables with its shaking as the flags say, where they say anything.

    Parameters
    ----------
    tables : mapping
        The tables.
    path : Path, optional
        The scenario's file.
    motion, component, unit, dt, scale, intensity, pga, pgv, sa, mmi, earthquake, building, storey, vertical
        The flags; None where one is not given. ``motion`` replaces the whole table, a strength those of the
        file and its scale.

    Raises
    ------
    InputError
        A flag's text that cannot be read.
    """
    from stayput.scenario.shaking import STRENGTHS

    strength = stated_strength(intensity=intensity, pga=pga, pgv=pgv, sa=sa, mmi=mmi, earthquake=earthquake)
    flags = {
        "component": component,
        "unit": unit,
        "dt": dt,
        "scale": scale,
        **strength,
        "building": None if building is None else building_table(building),
        "storey": storey,
        "vertical": vertical,
    }
    stated = {key: value for key, value in flags.items() if value is not None}
    if motion is None and not stated:
        return dict(tables)
    given = table_of(tables, "shaking") if motion is None else _from_here(shaking_table(motion), path)
    if not stated.keys().isdisjoint(STRENGTHS):  # in the place of what the file says
        given = {key: value for key, value in given.items() if key not in (*STRENGTHS, "scale")}
    return {**tables, "shaking": {**given, **stated}}


def _from_here(shaking: dict[str, Any], path: Path | None) -> dict[str, Any]:
    """Return the table of a motion whose path begins in the working folder and not in the file's."""
    if path is None or "record" not in shaking or path.parent.resolve() == Path().resolve():
        return shaking
    return {"record": str(Path(shaking["record"]).absolute())}

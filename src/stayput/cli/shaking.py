"""The flags that say how the floor is shaken, of every command that takes a scenario file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import typer

from stayput.cli.completion import intensity_classes, words
from stayput.cli.flags import (
    as_written,
    beside,
    building_table,
    earthquake_table,
    intensity_value,
    one_of_two,
    shaking_table,
    spectral_table,
    table_of,
    together,
)
from stayput.cli.streams import record_of
from stayput.errors import InputError, InputWarning, warn

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.cli.flags import FlagValues
    from stayput.scenario import AssemblyScenario, Scenario

MotionOption: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--motion",
        metavar="FILE|-|near-fault|sine:A,F[,T]",
        help="cli_help.motion_option",
    ),
]
XOption: TypeAlias = Annotated[
    str | None,
    typer.Option("--x", metavar="FILE", help="cli_help.x"),
]
YOption: TypeAlias = Annotated[str | None, typer.Option("--y", metavar="FILE", help="cli_help.y")]
ZOption: TypeAlias = Annotated[str | None, typer.Option("--z", metavar="FILE", help="cli_help.z")]
ScaleOption: TypeAlias = Annotated[
    float | None,
    typer.Option("--scale", help="cli_help.scale"),
]
STRENGTH_FLAGS: dict[str, Any] = {
    "intensity": Annotated[
        str | None,
        typer.Option("--intensity", help="cli_help.intensity", autocompletion=words(intensity_classes)),
    ],
    "pga": Annotated[float | None, typer.Option("--pga", help="cli_help.pga")],
    "pgv": Annotated[float | None, typer.Option("--pgv", help="cli_help.pgv")],
    "sa": Annotated[str | None, typer.Option("--sa", metavar="T,VALUE", help="cli_help.sa")],
    "mmi": Annotated[float | None, typer.Option("--mmi", help="cli_help.mmi")],
    "earthquake": Annotated[
        str | None,
        typer.Option("--earthquake", metavar="M,KM[,DEPTH[,VS30]][,KIND]", help="cli_help.earthquake"),
    ],
}
"""The flags that say how strongly the ground shakes, by the keys of a shaking table that they set."""

scales_motions = together("strength", STRENGTH_FLAGS)

BuildingOption: TypeAlias = Annotated[
    str | None,
    typer.Option("--building", metavar="STOREYS[,STRUCTURE]", help="cli_help.building_option"),
]
StoreyOption: TypeAlias = Annotated[int | None, typer.Option("--storey", help="cli_help.storey")]
VerticalOption: TypeAlias = Annotated[
    bool | None,
    typer.Option("--vertical/--no-vertical", help="cli_help.vertical"),
]


def stated_strength(strength: FlagValues) -> FlagValues:
    """Return the keys of a shaking table that the texts and numbers of `STRENGTH_FLAGS` stand for.

    Raises
    ------
    InputError
        A flag's text that cannot be read.
    """
    tables = {"intensity": intensity_value, "sa": spectral_table, "earthquake": earthquake_table}
    return {key: tables[key](value) if key in tables else value for key, value in strength.items()}


def shaken(
    tables: Mapping[str, Any],
    path: Path | None,
    *,
    motion: str | None,
    x: str | None,
    y: str | None,
    z: str | None,
    reading: FlagValues,
    scale: float | None,
    strength: FlagValues,
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
    motion, x, y, z
        The flags of the motion; None where one is not given.
    reading, strength : FlagValues
        How its record is read, and how strong it is.
    scale, building, storey, vertical
        The other flags; likewise. ``motion`` and ``x`` replace the whole table; ``scale`` and each strength
        replace the scale and the strengths of the file.

    Raises
    ------
    InputError
        A flag's text that cannot be read, or two flags for one thing.
    """
    strength = stated_strength(strength)
    motion, named = along(motion, x)
    if z is not None and vertical is False:
        raise InputError("cli.no_vertical_file", "--z", value=repr(z))
    flags = {
        "scale": scale,
        "building": None if building is None else building_table(building),
        "storey": storey,
        "vertical": vertical,
    }
    own = {key: as_written(value) for key, value in flags.items() if value is not None}
    stated = reading | strength | own
    if motion is None and not stated and y is None and z is None:
        return dict(tables)
    given = table_of(tables, "shaking")
    if motion is not None:
        given = _from_here(shaking_table(record_of(motion, named)), path)
    files = beside(y, z, given)
    given = _without_strengths(given, stated)
    if vertical and isinstance(given.get("vertical"), str):  # the component of that file acts
        del stated["vertical"]
    return {**tables, "shaking": {**given, **stated, **_from_here(files, path)}}


def along(motion: str | None, x: str | None, flag: str = "--motion") -> tuple[str | None, str]:
    """Return the motion of a flag or argument, or of ``--x``, and which of the two gives it.

    Raises
    ------
    InputError
        Both are given.
    """
    if motion is not None and x is not None:
        raise one_of_two("--x", repr(x), flag, repr(motion))
    return (motion, flag) if x is None else (x, "--x")


def tell_of_y(y: str | None, scenario: Scenario | AssemblyScenario) -> None:
    """Warn of ``--y`` where nothing across the depth acts: in the plane of a piece that faces the shaking."""
    from stayput.scenario import Scenario

    if y is None or not isinstance(scenario, Scenario):
        return
    if scenario.dimensions == 2 and scenario.furniture.heading == 0.0:
        warn(InputWarning("cli.y_in_the_plane", "--y"))


def _without_strengths(given: dict[str, Any], stated: Mapping[str, Any]) -> dict[str, Any]:
    """Return a file's table without what it says of the strength of the shaking, where a flag says it.

    Raises
    ------
    InputError
        Two flags say it.
    """
    from stayput.scenario.shaking import SOURCES, STRENGTHS

    strengths = (*STRENGTHS, "scale")
    flags = [key for key in strengths if key in stated]
    if len(flags) > 1:
        first, second = (("--" + key, stated[key]) for key in flags[:2])
        raise one_of_two(first[0], repr(first[1]), second[0], repr(second[1]))
    if not flags:
        return given
    rest = {key: value for key, value in given.items() if key not in strengths}
    if given.keys().isdisjoint(SOURCES) and not given.keys().isdisjoint(STRENGTHS):
        rest["suite"] = {}  # which a strength without a motion stands for
    return rest


def _from_here(shaking: dict[str, Any], path: Path | None) -> dict[str, Any]:
    """Return a table of which the records' paths begin in the working folder and not in the file's."""
    from stayput.scenario.shaking import RECORD_FILES

    if path is None or path.parent.resolve() == Path().resolve():
        return shaking
    return {
        key: str(Path(value).absolute()) if key in RECORD_FILES else value for key, value in shaking.items()
    }

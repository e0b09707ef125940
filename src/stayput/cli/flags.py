"""Options that several commands share, and the way from their texts to the tables of a scenario."""

from __future__ import annotations

import inspect
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias, TypeVar, cast, get_args

import typer

from stayput.cli.streams import called, is_stream, record_of, table_of_input
from stayput.errors import InputError, unknown
from stayput.progress import keep_quiet

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence

    from stayput.measures import Measure
    from stayput.motion import Motion
    from stayput.motion.suites import TargetSpectrum
    from stayput.scenario import AssemblyScenario, Scenario

    Given = TypeVar("Given", bound=Scenario | AssemblyScenario)


def _quiet_if(wanted: bool) -> None:
    if wanted:
        keep_quiet(True)


MotionArgument: TypeAlias = Annotated[
    str | None,
    typer.Argument(
        metavar="MOTION",
        help="cli_help.motion_argument",
        show_default=False,
    ),
]
RECORD_FLAGS: dict[str, Any] = {
    "component": Annotated[str | None, typer.Option("--component", help="cli_help.component")],
    "unit": Annotated[str | None, typer.Option("--unit", help="cli_help.unit")],
    "dt": Annotated[float | None, typer.Option("--dt", help="cli_help.dt")],
    "columns": Annotated[
        str | None, typer.Option("--columns", metavar="t=COLUMN,x=COLUMN,…", help="cli_help.record_columns")
    ],
    "skip_lines": Annotated[int | None, typer.Option("--skip-lines", help="cli_help.skip_lines")],
    "decimal_comma": Annotated[bool, typer.Option("--decimal-comma", help="cli_help.decimal_comma")],
    "location": Annotated[str | None, typer.Option("--location", help="cli_help.location")],
    "remove_mean": Annotated[bool, typer.Option("--remove-mean", help="cli_help.remove_mean")],
}
"""The flags that say how a record is read, by the keys of a shaking table that they set."""

ThreadsOption: TypeAlias = Annotated[int | None, typer.Option("--threads", help="cli_help.threads")]
QuietOption: TypeAlias = Annotated[
    bool,
    typer.Option(
        "--quiet",
        "-q",
        callback=_quiet_if,
        expose_value=False,
        help="cli_help.quiet",
    ),
]
EveryRunOption: TypeAlias = Annotated[
    bool,
    typer.Option(
        "--every-run",
        help="cli_help.every_run",
    ),
]


FlagValues: TypeAlias = dict[str, Any]
"""What several flags say: keys of a shaking table, of those that are given."""


def together(keyword: str, flags: Mapping[str, Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Return what gives a command several flags in the place of one keyword, which has what they say.

    Parameters
    ----------
    keyword : str
        The keyword, of the type `FlagValues`.
    flags : mapping
        The flags, by the keys that they set.
    """

    def with_flags(command: Callable[..., None]) -> Callable[..., None]:
        signature = inspect.signature(command, eval_str=True)
        parameters: list[inspect.Parameter] = []
        for one in signature.parameters.values():
            each = [
                one.replace(name=name, annotation=kind, default=False if get_args(kind)[0] is bool else None)
                for name, kind in flags.items()
            ]
            parameters += each if one.name == keyword else [one]

        @wraps(command)
        def run(**given: Any) -> None:
            values = {name: given.pop(name) for name in flags}
            said = {name: value for name, value in values.items() if value is not None and value is not False}
            command(**given, **{keyword: {name: as_written(value) for name, value in said.items()}})

        cast("Any", run).__signature__ = signature.replace(parameters=parameters)
        return run

    return with_flags


reads_records = together("reading", RECORD_FLAGS)


_MOST_DIGITS = 1e15
"""Numbers from this on are written with a point."""

EXAMPLE: dict[str, Any] = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "back_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"builtin": "near-fault"},
}
"""The example that is simulated by default: a full bookcase with its back to a wall, under one motion."""


def body_table(text: str) -> dict[str, Any]:
    """Return the furniture table of ``WIDTHxHEIGHTxMASS``."""
    width, height, mass = _numbers("--body", text, text.replace("×", "x").split("x"), (3,), "0.4x1.8x100")
    return {"width": width, "height": height, "mass": mass}


def shaking_table(text: str) -> dict[str, Any]:
    """Return the shaking table of a file, ``near-fault``, or ``sine:AMPLITUDE,FREQUENCY[,DURATION]``."""
    if text == "near-fault":
        return {"builtin": text}
    if text.startswith("sine:"):
        values = _numbers("--motion", text, text.removeprefix("sine:").split(","), (2, 3), "sine:5,0.8")
        return {"sine": dict(zip(("amplitude", "frequency", "duration"), values, strict=False))}
    return {"record": text}


def building_table(text: str) -> dict[str, Any]:
    """Return the building table of ``STOREYS[,STRUCTURE]``."""
    storeys, _, structure = text.partition(",")
    table = {"storeys": _numbers("--building", text, [storeys], (1,), "10,RC")[0]}
    return {**table, "structure": structure.strip()} if structure else table


def earthquake_table(text: str) -> dict[str, Any]:
    """Return the earthquake table of ``MAGNITUDE,DISTANCE[,DEPTH[,VS30]][,KIND]``."""
    parts = [part.strip() for part in text.split(",")]
    kind = {"kind": parts.pop()} if parts[-1].isalpha() and not _is_number(parts[-1]) else {}
    values = _numbers("--earthquake", text, parts, (2, 3, 4), "7,20,10,300,crustal")
    return dict(zip(("magnitude", "distance", "depth", "vs30"), values, strict=False)) | kind


def spectral_table(text: str) -> dict[str, Any]:
    """Return the table of a spectral acceleration, ``PERIOD,VALUE``."""
    values = _numbers("--sa", text, text.split(","), (2,), "0.3,8")
    return dict(zip(("period", "value"), values, strict=True))


def friction_table(text: str) -> dict[str, Any]:
    """Return the floor table of ``STATIC[,KINETIC]``."""
    values = _numbers("--friction", text, text.split(","), (1, 2), "0.4,0.3")
    return {"static_friction": values[0], "kinetic_friction": values[-1]}


def overlaid(
    data: dict[str, Any],
    *,
    body: str | None,
    floor: str | None,
    friction: str | None,
    walls: dict[str, float | None],
    dimensions: int | None,
    piece: dict[str, float | None],
) -> dict[str, Any]:
    """Return a scenario's tables, overridden by the flags that say what stands where.

    Parameters
    ----------
    data : dict
        The tables of a scenario file, or `EXAMPLE`.
    body, floor, friction : str, optional
        The flags' texts; each replaces a whole table.
    walls : dict
        Gaps of the walls by their names [m]; None where the flag is not given.
    dimensions : int, optional
        2 or 3.
    piece : dict
        Single keys of the furniture's table; None where the flag is not given.

    Raises
    ------
    InputError
        A flag's text that cannot be read, or two flags for one thing.
    """
    if floor is not None and friction is not None:
        raise one_of_two("--floor", repr(floor), "--friction", repr(friction))
    tables = dict(data)
    if body is not None:
        tables["furniture"] = body_table(body)
    if floor is not None:
        tables["room"] = {**table_of(tables, "room"), "floor": floor}
    if friction is not None:
        tables["room"] = {**table_of(tables, "room"), "floor": friction_table(friction)}
    for name, gap in walls.items():
        if gap is not None:
            room = {**table_of(tables, "room"), name: {"gap": as_written(gap)}}
            if name == "left_wall":
                room.pop("back_wall", None)
            tables["room"] = room
    if own := {key: as_written(value) for key, value in piece.items() if value is not None}:
        tables["furniture"] = {**table_of(tables, "furniture"), **own}
    return tables if dimensions is None else tables | {"dimensions": dimensions}


def scenario_data(path: Path | None, body: str | None) -> dict[str, Any]:
    """Return the tables to begin with: the file's, or the built-in example's.

    A body of one's own does not stand before the example's wall.
    """
    if path is not None:
        from stayput.scenario.toml import read_toml

        return table_of_input("SCENARIO") if is_stream(path) else read_toml(path)
    return EXAMPLE if body is None else {"shaking": EXAMPLE["shaking"]}


def parsed(
    kind: type[Given],
    data: dict[str, Any],
    given: dict[str, Any],
    path: Path | None,
    motion: str | None,
) -> Given:
    """Return the scenario of a file under the flags.

    What the file by itself gets wrong is refused with its name, and what the flags do without.

    Parameters
    ----------
    kind : type
        `Scenario`, `AssemblyScenario` or `RoomScenario`.
    data : dict
        The tables, under the flags.
    given : dict
        The tables of the file by itself.
    path : Path, optional
        The file.
    motion : str, optional
        The flag, in whose place no refusal of a record names the file.

    Raises
    ------
    InputError
        A value that is not allowed.
    """
    folder, name = (Path(), "") if path is None else (path.parent, called(path))
    try:
        return cast("Given", kind.parse(data, folder, name if motion is None else ""))
    except InputError as error:
        if path is not None and _refused_alone(kind, given) == str(error):
            raise error.at(called(path)) from None
        raise


def _refused_alone(kind: type[Given], given: dict[str, Any]) -> str | None:
    """Return the sentence by which a file is refused without flags, or None where it is not."""
    try:
        kind.parse(given)
    except InputError as error:
        return str(error)
    return None


def inputs_of(tables: Mapping[str, Any], path: Path | None, flags: Iterable[str | None]) -> list[Path]:
    """Return the files that a scenario is read from: its own, and those of its motion.

    Parameters
    ----------
    tables : mapping
        The file's tables.
    path : Path, optional
        The file.
    flags : iterable of str or None
        The flags in the place of the file's motion.
    """
    from stayput.scenario.shaking import RECORD_FILES

    shaking = table_of(tables, "shaking")
    folder = Path() if path is None else path.parent
    records = [folder / value for key in RECORD_FILES if isinstance(value := shaking.get(key), str)]
    return [*([] if path is None else [path]), *records, *(Path(each) for each in flags if each is not None)]


def beside(y: str | None, z: str | None, shaking: Mapping[str, Any]) -> dict[str, str]:
    """Return the keys of a shaking table for ``--y`` and ``--z``: files beside that of its record.

    Raises
    ------
    InputError
        Both are standard input, or the table has no record.
    """
    files = {"across": (y, "--y"), "vertical": (z, "--z")}
    for file, flag in files.values():
        if file is not None and "record" not in shaking:
            raise InputError("cli.beside_no_record", flag, name=flag)
    return {key: record_of(file, flag) for key, (file, flag) in files.items() if file is not None}


def motion_of(
    text: str,
    flag: str,
    *,
    y: str | None,
    z: str | None,
    reading: FlagValues,
    **strength: Any,
) -> Motion:
    """Return the motion of a text as of ``--motion``, and of what is said of its record and its strength.

    Parameters
    ----------
    text : str
        The text; ``-`` stands for standard input.
    flag : str
        The flag or argument that it is of.
    y, z : str, optional
        The files of the components across and up.
    reading : FlagValues
        How its record is read.
    strength
        Keys of a shaking table that say how strong it is; None where one is not given.

    Raises
    ------
    InputError
        A text or a file that cannot be read.
    """
    from stayput.scenario import Scenario

    stated = {key: as_written(value) for key, value in strength.items() if value is not None}
    text = record_of(text, flag)
    table = shaking_table(text)
    scenario = Scenario.parse({**EXAMPLE, "shaking": {**table, **reading, **stated, **beside(y, z, table)}})
    return scenario.shaking.motion(Path())


def band_of(text: str) -> tuple[float, float]:
    """Return the two periods [s] of a ``--band`` text."""
    first, last = _numbers("--band", text, text.split(","), (2,), "0.1,5")
    return first, last


def target_of(text: str) -> TargetSpectrum:
    """Return the target spectrum of ``japan[:LEVEL[,SOIL]]``, ``asce7:SDS,SD1[,TL]`` or a table's file.

    Raises
    ------
    InputError
        A text or a file that cannot be read.
    """
    from stayput.motion.suites import asce7, japanese_design, read_target

    kind, _, rest = text.partition(":")
    if kind == "asce7":
        return asce7(*_numbers("--target", text, rest.split(","), (2, 3), "asce7:1.0,0.6,8"))
    if kind == "japan":
        level, _, soil = (rest or "very-rare,2").partition(",")
        number = _numbers("--target", text, [soil or "2"], (1,), "japan:very-rare,2")[0]
        return japanese_design(level.replace("-", " "), round(number))
    if not Path(text).exists():
        raise InputError("cli.target", "--target", value=repr(text))
    return read_target(text)


def chosen_measures(scenario: Scenario, names: Sequence[str]) -> tuple[Measure, ...]:
    """Return the measures of ``--measure`` texts: those the scenario has under a name, or types by default.

    Raises
    ------
    InputError
        A text that is neither.
    """
    from stayput.measures import MEASURES

    named = {measure_set.name: measure_set.measures for measure_set in scenario.measures}
    known = [*named, *(kind for kind in MEASURES if kind not in named)]
    measures: list[Measure] = []
    for name in names:
        if name not in known:
            raise unknown("--measure", name, known, "--measure")
        measures += named[name] if name in named else (MEASURES[name](),)
    return tuple(measures)


def one_of_two(flag: str, value: str, other: str, other_value: str) -> InputError:
    """Return the refusal of two flags that say the same thing."""
    return InputError("cli.one_of_two", flag, flag=flag, value=value, other=other, other_value=other_value)


def intensity_value(text: str) -> float | str:
    """Return an ``--intensity`` text as a number where it is one, else as the name of a class."""
    try:
        return as_written(float(text))
    except ValueError:
        return text


def as_written(value: Any) -> Any:
    """Return what a flag says as it is written in a refusal: a whole number without a point."""
    if isinstance(value, float) and value.is_integer() and abs(value) < _MOST_DIGITS:
        return int(value)
    return value


def table_of(tables: Mapping[str, Any], name: str) -> dict[str, Any]:
    """Return a table of a scenario's tables; empty where there is none."""
    table: Any = tables.get(name)
    return cast("dict[str, Any]", table) if isinstance(table, dict) else {}


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _numbers(flag: str, text: str, parts: list[str], counts: tuple[int, ...], example: str) -> list[float]:
    try:
        if len(parts) in counts:
            return [as_written(float(part)) for part in parts]
    except ValueError:
        pass
    raise InputError("cli.written_like", flag, flag=flag, value=repr(text), example=example)

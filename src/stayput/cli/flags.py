"""Flags that several commands share, and the way from them to the keys of a scenario that they set."""

from __future__ import annotations

import inspect
import os
import re
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from functools import wraps
from pathlib import Path
from pkgutil import resolve_name
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias, cast

import typer

from stayput.catalogue import phrase
from stayput.cli.messages import of_locale
from stayput.cli.streams import called, file_of, is_stream, table_of_input
from stayput.errors import InputError, not_allowed, unknown
from stayput.files import LARGEST_RECORD, check_apart
from stayput.progress import keep_quiet
from stayput.wording import check_language

if TYPE_CHECKING:
    from stayput.measures import Measure
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario


def words(listed: str) -> Callable[[str], list[str]]:
    """Return the completion of a flag that takes one of some words: what a shell offers when Tab is pressed.

    Parameters
    ----------
    listed : str
        Where the words are, "measures:MEASURES"; to load them must not load the mechanics.
    """

    def complete(incomplete: str) -> list[str]:
        fitting = [word for word in resolve_name(f"stayput.{listed}") if word.startswith(incomplete)]
        if "bash" in os.environ.get("_STAYPUT_COMPLETE", ""):  # the other shells quote by themselves
            return [re.sub(r"([^\w.-])", r"\\\1", word) for word in fitting]
        return fitting

    return complete


def _quiet_if(wanted: bool) -> None:
    if wanted:
        keep_quiet(True)


ThreadsOption: TypeAlias = Annotated[int | None, typer.Option("--threads", help="cli_help.threads")]
QuietOption: TypeAlias = Annotated[
    bool, typer.Option("--quiet", "-q", callback=_quiet_if, expose_value=False, help="cli_help.quiet")
]


def _chosen(ctx: typer.Context, value: str) -> str:
    """Return the language of the flag, else that of the flag before the command, else the locale's."""
    if value:
        return check_language(value)
    return (ctx.parent and ctx.parent.params.get("lang")) or of_locale()


LanguageOption: TypeAlias = Annotated[
    str,
    typer.Option(
        "--lang", metavar="en|ja", callback=_chosen, show_default="cli_help.of_locale", help="cli_help.lang"
    ),
]
"""What a command speaks: what ``--lang`` says, else ("") the language of the locale."""

SetOption: TypeAlias = Annotated[
    list[str] | None, typer.Option("--set", metavar="KEY=VALUE", help="cli_help.set")
]
MotionArgument: TypeAlias = Annotated[str, typer.Argument(metavar="MOTION", help="cli_help.motion_argument")]

GROUND: dict[str, Any] = {
    "intensity": Annotated[
        str | None,
        typer.Option(help="cli_help.intensity", autocompletion=words("catalogue.names:INTENSITIES")),
    ],
    "pga": Annotated[float | None, typer.Option(help="cli_help.pga")],
    "building": Annotated[str | None, typer.Option(metavar="STOREYS[,STRUCTURE]", help="cli_help.building")],
    "storey": Annotated[int | None, typer.Option(help="cli_help.storey")],
    "unit": Annotated[str | None, typer.Option(help="cli_help.unit")],
    "dt": Annotated[float | None, typer.Option(help="cli_help.dt")],
    "columns": Annotated[
        str | None, typer.Option(metavar="t=COLUMN,x=COLUMN,…|rows", help="cli_help.record_columns")
    ],
    "set": Annotated[
        list[str] | None, typer.Option(metavar="shaking.KEY=VALUE", help="cli_help.set_shaking")
    ],
}
"""Flags of commands on a motion, each of which sets a key of ``[shaking]``."""

SHAKING: dict[str, Any] = {
    "motion": Annotated[
        str | None, typer.Option(metavar="FILE|-|near-fault|sine:A,F[,T]", help="cli_help.motion_option")
    ],
    **GROUND,
    "set": SetOption,
}
"""Flags of commands on a scenario."""

SCENE: dict[str, Any] = {
    "body": Annotated[str | None, typer.Option(metavar="WxHxM", help="cli_help.body")],
    "floor": Annotated[
        str | None,
        typer.Option(
            metavar="SURFACE", help="cli_help.floor", autocompletion=words("catalogue.names:SURFACES")
        ),
    ],
}
"""Flags of `simulate` on what stands."""

FlagValues: TypeAlias = dict[str, Any]
"""What flags say, by their names; of those that are given."""


def takes(flags: Mapping[str, Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Return what gives a command flags in the place of its keyword ``said``, which has what they say.

    ``--quiet`` is the last of all its flags.
    """

    def with_flags(command: Callable[..., None]) -> Callable[..., None]:
        signature = inspect.signature(command, eval_str=True)
        parameters: list[inspect.Parameter] = []
        for param in signature.parameters.values():
            each = [param.replace(name=name, annotation=kind, default=None) for name, kind in flags.items()]
            parameters += each if param.name == "said" else [param]
        quiet = inspect.Parameter(
            "quiet", inspect.Parameter.KEYWORD_ONLY, default=False, annotation=QuietOption
        )

        @wraps(command)
        def run(quiet: object = None, **args: Any) -> None:
            values = {name: args.pop(name) for name in flags}
            command(**args, said={name: value for name, value in values.items() if value not in (None, [])})

        cast("Any", run).__signature__ = signature.replace(parameters=[*parameters, quiet])
        return run

    return with_flags


EXAMPLE: dict[str, Any] = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"builtin": "near-fault"},
}
"""The example that is simulated by default: a full bookcase with its back to a wall, under one motion."""


def body_table(text: str) -> dict[str, Any]:
    """Return the furniture table of ``WIDTHxHEIGHTxMASS``."""
    parts = text.replace("×", "x").split("x")
    values = numbers("--body", text, parts, (3,), "0.4x1.8x100")
    return dict(zip(("width", "height", "mass"), values, strict=True))


def building_table(text: str) -> dict[str, Any]:
    """Return the building table of ``STOREYS[,STRUCTURE]``."""
    storeys, _, structure = text.partition(",")
    (count,) = numbers("--building", text, [storeys], (1,), "10,RC")
    return {"storeys": count, **({"structure": structure.strip()} if structure else {})}


def value_of(text: str) -> Any:
    """Return a value as TOML writes it, or the text where it is none; a point may begin or end a number.

    Examples
    --------
    >>> value_of("4.5"), value_of(".5"), value_of("{ gap = 0.1 }"), value_of("6-upper")
    (4.5, 0.5, {'gap': 0.1}, '6-upper')
    """
    from stayput.scenario.toml import table_of_toml

    try:
        table = table_of_toml(f"value = {text}", Path())
    except InputError:
        return float(text) if re.fullmatch(r"[+-]?(\.\d+|\d+\.)", text, re.ASCII) else text
    return table["value"] if len(table) == 1 else text


_TABLES: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "body": ("furniture", body_table),
    "floor": ("room.floor", str),
    "intensity": ("shaking.intensity", value_of),
    "pga": ("shaking.pga", lambda value: _as_written(value)),
    "building": ("shaking.building", building_table),
    "storey": ("shaking.storey", int),
    "unit": ("shaking.unit", str),
    "dt": ("shaking.dt", float),
    "columns": ("shaking.columns", str),
}
"""Keys that flags set, and what makes their values of what is typed; ``--motion`` sets all of the table."""

_TEXTS = {f"shaking.{name}" for name in ("record", "across", "component", "unit", "columns", "location")}
"""Keys of texts that may look like numbers."""


def _settings(said: FlagValues, motion_flag: str) -> Iterator[tuple[str, str, Any]]:
    """Yield which flag sets which key to which value.

    Raises
    ------
    InputError
        A flag's text that cannot be read.
    """
    from stayput.scenario.toml import steps_of

    if (motion := said.get("motion")) is not None:
        yield motion_flag, "shaking", {}
        key, value = "record", motion
        if motion == "near-fault":
            key = "builtin"
        elif motion.startswith("sine:"):
            parts = motion.removeprefix("sine:").split(",")
            values = numbers(motion_flag, motion, parts, (2, 3), "sine:5,0.8")
            key = "sine"
            value = dict(zip(("amplitude", "frequency", "duration"), values, strict=False))
        yield motion_flag, f"shaking.{key}", value
    for name, (key, made) in _TABLES.items():
        if name in said:
            yield f"--{name}", key, made(said[name])
    for text in said.get("set", ()):
        key, equals, value = text.partition("=")
        if not equals or not steps_of(key.strip()):
            raise not_allowed(
                "--set", repr(text), phrase("cli.written_like", example="shaking.pga=4"), "--set"
            )
        key, value = key.strip(), value.strip()
        made = value_of(value)
        yield f"--set {key}", key, value if key in _TEXTS and not isinstance(made, str) else made


def changed(
    tables: Mapping[str, Any], said: FlagValues, path: Path | None = None, motion_flag: str = "--motion"
) -> dict[str, Any]:
    """Return a scenario's tables with the keys that flags set; what they say is not checked yet.

    A motion and a strength of the shaking stand in the place of those of the file. Files that are named begin
    in the working folder.

    Parameters
    ----------
    tables : mapping
        The tables.
    said : FlagValues
        The flags.
    path : Path, optional
        The scenario's file.
    motion_flag : str
        The flag or argument that the motion is given by.

    Raises
    ------
    InputError
        A flag's text that cannot be read, a key that two flags set, or a place of what is no list.
    """
    from stayput.scenario.toml import steps_of, with_value

    settings: dict[tuple[str | int, ...], tuple[str, str, Any]] = {}
    for flag, key, value in _settings(said, motion_flag):
        steps = steps_of(key)
        if steps in settings:
            raise InputError("scenario.only_one", key, name=flag, other=settings[steps][0])
        settings[steps] = flag, key, value
    data = dict(tables)
    keys = {str(steps[1]) for steps in settings if len(steps) > 1 and steps[0] == "shaking"}
    if keys:
        data["shaking"] = _without_rivals(table_of(data, "shaking"), keys)
    for steps in sorted(settings, key=len):
        flag, key, value = settings[steps]
        data = with_value(data, key, _from_here(key, value, flag, path))
    return data


def _without_rivals(shaking: dict[str, Any], keys: set[str]) -> dict[str, Any]:
    """Return a file's table without its motion and its strength, where a flag says another."""
    from stayput.scenario.shaking import SOURCES, STRENGTHS

    rest = shaking
    for rivals in (SOURCES, (*STRENGTHS, "scale")):
        if not keys.isdisjoint(rivals):
            rest = {key: value for key, value in rest.items() if key not in rivals or key in keys}
    if keys.isdisjoint(SOURCES) and shaking.keys().isdisjoint(SOURCES) and rest.keys() != shaking.keys():
        rest["suite"] = {}  # which a strength without a motion stands for
    return rest


def _from_here(key: str, value: Any, flag: str, path: Path | None) -> Any:
    """Return a value; a file that begins in the working folder where the scenario's is another."""
    from stayput.scenario.shaking import RECORD_FILES

    table, _, name = key.rpartition(".")
    of_shaking = table == "shaking" and name in (*RECORD_FILES, "suite")
    if not isinstance(value, str) or not (of_shaking or name == "mesh"):
        return value
    file = file_of(value, flag, most=LARGEST_RECORD)
    here = path is None or path.parent.resolve() == Path().resolve()
    return file if here else str(Path(file).absolute())


def opened(
    path: Path | None, said: FlagValues, outputs: Sequence[Path | None], *, of_one: Mapping[str, object]
) -> Scenario:
    """Return the scenario, assembly or room of a file, or of the built-in example, under the flags.

    A body of one's own does not stand before the example's wall. What the file by itself gets wrong is
    refused with its name, and what the flags do without.

    Parameters
    ----------
    path : Path, optional
        The file.
    said : FlagValues
        The flags.
    outputs : sequence of Path or None
        Files to write, none of which may be one that is read.
    of_one : mapping
        Flags that only a lone preset or box has a use for, and whether they are given.

    Raises
    ------
    InputError
        A value that is not allowed.
    """
    from stayput.scenario import Scenario
    from stayput.scenario.toml import read_toml

    tables = {"shaking": EXAMPLE["shaking"]} if "body" in said else EXAMPLE
    if path is not None:
        tables = table_of_input("SCENARIO") if is_stream(path) else read_toml(path)
    if "body" in said and isinstance(tables.get("furniture"), list):
        raise InputError("common.left_out", "--body", where=phrase("scenario.of_a_lone_piece"))
    data = changed(tables, said, path)
    read = [*motion_files(tables, path), *motion_files(data, path)]
    check_apart(outputs, read if path is None else [path, *read])
    same_motions = path is not None and motion_files(data) == motion_files(tables)
    try:
        scenario = Scenario.parse(
            data, Path() if path is None else path.parent, called(path) if path and same_motions else ""
        )
    except InputError as error:
        if path is not None:
            try:
                Scenario.parse(tables)
            except InputError as alone:
                if str(alone) == str(error):
                    raise error.at(called(path)) from None
        raise
    for flag, wanted in of_one.items():
        if wanted and not scenario.alone:
            raise InputError("common.left_out", flag, where=phrase("scenario.of_a_lone_piece"))
    return scenario


def motion_files(tables: Mapping[str, Any], path: Path | None = None) -> list[Path]:
    """Return the files of a scenario's motion."""
    from stayput.scenario.shaking import RECORD_FILES

    folder, shaking = Path() if path is None else path.parent, table_of(tables, "shaking")
    return [folder / value for key in RECORD_FILES if isinstance(value := shaking.get(key), str)]


def tables_of_motion(
    motion: str | None, said: FlagValues, *outputs: Path | None, suite: Any = None
) -> dict[str, Any]:
    """Return a scenario's tables with a motion that is an argument, or with a suite, under the flags.

    Raises
    ------
    InputError
        A flag's text that cannot be read, a key of another table, or a file to write that is read.
    """
    for flag, key, _ in _settings(said, "MOTION"):
        if not key.startswith("shaking."):
            raise InputError("common.left_out", key, name=flag, where=phrase("cli.of_a_motion"))
    flags = said if motion is None else {**said, "motion": motion}
    tables = changed({**EXAMPLE, "shaking": {"suite": suite}}, flags, motion_flag="MOTION")
    check_apart(outputs, motion_files(tables))
    return tables


def motion_of(tables: Mapping[str, Any]) -> Motion:
    """Return the motion of a scenario's tables, whose files begin in the working folder.

    Raises
    ------
    InputError
        A value that is not allowed, or a record that cannot be read.
    """
    from stayput.scenario import Scenario

    return Scenario.parse(tables).shaking.motion(Path())


def chosen_measures(scenario: Scenario, names: Sequence[str]) -> tuple[Measure, ...]:
    """Return the measures of ``--measure`` texts: those the scenario has under a name, or types by default.

    Raises
    ------
    InputError
        A text that is neither.
    """
    from stayput.measures import MEASURES

    named = {measure_set.name: measure_set.measures for measure_set in scenario.options}
    known = [*named, *(kind for kind in MEASURES if kind not in named)]
    measures: list[Measure] = []
    for name in names:
        if name not in known:
            raise unknown("--measure", name, known, "--measure")
        measures += named[name] if name in named else (MEASURES[name](),)
    return tuple(measures)


def table_of(tables: Mapping[str, Any], name: str) -> dict[str, Any]:
    """Return a table of a scenario's tables; empty where there is none."""
    table: Any = tables.get(name)
    return cast("dict[str, Any]", table) if isinstance(table, dict) else {}


_MOST_DIGITS = 1e15
"""Numbers from this on are written with a point."""


def _as_written(value: float) -> float:
    """Return a number as it is written in a refusal: a whole one without a point."""
    return int(value) if value.is_integer() and abs(value) < _MOST_DIGITS else value


def numbers(flag: str, text: str, parts: list[str], counts: Container[int], example: str) -> list[float]:
    """Return the numbers of a flag's text.

    Raises
    ------
    InputError
        Other texts, or more or fewer of them.
    """
    try:
        if len(parts) in counts:
            return [_as_written(float(part)) for part in parts]
    except ValueError:
        pass
    raise not_allowed(flag, repr(text), phrase("cli.written_like", example=example), flag)

"""Refusals that name what was typed: a flag, in the place of the key of a scenario file that it sets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from stayput.catalogue import phrase
from stayput.catalogue.names import PARTS_OF_FLAGS
from stayput.cli.help import HelpfulCommand
from stayput.cli.streams import called
from stayput.cli.usage import as_on_the_line
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from stayput.catalogue import Phrase

_RECORD = ("shaking", "shaking.record", "shaking.sine")
_SINE = tuple(f"shaking.sine.{part}" for part in ("amplitude", "frequency", "duration"))

SET_BY: dict[str, tuple[str, ...]] = {
    "body": ("furniture", "furniture.width", "furniture.height", "furniture.mass"),
    "length": ("furniture.length",),
    "heading": ("furniture.heading",),
    "floor": ("room.floor",),
    "friction": ("room.floor", "room.floor.static_friction", "room.floor.kinetic_friction"),
    "wall": ("room.left_wall", "room.left_wall.gap"),
    "right_wall": ("room.right_wall", "room.right_wall.gap"),
    "near_side_wall": ("room.near_side_wall", "room.near_side_wall.gap"),
    "far_side_wall": ("room.far_side_wall", "room.far_side_wall.gap"),
    "dimensions": ("dimensions",),
    "motion": (*_RECORD, *_SINE),
    "x": (*_RECORD, *_SINE),
    "y": ("shaking.across",),
    "z": ("shaking.vertical",),
    "component": ("shaking.component", "component"),
    "unit": ("shaking.unit",),
    "dt": ("shaking.dt",),
    "columns": ("shaking.columns", "columns"),
    "skip_lines": ("shaking.skip_lines", "skip_lines"),
    "decimal_comma": ("shaking.decimal_comma", "decimal_comma"),
    "location": ("shaking.location", "location"),
    "remove_mean": ("shaking.remove_mean", "remove_mean"),
    "scale": ("shaking.scale",),
    "intensity": ("shaking.intensity", "intensity"),
    "pga": ("shaking.pga",),
    "pgv": ("shaking.pgv",),
    "sa": ("shaking.sa", "shaking.sa.period", "shaking.sa.value"),
    "mmi": ("shaking.mmi",),
    "earthquake": (
        "shaking.earthquake",
        *(f"shaking.earthquake.{part}" for part in ("magnitude", "distance", "depth", "kind", "vs30")),
    ),
    "building": ("shaking.building", "shaking.building.storeys", "shaking.building.structure"),
    "storey": ("shaking.storey", "storey"),
    "storeys": ("storeys",),
    "structure": ("structure",),
    "period": ("period",),
    "damping": ("damping",),
}
"""Keys of a scenario file, and fields of what a command makes itself, by the parameter that sets them."""


_WITHOUT_KEYS = {"scenario.without_record": "cli.beside_no_record"}
"""Sentences that name a key which several flags set, and those that name these flags."""


class FlagCommand(HelpfulCommand):
    """A command that refuses what a flag says by the flag's name, and what its file says by the key's."""

    def invoke(self, ctx: Any) -> Any:
        """Run the command."""
        try:
            return cast("Any", super().invoke(ctx))
        except InputError as error:
            file = ctx.params.get("scenario")
            names = {param.name: as_on_the_line(param) for param in self.params if param.name in SET_BY}
            given = {
                name: flag
                for name, flag in names.items()
                if getattr(ctx.get_parameter_source(name), "name", "") == "COMMANDLINE"
            }
            raise as_typed(error, given, names, "" if file is None else called(file)) from None


def as_typed(
    error: InputError, given: Mapping[str, str], offered: Mapping[str, str], file: str = ""
) -> InputError:
    """Return a refusal with the flags that were typed in the place of the keys that they set.

    Where it is about none of them it stays as it is: a file's own keys keep their names.

    Parameters
    ----------
    error : InputError
        The refusal.
    given : mapping
        The flags that were typed, as they are written, by their parameters.
    offered : mapping
        All that the command has; likewise. What is missing beside a given one is named so, too.
    file : str
        The scenario's file as refusals name it, which did not say what a flag says.

    Examples
    --------
    >>> from stayput.errors import InputError
    >>> error = InputError("scenario.needs_both", name="shaking.storey", other="shaking.building")
    >>> flags = {"building": "--building", "storey": "--storey"}
    >>> as_typed(error, {"storey": "--storey"}, flags).told("en")
    '--storey is given without --building; it needs both.'
    """
    texts = [value for value in (error.field, *error.values.values()) if isinstance(value, str)]
    of_flag = error.field is not None and _within(error.field, given)
    of_file = error.context[:1] == ((file, file),)
    if not of_flag and (of_file or not any(_within(text, given) for text in texts)):
        return error
    named = _naming(given, offered)
    values = {key: named(value) if isinstance(value, str) else value for key, value in error.values.items()}
    passed_over = ((file, file), phrase("scenario.in_table", table="shaking")) if of_flag else ()
    context = tuple(_table_as_typed(place, given) for place in error.context if place not in passed_over)
    flag = None if error.field is None else named(error.field)
    code = _WITHOUT_KEYS.get(error.code, error.code)
    typed = InputError(code, flag[0] if isinstance(flag, tuple) else flag, context=context, **values)
    if not of_flag or flag is None or flag == error.field or typed.told("en") != error.told("en"):
        return typed
    if "name" in values:  # what a field is called, in words
        return InputError(code, typed.field, context=context, **values | {"name": flag})
    return typed.at(flag)


def _naming(given: Mapping[str, str], offered: Mapping[str, str]) -> Callable[[str], str | Phrase]:
    """Return what a key is called: by the flag that set it, else by one that may, else as it is."""

    def named(key: str) -> str | Phrase:
        flag = next((flag for flags in (given, offered) for flag in _setting(key, flags)), None)
        if flag is None:
            return key
        part = PARTS_OF_FLAGS.get(key)
        return flag if part is None else phrase("cli.part_of_flag", flag=flag, part=part)

    return named


def _setting(key: str, flags: Mapping[str, str]) -> Iterable[str]:
    return (flag for name, flag in flags.items() if key in SET_BY[name])


def _within(key: str, flags: Mapping[str, str]) -> bool:
    """Return whether a flag set a key, or the whole table that it is of."""
    return any(key == own or key.startswith(f"{own}.") for name in flags for own in SET_BY[name])


def _table_as_typed(place: Phrase, given: Mapping[str, str]) -> Phrase:
    """Return where a refusal was met: the flag that made a table, in the place of that table."""
    for name, flag in given.items():
        if any(place == phrase("scenario.in_table", table=table) for table in SET_BY[name]):
            return flag, flag
    return place

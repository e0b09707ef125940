"""Kinds of field that the tables of a scenario have; ranges and units go into the JSON Schema.

What a field of a table has in common with the field of the value that the table makes stands with the latter:
`stayput.model.parameters`. `of` reads it.
"""

from __future__ import annotations

from dataclasses import MISSING
from typing import TYPE_CHECKING, Annotated, Any, TypeVar, cast

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

from stayput.catalogue import phrase
from stayput.errors import InputError, has_control
from stayput.model.body import Body
from stayput.model.parameters import parameter_of
from stayput.vocabulary import meant

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterator

Made = TypeVar("Made")

NAME, TABLE, NUMBER = "<name>", "<table>", "<number>"
"""Tags of a value that is a name, a table or a number; not part of a key's dotted name."""


class Table(BaseModel):
    """A table of the scenario: unknown keys, other types, NaN and infinity are refused."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    def __repr_args__(self) -> Iterator[tuple[str | None, Any]]:
        """Yield what was said, and nothing that was left to its default."""
        return (pair for pair in super().__repr_args__() if pair[0] in self.model_fields_set)


def between(low: float, high: float, unit: str = "", **about: Any) -> Any:
    """Return a number's bounds, and what else pydantic's ``Field`` takes."""

    def with_unit(schema: dict[str, Any]) -> None:
        for kind in cast("list[dict[str, Any]]", schema.get("anyOf", [schema])):
            if "minimum" in kind:
                kind["unit"] = unit

    return Field(ge=low, le=high, json_schema_extra=with_unit if unit else None, **about)


def each(of: Any, name: str) -> Any:
    """Return the bounds of an item of a list."""
    about = parameter_of(of, name)
    return between(about.low, about.high, about.unit)


def of(kind: Any, name: str, *, listed: bool = False, **changed: Any) -> Any:
    """Return the field of a table with the default, unit, range and meaning of the one that it is for.

    Parameters
    ----------
    kind : type or function
        The dataclass or the function that the table makes its value with.
    name : str
        The field or the argument.
    listed : bool
        Whether it is a list, whose items have their bounds by `each`.
    **changed
        What is otherwise in the table: default, description.
    """
    about = parameter_of(kind, name)
    own: dict[str, Any] = {
        "default": ... if about.default is MISSING else about.default,
        "description": about.meaning,
    }
    own |= changed
    return Field(**own) if listed else between(about.low, about.high, about.unit, **own)


def one_of(names: Collection[str], kind: str | None = None) -> Any:
    """Return the check of a name out of several; the sentence for a wrong one comes from the schema.

    With a kind of `stayput.vocabulary.WORDS` what people call one of them is taken for its name.
    """

    def check(value: str) -> str:
        name = value if kind is None else meant(kind, value)
        if name not in names:
            raise ValueError
        return name

    return AfterValidator(check)


def named(names: Collection[str]) -> Any:
    """Return what the JSON Schema says of such a name."""
    return Field(json_schema_extra={"enum": list(names)})


def _without_control(text: str) -> str:
    if has_control(text):
        raise ValueError
    return text


Text = Annotated[str, Field(min_length=1, max_length=200), AfterValidator(_without_control)]
Pair = Annotated[list[Annotated[float, each(Body, "cg_offset")]], Field(min_length=2, max_length=2)]


def kind_of(value: object) -> str:
    """Tell a table from a name."""
    return TABLE if isinstance(value, dict | BaseModel) else NAME


def name_or_number(value: object) -> str:
    """Tell a name from a number."""
    return NAME if isinstance(value, str) else NUMBER


def checked(table: str, make: Callable[[], Made]) -> Made:
    """Return what a table describes; what contradicts itself is refused with the table's name.

    Raises
    ------
    InputError
        With the table's name; pydantic carries it on.
    """
    try:
        return make()
    except InputError as error:
        raise error.at(phrase("scenario.in_table", table=table), table) from None

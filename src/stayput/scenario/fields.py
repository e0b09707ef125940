"""Kinds of field that the tables of a scenario have; ranges and units go into the JSON Schema."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.model.body import MASS_RANGE, SIZE_RANGE
from stayput.model.room import FRICTION_RANGE

if TYPE_CHECKING:
    from collections.abc import Callable, Collection

NAME, TABLE = "<name>", "<table>"
"""Tags of a value that is a name or a table; not part of a key's dotted name."""


class Table(BaseModel):
    """A table of the scenario: unknown keys, other types, NaN and infinity are refused."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


def between(low: float, high: float, unit: str = "") -> Any:
    """Return a number's bounds."""
    return Field(ge=low, le=high, json_schema_extra={"unit": unit} if unit else None)


def one_of(names: Collection[str]) -> Any:
    """Return the check of a name out of several; the sentence for a wrong one comes from the schema."""

    def check(value: str) -> str:
        if value not in names:
            raise ValueError
        return value

    return AfterValidator(check)


def named(names: Collection[str]) -> Any:
    """Return what the JSON Schema says of such a name."""
    return Field(json_schema_extra={"enum": list(names)})


Text = Annotated[str, Field(min_length=1, max_length=200)]
Size = Annotated[float, between(*SIZE_RANGE, "m")]
Mass = Annotated[float, between(*MASS_RANGE, "kg")]
Load = Annotated[float, between(0.0, MASS_RANGE[1], "kg")]
Offset = Annotated[float, between(-SIZE_RANGE[1], SIZE_RANGE[1], "m")]
Pair = Annotated[list[Offset], Field(min_length=2, max_length=2)]
Friction = Annotated[float, between(*FRICTION_RANGE)]
Restitution = Annotated[float, between(0.0, 1.0)]
Distance = Annotated[float, between(0.0, 1e4, "m")]


def kind_of(value: object) -> str:
    """Tell a table from a name."""
    return TABLE if isinstance(value, dict | BaseModel) else NAME


def checked(table: str, make: Callable[[], object]) -> None:
    """Make what a table describes, so that what contradicts itself is refused with the table's name.

    Raises
    ------
    InputError
        With the table's name; pydantic carries it on.
    """
    try:
        make()
    except InputError as error:
        raise error.at(phrase("scenario.in_table", table=table), table) from None

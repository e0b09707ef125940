"""Kinds of field that the tables of a scenario have; ranges and units go into the JSON Schema.

What a field of a table has in common with the field of the value that the table makes stands with the latter:
`stayput.model.parameters`. `fields_of` and `of` read it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import MISSING, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar, cast

from pydantic import AfterValidator, BaseModel, ConfigDict, Discriminator, Field, Tag, create_model

from stayput.catalogue import phrase
from stayput.errors import InputError, has_control
from stayput.model.parameters import Parameter, parameter_of, parameters
from stayput.vocabulary import meant

Made = TypeVar("Made")

NAME, TABLE, NUMBER = "<name>", "<table>", "<number>"
"""Tags of a value that is a name, a table or a number; not part of a key's dotted name."""


class Table(BaseModel):
    """A table of the scenario: unknown keys, other types, NaN and infinity are refused."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    def says(self, name: str) -> bool:
        """Return whether a field was said, and is not what it is by default."""
        default = type(self).model_fields[name].get_default(call_default_factory=True)
        return name in self.model_fields_set and getattr(self, name) != default

    def refuse_single(self, table: str, *pair: str) -> None:
        """Refuse one of two keys without the other."""
        for key, other in (pair, pair[::-1]):
            if getattr(self, key) is not None and getattr(self, other) is None:
                raise InputError("scenario.needs_both", f"{table}.{key}", other=f"{table}.{other}")

    def refuse_several(self, table: str, names: Iterable[str]) -> None:
        """Refuse the second of some keys, of which only one may be given."""
        stated = [f"{table}.{name}" for name in names if getattr(self, name) is not None]
        if len(stated) > 1:
            raise InputError("scenario.only_one", stated[1], other=stated[0])

    def __repr_args__(self) -> Iterator[tuple[str | None, Any]]:
        """Yield what was said, and nothing that was left to its default."""
        return (pair for pair in super().__repr_args__() if pair[0] in self.model_fields_set)


class ValueTable(Table):
    """A table with the fields of the value that it makes: see `fields_of`."""

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any: ...


AnyTable = TypeVar("AnyTable", bound=Table)


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


def of(kind: Any, name: str, **changed: Any) -> Any:
    """Return the field of a table with the default, unit, range and meaning of the one that it is for.

    Parameters
    ----------
    kind : type or function
        The dataclass or the function that the table makes its value with.
    name : str
        The field or the argument.
    **changed
        What is otherwise in the table: default, description.
    """
    return _field(parameter_of(kind, name), **changed)


def fields_of(
    kind: Any,
    *,
    but: Collection[str] = (),
    optional: Collection[str] = (),
    defaults: Mapping[str, float] = MappingProxyType({}),
    **meanings: str,
) -> Callable[[type[AnyTable]], type[AnyTable]]:
    """Return a decorator that gives a table, after its own fields, those of the value that it makes.

    Parameters
    ----------
    kind : type or function
        The dataclass or the function that the table makes its value with.
    but : collection of str
        Fields and arguments that a file does not say.
    optional : collection of str
        Those that a file may leave out: the table knows what they are then.
    defaults : mapping of str to float
        Those of the file alone.
    **meanings
        What a file says of a field in other words.
    """

    def with_fields(table: type[AnyTable]) -> type[AnyTable]:
        fields: dict[str, Any] = {}
        for about in parameters(kind):
            name = about.name
            if name not in (*but, *table.model_fields):
                here = replace(about, default=defaults.get(name, about.default))
                fields[name] = typed_field(here, meanings.get(name), optional=name in optional)
        return create_model(
            table.__name__, __base__=table, __doc__=table.__doc__, __module__=table.__module__, **fields
        )

    return with_fields


def typed_field(about: Parameter, meaning: str | None = None, *, optional: bool = False) -> tuple[Any, Any]:
    """Return the type and the field of a table for a field of a value: of a number, a word or a pair."""
    pair = isinstance(about.default, tuple)
    default = None if optional or pair else ... if about.default is MISSING else about.default
    changed: dict[str, Any] = {"default": default, "description": meaning or about.meaning}
    kind: Any = int if about.whole else float
    field = _field(about, **changed)
    if about.choices:
        kind, field = Literal[about.choices], Field(**changed)
    elif about.words:
        word: Any = Annotated[Literal[about.words], Tag(NAME)]
        number = Annotated[float, between(about.low, about.high, about.unit), Tag(NUMBER)]
        kind, field = Annotated[word | number, Discriminator(name_or_number)], Field(**changed)
    elif pair:
        number = Annotated[float, between(about.low, about.high, about.unit)]
        kind, field = Annotated[list[number], Field(min_length=2, max_length=2)], Field(**changed)
    return (kind | None if default is None else kind), field


def _field(about: Parameter, **changed: Any) -> Any:
    default = ... if about.default is MISSING else about.default
    options: dict[str, Any] = {"default": default, "description": about.meaning} | changed
    return between(about.low, about.high, about.unit, **options)


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


def _seen(text: str) -> str:
    if has_control(text) or not text.strip():
        raise ValueError
    return text


Text = Annotated[str, Field(min_length=1, max_length=200), AfterValidator(_seen)]


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
        With the table's name and the key in it; pydantic carries it on.
    """
    try:
        return make()
    except InputError as error:
        field = f"{table}.{error.field}" if error.field else table
        raise error.at(phrase("scenario.in_table", table=table), field) from None

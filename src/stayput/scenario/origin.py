"""How a scenario is read from a file and written to one."""

from __future__ import annotations

from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import tomli_w
from pydantic import Field, PrivateAttr, ValidationError
from pydantic.json_schema import DEFAULT_REF_TEMPLATE

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.scenario.fields import Table, Text
from stayput.scenario.messages import refusal_of

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping


class FromFile(Table):
    """A scenario that may come from a file."""

    title: Text | None = Field(default=None, description="What the scenario is about.")

    _folder: Path = PrivateAttr(default=Path())
    _file: str = PrivateAttr(default="")

    @classmethod
    def parse(cls, data: Mapping[str, Any], folder: Path = Path(), file: str = "") -> Self:
        """Make a scenario from the keys and values of its file.

        Parameters
        ----------
        data : mapping
            As a TOML reader returns it.
        folder : Path
            Where the relative path of a record begins.
        file : str
            The file's name, for what is refused later: a record that cannot be read.

        Raises
        ------
        InputError
            The first thing that is wrong: the key's dotted name, its value, and what is allowed.
        """
        try:
            scenario = cls.model_validate(dict(data))
        except ValidationError as error:
            raise refusal_of(error.errors(), _schema(cls)) from None
        scenario._folder, scenario._file = folder, file
        return scenario

    @classmethod
    def schema(cls, by_alias: bool = True, ref_template: str = DEFAULT_REF_TEMPLATE) -> dict[str, Any]:
        """Return the JSON Schema of a scenario file, for editors and other programs."""
        return cls.model_json_schema(by_alias=by_alias, ref_template=ref_template)

    def stated_keys(self) -> dict[str, Any]:
        """Return the keys and values of its file: what was said, and nothing that was left to its default."""
        return self.model_dump(mode="json", exclude_unset=True, exclude_none=True, by_alias=True)

    def to_toml(self) -> str:
        """Return the scenario as a file's text: what was said, and nothing that was left to its default.

        `Scenario.parse` reads it back as the same scenario.

        Examples
        --------
        >>> from stayput import Scenario
        >>> print(Scenario.parse({"furniture": {"preset": "chest"}}).to_toml(), end="")
        [furniture]
        preset = "chest"
        """
        return tomli_w.dumps(self.stated_keys())

    @property
    def folder(self) -> Path:
        """Where the relative path of a record or a mesh begins."""
        return self._folder

    @contextmanager
    def naming_file(self, table: str = "") -> Generator[None]:
        """Refuse what is wrong with the file's name, once, and with that of a table of the file."""
        try:
            yield
        except InputError as error:
            if not self._file or error.context[:1] == ((self._file, self._file),):
                raise
            in_table = error.at(phrase("scenario.in_table", table=table)) if table else error
            raise in_table.at(self._file) from None


@cache
def _schema(kind: type[FromFile]) -> dict[str, Any]:
    """Return the JSON Schema that sentences about errors are made from; it takes its time."""
    return kind.schema()

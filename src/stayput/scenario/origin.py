"""Where a scenario comes from: the folder where its relative paths begin, and the file that refusals name."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from pydantic import PrivateAttr

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.scenario.fields import Table

if TYPE_CHECKING:
    from collections.abc import Generator


class FromFile(Table):
    """A scenario that may come from a file."""

    _folder: Path = PrivateAttr(default=Path())
    _file: str = PrivateAttr(default="")

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

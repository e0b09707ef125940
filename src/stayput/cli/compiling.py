"""What a command says where the first run on a machine compiles."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from collections.abc import Generator


@contextmanager
def compiling() -> Generator[None]:
    """Say on standard error that the mechanics are compiled, where they are."""
    from stayput.compiled import on_compilation

    def tell() -> None:
        typer.echo("Compiling the mechanics once, which takes up to a minute ...", err=True)

    with on_compilation(tell):
        yield

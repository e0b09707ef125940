"""How every command ends when it cannot go on: one sentence on standard error and an exit code."""

from __future__ import annotations

from typing import Any

import typer
from typer.core import TyperGroup

from stayput.errors import InputError

REFUSED = 2
"""Exit code for input that is refused."""

INTERRUPTED = 130
"""Exit code after Ctrl-C."""


class Plainly(TyperGroup):
    """A group of commands that says in one sentence what is wrong with the input."""

    def invoke(self, ctx: Any) -> Any:
        """Run the command; refused input ends it with `REFUSED`, Ctrl-C with `INTERRUPTED`."""
        try:
            return super().invoke(ctx)
        except InputError as error:
            typer.echo(str(error), err=True)
            raise typer.Exit(REFUSED) from None
        except KeyboardInterrupt:
            typer.echo("Interrupted.", err=True)
            raise typer.Exit(INTERRUPTED) from None

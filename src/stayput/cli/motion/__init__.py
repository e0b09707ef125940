"""``stayput motion``: analyse, convert or generate motions of the floor."""

from __future__ import annotations

import typer

from stayput.cli.help import HelpfulCommand, HelpfulGroup
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.motion import record, suite

app = typer.Typer(cls=HelpfulGroup, help="cli_help.motion", no_args_is_help=True, rich_markup_mode=None)
for name, run in (
    ("info", record.info),
    ("plot", record.plot),
    ("spectrum", record.spectrum),
    ("convert", record.convert),
    ("suite", suite.suite),
):
    app.command(name, cls=HelpfulCommand, help=f"cli_help.{name}")(run)


@app.callback()
def _options(lang: LanguageOption = OF_LOCALE) -> None:  # pyright: ignore[reportUnusedFunction] - Typer calls it
    """Take the flags that stand before a command."""

"""``stayput motion``: analyse, convert or generate motions of the floor."""

from __future__ import annotations

import typer

from stayput.cli.as_typed import FlagCommand
from stayput.cli.motion import record, suite

app = typer.Typer(
    help="Look at a motion of the floor, or make one.", no_args_is_help=True, rich_markup_mode=None
)
app.command("info", cls=FlagCommand)(record.info)
app.command("plot", cls=FlagCommand)(record.plot)
app.command("spectrum", cls=FlagCommand)(record.spectrum)
app.command("convert", cls=FlagCommand)(record.convert)
app.command("suite")(suite.suite)

"""``stayput motion``: analyse, convert or generate motions of the floor."""

from __future__ import annotations

import typer

from stayput.cli.motion import record, suite

app = typer.Typer(
    help="Look at a motion of the floor, or make one.", no_args_is_help=True, rich_markup_mode=None
)
app.command("info")(record.info)
app.command("plot")(record.plot)
app.command("spectrum")(record.spectrum)
app.command("convert")(record.convert)
app.command("suite")(suite.suite)

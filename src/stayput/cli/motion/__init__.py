"""``stayput motion``: what a motion of the floor says, and what can be made of it."""

from __future__ import annotations

import typer

from stayput.cli.motion import convert, info, plot, spectrum, suite

app = typer.Typer(
    help="Look at a motion of the floor, or make one.", no_args_is_help=True, rich_markup_mode=None
)
app.command("info")(info.info)
app.command("plot")(plot.plot)
app.command("spectrum")(spectrum.spectrum)
app.command("convert")(convert.convert)
app.command("suite")(suite.suite)

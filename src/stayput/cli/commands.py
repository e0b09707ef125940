"""The commands and the flags of the program."""

from __future__ import annotations

from typing import Annotated

import typer

import stayput
from stayput.cli import assess, building, fragility, motion, simulate, verify
from stayput.cli.app import app as page
from stayput.cli.as_typed import FlagCommand
from stayput.cli.flags import QuietOption  # noqa: TC001 - Typer reads the annotations
from stayput.cli.help import HelpfulCommand, RootGroup
from stayput.cli.language import OF_LOCALE, LanguageOption

app = typer.Typer(
    cls=RootGroup,
    help="cli_help.stayput",
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
for name, run, kind in (
    ("simulate", simulate.simulate, FlagCommand),
    ("verify", verify.verify, FlagCommand),
    ("fragility", fragility.fragility, HelpfulCommand),
    ("building", building.building, FlagCommand),
    ("assess", assess.assess, HelpfulCommand),
    ("app", page, HelpfulCommand),
):
    app.command(name, cls=kind, help=f"cli_help.{name}")(run)
app.add_typer(motion.app, name="motion")


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"stayput {stayput.__version__}")
        raise typer.Exit


@app.callback()
def _options(  # pyright: ignore[reportUnusedFunction] - Typer calls it
    version: Annotated[
        bool,
        typer.Option("--version", "-V", callback=_print_version, is_eager=True, help="cli_help.version"),
    ] = False,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Take the flags that stand before a command."""

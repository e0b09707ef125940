"""The command line: heavy modules are loaded only when a command runs."""

from __future__ import annotations

from typing import Annotated

import typer

import stayput
from stayput.cli import app as page
from stayput.cli import assess, building, fragility, motion, simulate, study, verify
from stayput.cli.as_typed import FlagCommand
from stayput.cli.flags import QuietOption  # noqa: TC001 - Typer reads the annotations
from stayput.cli.messages import CommandGroup

app = typer.Typer(
    cls=CommandGroup,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
app.command("simulate", cls=FlagCommand)(simulate.simulate)
app.command("verify", cls=FlagCommand)(verify.verify)
app.command("fragility")(fragility.fragility)
app.command("study", cls=FlagCommand)(study.study)
app.command("building", cls=FlagCommand)(building.building)
app.add_typer(motion.app, name="motion")
app.command("assess")(assess.assess)
app.command("app")(page.app)


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"stayput {stayput.__version__}")
        raise typer.Exit


@app.callback()
def _options(  # pyright: ignore[reportUnusedFunction] - Typer calls it
    version: Annotated[
        bool,
        typer.Option("--version", "-V", callback=_print_version, is_eager=True, help="Print the version."),
    ] = False,
    quiet: QuietOption = False,
) -> None:
    """Verify earthquake-proof measures for furniture."""


def main() -> None:
    """Run the command line: the entry point of ``stayput``."""
    app(prog_name="stayput")

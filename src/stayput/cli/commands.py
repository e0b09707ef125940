"""The commands and the flags of the program."""

from __future__ import annotations

from typing import Annotated

import typer

import stayput
from stayput.cli import assess, motion, scenarios
from stayput.cli.flags import LanguageOption, QuietOption  # noqa: TC001 - Typer reads the annotations
from stayput.cli.help import HelpfulCommand, RootGroup
from stayput.errors import absent


def _page(
    host: Annotated[str, typer.Option(help="cli_help.host")] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="cli_help.port")] = 8000,
    name: Annotated[list[str] | None, typer.Option(metavar="NAME", help="cli_help.server_name")] = None,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="cli_help.browser")] = True,
    lang: LanguageOption = "",
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput app``."""
    try:
        from stayput.app.server import serve
    except ModuleNotFoundError as error:
        if error.name is not None and error.name.startswith("stayput"):
            raise
        raise absent("The app", error.name or "a library", "app") from None
    serve(host, port, names=name or (), browser=browser, language=lang)


app = typer.Typer(
    cls=RootGroup,
    help="cli_help.stayput",
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
for name, run in (
    ("simulate", scenarios.simulate),
    ("verify", scenarios.verify),
    ("assess", assess.assess),
    ("app", _page),
):
    app.command(name, cls=HelpfulCommand, help=f"cli_help.{name}")(run)
app.add_typer(motion.app, name="motion")


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"stayput {stayput.__version__}")
        raise typer.Exit


@app.callback()
def _options(  # pyright: ignore[reportUnusedFunction] - Typer calls it
    version: Annotated[
        bool, typer.Option("--version", "-V", callback=_print_version, is_eager=True, help="cli_help.version")
    ] = False,
    lang: LanguageOption = "",
    quiet: QuietOption = False,
) -> None:
    """Take the flags that stand before a command."""

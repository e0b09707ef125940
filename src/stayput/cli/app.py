"""``stayput app``: the page and its API, on this machine."""

from __future__ import annotations

from typing import Annotated

import typer

from stayput.cli.flags import QuietOption  # noqa: TC001 - Typer reads the annotations
from stayput.cli.language import OF_LOCALE, LanguageOption

PORT = 8000


def app(
    host: Annotated[str, typer.Option(help="cli_help.host")] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="cli_help.port")] = PORT,
    name: Annotated[list[str] | None, typer.Option(metavar="NAME", help="cli_help.server_name")] = None,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="cli_help.browser")] = True,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput app``."""
    from stayput.extras import absent

    try:
        from stayput.app.server import serve
    except ModuleNotFoundError as error:
        if error.name is not None and error.name.startswith("stayput"):
            raise
        raise absent("The app", error.name or "a library", "app") from None
    serve(host, port, names=name or (), browser=browser, language=lang)

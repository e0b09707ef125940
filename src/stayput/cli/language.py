"""The language that a command speaks: what ``--lang`` says, else that of the locale."""

from __future__ import annotations

import locale
import os
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.catalogue import Language

OF_LOCALE = ""
"""Default of `LanguageOption`."""


def of_locale() -> Language:
    """Return the language that the environment asks for: Japanese where it does, else English."""
    variables = (os.environ.get(name) for name in ("LC_ALL", "LC_MESSAGES", "LANG"))
    asked = next(filter(None, variables), None) or locale.getlocale()[0] or ""
    return "ja" if asked.lower().startswith("ja") else "en"


def of_arguments(args: Sequence[str]) -> Language:
    """Return the language of a command line, in which it is refused too."""
    flags = " ".join(args)
    for language in ("ja", "en"):
        if f"--lang {language}" in flags or f"--lang={language}" in flags:
            return language
    return of_locale()


def _chosen(ctx: typer.Context, value: str) -> str:
    """Return the language of the flag, else that of the flag before the command, else the locale's."""
    from stayput.wording import check_language

    if value != OF_LOCALE:
        return check_language(value)
    return (ctx.parent and ctx.parent.params.get("lang")) or of_locale()


LanguageOption: TypeAlias = Annotated[
    str,
    typer.Option(
        "--lang", metavar="en|ja", callback=_chosen, show_default="cli_help.of_locale", help="cli_help.lang"
    ),
]

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


def _chosen(value: str) -> str:
    from stayput.wording import check_language

    return check_language(value) if value != OF_LOCALE else of_locale()


LanguageOption: TypeAlias = Annotated[
    str,
    typer.Option(
        "--lang",
        metavar="en|ja",
        callback=_chosen,
        show_default="the locale's",
        help="Language of what is printed, drawn and reported.",
    ),
]

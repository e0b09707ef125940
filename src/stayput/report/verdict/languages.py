"""The languages of a report."""

from __future__ import annotations

from stayput.errors import InputError
from stayput.verification.words import LANGUAGES


def check_language(language: str) -> str:
    """Return a language, or refuse it.

    Raises
    ------
    InputError
        It is neither "en" nor "ja".
    """
    if language not in LANGUAGES:
        raise InputError(f"The language is {language!r}; it must be one of {', '.join(LANGUAGES)}.")
    return language

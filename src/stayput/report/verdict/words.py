"""Texts of the report of a verdict, in one language."""

from __future__ import annotations

from stayput.catalogue import TEXTS, say


def word(key: str, language: str, **values: object) -> str:
    """Return a text of the report in "en" or "ja", with values in it.

    Parameters
    ----------
    key : str
        Its key in `stayput.catalogue.report`, or in `stayput.catalogue.common`.
    language : str
        "en" or "ja".
    **values
        What stands in its braces.
    """
    module = "report" if f"report.{key}" in TEXTS else "common"
    return say(f"{module}.{key}", language, **values)

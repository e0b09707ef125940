"""Reports as HTML pages that load nothing from elsewhere: their templates, common head, and writing."""

from __future__ import annotations

import re
from functools import partial
from importlib import resources
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

import stayput
from stayput.catalogue import say
from stayput.files import check_target, draft
from stayput.report.embedding import inks_css
from stayput.wording import check_language

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from pathlib import Path

_BEFORE_UNIT = re.compile(r"(?<=\d) (?=(?:%|[ck]?m|kg|k?[NJ]|Hz|s|m/s²?|cm/s|秒)(?![\w/]))")

SUFFIXES = (".html",)
"""The kind of file that a report is written as."""


def write_page(path: str | Path, language: str, page: Callable[[], str]) -> Path:
    """Write a page, which is made once language and path are known to be possible.

    Raises
    ------
    InputError
        Another language, or a path that cannot be written.
    """
    check_language(language)
    target = check_target(path, SUFFIXES)
    text = page()
    with draft(target) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
    return target


def rendered(template: str, content: Mapping[str, Any]) -> str:
    """Return a template of the package `stayput.report`, by its path there, with its content filled in."""
    pages = Environment(
        loader=PackageLoader("stayput", "report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        finalize=_tight,
    )
    return pages.get_template(template).render(content)


def framed(language: str, texts: str, title: str, sheets: Iterable[str]) -> dict[str, Any]:
    """Return what the head of each page asks for (`head.html`), and ``own``, the texts of the page.

    Parameters
    ----------
    language : str
        "en" or "ja".
    texts : str
        The part of the catalogue that has the page's texts.
    title : str
        The page's title.
    sheets : iterable of str
        Its style sheets, by their paths in `stayput.report`.
    """
    return {
        "language": language,
        "own": partial(_own, texts, language),
        "title": title,
        "version": stayput.__version__,
        "style": Markup(inks_css() + "".join(map(file_of, sheets))),
    }


def _own(texts: str, language: str, key: str, **values: object) -> str:
    return say(f"{texts}.{key}", language, **values)


def _tight(value: object) -> object:
    """Keep a number and its unit on one line."""
    if not isinstance(value, str) or isinstance(value, Markup):
        return value
    return _BEFORE_UNIT.sub("\N{NO-BREAK SPACE}", value)


def file_of(name: str) -> str:
    """Return the text of a file of `stayput.report`, by its path there."""
    return resources.files("stayput.report").joinpath(name).read_text(encoding="utf-8")

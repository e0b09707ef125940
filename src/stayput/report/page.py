"""Reports as HTML pages that load nothing from elsewhere: their templates, common head, and writing."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

import stayput
from stayput.catalogue import say
from stayput.files import check_target, draft
from stayput.report.palette import STABILITY_COLOURS
from stayput.wording import check_language

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable


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


def rendered(template: str, content: Mapping[str, Any], package: str = "report") -> str:
    """Return a template of a package of `stayput`, by its path there, with its content filled in."""
    pages = Environment(
        loader=PackageLoader("stayput", package),
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


_IN_SCRIPT = str.maketrans({c: f"\\u{ord(c):04x}" for c in "<>&\u2028\u2029"})
_IMPORT = re.compile(r"^import [^;]*/([\w.]+)\";\n", re.MULTILINE)
_EXPORT = re.compile(r"^export ", re.MULTILINE)


FRAME_HEIGHT = 760
"""Height of a player in a notebook [px]."""


@dataclass(frozen=True, slots=True, repr=False)
class Player:
    """A player of an animation that notebooks show, in a frame of its own.

    Parameters
    ----------
    page : str
        The HTML page of the player, which needs nothing else.
    title : str
        What it shows.
    """

    page: str
    title: str

    def __repr__(self) -> str:
        return f"Player({self.title!r})"

    def _repr_html_(self) -> str:
        page, title = html.escape(self.page), html.escape(self.title)
        looks = f'style="width: 100%; height: {FRAME_HEIGHT}px; border: 0"'
        return f'<iframe title="{title}" {looks} srcdoc="{page}"></iframe>'


def canvas_files() -> dict[str, Traversable]:
    """Return the scripts and styles that draw a scene, by their names."""
    folder = resources.files("stayput.report").joinpath("canvas")
    return {file.name: file for file in folder.iterdir() if file.name.endswith((".js", ".css"))}


def script_json(values: object) -> str:
    """Return values as JSON that an HTML script element can hold.

    In it ``</script`` ends the element, and after ``<!--<script`` the end that follows is not seen: so none
    of HTML's own characters is left. Only strings can hold them, where JSON writes them by their numbers.

    Raises
    ------
    ValueError
        A number that is not finite.
    """
    text = json.dumps(values, allow_nan=False, ensure_ascii=False, separators=(",", ":"))
    return text.translate(_IN_SCRIPT)


def script_module(script: str) -> str:
    """Return a script and the modules that it needs as the text of one inline module.

    A page that is opened from disk cannot import a module, so all stand in one scope: imports and the word
    ``export`` are left out.

    Parameters
    ----------
    script : str
        The page's own script, which imports from the modules of `canvas_files`.
    """
    files, needed = canvas_files(), dict[str, str]()

    def add(text: str) -> None:
        for name in _IMPORT.findall(text):
            if name not in needed:
                module = files[name].read_text(encoding="utf-8")
                add(module)  # what it needs comes before it
                needed[name] = module

    add(script)
    texts = [*needed.values(), script]
    return "\n".join(_EXPORT.sub("", _IMPORT.sub("", text)) for text in texts)


def inks_css() -> str:
    """Return the colours of a scene in both themes, as the text of a style sheet."""
    steps = "".join(f"  --{step}: {colour};\n" for step, colour in STABILITY_COLOURS.items())
    return f":root {{\n{steps}}}\n" + canvas_files()["inks.css"].read_text(encoding="utf-8")

"""The scene's scripts and styles, served by the app and held by HTML files that stand alone."""

from __future__ import annotations

import html
import json
import re
from dataclasses import dataclass
from importlib import resources
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping
    from importlib.resources.abc import Traversable

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
    return canvas_files()["inks.css"].read_text(encoding="utf-8")


def filled(page: str, texts: Mapping[str, str], code: Mapping[str, str]) -> str:
    """Return a page with what stands for its marks in double braces.

    Parameters
    ----------
    page : str
        HTML.
    texts : mapping of str
        Texts by their marks.
    code : mapping of str
        Style sheets, scripts and data by their marks, which stand as they are.
    """
    parts = {**{key: html.escape(text) for key, text in texts.items()}, **code}
    # In one pass, as a title may hold a mark.
    return re.sub(r"\{\{(\w+)\}\}", lambda mark: parts[mark[1]], page)

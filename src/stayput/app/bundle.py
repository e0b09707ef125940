"""One script of a page's modules, and one page with its styles: so few requests are short on a slow line.

A browser asks for a module only when it has read the one that imports it. Here each module becomes a function
that is called once, after those that it imports, and returns what it exports.
"""

from __future__ import annotations

import posixpath
import re
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

_IMPORT = re.compile(
    r'^import\s+(?:(?P<what>\* as \w+|\{[^}]*\})\s+from\s+)?"(?P<name>[^"]+)";', re.MULTILINE
)
_EXPORT = re.compile(r"^export (?=(?:const|class|function|async function)\s+(?P<name>\w+))", re.MULTILINE)
_EXPORTS = re.compile(r"^export \{(?P<names>[^}]*)\};", re.MULTILINE)
_NOT_BUNDLED = re.compile(r"^(?:import|export)\b.*|\bimport(?:\(|\.meta\b).*", re.MULTILINE)
_COMMENT = re.compile(r"^[^\S\n]*(?://[^\n]*|/\*\*.*?\*/[^\S\n]*)\n", re.MULTILINE | re.DOTALL)

_STYLE = re.compile(r'<link rel="stylesheet" href="([^"]+)">\n?')
_PRELOAD = re.compile(r'<link rel="modulepreload"[^>]*>\n?')
_SCRIPT = re.compile(r'<script type="module" src="([^"]+)"></script>')
_WORDS = re.compile(r'(<[^<>]*\bdata-t="(\w+)"[^<>]*>)[^<]*')


def bundled(files: Mapping[str, str], entry: str) -> str:
    """Return a module and all that it needs as the text of one script.

    Lines of comments are left out.

    Parameters
    ----------
    files : mapping of str
        The modules' texts by their paths.
    entry : str
        The path of the module that is the page's own script.

    Raises
    ------
    ValueError
        A form of ``import`` or ``export`` that is not known here, a name that is not exported, modules that
        import each other, or one that is not there.
    """
    exported: dict[str, set[str]] = {}
    waiting: list[str] = []
    made: list[str] = []

    def add(path: str) -> None:
        if path in exported:
            return
        if path in waiting or path not in files:
            raise ValueError(f"{' imports '.join([*waiting, path])}, which cannot be bundled")
        waiting.append(path)
        text = _COMMENT.sub("", files[path])
        for found in _IMPORT.finditer(text):
            add(_beside(path, found["name"]))
        exported[path], body = _as_function(path, text, exported)
        made.append(body)
        waiting.pop()

    add(entry)
    return "\n".join(made)


def _as_function(path: str, text: str, exported: Mapping[str, set[str]]) -> tuple[set[str], str]:
    """Return what a module exports, and the module as a function that is called at once."""

    def taken(found: re.Match[str]) -> str:
        what, other = found["what"], _beside(path, found["name"])
        if what is None:
            return ""
        if what.startswith("*"):
            return f"const {what.removeprefix('* as ')} = {_variable(other)};"
        names = _names(what.strip("{}"))
        unknown = {name for name, _ in names} - exported[other]
        if unknown:
            raise ValueError(f"{path} imports {sorted(unknown)}, which {other} does not export")
        taken = ", ".join(name if name == own else f"{name}: {own}" for name, own in names)
        return f"const {{ {taken} }} = {_variable(other)};"

    given = {name: name for name in (found["name"] for found in _EXPORT.finditer(text))}
    for found in _EXPORTS.finditer(text):
        given |= {name: own for own, name in _names(found["names"])}
    body = _EXPORT.sub("", _EXPORTS.sub("", _IMPORT.sub(taken, text)))
    left = _NOT_BUNDLED.search(body)
    if left:
        raise ValueError(f"{path} has {left[0]!r}, which cannot be bundled")
    returned = ", ".join(name if name == own else f"{name}: {own}" for name, own in given.items())
    return set(given), f"const {_variable(path)} = (() => {{\n{body}\nreturn {{ {returned} }};\n}})();"


def _names(listed: str) -> list[tuple[str, str]]:
    """Return the pairs of a list of imports or exports: the name, and the one after ``as`` or the same."""
    pairs = (part.split(" as ") for part in listed.split(",") if part.strip())
    return [
        (first.strip(), last.strip())
        for first, *_, last in (pair if pair[1:] else pair * 2 for pair in pairs)
    ]


def _beside(path: str, name: str) -> str:
    return posixpath.normpath(posixpath.join(posixpath.dirname(path), name))


def _variable(path: str) -> str:
    return "$" + re.sub(r"\W", "_", path.removesuffix(".js"))


def entry_of(html: str) -> str:
    """Return the address of a page's own script, as the page writes it."""
    (found,) = _SCRIPT.findall(html)
    return found


def page_with(
    html: str, files: Mapping[str, str], folder: str, script: str, language: str, words: Mapping[str, str]
) -> str:
    """Return a page that loads one script, with its styles in it, and in one language.

    Parameters
    ----------
    html : str
        The page as it is written, with links to its style sheets and modules.
    files : mapping of str
        The style sheets' texts by their paths.
    folder : str
        The path of the page's folder.
    script : str
        The address of the bundled script.
    language : str
        The language.
    words : mapping of str
        The page's texts in the language by their keys.
    """
    sheets = [files[posixpath.normpath(posixpath.join(folder, name))] for name in _STYLE.findall(html)]
    style = "<style>\n" + "\n".join(sheets) + "</style>\n"
    own = f'{style}<script type="module" src="{escape(script)}"></script>'
    bare = _PRELOAD.sub("", _STYLE.sub("", html)).replace('<html lang="en">', f'<html lang="{language}">', 1)
    placed = _SCRIPT.sub(lambda _: own, bare)
    return _WORDS.sub(lambda found: found[1] + escape(words[found[2]]), placed)

"""The font of the pictures: Matplotlib's own, so that every machine draws the same.

What it has no letters for, such as a Japanese name, is drawn with a font of the machine that has them.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
from matplotlib.font_manager import findSystemFonts, fontManager  # pyright: ignore[reportUnknownVariableType]
from matplotlib.ft2font import FT2Font
from matplotlib.text import Text
from PIL import ImageFont

from stayput.errors import InputWarning, warn

if TYPE_CHECKING:
    from matplotlib.artist import Artist

_FILE = Path(mpl.get_data_path()) / "fonts/ttf/DejaVuSans.ttf"
_JAPANESE = r"\u3000-\u9fff\uff00-\uffef"
_PARTS = re.compile(rf"[（「]*(?:[{_JAPANESE}]|[^\s{_JAPANESE}]+)[、。」）：・ー]*\s*")
"""What stays together on a line: a word, or a Japanese letter, with what opens and closes around it."""

_LEFT_OUT = "\N{HORIZONTAL ELLIPSIS}"

PREFERRED = (
    *("NotoSansCJK-Regular", "NotoSansCJKjp-Regular", "NotoSansJP", "SourceHanSans"),
    *("ipaexg", "ipagp", "ipag"),
    *("TakaoPGothic", "VL-PGothic", "Hiragino Sans GB", "ヒラギノ角ゴシック W3", "YuGothR", "YuGothM"),
    *("meiryo", "msgothic", "DroidSansFallback"),
)
"""Sans serifs with Japanese letters, by the start of their file's name; any other font comes after."""


@cache
def font(size: float, file: Path = _FILE) -> ImageFont.FreeTypeFont:
    """Return a font for Pillow in a size [pixels]."""
    return ImageFont.truetype(str(file), round(size))


def drawable(text: str) -> str:
    """Return a text as Matplotlib draws it as it is: its dollars are no marks of mathematics.

    What no font of this machine can draw becomes an ellipsis, and is warned of once.
    """
    return _with_letters(text).replace("$", r"\$")


def _with_letters(text: str) -> str:
    text = re.sub(r"[^\S\n]", " ", text)  # no font has a tab
    missing = _missing(text)
    if not missing:
        return text
    other = _other(missing)
    nowhere = missing if other is None else missing - _characters(other)
    if nowhere:
        _warn("".join(sorted(nowhere))[:10])
    return _without(text, nowhere)


def with_face(text: str, size: float) -> tuple[str, ImageFont.FreeTypeFont]:
    """Return a text and one font for all of it, for Pillow, which takes no second font."""
    missing = _missing(text)
    other = _other(missing) if missing else None
    if other is None:
        return _with_letters(text), font(size)
    shown = {c for c in _with_letters(text) if not c.isspace()}
    return _without(text, shown - _characters(other)), font(size, other)


def wrapped(text: str, face: ImageFont.FreeTypeFont, room: float) -> str:
    """Return a text in lines that are at most so wide [pixels].

    Lines end at spaces and between Japanese letters; none begins with what closes a bracket or a sentence.
    """
    lines = [""]
    parts = [
        letters
        for part in _PARTS.findall(text)
        for letters in ([part] if face.getlength(part.rstrip()) <= room else part)
    ]
    for part in parts:
        if lines[-1] and face.getlength((lines[-1] + part).rstrip()) > room:
            lines.append("")
        lines[-1] += part
    return "\n".join(line.strip() for line in lines)


def with_fallback(drawn: Artist) -> set[str]:
    """Give those texts of a figure or of axes a second font that have letters which the first one lacks.

    Returns
    -------
    set of str
        The families that were added.
    """
    added: set[str] = set()
    for text in drawn.findobj(Text):
        missing = _missing(text.get_text())
        other = _other(missing) if missing else None
        if other is not None:
            family = _family(other)
            added.add(family)
            text.set_fontfamily([*mpl.rcParams["font.family"], family])
    return added


def _missing(text: str) -> frozenset[str]:
    return frozenset(c for c in text if not c.isspace()) - _characters(_FILE)


def _without(text: str, left_out: set[str] | frozenset[str]) -> str:
    marked = "".join("\0" if c in left_out else c for c in text)
    return re.sub("\0+", _LEFT_OUT, marked)


@cache
def _characters(file: Path) -> frozenset[str]:
    try:
        return frozenset(map(chr, FT2Font(str(file)).get_charmap()))
    except (OSError, RuntimeError):  # a file that is no font that FreeType reads
        return frozenset()


@cache
def _other(characters: frozenset[str]) -> Path | None:
    """Return the font of this machine that has the most of these characters, the preferred ones first."""
    best, most = None, 0
    for file in _system_fonts():
        has = len(characters & _characters(file))
        if has > most:
            best, most = file, has
        if most == len(characters):
            break
    return best


@cache
def _system_fonts() -> tuple[Path, ...]:
    """Return the machine's fonts; they are looked for anew, as Matplotlib's list on disk may be older."""

    def rank(file: Path) -> tuple[int, str]:
        places = (n for n, start in enumerate(PREFERRED) if file.stem.startswith(start))
        return next(places, len(PREFERRED)), str(file)

    files: list[str] = findSystemFonts()
    return tuple(sorted(map(Path, files), key=rank))


@cache
def _family(file: Path) -> str:
    """Return the name by which Matplotlib finds a font, which is made known to it."""
    fontManager.addfont(str(file))
    return FT2Font(str(file)).family_name


_warned: set[str] = set()


def _warn(characters: str) -> None:
    if not _warned:
        _warned.add(characters)
        warn(InputWarning("runs.no_letters", letters=characters, shown=_LEFT_OUT))

"""Shared by all plots: figures without pyplot (thread-safe, headless), their style, files and font.

The font is Matplotlib's own, so that every machine draws the same. What it has no letters for, such as a
Japanese name, is drawn with a font of the machine that has them.
"""

from __future__ import annotations

import base64
import math
import re
from collections.abc import Callable, Iterator
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import findSystemFonts, fontManager  # pyright: ignore[reportUnknownVariableType]
from matplotlib.ft2font import FT2Font
from matplotlib.text import Text
from matplotlib.ticker import NullFormatter, StrMethodFormatter
from numpy.typing import NDArray
from PIL import ImageFont

from stayput.catalogue import say
from stayput.catalogue.names import INTENSITIES
from stayput.errors import InputError, InputWarning, warn
from stayput.files import PLOT_SUFFIXES, check_target, draft
from stayput.motion.intensity import CLASSES
from stayput.report.palette import FAINT, INK, MUTED

if TYPE_CHECKING:
    from matplotlib.artist import Artist

    from stayput.simulation.run import PieceRun


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
    if nowhere and not _warned:
        _warned.update(nowhere)
        warn(InputWarning("runs.no_letters", letters="".join(sorted(nowhere))[:10], shown=_LEFT_OUT))
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


LINE = "drawn"
"""What marks the line of a value on axes, by which the lines there are counted."""

_ZERO = "zero"
"""What marks the line at zero."""

LINE_COLOURS = ("#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#0072b2")
"""Colours of further lines on the same axes, of Okabe and Ito."""

FONT = 10.0
"""Size of the labels [points]."""


def new_figure(width: float, height: float, title: str = "") -> Figure:
    """Return a figure of a size in inches, empty but for a title."""
    figure = Figure(figsize=(width, height), dpi=120, layout="constrained", facecolor="white")
    FigureCanvasAgg(figure)
    if title:
        figure.suptitle(drawable(title), fontsize=FONT + 2.0, color=INK)
    return figure


def figure_of(draw: Callable[[Axes], None], width: float, height: float) -> Figure:
    """Return a figure of a size in inches with one drawing, whose letters all have a font."""
    figure = new_figure(width, height)
    draw(figure.subplots())
    with_fallback(figure)
    return figure


def label_axes(axis: Axes, language: str, x: str = "", y: str = "", **values: object) -> None:
    """Label an axis along x, y or both, by the ids of the texts and the values in them."""
    if x:
        axis.set_xlabel(say(x, language, **values), fontsize=FONT)
    if y:
        axis.set_ylabel(say(y, language, **values), fontsize=FONT)


def legend_within(axis: Axes) -> None:
    """Explain the lines of an axis within it."""
    axis.legend(loc="best", fontsize=FONT - 1.5, framealpha=0.85)


def axes_of(ax: Axes | None) -> Axes:
    """Return the axes to draw on: those given, or those of a new figure of pyplot, which notebooks show.

    Raises
    ------
    InputError
        Something else than axes, such as the array of them that ``subplots`` returns; axes of another
        projection, such as polar ones.
    """
    if ax is None:
        from matplotlib import pyplot  # which chooses how figures are shown, and is slow to load

        return pyplot.subplots(layout="constrained")[1]
    if not isinstance(ax, Axes):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InputError("plots.not_axes", "ax", kind=type(ax).__name__)
    if ax.name != "rectilinear":
        raise InputError("plots.projection", "ax", projection=repr(ax.name))
    return ax


def plotted(ax: Axes | None, draw: Callable[..., Any], *arguments: Any, **line: Any) -> Axes:
    """Draw on axes, or on those of a new figure, by a function that takes them first; return them.

    They have fonts with the letters of their texts. Texts that are written later, such as those of a legend
    that is made anew, find the same fonts.
    """
    axis = axes_of(ax)
    draw(axis, *arguments, **line)
    for family in with_fallback(axis):
        if family not in mpl.rcParams["font.family"]:
            mpl.rcParams["font.family"] = [*mpl.rcParams["font.family"], family]
    return axis


def colour_beside(axis: Axes, first: str) -> str:
    """Return the colour of the next line of axes: the first one's own, then others in turn."""
    lines = sum(line.get_gid() == LINE for line in axis.lines)
    return LINE_COLOURS[(lines - 1) % len(LINE_COLOURS)] if lines else first


def saved(figure: Figure, path: str | Path | None) -> Figure:
    """Save a figure atomically where a path is given: PNG, SVG or PDF by its ending."""
    with_fallback(figure)
    if path is not None:
        target = check_target(path, PLOT_SUFFIXES)
        content = BytesIO()  # Matplotlib's PDF and SVG of a disk that gets full end in errors of their own
        figure.savefig(content, format=target.suffix[1:].lower())
        with draft(target) as unfinished:
            unfinished.write_bytes(content.getbuffer())
    return figure


def embedded(figure: Figure, form: Literal["png", "svg"]) -> str:
    """Return a figure as the address of an image that holds it, the same for the same figure."""
    content = BytesIO()
    with mpl.rc_context({"svg.hashsalt": "stayput"}):
        figure.savefig(content, format=form, metadata={"Date": None} if form == "svg" else None)
    kind = "svg+xml" if form == "svg" else form
    return f"data:image/{kind};base64,{base64.b64encode(content.getvalue()).decode('ascii')}"


def style(axis: Axes, *, zero: bool = True) -> None:
    """Give an axis the grid and the sizes of all plots, and a line at zero where that means something."""
    axis.tick_params(labelsize=FONT - 1.0, colors=INK)
    axis.grid(True, color=FAINT, linewidth=0.7)
    axis.set_axisbelow(True)
    if zero and not any(line.get_gid() == _ZERO for line in axis.lines):
        axis.axhline(0.0, color=MUTED, linewidth=0.6, gid=_ZERO)
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)


def grey_after_fall(axis: Axes, piece: PieceRun, time: NDArray[Any], *line: NDArray[Any]) -> None:
    """Draw a line grey from when a piece overturned or fell off on: its peaks are those until then."""
    fell = time > np.fmin(piece.overturn_time, piece.fall_time)  # nan where it did neither
    if fell.any():
        axis.plot(*(part[fell] for part in line), color=FAINT, linewidth=2.4, zorder=4)


def plain_log(axis: Axes, *, y: bool = True) -> None:
    """Make x logarithmic, and y too or not, with numbers instead of powers."""
    axis.set_xscale("log")
    if y:
        axis.set_yscale("log")
    for line in (axis.xaxis, axis.yaxis) if y else (axis.xaxis,):
        line.set_major_formatter(StrMethodFormatter("{x:g}"))
        line.set_minor_formatter(NullFormatter())


def shaded_classes(axis: Axes, first: float, last: float, language: str) -> Iterator[tuple[float, str]]:
    """Shade every second class of JMA's intensity along x, and yield where the names of wide ones stand.

    Parameters
    ----------
    axis : Axes
        The axis, along whose x are intensities.
    first, last : float
        Its ends.
    language : str
        "en" or "ja", of the names.

    Yields
    ------
    tuple
        The middle of a class within the ends, and its name.
    """
    ends = [start for _, start in CLASSES[1:]] + [math.inf]
    for place, ((name, start), end) in enumerate(zip(CLASSES, ends, strict=True)):
        low, high = max(start, first), min(end, last)
        if place % 2 == 1 and high > low:
            axis.axvspan(low, high, color=FAINT, alpha=0.35, linewidth=0.0, zorder=0)
        if high - low > 0.05 * (last - first):
            yield 0.5 * (low + high), drawable(say(INTENSITIES[name], language).removeprefix("震度"))

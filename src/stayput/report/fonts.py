"""The font of the pictures: Matplotlib's own, so that every machine draws the same."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import matplotlib as mpl
from matplotlib.ft2font import FT2Font
from PIL import ImageFont

_FILE = Path(mpl.get_data_path()) / "fonts/ttf/DejaVuSans.ttf"
_LEFT_OUT = "\N{HORIZONTAL ELLIPSIS}"


def font(size: float) -> ImageFont.FreeTypeFont:
    """Return the font for Pillow in a size [pixels]."""
    return ImageFont.truetype(str(_FILE), round(size))


def drawable(text: str) -> str:
    """Return a text with an ellipsis for what the font cannot draw, such as a station's Japanese name."""
    known = _characters()
    kept = "".join(c if ord(c) in known or c.isspace() else "\0" for c in text)
    return re.sub("\0+", _LEFT_OUT, kept)


@cache
def _characters() -> frozenset[int]:
    return frozenset(FT2Font(str(_FILE)).get_charmap())

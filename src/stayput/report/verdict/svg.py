"""Small pieces of inline SVG; colours and fonts come from the page's style by class."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape

import numpy as np
from numpy.typing import ArrayLike


def element(name: str, content: str = "", **attributes: str | float) -> str:
    """Return an element; underscores in the names of attributes are dashes, ``class_`` is ``class``."""
    listed = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{_value(value)}"' for key, value in attributes.items()
    )
    return f"<{name}{listed}>{content}</{name}>" if content else f"<{name}{listed}/>"


def _value(value: str | float) -> str:
    return escape(value) if isinstance(value, str) else f"{value:.2f}".rstrip("0").rstrip(".")


def label(x: float, y: float, text: str, class_: str = "small", anchor: str = "middle") -> str:
    """Return a text that stands at a place [px]."""
    return element("text", escape(text), x=x, y=y, class_=class_, text_anchor=anchor)


def line(x0: float, y0: float, x1: float, y1: float, class_: str) -> str:
    """Return a straight line [px]."""
    return element("line", x1=x0, y1=y0, x2=x1, y2=y1, class_=class_)


def box(x0: float, y0: float, x1: float, y1: float, class_: str) -> str:
    """Return a rectangle between two corners [px]."""
    low, high = min(x0, x1), min(y0, y1)
    return element("rect", x=low, y=high, width=abs(x1 - x0), height=abs(y1 - y0), class_=class_)


def polyline(x: ArrayLike, y: ArrayLike, class_: str) -> str:
    """Return a line through points [px]."""
    return element("polyline", points=_points(zip(np.asarray(x), np.asarray(y), strict=True)), class_=class_)


def polygon(points: Iterable[tuple[float, float]], class_: str) -> str:
    """Return a filled outline [px]."""
    return element("polygon", points=_points(points), class_=class_)


def _points(points: Iterable[tuple[float, float]]) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points)


def drawing(
    width: float, height: float, content: Sequence[str], name: str, class_: str, **attributes: str
) -> str:
    """Return a picture with its name for those who do not see it."""
    window = f"0 0 {width:.0f} {height:.0f}"
    named = {"viewBox": window, "class_": class_, "role": "img", "aria_label": name}
    return element("svg", "".join(content), **named, **attributes)


def ticks(low: float, high: float, count: int) -> list[float]:
    """Return round numbers between two ends, about so many."""
    rough = (high - low) / count
    power = 10.0 ** math.floor(math.log10(rough))
    step = power * next(s for s in (1.0, 2.0, 5.0, 10.0) if s * power >= rough * (1.0 - 1e-9))
    return [step * k for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]

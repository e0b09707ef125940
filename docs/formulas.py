"""Formulas as pictures: TeX becomes SVG as the pages are built, and MathML beside it for screen readers.

Browsers show an SVG alike, without scripts, fonts or styles from elsewhere. It takes the colour and the size
of the text around it. What `\\qquad` separates in a displayed formula goes onto lines of its own where the
page is narrow.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from functools import cache
from typing import Any

import ziamath
from docutils.nodes import SkipNode
from sphinx.errors import ExtensionError
from ziamath.tex import tex2mml

SIZE = 100.0
"""Size at which formulas are drawn; on the page it is an em."""
SIGNS = "\u2212+±∓"
NAME = re.compile(r"\\operatorname\s*\{(\w+)\}")
DEEPER = re.compile(r"\{|\\begin\b|\\left\b|(\}|\\end\b|\\right\b)|(\\qquad\b(?:\\quad\b)?)")
"""What opens a group, what closes one (1), and what stands between formulas (2)."""

ziamath.config.svg2 = False  # paths in place of symbols, whose ids would be those of other formulas too
ziamath.config.precision = 1


def _signs_of_numbers(row: ET.Element) -> None:
    """Mark a sign after an operator, a bracket or nothing as one that belongs to what follows it."""
    before: ET.Element | None = None
    for node in row:
        operator = before is None or (before.tag == "mo" and before.get("form") != "postfix")
        closed = before is not None and (before.text or "").strip() in {")", "]", "}", "!", "′"}
        if node.tag == "mo" and (node.text or "").strip() in SIGNS and operator and not closed:
            node.set("form", "prefix")
        _signs_of_numbers(node)
        if node.tag != "mspace":
            before = node


def _mathml(tex: str, inline: bool) -> ET.Element:
    named = NAME.sub(r"\\mathrm {\1}", tex)
    text = tex2mml(named, inline=inline).replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "")
    math = ET.fromstring(text)
    unknown = re.search(r"\\[a-zA-Z]+", " ".join(math.itertext()))
    if unknown:
        raise ExtensionError(f"The formula {tex!r} has {unknown[0]}, which its renderer does not know.")
    _signs_of_numbers(math)
    return math


@cache
def drawn(tex: str, inline: bool) -> str:
    """Return a formula as HTML: its SVG, on the baseline of the text, and hidden MathML."""
    math = _mathml(tex, inline)
    heard = ET.tostring(math, encoding="unicode")
    math.set("mathcolor", "currentColor")
    svg = ziamath.Math(math, size=SIZE).svgxml()
    _, top, width, height = map(float, svg.attrib["viewBox"].split())
    svg.attrib.pop("xmlns:xlink", None)
    del svg.attrib["width"], svg.attrib["height"]
    svg.set("style", f"width:{width / SIZE:.3f}em;vertical-align:{-(top + height) / SIZE:.3f}em")
    svg.set("aria-hidden", "true")
    return (
        f'<span class="formula">{ET.tostring(svg, encoding="unicode")}'
        f'<span class="heard">{heard}</span></span>'
    )


def _inline(writer: Any, node: Any) -> None:
    writer.body.append(drawn(node.astext(), inline=True))
    raise SkipNode


def apart(tex: str) -> list[str]:
    """Return the formulas that stand side by side, with `\\qquad` between them."""
    parts, depth, start = [], 0, 0
    for mark in DEEPER.finditer(tex):
        if mark[2] is None:
            depth += -1 if mark[1] else 1
        elif depth == 0:
            parts.append(tex[start : mark.start()].strip())
            start = mark.end()
    return [*parts, tex[start:].strip()]


def _display(writer: Any, node: Any) -> None:
    inner = "".join(drawn(part, inline=False) for part in apart(node.astext()))
    writer.body.append(f'<div class="math">{inner}</div>\n')
    raise SkipNode


def setup(app: Any) -> dict[str, Any]:
    """Draw formulas of HTML pages here."""
    app.add_html_math_renderer("svg", (_inline, None), (_display, None))
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}

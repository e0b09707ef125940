"""Formulas of the documentation are drawn, their signs stand where they belong, and neighbours come apart."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
pytest.importorskip("ziamath", reason="formulas are drawn by the documentation's libraries, which are absent")
pytest.importorskip("sphinx", reason="the documentation's libraries are absent")
sys.path.insert(0, str(DOCS))

from formulas import apart, drawn  # noqa: E402
from sphinx.errors import ExtensionError  # noqa: E402

CODE = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)
DISPLAYED = re.compile(r"\$\$(.+?)\$\$", re.DOTALL)


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda page: page.stem)
def test_every_displayed_formula_is_drawn(page: Path) -> None:
    for found in DISPLAYED.finditer(CODE.sub("", page.read_text(encoding="utf-8"))):
        for part in apart(found[1].strip()):
            assert "<path" in drawn(part, inline=False)


def test_what_the_renderer_does_not_know_is_refused() -> None:
    with pytest.raises(ExtensionError, match=r"has \\nosuch,"):
        drawn(r"a = \nosuch b", inline=True)


def test_formulas_side_by_side_come_apart_but_for_those_within_a_group() -> None:
    assert apart(r"a = 1, \qquad b = 2") == ["a = 1,", "b = 2"]
    assert apart(r"\begin{cases} a \qquad b \end{cases} \qquad c") == [
        r"\begin{cases} a \qquad b \end{cases}",
        "c",
    ]
    assert apart(r"\frac{a \qquad b}{c}") == [r"\frac{a \qquad b}{c}"]


def test_a_sign_after_an_equals_sign_belongs_to_what_follows() -> None:
    assert drawn("a = -b", inline=True).count('form="prefix"') == 1
    assert 'form="prefix"' not in drawn("a - b", inline=True)


def test_a_formula_takes_the_colour_of_the_text_and_is_read_aloud() -> None:
    picture = drawn("x^2", inline=True)
    assert 'fill="currentColor"' in picture
    assert "<math" in picture
    assert 'aria-hidden="true"' in picture

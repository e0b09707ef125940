"""Reports on paper: few pages, headings stay with their tables, and pages have margins."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from test_room_api import ROOM

import stayput as sp
from long_cases import long

if TYPE_CHECKING:
    from playwright.sync_api import Browser

EXAMPLES = Path(__file__).parents[2] / "examples"

LINKED = """(gap) => {
  // the printed file says on which page a link's target is
  const links = document.createElement("nav"), space = document.createElement("div"), names = [];
  const target = (one, id) => {
    one.id = id;
    links.append(Object.assign(document.createElement("a"), { href: `#${id}`, textContent: id }));
  };
  for (const table of document.querySelectorAll("main table")) {
    if (table.closest("details details")) continue; // not printed
    let heading = (table.closest(".wide") ?? table).previousElementSibling;
    while (heading.tagName === "P") heading = heading.previousElementSibling;
    if (heading.tagName === "SUMMARY") heading = heading.querySelector("h2");
    if (!["H2", "H3"].includes(heading.tagName)) continue;
    target(heading, `heading-${names.length}`);
    target(table.querySelector("tbody tr"), `row-${names.length}`);
    names.push(heading.textContent);
  }
  space.style.height = `${gap}mm`;
  document.querySelector("main").prepend(links, space);
  return names;
}"""

MARGIN = """[...document.styleSheets].flatMap((one) => [...one.cssRules])
  .filter((rule) => rule instanceof CSSPageRule).map((rule) => rule.style.margin)"""


def test_headings_stay_with_their_tables(browser: Browser, tmp_path: Path) -> None:
    verdict = sp.verify(sp.Scenario.parse(ROOM), changes=False, progress=False)
    file = verdict.report(tmp_path / "room.html")
    for gap in range(0, 260, 65):  # of an A4 page
        page = browser.new_page()
        page.goto(file.as_uri())
        names = page.evaluate(LINKED, gap)
        printed = page.pdf(format="A4", print_background=True)
        assert page.evaluate(MARGIN) == ["14mm 14mm 16mm"]
        page.close()
        targets = dict(re.findall(rb"/((?:heading|row)-\d+) \[(\d+) 0 R /XYZ", printed))
        assert len(names) >= 4
        assert len(targets) == 2 * len(names)
        for number, name in enumerate(names):
            assert targets[b"heading-%d" % number] == targets[b"row-%d" % number], (gap, name)


PIECE = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"builtin": "near-fault"},
    "uncertainty": {"samples": 4},
}
"""A piece with all usual measures."""


def verdict_of(name: str) -> sp.Verdict:
    stated = {"piece": PIECE, "room": ROOM}.get(name)
    scenario = sp.read(EXAMPLES / f"{name}.toml") if stated is None else sp.Scenario.parse(stated)
    return sp.verify(scenario, progress=False)


@pytest.mark.parametrize(
    ("name", "most"), [("piece", 5), ("room", 6), *long(("bookcase", 5), ("kitchen", 5), ("bedroom", 6))]
)
def test_reports_have_few_pages(browser: Browser, tmp_path: Path, name: str, most: int) -> None:
    verdict = verdict_of(name)
    for language in ("en", "ja"):
        page = browser.new_page()
        page.goto(verdict.report(tmp_path / "report.html", language).as_uri())
        for paper in ("A4", "Letter"):
            printed = page.pdf(format=paper, print_background=True)
            assert len(re.findall(rb"/Type\s*/Page\b", printed)) <= most
        assert page.locator("details[open]").count() == 0  # as they were before
        page.close()

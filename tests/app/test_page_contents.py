"""The page asks what is inside; the scene, the link and the ranking have it."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from browsing import opened

if TYPE_CHECKING:
    from playwright.sync_api import Browser
    from serving import Running


def test_what_is_inside_is_asked_and_the_ranking_says_what_comes_out(
    browser: Browser, server: Running
) -> None:
    with opened(browser, server, verify=True) as it:
        assert not it.page.get_by_label("Doors").is_visible()
        asked, _ = it.simulated(lambda: it.page.get_by_label("What may come out").select_option("dishes"))
        assert asked["scene"]["contents"] == {"kind": "dishes", "doors": "none"}
        asked, _ = it.simulated(lambda: it.page.get_by_label("Doors").select_option("hinged"))
        assert asked["scene"]["contents"]["doors"] == "hinged"
        it.kept("contents=dishes", "doors=hinged")
        it.go("understand")
        it.wait("() => /dishes (come out|stay inside)/.test(document.querySelector('#ranking').innerText)")


def test_the_headline_says_what_comes_out_and_how_it_is_as_people_install_it(
    browser: Browser, server: Running
) -> None:
    address = "#piece=bookcase&contents=books&measures=l_bracket&installed=1"
    with opened(browser, server, address, verify=True) as it:
        it.go("understand")
        it.wait("() => document.querySelectorAll('#also li:not(.hint)').length === 2")
        without, held = it.page.locator("#also li:not(.hint)").all_inner_texts()
        comes_out = re.compile(r"%\sof the books come out\.|The books stay inside\.")
        assert without.startswith("Without measures: ")
        assert comes_out.search(without)
        assert "As people install it" not in without
        assert comes_out.search(held)
        assert re.search(r"As people install it, it overturns in \d", held)
        it.speak("ja")
        assert re.search(r"本(の.*が飛び出します|は飛び出しません)。", it.text("#also"))
        assert "実際の取付けでは" in it.text("#also")

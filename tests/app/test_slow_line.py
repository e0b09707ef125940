"""The first picture on a slow line: how much is fetched for it, in how many steps one after the other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from browsing import COMPILING, PHONE, opened
from page_coverage import start

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page
    from serving import Running

RATE = 50_000
"""What comes over the line in a second [bytes]."""

LATENCY = 0.4
"""How long a request waits for its answer to begin [s]."""

MOST_BYTES = 230_000
STEPS = ["page", "modules", "simulation"]
"""What is asked for one after the other; what can be chosen comes beside the modules."""

LATER = ("icon.svg", "/api/v1/verify", "/api/v1/jobs/", "/ping")

PATIENCE = 30.0
"""How long the throttled picture may take on a machine that has much else to do [s]."""

pytestmark = pytest.mark.skipif(bool(start()), reason="modules are loaded one by one to be recorded")


class Line:
    """What a page fetches, with the bytes that came over the line."""

    def __init__(self, page: Page, *, throttled: bool = False) -> None:
        self._urls: dict[str, str] = {}
        self._sizes: dict[str, int] = {}
        session = page.context.new_cdp_session(page)
        session.on("Network.requestWillBeSent", self._sent)
        session.on("Network.loadingFinished", self._came)
        session.send("Network.enable")
        if throttled:
            session.send(
                "Network.emulateNetworkConditions",
                {
                    "offline": False,
                    "latency": 1000 * LATENCY,
                    "downloadThroughput": RATE,
                    "uploadThroughput": RATE,
                },
            )

    def _sent(self, told: dict[str, Any]) -> None:
        self._urls[told["requestId"]] = told["request"]["url"]

    def _came(self, told: dict[str, Any]) -> None:
        self._sizes[told["requestId"]] = int(told["encodedDataLength"])

    @property
    def fetched(self) -> dict[str, int]:
        """The bytes of each answer, by its address, without those that no picture waits for.

        The chances are asked for a second later, which comes before the picture where that is compiled first;
        a page that waits long asks beside that whether the server is getting ready.
        """
        urls = {self._urls[one]: size for one, size in self._sizes.items()}
        return {url: size for url, size in urls.items() if not any(part in url for part in LATER)}


def first_picture(page: Page, address: str) -> float:
    """Return when the first picture was drawn [s]."""
    page.goto(address)
    page.wait_for_selector("html[data-drawn]", state="attached", timeout=COMPILING)
    return float(page.evaluate("Number(document.documentElement.dataset.drawn)")) / 1000


@pytest.mark.parametrize("language", ["en-GB", "ja-JP"])
def test_the_first_picture_needs_few_bytes(browser: Browser, server: Running, language: str) -> None:
    with browser.new_context(viewport=PHONE, locale=language) as context:  # type: ignore[arg-type]
        page = context.new_page()
        line = Line(page)
        first_picture(page, server.address)
        fetched = line.fetched
    assert sum(fetched.values()) <= MOST_BYTES, fetched


def test_the_first_picture_comes_soon_on_a_slow_line(browser: Browser, server: Running) -> None:
    with opened(browser, server):  # what is compiled first is compiled
        pass
    with browser.new_context(viewport=PHONE, locale="en-GB") as context:  # type: ignore[arg-type]
        page = context.new_page()
        Line(page, throttled=True)
        drawn = first_picture(page, server.address)
    assert len(STEPS) * LATENCY < drawn < PATIENCE


def test_what_was_fetched_once_is_not_fetched_again(browser: Browser, server: Running) -> None:
    with browser.new_context(viewport=PHONE, locale="en-GB") as context:  # type: ignore[arg-type]
        page = context.new_page()
        first_picture(page, server.address)
        line = Line(page)
        page.reload()
        page.wait_for_selector("html[data-drawn]", state="attached")
    again = {url: size for url, size in line.fetched.items() if url.endswith((".css", ".js"))}
    del again[f"{server.address}/words_table.js"]  # which the server makes
    assert max(again.values()) < 1000, again


def test_another_language_is_fetched_once(browser: Browser, server: Running) -> None:
    with opened(browser, server) as it:
        for title in ("見る", "See it", "見る"):
            it.page.get_by_role("button", name="日本語" if title == "見る" else "English").click()
            it.page.wait_for_selector(f"#see-title:text-is('{title}')")
        assert [url.rpartition("/")[2] for url in it.asked if "/words-" in url] == ["words-ja.json"]


def test_a_language_that_was_remembered_comes_before_that_of_the_browser(
    browser: Browser, server: Running
) -> None:
    with opened(browser, server) as it:
        it.page.get_by_role("button", name="日本語").click()
        it.page.wait_for_selector("html[lang=ja]")
        it.page.reload()
        it.settle()
        assert it.page.get_attribute("html", "lang") == "ja"
        assert it.text("#see-title") == "見る"

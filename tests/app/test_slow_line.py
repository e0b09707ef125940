"""The first picture on a slow line: how much is fetched for it, and what is fetched again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from browsing import COMPILING, PHONE

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page
    from serving import Running


MOST_BYTES = 255_000
"""Of the page and of its first runs, which are in space: poses in three axes, and each device by itself."""

LATER = ("icon.svg", "/api/v1/verify", "/api/v1/jobs/", "/ping")


class Line:
    """What a page fetches, with the bytes that came over the line."""

    def __init__(self, page: Page) -> None:
        self._urls: dict[str, str] = {}
        self._sizes: dict[str, int] = {}
        session = page.context.new_cdp_session(page)
        session.on("Network.requestWillBeSent", self._sent)
        session.on("Network.loadingFinished", self._came)
        session.send("Network.enable")

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


def first_picture(page: Page, address: str) -> None:
    """Wait until the first picture is drawn."""
    page.goto(address)
    page.wait_for_selector("html[data-drawn]", state="attached", timeout=COMPILING)


def test_the_first_picture_needs_few_bytes(browser: Browser, server: Running) -> None:
    with browser.new_context(viewport=PHONE, locale="ja-JP") as context:  # type: ignore[arg-type]
        page = context.new_page()
        line = Line(page)
        first_picture(page, server.address)
        fetched = line.fetched
    assert sum(fetched.values()) <= MOST_BYTES, fetched

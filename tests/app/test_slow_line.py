"""The first picture on a slow line: how much is fetched for it, in how many steps one after the other."""

# ruff: noqa: F811 - a fixture is imported, and then asked for by its name
from __future__ import annotations

import base64
import json
from itertools import accumulate
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from browsing import COMPILING, PHONE, browser, opened  # noqa: F401
from page_coverage import start
from serving import SCENE

if TYPE_CHECKING:
    import httpx
    from playwright.sync_api import Browser, Page
    from serving import Running

RATE = 50_000
"""What comes over the line in a second [bytes]."""

LATENCY = 0.4
"""How long a request waits for its answer to begin [s]."""

MOST_BYTES = 107_000
MOST_REQUESTS = 4
STEPS = ["page", "script", "simulation"]
"""What is asked for one after the other; what can be chosen comes beside the script."""

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
def test_the_first_picture_needs_few_bytes_and_three_steps(
    browser: Browser, server: Running, language: str
) -> None:
    with browser.new_context(viewport=PHONE, locale=language) as context:  # type: ignore[arg-type]
        page = context.new_page()
        line = Line(page)
        first_picture(page, server.address)
        fetched = line.fetched
    assert len(fetched) <= MOST_REQUESTS, list(fetched)
    assert sum(fetched.values()) <= MOST_BYTES, fetched
    assert sum(fetched.values()) / RATE + len(STEPS) * LATENCY <= 4.0


def test_the_first_picture_comes_soon_on_a_slow_line(browser: Browser, server: Running) -> None:
    with opened(browser, server):  # what is compiled first is compiled
        pass
    with browser.new_context(viewport=PHONE, locale="en-GB") as context:  # type: ignore[arg-type]
        page = context.new_page()
        line = Line(page, throttled=True)
        drawn = first_picture(page, server.address)
    assert len(line.fetched) <= MOST_REQUESTS, list(line.fetched)
    assert len(STEPS) * LATENCY < drawn < PATIENCE


def test_what_was_fetched_once_is_not_fetched_again(browser: Browser, server: Running) -> None:
    with browser.new_context(viewport=PHONE, locale="en-GB") as context:  # type: ignore[arg-type]
        page = context.new_page()
        first_picture(page, server.address)
        line = Line(page)
        page.reload()
        page.wait_for_selector("html[data-drawn]", state="attached")
    again = {url: size for url, size in line.fetched.items() if "/api/" not in url}
    assert sum(again.values()) < 2000, again


def test_another_language_is_fetched_once(browser: Browser, server: Running) -> None:
    with opened(browser, server) as it:
        for title in ("見る", "See it", "見る"):
            it.page.get_by_role("button", name="日本語" if title == "見る" else "English").click()
            it.page.wait_for_selector(f"#see-title:text-is('{title}')")
        assert [url for url in it.asked if "/words-" in url] == [
            url for url in it.asked if "/words-ja-" in url
        ]
        assert sum("/words-" in url for url in it.asked) == 1


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


def plain(sent: Any) -> Any:
    """Return a reply with numbers in the place of differences."""
    if isinstance(sent, list):
        return [plain(one) for one in sent]
    if not isinstance(sent, dict):
        return sent
    if "second_differences" not in sent:
        return {name: plain(one) for name, one in sent.items()}
    columns = (sent["second_differences"][k :: sent["width"]] for k in range(sent["width"]))
    whole = [list(accumulate(accumulate(column))) for column in columns]
    return [one / 10 ** sent["digits"] for together in zip(*whole, strict=True) for one in together]


def test_differences_give_the_same_numbers_to_the_bit(client: httpx.Client) -> None:
    scene = {**SCENE, "shaking": {**SCENE["shaking"], "building": {"storeys": 6}, "storey": 4}}
    asked = {"scene": scene, "measures": [{"type": "belt"}]}
    usual = client.post("/api/v1/simulate", json=asked)
    short = client.post("/api/v1/simulate", json={**asked, "histories": "differences"})
    assert json.dumps(plain(short.json())) == json.dumps(usual.json())
    assert "second_differences" not in usual.text
    lists = [short.json()["floor"], short.json()["building"], short.json()["with"]]
    assert not any(isinstance(one, list) and len(one) > 500 for each in lists for one in each.values())
    assert len(short.content) < 0.6 * len(usual.content)


def test_differences_in_space_are_what_the_numbers_are(client: httpx.Client) -> None:
    asked = {"scene": {**SCENE, "dimensions": 3}, "measures": []}
    usual = client.post("/api/v1/simulate", json=asked).json()
    answer = client.post("/api/v1/simulate", json={**asked, "histories": "differences"})
    short = plain(answer.json())
    for name in ("place_m", "attitude", "tilt_rad", "slide_m", "yaw_rad"):
        sent = usual["without"]["scene"]["bodies"][0][name]
        numbers = np.frombuffer(base64.b64decode(sent), "<f4")
        assert short["without"]["scene"]["bodies"][0][name] == pytest.approx(numbers, abs=5.1e-6)
    assert list(short["floor"]["acceleration_m_s2"]) == list(usual["floor"]["acceleration_m_s2"])


def test_other_forms_of_histories_are_refused(client: httpx.Client) -> None:
    answer = client.post("/api/v1/simulate", json={"scene": SCENE, "histories": "cubes"})
    assert answer.status_code == 422
    assert answer.json()["field"] == "histories"

"""The page in Chromium: what it says of the chances, and what the user can keep."""

from __future__ import annotations

import csv
import io
import math
import threading
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from browsing import COMPILING, IN_PLANE, PLANE, opened
from serving import hold_verifications

from stayput.app import api
from stayput.scenario import Scenario

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running

    from stayput.verification import Verdict


@pytest.fixture(scope="module")
def verified(browser: Browser, server: Running) -> Iterator[tuple[Opened, dict]]:
    with opened(browser, server, IN_PLANE, verify=True) as it:
        it.page.wait_for_selector("#understand[data-state=done]", timeout=COMPILING)
        assert sum(url.endswith("/verify") for url in it.asked) == 1  # one verification has all that is shown
        job = it.page.get_attribute("#understand", "data-job")
        yield it, it.page.request.get(f"{server.address}/api/v1/jobs/{job}").json()["result"]


def shown(share: float) -> str:
    return f"{100 * share:.0f} %"


def test_the_verdict_has_its_probability(verified: tuple[Opened, dict]) -> None:
    it, verdict = verified
    without = next(one for one in verdict["options"] if not one["measures"])
    overturned = without["probabilities"]["overturned"]
    ends = f"{shown(overturned['low'])[:-2]} to {shown(overturned['high'])}"
    assert f"in {ends} of such earthquakes" in it.text("#verdict")
    assert "With screwed L-brackets" in it.text("#verdict")
    assert it.page.get_attribute("#verdict", "aria-live") == "polite"
    figure = it.page.locator("#tens figure").first
    surely, may = math.floor(10 * overturned["low"]), math.ceil(10 * overturned["high"])
    assert figure.locator(".fell:not(.unsure)").count() == surely
    assert figure.locator(".fell.unsure").count() == may - surely
    assert f"Without measures: {ends} fall" in figure.inner_text().replace("\u00a0", " ")


def test_the_ranking_is_the_verdicts(verified: tuple[Opened, dict]) -> None:
    it, verdict = verified
    rows = it.page.locator("#ranking .option")
    assert rows.count() == len(verdict["options"])
    for i, option in enumerate(verdict["options"]):
        text = rows.nth(i).inner_text()
        assert option["reason"]["en"] in text.replace("\xa0", " ")
        if option["measures"]:
            assert option["label"]["en"] in text
    assert "yours" in it.text("#ranking .yours")
    lengths = it.page.eval_on_selector_all(
        "#ranking .bar", "all => all.map(one => Math.round(one.getBoundingClientRect().width))"
    )
    assert len(set(lengths)) == 1  # one scale for all, the reader's own among them


def test_the_curves_say_where_the_scene_is(verified: tuple[Opened, dict]) -> None:
    it, verdict = verified
    assert "you are here" in it.page.text_content("#fragility svg.chart")
    assert it.page.locator("#fragility .curve.c0").count() >= 1
    assert it.page.locator("#estimates dt").count() == 8
    for words in ("Kaneko and Hayashi", "class S, ground floor", "AC156", "ASCE 43-05", "Peak tilt, median"):
        assert words in it.text("#estimates")
    assert f"{verdict['jma_intensity']:.2f}" in it.page.get_attribute("#fragility svg.chart", "aria-label")


def test_another_language_keeps_everything(verified: tuple[Opened, dict]) -> None:
    it, verdict = verified
    address = it.page.evaluate("location.hash")
    asked = len(it.asked)
    it.speak("ja")
    try:
        assert it.page.get_attribute("html", "lang") == "ja"
        assert it.page.evaluate("location.hash") == address
        assert "倒れます" in it.text("#verdict")
        assert verdict["options"][0]["reason"]["ja"] in it.text("#ranking")
        assert it.text("#presets [aria-pressed=true]").startswith("本棚")
        assert "lang=ja" in it.page.get_attribute("#report", "href")
        assert len(it.asked) == asked  # nothing had to be worked out again
    finally:
        it.speak("en")


def saved(it: Opened, selector: str) -> tuple[str, str]:
    with it.page.expect_download() as found:
        it.page.click(selector)
    return found.value.suggested_filename, Path(found.value.path()).read_text(encoding="utf-8")


def test_what_is_kept(verified: tuple[Opened, dict]) -> None:
    it, verdict = verified
    name, text = saved(it, "#toml")
    scenario = Scenario.parse(tomllib.loads(text))
    assert name == "scenario.toml"
    assert scenario.piece.preset == "bookcase"
    assert scenario.shaking.intensity == 6.25
    name, text = saved(it, "#report")
    assert name.endswith(".html")
    assert "<html" in text
    assert "http://" not in text.replace("http://www.w3.org", "")
    name, text = saved(it, "#table")
    assert len(list(csv.reader(io.StringIO(text)))) >= len(verdict["options"]) + 1
    runs = [list(csv.DictReader(io.StringIO(saved(it, f"#csv-{which}")[1]))) for which in ("without", "with")]
    assert float(runs[0][-1]["tilt_rad"]) > 1.5
    assert abs(float(runs[1][-1]["tilt_rad"])) < 0.1
    it.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    it.page.click("#copy")
    it.page.wait_for_selector("#kept:not(:empty)")
    assert it.page.evaluate("navigator.clipboard.readText()") == it.page.input_value("#address")


def test_a_measure_is_taken_from_the_ranking_and_the_new_verification_stopped(
    verified: tuple[Opened, dict], monkeypatch: pytest.MonkeyPatch
) -> None:
    it, _ = verified
    hold_verifications(monkeypatch)
    row = it.page.locator("#ranking .option", has_text="Belts").first
    asked, _ = it.simulated(lambda: row.get_by_role("button").click())
    assert [one["type"] for one in asked["measures"]] == ["belt"]
    assert it.page.get_by_role("checkbox", name="Belts").is_checked()
    assert it.page.get_attribute("#understand", "data-old") == "true"
    assert it.page.get_attribute("#report", "href") is None
    it.page.wait_for_selector("#understand[data-state=running]")
    it.wait("() => document.getElementById('progress').value > 0")
    with it.page.expect_request(lambda one: one.method == "DELETE" and "/jobs/" in one.url):
        it.page.click("#cancel")
    assert it.text("#state") == "Stopped."
    assert it.page.locator("#verify").is_visible()


def test_a_first_look_has_its_headline_and_its_ranking_of_the_same_runs(
    browser: Browser, server: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    go_on, verify = threading.Event(), api.verify
    looks: list[Verdict] = []

    def held(scenario: Scenario, *, on_verdict: Callable[[Verdict], None], **more: Any) -> Verdict:
        def told(known: Verdict) -> None:
            looks.append(known)
            on_verdict(known)
            assert go_on.wait(COMPILING / 1000)

        return verify(scenario, on_verdict=told, **more)

    monkeypatch.setattr(api, "verify", held)
    with opened(browser, server, PLANE, verify=True) as it:
        it.page.wait_for_selector("#ranking-rough:not([hidden])", timeout=COMPILING)
        assert "runs of each: 4. It may still change" in it.text("#ranking-rough")
        assert it.page.locator("#ranking .option").count() > 3
        assert it.page.get_attribute("#ranking", "data-old") == "false"
        bare = looks[0].without.probabilities["overturned"].text
        assert bare.split(" (")[0] in it.text("#verdict").replace("\xa0", " ")
        assert bare.split(" (")[0] in it.text("#ranking").replace("\xa0", " ")
        assert it.page.get_attribute("#fragility", "data-old") == "true"
        assert it.page.get_attribute("#report", "href") is None
        go_on.set()
        it.page.wait_for_selector("#understand[data-state=done]", timeout=COMPILING)
        assert it.page.locator("#ranking-rough").is_hidden()


def test_what_this_floor_refuses_stands_below_the_ranking_with_the_reason(
    browser: Browser, server: Running
) -> None:
    link = f"{PLANE}&floor=carpet&measures=l_bracket"
    with opened(browser, server, link, verify=True) as it:
        it.go("understand")
        it.wait("() => document.querySelector('#ranking .impossible') !== null")
        assert it.page.locator("#ranking .yours").count() == 1
        told = it.page.locator("#ranking .impossible").all_inner_texts()
        assert [one for one in told if "gel mats" in one and "carpet" in one]

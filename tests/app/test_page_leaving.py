"""The page in Chromium: its jobs and its scene when it is left, comes back, or has to wait for its server."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from browsing import COMPILING, PHONE, PLANE, opened
from serving import hold_verifications

from waiting import wait_until

if TYPE_CHECKING:
    from browsing import Opened
    from playwright.sync_api import Browser, Route
    from serving import Running

    from stayput.app.service import Service


def test_a_page_that_is_left_takes_its_verification_along(
    browser: Browser, server: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    service: Service = server.app.state.service
    hold_verifications(monkeypatch)
    with opened(browser, server) as it:
        it.page.unroute("**/api/v1/verify")
        with it.page.expect_response(
            lambda answer: "/jobs/" in answer.url and answer.json()["done"] > 0, timeout=COMPILING
        ) as found:
            it.page.get_by_label("Height (cm)").fill("175")
        job = found.value.json()
        it.page.goto("about:blank")
        it.asked.remove("about:blank") if "about:blank" in it.asked else None
        wait_until(lambda: service.jobs.get(job["id"]).state != "running")
        assert service.jobs.get(job["id"]).state == "cancelled"


def test_a_job_that_the_server_has_lost_is_begun_again(browser: Browser, server: Running) -> None:
    with opened(browser, server, PLANE, verify=True, allowed=("404",)) as it:
        lost = []

        def lose(route: Route) -> None:
            if lost:
                route.fallback()
            else:
                lost.append(route.request.url)
                route.fulfill(status=404, json={"message": "There is no such job.", "field": None})

        it.page.route("**/api/v1/jobs/*", lose)
        it.page.click("#verify", timeout=COMPILING)
        it.page.wait_for_selector("#understand[data-state=done]", timeout=COMPILING)
        assert lost
        assert "falls over" in it.text("#verdict")


def test_the_page_goes_on_by_itself_when_the_server_is_back(browser: Browser, server: Running) -> None:
    with opened(browser, server, allowed=("Failed to load",)) as it:
        it.page.route("**/api/v1/**", lambda route: route.abort())
        it.page.get_by_label("Height (cm)").fill("150")
        it.page.wait_for_selector("#problem:visible")
        assert "does not answer" in it.text("#problem")
        assert it.page.locator("#away").is_visible()
        assert it.page.get_attribute("#see", "data-old") == "true"
        with it.page.expect_response("**/simulate") as found:  # nobody clicks
            it.page.unroute("**/api/v1/**")
            it.page.route("**/api/v1/verify", lambda route: None)
        (body,) = found.value.json()["without"]["scene"]["bodies"]
        assert max(z for *_, z in body["shape"]["vertices_m"]) == pytest.approx(1.5)
        it.page.wait_for_selector("#problem", state="hidden")
        assert not it.page.locator("#away").is_visible()
        assert it.page.get_attribute("#see", "data-old") == "false"


def test_back_takes_a_change_back(it: Opened) -> None:
    height = it.page.get_by_label("Height (cm)")
    first = height.input_value()
    it.simulated(lambda: it.page.click("#presets button:has-text('Chest')"))
    it.kept("piece=chest")
    # what goes on with the same field, and soon, has one place: here as soon as can be
    it.page.evaluate("(now => { performance.now = () => now; })(performance.now())")
    it.simulated(lambda: height.fill("150"))
    it.kept("height=1.5")
    height.fill("151")
    it.kept("height=1.51")
    it.simulated(lambda: it.page.go_back())
    assert it.text("#presets [aria-pressed=true]") == "Chest of drawers"
    assert height.input_value() not in ("150", "151")
    it.simulated(lambda: it.page.go_back())
    assert it.text("#presets [aria-pressed=true]") == "Bookcase, full"
    assert height.input_value() == first
    it.simulated(lambda: it.page.go_forward())
    assert it.text("#presets [aria-pressed=true]") == "Chest of drawers"


def test_back_shows_the_screen_before_on_a_phone(browser: Browser, server: Running) -> None:
    with opened(browser, server, size=PHONE) as it:
        it.go("scene")
        it.go("understand")
        for screen in ("scene", "see"):
            it.page.go_back()
            it.page.wait_for_selector(f"body[data-screen={screen}]")
            assert it.page.locator(".screen:visible").get_attribute("id") == screen
        assert it.page.get_attribute("#steps [aria-current]", "data-screen") == "see"


def test_care_speed_and_building_are_remembered(it: Opened) -> None:
    it.page.select_option("#precision", "0.25")
    it.page.select_option("#speed", "0.25")
    it.simulated(lambda: it.page.get_by_label("In a building").check())
    it.simulated(lambda: it.page.get_by_role("slider", name="Storeys of the building").fill("14"))
    it.simulated(lambda: it.page.get_by_role("slider", name="On storey").fill("9"))
    it.simulated(lambda: it.page.get_by_label("On the ground").check())
    it.kept("storeys=0")
    it.page.reload()
    it.settle()
    assert it.page.input_value("#precision") == "0.25"
    assert it.page.input_value("#speed") == "0.25"
    asked, _ = it.simulated(lambda: it.page.get_by_label("In a building").check())
    assert asked["scene"]["shaking"]["storey"] == 9
    assert asked["scene"]["shaking"]["building"]["storeys"] == 14


def test_a_care_of_an_older_page_is_the_usual_one(it: Opened) -> None:
    it.page.evaluate("localStorage.setItem('stayput-care', '400')")
    it.page.reload()
    it.settle()
    assert it.page.locator("#precision option:checked").text_content() == "usual"


@pytest.mark.parametrize(
    ("address", "ready", "said"),
    [("", True, "The first picture is being computed."), ("room/", False, "The server is getting ready.")],
)
def test_the_server_is_said_to_compile_only_while_it_does(
    browser: Browser, server: Running, address: str, ready: bool, said: str
) -> None:
    page = browser.new_page(locale="en-GB")
    page.route("**/api/v1/ping", lambda route: route.fulfill(json={"ready": ready, "version": "0"}))
    for never in ("simulate", "room", "verify"):
        page.route(f"**/api/v1/{never}", lambda route: None)
    page.goto(f"{server.address}/{address}")
    page.locator("#wait", has_text=said).wait_for(state="visible")
    page.unroute_all(behavior="ignoreErrors")
    page.close()

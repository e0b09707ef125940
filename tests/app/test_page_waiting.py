"""What both pages say while their first picture is long in coming."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser
    from serving import Running


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

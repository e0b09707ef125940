"""The plan to buy and do: over the API, and on paper, where five pieces fit on one page."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from test_room_api import ROOM, ended

import stayput as sp
from long_cases import long
from stayput.app import api

if TYPE_CHECKING:
    from pathlib import Path

    import httpx
    from playwright.sync_api import Browser
    from serving import Running


@pytest.fixture(scope="module")
def plan() -> sp.ActionPlan:
    shaking = {**ROOM["shaking"], "suite": {"family": "near-fault", "count": 8}}  # enough for a clear effect
    scenario = sp.Scenario.parse({**ROOM, "shaking": shaking, "uncertainty": {"samples": 8}})
    verdict = sp.verify(scenario, changes=False, progress=False)
    return sp.action_plan(verdict, progress=False)


def test_the_plan_of_a_room_that_is_done(
    client: httpx.Client, plan: sp.ActionPlan, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The server's own is made in `test_room_changes.py`."""
    made: list[dict[str, Any]] = []

    def action_plan(_verdict: object, **given: Any) -> sp.ActionPlan:
        made.append(given)
        given["on_progress"](plan.verdict.runs)
        return plan

    monkeypatch.setattr(api, "action_plan", action_plan)
    asked: dict[str, Any] = {"scene": ROOM, "changes": False}
    job = ended(client, client.post("/api/v1/room", json=asked).json())
    address = f"/api/v1/jobs/{job['id']}/plan"
    progress = f"{address}/progress"
    assert client.get(progress).json() == {"made": False, "runs": 0}
    answer = client.get(address)
    assert answer.status_code == 200
    assert answer.headers["content-type"] == "text/html; charset=utf-8"
    assert "script-src" in answer.headers["content-security-policy"]
    assert answer.text == plan.to_html("en")
    assert client.get(address, params={"lang": "ja"}).text == plan.to_html("ja")
    assert client.get(progress).json() == {"made": True, "runs": plan.verdict.runs}
    assert client.get(progress, params={"tatami": "true"}).json() == {"made": False, "runs": 0}
    client.get(address, params={"lang": "ja", "no_drilling": "true"})
    assert [one["no_drilling"] for one in made] == [False, True]
    refused = client.get(address, params={"tatami": "true"})  # this room states its floor
    assert refused.status_code == 422
    assert "room.floor is stated otherwise" in refused.json()["message"]
    assert client.get(address, params={"tatami": "often"}).status_code == 422
    for path in ("plan", "plan/progress"):
        assert client.get(f"/api/v1/jobs/{'0' * 32}/{path}").status_code == 404


PAPERS = ("A4", "Letter")


def pages(opened: Browser, file: Path, paper: str) -> int:
    page = opened.new_page()
    page.goto(file.as_uri())
    printed = page.pdf(format=paper, print_background=True)
    page.close()
    return len(re.findall(rb"/Type\s*/Page\b", printed))


def test_the_card_is_printed_by_a_button_and_leads_back_to_the_room(
    browser: Browser, server: Running, client: httpx.Client
) -> None:
    job = ended(client, client.post("/api/v1/room", json={"scene": ROOM, "changes": False}).json())
    page = browser.new_page()
    wrong = list[str]()
    page.on("console", lambda one: wrong.append(one.text) if one.type == "error" else None)
    page.add_init_script("window.print = () => { document.title = 'printed'; }")
    page.goto(f"{server.address}/api/v1/jobs/{job['id']}/plan#room=abc")
    page.get_by_role("button", name="Print").click()
    assert page.title() == "printed"
    back = page.get_by_role("link", name="Back to the room")
    assert back.evaluate("one => one.href") == f"{server.address}/room/#room=abc"
    page.emulate_media(media="print")
    assert not back.is_visible()
    assert not page.locator("#print").is_visible()
    page.close()
    assert wrong == []


@pytest.mark.parametrize("language", ["ja", *long("en")])
def test_four_pieces_are_on_one_page_and_more_go_on(
    browser: Browser, plan: sp.ActionPlan, tmp_path: Path, language: str
) -> None:
    fixed = next(step for step in plan.steps if step.fix is not None)
    assert fixed.fix is not None
    longest = replace(fixed, instead=fixed.instead or replace(fixed.fix))
    card = tmp_path / "card.html"
    for count, expected in ((4, {1}), (12, {2, 3})):
        replace(plan, steps=(longest,) * count).report(card, language)
        for paper in PAPERS:
            assert pages(browser, card, paper) in expected, (count, paper)

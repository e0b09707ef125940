"""Every kind of measure through all that runs, plans, draws and tells: none may be left out anywhere."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import pytest
from test_room_api import ended

import stayput as sp
from stayput.catalogue import LANGUAGES
from stayput.measures import MEASURES
from stayput.report.summary import rows
from stayput.report.verdict.html import report_html

if TYPE_CHECKING:
    import httpx

SHAKING = {"builtin": "near-fault"}
BOOKCASE = {"preset": "bookcase"}
FEW: dict[str, Any] = {"uncertainty": {"samples": 1}, "room": {"ceiling": {"height": 2.4}}}
IN_A_ROOM: dict[str, Any] = {
    **FEW,
    "plan": {"width": 3.0, "length": 2.5},
    "furniture": [{"name": "shelf", **BOOKCASE, "against": "left_wall", "along": 1.2}],
    "places": [{"kind": "bed", "at": [1.6, 1.2], "heading": 1.5708}],
    "shaking": SHAKING,
}


def test_measures_on_a_lone_piece_are_simulated_verified_and_reported() -> None:
    scene = {
        "dimensions": 2,
        "furniture": BOOKCASE,
        "shaking": SHAKING,
        "measures": [{"type": kind} for kind in MEASURES],
        **FEW,
        "room": {"left_wall": {"gap": 0.02}, **FEW["room"]},
    }
    scenario = sp.Scenario.parse(scene)
    verdict = sp.verify(scenario, levels=[], progress=False)
    assert {option.option.name for option in verdict.options} == {"none", *MEASURES}
    data, table = verdict.to_json(), verdict.to_csv()
    runs = {option.name: scenario.run(option.measures) for option in scenario.options}
    for number, language in enumerate(LANGUAGES):
        reports = html.unescape(report_html(verdict, language)), verdict.to_markdown(language)
        for kind, measure in MEASURES.items():
            label = measure.label[number]
            assert all(label in report for report in reports), kind
            assert {device.kind for device in runs[kind].devices} <= {kind}
            assert (label in str(rows(runs[kind], language))) == bool(runs[kind].devices), kind
            assert kind in data
            assert kind in table


@pytest.mark.parametrize("kind", MEASURES)
def test_a_measure_in_a_room_is_a_step_of_its_plan_on_the_card(client: httpx.Client, kind: str) -> None:
    held = {**IN_A_ROOM, "furniture": [{**IN_A_ROOM["furniture"][0], "measures": [{"type": kind}]}]}
    answer = client.post("/api/v1/room", json={"scene": held, "before": IN_A_ROOM, "changes": False})
    job = ended(client, answer.json())
    if MEASURES[kind].acts_on == "the room":  # a piece in a room has a place instead
        assert "place (at)" in job["error"]["message"]
        return
    assert job["state"] == "done", job["error"]
    for number, language in enumerate(LANGUAGES):
        told, card = (
            client.get(f"/api/v1/jobs/{job['id']}/{path}", params={"lang": language})
            for path in ("report", "plan")
        )
        assert (told.status_code, card.status_code) == (200, 200)
        assert MEASURES[kind].label[number].casefold() in html.unescape(card.text).casefold()

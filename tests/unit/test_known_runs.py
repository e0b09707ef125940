"""Runs of a room that its verdict has made: its plan takes them, and nothing else does."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from planned_room import ROOM

import stayput as sp
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.montecarlo import library
from stayput.report.verdict.exports import write_curves

if TYPE_CHECKING:
    from pathlib import Path


def alone(**tables: Any) -> sp.Scenario:
    """Return the room with the bookcase only."""
    return sp.Scenario.parse({**ROOM, "furniture": ROOM["furniture"][:1], **tables})


def steps(plan: sp.ActionPlan) -> list[Any]:
    return json.loads(plan.to_json())["steps"]


def counts(verdict: sp.Verdict) -> list[tuple[int, int, int]]:
    of_piece = [*verdict.without.probabilities.values()]
    return [(chance.fell, chance.runs, chance.missing) for chance in of_piece]


def verified(scenario: sp.Scenario, **settings: Any) -> sp.Verdict:
    return sp.verify(scenario, changes=False, progress=False, **settings)


def test_a_plan_makes_no_run_again_that_the_verdict_rests_on(monkeypatch):
    """An equal scenario that is another object has no runs yet: its plan makes them all, and is the same."""
    made, traced = list[sp.Scene](), library.trace_draw

    def noted(scene: sp.Scene, *given: Any, **rest: Any) -> Any:
        made.append(scene)
        return traced(scene, *given, **rest)

    monkeypatch.setattr(library, "trace_draw", noted)
    verdict = sp.verify(alone(), progress=False)
    of_verdict = len(made)
    plan = sp.action_plan(verdict, progress=False)
    after_it = len(made) - of_verdict
    anew = sp.action_plan(replace(verdict, scenario=verdict.scenario.model_copy()), progress=False)
    by_itself = len(made) - of_verdict - after_it
    # but those of devices in other numbers than they are bought in
    assert of_verdict / 2 < by_itself - after_it <= of_verdict
    assert steps(plan)
    assert steps(anew) == steps(plan)


class StopError(Exception):
    """Ends a verification."""


def test_runs_that_were_cut_off_are_made_again():
    def stop(*_: int) -> None:
        raise StopError

    right = counts(verified(alone()))
    for _ in range(3):
        scenario = alone()
        with pytest.raises(StopError):
            verified(scenario, on_progress=stop)
        assert counts(verified(scenario)) == right


def test_a_record_that_has_changed_has_other_runs(tmp_path: Path):
    record = tmp_path / "record.csv"
    sp.near_fault().scaled(1.5).write(record)
    scenario = alone(shaking={"record": str(record)})
    strong = verified(scenario)
    sp.near_fault().scaled(0.02).write(record)
    weak = verified(scenario)
    assert strong.without.probabilities["overturned"].fell > 0
    assert weak.without.probabilities["overturned"].fell == 0


def test_rooms_that_are_verified_at_once_keep_to_their_own():
    rooms = [alone(), alone(shaking={**ROOM["shaking"], "intensity": "5-lower"})]
    right = [counts(verified(room.model_copy())) for room in rooms]
    assert right[0] != right[1]
    with ThreadPoolExecutor(4) as pool:
        found = [*pool.map(lambda room: counts(verified(room)), rooms * 4)]
    assert found == right * 4


def test_curves_of_a_room_call_changes_what_its_report_does(tmp_path: Path):
    verdict = sp.verify(alone(), levels=[6.5], progress=False)
    assert any(option.option.moved for option in verdict.options)
    write_curves(verdict, JMA_INTENSITY, tmp_path / "curves")
    drawn = (tmp_path / "curves" / "fragility.svg").read_text(encoding="utf-8")
    assert "Move the" in drawn


@pytest.mark.parametrize("switch", ["no_drilling", "tatami", "plasterboard", "dropped_ceiling"])
def test_what_a_home_is_like_is_true_or_false(switch: str):
    with pytest.raises(sp.InputError, match=f"^{switch} is 'no'; it must be of type bool"):
        sp.action_plan(verified(alone()), progress=False, **{switch: "no"})

"""Measures of a plan: on which studs they are, what the home allows, and why the others were not taken."""

from __future__ import annotations

import html
import json
import math
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from planned_room import ROOM
from test_action_plan import alone, planned, room
from typer.testing import CliRunner

import stayput as sp
from stayput.catalogue import phrase
from stayput.cli import app
from stayput.measures import Belt, LBracket
from stayput.measures.fixing import STUD_PITCH
from stayput.measures.wall import most_on_studs
from stayput.report.room.card import plan_html
from stayput.rooms.purchases import Purchase
from stayput.rooms.step_words import where
from stayput.rooms.steps import Home
from stayput.simulation.placing import placed
from stayput.verification.changes import Change, measures_for, refuse_unheld, with_changes
from stayput.verification.options import TRIED

if TYPE_CHECKING:
    from pathlib import Path


def test_each_set_that_was_tried_and_not_taken_has_a_reason():
    plan = planned(room())
    for step in plan.steps:
        shown = {fix.kinds for fix in (step.fix, step.instead) if fix is not None}
        if shown:
            assert shown | set(plan.not_taken[step.what]) == set(TRIED)
            assert not shown & set(plan.not_taken[step.what])
    page = html.unescape(plan_html(plan)).replace("\xa0", " ")
    reasons = plan.not_taken["bookcase"]
    assert all(why[0] in page for why in reasons.values())
    told = json.loads(plan.to_json())["not_taken"]["bookcase"]
    assert [tuple(one["types"]) for one in told] == [*reasons]


def test_what_cannot_be_mounted_is_not_offered_and_the_reason_is_said():
    scenario = room(
        furniture=ROOM["furniture"][:1],
        room={"floor": "tatami", "ceiling": {"height": 2.4, "construction": "dropped"}},
        windows=[{"wall": "left_wall", "start": 1.5, "width": 1.0}],
    )
    plan = planned(scenario)
    assert not plan.steps or plan.steps[0].fix is None
    reasons = {kinds: why[0] for kinds, why in plan.not_taken["bookcase"].items()}
    assert set(reasons) == set(TRIED)
    assert "do not stick to carpet or tatami" in reasons[("gel_mats",)]
    assert "sinks into a soft floor" in reasons[("wedge_stopper", "tension_pole")]
    assert "dropped ceiling lifts" in reasons[("tension_pole",)]
    assert "door or a window" in reasons[("l_bracket",)]
    rented = planned(alone(), no_drilling=True).not_taken["bookcase"]
    assert rented[("belt",)] == phrase("action_plan.drills")


@pytest.mark.parametrize(
    ("length", "count", "told"),
    [(0.8, 2, "on studs every 455 mm"), (0.8, 3, "every 303 mm"), (0.3, 1, "too narrow for two")],
)
def test_devices_on_the_wall_stand_where_studs_can_be(length: float, count: int, told: str):
    """In the runs as in the words: a multiple of 303 or 455 mm apart, not 0.27 m."""
    piece = {"name": "shelf", "preset": "bookcase", "length": length, "against": "left_wall", "along": 1.9}
    shelf = room(furniture=[piece])
    tried = dict.fromkeys(measures_for(("l_bracket", "belt"), shelf.scene(), 0))
    assert {getattr(measure, "count") for measure in tried} == {min(2, most_on_studs(length))}  # noqa: B009
    for measure in (LBracket(count=count), Belt(count=count)):
        scene = shelf.scene(with_changes(shelf.stated, [Change("shelf", measure)], shelf.names))
        refuse_unheld(scene, 0)
        held = placed(scene)[0].held
        assert held is not None
        places = [element.across for element in held.elements]
        assert len(places) == count
        assert sum(places) == pytest.approx(0.0)
        for apart in np.diff(places):
            assert min(abs(math.remainder(apart, pitch)) for pitch in STUD_PITCH) < 1e-9
        fix: Any = SimpleNamespace(scene=scene, body=0, piece=scene.pieces[0])
        assert told in where(Purchase(measure), fix)[0]


def test_more_devices_than_studs_are_said_to_need_a_strip():
    shelf = room(furniture=[{**ROOM["furniture"][0], "measures": [{"type": "l_bracket", "count": 4}]}])
    scene = shelf.scene()
    fix: Any = SimpleNamespace(scene=scene, body=0, piece=scene.pieces[0])
    assert "strip of wood" in where(Purchase(LBracket(count=4)), fix)[0]


def test_a_home_changes_floor_walls_and_ceiling():
    around = Home(tatami=True, plasterboard=True, dropped_ceiling=True).of(room()).surroundings()
    assert around.floor.surface == "tatami, along the weave"
    assert around.left_wall is not None
    assert around.left_wall.construction == "plasterboard"
    assert around.ceiling == sp.Ceiling(2.4, construction="dropped")
    assert Home(no_drilling=True).of(room()) == room()
    for stated, home in (
        ({"floor": "wood flooring"}, Home(tatami=True)),
        ({"walls": "stud"}, Home(plasterboard=True)),
        ({"ceiling": {"height": 2.4, "construction": "joist"}}, Home(dropped_ceiling=True)),
    ):
        (key,) = stated
        with pytest.raises(sp.InputError, match=rf"asked for, but room\.{key}\S* is stated otherwise"):
            home.of(room(room=stated))
    on_tatami = room(room={"floor": "tatami, across the weave"})
    assert Home(tatami=True).of(on_tatami).surroundings().floor.surface == "tatami, across the weave"


@pytest.mark.parametrize("stated", ["", 'floor = "wood flooring"\n'])
def test_the_command_line_verifies_the_home_that_is_said_or_refuses_it(tmp_path: Path, stated: str):
    """No gel mats are advised beside a plan that is made for tatami."""
    file, out = tmp_path / "room.toml", tmp_path / "plan.html"
    file.write_text(
        "[plan]\nwidth = 3.6\nlength = 2.7\n[[furniture]]\nname = 'shelf'\npreset = 'bookcase'\n"
        "against = 'left_wall'\nalong = 1.35\n[shaking]\nbuiltin = 'near-fault'\n"
        f"[uncertainty]\nsamples = 2\n[room]\n{stated}",
        encoding="utf-8",
    )
    done = CliRunner().invoke(app, ["verify", str(file), "--card", str(out), "--tatami", "--json"])
    if stated:
        assert done.exit_code == 2
        assert "room.floor is stated otherwise" in " ".join(done.output.split())
    else:
        assert done.exit_code == 0, done.output
        assert "gel_mats" not in done.stdout
        assert "tatami floor" in out.read_text(encoding="utf-8")

"""Verifications of several pieces: options, draws, what is counted, and what is written."""

from __future__ import annotations

import csv
import io
import json
import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput.catalogue import say
from stayput.model.room import SURFACES
from stayput.model.soft_base import rigid_half_base
from stayput.montecarlo.counting import Member
from stayput.montecarlo.sampling import draws
from stayput.montecarlo.scene_draws import SceneDraw, SceneDraws, drawn_scene
from stayput.montecarlo.scenes import replay
from stayput.report.verdict.assumptions import assumptions, settlement_assumptions
from stayput.scenario import Scenario
from stayput.simulation.placing import placed
from stayput.uncertainty import USUAL
from stayput.verification.option_runner import drawn_run
from stayput.verification.options import compared_options

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.verification import Verdict

VASE: dict[str, Any] = {"name": "vase", "bottom": 0.1, "top": 0.18, "height": 0.3, "mass": 1.5}


def box(name: str, width: float, height: float, mass: float, **more: Any) -> dict[str, Any]:
    return {"name": name, "width": width, "length": 0.9, "height": height, "mass": mass, **more}


FRICTION = {"static_friction": 0.6, "kinetic_friction": 0.5}
DRESSER: dict[str, Any] = {
    "title": "Two parts",
    **FRICTION,
    "furniture": [
        box("lower", 0.45, 0.9, 60.0),
        box("upper", 0.3, 1.1, 40.0, on="lower", at=[-0.05, 0.0]),
        {**VASE, "on": "upper"},
    ],
    "joints": [
        {"first": "upper", "second": "lower", "at": [-0.19, y, 0.9], "strength": 2000.0, "shear": 2000.0}
        for y in (-0.4, 0.4)
    ],
    "room": {"floor": FRICTION, "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.6}},
    "shaking": {"sine": {"amplitude": 5.5, "frequency": 0.8, "duration": 3.0}},
    "uncertainty": {"samples": 2},
}
SLOW = {"amplitude": 2.5, "frequency": 1.5, "duration": 3.0}


def drawn_of(scenario: Scenario, motion: int = 0, number: int = 0) -> SceneDraw:
    draws = SceneDraws(scenario, motion + 1)
    return draws.draw(motion, number, draws.streams(range(len(scenario.pieces))))


DRAW = drawn_of(Scenario.parse({**DRESSER, "uncertainty": {"seed": 2}}))


def option(name: str, piece: str, measure: str) -> dict[str, Any]:
    return {"name": name, "measures": {piece: [{"type": measure}]}}


def parsed(**changed: Any) -> Scenario:
    return Scenario.parse({**DRESSER, **changed})


@pytest.fixture(scope="module")
def verdict() -> Verdict:
    return sp.verify(parsed(), threads=2, progress=False)


@pytest.mark.parametrize(
    ("shape", "told"),
    [
        ({"length": 0.3, "width": 0.3}, ("nothing else was compared, as none", "どの案も設置できないため")),
        ({"bottom": 0.3, "top": 0.3}, ("without joints and measures.", "家具のいずれかが")),
    ],
)
def test_without_another_option_nothing_is_said_of_those_compared(
    shape: dict[str, float], told: tuple[str, str]
) -> None:
    one = {"name": "one", "bottom": 0.6, "top": 0.6, "height": 0.8, "mass": 40.0}
    two = {"name": "two", "height": 1.8, "mass": 40.0, "on": "one", **shape}
    made = parsed(furniture=[one, two], joints=[], room={"floor": FRICTION})
    found = sp.verify(made, threads=2, progress=False)
    for language, part in zip(("en", "ja"), told, strict=True):
        assert part in found.sentence(language)


def test_the_usual_options() -> None:
    options, rejected = compared_options(parsed())
    names = [option.name for option in options]
    kinds = ["l_bracket", "belt", "tension_pole", "gel_mats"]
    assert names == ["none", "joined", "l_bracket", *(f"joined + {kind}" for kind in kinds)]
    assert not rejected
    bracket = options[2]
    assert [len(measures) for measures in bracket.on] == [0, 1, 0]
    assert not bracket.joined
    assert bracket.label(parsed().names)[0] == "Screwed L-brackets on upper"
    without = {key: value for key, value in DRESSER.items() if key != "joints"}
    unjoined, _ = compared_options(Scenario.parse(without))
    assert [option.name for option in unjoined] == ["none", *kinds]


def test_options_of_a_file() -> None:
    both, mats = option("both", "upper", "belt"), option("mats between", "upper", "gel_mats")
    options, rejected = compared_options(parsed(options=[both, mats]))
    assert [option.name for option in options] == ["none", "both"]
    assert options[1].joined
    assert rejected[0].why("en").startswith("'upper': Adhesive gel mats belong on the floor")
    with pytest.raises(sp.InputError, match="belong on the floor"):
        compared_options(parsed(options=[mats]))


def test_measures_of_a_piece_are_in_place_as_stated() -> None:
    furniture = [dict(piece) for piece in DRESSER["furniture"]]
    furniture[1]["measures"] = [{"type": "l_bracket"}]
    scenario = parsed(furniture=furniture)
    assert [option.name for option in compared_options(scenario)[0]] == ["none", "joined", "as stated"]
    assert {device.kind for device in scenario.run().devices} == {"l_bracket", "joint"}
    assert Scenario.parse(DRESSER | {"furniture": furniture}).to_toml() == scenario.to_toml()


@pytest.mark.parametrize("plan", [{}, {"plan": {"width": 8.0, "length": 8.0}}], ids=["no plan", "plan"])
def test_options_are_compared_with_what_simulate_runs(plan: dict[str, Any]) -> None:
    """What pieces state stays in the baseline, and in options that do not name the piece."""
    cart = box("cart", 0.5, 0.8, 40.0, at=[2.0, 2.0], measures=[{"type": "free_casters"}])
    chest = box("chest", 0.45, 1.0, 60.0, at=[6.0, 6.0])
    named = [option("glides", "chest", "felt_glides"), {"name": "no casters", "measures": {"cart": []}}]
    scenario = Scenario.parse(
        {
            "furniture": [cart, chest],
            "shaking": {"sine": SLOW},
            "direction": 0.0,
            "options": named,
            "uncertainty": {"samples": 1, "as_stated": list(USUAL)},
            **plan,
        }
    )
    verdict, stated = sp.verify(scenario, progress=False), scenario.run()
    slides = {name.option.name: name.pieces[0].slide.median for name in verdict.options}
    assert verdict.without.option.name == "as stated"
    assert slides["as stated"] == slides["glides"] == pytest.approx(stated["cart"].peak_slide)
    assert slides["no casters"] < 1e-3 < 0.02 < slides["as stated"]
    assert "without joints" not in verdict.sentence()
    free = "The room as it is" if plan else "As stated: Casters, free on cart"
    assert [verdict.label(verdict.without), verdict.without.devices] == [free, ()]
    assert free in verdict.to_json()
    with pytest.raises(sp.InputError, match="that of the option with what the pieces themselves state"):
        Scenario.parse(scenario.stated_keys() | {"options": [{"name": "As stated"}]})


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"options": [option("x", "y", "belt")]}, "must be one of .lower., .upper., .vase."),
        ({"options": [option("x", "vase", "belt")]}, "preset"),
        (
            {"options": [{"name": "x"}, {"name": "y"}, {"name": "x"}]},
            r"^options\[2\].name is 'x'; it must not be that of options\[0\]",
        ),
        ({"options": [{"name": "é"}, {"name": "E\u0301 "}]}, r"^options\[1\].name is .*must not be that"),
        ({"options": [{"name": " "}]}, r"^options\[0\].name is ' '; it must be a text .* not only spaces"),
        ({"options": [{"name": "none"}]}, "must not be that of the option with nothing in place"),
    ],
)
def test_what_a_file_may_not_say(changed: dict[str, Any], said: str) -> None:
    with pytest.raises(sp.InputError, match=said):
        Scenario.parse({**DRESSER, "joints": [], **changed})


def test_draws_of_a_piece_depend_on_its_kind_alone() -> None:
    single = draws(2, 3, seed=1)
    two = DRESSER["furniture"][:2]
    pieces = [*two, {**DRESSER["furniture"][2], "on": "upper"}, {**two[1], "name": "copy", "at": [2.0, 0.0]}]
    pieces[3].pop("on", None)
    several = parsed(furniture=pieces, joints=[])
    for motion, number in np.ndindex(2, 3):
        draw = drawn_of(several, motion, number)
        fewer = drawn_of(parsed(furniture=two, joints=[]), motion, number)
        assert draw.pieces[:2] == fewer.pieces
        assert draw._replace(pieces=()) == fewer._replace(pieces=())
        assert replace(draw.pieces[0], lean=draw.lean) == single[motion][number]
        assert len({piece.friction for piece in draw.pieces}) == 1
        # a copy that runs together with its like has a mass of its own, one by itself the same
        assert len({piece.mass for piece in draw.pieces}) == 4
        draws_of_kinds = SceneDraws(several, motion + 1)
        assert draws_of_kinds.streams([1]) == draws_of_kinds.streams([3]) != draws_of_kinds.streams([0])
    stated = drawn_of(parsed(uncertainty={"as_stated": ["mass", "friction"]}))
    assert all(piece.mass == 1.0 for piece in stated.pieces)
    assert stated.between == 1.0
    assert stated.joints == drawn_of(parsed()).joints != 1.0


def test_what_is_drawn() -> None:
    scenario = parsed()
    draw = DRAW
    drawn = drawn_scene(scenario.scene(compared_options(scenario)[0][1]), draw)
    lower, upper, vase = drawn.pieces
    assert lower.body.mass == pytest.approx(60.0 * draw.pieces[0].mass)
    assert lower.body.base_insets[0] > 0.0
    assert upper.body.mass == pytest.approx(40.0 * draw.pieces[1].mass)
    assert upper.body.base_insets == (0.0, 0.0)
    assert vase.solid.mass == pytest.approx(1.5 * draw.pieces[2].mass)
    assert drawn.joints[0].strength == pytest.approx(2000.0 * draw.joints)
    assert drawn.friction[0] == pytest.approx(0.6 * draw.between)


def test_pieces_on_the_floor_sink_in_as_drawn_and_as_stated() -> None:
    """The lower part has the narrower base, of which the length is looked at: the depth has drawn insets."""
    scenario = parsed(room={"floor": "carpet"})
    scene = scenario.scene(compared_options(scenario)[0][1])
    for standing, factor in (
        (scenario.scene(), 1.0),
        (scene, 1.0),
        (drawn_scene(scene, DRAW), DRAW.room.settlement),
    ):
        lower, upper, vase = placed(standing)
        feet = lower.piece.solid.feet
        assert feet is not None
        z = lower.piece.solid.centre_of_gravity[2]
        half_length = float(rigid_half_base(0.45, z, factor * SURFACES["carpet"].settlement))
        assert np.abs(feet[:, 1]) == pytest.approx(half_length, rel=1e-12)
        assert upper.piece.solid.feet is None
        assert vase.piece.solid.feet is None
    assert [piece.body.shape is None for piece in parsed().scene().pieces] == [True, True, False]


def test_what_a_soft_floor_leaves_out_is_said() -> None:
    alone = {"name": "drum", "diameter": 0.3, "height": 0.7, "mass": 5.0, "at": [3.0, 0.0]}
    box, carried = DRESSER["furniture"][0], DRESSER["furniture"][1]

    def said(furniture: list[dict[str, Any]], floor: str) -> list[str]:
        scenario = parsed(furniture=furniture, joints=[], room={"floor": floor})
        return [one.value[0] for one in settlement_assumptions(scenario)]

    solids, stacks = "Left out for round pieces and meshes", "A piece that carries others sinks in"
    assert said([box], "carpet") == []
    (only,) = said([box, alone], "carpet")
    assert only.startswith(solids)
    (only,) = said([box, carried], "carpet")
    assert only.startswith(stacks)
    assert len(said([box, carried, alone], "tatami, along the weave")) == 2
    assert said([box, carried, alone], "locked caster") == []


def test_assumptions_are_of_what_is_there() -> None:
    """No friction between pieces of one piece, and nothing of walls that no device is fixed to."""
    fixing, between = "What devices are fixed to in the wall behind", "Friction between the pieces"

    def tags(**changed: Any) -> dict[str, str]:
        few = {"uncertainty": {"samples": 1}, "shaking": {"builtin": "near-fault", "scale": 0.01}}
        scenario = Scenario.parse({**DRESSER, **few, **changed})
        if scenario.plan is None:
            return {one.what[0]: one.confidence for one in assumptions(sp.verify(scenario))}
        verdict = sp.verify(scenario, changes=False)
        return {one.what[0]: one.confidence for one in assumptions(verdict)}

    drum = {"name": "drum", "diameter": 0.3, "height": 0.7, "mass": 5.0}
    alone = {"furniture": drum, "joints": [], "room": {"left_wall": {"gap": 0.1}}}
    assert tags(**alone).keys().isdisjoint({fixing, between})
    assert tags()[between] == "given"
    assert fixing in tags()
    by_default = tags(static_friction=0.4, kinetic_friction=0.3)
    assert by_default[between] == "given"  # as the file says it, though it is the default
    plan: dict[str, Any] = {"plan": {"width": 3.0, "length": 3.0}, "joints": [], "room": {}}
    piece = {**drum, "at": [1.5, 1.5]}
    assert tags(**plan, furniture=[piece]).keys().isdisjoint({fixing, between})


def test_a_bracket_that_reaches_the_wall_does_in_every_draw() -> None:
    scenario = parsed(room={**DRESSER["room"], "left_wall": {"gap": 0.1}})
    bracket = next(one for one in compared_options(scenario)[0] if one.name == "l_bracket")
    scene = scenario.scene(bracket)
    drawn = [drawn_of(scenario, number=number) for number in range(16)]
    gaps = [drawn_scene(scene, draw).room.left_wall.gap for draw in drawn]
    # the upper part's back is 2.5 cm nearer to the room than the lower one's
    assert max(gaps) == pytest.approx(0.15 - 0.025)
    assert min(gaps) < 0.1


def test_a_verdict(verdict: Verdict) -> None:
    assert verdict.runs == 2 * 7
    assert verdict.scenario.counted == (0, 1)
    assert verdict.without.probabilities["overturned"].estimate > 0.6
    assert verdict.best is verdict.without  # two runs show no clear difference
    assert min(option.probabilities["overturned"].estimate for option in verdict.options) == 0.0
    assert "furniture overturns" in verdict.sentence("en")
    assert "家具のいずれかが" in verdict.sentence("ja")
    joined = next(one for one in verdict.options if one.option.name == "joined")
    assert [device.pieces for device in joined.devices] == [("upper", "lower")] * 2
    assert joined.devices[0].peak.median > 0.0
    for option in verdict.options:
        falls = [piece.probabilities["overturned"].fell for piece in option.pieces[:2]]
        assert max(falls) <= option.probabilities["overturned"].fell <= sum(falls)


def test_a_piece_has_the_runs_that_it_has_alone_with_what_cannot_reach_it() -> None:
    near, far = box("near", 0.3, 1.2, 30.0), box("far", 0.4, 1.0, 40.0, at=[0.0, 30.0], heading=1.5)
    options = [option("sheet", "near", "anti_slip_sheet")]
    same: dict[str, Any] = {"joints": [], "room": {}, "options": options, "shaking": {"sine": SLOW}}
    verdicts = [
        sp.verify(parsed(furniture=pieces, **same), progress=False) for pieces in ([near], [near, far])
    ]
    for name in ("none", "sheet"):
        runs = [
            next(piece for piece in option.pieces if piece.name == "near")
            for verdict in verdicts
            for option in verdict.options
            if option.option.name == name
        ]
        assert len({(run.slide, run.tilt) for run in runs}) == 1
        assert math.isfinite(runs[0].tilt.p90)


def test_a_run_made_again_has_the_motion_that_shook_it() -> None:
    scenario = parsed(direction=math.pi / 2.0)
    motion = parsed().motion()
    run = replay(scenario, scenario.scene(), Member(0, 0), motion, 1.0)
    assert run.motion.y is not None
    assert (np.ptp(run.motion.x), np.ptp(run.motion.y)) == pytest.approx((0.0, np.ptp(motion.x)), abs=1e-9)
    assert np.ptp(run.place[0, :, 1]) > 5.0 * np.ptp(run.place[0, :, 0])


def test_a_sweep_has_what_a_run_says_of_what_fell_too() -> None:
    run, swept = parsed().run(), sp.sweep(parsed(), {"gravity": [9.80665]}, progress=False)
    assert any(piece.overturned for piece in run.pieces)
    for name in ("peak_slide", "residual_slide", "peak_tilt", "residual_tilt", "wall_impacts"):
        for piece in run.names:
            assert swept[name].sel(piece=piece).item() == getattr(run[piece], name)


def test_a_sweep_of_a_single_piece_has_no_dimension_of_pieces() -> None:
    swept = sp.sweep(parsed(furniture=[VASE], joints=[]), {"gravity": [9.0, 9.8]}, progress=False)
    assert swept.peak_tilt.dims == ("gravity",)


def test_the_bits_do_not_depend_on_threads() -> None:
    scenario = parsed(options=[{"name": "joined"}])
    first, second = (sp.verify(scenario, threads=threads, progress=False) for threads in (1, 2))
    for mine, theirs in zip(first.options, second.options, strict=True):
        assert mine.pieces == theirs.pieces
        assert mine.devices == theirs.devices


def test_runs_are_made_again(verdict: Verdict) -> None:
    run = drawn_run(verdict.scenario, verdict.without.option, verdict.without.worst)
    assert any(piece.overturned for piece in run.pieces[:2]) == (
        verdict.without.probabilities["overturned"].fell > 0
    )
    assert np.isfinite(run.place).all()


def test_what_is_written(verdict: Verdict, tmp_path: Path) -> None:
    data = json.loads(verdict.to_json())
    ranks = [option["rank"] for option in data["options"]]
    assert (len(ranks), ranks[0], ranks) == (7, 1, sorted(ranks))
    assert [piece["counts"] for piece in data["options"][0]["pieces"]] == [True, True, False]
    rows = list(csv.DictReader(io.StringIO(verdict.to_csv())))
    assert len(rows) == 7
    assert "0.0" in {row["overturned"] for row in rows}
    page = verdict.report(tmp_path / "ja.html", "ja").read_text(encoding="utf-8")
    assert page.count("<iframe") == 2  # of the pieces as they are, since nothing clearly helps
    assert verdict.sentence("ja") in page
    assert say("several.rolling_text", "ja") in page  # of the vase
    for language in ("en", "ja"):
        assert verdict.sentence(language).split("(")[0] in verdict.to_markdown(language).replace("\\", "")


def test_curves_of_several_are_asked_for() -> None:
    levels = [3.0, 6.8]
    found = sp.verify(parsed(options=[option("belts", "upper", "belt")]), levels=levels, progress=False)
    assert found.runs == len(found) * 2 * (1 + len(levels))
    for one in found.options:
        jma, *_ = one.curves.values()
        assert len(jma.levels) == 1 + len(levels)
        assert jma.levels[-1].probability.estimate >= jma.levels[0].probability.estimate


def test_badly_installed_measures_of_several_are_told() -> None:
    held = {"options": [option("belts", "upper", "belt")]}
    found = sp.verify(parsed(**held, uncertainty={"samples": 2, "installation": 0.4}), progress=False)
    belts = next(one for one in found.options if one.option.name == "belts")
    assert belts.installed is not None
    assert belts.installed.share == 0.4
    assert found.without.installed is None

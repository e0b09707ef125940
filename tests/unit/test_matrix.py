"""What a scene may be and have: each thing with one piece, with three, and in a room with people."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput.measures import LBracket
from stayput.measures.floor import OtherFriction
from stayput.montecarlo.scene_draws import SceneDraws

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

SHAKING: dict[str, Any] = {"sine": {"amplitude": 4.0, "frequency": 1.5, "duration": 2.0}}
CHEST: dict[str, Any] = {"preset": "chest"}
OTHERS: list[dict[str, Any]] = [
    {"name": "crate", "width": 0.4, "length": 0.6, "height": 0.5, "mass": 20.0, "at": [2.0, 0.5]},
    {"name": "drum", "diameter": 0.4, "height": 0.8, "mass": 15.0, "at": [2.0, 2.0]},
]
PLAN: dict[str, Any] = {
    "plan": {"width": 3.6, "length": 3.0},
    "places": [{"kind": "bed", "at": [1.2, 1.5], "day": 0.1, "night": 0.9}],
    "doors": [{"wall": "right_wall", "start": 0.3}],
}
SCENES = ("one", "three", "room")


def scene(kind: str, piece: dict[str, Any], **tables: Any) -> dict[str, Any]:
    common: dict[str, Any] = {"shaking": SHAKING, "uncertainty": {"samples": 2}} | tables
    if kind == "one":
        return {"furniture": CHEST | piece} | common
    if kind == "three":
        return {"furniture": [{**CHEST, "name": "chest"} | piece, *OTHERS]} | common
    against = {**CHEST, "name": "chest", "against": "near_side_wall", "along": 0.9} | piece
    return {"furniture": [against, *OTHERS]} | PLAN | common


def verified(scenario: sp.Scenario) -> Any:
    return sp.verify(scenario, changes=False, levels=[], progress=False)


@dataclass(frozen=True)
class Stated:
    """Keys of a piece or of the file; where a scene has no use for them, the sentence that says so."""

    piece: dict[str, Any]
    tables: dict[str, Any]
    refused: dict[str, str]


def stated(
    piece: dict[str, Any] | None = None, refused: dict[str, str] | None = None, **tables: Any
) -> Stated:
    return Stated(piece or {}, tables, refused or {})


LONE = "is given where furniture is not one preset or box"
OF_ONE = {"three": LONE, "room": LONE}
BUILDING: dict[str, Any] = {"storeys": 3, "structure": "RC"}
OF_DRAWS = "as stated", "badly installed"
"""Features that change no run of what the file states."""

FEATURES = {
    "a preset of another size": stated({"height": 1.6}),
    "shelves": stated({"preset": "empty bookcase", "shelves": [10.0, 5.0]}),
    "a centre off the middle": stated({"cg_offset": [0.02, -0.1]}),
    "inertia": stated({"inertia": 12.0}),
    "uneven feet": stated({"base_heights": [0.0, -0.004], "base": "feet"}),
    "a soft floor": stated(room={"floor": "carpet"}),
    "contents": stated(refused=OF_ONE, contents={"kind": "dishes", "doors": "hinged"}),
    "drawers": stated(refused=OF_ONE, contents={"kind": "books", "drawers": "catches"}),
    "badly installed": stated(uncertainty={"samples": 2, "installation": 0.3}),
    "everyday": stated(refused=OF_ONE, everyday={"drawers": 2}),
    "as stated": stated(uncertainty={"samples": 2, "as_stated": ["mass", "friction"]}),
    "initial state": stated(refused=OF_ONE, initial={"tilt": 0.02}),
    "gravity": stated(gravity=3.7),
    "isolation": stated(
        shaking={**SHAKING, "building": {"storeys": 3, "structure": "base-isolated"}, "storey": 2}
    ),
    "no vertical shaking": stated(shaking={"builtin": "near-fault", "vertical": False}),
    "a storey of a building": stated(shaking={**SHAKING, "building": BUILDING, "storey": 3}),
    "a direction": stated(direction=0.7),
    "joints": stated(
        refused={"one": "joints"},
        joints=[{"first": "crate", "second": "drum", "at": [2.0, 0.8, 0.4], "to": [2.0, 1.8, 0.4]}],
    ),
    "places of people": stated(
        refused={"one": "places is given without plan", "three": "places is given without plan"},
        places=[{"kind": "desk", "at": [1.2, 1.5], "day": 0.5}],
    ),
}


@pytest.mark.parametrize("kind", SCENES)
@pytest.mark.parametrize("feature", FEATURES.values(), ids=FEATURES)
def test_it_runs_and_is_verified_or_is_refused_in_a_sentence(feature: Stated, kind: str) -> None:
    tables = scene(kind, feature.piece, **feature.tables)
    if kind in feature.refused:
        with pytest.raises(sp.InputError, match=feature.refused[kind]):
            sp.Scenario.parse(tables)
        return
    scenario = sp.Scenario.parse(tables)
    scenario.run()
    assert verified(scenario).to_json()
    again = sp.Scenario.parse(tomllib.loads(scenario.to_toml()))
    assert again.stated_keys() == scenario.stated_keys()


def test_keys_change_the_answer() -> None:
    """Each key of a piece and of the scene moves what the chest does, in every scene."""
    keys = [name for name, feature in FEATURES.items() if not feature.refused and name not in OF_DRAWS]
    for kind in SCENES:
        plain = first_place(sp.Scenario.parse(scene(kind, {})))
        for name in keys:
            changed = first_place(
                sp.Scenario.parse(scene(kind, FEATURES[name].piece, **FEATURES[name].tables))
            )
            assert changed.shape != plain.shape or not np.array_equal(changed, plain), (kind, name)


def first_place(scenario: sp.Scenario) -> Any:
    run: Any = scenario.run()
    return run.place[0]


class Rubber(OtherFriction):
    """A measure of one's own."""


def own_motions(scenario: sp.Scenario) -> sp.Scenario:
    return scenario.with_python(motions=sp.synthetic_suite("near-fault", 2).to_intensity(5.0))


def on_isolators(scenario: sp.Scenario) -> sp.Scenario:
    building = sp.Building(3, "base-isolated", isolation=sp.Isolation(period=3.0))
    shaking = {**SHAKING, "building": building, "storey": 2}
    return sp.Scenario.parse(scenario.stated_keys() | {"shaking": shaking})


def own_quantities(scenario: sp.Scenario) -> sp.Scenario:
    return scenario.with_python(quantities=sp.Uncertainty({"mass": sp.Uniform(2.0, 2.1)}))


@pytest.mark.parametrize("kind", SCENES)
@pytest.mark.parametrize("changed", [own_motions, own_quantities, on_isolators])
def test_python_objects_in_the_place_of_tables(
    changed: Callable[[sp.Scenario], sp.Scenario], kind: str, tmp_path: Path
) -> None:
    scenario = changed(sp.Scenario.parse(scene(kind, {})))
    verdict = verified(scenario)
    again = type(verdict).load(verdict.save(tmp_path / "verdict.json"))
    assert again.to_json() == verdict.to_json()
    assert "# " in scenario.to_toml()


def test_own_quantities_are_drawn_for_every_piece() -> None:
    draws = SceneDraws(own_quantities(sp.Scenario.parse(scene("three", {}))), 1)
    streams = draws.streams(range(3))
    drawn = [draws.draw(0, number, streams) for number in range(4)]
    assert all(2.0 <= piece.mass <= 2.1 for draw in drawn for piece in draw.pieces)


@pytest.mark.parametrize("kind", SCENES)
def test_a_run_and_a_sweep_are_saved_shown_and_filmed(kind: str, tmp_path: Path) -> None:
    scenario = sp.Scenario.parse(scene(kind, {}))
    run: Any = scenario.run()
    again = type(run).load(run.save(tmp_path / "run.nc"))
    assert repr(again) == repr(run)
    assert "<img" in run._repr_html_()
    assert run.animate(tmp_path / "run.html").stat().st_size > 10_000
    swept = sp.sweep(scenario, {"shaking.sine.amplitude": [1.0, 4.0]}, progress=False)
    assert np.all(swept.peak_slide[0] <= swept.peak_slide[1])


@pytest.mark.parametrize("kind", SCENES)
def test_parts_and_measures_of_a_piece(kind: str) -> None:
    """A body of parts, which only Python makes, held by brackets, alone and among others."""
    parts = [sp.Part(40.0, 0.0, 0.6, 0.3, 1.2), sp.Part(30.0, 0.02, 0.2)]
    loaded = sp.Body.from_parts(0.4, 1.2, parts)
    body = sp.Body(0.4, 1.2, loaded.mass, loaded.cg_offset, loaded.inertia, length=0.9)
    room, motion = sp.Room(left_wall=sp.Wall(0.02)), sp.near_fault()
    free, held = (
        sp.simulate(body, room, motion, measures)
        if kind == "one"
        else sp.simulate(
            sp.Scene([sp.Piece(body, at=(0.0, 2.0 * n, 0.0), measures=measures) for n in range(3)], room),
            motion,
        )
        for measures in ([], [LBracket()])
    )
    slides = [max(piece.peak_slide for piece in run.pieces) for run in (held, free)]
    assert slides[0] < slides[1]

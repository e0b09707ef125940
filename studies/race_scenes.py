"""Scenes of which all options run 800 times: ``python -m studies.race_scenes [SCENE ...]``, hours on a core.

What became of the runs goes to `studies.races.RECORDED`, beside that of other scenes.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np

import stayput as sp
from stayput.montecarlo.counting import SLIDE_LIMIT, Members
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.montecarlo.scenes import ENERGY
from stayput.verification.option_runner import OptionRunner
from stayput.verification.options import compared_options
from stayput.verification.people import hits_in
from stayput.verification.search import tried_options
from studies.races import BESIDE, RECORDED, RUNS_BESIDE

EXAMPLES = Path(__file__).parents[1] / "examples"

MOTIONS, DRAWS = 400, 2
"""Motions of a scene, and draws of each."""

CHANGES, PART = 9, 80
"""Single changes of a room that are run, and runs between which memory is freed."""

OF_ONE_MOTION = ("member", "builtin", "scale")
"""Keys of ``[shaking]`` that choose a motion, and its strength."""

ROOM = {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}}
CONCRETE = {"static_friction": 0.7, "kinetic_friction": 0.6}
BOARD = {
    "left_wall": {"gap": 0.02, "construction": "plasterboard"},
    "ceiling": {"height": 2.4, "construction": "plasterboard"},
}


def lone(preset: str, intensity: str, room: dict[str, Any] | None = None, **shaking: Any) -> dict[str, Any]:
    """Return a piece before a wall with all usual measures."""
    shaken = {"intensity": intensity, **shaking}
    return {"furniture": {"preset": preset}, "room": {**ROOM, **(room or {})}, "shaking": shaken}


def storeys(count: int, structure: str, storey: int) -> dict[str, Any]:
    """Return where in a building a piece stands."""
    return {"building": {"storeys": count, "structure": structure}, "storey": storey}


SHELF_AND_BED: dict[str, Any] = {
    "plan": {"width": 3.0, "length": 2.5},
    "room": {"floor": "wood flooring", "ceiling": {"height": 2.4}},
    "furniture": [
        {"name": "shelf", "preset": "bookcase", "against": "left_wall", "along": 1.0},
        {"name": "chest", "preset": "chest", "against": "right_wall", "along": 0.6},
    ],
    "places": [{"kind": "bed", "at": [1.5, 1.0], "heading": 1.5708}],
    "shaking": {"intensity": "6-upper"},
}

OFFICE: dict[str, Any] = {
    "plan": {"width": 5.0, "length": 4.0},
    "furniture": [
        {"name": "bookcase 1", "preset": "bookcase", "against": "left_wall", "along": 1.1},
        {"name": "bookcase 2", "preset": "bookcase", "against": "left_wall", "along": 2.3},
        {"name": "bookcase 3", "preset": "bookcase", "against": "far_side_wall", "along": 2.0},
        {"name": "machine", "preset": "vending machine", "against": "right_wall", "along": 3.0},
        {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 2.0},
    ],
    "places": [{"kind": "desk", "at": [1.5, 1.4]}, {"kind": "desk", "name": "desk 2", "at": [3.6, 1.5]}],
    "room": {"floor": "vinyl", "ceiling": {"height": 2.4}},
    "shaking": {"intensity": "6-lower"},
}

HALF: dict[str, Any] = {"width": 0.45, "length": 1.2, "height": 0.9, "mass": 60.0}
JOINED: dict[str, Any] = {"first": "upper", "second": "lower", "strength": 400.0, "shear": 400.0}
DRESSER: dict[str, Any] = {
    "furniture": [{"name": "lower", **HALF}, {"name": "upper", **HALF, "on": "lower"}],
    "joints": [{**JOINED, "at": [-0.2, y, 0.9]} for y in (-0.4, 0.4)],
    "room": ROOM,
    "options": [
        {"name": "joined", "joined": True},
        {"name": "joined, brackets", "joined": True, "measures": {"upper": [{"type": "l_bracket"}]}},
        {"name": "joined, poles", "joined": True, "measures": {"upper": [{"type": "tension_pole"}]}},
    ],
    "shaking": {"intensity": "6-upper"},
}

SEEN: dict[str, dict[str, Any] | Path] = {
    "bookcase": lone("bookcase", "6-upper"),
    "bookcase, 8th of 10 storeys": lone("bookcase", "5-upper", **storeys(10, "RC", 8)),
    "wardrobe on vinyl": lone("wardrobe", "6-upper", {"floor": "vinyl"}, suite={"family": "mixed"}),
    "cupboard before boards, 3rd of 5": {
        **lone("cupboard", "6-upper", {"floor": "vinyl", **BOARD}, **storeys(5, "RC", 3)),
        "uncertainty": {"installation": "as people install it"},
        "measures": [{"type": kind} for kind in ("l_bracket_board", "tension_pole", "gel_mats")],
    },
    "television": lone("television", "6-upper"),
    "piano": lone("upright piano", "7"),
    "chest, 2nd of 2, timber": lone("chest", "6-lower", **storeys(2, "timber", 2)),
    "cupboard, subduction": lone("cupboard", "6-upper", suite={"family": "subduction"}),
    "dresser of two": DRESSER,
    "bedroom": EXAMPLES / "bedroom.toml",
}
"""Scenes that were looked at while the race was made."""

UNSEEN: dict[str, dict[str, Any] | Path] = {
    "chest on carpet": lone("chest", "7", {"floor": "carpet", "left_wall": {"gap": 0.05}}),
    "refrigerator": lone("refrigerator", "7", {"left_wall": {"gap": 0.05}}),
    "empty bookcase": lone("empty bookcase", "6-lower"),
    "vending machine on concrete": lone("vending machine", "7", {"floor": CONCRETE}),
    "rack, 5th of 10, steel": lone("server rack", "6-upper", {"floor": "vinyl"}, **storeys(10, "S", 5)),
    "bookcase, 10th of 10": lone("bookcase", "5-lower", **storeys(10, "RC", 10)),
    "wardrobe on tatami": lone("wardrobe", "7", {"floor": "tatami"}),
    "bookcase near a fault": lone("bookcase", "6-lower", suite={"family": "near-fault"}),
    "shelf and chest beside a bed": SHELF_AND_BED,
    "wardrobe, 8th of 10": EXAMPLES / "upper_floor.toml",
    "office of five": OFFICE,
}
"""Scenes that were looked at once, when the race was as it is."""


def scenario_of(stated: dict[str, Any] | Path) -> sp.Scenario:
    """Return a scene under as many motions, with as many runs; what is inside is left out.

    One motion at a strength of its own, as in some of the examples, becomes a suite at 6-upper.
    """
    scenario = sp.read(stated) if isinstance(stated, Path) else sp.Scenario.parse(stated)
    tables = scenario.stated_keys()
    shaking: dict[str, Any] = {
        key: value for key, value in tables["shaking"].items() if key not in OF_ONE_MOTION
    }
    shaking.setdefault("intensity", "6-upper")
    suite = {**shaking.get("suite", {}), "count": MOTIONS}
    asked = {**tables.get("uncertainty", {}), "samples": MOTIONS * DRAWS}
    tables = {key: value for key, value in tables.items() if key not in ("contents", "everyday")}
    return sp.Scenario.parse({**tables, "shaking": {**shaking, "suite": suite}, "uncertainty": asked})


def record(stated: dict[str, Any] | Path) -> dict[str, Any]:
    """Run a scene; return what of it is recorded: see `studies.races.Scene`."""
    scenario = scenario_of(stated)
    room = scenario.plan is not None
    runner = OptionRunner(scenario, SLIDE_LIMIT, None, beside=scenario.alone)
    options = list(compared_options(scenario)[0])
    if room:
        (runs,) = runner.run(options, runner.members.chosen(slice(16)), keep=True)
        options += list(tried_options(runner, options[0], runs))[:CHANGES]
    shape = len(options), MOTIONS, DRAWS
    fell, slid, energy = np.zeros(shape, np.bool_), np.zeros(shape, np.bool_), np.zeros((*shape, 0))
    for first in range(0, len(runner.members), PART):
        members = runner.members.chosen(slice(first, first + PART))
        for number, runs in enumerate(runner.run(options, members)):
            at = number, members.motion, members.sample
            fell[at], slid[at] = runs.overturned, runs.moved(SLIDE_LIMIT)
            if room:
                energy = energy if energy.size else np.zeros((*shape, runs.hits.shape[1]))
                energy[at] = np.where(hits_in(runs), runs.hits[..., ENERGY], 0.0).max(axis=2)
        runner.scene_runner = runner.scene_runner.anew(runner.advance)  # else all runs stay in memory
        print(f"  {first + PART} of {len(runner.members)}", flush=True)
    beside = np.full((len(BESIDE), len(options)), np.nan)
    for place, offset in enumerate(BESIDE if scenario.alone else ()):
        floors = ScaledMotions.of(scenario).stated_by(scenario, 10.0 ** (0.5 * offset))
        far = OptionRunner(scenario, SLIDE_LIMIT, None, floors=floors)
        chosen = options[:2]
        each = far.run(chosen, Members.of_samples(MOTIONS, 1).chosen(slice(RUNS_BESIDE)))
        beside[place, : len(chosen)] = [runs.overturned.mean() for runs in each]
    return {
        "options": [option.name for option in options],
        "shape": shape,
        "fell": np.packbits(fell),
        "slid": np.packbits(slid),
        "energy": energy.astype(np.float32),
        "beside": beside,
    }


def main() -> None:
    """Run scenes, and add them to those that are recorded."""
    for name in sys.argv[1:] or [*SEEN, *UNSEEN]:
        empty: dict[str, Any] = {"names": np.array([], str)}
        recorded: dict[str, Any] = dict(np.load(RECORDED)) if RECORDED.exists() else empty
        if name in recorded["names"] and not sys.argv[1:]:
            continue
        print(name, flush=True)
        made = record((SEEN | UNSEEN)[name])
        recorded |= {f"{name}/{of}": np.asarray(value) for of, value in made.items()}
        recorded[f"{name}/seen"] = np.asarray(name in SEEN)
        recorded["names"] = np.union1d(recorded["names"], [name])
        np.savez_compressed(RECORDED, **recorded)


if __name__ == "__main__":
    main()

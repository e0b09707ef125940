"""One answer to one question: a bookcase alone, in a scene of three, in a room and in a room of three."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import stayput as sp
from stayput.measures import GelMats, LBracket
from stayput.montecarlo.counting import OVERTURNED, Members
from stayput.scenario.measures import Option
from stayput.verification.option_runner import OptionRunner

SHAKEN = {
    "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 4}},
    "uncertainty": {"samples": 4},
}
SIZES = {"name": "bookcase", "width": 0.3, "height": 1.8, "mass": 200.0, "length": 0.9}
AT_THE_WALL = {**SIZES, "against": "left_wall", "along": 5.0, "gap": 0.02}
BEHIND = {"left_wall": {"gap": 0.02}}
ROOM = {"width": 8.0, "length": 10.0}


def chest(name: str, **place: Any) -> dict[str, Any]:
    return {"name": name, "width": 0.45, "height": 0.8, "mass": 60.0, "length": 0.9, **place}


PLACES: dict[str, dict[str, Any]] = {
    "alone": {"furniture": SIZES, "room": BEHIND},
    "in a scene of three": {
        "furniture": [SIZES, chest("a", at=[0.075, 4.0]), chest("b", at=[0.075, -4.0])],
        "room": BEHIND,
    },
    "in a room": {"furniture": [AT_THE_WALL], "plan": ROOM},
    "in a room of three": {
        "furniture": [
            AT_THE_WALL,
            chest("a", against="left_wall", along=1.0),
            chest("b", against="right_wall", along=8.0),
        ],
        "plan": ROOM,
    },
}


CASES = {
    "free": ((), {}),
    "brackets": ((LBracket(),), {}),
    "mats": ((GelMats(),), {}),
    "from a direction": ((), {"direction": 0.7}),
}


@pytest.mark.parametrize("case", CASES)
def test_a_bookcase_has_the_same_runs_to_the_bit_wherever_nothing_else_reaches_it(case: str) -> None:
    measures, stated = CASES[case]
    results, used = list[Any](), list[Any]()
    for tables in PLACES.values():
        scenario = sp.Scenario.parse({**SHAKEN, **tables, **stated})
        option = Option("held", (measures, *((),) * (len(scenario.names) - 1)))
        runner = OptionRunner(scenario, 0.1, 2)
        (runs,) = runner.run([option], Members.of_samples(runner.settings.motions, 1))
        results.append(runs.results[..., 0])
        used.append(runs.used)
    assert len(np.unique(results[0]["peak_slide"])) == results[0].size  # each draw is another
    for other, of_devices in zip(results[1:], used[1:], strict=True):
        for name in ("outcome", "peak_slide", "peak_tilt", "residual_tilt", "wall_impacts"):
            assert np.array_equal(results[0][name], other[name]), name
        assert np.array_equal(used[0], of_devices)


def test_their_verdicts_are_one() -> None:
    chances: list[Any] = []
    for tables in PLACES.values():
        verdict = sp.verify(sp.Scenario.parse({**SHAKEN, **tables}), changes=False, levels=[])
        piece = next(piece for piece in verdict.without.pieces if piece.name == "bookcase")
        chances.append((piece.probabilities[OVERTURNED], piece.slide, piece.stability))
    assert all(other == chances[0] for other in chances[1:])


@pytest.mark.parametrize("stated", [{}, {"direction": 0.4}], ids=["drawn", "stated"])
def test_one_that_faces_elsewhere_is_shaken_alike(stated: dict[str, float]) -> None:
    """Turned with its draws: but for rounding, which impacts enlarge."""
    slides: list[Any] = []
    for furniture in ({**SIZES, "heading": 0.7}, [{**SIZES, "heading": 0.7}]):
        scenario = sp.Scenario.parse({**SHAKEN, "furniture": furniture, **stated})
        runner = OptionRunner(scenario, 0.1, 2)
        (runs,) = runner.run([Option("none")], Members.of_samples(runner.settings.motions, 1))
        slides.append(np.where(runs.overturned, np.inf, runs.slide))
    alike = np.isclose(slides[0], slides[1], rtol=1e-3, atol=1e-6)
    assert alike.mean() > 0.7
    assert np.array_equal(*(np.isinf(each) for each in slides))


def test_one_component_comes_from_where_it_is_said_to() -> None:
    sine = {"shaking": {"sine": {"amplitude": 4.0, "frequency": 1.0, "duration": 5.0}}}
    for turned, points in (({}, 0.0), ({"direction": 0.0}, 0.0), ({"direction": 0.5}, 0.5)):
        scenario = sp.Scenario.parse({**sine, "furniture": SIZES, **turned})
        assert (scenario.points, scenario.dimensions) == (points, 3)  # as measures are compared
    body = sp.Body(**{key: value for key, value in SIZES.items() if key != "name"})
    assert sp.simulate(body, sp.Room(), sp.sine(4.0, 1.0, 5.0)).engine == "plane"  # which is free
    aside = sp.Scenario.parse({**sine, "furniture": {**SIZES, "heading": 1e-9}})
    assert aside.points == 0.0
    aside = sp.Scenario.parse({**sine, "furniture": {**SIZES, "heading": 0.5}})
    assert (aside.points, aside.facing, aside.dimensions) == (0.0, 0.5, 3)

"""The runs behind a verdict made again: the same motion and draw, to the bit, now with their histories."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.measures.element import device_results
from stayput.mechanics.runner import shaking, trace
from stayput.model.flat_fields import case_columns
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.sampling import drawn_held, draws
from stayput.montecarlo.scene_draws import draws_of_scenario
from stayput.montecarlo.scenes import replay
from stayput.motion.suites.suite import Suite
from stayput.simulation.case import Case, run_of

if TYPE_CHECKING:
    from stayput.montecarlo.counting import Member
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.scenario.option import Option
    from stayput.simulation.run import Run

MOST_EVENTS = 2000
"""Events of a run in the plane that its plot marks: the first ones, and the last."""


def floor_motion(scenario: Scenario, member: Member) -> tuple[Motion, float]:
    """Return a member's motion under the furniture, and the factor on it.

    Parameters
    ----------
    scenario : Scenario
        What was verified.
    member : Member
        Which of its motions.
    """
    shaken, ground, seed = scenario.shaking, scenario.ground(), scenario.uncertainty.seed
    hazard = Hazard.of(scenario, ground=Suite((ground[member.motion],)))
    strength = shaken.strength
    drawn = None if strength is None else strength.drawn(len(ground), seed)[member.motion]
    floors = hazard.stated(drawn, shaken.scale, seed)
    return floors.motions[0], float(floors.scales[0])


def drawn_run(scenario: Scenario, option: Option, member: Member) -> Run:
    """Run a member of an option again, with its histories.

    Parameters
    ----------
    scenario : Scenario
        What was verified.
    option : Option
        What is in place; another option's run of the same member met the same motion and the same draw.
    member : Member
        Which motion, and which draw.
    """
    (motion, scale), stated = floor_motion(scenario, member), scenario.uncertainty
    counts, gravity = (member.motion + 1, member.sample + 1), scenario.gravity
    initial = scenario.initial.state()
    if scenario.dimensions == 3:
        draw = draws_of_scenario(scenario, *counts)[member.motion][member.sample]
        with scenario.naming_keys():
            return replay(scenario.scene(option), draw, motion, scale, gravity, initial)
    scaled = motion.scaled(scale)
    each = draws(*counts, stated.seed, as_stated=stated.as_stated, quantities=stated.quantities)
    draw = each[member.motion][member.sample]
    body, room = scenario.piece.body(), scenario.room.room()
    held, elements = drawn_held(body, room, option.measures, draw)
    row = case_columns(held.body, held.room, initial, gravity)
    row["scale"] = scale
    traced = trace(row[0], shaking(motion.x, motion.z, motion.dt, 0), elements)
    results = device_results(held, elements, traced.devices, traced.forces, held.body.mass)
    case = Case(held.body, held.room, scaled, initial=initial, gravity=gravity)
    return run_of(case, traced, held, results, MOST_EVENTS).named(scenario.names)

"""Single runs of a verification, run again with their histories."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from stayput.cases import case_columns
from stayput.measures import element_rows, hold
from stayput.measures.results import device_results
from stayput.mechanics.runner import shaking
from stayput.motion.suites import Suite
from stayput.simulation import Case, run_of, trace_held
from stayput.verification.draws import drawn_body, drawn_room, draws
from stayput.verification.hazard import Hazard

if TYPE_CHECKING:
    from stayput.motion import Motion
    from stayput.simulation import Run
    from stayput.verification import Option, Verdict
    from stayput.verification.verdict import Member


def replay(verdict: Verdict, option: Option, member: Member, ground: Suite) -> Run:
    """Run one of the runs behind a verdict again: the same bits, now with its histories.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    option : Option
        The measures; another option's run of the same member met the same motion and the same draw.
    member : Member
        Which motion, and which draw.
    ground : Suite
        The motions of the ground, as the verdict's scenario gives them.
    """
    motion, scale = felt(verdict, ground, member)
    return replay_under(verdict, option, member, motion, scale)


def felt(verdict: Verdict, ground: Suite, member: Member) -> tuple[Motion, float]:
    """Return a member's motion under the furniture, and the factor on it.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    ground : Suite
        The motions of the ground.
    member : Member
        Which of them.
    """
    shaken = verdict.scenario.shaking
    one = Suite((ground[member.motion],))
    hazard = Hazard(one, shaken.building, shaken.storey or 1, vertical=bool(shaken.vertical))
    wanted = shaken.wanted_intensity
    scale = 1.0 if shaken.scale is None else shaken.scale
    floors = hazard.as_given(scale) if wanted is None else hazard.at(wanted)
    return floors.motions[0], float(floors.scales[0])


def replay_under(verdict: Verdict, option: Option, member: Member, motion: Motion, scale: float) -> Run:
    """Run a member again under its motion and the factor on it; see `replay`."""
    scenario = verdict.scenario
    drawn = draws(member.motion + 1, member.sample + 1, verdict.seed)[member.motion][member.sample]
    body = drawn_body(scenario.furniture.body(), drawn)
    stated = hold(body, scenario.room.room(), option.measures)
    held = replace(stated, room=drawn_room(stated.room, drawn))
    initial = scenario.initial.state()
    case = case_columns(held.body, held.room, initial, scenario.gravity)
    case["scale"] = scale
    elements = element_rows(stated, drawn.strength)
    traced, devices, forces = trace_held(case[0], elements, shaking(motion.x, motion.z, motion.dt, 0))
    asked = Case(held.body, held.room, motion.scaled(scale), initial=initial, gravity=scenario.gravity)
    return run_of(asked, traced, held, device_results(held, elements, devices, forces))

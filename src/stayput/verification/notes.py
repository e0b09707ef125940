"""Beside a verdict's numbers: quick estimates by formulas, and what the numbers rest on."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Self

import numpy as np

from stayput import estimates
from stayput.catalogue import Phrase, phrase
from stayput.execution import Pool
from stayput.fragility.intensity_measures import PFA, PFV
from stayput.fragility.probabilities import percent
from stayput.measures.measure import GRADE_OF
from stayput.model.parameters import STANDARD_GRAVITY, parameters
from stayput.model.room import WALLS_AROUND
from stayput.montecarlo.counting import OVERTURNED
from stayput.motion.floors import floor_phrase
from stayput.standards.ac156 import ac156
from stayput.standards.asce43 import FRICTION_RANGE, VERTICAL_SHARE, asce43_sliding
from stayput.standards.equipment import EquipmentLoad, equipment_loads, position_of
from stayput.verification.meetings import notes_of_rooms
from stayput.verification.options import furniture_tag, grade, weakest
from stayput.verification.words import slides_off
from stayput.wording import FAR, joined

if TYPE_CHECKING:
    from stayput.model.body import Body
    from stayput.montecarlo.scaled_motions import FloorMotions
    from stayput.scenario import Scenario
    from stayput.scenario.measures import Option
    from stayput.verification.verdict import Verdict


@dataclass(frozen=True, slots=True)
class Ac156Estimate:
    """From which strength on a shake-table test by AC156 rocks a piece.

    Parameters
    ----------
    height_ratio : float
        z/h of the floor.
    sds : float
        S_DS at which the test's acceleration of a rigid body, A_rig, starts rocking [g].
    """

    height_ratio: float
    sds: float

    @classmethod
    def of(cls, rocking: float, height_ratio: float) -> Self:
        """Return it for an acceleration at which rocking starts [m/s²]; A_rig is proportional to S_DS."""
        required = ac156(1.0, height_ratio)
        return cls(height_ratio, rocking / (required.rigid * STANDARD_GRAVITY))


@dataclass(frozen=True, slots=True)
class SlidingShare:
    """How far the piece slides by ASCE 43, over the motions under it.

    Parameters
    ----------
    share : float
        Share of the motions that make it slide; those that the method says nothing of do not count.
    distance : float
        Median distance under those [m]; nan where there are none.
    """

    share: float
    distance: float

    @classmethod
    def of(cls, floors: FloorMotions, friction: float, gravity: float, threads: int | None) -> Self:
        """Return it for the motions of a level and the static friction of the floor."""
        mu = float(np.clip(friction, *FRICTION_RANGE))

        def estimated(place: int) -> float:
            motion = floors.motions[place].scaled(float(floors.scales[place]))
            lifted = motion.z is not None and float(np.abs(motion.z).max()) >= gravity / VERTICAL_SHARE
            return math.nan if lifted else asce43_sliding(motion, mu, gravity).distance

        with Pool(threads) as pool:
            calls = (partial(estimated, place) for place in range(len(floors.motions)))
            distances = np.sort([distance for _, distance in pool.as_completed(calls)])
        slides = distances[np.isfinite(distances)]  # NaN where the spectrum nowhere reaches the friction
        return cls(len(slides) / len(distances), float(np.median(slides)) if len(slides) else math.nan)


@dataclass(frozen=True, slots=True)
class Estimates:
    """Quick estimates by formulas of the piece without a measure, on a floor on which it does not slide.

    Parameters
    ----------
    rocking_acceleration : float
        Floor acceleration at which rocking starts (West) [m/s²].
    overturning_velocity : float
        Floor velocity that overturning needs as well (Ishiyama 1982) [m/s].
    possible : float
        Share of the motions that reach both.
    overturning_ratio : float
        Share that overturns by Kaneko and Hayashi, on average over the motions.
    equipment : tuple of EquipmentLoad
        Static loads of the Japanese guideline for building equipment where the piece stands, class by class.
        None under motions of upper floors: it goes by the storeys of the building, which are not known then.
    shake_table : Ac156Estimate, optional
        The shake-table test of AC156 where the piece stands; likewise.
    sliding : SlidingShare
        Sliding by the approximate method of ASCE 43.
    """

    rocking_acceleration: float
    overturning_velocity: float
    possible: float
    overturning_ratio: float
    equipment: tuple[EquipmentLoad, ...]
    shake_table: Ac156Estimate | None
    sliding: SlidingShare

    @classmethod
    def of(cls, body: Body, floors: FloorMotions, scenario: Scenario, threads: int | None) -> Estimates:
        """Return the estimates of a scenario's body under the motions of a level."""
        gravity, shaking = scenario.gravity, scenario.shaking
        a, v = floors.values(PFA), floors.values(PFV)
        a0, v0 = estimates.rocking_acceleration(body, gravity), estimates.ishiyama_velocity(body, gravity)
        ratios = [
            estimates.kaneko_hayashi(body, float(x), float(y), gravity).ratio
            for x, y in zip(a, v, strict=True)
        ]
        building = shaking.building
        storey, storeys = (1, 1) if building is None else (shaking.storey or 1, building.highest() - 1)
        return cls(
            a0,
            v0,
            float(np.mean((a >= a0) & (v >= v0))),
            float(np.mean(ratios)),
            () if floors.floor else equipment_loads(body, position_of(storey, storeys), gravity=gravity),
            None if floors.floor else Ac156Estimate.of(a0, (storey - 1) / storeys),
            SlidingShare.of(floors, scenario.room.room().floor.static_friction, gravity, threads),
        )


APART = 0.20
"""A quick estimate that is farther from the simulation than this is explained."""

LISTED = 4
"""Most inputs that a note names."""

_MAY_SLIDE = 1.5
"""Below so many times B/H the friction that is drawn may let a piece slide where the formula has it rock."""

_OFF_MIDDLE = 0.05
"""From so far off half the height, in heights, the centre of gravity is not the formula's."""


def notes(verdict: Verdict) -> tuple[Phrase, ...]:
    """Return the notes beside the numbers of a verdict, each in English and Japanese.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    """
    everyday = (everyday_note(verdict),) if verdict.scenario.alone else ()
    return *shaken_notes(verdict, verdict.best.option), *everyday


def shaken_notes(verdict: Verdict, graded: Option) -> Iterator[Phrase]:
    """Yield the notes of a verdict but that on the piece without an earthquake.

    How far its numbers may be trusted comes first.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    graded : Option
        The option of which that is told.
    """
    yield _trust(graded, verdict)
    strength = verdict.scenario.shaking.strength
    if strength is not None and strength.scatter:
        yield phrase("verification.strength", strength=strength.told(verdict.motions))
    if verdict.floor:
        yield phrase("verification.of_a_floor", floor=floor_phrase(verdict.floor))
    if not verdict.scenario.alone:
        yield from notes_of_rooms(verdict)
        return
    free = not verdict.without.option.count and _stands_free(verdict.scenario)
    if verdict.estimates is not None and free:  # formulas know of no measures, walls and ceilings
        yield from _estimate(verdict, verdict.estimates.overturning_ratio)
        yield from _field(verdict)
    if any(slides_off(option, verdict) for option in verdict.options):
        yield phrase("verification.slides_off", far=FAR)
    yield from _contents(verdict)
    scenario = verdict.scenario
    if scenario.dimensions == 3:
        drawn = scenario.points is None
        turned = math.remainder(scenario.facing - (scenario.points or 0.0), 2.0 * math.pi)
        heading = round(math.degrees(turned))  # a whole number: no −0
        key = "verification.in_space_drawn" if drawn else "verification.in_space"
        yield phrase(key, heading=heading, components=", ".join(scenario.components))


def _stands_free(scenario: Scenario) -> bool:
    """Return whether a piece can fall to all sides, as in the formulas that it is compared with."""
    body, room = scenario.piece.body(), scenario.room.room()
    walls = (getattr(room, name) for name in WALLS_AROUND)
    if any(wall is not None and wall.gap < body.height for wall in walls):
        return False
    return room.ceiling is None or room.ceiling.height >= math.hypot(body.width, body.height)


def _trust(graded: Option, verdict: Verdict) -> Phrase:
    """Return how far the numbers of an option may be trusted: what they rest on, and what would help."""
    scenario = verdict.scenario
    deciding = weakest(graded, scenario)
    inputs = joined(item.label for item in deciding[:LISTED])
    if len(deciding) > LISTED:
        more = phrase("verification.and_more", more=len(deciding) - LISTED)
        inputs = inputs[0] + more[0], inputs[1] + more[1]
    return phrase(f"verification.trust_{grade(graded, scenario).value}", inputs=inputs)


def left_out_of_held(verdict: Verdict) -> Phrase | None:
    """Return what the engine or the motions leave out that what holds the furniture would bear too.

    It stands in the headline, since a measure may then fail that holds here. None where nothing is left out.
    """
    scenario, held = verdict.scenario, any(result.option.measures for result in verdict.options)
    if scenario.dimensions == 2 and (held or scenario.shakes_across):
        key = "verification.no_length" if scenario.piece.body().length is None else "verification.in_plane"
        return phrase(key, held=phrase("verification.may_fail") if held else "")
    if held and not scenario.has_two_components:
        return phrase("verification.one_component")
    return None


def _field(verdict: Verdict) -> Iterator[Phrase]:
    """Yield where the piece lies against the field's formulas, where half of it fall at some level."""
    curves = verdict.without.curves
    lognormal = curves[PFV].lognormal if curves else None
    if lognormal is None:
        return
    body = verdict.scenario.piece.body()
    formula = estimates.kaneko_hayashi_velocity(body)
    low = estimates.LOSS_MODEL_RATIO * formula
    yield phrase(
        "verification.field",
        median=100.0 * lognormal.median,
        low=100.0 * low,
        high=100.0 * formula,
        least=lognormal.median / formula,
        most=lognormal.median / low,
    )


def _estimate(verdict: Verdict, formula: float) -> Iterator[Phrase]:
    simulated = verdict.without.probabilities[OVERTURNED]
    close = not abs(formula - simulated.estimate) > APART  # also where the simulation has no result
    if close or simulated.low <= formula <= simulated.high:
        return
    yield phrase(
        "verification.estimate_differs",
        formula=percent(formula),
        simulated=simulated.share,
        left_out=joined(_left_out(verdict)),
    )


def _left_out(verdict: Verdict) -> Iterator[Phrase]:
    """Yield what the formula leaves out of this piece where it stands."""
    scenario = verdict.scenario
    body, room = scenario.piece.body(), scenario.room.room()
    friction, slender = room.floor.static_friction, body.width / body.height
    if friction < _MAY_SLIDE * slender:
        yield phrase("verification.may_slide", friction=friction, slender=slender)
    up = body.centre_of_gravity[1] / body.height
    if abs(up - 0.5) > _OFF_MIDDLE:
        yield phrase("verification.centre_off_middle", percent=100.0 * up)
    yield phrase("verification.of_their_own")


def everyday_cases(scenario: Scenario) -> tuple[tuple[estimates.TipOverCase, Phrase], ...]:
    """Return the cases of tip-over without an earthquake, the smallest margin first, each in words."""
    everyday, body = _everyday(scenario), scenario.piece.body()

    def said(case: estimates.TipOverCase) -> Phrase:
        height = min(everyday.pull_height, body.height)
        key = f"verification.everyday_{case.name}"
        words = phrase(key, drawers=everyday.drawers, load=everyday.load, pull=everyday.pull, height=height)
        if everyday.carpet == 0.0:
            return words
        return phrase("verification.everyday_on_carpet", case=words, carpet=1e3 * everyday.carpet)

    return tuple((case, said(case)) for case in estimates.tip_over(body, everyday, scenario.gravity))


def _everyday(scenario: Scenario) -> estimates.Everyday:
    """Return what people do to the piece where it stands."""
    return scenario.everyday.everyday(scenario.piece.preset, scenario.room.room().floor.surface)


def everyday_note(verdict: Verdict) -> Phrase:
    """Return the case in which the piece tips over most easily without an earthquake, and its margin."""
    furniture = verdict.scenario.piece
    everyday = _everyday(verdict.scenario)
    tags = [about.tag(getattr(everyday, about.name)) for about in parameters(estimates.Everyday)]
    worst, said = everyday_cases(verdict.scenario)[0]
    return phrase(
        "verification.everyday_tips" if worst.tips else "verification.everyday_stays",
        case=said,
        margin=worst.margin,
        letter=max(GRADE_OF[tag] for tag in (*tags, furniture_tag(furniture))).value,
    )


def _contents(verdict: Verdict) -> Iterator[Phrase]:
    contents, inside = verdict.without.contents, verdict.scenario.contents
    if contents is None or contents.emptied is None or contents.rigid.runs == 0:
        return
    if inside is not None and "latched" in inside.doors:
        yield phrase("verification.latches_hold")
    wide = contents.opened
    yield phrase(
        "verification.contents_bound",
        runs=contents.rigid.runs,
        rigid=contents.rigid.texts,
        emptied=contents.emptied.texts,
        opened="" if wide is None else phrase("verification.drawers_open", share=wide.texts),
    )

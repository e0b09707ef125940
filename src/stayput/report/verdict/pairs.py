"""Pairs of runs shown side by side: one motion and one draw, without and with a measure, simulated again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.measures import element_rows, hold
from stayput.measures.results import device_results
from stayput.mechanics.runner import shaking, trace
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.sampling import drawn_body, drawn_place, drawn_surfaces, draws
from stayput.motion.suites import Suite
from stayput.report.history import History, history
from stayput.report.scene import TIME_DIGITS, Scene, scene_of
from stayput.report.summary import slides_off
from stayput.report.verdict.numbers import peak_slide, peak_tilt
from stayput.report.verdict.words import word
from stayput.report.window import MOVED, window_of
from stayput.simulation.case import Case
from stayput.simulation.flat_fields import case_columns
from stayput.simulation.outcome import Outcome
from stayput.simulation.run import run_of
from stayput.simulation.space import run_held
from stayput.wording import FAR

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.measures import Held
    from stayput.motion import Motion
    from stayput.scenario.tables import FurnitureTable
    from stayput.simulation.run import Run
    from stayput.simulation.space_run import SpaceRun
    from stayput.verification import Option, Verdict
    from stayput.verification.verdict import Member

_HARDLY_TILT, _HARDLY_SLIDE = 0.01, 0.005
"""Peaks [rad, m] below which a run is said to hardly move."""

RATE = 50.0
"""Poses a second that the report holds; its script draws straight lines between them."""


@dataclass(frozen=True, slots=True, eq=False)
class Side:
    """One of the two runs.

    Parameters
    ----------
    option : Option
        The measures, or none.
    run : Run
        The run.
    history : History
        Where the body is when, until it lies.
    """

    option: Option
    run: Run
    history: History

    def outcome(self, language: str) -> str:
        """Return the outcome, as the end of a sentence."""
        run = self.run
        still = run.outcome in (Outcome.SLID, Outcome.ROCKED)
        hardly = still and run.peak_tilt < _HARDLY_TILT and run.peak_slide < _HARDLY_SLIDE
        slide = peak_slide(run.peak_slide, language)
        return word(
            f"outcome_{'hardly' if hardly else run.outcome.value}",
            language,
            slide=word("more_than", language, value=f"{FAR:g} m") if slides_off(run) else slide,
            tilt=peak_tilt(run.peak_tilt, language),
            time=f"{run.overturn_time:.1f}",
        )


@dataclass(frozen=True, slots=True, eq=False)
class RunPair:
    """Two runs of one member.

    Parameters
    ----------
    kind : str
        "typical" or "worst".
    member : Member
        The motion and the draw.
    motion : Motion
        The floor's motion.
    sides : tuple of Side
        Without a measure first.
    start, end : float
        What part of the time is shown [s].
    """

    kind: str
    member: Member
    motion: Motion
    sides: tuple[Side, ...]
    start: float
    end: float

    @property
    def scene(self) -> Scene:
        """The scene of the two runs."""
        return scene_of([side.run for side in self.sides], self.start, self.end)

    @property
    def telling(self) -> float:
        """The most telling moment [s]: halfway through the first fall, else the largest tilt or slide."""
        for side in self.sides:
            if side.run.overturned:
                far = np.abs(side.history.tilt) > 0.5
                return float(side.history.time[int(far.argmax())])
        bare = self.sides[0].history
        largest = np.abs(bare.tilt) if np.abs(bare.tilt).max() > MOVED else np.abs(bare.slide)
        return min(max(float(bare.time[int(largest.argmax())]), self.start), self.end)


def scene_data(pair: RunPair, scene: Scene, look: FurnitureTable) -> dict[str, Any]:
    """Return a pair's scene for the report's script, as plain values.

    Parameters
    ----------
    pair : Pair
        The runs.
    scene : Scene
        Its scene.
    look : FurnitureTable
        The piece, whose kind and shelves are drawn on it.

    Returns
    -------
    dict
        What `Scene.data` returns; ``start_s``, ``end_s``, ``telling_s``; ``kind`` and ``loads_kg`` of
        the piece.
    """
    return {
        **scene.data(RATE),
        "start_s": pair.start,
        "end_s": pair.end,
        "telling_s": round(pair.telling, TIME_DIGITS),
        "kind": look.preset,
        "loads_kg": look.shelves,
    }


def pairs_of(verdict: Verdict, ground: Suite) -> tuple[RunPair, ...]:
    """Return the typical and the worst case, run again.

    The typical case is that without a measure, the worst one that of the best measure; without a best
    measure both are those without one, alone.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    ground : Suite
        The motions of the ground.
    """
    bare, best = verdict.without, verdict.best
    return (
        _pair("typical", verdict, bare.typical, ground),
        _pair("worst", verdict, best.worst, ground),
    )


def shown_options(verdict: Verdict) -> list[Option]:
    """Return what is shown side by side: no measure, and the best one, if it is one."""
    bare, best = verdict.without.option, verdict.best.option
    return [bare, best] if best.measures else [bare]


def _pair(kind: str, verdict: Verdict, member: Member, ground: Suite) -> RunPair:
    motion, scale = floor_motion(verdict, ground, member)
    options = shown_options(verdict)
    runs = [replay_under(verdict, option, member, motion, scale) for option in options]
    sides = tuple(Side(option, run, history(run)) for option, run in zip(options, runs, strict=True))
    start, end = window_of([(side.run, side.history) for side in sides], motion)
    return RunPair(kind, member, motion.scaled(scale), sides, start, end)


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
    motion, scale = floor_motion(verdict, ground, member)
    return replay_under(verdict, option, member, motion, scale)


def floor_motion(verdict: Verdict, ground: Suite, member: Member) -> tuple[Motion, float]:
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
    one_motion = Suite((ground[member.motion],))
    dimensions = verdict.scenario.dimensions
    hazard = Hazard(one_motion, shaken.building, shaken.storey or 1, bool(shaken.vertical), dimensions)
    strength = shaken.strength
    own = None if strength is None else strength.drawn(len(ground), verdict.seed)[member.motion]
    floors = hazard.stated(own, shaken.scale, verdict.seed)
    return floors.motions[0], float(floors.scales[0])


def drawn_piece(verdict: Verdict, option: Option, member: Member) -> tuple[Held, NDArray[np.void]]:
    """Return the piece with the measures of an option as a member drew it, and its devices' rows."""
    scenario = verdict.scenario
    motions, samples, stated = member.motion + 1, member.sample + 1, scenario.uncertainty
    table = draws(motions, samples, verdict.seed, as_stated=stated.as_stated, quantities=stated.quantities)
    drawn = table[member.motion][member.sample]
    body = drawn_body(scenario.furniture.body(), drawn)
    bought = [measure.fitted_to(scenario.furniture.body()) for measure in option.measures]
    place = drawn_place(scenario.room.room(), drawn)
    stated = hold(body, place, bought, dimensions=scenario.dimensions)
    held = replace(stated, room=drawn_surfaces(stated.room, drawn))
    return held, element_rows(stated, drawn.strength)


def replay_in_space(
    verdict: Verdict, option: Option, member: Member, motion: Motion, scale: float
) -> SpaceRun:
    """Run a member of a verdict in space again under its motion and the factor on it: the same bits."""
    scenario = verdict.scenario
    held, elements = drawn_piece(verdict, option, member)
    return run_held(held, elements, motion.scaled(scale), scenario.initial.state(), scenario.gravity)


def replay_under(verdict: Verdict, option: Option, member: Member, motion: Motion, scale: float) -> Run:
    """Run a member again under its motion and the factor on it; see `replay`."""
    scenario, initial = verdict.scenario, verdict.scenario.initial.state()
    held, elements = drawn_piece(verdict, option, member)
    row = case_columns(held.body, held.room, initial, scenario.gravity)
    row["scale"] = scale
    traced = trace(row[0], shaking(motion.x, motion.z, motion.dt, 0), elements)
    case = Case(held.body, held.room, motion.scaled(scale), initial=initial, gravity=scenario.gravity)
    results = device_results(held, elements, traced.devices, traced.forces, held.body.mass)
    return run_of(case, traced, held, results, most_events=2)  # the pictures need the last one

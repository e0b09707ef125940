"""The typical and the worst case of a verdict: runs side by side, without and with measures, made again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from stayput.catalogue import phrase, say
from stayput.catalogue.names import ANY_PIECE
from stayput.measures.element import device_results
from stayput.mechanics.runner import shaking, trace
from stayput.model.flat_fields import case_columns
from stayput.montecarlo.counting import OVERTURNED
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.sampling import drawn_held, draws
from stayput.montecarlo.several import draws_of_several
from stayput.montecarlo.several import replay as run_again
from stayput.motion.suites.suite import Suite
from stayput.report.animation import film_of, player_page
from stayput.report.figures import embedded
from stayput.report.fonts import drawable
from stayput.report.history import peak_told, window_of
from stayput.report.names import motion_label
from stayput.report.plot import plot_run
from stayput.report.summary import sentences_of_piece
from stayput.report.verdict.numbers import word
from stayput.simulation.case import Case, run_of
from stayput.simulation.space import simulate_held
from stayput.verification.words import title

if TYPE_CHECKING:
    from stayput.montecarlo.counting import Member
    from stayput.motion.record import Motion
    from stayput.scenario.option import Option
    from stayput.simulation.run import Run
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

MOST_EVENTS = 2000
"""Events of a run in the plane that its plot marks: the first ones, and the last."""


def pairs_of(verdict: Verdict, language: str) -> list[dict[str, Any]]:
    """Return what a report shows of the typical and the worst case, run again.

    The typical case is that without a measure, the worst one that of the best measure; without a best
    measure both are those without one, alone.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    heading = word("histories", language)
    drawn = language if drawable(heading) == heading else "en"  # where no font has the letters
    without = phrase("common.without" if verdict.scenario.alone else "several.nothing")
    pairs: list[dict[str, Any]] = []
    for kind, member in (("typical", verdict.without.typical), ("worst", verdict.best.worst)):
        sides = _sides(verdict, member, language)
        runs = [run for _, run in sides]
        window = window_of(runs)
        about = word(f"{kind}{'' if len(sides) > 1 else '_bare'}_text", language, without=without)
        if kind == "typical" and len(runs) > 1 and verdict.scenario.alone:
            about += place_of_the_measure(verdict, runs[1], language)
        shown: list[dict[str, Any]] = []
        for label, run in sides:
            film = film_of(run, language, runs, window=window)
            shown.append(
                {
                    "label": label,
                    "outcome": say(sentences_of_piece(run), language),
                    # several that play at once would be too much for a slow machine
                    "player": player_page(film, 1.0, 1.5, plays=False),
                    "histories": embedded(plot_run(film.scene.run, language=drawn), "svg"),
                }
            )
        motion = motion_told(verdict, member, runs[0], window, language)
        pairs.append({"title": word(kind, language), "about": about, "sides": shown, "motion": motion})
    return pairs


def _sides(verdict: Verdict, member: Member, language: str) -> list[tuple[str, Run]]:
    """Return labels and runs of what is shown side by side: no measure, and the best one, if it is one."""
    scenario = verdict.scenario
    sides: list[tuple[str, Run]] = []
    on_floor = floor_motion(verdict, scenario.ground(), member) if scenario.alone else None
    for result in [verdict.without, verdict.best][: 1 + bool(verdict.best.option.count)]:
        if on_floor is None:
            run = replay_of_several(verdict, result, member)
        else:
            run = replay(verdict, result.option, member, *on_floor)
        sides.append((title(result.option, verdict, language), run))
    return sides


def place_of_the_measure(verdict: Verdict, held: Run, language: str) -> str:
    """Return whether the measure's run in a typical case is one of those that overturn, and how many do.

    The case is typical of the piece without a measure: the measure may fail in it and hold in most others.
    """
    chance = verdict.best.probabilities[OVERTURNED]
    if chance.runs == 0:
        return ""
    spared = "typical_never_falls" if chance.estimate == 0.0 else "typical_is_held"
    key = "typical_also_falls" if held.overturned else spared
    text = word(key, language, share=chance.share)
    return f" {text}" if language == "en" else text


def motion_told(
    verdict: Verdict,
    member: Member,
    run: Run,
    shown: tuple[float, float],
    language: str,
) -> str:
    """Return which motion a run met, how strong it was, and from when to when it is shown [s]."""
    return word(
        "motion_shown",
        language,
        number=member.motion + 1,
        count=verdict.motions,
        name=motion_label(run.motion, language),
        peak=peak_told(run),
        start=f"{shown[0]:.1f}",
        end=f"{shown[1]:.1f}",
        duration=f"{run.motion.duration:g}",
    )


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
    hazard = Hazard.of(verdict.scenario, ground=one_motion)
    strength = shaken.strength
    drawn = None if strength is None else strength.drawn(len(ground), verdict.seed)[member.motion]
    floors = hazard.stated(drawn, shaken.scale, verdict.seed)
    return floors.motions[0], float(floors.scales[0])


def replay(verdict: Verdict, option: Option, member: Member, motion: Motion, scale: float) -> Run:
    """Run one of the runs behind a verdict again: the same bits, now with its histories.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    option : Option
        The measures; another option's run of the same member met the same motion and the same draw.
    member : Member
        Which motion, and which draw.
    motion, scale : Motion, float
        Its motion of the floor and the factor on it; see `floor_motion`.
    """
    scenario, initial = verdict.scenario, verdict.scenario.initial.state()
    gravity, stated, scaled = scenario.gravity, scenario.uncertainty, motion.scaled(scale)
    motions, samples = member.motion + 1, member.sample + 1
    table = draws(motions, samples, verdict.seed, as_stated=stated.as_stated, quantities=stated.quantities)
    body, room, draw = scenario.piece.body(), scenario.room.room(), table[member.motion][member.sample]
    held, elements = drawn_held(body, room, option.measures, draw, scenario.dimensions)
    if scenario.dimensions == 3:
        run = simulate_held(held, elements, scaled, initial, gravity)
    else:
        row = case_columns(held.body, held.room, initial, gravity)
        row["scale"] = scale
        traced = trace(row[0], shaking(motion.x, motion.z, motion.dt, 0), elements)
        results = device_results(held, elements, traced.devices, traced.forces, held.body.mass)
        case = Case(held.body, held.room, scaled, initial=initial, gravity=gravity)
        run = run_of(case, traced, held, results, MOST_EVENTS)
    return run.named([scenario.piece.name or scenario.piece.preset or ANY_PIECE[0]])


def replay_of_several(verdict: Verdict, result: OptionVerdict, member: Member) -> Run:
    """Run a member of an option again, with its histories."""
    scenario = verdict.scenario
    hazard, stated = Hazard.of(scenario), scenario.uncertainty
    floors = hazard.stated_by(scenario)
    drawn = draws_of_several(
        scenario.names,
        len(hazard.ground),
        verdict.samples,
        verdict.seed,
        as_stated=stated.as_stated,
        quantities=stated.quantities,
        direction=scenario.direction or 0.0,
    )
    return run_again(
        scenario.scene(result.option),
        drawn[member.motion][member.sample],
        floors.motions[member.motion],
        float(floors.scales[member.motion]),
        scenario.gravity,
    )

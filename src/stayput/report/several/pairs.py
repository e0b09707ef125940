"""The typical and the worst case of a verdict on several pieces: players and histories of the runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from stayput.catalogue import say
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.several import draws_of_several, replay
from stayput.report.fonts import drawable
from stayput.report.space.animation import space_player_page
from stayput.report.space.film import space_film
from stayput.report.space.plot import plot_space_run
from stayput.report.space.said import became
from stayput.report.verdict.in_space import embedded, motion_in_space
from stayput.report.verdict.words import word
from stayput.report.window import cut_run, window_in_space
from stayput.verification.words import title_of_several

if TYPE_CHECKING:
    from stayput.montecarlo.counting import Member
    from stayput.simulation.space_run import SpaceRun
    from stayput.verification import AssemblyOptionVerdict, AssemblyVerdict


def pairs_of_several(verdict: AssemblyVerdict, language: str) -> list[dict[str, Any]]:
    """Return what the report shows of the typical and the worst case.

    Parameters
    ----------
    verdict : AssemblyVerdict
        The verdict.
    language : str
        "en" or "ja".
    """
    members = ("typical", verdict.without.typical), ("worst", verdict.best.worst)
    return [_pair(kind, verdict, member, language) for kind, member in members]


def replay_of_several(verdict: AssemblyVerdict, result: AssemblyOptionVerdict, member: Member) -> SpaceRun:
    """Run a member of an option again, with its histories."""
    scenario = verdict.scenario
    shaking, settings = scenario.shaking, scenario.uncertainty
    ground = scenario.ground()
    hazard = Hazard(ground, shaking.building, shaking.storey or 1, bool(shaking.vertical), 3)
    floors = hazard.stated(shaking.strength, shaking.scale, verdict.seed)
    drawn = draws_of_several(
        scenario.names, len(ground), verdict.samples, verdict.seed, as_stated=settings.as_stated
    )
    return replay(
        scenario.assembly(result.option),
        scenario.surroundings(),
        drawn[member.motion][member.sample],
        floors.motions[member.motion],
        float(floors.scales[member.motion]),
        scenario.gravity,
    )


def _pair(kind: str, verdict: AssemblyVerdict, member: Member, language: str) -> dict[str, Any]:
    options = [verdict.without, verdict.best] if verdict.best.option.count else [verdict.without]
    runs = [replay_of_several(verdict, option, member) for option in options]
    start, end = window_in_space(runs)
    names, heading = verdict.scenario.names, word("histories", language)
    drawn = language if drawable(heading) == heading else "en"  # where no font has the letters
    sides: list[dict[str, Any]] = []
    cut = [cut_run(run, start, end) for run in runs]
    for option, run, shown in zip(options, runs, cut, strict=True):
        film = space_film(shown, names, language, cut)
        sides.append(
            {
                "label": title_of_several(option, verdict, language),
                "outcome": say(became(run, names), language),
                "player": space_player_page(film, 1.0, 1.5, plays=False),
                "histories": embedded(plot_space_run(shown, names=names, language=drawn)),
            }
        )
    about = f"{kind}_text" if len(runs) > 1 else f"{kind}_bare_text"
    return {
        "title": word(kind, language),
        "about": say(f"several.{about}", language),
        "sides": sides,
        "motion": motion_in_space(runs[0].motion, member.motion, verdict.motions, (start, end), language),
    }

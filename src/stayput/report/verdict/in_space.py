"""The typical and the worst case of a verdict in space: players and histories of the runs."""

from __future__ import annotations

import base64
import io
from typing import TYPE_CHECKING, Any

from stayput.catalogue import say
from stayput.catalogue.names import ANY_PIECE, PIECES
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.several import draws_of_several, replay
from stayput.report.animation import player_page
from stayput.report.film import film_of
from stayput.report.fonts import drawable
from stayput.report.history import cut_run, window_in_space
from stayput.report.space.plot import plot_space_run
from stayput.report.space.summary import became
from stayput.report.verdict.numbers import word
from stayput.report.verdict.pairs import floor_motion, motion_told, replay_in_space, shown_options
from stayput.scenario import Scenario
from stayput.verification.words import title, title_of_several

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.figure import Figure

    from stayput.motion.suites import Suite
    from stayput.simulation.space_run import SpaceRun
    from stayput.verification import AssemblyVerdict, Verdict
    from stayput.verification.verdict import AssemblyOptionVerdict, Member


def space_pairs(verdict: Verdict, ground: Suite, language: str) -> list[dict[str, Any]]:
    """Return what the report shows of the typical and the worst case; see `stayput.report.verdict.pairs`.

    Parameters
    ----------
    verdict : Verdict
        A verdict in space.
    ground : Suite
        The motions of the ground.
    language : str
        "en" or "ja".
    """
    piece, options = verdict.scenario.furniture, shown_options(verdict)
    names = [piece.name or say(PIECES.get(piece.preset or "", ANY_PIECE), language)]
    labels = [title(option, verdict, language) for option in options]

    def runs_of(member: Member) -> list[SpaceRun]:
        on_floor = floor_motion(verdict, ground, member)
        return [replay_in_space(verdict, option, member, *on_floor) for option in options]

    return _pairs(verdict, runs_of, labels, names, language)


def pairs_of_several(verdict: AssemblyVerdict, language: str) -> list[dict[str, Any]]:
    """Return the same for the report of a verdict on several pieces."""
    options = [verdict.without, verdict.best] if verdict.best.option.count else [verdict.without]
    labels = [title_of_several(option, verdict, language) for option in options]

    def runs_of(member: Member) -> list[SpaceRun]:
        return [replay_of_several(verdict, option, member) for option in options]

    return _pairs(verdict, runs_of, labels, verdict.scenario.names, language)


def _pairs(
    verdict: Verdict | AssemblyVerdict,
    runs_of: Callable[[Member], list[SpaceRun]],
    labels: Sequence[str],
    names: Sequence[str],
    language: str,
) -> list[dict[str, Any]]:
    """Return the typical and the worst case, of runs under options with labels, of bodies with names."""
    heading = word("histories", language)
    drawn = language if drawable(heading) == heading else "en"  # where no font has the letters
    texts = "report" if isinstance(verdict.scenario, Scenario) else "several"
    pairs: list[dict[str, Any]] = []
    for kind, member in (("typical", verdict.without.typical), ("worst", verdict.best.worst)):
        runs = runs_of(member)
        start, end = window_in_space(runs)
        cut = [cut_run(run, start, end) for run in runs]
        pairs.append(
            {
                "title": word(kind, language),
                "about": say(f"{texts}.{kind}{'' if len(runs) > 1 else '_bare'}_text", language),
                "sides": [
                    {
                        "label": label,
                        "outcome": say(became(run, names), language),
                        # several that play at once would be too much for a slow machine
                        "player": player_page(film_of(shown, names, language, cut), 1.0, 1.5, plays=False),
                        "histories": _embedded(plot_space_run(shown, names=names, language=drawn)),
                    }
                    for label, run, shown in zip(labels, runs, cut, strict=True)
                ],
                "motion": motion_told(verdict, member, runs[0], (start, end), language),
            }
        )
    return pairs


def _embedded(figure: Figure) -> str:
    """Return a figure as the address of an image that holds it."""
    written = io.BytesIO()
    figure.savefig(written, format="svg")
    return f"data:image/svg+xml;base64,{base64.b64encode(written.getvalue()).decode('ascii')}"


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

"""The typical and the worst case of a verdict: runs side by side, without and with measures, made again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from stayput.catalogue import phrase, say
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.animation import film_of, player_page
from stayput.report.figures import embedded
from stayput.report.fonts import drawable
from stayput.report.history import peak_told, window_of
from stayput.report.names import motion_label
from stayput.report.plot import plot_run
from stayput.report.summary import sentences_of_piece
from stayput.report.verdict.numbers import word
from stayput.verification.contest import drawn_run
from stayput.verification.words import title

if TYPE_CHECKING:
    from stayput.montecarlo.counting import Member
    from stayput.simulation.run import Run
    from stayput.verification import Verdict


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
    shown = [verdict.without, verdict.best][: 1 + bool(verdict.best.option.count)]
    return [
        (title(result.option, verdict, language), drawn_run(scenario, result.option, member))
        for result in shown
    ]


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


def motion_told(verdict: Verdict, member: Member, run: Run, shown: tuple[float, float], language: str) -> str:
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

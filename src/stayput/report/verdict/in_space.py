"""The typical and the worst case of a verdict in space: players and histories of the runs."""

from __future__ import annotations

import base64
import io
from typing import TYPE_CHECKING, Any

from stayput.catalogue import say
from stayput.catalogue.names import ANY_PIECE, PIECES
from stayput.report.fonts import drawable
from stayput.report.names import motion_label
from stayput.report.space.animation import space_player_page
from stayput.report.space.film import space_film
from stayput.report.space.histories import peak_of
from stayput.report.space.plot import plot_space_run
from stayput.report.space.said import became
from stayput.report.verdict.pairs import floor_motion, replay_in_space, shown_options
from stayput.report.verdict.words import word
from stayput.report.window import cut_run, window_in_space
from stayput.verification.words import title

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from stayput.montecarlo.counting import Member
    from stayput.motion import Motion
    from stayput.motion.suites import Suite
    from stayput.verification import Verdict


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
    members = ("typical", verdict.without.typical), ("worst", verdict.best.worst)
    return [_pair(kind, verdict, member, ground, language) for kind, member in members]


def _pair(kind: str, verdict: Verdict, member: Member, ground: Suite, language: str) -> dict[str, Any]:
    motion, scale = floor_motion(verdict, ground, member)
    options = shown_options(verdict)
    runs = [replay_in_space(verdict, option, member, motion, scale) for option in options]
    start, end = window_in_space(runs)
    piece = verdict.scenario.furniture
    name = piece.name or say(PIECES.get(piece.preset or "", ANY_PIECE), language)
    heading = word("histories", language)
    drawn = language if drawable(heading) == heading else "en"  # where no font has the letters
    sides: list[dict[str, Any]] = []
    cut = [cut_run(run, start, end) for run in runs]
    for option, run, shown in zip(options, runs, cut, strict=True):
        label = title(option, verdict, language)
        # several that play at once would be too much for a slow machine
        player = space_player_page(space_film(shown, [name], language, cut), 1.0, 1.5, plays=False)
        figure = plot_space_run(shown, names=[name], language=drawn)
        sides.append(
            {
                "label": label,
                "outcome": say(became(run, [name]), language),
                "player": player,
                "histories": embedded(figure),
            }
        )
    about = f"{kind}_text" if len(runs) > 1 else f"{kind}_bare_text"
    return {
        "title": word(kind, language),
        "about": word(about, language),
        "sides": sides,
        "motion": motion_in_space(motion.scaled(scale), member.motion, len(ground), (start, end), language),
    }


def motion_in_space(
    motion: Motion, number: int, count: int, window: tuple[float, float], language: str
) -> str:
    """Return what is said of the motion of a pair of runs.

    Parameters
    ----------
    motion : Motion
        Of the floor.
    number, count : int
        Which it is, from 0, and of how many.
    window : tuple of float
        From when to when it is shown [s].
    language : str
        "en" or "ja".
    """
    return word(
        "motion_in_space",
        language,
        number=number + 1,
        count=count,
        name=motion_label(motion, language),
        peak=peak_of(motion),
        start=f"{window[0]:.1f}",
        end=f"{window[1]:.1f}",
        duration=f"{motion.duration:g}",
    )


def embedded(figure: Figure) -> str:
    """Return a figure as the address of an image that holds it."""
    written = io.BytesIO()
    figure.savefig(written, format="svg")
    return f"data:image/svg+xml;base64,{base64.b64encode(written.getvalue()).decode('ascii')}"

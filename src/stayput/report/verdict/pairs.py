"""The typical and the worst case of a verdict: runs side by side, without and with measures, made again."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase, say
from stayput.catalogue.names import ANY_PIECE
from stayput.measures.element import device_results
from stayput.mechanics.runner import shaking, trace
from stayput.model.flat_fields import case_columns
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.sampling import drawn_held, draws
from stayput.montecarlo.several import draws_of_several
from stayput.montecarlo.several import replay as run_again
from stayput.motion.suites.suite import Suite
from stayput.report.animation import film_of, player_page
from stayput.report.figures import embedded
from stayput.report.fonts import drawable
from stayput.report.history import MOVED, cut_run, history, peak_of, window_in_space, window_of
from stayput.report.names import motion_label
from stayput.report.plot import plot_run
from stayput.report.scene import TIME_DIGITS, PlaneScene, scene_of
from stayput.report.summary import sentences
from stayput.report.verdict import svg
from stayput.report.verdict.numbers import word
from stayput.simulation.case import Case, run_of
from stayput.simulation.space import simulate_held
from stayput.verification import Verdict
from stayput.verification.words import title

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.catalogue import Phrase
    from stayput.measures import Held
    from stayput.montecarlo.counting import Member
    from stayput.motion import Motion
    from stayput.scenario.option import Option
    from stayput.scenario.pieces import PieceTable
    from stayput.simulation.run import Run
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

RATE = 50.0
"""Poses a second that the report holds; its script draws straight lines between them."""


WIDTH, HEIGHT = 900.0, 430.0
LEFT, RIGHT = 62.0, 890.0
PANELS = ((26.0, 116.0), (148.0, 262.0), (294.0, 384.0))
"""Upper and lower edge of each panel [px]."""

_TILT_SHOWN = 3.0
"""Tilts beyond this are cut, in critical angles, so that the rocking before a fall is seen."""


@dataclass(frozen=True, slots=True, eq=False)
class RunPair:
    """Two runs of one member.

    Parameters
    ----------
    kind : str
        "typical" or "worst".
    member : Member
        The motion and the draw.
    options : list of Option
        The measures of each, or none, which comes first.
    scene : PlaneScene
        The runs, and what is drawn of them.
    """

    kind: str
    member: Member
    options: list[Option]
    scene: PlaneScene

    @property
    def telling(self) -> float:
        """The most telling moment [s]: halfway through the first fall, else the largest tilt or slide."""
        for run, shown in zip(self.scene.runs, self.scene.histories, strict=True):
            if run.overturned:
                return float(shown.time[int((np.abs(shown.tilt) > 0.5).argmax())])
        bare = self.scene.histories[0]
        largest = np.abs(bare.tilt) if np.abs(bare.tilt).max() > MOVED else np.abs(bare.slide)
        return min(max(float(bare.time[int(largest.argmax())]), self.scene.start), self.scene.end)

    def data(self, look: PieceTable) -> dict[str, Any]:
        """Return the scene for the report's script, as plain values.

        Parameters
        ----------
        look : PieceTable
            The piece, whose kind and shelves are drawn on it.

        Returns
        -------
        dict
            What `PlaneScene.data` returns; ``start_s``, ``end_s``, ``telling_s``; ``kind`` and ``loads_kg``
            of the piece.
        """
        return {
            **self.scene.data(RATE),
            "start_s": self.scene.start,
            "end_s": self.scene.end,
            "telling_s": round(self.telling, TIME_DIGITS),
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
    options, pairs = shown_options(verdict), list[RunPair]()
    for kind, member in (("typical", verdict.without.typical), ("worst", verdict.best.worst)):
        motion, scale = floor_motion(verdict, ground, member)
        runs = [replay(verdict, option, member, motion, scale) for option in options]
        window = window_of([(run, history(run)) for run in runs], motion)
        pairs.append(RunPair(kind, member, options, scene_of(runs, *window)))
    return tuple(pairs)


def about_case(kind: str, sides: int, without: Phrase, language: str) -> str:
    """Return which run the typical or the worst case is, shown alone or on two sides."""
    return word(f"{kind}{'' if sides > 1 else '_bare'}_text", language, without=without)


def shown_options(verdict: Verdict) -> list[Option]:
    """Return what is shown side by side: no measure, and the best one, if it is one."""
    bare, best = verdict.without.option, verdict.best.option
    return [bare, best] if best.measures else [bare]


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


def drawn_piece(verdict: Verdict, option: Option, member: Member) -> tuple[Held, NDArray[np.void]]:
    """Return the piece with the measures of an option as a member drew it, and its devices' rows."""
    scenario = verdict.scenario
    motions, samples, stated = member.motion + 1, member.sample + 1, scenario.uncertainty
    table = draws(motions, samples, verdict.seed, as_stated=stated.as_stated, quantities=stated.quantities)
    body, room, draw = scenario.piece.body(), scenario.room.room(), table[member.motion][member.sample]
    return drawn_held(body, room, option.measures, draw, scenario.dimensions)


def replay_in_space(verdict: Verdict, option: Option, member: Member, motion: Motion, scale: float) -> Run:
    """Run a member of a verdict in space again; see `replay`."""
    scenario = verdict.scenario
    held, elements = drawn_piece(verdict, option, member)
    run = simulate_held(held, elements, motion.scaled(scale), scenario.initial.state(), scenario.gravity)
    return _named(run, scenario.piece)


def _named(run: Run, piece: PieceTable) -> Run:
    return run.named([piece.name or piece.preset or ANY_PIECE[0]])


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
    held, elements = drawn_piece(verdict, option, member)
    row = case_columns(held.body, held.room, initial, scenario.gravity)
    row["scale"] = scale
    traced = trace(row[0], shaking(motion.x, motion.z, motion.dt, 0), elements)
    case = Case(held.body, held.room, motion.scaled(scale), initial=initial, gravity=scenario.gravity)
    results = device_results(held, elements, traced.devices, traced.forces, held.body.mass)
    run = run_of(case, traced, held, results, most_events=2)  # the pictures need the last one
    return _named(run, scenario.piece)


def motion_told(
    verdict: Verdict,
    member: Member,
    run: Run,
    shown: tuple[float, float],
    language: str,
) -> str:
    """Return which motion a run met, how strong it was, and from when to when it is shown [s]."""
    motion, in_space = run.motion, run.engine == "space"
    return word(
        "motion_in_space" if in_space else "motion_shown",
        language,
        number=member.motion + 1,
        count=verdict.motions,
        name=motion_label(motion, language),
        peak=peak_of(motion) if in_space else motion.pga,
        start=f"{shown[0]:.1f}",
        end=f"{shown[1]:.1f}",
        duration=f"{motion.duration:g}",
    )


def space_pairs(verdict: Verdict, ground: Suite, language: str) -> list[dict[str, Any]]:
    """Return what the report shows of the typical and the worst case; see `pairs_of`.

    Parameters
    ----------
    verdict : Verdict
        A verdict in space.
    ground : Suite
        The motions of the ground.
    language : str
        "en" or "ja".
    """
    options = shown_options(verdict)
    labels = [title(option, verdict, language) for option in options]

    def runs_of(member: Member) -> list[Run]:
        on_floor = floor_motion(verdict, ground, member)
        return [replay_in_space(verdict, option, member, *on_floor) for option in options]

    return _pairs(verdict, runs_of, labels, language)


def pairs_of_several(verdict: Verdict, language: str) -> list[dict[str, Any]]:
    """Return the same for the report of a verdict on several pieces."""
    options = [verdict.without, verdict.best] if verdict.best.option.count else [verdict.without]
    labels = [title(option.option, verdict, language) for option in options]

    def runs_of(member: Member) -> list[Run]:
        return [replay_of_several(verdict, option, member) for option in options]

    return _pairs(verdict, runs_of, labels, language)


def _pairs(
    verdict: Verdict,
    runs_of: Callable[[Member], list[Run]],
    labels: Sequence[str],
    language: str,
) -> list[dict[str, Any]]:
    """Return the typical and the worst case, of runs under options with labels."""
    heading = word("histories", language)
    drawn = language if drawable(heading) == heading else "en"  # where no font has the letters
    without = "common.without" if verdict.scenario.alone else "several.nothing"
    pairs: list[dict[str, Any]] = []
    for kind, member in (("typical", verdict.without.typical), ("worst", verdict.best.worst)):
        runs = runs_of(member)
        start, end = window_in_space(runs)
        cut = [cut_run(run, start, end) for run in runs]
        pairs.append(
            {
                "title": word(kind, language),
                "about": about_case(kind, len(runs), phrase(without), language),
                "sides": [
                    {
                        "label": label,
                        "outcome": say(sentences(run), language),
                        # several that play at once would be too much for a slow machine
                        "player": player_page(film_of(shown, language, cut), 1.0, 1.5, plays=False),
                        "histories": embedded(plot_run(shown, language=drawn), "svg"),
                    }
                    for label, run, shown in zip(labels, runs, cut, strict=True)
                ],
                "motion": motion_told(verdict, member, runs[0], (start, end), language),
            }
        )
    return pairs


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
    run = run_again(
        scenario.scene(result.option),
        drawn[member.motion][member.sample],
        floors.motions[member.motion],
        float(floors.scales[member.motion]),
        scenario.gravity,
    )
    return run.named(scenario.names)


def histories_svg(pair: RunPair, language: str, outcomes: str) -> str:
    """Return the picture of a pair's histories over the time that is shown.

    Parameters
    ----------
    pair : Pair
        The runs.
    language : str
        "en" or "ja".
    outcomes : str
        What became of them, for those who do not see it.
    """
    x = svg.PixelAxis(pair.scene.start, pair.scene.end, LEFT, RIGHT)
    motion = pair.scene.motion
    inside = (motion.time >= pair.scene.start) & (motion.time <= pair.scene.end)
    floor = [(motion.time[inside], motion.x[inside], 0)]
    tilts = [(h.time, np.degrees(h.tilt), n) for n, h in enumerate(pair.scene.histories)]
    slides = [(h.time, 100.0 * h.slide, n) for n, h in enumerate(pair.scene.histories)]
    limit = _TILT_SHOWN * math.degrees(max(pair.scene.runs[0].body.slenderness))
    parts = [
        *_panel(x, PANELS[0], floor, word("axis_acceleration", language), "floor", math.inf),
        *_panel(x, PANELS[1], tilts, word("axis_tilt", language), "run", limit),
        *_panel(x, PANELS[2], slides, word("axis_slide", language), "run", math.inf),
        *_times(x, language),
        *_failures(x, pair, language),
        svg.element("line", x1=LEFT, x2=LEFT, y1=PANELS[0][0], y2=PANELS[2][1], class_="now"),
    ]
    return svg.drawing(
        WIDTH, HEIGHT, parts, word("histories_alt", language, outcomes=outcomes), "chart histories"
    )


def _panel(
    x: svg.PixelAxis,
    edges: tuple[float, float],
    lines: list[tuple[NDArray[np.float64], NDArray[np.float64], int]],
    name: str,
    class_: str,
    limit: float,
) -> list[str]:
    top, bottom = edges
    shown = [(t[(t >= x.low) & (t <= x.high)], v[(t >= x.low) & (t <= x.high)], n) for t, v, n in lines]
    peak = max((float(np.abs(v).max(initial=0.0)) for _, v, _ in shown), default=0.0)
    most = 1.08 * (min(peak, limit) or 1.0)
    y = svg.PixelAxis(-most, most, bottom, top)
    parts = [svg.label(LEFT, top - 8.0, name, "name", "start")]
    for value in svg.ticks(-most, most, 5):  # one at least on each side of 0
        level = y.place(value)
        parts.append(svg.line(LEFT, level, RIGHT, level, "grid"))
        parts.append(svg.label(LEFT - 7.0, level + 4.5, f"{value:z.4g}".replace("-", "−"), anchor="end"))
    inside: list[str] = []
    for time, values, number in reversed(shown):
        across, up = svg.thinned(time, np.clip(values, -2.0 * most, 2.0 * most))
        inside.append(svg.polyline(x.at(across), y.at(up), f"{class_} side{number}"))
    wide, high = RIGHT - LEFT, bottom - top
    window = f"{LEFT:g} {top:g} {wide:g} {high:g}"
    clip = svg.element("svg", "".join(inside), x=LEFT, y=top, width=wide, height=high, viewBox=window)
    return [*parts, clip]


def _times(x: svg.PixelAxis, language: str) -> list[str]:
    bottom = PANELS[-1][1]
    parts = [svg.line(LEFT, bottom, RIGHT, bottom, "axis")]
    for value in svg.ticks(x.low, x.high, 8):
        parts += svg.tick(x.place(value), bottom, f"{value:g}")
    return [*parts, svg.label(0.5 * (LEFT + RIGHT), bottom + 38.0, word("axis_time", language), "name")]


def _failures(x: svg.PixelAxis, pair: RunPair, language: str) -> list[str]:
    """Return a line and a word where a device fails."""
    top, bottom = PANELS[1][0], PANELS[2][1]
    times = sorted({d.failure_time for run in pair.scene.runs for d in run.devices if d.failed})
    parts = [svg.line(x.place(t), top, x.place(t), bottom, "broken") for t in times if x.low <= t <= x.high]
    if parts:
        right = times[0] < 0.5 * (x.low + x.high)
        across = x.place(times[0]) + (5.0 if right else -5.0)
        text = word("device_failure", language)
        parts.append(svg.label(across, top + 12.0, text, "name halo", "start" if right else "end"))
    return parts

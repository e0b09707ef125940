"""Pairs of runs shown side by side: the same motion and the same draw, without and with a measure."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.report.film import ground_displacement
from stayput.report.history import History, history
from stayput.report.verdict.numbers import angle, length
from stayput.report.verdict.replay import felt, replay_under
from stayput.report.verdict.words import HARDLY, OUTCOMES, place
from stayput.simulation import Outcome

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.motion.suites import Suite
    from stayput.simulation import Run
    from stayput.verification import Option, Verdict
    from stayput.verification.verdict import Member

BEFORE, AFTER, LONGEST = 2.0, 4.0, 60.0
"""What is shown before anything moves and after the last thing of note, and at most in all [s]."""

_MOVED = 1e-3
"""Tilt [rad] and slide [m] from which something moves."""

_HARDLY_TILT, _HARDLY_SLIDE = 0.01, 0.005
"""Peaks [rad, m] below which a run is said to hardly move."""

_SHIFT_SHOWN = 0.35
"""Largest movement of the room that is shown, in sizes of the piece."""


@dataclass(frozen=True, slots=True, eq=False)
class Side:
    """One of the two runs.

    Parameters
    ----------
    option : Option
        The measures, or none.
    run : Run
        The run.
    shown : History
        Where the body is when, until it lies.
    """

    option: Option
    run: Run
    shown: History

    def outcome(self, language: str) -> str:
        """Return what became of it, as the end of a sentence."""
        run = self.run
        still = run.outcome in (Outcome.SLID, Outcome.ROCKED)
        hardly = still and run.peak_tilt < _HARDLY_TILT and run.peak_slide < _HARDLY_SLIDE
        return (HARDLY if hardly else OUTCOMES[run.outcome])[place(language)].format(
            slide=length(run.peak_slide, language),
            tilt=angle(run.peak_tilt, language),
            time=f"{run.overturn_time:.1f}",
        )


@dataclass(frozen=True, slots=True, eq=False)
class Pair:
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
    def shift(self) -> tuple[NDArray[np.float64], float]:
        """The room's displacement in the picture at the motion's samples [m], and its scale."""
        ground = ground_displacement(self.motion)
        body = self.sides[0].run.body
        size = max(body.width, body.height)
        inside = (self.motion.time >= self.start) & (self.motion.time <= self.end)
        largest = float(np.abs(ground[inside]).max(initial=0.0))
        scale = min(1.0, _SHIFT_SHOWN * size / largest) if largest > 0.0 else 1.0
        return scale * ground, scale

    @property
    def telling(self) -> float:
        """The most telling moment [s]: halfway through the first fall, else the largest tilt or slide."""
        for side in self.sides:
            if side.run.overturned:
                far = np.abs(side.shown.tilt) > 0.5
                return float(side.shown.time[int(far.argmax())])
        bare = self.sides[0].shown
        largest = np.abs(bare.tilt) if np.abs(bare.tilt).max() > _MOVED else np.abs(bare.slide)
        return min(max(float(bare.time[int(largest.argmax())]), self.start), self.end)


def pairs_of(verdict: Verdict, ground: Suite) -> tuple[Pair, ...]:
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


def _pair(kind: str, verdict: Verdict, member: Member, ground: Suite) -> Pair:
    motion, scale = felt(verdict, ground, member)
    options = [verdict.without.option]
    if verdict.best.option.measures:
        options.append(verdict.best.option)
    runs = [replay_under(verdict, option, member, motion, scale) for option in options]
    sides = tuple(Side(option, run, history(run)) for option, run in zip(options, runs, strict=True))
    start, end = _window(sides, motion)
    return Pair(kind, member, motion.scaled(scale), sides, start, end)


def _window(sides: tuple[Side, ...], motion: Motion) -> tuple[float, float]:
    """Return from when to when something happens."""
    first = motion.duration
    for side in sides:
        shown = side.shown
        moved = (np.abs(shown.tilt - shown.tilt[0]) > _MOVED) | (np.abs(shown.slide) > _MOVED)
        if moved.any():
            first = min(first, float(shown.time[int(moved.argmax())]))
    falls = [side.run.overturn_time for side in sides if side.run.overturned]
    peaks = [
        float(s.shown.time[int(np.abs(v).argmax())]) for s in sides for v in (s.shown.tilt, s.shown.slide)
    ]
    last = max(falls or peaks)
    if first >= last:  # nothing moves: show the strongest shaking
        first = last = float(motion.time[int(np.abs(motion.x).argmax())])
    end = min(motion.duration, last + AFTER)
    start = max(0.0, first - BEFORE, end - LONGEST)
    return math.floor(10.0 * start) / 10.0, end

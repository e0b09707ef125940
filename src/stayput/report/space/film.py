"""The contents of an animation in space: scene and texts of a run, and the time of each frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase, say
from stayput.errors import InputError
from stayput.report.movie import frame_times
from stayput.report.names import motion_label
from stayput.report.scene import DRIFT_CORNER
from stayput.report.space.histories import at_time, peak_of, slid
from stayput.report.space.said import became, names_of
from stayput.report.space.scene import SpaceScene, space_scene

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.simulation.space_run import SpaceRun


@dataclass(frozen=True, slots=True, eq=False)
class SpaceFilm:
    """A run in space made ready for an animation.

    Parameters
    ----------
    scene : SpaceScene
        What is drawn.
    title : str
        What became of the bodies, in one sentence.
    strip_title : str
        Title of the strip with the floor's acceleration.
    language : str
        Language of the texts, "en" or "ja".
    note : str
        A sentence that stands in every frame.
    """

    scene: SpaceScene
    title: str
    strip_title: str
    language: str
    note: str = ""

    @property
    def caption(self) -> str:
        """What the grid and the marks mean."""
        return say("space.caption", self.language, grid=self.scene.grid)

    @property
    def moved(self) -> str:
        """How the room moves in the picture."""
        scale = self.scene.shift_scale
        part = "" if scale >= 1.0 else phrase("runs.drawn_smaller", share=100.0 * scale)
        return say("space.caption_moved", self.language, corner=DRIFT_CORNER, part=part)

    def state(self, time: float) -> str:
        """Return how the first body stands at a time [s], where it is the only one; else nothing."""
        run = self.scene.run
        if len(run.standing) > 1:
            return ""
        tilt = at_time(time, run, np.degrees(run.tilt[0]))
        slide = at_time(time, run, 100.0 * slid(run)[0])
        return say("space.state", self.language, tilt=tilt, slide=slide)

    def times(self, fps: float, speed: float, hold: float) -> NDArray[np.float64]:
        """Return the instant that each frame shows [s]; see `stayput.report.movie.frame_times`."""
        return frame_times(self.scene.start, self.scene.end, fps, speed, hold)


def space_film(
    run: SpaceRun,
    names: Sequence[str] | None,
    language: str,
    beside: Sequence[SpaceRun] = (),
    *,
    note: str = "",
) -> SpaceFilm:
    """Make a run in space ready for an animation.

    Parameters
    ----------
    run : SpaceRun
        The run.
    names : sequence of str, optional
        What the bodies are called; by default by their numbers.
    language : str
        Language of the texts, "en" or "ja".
    beside : sequence of SpaceRun
        Runs that are shown beside each other, this one among them, to one scale.
    note : str
        A sentence that stands in every frame.

    Raises
    ------
    InputError
        The run has fewer than two samples, or there is not a name for each body.
    """
    if len(run.time) < 2:
        raise InputError("runs.too_short", samples=len(run.time))
    called = names_of(run, names, language)
    name, peak = motion_label(run.motion, language), peak_of(run.motion)
    motion = say("space.motion_title", language, name=name, peak=peak)
    strip = say("runs.floor_acceleration", language, motion=motion)
    return SpaceFilm(
        space_scene(run, called, beside), say(became(run, called), language), strip, language, note
    )

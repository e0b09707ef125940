"""The contents of an animation: scene and texts of a run, and the time of each frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.errors import InputError
from stayput.report.history import history
from stayput.report.movie import frame_times
from stayput.report.names import motion_label
from stayput.report.scene import DRIFT_CORNER, Scene, scene_of
from stayput.report.summary import sentences
from stayput.report.window import window_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from stayput.simulation.run import Run


@dataclass(frozen=True, slots=True, eq=False)
class Film:
    """A run made ready for an animation.

    Parameters
    ----------
    scene : Scene
        What is drawn.
    title : str
        What became of the body, in one sentence.
    motion_title : str
        What the motion is called, and its peak.
    language : str
        Language of the texts, "en" or "ja".
    note : str
        A sentence that stands in every frame.
    """

    scene: Scene
    title: str
    motion_title: str
    language: str = "en"
    note: str = ""

    def say(self, key: str, **values: object) -> str:
        """Return a text of `stayput.catalogue.runs` in the film's language."""
        return say(f"runs.{key}", self.language, **values)

    @property
    def caption(self) -> str:
        """How the room moves in the picture."""
        scale = self.scene.shift_scale
        part = "" if scale >= 1.0 else phrase("runs.drawn_smaller", share=100.0 * scale)
        return self.say("caption", corner=DRIFT_CORNER, part=part, grid=self.scene.view.grid)

    @property
    def strip_title(self) -> str:
        """Title of the strip with the floor's acceleration."""
        return self.say("floor_acceleration", motion=self.motion_title)

    def times(self, fps: float, speed: float, hold: float) -> NDArray[np.float64]:
        """Return the instant that each frame shows [s]; see `stayput.report.movie.frame_times`."""
        return frame_times(self.scene.start, self.scene.end, fps, speed, hold)


def film_of(
    run: Run,
    name: str | None = None,
    language: str = "en",
    *,
    seconds: float | None = None,
    note: str = "",
) -> Film:
    """Make a run ready for an animation.

    Parameters
    ----------
    run : Run
        The run.
    name : str, optional
        What the body is called; "body" by default.
    language : str
        Language of the texts, "en" or "ja".
    seconds : float, optional
        How much is shown of it, in which something happens [s]; by default all.
    note : str
        A sentence that stands in every frame.

    Raises
    ------
    InputError
        The run has fewer than two samples.
    """
    if len(run.time) < 2:
        raise InputError("runs.too_short", samples=len(run.time))
    motion = say("runs.motion_title", language, name=motion_label(run.motion, language), peak=run.motion.pga)
    called = phrase("runs.body") if name is None else (name, name)
    title = say(sentences(run, called), language)
    start, end = float(run.time[0]), None
    if seconds is not None:
        shown = history(run)
        start, end = window_of([(run, shown)], run.motion, seconds)
        end = min(end, shown.end)
    return Film(scene_of([run], start=start, end=end), title, motion, language, note)

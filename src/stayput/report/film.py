"""What an animation shows of one run: its scene, what is said beside it, and the instant of each frame."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import say
from stayput.errors import InputError
from stayput.report.scene import DRIFT_CORNER, Scene, scene_of
from stayput.report.summary import motion_label, sentence

if TYPE_CHECKING:
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
    """

    scene: Scene
    title: str
    motion_title: str

    @property
    def caption(self) -> str:
        """Say what is shown of the ground's motion."""
        scale = self.scene.shift_scale
        part = "" if scale >= 1.0 else say("runs.drawn_smaller", share=100.0 * scale)
        return say("runs.caption", corner=DRIFT_CORNER, part=part, grid=self.scene.view.grid)

    def times(self, fps: float, speed: float, hold: float) -> NDArray[np.float64]:
        """Return the instant that each frame shows [s].

        Parameters
        ----------
        fps : float
            Frames a second of the film.
        speed : float
            Seconds of the run shown in one second of the film.
        hold : float
            How long the last pose is held [s of the film].
        """
        start, end = self.scene.start, self.scene.end
        moving = start + np.arange(math.ceil((end - start) * fps / speed - 1e-9)) * speed / fps
        return np.append(moving, np.full(max(1, round(hold * fps)), end))


def film_of(run: Run, name: str = "body") -> Film:
    """Make a run ready for an animation.

    Parameters
    ----------
    run : Run
        The run.
    name : str
        What the body is called.

    Raises
    ------
    InputError
        The run has fewer than two samples.
    """
    if len(run.time) < 2:
        raise InputError("runs.too_short", samples=len(run.time))
    title = say("runs.motion_title", name=motion_label(run.motion), peak=run.motion.pga)
    return Film(scene_of([run], start=float(run.time[0])), sentence(run, name), title)

"""The contents of animations, in the plane and in space: scene and texts of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, TypeVar

from stayput.catalogue import phrase, say
from stayput.errors import InputError
from stayput.report.history import history, peak_of, window_of
from stayput.report.names import motion_label
from stayput.report.scene import DRIFT_CORNER, Scene, scene_of
from stayput.report.space.scene import SpaceScene, space_scene
from stayput.report.space.summary import became, names_of
from stayput.report.summary import sentences

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.simulation.run import Run
    from stayput.simulation.space_run import SpaceRun


AnyScene = TypeVar("AnyScene", Scene, SpaceScene)


@dataclass(frozen=True, slots=True, eq=False)
class Film(Generic[AnyScene]):
    """A run made ready for an animation.

    Parameters
    ----------
    scene : Scene or SpaceScene
        What is drawn.
    title : str
        What became of the bodies, in one sentence.
    strip_title : str
        Title of the strip with the floor's acceleration.
    caption : str
        What the picture shows, and how the room moves in it.
    language : str
        Language of the texts, "en" or "ja".
    note : str
        A sentence that stands in every frame of a GIF or MP4.
    """

    scene: AnyScene
    title: str
    strip_title: str
    caption: str
    language: str
    note: str


def film_of(
    run: Run,
    name: str | None = None,
    language: str = "en",
    *,
    seconds: float | None = None,
    note: str = "",
) -> Film[Scene]:
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
    strip = _strip_title(run, "runs.motion_title", run.motion.pga, language)
    called = phrase("runs.body") if name is None else (name, name)
    start, end = float(run.time[0]), None
    if seconds is not None:
        shown = history(run)
        start, end = window_of([(run, shown)], run.motion, seconds)
        end = min(end, shown.end)
    scene = scene_of([run], start, end)
    caption = say("runs.caption", language, **_movement(scene), grid=scene.view.grid)
    return Film(scene, say(sentences(run, called), language), strip, caption, language, note)


def space_film(
    run: SpaceRun,
    names: Sequence[str] | None,
    language: str,
    beside: Sequence[SpaceRun] = (),
    *,
    note: str = "",
) -> Film[SpaceScene]:
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
    strip = _strip_title(run, "space.motion_title", peak_of(run.motion), language)
    called = names_of(run, names, language)
    scene = space_scene(run, called, beside)
    caption = [
        say("space.caption", language, grid=scene.grid),
        *([say("space.caption_still", language)] if scene.still else []),
        say("space.caption_moved", language, **_movement(scene)),
    ]
    return Film(scene, say(became(run, called), language), strip, " ".join(caption), language, note)


def _strip_title(run: Run | SpaceRun, key: str, peak: float, language: str) -> str:
    """Return the title of the strip with the floor's acceleration, of a run that can be shown."""
    if len(run.time) < 2:
        raise InputError("runs.too_short", samples=len(run.time))
    motion = say(key, language, name=motion_label(run.motion, language), peak=peak)
    return say("runs.floor_acceleration", language, motion=motion)


def _movement(scene: Scene | SpaceScene) -> dict[str, object]:
    """Return the values of a sentence on how the room moves in a picture."""
    scale = scene.shift_scale
    part = "" if scale >= 1.0 else phrase("runs.drawn_smaller", share=100.0 * scale)
    return {"corner": DRIFT_CORNER, "part": part}

"""The contents of animations, in the plane and in space: scene and texts of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from stayput.catalogue import phrase, say
from stayput.errors import InputError
from stayput.report.history import cut_run, history, peak_of, window_in_space, window_of
from stayput.report.names import motion_label
from stayput.report.scene import DRIFT_CORNER, Scene, scene_of
from stayput.report.space.scene import SpaceScene, space_scene
from stayput.report.space.summary import became, names_of
from stayput.report.summary import sentences
from stayput.simulation.space_run import SpaceRun

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.simulation.run import Run


AnyScene = TypeVar("AnyScene", bound=Scene | SpaceScene)


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
    run: Run | SpaceRun,
    names: Sequence[str] | None = None,
    language: str = "en",
    beside: Sequence[SpaceRun] = (),
    *,
    seconds: float | None = None,
    note: str = "",
) -> Film[Any]:
    """Make a run ready for an animation.

    Parameters
    ----------
    run : Run or SpaceRun
        The run.
    names : sequence of str, optional
        What the bodies are called; by default "body", or by their numbers where there are several.
    language : str
        Language of the texts, "en" or "ja".
    beside : sequence of SpaceRun
        Runs in space that are shown beside each other, this one among them, to one scale.
    seconds : float, optional
        How much is shown of it, in which something happens [s]; by default all.
    note : str
        A sentence that stands in every frame.

    Raises
    ------
    InputError
        The run has fewer than two samples, or there is not a name for each body.
    """
    if len(run.time) < 2:
        raise InputError("runs.too_short", samples=len(run.time))
    if isinstance(run, SpaceRun):
        shown = run if seconds is None else cut_run(run, *window_in_space([run], seconds))
        called = names_of(run, names, language)
        scene = space_scene(shown, called, beside)
        told, key, peak = became(run, called), "space.motion_title", peak_of(run.motion)
        caption = [
            say("space.caption", language, grid=scene.grid),
            *([say("space.caption_still", language)] if scene.still else []),
            say("space.caption_moved", language, **_movement(scene)),
        ]
    else:
        start, end = float(run.time[0]), None
        if seconds is not None:
            shown = history(run)
            start, end = window_of([(run, shown)], run.motion, seconds)
            end = min(end, shown.end)
        scene = scene_of([run], start, end)
        told = sentences(run, phrase("runs.body") if names is None else (names[0], names[0]))
        key, peak = "runs.motion_title", run.motion.pga
        caption = [say("runs.caption", language, **_movement(scene), grid=scene.view.grid)]
    motion = say(key, language, name=motion_label(run.motion, language), peak=peak)
    strip = say("runs.floor_acceleration", language, motion=motion)
    return Film(scene, say(told, language), strip, " ".join(caption), language, note)


def _movement(scene: Scene | SpaceScene) -> dict[str, object]:
    """Return the values of a sentence on how the room moves in a picture."""
    scale = scene.shift_scale
    part = "" if scale >= 1.0 else phrase("runs.drawn_smaller", share=100.0 * scale)
    return {"corner": DRIFT_CORNER, "part": part}

"""Animations of runs: GIF, MP4, or a self-contained HTML page."""

from __future__ import annotations

import math
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from markupsafe import Markup, escape
from numpy.typing import NDArray
from PIL import Image

from stayput.catalogue import phrase, say
from stayput.errors import InputError, within
from stayput.files import check_animation, draft
from stayput.report.film.frames import Painter
from stayput.report.film.scene import DRIFT_CORNER, FilmScene, posed, scene_of
from stayput.report.history import AFTER, cut_run, peak_told, telling, window_of
from stayput.report.names import motion_label, names_of
from stayput.report.page import Player, file_of, inks_css, rendered, script_json, script_module
from stayput.report.palette import stability_looks
from stayput.report.summary import sentences
from stayput.wording import check_language

if TYPE_CHECKING:
    from stayput.simulation.run import Run

Progress: TypeAlias = Callable[[int, int], None]
"""Called with the number of frames drawn and the number of all frames."""

FrameAt: TypeAlias = Callable[[float], Image.Image]
"""Draws the frame of an instant [s], in RGB."""

_SHORTEST = 2  # hundredths of a second between a GIF's frames: browsers slow down what is shorter
_COLOURS = 96  # colours of a GIF
_SAMPLED = 12  # frames from which these are chosen

_OF_PICTURE = ("tilt", "slide", "yaw", "strip", "shaken", "scene", "tilt_of", "keys", "no_webgl", "about")
_OF_VIEWS = ("piece", "view", "view_free", "view_front", "view_side", "view_top")
PLAYER_TEXTS = {
    **{key: f"common.{key}" for key in ("play", "pause", "time", "speed")},
    "theme": "runs.player_theme",
    **{key: f"space.{key}" for key in (*_OF_PICTURE, *_OF_VIEWS)},
}
"""Texts of the HTML player: their ids by what the player calls them."""


@dataclass(frozen=True, slots=True, eq=False)
class Film:
    """A run made ready for an animation.

    Parameters
    ----------
    scene : FilmScene
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

    scene: FilmScene
    title: str
    strip_title: str
    caption: str
    language: str
    note: str


def film_of(
    run: Run,
    language: str = "en",
    beside: Sequence[Run] = (),
    *,
    window: tuple[float, float] | None = None,
    note: str = "",
) -> Film:
    """Make a run ready for an animation.

    Parameters
    ----------
    run : Run
        The run.
    language : str
        Language of the texts, "en" or "ja".
    beside : sequence of Run
        Runs that are shown beside each other, this one among them, to one scale.
    window : tuple of float, optional
        The start and the end of what is shown of it [s]; by default all.
    note : str
        A sentence that stands in every frame.

    Raises
    ------
    InputError
        The run has fewer than two samples.
    """
    if len(run.time) < 2:
        raise InputError("runs.too_short", samples=len(run.time))
    if window is None:  # in the plane nothing is followed from when it has overturned
        window = 0.0, run.end + AFTER if run.engine == "plane" and run.overturned else math.inf
    shown, *others = [cut_run(posed(each), *window) for each in (run, *beside)]
    scene = scene_of(shown, names_of(run, language), others)
    scale = scene.shift_scale
    part = "" if scale >= 1.0 else phrase("runs.drawn_smaller", share=100.0 * scale)
    caption = [
        say("space.caption", language, grid=scene.grid),
        *([say("space.caption_still", language)] if scene.still else []),
        say("space.caption_moved", language, corner=DRIFT_CORNER, part=part),
    ]
    name = motion_label(run.motion, language)
    motion = say("runs.motion_title", language, name=name, peak=peak_told(run))
    strip = say("runs.floor_acceleration", language, motion=motion)
    return Film(scene, say(sentences(run), language), strip, " ".join(caption), language, note)


def animate_run(
    run: Run,
    path: str | Path,
    *,
    fps: float = 20.0,
    speed: float = 1.0,
    hold: float = 1.5,
    width: int = 640,
    language: str = "en",
    progress: Progress | None = None,
    seconds: float | None = None,
    note: str = "",
) -> Path:
    """Animate a run: the shaken room to scale, above the floor's acceleration.

    Parameters
    ----------
    run : Run
        The run.
    path : str or Path
        Where to write it: GIF, MP4 (needs ffmpeg) or HTML (a player in one file, which needs a browser with
        WebGL 2 to draw light and shadows), by its ending.
    fps : float
        Frames a second. A GIF counts in hundredths of a second, so 20, 25 and 50 are met exactly and
        others as nearly as can be, at most 50, always at the right speed. The HTML player draws
        as fast as the screen.
    speed : float
        Seconds of the run in one second of the film: 0.25 is slow motion. In the HTML player, the speed
        to start with.
    hold : float
        How long the last pose is held [s].
    width : int
        Width of a frame [pixels]; the height is three quarters of it. Not used for HTML.
    language : str
        Language of the texts, "en" or "ja".
    progress : callable, optional
        Called with the number of frames drawn and the number of all frames.
    seconds : float, optional
        How much of the run is shown, in which something happens [s]; by default all.
    note : str
        A sentence that stands in every frame of a GIF or MP4.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    InputError
        A value out of range, another language, a path that cannot be written, or no
        ffmpeg for an MP4.
    """
    target = check_animation(path)
    within("runs.animation_fps", fps, 1.0, 100.0, field="fps")
    within("runs.animation_speed", speed, 0.01, 100.0, field="speed")
    within("runs.animation_hold", hold, 0.0, 60.0, "s", field="hold")
    within("runs.animation_width", width, 200, 4000, "pixels", field="width")
    window = None if seconds is None else window_of([run], seconds)
    film = film_of(run, check_language(language), window=window, note=note)
    suffix = target.suffix.lower()
    with draft(target) as unfinished:
        if suffix == ".html":
            unfinished.write_text(player_page([film], speed, hold), encoding="utf-8")
            return target
        size = width - width % 2, round(0.375 * width) * 2  # both even, as MP4 needs them
        frame = Painter(film, *size).frame
        delay = max(_SHORTEST, round(100.0 / fps))  # of a GIF
        rate = 100.0 / delay if suffix == ".gif" else fps
        times = frame_times(film.scene.start, film.scene.end, rate, speed, hold)
        images = _images(frame, times, progress)
        if suffix == ".gif":
            _write_gif(images, _palette(frame, times), unfinished, delay)
        else:
            _write_mp4(images, unfinished, size, rate)
    return target


def run_player(run: Run, speed: float = 1.0, language: str = "en") -> Player:
    """Return an animation of a run that notebooks play."""
    film = film_of(run, check_language(language))
    return Player(player_page([film], speed, hold=1.5), film.title)


def player_page(
    films: Sequence[Film], speed: float, hold: float, *, plays: bool = True, labels: Sequence[str] = ("",)
) -> str:
    """Return the HTML player: one file with the runs in it, drawn by the browser as fast as its screen.

    Parameters
    ----------
    films : sequence of Film
        What is shown: one, or several of the same time side by side, in step.
    speed : float
        Seconds of the run in one second, to start with.
    hold : float
        How long the last pose is held before the film starts again [s].
    plays : bool
        Whether it plays at once; else its most telling moment is shown.
    labels : sequence of str
        What stands above each of several.
    """
    first, language = films[0], films[0].language
    texts = {key: say(name, language) for key, name in PLAYER_TEXTS.items()}
    data = {
        "films": [
            {**film.scene.data(), "strip_title": film.strip_title, "label": label}
            for film, label in zip(films, labels, strict=True)
        ],
        "looks": {step: name for step, (name, _) in stability_looks(language).items()},
        "speed": speed,
        "hold_s": hold,
        "plays": plays,
        "telling_s": telling(first.scene.run),
        "texts": texts,
    }
    script = script_module(file_of("film/player.js"))
    code = {"inks": Markup(inks_css()), "data": Markup(script_json(data)), "code": Markup(script)}
    title = escape(first.title) if plays else ""  # a report tells it beside the player
    said = {"language": language, "title": title, "caption": escape(first.caption), "plays": plays}
    return rendered("film/player.html", {**texts, **said, **code})


def frame_times(start: float, end: float, fps: float, speed: float, hold: float) -> NDArray[np.float64]:
    """Return the instant that each frame shows [s].

    Parameters
    ----------
    start, end : float
        What part of the run is shown [s].
    fps : float
        Frames a second of the film.
    speed : float
        Seconds of the run shown in one second of the film.
    hold : float
        How long the last pose is held [s of the film].
    """
    moving = start + np.arange(math.ceil((end - start) * fps / speed - 1e-9)) * speed / fps
    return np.append(moving, np.full(max(1, round(hold * fps)), end))


def _images(frame: FrameAt, times: NDArray[np.float64], progress: Progress | None) -> Iterator[Image.Image]:
    for i, time in enumerate(times):
        yield frame(float(time))
        if progress is not None:
            progress(i + 1, len(times))


def _palette(frame: FrameAt, times: NDArray[np.float64]) -> Image.Image:
    """Return an image whose palette serves every frame: chosen from some of them, one above the other."""
    chosen = np.append(times[:: max(1, len(times) // _SAMPLED)], times[-1])
    samples = [frame(float(time)) for time in chosen]
    sheet = Image.new("RGB", (samples[0].width, sum(image.height for image in samples)))
    for i, image in enumerate(samples):
        sheet.paste(image, (0, i * image.height))
    return sheet.quantize(_COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)


def _write_gif(images: Iterator[Image.Image], colours: Image.Image, path: Path, delay: int) -> None:
    """Write a GIF with one palette for all frames and a delay between them in hundredths of a second."""
    frames = (image.quantize(palette=colours, dither=Image.Dither.NONE) for image in images)
    first = next(frames)
    first.save(path, "GIF", save_all=True, append_images=frames, duration=10 * delay, loop=0)


def _write_mp4(images: Iterator[Image.Image], path: Path, size: tuple[int, int], fps: float) -> None:
    wide, high = size
    command = ["ffmpeg", "-y", "-loglevel", "error", "-xerror"]  # -xerror: a full disk fails, too
    command += f"-f rawvideo -pix_fmt rgb24 -s {wide}x{high} -r {fps:g} -i -".split()
    command += [*["-pix_fmt", "yuv420p", "-movflags", "+faststart"], str(path)]
    with tempfile.TemporaryFile() as messages:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=messages, stderr=messages) as ffmpeg:
            assert ffmpeg.stdin is not None
            try:
                for image in images:
                    ffmpeg.stdin.write(image.tobytes())
            except BrokenPipeError:
                pass  # ffmpeg gave up; its message says why
            except BaseException:
                ffmpeg.kill()
                raise
        if ffmpeg.returncode:
            messages.seek(0)
            output = messages.read().decode(errors="replace").strip().splitlines()
            reason = output[-1] if output else phrase("runs.no_reason")
            raise InputError("runs.no_video", suffix=path.suffix, reason=reason)

"""Animations of a run: GIF, MP4, or a self-contained HTML page."""

from __future__ import annotations

import html
import re
import subprocess
import tempfile
from collections.abc import Callable
from importlib import resources
from typing import TYPE_CHECKING, TypeAlias

from PIL import Image

from stayput.catalogue import phrase, say
from stayput.errors import InputError, within
from stayput.files import check_animation, draft
from stayput.report.embedding import inks_css, script_json, script_module
from stayput.report.film import film_of
from stayput.report.frames import Painter
from stayput.report.palette import mode_looks
from stayput.wording import check_language

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    import numpy as np
    from numpy.typing import NDArray

    from stayput.report.film import Film
    from stayput.simulation.run import Run

Progress: TypeAlias = Callable[[int, int], None]
"""Called with the number of frames drawn and the number of all frames."""

PLAYER_TEXTS = {
    **{key: f"runs.player_{key}" for key in ("tilt", "slide", "theme", "strip", "keys", "tilt_shown")},
    **{key: f"common.{key}" for key in ("play", "pause", "time", "speed")},
}
"""Texts of the HTML player: their ids by what the player calls them."""

_SHORTEST = 2  # hundredths of a second between a GIF's frames: browsers slow down what is shorter
_COLOURS = 64  # colours of a GIF
_SAMPLED = 12  # frames from which these are chosen


def animate_run(
    run: Run,
    path: str | Path,
    *,
    fps: float = 20.0,
    speed: float = 1.0,
    hold: float = 1.5,
    width: int = 640,
    name: str | None = None,
    language: str = "en",
    progress: Progress | None = None,
) -> Path:
    """Animate a run: the shaken room in section, to scale, above the floor's acceleration.

    Parameters
    ----------
    run : Run
        The run.
    path : str or Path
        Where to write it: GIF, MP4 (needs ffmpeg) or HTML (a player in one file), by its ending.
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
    name : str, optional
        What the body is called; "body" by default.
    language : str
        Language of the texts, "en" or "ja".
    progress : callable, optional
        Called with the number of frames drawn and the number of all frames.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    InputError
        A value out of range, another language, a path that cannot be written, or no ffmpeg for an MP4.
    """
    target = check_animation(path)
    within("runs.animation_fps", fps, 1.0, 100.0, field="fps")
    within("runs.animation_speed", speed, 0.01, 100.0, field="speed")
    within("runs.animation_hold", hold, 0.0, 60.0, "s", field="hold")
    within("runs.animation_width", width, 200, 4000, "pixels", field="width")
    film = film_of(run, name, check_language(language))
    with draft(target) as unfinished:
        match target.suffix.lower():
            case ".html":
                unfinished.write_text(player_page(film, speed, hold), encoding="utf-8")
            case ".gif":
                delay = max(_SHORTEST, round(100.0 / fps))
                times = film.times(100.0 / delay, speed, hold)
                _write_gif(film, unfinished, times, delay, width, progress)
            case _:
                _write_mp4(film, unfinished, film.times(fps, speed, hold), fps, width, progress)
    return target


def _images(
    film: Film, times: NDArray[np.float64], width: int, progress: Progress | None
) -> Iterator[Image.Image]:
    painter = Painter(film, width - width % 2, round(0.375 * width) * 2)
    for i, time in enumerate(times):
        yield painter.frame(float(time))
        if progress is not None:
            progress(i + 1, len(times))


def _write_gif(
    film: Film, path: Path, times: NDArray[np.float64], delay: int, width: int, progress: Progress | None
) -> None:
    """Write a GIF with one palette for all frames and a delay between them in hundredths of a second."""
    colours = _palette(film, times, width)
    frames = (
        image.quantize(palette=colours, dither=Image.Dither.NONE)
        for image in _images(film, times, width, progress)
    )
    first = next(frames)
    first.save(path, "GIF", save_all=True, append_images=frames, duration=10 * delay, loop=0)


def _palette(film: Film, times: NDArray[np.float64], width: int) -> Image.Image:
    """Return an image whose palette serves every frame: chosen from some of them, one above the other."""
    chosen = times[:: max(1, len(times) // _SAMPLED)]
    samples = [*_images(film, chosen, width, None), *_images(film, times[-1:], width, None)]
    sheet = Image.new("RGB", (samples[0].width, sum(image.height for image in samples)))
    for i, image in enumerate(samples):
        sheet.paste(image, (0, i * image.height))
    return sheet.quantize(_COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)


def _write_mp4(
    film: Film, path: Path, times: NDArray[np.float64], fps: float, width: int, progress: Progress | None
) -> None:
    size = f"{width - width % 2}x{round(0.375 * width) * 2}"
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", size]
    command += ["-r", f"{fps:g}", "-i", "-", "-pix_fmt", "yuv420p", "-movflags", "+faststart", str(path)]
    with tempfile.TemporaryFile() as messages:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=messages, stderr=messages) as ffmpeg:
            assert ffmpeg.stdin is not None
            try:
                for image in _images(film, times, width, progress):
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


def player_page(film: Film, speed: float, hold: float) -> str:
    """Return the HTML player: one file with the run in it, drawn by the browser as fast as its screen.

    Parameters
    ----------
    film : Film
        What is shown.
    speed : float
        Seconds of the run in one second, to start with.
    hold : float
        How long the last pose is held before the film starts again [s].
    """
    files = resources.files("stayput.report")
    texts = {key: say(name, film.language) for key, name in PLAYER_TEXTS.items()}
    data = {
        **film.scene.data(),
        "title": film.title,
        "strip_title": film.strip_title,
        "caption": film.caption,
        "speed": speed,
        "hold_s": hold,
        "modes": mode_looks(film.language),
        "texts": texts,
    }
    parts = {
        **{key: html.escape(text) for key, text in texts.items()},
        "language": film.language,
        "title": html.escape(film.title),
        "inks": inks_css(),
        "data": script_json(data),
        "code": script_module(files.joinpath("player.js").read_text(encoding="utf-8")),
    }
    page = files.joinpath("player.html").read_text(encoding="utf-8")
    # In one pass, as a title may hold a mark.
    return re.sub(r"\{\{(\w+)\}\}", lambda mark: parts[mark[1]], page)

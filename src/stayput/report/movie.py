"""Films of runs, whatever is in their frames: settings, times of the frames, GIF and MP4 files."""

from __future__ import annotations

import math
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, TypeAlias

import numpy as np
from PIL import Image

from stayput.catalogue import phrase
from stayput.errors import InputError, within

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from numpy.typing import NDArray

Progress: TypeAlias = Callable[[int, int], None]
"""Called with the number of frames drawn and the number of all frames."""

Times: TypeAlias = Callable[[float, float, float], "NDArray[np.float64]"]
"""Gives the instants that the frames show, from fps, speed and hold; see `frame_times`."""

PainterOf: TypeAlias = "Callable[[int, int], FramePainter]"
"""Gives what draws frames of a width and height [pixels]."""

_SHORTEST = 2  # hundredths of a second between a GIF's frames: browsers slow down what is shorter
_COLOURS = 64  # colours of a GIF
_SAMPLED = 12  # frames from which these are chosen


class FramePainter(Protocol):
    """Draws the frames of one film."""

    def frame(self, time: float) -> Image.Image:
        """Return the frame of an instant [s], in RGB."""
        ...


@dataclass(frozen=True, slots=True)
class FilmSettings:
    """How a film is made.

    Parameters
    ----------
    fps : float
        Frames a second.
    speed : float
        Seconds of the run in one second of the film.
    hold : float
        How long the last pose is held [s].
    width : int
        Width of a frame [pixels]; the height is three quarters of it.
    progress : callable, optional
        Called with the number of frames drawn and the number of all frames.

    Raises
    ------
    InputError
        A value out of range.
    """

    fps: float
    speed: float
    hold: float
    width: int
    progress: Progress | None

    def __post_init__(self) -> None:
        within("runs.animation_fps", self.fps, 1.0, 100.0, field="fps")
        within("runs.animation_speed", self.speed, 0.01, 100.0, field="speed")
        within("runs.animation_hold", self.hold, 0.0, 60.0, "s", field="hold")
        within("runs.animation_width", self.width, 200, 4000, "pixels", field="width")

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of a frame [pixels], both even as MP4 needs them."""
        return self.width - self.width % 2, round(0.375 * self.width) * 2


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


def write_film(times: Times, painter_of: PainterOf, path: Path, settings: FilmSettings) -> None:
    """Write a film as a GIF or MP4, by its ending.

    Raises
    ------
    InputError
        ffmpeg could not write it.
    """
    painter = painter_of(*settings.size)
    if path.suffix.lower() == ".gif":
        delay = max(_SHORTEST, round(100.0 / settings.fps))
        shown = times(100.0 / delay, settings.speed, settings.hold)
        _write_gif(painter, path, shown, delay, settings.progress)
    else:
        _write_mp4(painter, path, times(settings.fps, settings.speed, settings.hold), settings)


def _images(
    painter: FramePainter, times: NDArray[np.float64], progress: Progress | None
) -> Iterator[Image.Image]:
    for i, time in enumerate(times):
        yield painter.frame(float(time))
        if progress is not None:
            progress(i + 1, len(times))


def _write_gif(
    painter: FramePainter, path: Path, times: NDArray[np.float64], delay: int, progress: Progress | None
) -> None:
    """Write a GIF with one palette for all frames and a delay between them in hundredths of a second."""
    colours = _palette(painter, times)
    frames = (
        image.quantize(palette=colours, dither=Image.Dither.NONE)
        for image in _images(painter, times, progress)
    )
    first = next(frames)
    first.save(path, "GIF", save_all=True, append_images=frames, duration=10 * delay, loop=0)


def _palette(painter: FramePainter, times: NDArray[np.float64]) -> Image.Image:
    """Return an image whose palette serves every frame: chosen from some of them, one above the other."""
    chosen = np.append(times[:: max(1, len(times) // _SAMPLED)], times[-1])
    samples = [painter.frame(float(time)) for time in chosen]
    sheet = Image.new("RGB", (samples[0].width, sum(image.height for image in samples)))
    for i, image in enumerate(samples):
        sheet.paste(image, (0, i * image.height))
    return sheet.quantize(_COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)


def _write_mp4(painter: FramePainter, path: Path, times: NDArray[np.float64], settings: FilmSettings) -> None:
    size = "{}x{}".format(*settings.size)
    command = ["ffmpeg", "-y", "-loglevel", "error", "-xerror"]  # which a full disk fails, too
    command += ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", size]
    command += [
        "-r",
        f"{settings.fps:g}",
        "-i",
        "-",
        "-pix_fmt",
        "yuv420p",
        "-movflags",
        "+faststart",
        str(path),
    ]
    with tempfile.TemporaryFile() as messages:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=messages, stderr=messages) as ffmpeg:
            assert ffmpeg.stdin is not None
            try:
                for image in _images(painter, times, settings.progress):
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

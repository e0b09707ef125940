"""Animations of a run: GIF, MP4, or a self-contained HTML page."""

from __future__ import annotations

from functools import partial
from importlib import resources
from typing import TYPE_CHECKING

from stayput.catalogue import say
from stayput.files import check_animation, draft
from stayput.report.embedding import Player, filled, inks_css, script_json, script_module
from stayput.report.film import film_of
from stayput.report.frames import Painter
from stayput.report.movie import FilmSettings, Progress, write_film
from stayput.report.palette import mode_looks
from stayput.wording import check_language

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.report.film import Film
    from stayput.simulation.run import Run

PLAYER_TEXTS = {
    **{key: f"runs.player_{key}" for key in ("tilt", "slide", "theme", "strip", "keys", "tilt_shown")},
    **{key: f"common.{key}" for key in ("play", "pause", "time", "speed")},
}
"""Texts of the HTML player: their ids by what the player calls them."""


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
    seconds: float | None = None,
    note: str = "",
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
        A value out of range, another language, a path that cannot be written, or no ffmpeg for an MP4.
    """
    target = check_animation(path)
    settings = FilmSettings(fps, speed, hold, width, progress)
    film = film_of(run, name, check_language(language), seconds=seconds, note=note)
    with draft(target) as unfinished:
        if target.suffix.lower() == ".html":
            unfinished.write_text(player_page(film, speed, hold), encoding="utf-8")
        else:
            write_film(film.times, partial(Painter, film), unfinished, settings)
    return target


def run_player(run: Run, language: str = "en") -> Player:
    """Return an animation of a run that notebooks play."""
    film = film_of(run, None, check_language(language))
    return Player(player_page(film, speed=1.0, hold=1.5), film.title)


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
    script = files.joinpath("player.js").read_text(encoding="utf-8")
    code = {"inks": inks_css(), "data": script_json(data), "code": script_module(script)}
    page = files.joinpath("player.html").read_text(encoding="utf-8")
    return filled(page, {**texts, "language": film.language, "title": film.title}, code)

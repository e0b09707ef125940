"""Animations of a run in space: GIF, MP4, or a self-contained HTML page."""

from __future__ import annotations

from functools import partial
from importlib import resources
from typing import TYPE_CHECKING

from stayput.catalogue import say
from stayput.files import check_animation, draft
from stayput.report.embedding import Player, filled, inks_css, script_json, script_module
from stayput.report.movie import FilmSettings, Progress, write_film
from stayput.report.space.film import SpaceFilm, space_film
from stayput.report.space.frames import SpacePainter
from stayput.report.window import cut_run, window_in_space
from stayput.wording import check_language

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.simulation.space_run import SpaceRun

_OWN_TEXTS = (
    *("body", "tilt", "slide", "yaw", "view", "view_free", "view_front", "view_side", "view_top"),
    *("shaken", "scene", "strip", "tilt_of", "keys", "no_webgl"),
)

SPACE_PLAYER_TEXTS = {
    **{key: f"space.{key}" for key in _OWN_TEXTS},
    **{key: f"common.{key}" for key in ("play", "pause", "time", "speed")},
    "theme": "runs.player_theme",
}
"""Texts of the HTML player in space: their ids by what the player calls them."""


def animate_space_run(
    run: SpaceRun,
    path: str | Path,
    *,
    names: Sequence[str] | None = None,
    fps: float = 20.0,
    speed: float = 1.0,
    hold: float = 1.5,
    width: int = 640,
    language: str = "en",
    progress: Progress | None = None,
    seconds: float | None = None,
    note: str = "",
) -> Path:
    """Animate a run in space: the bodies in their room, above the floor's acceleration.

    Parameters
    ----------
    run : SpaceRun
        The run.
    path : str or Path
        Where to write it: GIF, MP4 (needs ffmpeg) or HTML (a player in one file, which needs a browser with
        WebGL 2 to draw surfaces), by its ending.
    names : sequence of str, optional
        What the bodies are called; by default by their numbers.
    fps, speed, hold, width, progress, seconds, note
        As for `stayput.report.animation.animate_run`.
    language : str
        Language of the texts, "en" or "ja".

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    InputError
        A value out of range, another language, not a name for each body, a path that cannot be written, or no
        ffmpeg for an MP4.
    """
    target = check_animation(path)
    settings = FilmSettings(fps, speed, hold, width, progress)
    shown = run if seconds is None else cut_run(run, *window_in_space([run], seconds))
    film = space_film(shown, names, check_language(language), note=note)
    with draft(target) as unfinished:
        if target.suffix.lower() == ".html":
            unfinished.write_text(space_player_page(film, speed, hold), encoding="utf-8")
        else:
            write_film(film.times, partial(SpacePainter, film), unfinished, settings)
    return target


def space_run_player(run: SpaceRun, names: Sequence[str] | None, speed: float, language: str) -> Player:
    """Return an animation of a run in space that notebooks play."""
    film = space_film(run, names, check_language(language))
    return Player(space_player_page(film, speed, hold=1.5), film.title)


def space_player_page(film: SpaceFilm, speed: float, hold: float, *, plays: bool = True) -> str:
    """Return the HTML player: one file with the run in it, drawn by the browser as fast as its screen.

    Parameters
    ----------
    film : SpaceFilm
        What is shown.
    speed : float
        Seconds of the run in one second, to start with.
    hold : float
        How long the last pose is held before the film starts again [s].
    plays : bool
        Whether it plays at once.
    """
    files = resources.files("stayput.report.space")
    texts = {key: say(name, film.language) for key, name in SPACE_PLAYER_TEXTS.items()}
    data = {
        **film.scene.data(),
        "title": film.title,
        "strip_title": film.strip_title,
        "speed": speed,
        "hold_s": hold,
        "plays": plays,
        "texts": texts,
    }
    script = files.joinpath("player.js").read_text(encoding="utf-8")
    code = {"inks": inks_css(), "data": script_json(data), "code": script_module(script)}
    page = files.joinpath("player.html").read_text(encoding="utf-8")
    said = {"language": film.language, "title": film.title, "caption": film.caption, "moved": film.moved}
    return filled(page, {**texts, **said}, code)

"""Animations of runs in the plane and in space: their files, texts and frames."""

from __future__ import annotations

import math
import shutil
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
import report_runs
import space_runs
from PIL import Image

import stayput as sp
from stayput.report.animation import animate_run, film_of, frame_times, player_page
from stayput.report.figures import font, wrapped
from stayput.report.film.layout import FrameLayout
from stayput.report.palette import ALARM, rgb

if TYPE_CHECKING:
    from pathlib import Path

SHORT, LONG = "the north component of a record with a long name.csv", "地震の揺れの記録の名前" * 12


RUNS = {"plane": report_runs.falling(), "space": space_runs.falling()}


def animated(kind: str, path: Path, **options: Any) -> Path:
    """Animate a run that falls."""
    return animate_run(RUNS[kind], path, **options)


both = pytest.mark.parametrize("kind", ["plane", "space"])


@pytest.mark.parametrize(("fps", "speed"), [(20.0, 1.0), (30.0, 0.5), (25.0, 2.0)])
def test_frames_show_every_instant_once_and_then_hold(fps: float, speed: float):
    times = frame_times(0.0, 2.505, fps, speed, hold=1.0)
    moving = times[times < 2.505]
    assert moving == pytest.approx(np.arange(len(moving)) * speed / fps)
    assert len(moving) == math.ceil(2.505 * fps / speed)
    assert len(times) - len(moving) == fps


def test_a_gif_has_its_frames_and_its_time(tmp_path: Path):
    seen: list[tuple[int, int]] = []
    path = animated("plane", tmp_path / "a.gif", fps=10, hold=0.5, progress=lambda *step: seen.append(step))
    with Image.open(path) as gif:
        durations, cursors = [], []
        for k in range(gif.n_frames):
            gif.seek(k)
            durations.append(gif.info["duration"])
            strip = np.asarray(gif.convert("RGB"), dtype=int)[390:420]
            red = np.abs(strip - rgb(ALARM)).max(axis=2) < 40
            cursors.append(np.argwhere(red.all(axis=0)).mean())
    assert sum(durations) == 10 * (40 + 5) * 10
    assert seen[-1] == (45, 45)
    assert np.diff(cursors[:25]) == pytest.approx(np.mean(np.diff(cursors[:25])), abs=1.5)  # an even clock
    assert path.stat().st_size < 600_000
    with Image.open(animated("space", tmp_path / "b.gif", fps=10, hold=0.5, width=320)) as gif:
        assert (gif.size, gif.n_frames) == ((320, 240), 21)  # those that hold are one


@both
@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_an_mp4_is_written(tmp_path: Path, kind: str):
    assert animated(kind, tmp_path / "a.mp4", fps=10).read_bytes()[4:8] == b"ftyp"


def test_without_ffmpeg_an_mp4_is_refused_in_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(sp.InputError, match="ffmpeg, which is not installed"):
        animated("plane", tmp_path / "a.mp4")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("kind", "name", "options", "message"),
    [
        *(
            (kind, name, options, message)
            for kind in ("plane", "space")
            for name, options, message in (
                ("a.html", {"language": "fr"}, "language is 'fr'"),
                ("a.avi", {}, "ends in .gif, .mp4, .html"),
                ("nowhere/a.gif", {}, "in a folder that exists"),
                ("a.gif", {"fps": 0.0}, "fps is 0"),
                ("a.gif", {"speed": math.nan}, "speed is nan"),
                ("a.gif", {"width": 10}, "width is 10"),
            )
        )
    ],
)
def test_what_is_refused_leaves_nothing(
    tmp_path: Path, kind: str, name: str, options: dict[str, Any], message: str
):
    with pytest.raises(sp.InputError, match=message):
        animated(kind, tmp_path / name, **options)
    assert not list(tmp_path.iterdir())


def test_an_interrupted_animation_leaves_the_older_file(tmp_path: Path):
    path = tmp_path / "a.gif"
    path.write_text("older")

    def stop(done: int, total: int):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        animated("plane", path, progress=stop)
    assert [file.name for file in tmp_path.iterdir()] == ["a.gif"]
    assert path.read_text() == "older"


def test_players_are_in_the_language_that_is_wanted():
    plane = player_page([film_of(report_runs.falling().named(["本棚"]), "ja")], 1.0, 1.0)
    space = player_page([film_of(space_runs.falling().named(["本棚"]), "ja")], 1.0, 1.0)
    for page in (plane, space):
        assert '<html lang="ja">' in page
        assert all(text in page for text in ("「本棚」は", "再生", "傾き", "床の加速度：", "視点"))
        assert "Space plays" not in page


def test_a_large_ground_displacement_is_drawn_smaller_and_said_so():
    long = replace(report_runs.rocking(), motion=sp.sine(20.0, 0.3, 20.0))
    shake = replace(space_runs.SHAKE, x=20.0 * np.cos(2.0 * space_runs.TIME))
    far = film_of(replace(space_runs.falling(), motion=shake), "en")
    for film in (film_of(long), far):
        assert film.scene.shift_scale < 1.0
        assert "of its size" in film.caption
    assert np.linalg.norm(far.scene.shift, axis=1).max() == pytest.approx(0.9, rel=0.01)
    assert film_of(report_runs.rocking()).scene.shift_scale == 1.0
    assert film_of(space_runs.falling(), "en").scene.shift_scale == 1.0


@pytest.mark.parametrize("text", ["", SHORT, 4 * f"{SHORT}, ", LONG])
def test_texts_of_any_length_are_within_the_frame(text: str):
    layout = FrameLayout(replace(film_of(report_runs.rocking()), strip_title=text, caption=text), 640, 480)
    left, top, right, bottom = layout._strip
    heading, caption = layout._heading, layout._caption
    assert all(heading.face.getlength(line) <= right - left for line in heading.text.splitlines())
    assert all(caption.face.getlength(line) <= 640 for line in caption.text.splitlines())
    assert 40 + layout.scene[1] / 2 <= top - heading.height
    assert bottom + layout._band + caption.height < 480


def test_texts_are_wrapped_between_words_and_between_japanese_letters():
    face = font(11)
    text = "The floor's grid is 0.5 m wide; what is lighter is the front."
    room = face.getlength("floor's grid is 0.5")
    lines = wrapped(text, face, room).split("\n")
    assert " ".join(lines) == text
    assert len(lines) > 2
    assert all(face.getlength(line) <= room for line in lines)
    japanese = "床の格子の間隔は0.5 mです。明るい面または縞のある側が（正面）です。"
    for letters in range(6, 20):
        room = letters * face.getlength("床")
        lines = wrapped(japanese, face, room).split("\n")
        assert "".join(lines).replace(" ", "") == japanese.replace(" ", "")
        assert len(lines) > 1
        assert not any(line.startswith(tuple("。、）」")) or line.endswith(tuple("（「")) for line in lines)
        assert all(face.getlength(line.rstrip("。）")) <= room for line in lines)
    lines = wrapped("x" * 90, face, 100.0).split("\n")
    assert "".join(lines) == "x" * 90
    assert all(face.getlength(line) <= 100.0 for line in lines)

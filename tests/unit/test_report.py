"""Pictures and animations of a run made by hand."""

import dataclasses
import itertools
import json
import math
import re
import shutil
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from PIL import Image
from report_runs import BODY, SHAKE, falling, made, rocking

import stayput as sp
from stayput.report.animation import animate_run, frame_times
from stayput.report.film import film_of
from stayput.report.fonts import font, wrapped
from stayput.report.frames import Painter
from stayput.report.history import history
from stayput.report.names import motion_label
from stayput.report.palette import ALARM, MODE_COLOURS, rgb
from stayput.report.plot import plot_motion, plot_run
from stayput.report.scene import ground_displacement, scene_of, section
from stayput.simulation.outcome import Mode, Outcome


def test_the_history_ends_with_the_body_lying_on_the_floor():
    for sign in (1.0, -1.0):
        shown = history(falling(sign))
        assert shown.end == 2.505
        assert shown.tilt[-1] == pytest.approx(sign * math.pi / 2)
        assert shown.z[-1] == pytest.approx(BODY.width / 2)
        assert shown.x[-1] == pytest.approx(sign * (BODY.width / 2 + BODY.height / 2) + 0.06)
        assert shown.mode[-1] is Mode.OVERTURNED
    upright = rocking()
    assert history(upright).time is upright.time


def test_the_modes_follow_one_another():
    spans = history(falling()).spans()
    assert [mode.value for *_, mode in spans] == ["rest", "slide", "rest", "rock", "overturned"]
    assert spans[1][:2] == pytest.approx((0.5, 1.0))
    assert all(one[1] == two[0] for one, two in itertools.pairwise(spans))


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf"])
def test_plots_are_saved(tmp_path, suffix):
    path = tmp_path / f"run{suffix}"
    falling().figure("Bookcase").savefig(path)
    assert path.read_bytes().startswith({".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}[suffix])
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_the_plot_shows_the_histories_the_events_and_the_modes(tmp_path):
    figure = plot_run(falling(), tmp_path / "a.png", title="A chest")
    acceleration, tilt, slide, modes = figure.axes
    assert acceleration.lines[1].get_ydata() == pytest.approx(SHAKE.x)
    labels = tilt.get_legend_handles_labels()[1]
    assert "critical angle 9.5°" in labels
    assert any("wall reached at 1.0°" in label for label in labels)
    assert "overturned at 2.50 s" in labels
    assert "wall impact" in labels
    assert max(slide.lines[1].get_ydata()) == pytest.approx(6.0)
    shown = [text.get_text() for text in modes.get_legend().get_texts()]
    assert shown == ["stands still", "slides", "rocks", "overturned"]
    colours = Image.open(tmp_path / "a.png").convert("RGB").getcolors(1 << 24)
    assert {rgb(MODE_COLOURS[mode]) for mode in (Mode.REST, Mode.SLIDE, Mode.ROCK)} <= {c for _, c in colours}


def test_a_still_run_is_plotted_too():
    still = made(np.zeros(401), np.zeros(401), ["rest"] * 401, outcome=Outcome.RESTED)
    assert plot_run(still).axes[1].get_ylim()[1] > 0.0


def test_a_motion_is_plotted_with_its_peaks_and_called_synthetic(tmp_path):
    motion = sp.near_fault()
    figure = plot_motion(motion, tmp_path / "m.png")
    assert len(figure.axes) == 9
    assert figure.get_suptitle() == ""
    assert figure.axes[3].lines[1].get_ydata() == pytest.approx(100.0 * motion.velocity)
    assert "(synthetic)" in motion_label(SHAKE)


def test_figures_can_be_made_on_many_threads():
    with ThreadPoolExecutor(3) as pool:
        figures = list(pool.map(plot_run, [rocking()] * 3))
    assert len({len(figure.axes[1].lines) for figure in figures}) == 1


def test_the_ground_of_a_sine_is_a_sine_without_drift():
    f = 0.8
    motion = sp.sine(5.0, f, 80.0, phase=0.3)
    shown = ground_displacement(motion)
    middle = slice(len(shown) // 4, -len(shown) // 4)
    w = 2.0 * math.pi * f
    wanted = -5.0 / w**2 * np.sin(w * motion.time + 0.3) / (1.0 + (0.1 / f) ** 4)
    assert shown[middle] == pytest.approx(wanted[middle], abs=0.002)
    drifting = dataclasses.replace(motion, x=motion.x + 0.05)  # 160 m of drift in the record
    assert np.abs(ground_displacement(drifting) - shown)[middle].max() < 0.15


def test_a_large_ground_displacement_is_drawn_smaller_and_said_so():
    long = dataclasses.replace(rocking(), motion=sp.sine(20.0, 0.3, 20.0))
    film = film_of(long)
    assert film.scene.shift_scale < 1.0
    assert "of its size" in film.caption
    assert film_of(rocking()).scene.shift_scale == 1.0


def test_poses_are_linear_between_samples_and_hold_at_the_end():
    run = falling()
    scene = scene_of([run])
    pose = scene.pose(2.003)
    assert pose.tilt == pytest.approx(0.7 * run.tilt[200] + 0.3 * run.tilt[201])
    assert pose.x == pytest.approx(0.7 * run.x[200] + 0.3 * run.x[201])
    assert pose.mode is Mode.ROCK
    assert scene.pose(99.0) == scene.pose(2.505)
    lowest = min(z for _, z in section(BODY, scene.pose(99.0)))
    assert lowest == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(("fps", "speed"), [(20.0, 1.0), (30.0, 0.5), (25.0, 2.0)])
def test_frames_show_every_instant_once_and_then_hold(fps, speed):
    times = frame_times(0.0, 2.505, fps, speed, hold=1.0)
    moving = times[times < 2.505]
    assert moving == pytest.approx(np.arange(len(moving)) * speed / fps)
    assert len(moving) == math.ceil(2.505 * fps / speed)
    assert len(times) - len(moving) == fps


def test_the_room_is_drawn_to_scale_and_moves_with_the_ground():
    film = film_of(falling())
    painter = Painter(film, 640, 480)
    frame = np.asarray(painter.frame(0.7))
    body = np.argwhere((frame[60:340] == rgb(MODE_COLOURS[Mode.SLIDE])).all(axis=2))
    height, width = body.max(axis=0) - body.min(axis=0)
    line = 4  # pixels of the outline, of both sides
    assert (height + line) / (width + line) == pytest.approx(6.0, rel=0.05)

    def left_edge(time):
        row = np.asarray(painter.frame(time))[200]
        return np.argwhere((row == rgb(MODE_COLOURS[Mode.REST])).all(axis=1)).min()

    first, then = film.scene.pose(0.3), film.scene.pose(1.4)
    moved = then.shift + then.x - first.shift - first.x
    assert left_edge(1.4) - left_edge(0.3) == pytest.approx(moved * (width + line) / 0.3, abs=2.0)


def test_a_gif_has_its_frames_and_its_time(tmp_path):
    seen = []
    path = animate_run(
        falling(), tmp_path / "a.gif", fps=10, hold=0.5, progress=lambda *step: seen.append(step)
    )
    with Image.open(path) as gif:
        durations, cursors = [], []
        for k in range(gif.n_frames):
            gif.seek(k)
            durations.append(gif.info["duration"])
            strip = np.asarray(gif.convert("RGB"), dtype=int)[390:420]
            red = np.abs(strip - rgb(ALARM)).max(axis=2) < 40
            cursors.append(np.argwhere(red.all(axis=0)).mean())
    assert sum(durations) == 10 * (26 + 5) * 10
    assert seen[-1] == (31, 31)
    assert np.diff(cursors[:25]) == pytest.approx(np.mean(np.diff(cursors[:25])), abs=1.5)  # an even clock
    assert path.stat().st_size < 500_000


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_an_mp4_is_written(tmp_path):
    path = animate_run(falling(), tmp_path / "a.mp4", fps=10)
    assert path.read_bytes()[4:8] == b"ftyp"


def test_without_ffmpeg_an_mp4_is_refused_in_a_sentence(tmp_path, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(sp.InputError, match="ffmpeg, which is not installed"):
        animate_run(falling(), tmp_path / "a.mp4")
    assert not list(tmp_path.iterdir())


def test_the_html_page_stands_alone_and_holds_the_histories(tmp_path):
    page = animate_run(falling(), tmp_path / "a.html", name="</script><b>").read_text(encoding="utf-8")
    assert not re.search(r"https?:|src=|@import|url\(", page)
    assert page.count("</script>") == 2
    assert "{{" not in page
    data = json.loads(re.search(r'type="application/json">(.*?)</script>', page, re.DOTALL).group(1))
    shown = history(falling())
    [run], floor = data["runs"], data["floor"]
    for key, values in {"time_s": shown.time, "x_m": shown.x, "tilt_rad": shown.tilt}.items():
        assert run[key] == pytest.approx(values, abs=1e-5)
    assert len(floor["x_m"]) == len(floor["time_s"])
    assert [mode for _, mode in run["modes"]] == ["rest", "slide", "rest", "rock", "overturned"]


def test_the_html_page_is_in_the_language_that_is_wanted(tmp_path):
    page = animate_run(falling(), tmp_path / "a.html", name="本棚", language="ja").read_text(encoding="utf-8")
    assert '<html lang="ja">' in page
    for text in ("本棚は", "再生", "一時停止", "傾き", "床の加速度：", "転倒"):
        assert text in page
    assert "Space plays" not in page


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("a.html", {"language": "fr"}, "language is 'fr'"),
        ("a.avi", {}, "must end in .gif, .mp4, .html"),
        ("nowhere/a.gif", {}, "its folder must exist"),
        ("a.gif", {"fps": 0.0}, "fps is 0"),
        ("a.gif", {"speed": math.nan}, "speed is nan"),
        ("a.gif", {"width": 10}, "width is 10"),
    ],
)
def test_animations_that_are_refused_leave_nothing(tmp_path, name, options, message):
    with pytest.raises(sp.InputError, match=message):
        animate_run(falling(), tmp_path / name, **options)
    assert not list(tmp_path.iterdir())


def test_an_interrupted_animation_leaves_the_older_file(tmp_path):
    path = tmp_path / "a.gif"
    path.write_text("older")

    def stop(done, total):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        animate_run(falling(), path, progress=stop)
    assert [file.name for file in tmp_path.iterdir()] == ["a.gif"]
    assert path.read_text() == "older"


def test_a_scene_holds_all_that_is_drawn_in_si_units():
    scene = scene_of([falling(), rocking()])
    data = scene.data(60.0)
    assert json.loads(json.dumps(data, allow_nan=False))["view"] == data["view"]
    floor, (fallen, upright) = data["floor"], data["runs"]
    assert floor["time_s"][-1] == upright["time_s"][-1] == scene.end
    assert fallen["time_s"][-1] == 2.505
    assert np.diff(floor["time_s"])[:-1] == pytest.approx(1.0 / 60.0, abs=1e-4)
    assert max(map(abs, floor["acceleration_m_s2"])) == pytest.approx(np.abs(SHAKE.x).max(), abs=1e-3)
    assert (fallen["overturned"], upright["overturned"]) == (True, False)
    assert fallen["room"] == {"left_wall_x_m": -0.18, "right_wall_x_m": None, "ceiling_z_m": 2.4}
    feet = [fallen["z_m"][0] + v for _, v in fallen["body"]["corners_m"][:2]]
    assert feet == pytest.approx([0.0, 0.0], abs=1e-5)


def test_a_scene_can_be_a_part_of_the_time():
    scene = scene_of([falling(), rocking()], start=1.0, end=3.0)
    data = scene.data(50.0)
    times = [data["floor"]["time_s"], *(run["time_s"] for run in data["runs"])]
    assert [(one[0], one[-1]) for one in times] == [(1.0, 3.0), (1.0, 2.505), (1.0, 3.0)]


def test_the_view_holds_every_pose_the_near_wall_and_the_ceiling():
    scene = scene_of([falling()])
    view, lying = scene.view, scene.pose(99.0)
    assert all(view.left < x + lying.shift < view.right for x, _ in section(BODY, lying))
    assert view.left < -0.18
    assert view.high > 2.4
    assert view.grid == 0.5
    high = dataclasses.replace(falling(), room=sp.Room(ceiling=sp.Ceiling(9.0)))
    assert scene_of([high]).view.high < 2.5


def test_texts_are_wrapped_between_words_and_between_japanese_letters():
    face = font(11)
    room = face.getlength("floor's grid is 0.5")
    lines = wrapped("The floor's grid is 0.5 m wide; what is lighter is the front.", face, room).split("\n")
    assert " ".join(lines) == "The floor's grid is 0.5 m wide; what is lighter is the front."
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
    name = "x" * 90
    lines = wrapped(name, face, 100.0).split("\n")
    assert "".join(lines) == name
    assert all(face.getlength(line) <= 100.0 for line in lines)


def test_a_film_names_its_motion_in_its_language():
    run = dataclasses.replace(falling(), motion=dataclasses.replace(SHAKE, name="synthetic mixed 3"))
    assert "synthetic mixed 3" in film_of(run).strip_title
    assert "模擬地震動（" in film_of(run, language="ja").strip_title
    assert "synthetic" not in film_of(run, language="ja").strip_title

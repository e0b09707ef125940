"""Pictures and animations of a run made by hand."""

import dataclasses
import itertools
import json
import math

import numpy as np
import pytest
from PIL import Image
from report_runs import BODY, SHAKE, falling, made, rocking

import stayput as sp
from stayput.report.animation import film_of
from stayput.report.frames import Painter
from stayput.report.history import history
from stayput.report.names import motion_label
from stayput.report.palette import MODE_COLOURS, rgb
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


def test_poses_are_linear_between_samples_and_hold_at_the_end():
    run = falling()
    scene = scene_of([run])
    pose = scene.pose(2.003)
    assert pose.tilt == pytest.approx(0.7 * run.tilt[200] + 0.3 * run.tilt[201])
    assert pose.x == pytest.approx(0.7 * run.place[0, 200, 0] + 0.3 * run.place[0, 201, 0])
    assert pose.mode is Mode.ROCK
    assert scene.pose(99.0) == scene.pose(2.505)
    lowest = min(z for _, z in section(BODY, scene.pose(99.0)))
    assert lowest == pytest.approx(0.0, abs=1e-12)


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


def test_a_scene_holds_all_that_is_drawn_in_si_units():
    scene = scene_of([falling(), rocking()])
    data = scene.data(60.0)
    assert json.loads(json.dumps(data, allow_nan=False))["view"] == data["view"]
    floor, (fallen, upright) = data["floor"], data["runs"]
    assert floor["time_s"][-1] == upright["time_s"][-1] == scene.end
    assert fallen["time_s"][-1] == 2.505
    assert np.diff(floor["time_s"])[:-1] == pytest.approx(1.0 / 60.0, abs=1e-4)
    assert max(map(abs, floor["acceleration_m_s2"])) == pytest.approx(np.abs(SHAKE.x).max(), abs=1e-3)
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

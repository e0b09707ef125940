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
from stayput.report.film.frames import Painter
from stayput.report.film.scene import ground_displacement, posed
from stayput.report.history import cut_run, spans, telling, window_of, with_overturning
from stayput.report.names import motion_label
from stayput.report.palette import MODE_COLOURS, STABILITY_COLOURS, rgb
from stayput.report.plot import plot_motion, plot_run
from stayput.simulation.outcome import Mode, Outcome
from stayput.simulation.space_records import matrices


def test_the_history_ends_with_the_body_lying_on_the_floor():
    for sign in (1.0, -1.0):
        shown = with_overturning(falling(sign))
        assert shown.time[-1] == 2.505
        assert shown.tilt[-1] == pytest.approx(sign * math.pi / 2)
        x, _, z = shown.place[0, -1]
        assert z == pytest.approx(BODY.width / 2)
        assert x == pytest.approx(sign * (BODY.width / 2 + BODY.height / 2) + 0.06)
        assert matrices(shown.attitude[0, -1])[:, 2] == pytest.approx([sign, 0.0, 0.0])
        assert shown.mode[-1] == Mode.OVERTURNED
    upright = rocking()
    assert with_overturning(upright) is upright


def test_the_modes_follow_one_another():
    parts = spans(with_overturning(falling()))
    assert [mode.value for *_, mode in parts] == ["rest", "slide", "rest", "rock", "overturned"]
    assert parts[1][:2] == pytest.approx((0.5, 1.0))
    assert all(one[1] == two[0] for one, two in itertools.pairwise(parts))


def test_what_is_shown_begins_before_anything_moves_and_ends_after_the_fall():
    runs = [falling(), rocking()]
    assert window_of(runs) == (0.0, 4.0)
    assert window_of(runs, 1.0) == pytest.approx((1.9, 2.905))
    assert telling(falling()) == pytest.approx(1.5 + 1.005 * math.sqrt(0.5 / (math.pi / 2)), abs=0.01)
    assert telling(rocking()) % (math.pi / 3) == pytest.approx(math.pi / 6, abs=0.01)
    part = cut_run(falling(), 1.0, 2.0)
    assert (part.time[0], part.time[-1], len(part.tilt)) == (1.0, 2.0, 101)
    assert [event.time for event in part.events] == [1.2]


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


def test_a_run_in_the_plane_is_posed_as_one_in_space():
    """Its places are those of the engine in space, with walls, ceiling and devices where that has them."""
    body = sp.Body(0.3, 1.8, 90.0, length=0.9)
    room = sp.Room(left_wall=sp.Wall(0.03), right_wall=sp.Wall(0.4), ceiling=sp.Ceiling(2.4))
    measures = [sp.MEASURES["l_bracket"](), sp.MEASURES["tension_pole"]()]
    shaking = sp.sine(2.0, 1.0, 1.0)
    plane, space = (posed(sp.simulate(body, room, shaking, measures, dimensions=d)) for d in (2, 3))
    assert posed(space) is space
    assert plane.place[0, 0] == pytest.approx(space.place[0, 0], abs=1e-6)
    assert plane.planes.tolist() == space.planes.tolist()
    assert plane.standing[0].solid.vertices.tolist() == space.standing[0].solid.vertices.tolist()
    assert len(plane.devices) == len(plane.springs) == len(space.devices) == 4
    for one, other in zip(plane.springs, space.springs, strict=True):
        assert all(
            abs(one[f"{kind}{axis}"] - other[f"{kind}{axis}"]) < 1e-9 for kind in "pa" for axis in "xyz"
        )


def test_a_body_that_overturned_lies_until_the_motion_ends():
    for sign in (1.0, -1.0):
        run = posed(falling(sign))
        assert np.array_equal(run.time, SHAKE.time)
        assert run.tilt[-1] == pytest.approx(sign * math.pi / 2)
        scene = film_of(falling(sign)).scene
        places, turns = scene.pose(4.0)
        corners = scene.corners(0, turns[0], places[0])
        assert corners[:, 2].min() == pytest.approx(0.0, abs=1e-9)
        assert np.ptp(corners, axis=0) == pytest.approx([BODY.height, BODY.width, BODY.width], abs=1e-9)
    film = film_of(falling())
    assert film.scene.end == 4.0  # not 4 s after the fall, as the motion ends before
    assert film.scene.data()["bodies"][0]["stability"][-1] == (pytest.approx(1.9, abs=0.3), "falls")


def test_the_room_is_drawn_to_scale_and_moves_with_the_ground():
    film = film_of(falling())
    painter = Painter(film, 640, 480)

    def body(time):
        frame = np.asarray(painter.frame(time)).astype(int)[45:330]
        blue = frame[frame[..., 2] > frame[..., 0] + 60]
        shades, counts = np.unique(blue, axis=0, return_counts=True)
        return np.argwhere((frame == shades[counts.argmax()]).all(axis=2))  # the side that is seen

    height, width = np.ptp(body(0.3), axis=0)
    assert height / width == pytest.approx(6.0, rel=0.1)
    scene = film.scene
    (first, _), (then, _) = scene.pose(0.3), scene.pose(1.4)
    moved = scene.shift_at(1.4) + then[0] - scene.shift_at(0.3) - first[0]
    across = body(1.4)[:, 1].mean() - body(0.3)[:, 1].mean()
    assert across == pytest.approx(moved[0] * height / 1.8, abs=4.0)


def test_a_film_shows_how_firmly_a_piece_stands_as_a_band():
    frame = np.asarray(Painter(film_of(falling()), 640, 480).frame(1.0))
    colours = {tuple(colour) for colour in frame[420:440].reshape(-1, 3).tolist()}
    assert {rgb(STABILITY_COLOURS[step]) for step in ("stays", "moves", "falls")} <= colours


def test_runs_side_by_side_share_their_times_and_their_scale():
    runs = falling(), rocking()
    scenes = [film_of(run, beside=runs).scene for run in runs]
    data = [scene.data() for scene in scenes]
    assert data[0]["view"] == data[1]["view"]
    assert data[0]["floor"] == data[1]["floor"]
    assert data[0]["view"]["from"] == "side"
    assert np.array_equal(scenes[0].time, scenes[1].time)
    assert json.loads(json.dumps(data, allow_nan=False))


def test_the_view_holds_every_pose_and_what_holds_the_body():
    """A pole reaches up to the ceiling, which is in the picture."""
    room = sp.Room(left_wall=sp.Wall(0.03), ceiling=sp.Ceiling(2.4))
    run = sp.simulate(BODY, room, SHAKE, [sp.MEASURES["tension_pole"]()])
    film = film_of(run)
    painter = Painter(film, 640, 480)
    wide, high = painter._layout.scene
    for time in (0.0, 1.0, 3.0):
        places, turns = film.scene.pose(time)
        points = [
            film.scene.corners(0, turns[0], places[0]),
            *(film.scene.ends(tie, places, turns) for tie in film.scene.ties),
        ]
        seen = np.array(painter._camera.seen(np.concatenate(points)))
        assert ((seen > 0.0) & (seen < [wide, high])).all()

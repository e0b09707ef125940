"""Pictures and animations of runs in space that are made by hand."""

from __future__ import annotations

import base64
import dataclasses
import json
from typing import Any

import numpy as np
import pytest
from matplotlib.patches import Rectangle
from space_runs import BOX, DRUM, DT, SHAKE, TIME, falling, of_poses, spinning

import stayput as sp
from stayput.report.animation import film_of
from stayput.report.film.frames import VIEWS, Camera, Painter, _from_far, _hull_of
from stayput.report.film.scene import RATE, scene_of
from stayput.report.film.shape import shape_of
from stayput.report.palette import FAINT, LINE_COLOURS, STABILITY_COLOURS, rgb
from stayput.report.plot import plot_run
from stayput.report.summary import sentence
from stayput.simulation.space_records import matrices

NAMES = ["cupboard", "drum", "vase"]


def unpacked(text: str) -> Any:
    return np.frombuffer(base64.b64decode(text), "<f4")


def part(run: sp.Run, *, bodies: slice = slice(None), samples: slice = slice(None)) -> sp.Run:
    poses = run.place[bodies, samples], run.attitude[bodies, samples]
    return of_poses(run.standing[bodies], *poses, run.time[samples])


def test_the_yaw_counts_whole_turns_and_leaves_out_the_tilt() -> None:
    assert [piece.yaw[-1] for piece in spinning().pieces] == pytest.approx([0.0, 3.0 * np.pi, 0.0])
    assert falling()[0].yaw == pytest.approx(0.0, abs=1e-9)


def test_poses_turn_evenly_between_samples_and_hold_at_the_ends() -> None:
    run = spinning()
    scene = scene_of(run, tuple(NAMES))
    for time in (0.3, 0.3041, 1.7777):
        angle = 3.0 * np.pi * time / TIME[-1]
        _, turns = scene.pose(time)
        assert turns[1][0] == pytest.approx([np.cos(angle), -np.sin(angle), 0.0], abs=1e-6)
    assert np.array_equal(scene.pose(99.0)[1], scene.pose(TIME[-1])[1])
    assert np.array_equal(scene.pose(-1.0)[0], run.place[:, 0])


def test_a_scene_has_no_more_poses_than_a_screen_shows() -> None:
    run = falling()
    assert len(scene_of(run, ("box",)).time) == np.ceil(TIME[-1] * RATE) + 1
    slow = part(run, samples=slice(None, None, 4))
    assert np.array_equal(scene_of(slow, ("box",)).time, TIME[::4])


def test_the_data_hold_all_that_is_drawn_in_si_units() -> None:
    run = falling()
    scene = scene_of(run, ("box",))
    data = json.loads(json.dumps(scene.data(), allow_nan=False))
    [body] = data["bodies"]
    place, attitude = unpacked(body["place_m"]).reshape(-1, 3), unpacked(body["attitude"]).reshape(-1, 4)
    assert data["poses"] == {"start_s": 0.0, "end_s": 2.0, "count": len(place)}
    assert place == pytest.approx(scene.place[0], abs=1e-5)
    assert np.linalg.norm(attitude, axis=1) == pytest.approx(1.0, abs=5e-5)
    assert unpacked(body["tilt_rad"])[-1] == pytest.approx(np.pi / 2, abs=1e-5)
    assert unpacked(body["slide_m"])[60] == pytest.approx(0.1, abs=1e-5)
    accelerations = data["floor"]["acceleration_m_s2"]
    assert {name: len(unpacked(text)) for name, text in accelerations.items()} == dict.fromkeys("xyz", 201)
    assert data["floor"]["dt_s"] == DT
    assert [plane[:3] for plane in data["planes"]] == [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]
    assert data["planes"][0][3] == pytest.approx(run.standing[0].reach((1.0, 0.0, 0.0))[0] - 0.1)
    foot = np.array(body["footprint_m"])
    assert np.ptp(foot @ run.standing[0].turn, axis=0) == pytest.approx([0.4, 0.6, 0.0], abs=1e-4)
    vertices = np.array(body["shape"]["vertices_m"])
    lowest = place[-1][2] + ((vertices - body["centre_of_gravity_m"]) @ matrices(attitude[-1])[2]).min()
    assert lowest == pytest.approx(0.0, abs=5e-5)


def test_the_picture_holds_every_pose_near_the_start() -> None:
    run = falling()
    scene = scene_of(run, ("box",))
    for time in (0.0, 1.0, 1.3, 2.0):
        places, turns = scene.pose(time)
        painter = Painter(film_of(run, "en"), 640, 480)
        seen = np.array(painter._camera.seen(scene.corners(0, turns[0], places[0])))
        assert (seen > 0.0).all()
        assert (seen < [1280, 622]).all()
    far = dataclasses.replace(run, place=run.place + 50.0 * TIME[:, np.newaxis])
    assert np.ptp(scene_of(far, ("box",)).points, axis=0).max() < 15.0


def test_runs_beside_each_other_are_drawn_to_one_scale() -> None:
    fallen = falling()
    still = part(fallen, samples=slice(None))
    still = dataclasses.replace(still, place=np.repeat(fallen.place[:, :1], len(fallen.time), axis=1))
    runs = (fallen, still)
    views = [scene_of(run, ("box",), runs).data()["view"] for run in runs]
    for key in ("low_m", "high_m", "grid_m"):
        assert views[0][key] == views[1][key]
    assert views[0]["high_m"] != scene_of(still, ("box",)).data()["view"]["high_m"]
    cameras = [Painter(film_of(run, "en", runs), 640, 480)._camera for run in runs]
    assert cameras[0].place == pytest.approx(cameras[1].place)


def test_lines_that_go_behind_the_camera_are_cut_and_the_others_are_whole() -> None:
    camera = Camera(np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 2.0]]), 640, 480, VIEWS["free"])
    behind = camera.place + 5.0 * (camera.place - [0.5, 0.5, 1.0])
    points = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], behind, behind + 1.0])
    lines = [(0, 1), (1, 2), (2, 3), (2, 1)]
    outlines = camera.outlines(points, lines)
    assert [len(outline) for outline in outlines] == [2, 3, 0, 3]  # a line that is cut goes there and back
    for line, outline in zip(lines, outlines, strict=True):
        assert outline == camera.seen(points[list(line)])
    assert outlines[1][0] == outlines[0][1]
    assert outlines[0][1] in outlines[3]


def test_a_box_has_sharp_edges_and_a_round_body_a_smooth_side() -> None:
    box, drum = shape_of(BOX.solid), shape_of(DRUM.solid)
    assert (len(box.edges), box.curved.any()) == (12, False)
    assert (len(drum.edges), int(drum.curved.sum())) == (64, 32)
    panel, arrow = box.marks
    assert panel.corners[:, 0] == pytest.approx(0.2)
    assert arrow.corners[:, 2] == pytest.approx(1.8)
    assert arrow.corners[0, 0] == arrow.corners[:, 0].max()
    stripe = np.concatenate([mark.corners for mark in drum.marks if mark.light])
    assert stripe[:, 0].min() > 0.19
    assert np.abs(stripe[:, 1]).max() < 0.03
    for shape in (box, drum):
        for mark in shape.marks:
            face = shape.solid.vertices[shape.solid.faces[mark.face]]
            assert (mark.corners - face[0]) @ shape.solid.normals[mark.face] == pytest.approx(0.0, abs=1e-9)
            assert np.cross(*np.diff(mark.corners[:3], axis=0)) @ shape.solid.normals[mark.face] > 0.0


def test_near_bodies_are_drawn_over_those_they_hide() -> None:
    """The drum on the box, and the one in front of it, whichever body comes first."""
    run = spinning()
    for order in ([0, 1, 2], [2, 1, 0], [1, 0, 2]):
        mixed = of_poses([run.standing[b] for b in order], run.place[order], run.attitude[order])
        painter = Painter(film_of(mixed, "en"), 640, 480)
        places, turns = painter._film.scene.pose(0.0)
        corners = [painter._film.scene.corners(b, turns[b], places[b]) for b in range(3)]
        hulls = [_hull_of(*each) for each in zip(painter._film.scene.shapes, corners, turns, strict=True)]
        drawn = [order[b] for b in _from_far(painter._camera.place, hulls)]
        assert drawn.index(0) < drawn.index(2)
        assert drawn.index(0) < drawn.index(1)


def test_frames_show_each_body_by_how_firmly_it_stands() -> None:
    film = film_of(spinning().named(NAMES), "en")
    painter = Painter(film, 640, 480)
    for time in (0.0, 0.7):
        shown = np.asarray(painter.frame(time)).astype(int).reshape(-1, 3)
        present = {film.scene.stability_at(body, time) for body in range(3)}
        for step, colour in STABILITY_COLOURS.items():  # light and shade leave the hue
            hue = np.array(rgb(colour)) / max(rgb(colour))
            near = np.abs(shown / np.maximum(shown.max(axis=1, keepdims=True), 1) - hue).max(axis=1) < 0.02
            assert (near.sum() > 300) == (step in present)


def test_what_became_of_the_bodies() -> None:
    assert sentence(falling().named(["box"])) == "“box” overturned 1.5 s into the motion."
    assert sentence(spinning().named(NAMES)) == "None of the 3 pieces overturned or fell off."
    run, other = falling(), spinning()
    both = of_poses(
        (*run.standing, *other.standing),
        np.concatenate([run.place, other.place]),
        np.concatenate([run.attitude, other.attitude]),
    )
    assert sentence(both.named(["box", *NAMES])) == "1 of 4 pieces overturned or fell off: box at 1.5 s."
    upright = part(run, samples=slice(101))
    assert sentence(upright.named(["box"])) == (
        "“box” did not overturn; it tilted by less than 0.1° and slid by up to 10.0 cm."
    )
    still = part(other, bodies=slice(1))
    assert sentence(still.named(["box"])) == "“box” stayed put: it neither slid nor rocked."
    landed = sp.simulate(sp.Piece(BOX, (0.0, 0.0, 0.1)), sp.Room(), sp.Motion(dt=0.01, x=np.zeros(100)))
    assert sentence(landed.named(["box"])).startswith("“box” did not overturn; it tilted by less than 0.1°")


def test_the_plot_shows_the_histories_and_the_ways_in_plan() -> None:
    figure = plot_run(falling().named(["crate"]))
    acceleration, tilt, slide, plan = figure.axes
    assert [line.get_ydata()[7] for line in acceleration.lines[1:]] == pytest.approx(
        [part[7] for part in SHAKE.components.values()]
    )
    assert max(tilt.lines[1].get_ydata()) == pytest.approx(90.0)
    assert [text.get_text() for text in tilt.get_legend().get_texts()] == ["overturned at 1.50 s"]
    assert slide.lines[1].get_ydata()[60] == pytest.approx(6.0, abs=1e-6)
    first, last, *_ = plan.lines
    assert len(first.get_xdata()) == 5
    assert np.ptp(last.get_xdata()) > 1.7
    assert [text.get_text() for text in plan.get_legend().get_texts()] == ["crate"]
    assert figure.get_suptitle() == ""


def test_the_plot_of_a_room_has_its_walls_and_windows() -> None:
    window = sp.Window("far_side_wall", start=1.0, width=2.0)
    plan = sp.FloorPlan(4.0, 3.0, windows=[window])
    run = dataclasses.replace(falling().named(["crate"]), plan=plan)
    *_, axis = plot_run(run, title="A room").axes
    assert (axis.get_xlabel(), axis.get_ylabel()) == (
        "x, from the left wall [m]",
        "y, from the near wall [m]",
    )
    (walls,) = (patch for patch in axis.patches if isinstance(patch, Rectangle))
    assert walls.get_bbox().extents == pytest.approx([0.0, 0.0, 4.0, 3.0])
    (opening,) = (line for line in axis.lines if line.get_linewidth() == 2.5)
    assert set(zip(*opening.get_data(), strict=True)) == {(1.0, 3.0), (3.0, 3.0)}
    low, high = axis.get_xlim()
    assert -0.5 < low < 0.0
    assert 4.0 < high < 4.5


def test_a_still_run_of_several_bodies_is_plotted_in_japanese() -> None:
    figure = plot_run(spinning().named(NAMES), language="ja")
    assert figure.axes[3].get_xlabel() == "x、正面側 [m]"
    assert figure.axes[1].get_ylim() == (-0.1, 0.1)
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["食器棚", "drum", "vase"]


def test_bodies_of_one_colour_have_other_dashes_and_long_titles_are_wrapped() -> None:
    one = falling()
    count = len(LINE_COLOURS) + 1
    poses = np.repeat(one.place, count, axis=0), np.repeat(one.attitude, count, axis=0)
    names = [f"a piece with a long name, number {b}" for b in range(count)]
    run = of_poses(count * one.standing, *poses).named(names)
    figure = plot_run(run, title=sentence(run))
    first, *_, last = figure.legends[0].get_lines()[:count]
    assert first.get_color() == last.get_color()
    assert first.get_linestyle() != last.get_linestyle()
    figure.draw_without_rendering()
    wide = figure.bbox.width
    for text in (figure._suptitle, figure.legends[0]):
        box = text.get_window_extent()
        assert box.x0 >= 0.0
        assert box.x1 <= wide
    assert figure.axes[1].get_legend() is None


def test_devices_are_drawn_from_the_body_to_where_they_hold() -> None:
    """A pole reaches up to the ceiling, a bracket is where it is screwed on, a joint joins both bodies."""
    body = sp.Body(0.4, 1.8, 100.0, length=0.9)
    room = sp.Room(left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.4))
    still = sp.Motion(dt=0.01, x=np.zeros(11))
    measures = [sp.MEASURES["l_bracket"](), sp.MEASURES["tension_pole"]()]
    scene = scene_of(sp.simulate(body, room, still, measures, dimensions=3), ("body",))
    places, turns = scene.pose(0.0)
    brackets, poles = np.split(np.array([scene.ends(tie, places, turns) for tie in scene.ties]), 2)
    np.testing.assert_allclose(brackets[:, 0], brackets[:, 1], atol=1e-9)
    np.testing.assert_allclose(poles[:, :, 2], [[1.8, 2.4]] * 2)
    np.testing.assert_allclose(sorted(poles[:, 0, 1]), [-0.225, 0.225])
    lower, upper = sp.Body.box(0.4, 0.8, 0.9, 40.0), sp.Body.box(0.3, 0.8, 0.9, 20.0)
    joint = sp.Joint(1, 0, (-0.1, 0.3, 0.9), strength=1.0)
    stack = sp.Scene([sp.Piece(lower), sp.Piece(upper, (0.0, 0.0, 0.9))], joints=[joint])
    run = sp.simulate(stack, sp.near_fault())
    (tie,) = scene_of(run, ("lower", "upper")).ties
    assert (tie.body, tie.other) == (1, 0)
    np.testing.assert_allclose(tie.point, [-0.1, 0.3, 0.0], atol=1e-9)
    np.testing.assert_allclose(tie.anchor, [-0.1, 0.3, 0.9], atol=1e-9)
    assert tie.lost == run.devices[0].failure_time < 10.0


def test_what_a_piece_does_after_its_fall_is_drawn_grey() -> None:
    vase = sp.Piece(sp.Body.cone(0.1, 0.22, 0.35, 1.8), tilt=(0.0, 0.4, 0.0), at=(0.0, 0.0, 0.05))
    run = sp.simulate(vase, sp.Room(), sp.Motion(dt=0.01, x=np.zeros(101), name="still"))
    assert run.overturned
    _, tilt, slide, plan = run.figure().axes
    for axis in (tilt, slide, plan):
        (after,) = (line for line in axis.lines if line.get_color() == FAINT)
        assert len(after.get_xdata()) == np.count_nonzero(run.time > run.overturn_time)

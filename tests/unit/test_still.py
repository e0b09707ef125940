"""What stands still in a picture of a room: places of people, doors and windows."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np
from space_runs import falling

import stayput as sp
from stayput.report.animation import film_of
from stayput.report.film import frames
from stayput.report.film.frames import Painter
from stayput.report.film.scene import scene_of
from stayput.report.film.shape import STILL_LOOKS, still_of
from stayput.report.plot import plot_run

if TYPE_CHECKING:
    import pytest

    from stayput.report.film.shape import StillShape

PLAN = sp.FloorPlan(
    3.0,
    2.0,
    doors=[sp.Door("left_wall", 0.5, 0.8), sp.Door("right_wall", 0.5, 0.8, opens="sliding", name="other")],
    windows=[sp.Window("far_side_wall", 1.0, 1.5, sill=0.9)],
    places=[sp.PersonPlace.of("bed", (1.0, 1.0)), sp.PersonPlace.of("desk", (2.5, 1.5))],
)


def room_run() -> sp.Run:
    return dataclasses.replace(falling(), plan=PLAN)


def test_beds_have_a_box_below_and_one_of_the_person_with_a_pillow() -> None:
    below, person, desk = (one for one in still_of(room_run()) if one.role in ("furniture", "person"))
    assert (below.role, person.role, desk.role) == ("furniture", "person", "person")
    assert below.points.min(axis=0).tolist() == [0.5, 0.0, 0.0]
    assert below.points.max(axis=0).tolist() == [1.5, 2.0, 0.45]
    assert person.points[:, 2].min() == 0.45
    assert person.points[:, 2].max() == 0.75
    pillow = person.lines[-1]
    assert np.allclose(pillow.mean(axis=0)[2], 0.75)
    assert pillow[:, 1].max() < 0.5  # at the head, at −y
    assert len(desk.lines) == len(person.lines) - 1  # who sits there has no pillow


def test_doors_swing_inwards_and_windows_stand_on_their_sill() -> None:
    window, door, sliding = still_of(room_run())[:3]
    assert (window.role, door.role) == ("window", "door")
    assert window.points.min(axis=0).tolist() == [1.0, 2.0, 0.9]
    assert np.allclose(window.points.max(axis=0), [2.5, 2.0, 2.1])
    arc, leaf = door.lines[1:]
    assert np.allclose(np.hypot(arc[:, 0], arc[:, 1] - 0.5), 0.8)
    assert np.allclose(leaf, [(0.0, 0.5, 0.0), (0.8, 0.5, 0.0)])
    assert len(sliding.lines) == 1  # it takes no floor


def test_faces_look_outwards() -> None:
    for one in still_of(room_run()):
        middle = np.array([1.5, 1.0, 1.0]) if one.role in ("door", "window") else one.points.mean(axis=0)
        ways = np.array([face.mean(axis=0) - middle for face in one.faces])
        along = np.einsum("fi,fi->f", ways, one.normals)
        assert (along < 0.0).all() if one.role in ("door", "window") else (along > 0.0).all()


def test_none_passes_the_ceiling() -> None:
    run = dataclasses.replace(room_run(), room=sp.Room(ceiling=sp.Ceiling(1.5)))
    assert max(one.points[:, 2].max() for one in still_of(run) if one.role != "person") == 1.5


def test_a_scene_shows_them_all_and_a_run_without_a_plan_has_none() -> None:
    scene = scene_of(room_run(), ("box",))
    assert [one["role"] for one in scene.data()["still"]] == [one.role for one in still_of(room_run())]
    assert scene.low[:2].tolist() <= [0.0, 0.0]
    assert (scene.high[:2] >= [3.0, 2.0]).all()
    assert scene_of(falling(), ("box",)).data()["still"] == []


def test_films_and_plots_draw_them() -> None:
    film = film_of(room_run())
    assert "hold nothing up" in film.caption
    assert "hold nothing up" not in film_of(falling()).caption
    bare = dataclasses.replace(film, scene=dataclasses.replace(film.scene, still=()))
    shown, empty = (np.asarray(Painter(one, 480, 360).frame(0.0), float) for one in (film, bare))
    blue = shown[..., 2] - shown[..., 0] > 30.0
    assert blue.sum() > (empty[..., 2] - empty[..., 0] > 30.0).sum() + 500  # the person's box
    lines = [len(plot_run(run).axes[3].lines) for run in (room_run(), falling())]
    # a wall without a plan is a line of its own, those of a plan are one rectangle
    assert lines[0] - (lines[1] - 1) == sum(len(one.lines) for one in still_of(room_run()))


def test_doors_of_walls_that_are_seen_from_outside_are_drawn_over_the_bodies(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    drawn = list[str]()
    middles = {0.0: "left", 3.0: "right", 2.0: "far"}

    def still(_pen: object, _camera: object, _line: object, one: StillShape) -> None:
        if one.role in ("door", "window"):
            (x, y, _) = one.faces[0].mean(axis=0) if one.faces else one.lines[0].mean(axis=0)
            drawn.append("floor" if not one.faces else middles.get(x) or middles[y])

    def body(*_: object) -> None:
        drawn.append("body")

    monkeypatch.setattr(frames, "_draw_still", still)
    monkeypatch.setattr(frames, "_draw_body", body)
    Painter(film_of(room_run()), 480, 360).frame(0.0)  # seen from the right and the near wall
    bodies = [place for place, one in enumerate(drawn) if one == "body"]
    assert sorted(drawn[: bodies[0]]) == ["far", "floor", "left"]
    assert drawn[bodies[-1] + 1 :] == ["right"]


def test_a_room_is_run_with_its_plan() -> None:
    scenario = sp.Scenario.parse(
        {
            "plan": {"width": 2.0, "length": 2.0},
            "places": [{"at": [1.0, 1.3], "kind": "cot"}],
            "furniture": [{"name": "box", "preset": "chest", "against": "left_wall", "along": 0.6}],
            "shaking": {"sine": {"amplitude": 0.5, "frequency": 2.0}},
        }
    )
    assert {one.role for one in still_of(scenario.run())} == {"furniture", "person"}
    assert set(STILL_LOOKS) >= {one.role for one in still_of(scenario.run())}

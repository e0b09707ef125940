"""Rooms against closed forms and independent computations.

Separating axes of convex bodies: Gottschalk, Lin and Manocha (1996), here against linear programmes. A box
that topples: energy of a rigid body about its edge. Ways out: floors on which one can count the cells.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import linprog

import stayput as sp
from stayput.model.floor_plan import rectangle
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.simulation.groups import Track, at_rest, meet, outline_of, stirring
from stayput.simulation.piece import inside_each_other
from stayput.verification.events import (
    CELL,
    ENTERS_BY,
    PASSAGE,
    RoomContact,
    WalkableGrid,
    contact_with_place,
)


def placed(rng: np.random.Generator, reach: float) -> sp.Piece:
    body = sp.Body.box(*rng.uniform(0.2, 1.0, 3).tolist(), 10.0)
    at, tilt = rng.uniform(-reach, reach, 3), rng.uniform(-2.0, 2.0, 3)
    return sp.Piece(body, tuple(at.tolist()), float(rng.uniform(-3, 3)), tilt=tuple(tilt.tolist()))


def corners_of(one: sp.Piece) -> np.ndarray:
    return one.solid.vertices @ one.turn.T + np.asarray(one.at)


def linear_programme_overlaps(first: np.ndarray, second: np.ndarray) -> bool:
    """Whether a point is a convex combination of the corners of both."""
    n, m = len(first), len(second)
    equal = np.zeros((5, n + m))
    equal[:3, :n], equal[:3, n:] = first.T, -second.T
    equal[3, :n] = equal[4, n:] = 1.0
    found = linprog(np.zeros(n + m), A_eq=equal, b_eq=[0.0, 0.0, 0.0, 1.0, 1.0], bounds=(0.0, None))
    return found.status == 0


def test_separating_axes_agree_with_linear_programmes() -> None:
    rng = np.random.default_rng(5)
    met = 0
    for _ in range(200):
        one, other = placed(rng, 0.6), placed(rng, 0.6)
        expected = linear_programme_overlaps(corners_of(one), corners_of(other))
        assert (inside_each_other(one, other) > 0.0) == expected
        met += expected
    assert 40 < met < 160


def test_separating_axes_of_cylinders_agree_with_linear_programmes() -> None:
    rng = np.random.default_rng(6)
    for _ in range(40):
        tilt = tuple(rng.uniform(-2.0, 2.0, 3).tolist())
        at = tuple(rng.uniform(-0.5, 0.5, 3).tolist())
        one = sp.Piece(sp.Body.cone(0.4, 0.2, 0.8, 10.0), at, tilt=tilt)
        other = placed(rng, 0.4)
        expected = linear_programme_overlaps(corners_of(one), corners_of(other))
        assert (inside_each_other(one, other) > 0.0) == expected


BOX = sp.Body(0.4, 1.8, 100.0, length=0.9)
B, H = 0.5 * BOX.width, 0.5 * BOX.height
R, ALPHA = math.hypot(B, H), math.atan2(B, H)
START = ALPHA + 0.02
AWAY, TOP = 0.8, 0.6
"""How far beyond the box's front edge, and how high, the place of a person has its near upper edge [m]."""

TOUCHES = math.atan2(AWAY, TOP)
"""The front face goes through the front edge of the base: it meets that edge at this tilt."""


def energy(tilt: float | np.ndarray) -> float | np.ndarray:
    """Return the kinetic energy of a box that toppled from START on."""
    return BOX.mass * STANDARD_GRAVITY * R * (math.cos(START - ALPHA) - np.cos(tilt - ALPHA))


def rate(tilt: float | np.ndarray) -> float | np.ndarray:
    """Return how fast it turns then about its edge."""
    return np.sqrt(2.0 * energy(tilt) / (BOX.mass * 4.0 / 3.0 * R * R))


def person(heading: float) -> sp.PersonPlace:
    middle = B + AWAY + 0.5
    at = middle * math.cos(heading), middle * math.sin(heading)
    return sp.PersonPlace("person", at, width=1.0, length=2.0, low=0.3, high=TOP, heading=heading)


def cut(track: Track, count: int) -> Track:
    """Return a track that ends after so many samples."""
    names = ("sample", "place", "turn", "energy")
    return replace(track, **{name: getattr(track, name)[:count] for name in names})


def track_in_plane(pose: Track, x: np.ndarray, z: np.ndarray, tilt: np.ndarray) -> Track:
    """Return the track of a piece that moves in the plane across its length.

    Parameters
    ----------
    pose : Track
        How it stands at first, alone.
    x, z : ndarray, shape (samples,)
        How far its centre of gravity has come to its front and up from there [m].
    tilt : ndarray, shape (samples,)
        By what it has tilted to its front from there [rad].
    """
    shape = pose.shape
    facing = pose.turn[0] @ np.array([1.0, 0.0, 0.0])
    front = np.array([facing[0], facing[1], 0.0]) / np.hypot(facing[0], facing[1])
    place = pose.place[0] + x[:, np.newaxis] * front + z[:, np.newaxis] * [0.0, 0.0, 1.0]
    cos, sin = np.cos(tilt), np.sin(tilt)
    turn = np.zeros((len(tilt), 3, 3))
    across = np.cross([0.0, 0.0, 1.0], front)
    # a turn from up to the front is one about the axis across, by Rodrigues
    outer, skew = np.outer(across, across), np.cross(np.eye(3), across)
    turn = (
        cos[:, np.newaxis, np.newaxis] * (np.eye(3) - outer) + outer + sin[:, np.newaxis, np.newaxis] * skew
    )
    turn = turn @ pose.turn[0]
    moved = stirring(shape, place, turn)
    inertia = float(across @ (pose.turn[0] @ shape.inertia @ pose.turn[0].T) @ across)
    rates = [np.gradient(values, pose.dt) if len(values) > 1 else np.zeros(1) for values in (x, z, tilt)]
    energy = 0.5 * (shape.mass * (rates[0] ** 2 + rates[1] ** 2) + inertia * rates[2] ** 2)
    return Track(pose.piece, moved, place[moved], turn[moved], energy[moved], pose.dt)


def toppling(heading: float) -> tuple[Track, sp.Run]:
    """Return the track of the box, which topples to its front from a tilt beyond its balance."""
    dt, room = 1e-3, sp.Room(sp.Floor(2.0, 2.0))
    still, start = sp.Motion(dt=dt, x=np.zeros(4000)), sp.State(tilt=START, tilt_rate=0.0)
    run = sp.simulate(BOX, room, still, dimensions=2, initial=start)
    upright = at_rest(sp.Piece(BOX, heading=heading), dt)
    # relative to how it stands upright, with the middle of its base at the origin
    return track_in_plane(upright, run.place[0, :, 0], run.place[0, :, 2] - H, run.tilt), run


@pytest.mark.parametrize("heading", [0.0, 0.7, -2.0])
def test_a_toppling_box_hits_a_bed_with_the_speed_and_energy_of_the_fall(heading: float) -> None:
    contact = contact_with_place(toppling(heading)[0], person(heading))
    assert contact is not None
    # it moves on as if nobody were there: later it is faster
    assert contact.energy >= energy(TOUCHES) * 0.99
    assert contact.speed >= 0.98 * rate(TOUCHES) * math.hypot(AWAY, TOP)
    # at the floor, of the farthest point of the face within the place
    last = rate(math.pi / 2)
    assert (
        0.8 * last * math.hypot(1.0 + AWAY, 0.3) < contact.speed < 1.02 * last * math.hypot(1.0 + AWAY, TOP)
    )
    # the time, by quadrature of the energy
    step = (TOUCHES - START) / 200_000
    expected = float(np.sum(step / rate(START + step * (np.arange(200_000) + 0.5))))
    assert contact.time == pytest.approx(expected, abs=0.01)


def test_it_touches_first_with_the_rate_of_the_fall() -> None:
    track, run = toppling(0.0)
    reach = math.hypot(AWAY, TOP)

    def until(tilt: float) -> RoomContact | None:
        """Return the contact with a track that is cut where the piece has this tilt."""
        k = int(np.searchsorted(run.tilt, tilt)) + 1
        return contact_with_place(cut(track, k), person(0.0))

    # the upper edge of the place is at `TOP` below the face at first, and then within it
    deep = TOUCHES + 1.05 * ENTERS_BY / reach
    assert until(TOUCHES + 0.9 * ENTERS_BY / reach) is None
    contact = until(deep)
    assert contact is not None
    assert contact.time == pytest.approx(float(np.interp(TOUCHES, run.tilt, run.time)), abs=2e-3)
    # the point of the face moves across the face, faster from the touch to there
    assert 0.98 * rate(TOUCHES) * reach <= contact.speed <= 1.15 * rate(deep) * reach
    assert contact.energy == pytest.approx(energy(deep), rel=0.01)


@pytest.mark.parametrize(("into", "hits"), [(0.03, False), (0.07, True)])
def test_who_is_nudged_is_not_hit(into: float, hits: bool) -> None:
    """A box that slides upright a little way into a bed's edge, and back, is no blow."""
    start = at_rest(sp.Piece(sp.Body.box(0.6, 1.2, 1.9, 60.0), (-0.301, 0.0, 0.0)), 0.01)
    x = into * np.sin(np.pi * np.linspace(0.0, 1.0, 101))
    place = sp.PersonPlace("bed", (0.5, 0.0), 1.0, 2.0, 0.0, 0.5)
    assert (contact_with_place(track_in_plane(start, x, 0.0 * x, 0.0 * x), place) is not None) is hits


@pytest.mark.parametrize("to", [1.0, -1.0])
def test_only_a_piece_that_falls_into_a_place_hits(to: float) -> None:
    """A box nudges a person by 7 cm, and then topples onto the person or away."""
    start = at_rest(sp.Piece(BOX, (-B - 1e-3, 0.0, 0.0)), 0.01)
    time = np.linspace(0.0, 1.0, 101)
    x = np.concatenate([0.07 * np.sin(np.pi * time), 0.0 * time])
    tilt = np.concatenate([0.0 * time, 0.5 * np.pi * to * time**2])
    # about the edge that it topples over
    side, up = np.sin(np.abs(tilt)), np.cos(tilt)
    x, z = x + to * (B - B * up + H * side), B * side + H * up - H
    place = sp.PersonPlace("person", (0.5, 0.0), 1.0, 2.0, 0.0, 1.25)
    contact = contact_with_place(track_in_plane(start, x, z, tilt), place)
    assert contact is not None
    assert contact.falls == (to > 0.0)
    assert contact.time < 1.0
    # the speed is that of the nudge, at most 0.07 π m/s, or that of the fall
    assert (contact.speed > 1.0) == (to > 0.0)


def test_the_speed_within_a_place_is_the_largest_of_all_samples() -> None:
    # it falls slowly, then fast, then lies there and trembles: the fastest sample is neither first nor last
    shape = at_rest(sp.Piece(sp.Body.box(0.4, 0.9, 1.8, 100.0)), 0.01)
    time = np.linspace(0.0, 3.0, 301)
    tilt = np.where(
        time < 2.0, 0.5 * np.pi * (0.5 * time) ** 6, 0.5 * np.pi - 0.01 * np.sin(40.0 * time) ** 2
    )
    track = track_in_plane(shape, 0.2 * time, 0.0 * time, tilt)
    place = sp.PersonPlace("person", (1.2, 0.1), 1.0, 2.0, 0.5, 1.2, heading=0.3)
    whole = contact_with_place(track, place)
    assert whole is not None
    first = round(whole.time / track.dt) + 1
    # cut short after each sample: the largest so far
    parts = [contact_with_place(cut(track, k), place) for k in range(first + 1, len(track.sample) + 1)]
    speeds = np.array([part.speed for part in parts if part is not None])
    assert len(speeds) > 100
    assert (np.diff(speeds) >= 0.0).all()
    assert whole.speed == speeds[-1] > 2.0 * speeds[0]


def test_two_pieces_meet_where_their_tracks_cross() -> None:
    box = sp.Body.box(0.4, 0.4, 1.0, 20.0)
    one = at_rest(sp.Piece(box), 0.01)
    steps = np.arange(101)
    x = 0.5 * 0.01 * steps  # 0.5 m/s
    moves = track_in_plane(at_rest(sp.Piece(box, (-0.65, 0.0, 0.0)), 0.01), x, 0.0 * x, 0.0 * x)
    assert meet(moves, one)
    before = np.flatnonzero(x < 0.25)  # at 0.5 s it has closed the gap of 0.25 m
    assert not meet(cut(moves, len(before)), one)


def test_an_outline_is_the_hull_of_what_is_below_it() -> None:
    rng = np.random.default_rng(2)
    points = rng.normal(size=(40, 3))
    outline = outline_of(points)
    sides = np.roll(outline, -1, axis=0) - outline
    arms = points[:, np.newaxis, :2] - outline
    assert (sides[:, 0] * arms[..., 1] - sides[:, 1] * arms[..., 0] > -1e-12).all()


@pytest.mark.parametrize(("gap", "free"), [(PASSAGE - 2 * CELL, False), (PASSAGE + CELL, True)])
def test_one_walks_out_through_gaps_that_are_wide_enough(gap: float, free: bool) -> None:
    door = sp.Door("right_wall", 1.0, 0.8, opens="outwards")
    plan = sp.FloorPlan(4.0, 3.0, [door], places=[sp.PersonPlace.of("desk", (0.6, 1.5))])
    wall = rectangle((2.0, 0.5 * (3.0 - gap)), 0.4, 3.0 - gap)
    ways = WalkableGrid(plan)
    covered = ways.covered([wall])
    blocked, shut_in = ways.shut_in(covered, ways.too_near(covered))
    assert shut_in == [not free]
    assert blocked == [False] or not free


def test_one_walks_no_nearer_to_furniture_than_half_a_passage() -> None:
    rng = np.random.default_rng(5)
    ways = WalkableGrid(sp.FloorPlan(4.0, 3.0))
    middles, sides = rng.uniform((0.0, 0.0), (4.0, 3.0), (6, 2)), rng.uniform(0.1, 1.0, (6, 2))
    pieces = [
        ways.covered([rectangle((x, y), width, length)])
        for (x, y), (width, length) in zip(middles.tolist(), sides.tolist(), strict=True)
    ]
    taken = np.argwhere(np.any(pieces, axis=0))
    cells = np.argwhere(np.ones_like(pieces[0]))
    apart = np.linalg.norm(cells[:, np.newaxis] - taken, axis=2).min(axis=1)
    # it is half a cell more to the middle of a covered cell than to its edge
    near = (CELL * (apart - 0.5) < 0.5 * PASSAGE - 0.5 * CELL).reshape(pieces[0].shape)
    np.testing.assert_array_equal(np.any([ways.too_near(each) for each in pieces], axis=0), near)


def test_a_door_that_opens_inwards_needs_its_floor() -> None:
    plan = sp.FloorPlan(4.0, 3.0, [sp.Door("near_side_wall", 1.0, 0.8)])
    ways = WalkableGrid(plan)
    # until its edge is a passage's width from the jamb: by 2 asin(0.5 · 0.5 / 0.8)
    angle = 2.0 * math.asin(0.5 * PASSAGE / 0.8)
    radius, beyond = 0.6, 0.15
    for turn, opens in ((angle - beyond, False), (angle + beyond, True)):
        at = (1.0 + radius * math.cos(turn), radius * math.sin(turn))
        assert ways.opens(plan.doors[0], ways.covered([rectangle(at, 0.1, 0.1)])) == opens
    outwards = sp.Door("near_side_wall", 1.0, 0.8, opens="outwards")
    assert ways.opens(outwards, ways.covered([rectangle((1.4, 0.3), 0.3, 0.3)]))


@pytest.mark.parametrize("wall", ["left_wall", "right_wall", "near_side_wall", "far_side_wall"])
@pytest.mark.parametrize("hinge", ["start", "end"])
def test_every_wall_and_hinge_sweeps_the_same_floor(wall: str, hinge: str) -> None:
    plan = sp.FloorPlan(3.0, 3.0, [sp.Door(wall, 1.0, 0.8, hinge)])
    ways = WalkableGrid(plan)
    at_hinge = plan.on_wall(wall, 1.1 if hinge == "start" else 1.7, 0.05)
    at_edge = plan.on_wall(wall, 1.7 if hinge == "start" else 1.1, 0.7)
    assert not ways.opens(plan.doors[0], ways.covered([rectangle(at_hinge, 0.1, 0.1)]))
    assert ways.opens(plan.doors[0], ways.covered([rectangle(at_edge, 0.1, 0.1)]))

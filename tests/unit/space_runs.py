"""Runs in space made by hand, in closed form, for the tests of what is shown of them."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

import stayput as sp
from stayput.mechanics.space.columns import HIT
from stayput.simulation.run import default_names
from stayput.simulation.space import piece_runs
from stayput.simulation.space_engine import Gaps
from stayput.simulation.space_fate import fates_of
from stayput.simulation.space_records import matrices, planes_of, product

if TYPE_CHECKING:
    from collections.abc import Sequence

DT = 0.01
TIME = DT * np.arange(201)
BOX = sp.Body.box(0.4, 0.6, 1.8, 80.0)
DRUM = sp.Body.cylinder(0.4, 0.8, 30.0)
SHAKE = sp.Motion(
    dt=DT, x=3.0 * np.sin(8.0 * TIME), y=2.0 * np.sin(5.0 * TIME), z=np.cos(9.0 * TIME), name="three"
)
ROOM = sp.Room(left_wall=sp.Wall(0.1), ceiling=sp.Ceiling(2.4))


def _about(axis: tuple[float, float, float], angle: np.ndarray) -> np.ndarray:
    sine = np.sin(angle / 2)[:, np.newaxis] * np.array(axis)
    return np.column_stack((np.cos(angle / 2), sine))


def apart(count: int) -> Gaps:
    """Return gaps of bodies that touch nothing."""
    return Gaps(np.ones((count, 3)), np.ones((count, count)))


def _made(standing: list[sp.Piece], places: list[np.ndarray], attitudes: list[np.ndarray]) -> sp.Run:
    """Return a run from the ways of the origins of the bodies' frames and their attitudes."""
    attitude = np.stack(attitudes)
    offsets = np.array([one.solid.centre_of_gravity for one in standing])
    place = np.stack(places) + np.einsum("bsij,bj->bsi", matrices(attitude), offsets)
    return of_poses(standing, place, attitude)


def of_poses(
    standing: Sequence[sp.Piece], place: np.ndarray, attitude: np.ndarray, time: np.ndarray = TIME
) -> sp.Run:
    """Return a run from the poses of the bodies."""
    still, count = np.zeros(place.shape), len(standing)
    gaps, none = (apart(count), apart(count)), np.zeros((count, 3), np.int64)
    bodies = [SimpleNamespace(piece=piece, held=None) for piece in standing]
    trace = SimpleNamespace(peak_tilt=np.zeros(count), hit_numbers=none, hits=np.zeros(0, HIT))
    turns = matrices(attitude)
    fates = fates_of(standing, place, turns, gaps)
    traced: Any = SimpleNamespace(bodies=bodies, trace=trace, turns=turns, fates_over_time=lambda: fates)
    return sp.Run(
        engine="space",
        names=default_names(count),
        pieces=piece_runs(traced, time),
        standing=tuple(standing),
        room=ROOM,
        motion=SHAKE,
        planes=planes_of(standing, ROOM),
        time=time,
        place=place,
        attitude=attitude,
        velocity=still,
        rotation_rate=still,
        force=np.zeros((count, len(time), 2, 3)),
        gaps=gaps,
        steps=200,
    )


def falling() -> sp.Run:
    """A box with a heading of 0.2 rad that slides 10 cm aside, and falls over its front until 1.5 s."""
    angle = np.pi / 2 * np.clip((TIME - 1.0) / 0.5, 0.0, 1.0) ** 2
    way = np.column_stack((0.2 * (1.0 - np.cos(angle)), 0.1 * np.clip(TIME, 0.0, 1.0), 0.2 * np.sin(angle)))
    fallen = _about((0.0, 1.0, 0.0), angle)
    heading = sp.Piece(BOX, heading=0.2)
    turned = way.copy()
    turned[:, :2] = way[:, :2] @ heading.turn[:2, :2].T
    return _made([heading], [turned], [product(_about((0.0, 0.0, 1.0), np.full(201, 0.2)), fallen)])


def spinning() -> sp.Run:
    """A box that stands still, a drum that turns once and a half about the vertical, and one on the box."""
    angle = np.array([0.0, 3.0 * np.pi, 0.0])[:, np.newaxis] * TIME / TIME[-1]
    starts = [(0.0, 0.0, 0.0), (0.9, 0.1, 0.0), (0.0, 0.1, 1.8)]
    standing = [sp.Piece(solid, at) for solid, at in zip((BOX, DRUM, DRUM), starts, strict=True)]
    places = [np.tile(at, (201, 1)) for at in starts]
    return _made(standing, places, [_about((0.0, 0.0, 1.0), one) for one in angle])

"""Draws of what is uncertain of a scene, and the scene and the shaking that they make."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.measures.wall import REACH
from stayput.model.room import FRICTION_RANGE, WALLS_AROUND, Room, Wall
from stayput.montecarlo.sampling import AS_STATED, INSETS, Draw, drawn_body, drawn_place, drawn_surfaces
from stayput.simulation.placement import ORIGIN, Placement
from stayput.simulation.placing import room_seen
from stayput.simulation.scene import STRENGTH_RANGE, Scene
from stayput.simulation.space_engine import SpaceShaking
from stayput.simulation.space_records import planes_of
from stayput.uncertainty import Marginal, Uncertainty, Uniform

if TYPE_CHECKING:
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.simulation.piece import Piece

OWN = ("mass", "gravity_height", *INSETS)
"""Quantities of `Draw` that each piece has of its own; the others are the room's."""

LIKE = {"between": "friction", "joints": "strength"}
"""Quantities of several pieces that are drawn like one of `Draw`: friction between them, and joints."""


class SceneDraw(NamedTuple):
    """One draw of what is uncertain of a scene.

    Parameters
    ----------
    pieces : tuple of Draw
        Of each; what is the room's is the same in all.
    between : float
        Factor on the friction between pieces.
    joints : float
        Factor on the strengths of the joints.
    lean : float
        By what the floor falls towards where the motion's x points [rad]; no piece leans on its own feet.
    direction : float
        Where the motion's x points in plan, from x towards y [rad].
    """

    pieces: tuple[Draw, ...]
    between: float
    joints: float
    lean: float = 0.0
    direction: float = 0.0

    @property
    def room(self) -> Draw:
        """What is drawn of the room."""
        return self.pieces[0]


class SceneDraws:
    """Draws of what is uncertain of the pieces of a scenario, made when they are asked for.

    Pieces of one body are of one kind, and have the same draws.

    Parameters
    ----------
    scenario : Scenario
        What stands where.
    motions : int
        How many there are.
    """

    def __init__(self, scenario: Scenario, motions: int) -> None:
        stated = scenario.uncertainty
        self._scenario, self._motions = scenario, motions
        self._seed, self._as_stated = stated.seed, stated.as_stated
        self._usual = dict(stated.quantities.marginals)
        self._columns: dict[str, dict[str, NDArray[np.float64]]] = {}

    @cached_property
    def kinds(self) -> tuple[int, ...]:
        """Of each piece the number of its kind."""
        bodies = [piece.body for piece in self._scenario.scene().pieces]
        different = [body for number, body in enumerate(bodies) if body not in bodies[:number]]
        return tuple(different.index(body) for body in bodies)

    def streams(self, group: Sequence[int]) -> tuple[str, ...]:
        """Return the names of the draws of pieces that run together: copies there have draws of their own."""
        each = [self.kinds[number] for number in group]
        copies = [each[:place].count(kind) for place, kind in enumerate(each)]
        return tuple(f"{kind}.{copy}" if copy else str(kind) for kind, copy in zip(each, copies, strict=True))

    def prepare(self, draw: int) -> None:
        """Draw all up to one of a number, before threads ask for it."""
        for stream in {"", *self._columns}:
            self._drawn(stream, draw)

    def draw(self, motion: int, number: int, streams: Sequence[str], axes: Placement = ORIGIN) -> SceneDraw:
        """Return a draw for pieces of some streams, its direction as it is seen along axes in the scene."""
        shared = {name: float(column[motion, number]) for name, column in self._drawn("", number).items()}
        between, joints, lean, towards = (shared.pop(name) for name in (*LIKE, "lean", "direction"))
        of_pieces = list[Draw]()
        for stream in streams:
            columns = self._drawn(stream, number) if stream != "0" else {}
            values = shared | {name: float(column[motion, number]) for name, column in columns.items()}
            of_pieces.append(Draw(**values, lean=0.0))
        points = towards if self._scenario.points is None else self._scenario.points
        direction = points - self._scenario.facing - axes.heading
        return SceneDraw(tuple(of_pieces), between, joints, lean, direction)

    def _drawn(self, stream: str, draw: int) -> dict[str, NDArray[np.float64]]:
        """Return the draws of a stream, at least up to one of a number; that without a name is the room's."""
        known = self._columns.get(stream, {})
        done = known["mass"].shape[1] if known else 0
        if draw >= done:
            usual = self._usual
            like = {name: usual[quantity] for name, quantity in LIKE.items()}
            turned = {"direction": Uniform(0.0, 2.0 * math.pi)}
            shared: dict[str, Marginal] = {**usual, **like, **turned}
            marginals = {name: usual[name] for name in OWN} if stream else shared
            count = max(2 * done, draw + 1)  # doubled, as each call draws those before again
            columns = Uncertainty(marginals).sample(count, self._seed, motions=self._motions, stream=stream)
            for name in columns:
                if LIKE.get(name, name) in self._as_stated:
                    columns[name] = np.full_like(columns[name], getattr(AS_STATED, LIKE.get(name, name)))
            self._columns[stream] = known = columns
        return known


def drawn_scene(scene: Scene, draw: SceneDraw) -> Scene:
    """Return a scene as drawn, its walls too; its products were bought for the pieces as stated."""
    pieces = [_drawn_piece(piece, drawn) for piece, drawn in zip(scene.pieces, draw.pieces, strict=True)]
    static, kinetic = (min(draw.between * mu, FRICTION_RANGE[1]) for mu in scene.friction)
    low, high = STRENGTH_RANGE

    def strength(stated: float) -> float:
        return stated if math.isinf(stated) else min(max(draw.joints * stated, low), high)

    joints = [
        replace(joint, strength=strength(joint.strength), shear=strength(joint.shear))
        for joint in scene.joints
    ]
    return Scene(pieces, _drawn_room(scene, draw.room), joints=joints, friction=(static, kinetic))


def _drawn_piece(piece: Piece, draw: Draw) -> Piece:
    """Return a piece as drawn; feet matter on the floor alone."""
    inset = draw if piece.at[2] == 0.0 else replace(draw, back_inset=0.0, front_inset=0.0)
    measures = [measure.fitted_to(piece.body) for measure in piece.measures]
    return replace(piece, body=drawn_body(piece.body, inset), measures=measures)


def _drawn_room(scene: Scene, draw: Draw) -> Room:
    """Return the room as drawn; where a bracket reaches the wall from a piece as stated, it does as drawn."""
    room = scene.around
    drawn, walls = drawn_surfaces(drawn_place(room, draw), draw), dict[str, Wall | None]()
    for name in WALLS_AROUND:
        wall, original = getattr(drawn, name), getattr(room, name)
        if wall is not None and original.gap <= REACH:
            most = _most_gap(tuple(scene.pieces), room, name)
            walls[name] = replace(wall, gap=min(wall.gap, most))
    return replace(drawn, **walls)  # pyright: ignore[reportArgumentType]


@lru_cache(maxsize=64)
def _most_gap(pieces: tuple[Piece, ...], room: Room, wall: str) -> float:
    """Return the gap of a wall [m] up to which brackets reach it that reach it from the pieces as stated."""
    alone = replace(room, **{other: None for other in WALLS_AROUND if other != wall})
    planes = planes_of(pieces, alone)
    rooms = [room_seen(piece, alone, planes) for piece in pieces if piece.body.shape is None]
    gaps = [around.left_wall.gap for around in rooms if around.left_wall is not None]
    stated_gap = getattr(room, wall).gap
    return min((REACH - (gap - stated_gap) for gap in gaps if gap <= REACH), default=math.inf)


def drawn_shaking(motion: Motion, scale: float, draw: SceneDraw, gravity: float) -> SpaceShaking:
    """Return the motion of a floor times a scale, its x turned in plan as drawn.

    A floor that leans by a small angle is also shaken by −g sin(lean) along x, whatever stands on it: what a
    piece does depends neither on the order of the pieces nor on those that cannot reach it.
    """
    still = np.zeros(len(motion.x))
    x, y, z = (scale * motion.components.get(name, still) for name in "xyz")
    x -= gravity * math.sin(draw.lean)
    if draw.direction:
        cos, sin = math.cos(draw.direction), math.sin(draw.direction)
        x, y = cos * x - sin * y, sin * x + cos * y
    return SpaceShaking(np.stack([x, y, z], axis=1), motion.dt)

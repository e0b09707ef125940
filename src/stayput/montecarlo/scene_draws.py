"""Draws of what is uncertain of a scene, and the scene and the shaking that they make."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.measures.wall import REACH
from stayput.model.room import FRICTION_RANGE, WALLS_AROUND, Room
from stayput.montecarlo.sampling import AS_STATED, INSETS, Draw, drawn_body, drawn_place, drawn_surfaces
from stayput.simulation.placing import planes_around, room_seen
from stayput.simulation.scene import STRENGTH_RANGE, Scene
from stayput.simulation.space_engine import SpaceShaking
from stayput.uncertainty import QUANTITIES, Marginal, Uncertainty, Uniform

if TYPE_CHECKING:
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.simulation.piece import Piece

OWN = ("mass", "gravity_height", *INSETS)
"""Quantities of `Draw` that each piece has of its own; the others are the room's."""

LIKE = {"between": "friction", "joints": "strength"}
"""Quantities of several pieces that are drawn like one of `Draw`: friction between them, and joints."""


class DrawOfSeveral(NamedTuple):
    """One draw of what is uncertain of several pieces in a room.

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

    def of(self, bodies: Sequence[int]) -> DrawOfSeveral:
        """Return the draw of some of the pieces by themselves."""
        return self._replace(pieces=tuple(self.pieces[body] for body in bodies))


def draws_of_several(
    pieces: int,
    motions: int,
    samples: int,
    seed: int,
    start: int = 0,
    *,
    as_stated: Collection[str] = (),
    quantities: Uncertainty = QUANTITIES,
    direction: float | None = 0.0,
    facing: float = 0.0,
) -> list[list[DrawOfSeveral]]:
    """Return the draws of every motion; those of a piece depend on its number, and on no piece after it.

    Those of the first piece are those of `stayput.montecarlo.sampling.draws`, which are of a lone piece.

    Parameters
    ----------
    pieces : int
        How many there are.
    motions, samples, seed, start, as_stated, quantities
        As for `stayput.montecarlo.sampling.draws`.
    direction : float, optional
        Where the motion's x points in plan [rad]; None draws it.
    facing : float
        Where the axes point in plan, along which the pieces are [rad].
    """
    usual = quantities.marginals
    like = {name: usual[quantity] for name, quantity in LIKE.items()}
    turned = Uniform(0.0, 2.0 * math.pi)

    def drawn(distributions: dict[str, Marginal], stream: str = "") -> list[list[dict[str, float]]]:
        columns = Uncertainty(distributions).sample(
            samples, seed, motions=motions, start=start, stream=stream
        )
        for name in columns:
            if LIKE.get(name, name) in as_stated:
                columns[name] = np.full((motions, samples), getattr(AS_STATED, LIKE.get(name, name)))
        rows = zip(*(column.ravel().tolist() for column in columns.values()), strict=True)
        each = [dict(zip(columns, row, strict=True)) for row in rows]
        return [each[motion * samples : (motion + 1) * samples] for motion in range(motions)]

    shared = drawn({**usual, **like, "direction": turned})
    further = [drawn({name: usual[name] for name in OWN}, str(number)) for number in range(1, pieces)]

    def draw(motion: int, sample: int) -> DrawOfSeveral:
        values = dict(shared[motion][sample])
        between, joints, lean, towards = (values.pop(name) for name in (*LIKE, "lean", "direction"))
        each = [{}, *(columns[motion][sample] for columns in further)]
        of_pieces = tuple(Draw(**values | columns, lean=0.0) for columns in each)
        points = towards if direction is None else direction
        return DrawOfSeveral(of_pieces, between, joints, lean, points - facing)

    return [[draw(motion, sample) for sample in range(samples)] for motion in range(motions)]


def draws_of_scenario(
    scenario: Scenario, motions: int, samples: int, start: int = 0
) -> list[list[DrawOfSeveral]]:
    """Return the draws of what a scenario states, along the axes of what stands; see `draws_of_several`."""
    stated = scenario.uncertainty
    return draws_of_several(
        len(scenario.pieces),
        motions,
        samples,
        stated.seed,
        start,
        as_stated=stated.as_stated,
        quantities=stated.quantities,
        direction=scenario.points,
        facing=scenario.facing,
    )


def drawn_scene(scene: Scene, draw: DrawOfSeveral) -> Scene:
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
    drawn = drawn_place(room, draw)
    for name in WALLS_AROUND:
        wall, stated = getattr(drawn, name), getattr(room, name)
        if wall is None or stated.gap > REACH:
            continue
        alone = replace(room, **{other: None for other in WALLS_AROUND if other != name})
        planes = planes_around(scene.pieces, alone)
        seen = [room_seen(piece, alone, planes) for piece in scene.pieces if piece.body.shape is None]
        behind = [around.left_wall.gap for around in seen if around.left_wall is not None]
        most = min((REACH - (gap - stated.gap) for gap in behind if gap <= REACH), default=math.inf)
        drawn = replace(drawn, **{name: replace(wall, gap=min(wall.gap, most))})
    return drawn_surfaces(drawn, draw)


def drawn_shaking(motion: Motion, scale: float, draw: DrawOfSeveral, gravity: float) -> SpaceShaking:
    """Return the motion of a floor times a scale, its x turned in plan as drawn.

    A floor that leans by a small angle is also shaken by −g sin(lean) along x, whatever stands on it: what a
    piece does depends neither on the order of the pieces nor on those that cannot reach it.
    """
    acceleration = scale * SpaceShaking.of(motion).acceleration
    acceleration[:, 0] -= gravity * math.sin(draw.lean)
    if draw.direction:
        cos, sin = math.cos(draw.direction), math.sin(draw.direction)
        x, y = acceleration[:, 0].copy(), acceleration[:, 1].copy()
        acceleration[:, 0], acceleration[:, 1] = cos * x - sin * y, sin * x + cos * y
    return SpaceShaking(acceleration, motion.dt)

"""Monte Carlo runs of several pieces: draws of what is uncertain of each, and what became of them."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.execution import Pool
from stayput.measures.element import utilisation
from stayput.measures.wall import REACH
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.devices.columns import DEVICE, HOLDS
from stayput.model.room import FRICTION_RANGE, WALLS_AROUND, Room
from stayput.montecarlo.runs import Runs
from stayput.montecarlo.sampling import AS_STATED, Draw, drawn_body, drawn_floor, drawn_place, drawn_surfaces
from stayput.simulation.placing import planes_around, room_seen
from stayput.simulation.scene import STRENGTH_RANGE, Scene
from stayput.simulation.space import Trace, results_of, run_of_trace, trace_scene
from stayput.simulation.space_engine import STEP, SpaceShaking
from stayput.uncertainty import QUANTITIES, Uncertainty, Uniform

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Sequence

    from numpy.typing import NDArray

    from stayput.montecarlo.hazard import FloorMotions
    from stayput.motion.record import Motion
    from stayput.simulation.piece import Piece
    from stayput.simulation.run import Run
    from stayput.uncertainty import Marginal

OWN = ("mass", "gravity_height", "back_inset", "front_inset")
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
    names: Sequence[str],
    motions: int,
    samples: int,
    seed: int,
    start: int = 0,
    *,
    as_stated: Collection[str] = (),
    quantities: Uncertainty = QUANTITIES,
    direction: float | None = 0.0,
) -> list[list[DrawOfSeveral]]:
    """Return the draws of every motion; those of a piece depend on its name, and on no other piece.

    Parameters
    ----------
    names : sequence of str
        Names of the pieces.
    motions, samples, seed, start, as_stated, quantities
        As for `stayput.montecarlo.sampling.draws`.
    direction : float, optional
        Where the motion's x points in plan [rad]; None draws it.
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
    of_pieces = [drawn({name: usual[name] for name in OWN}, piece) for piece in names]

    def draw(motion: int, sample: int) -> DrawOfSeveral:
        values = dict(shared[motion][sample])
        between, joints, lean, towards = (values.pop(name) for name in (*LIKE, "lean", "direction"))
        pieces = tuple(Draw(**values | columns[motion][sample], lean=0.0) for columns in of_pieces)
        return DrawOfSeveral(pieces, between, joints, lean, towards if direction is None else direction)

    return [[draw(motion, sample) for sample in range(samples)] for motion in range(motions)]


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


def run_several(
    scenes: Sequence[Scene],
    drawn: Sequence[Sequence[DrawOfSeveral]],
    floors: FloorMotions,
    gravity: float,
    counted: Sequence[int],
    *,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> list[Runs]:
    """Run several options at one level together, so that all threads are busy.

    Parameters
    ----------
    scenes : sequence of Scene
        The pieces with each option, as stated.
    drawn : sequence of sequence of DrawOfSeveral
        The draws, by motion and sample.
    floors : FloorMotions
        The motions.
    gravity : float
        Acceleration of gravity [m/s²].
    counted : sequence of int
        The pieces that count together.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : callable, optional
        Called with the number of runs just done; an exception that it raises stops the work.

    Raises
    ------
    InputError
        Measures that cannot be put in place, as stated or in one of the draws.
    """
    shape = len(scenes), len(drawn), len(drawn[0])
    results = np.zeros((*shape, len(scenes[0].pieces)), RESULT)
    devices: dict[tuple[int, ...], tuple[NDArray[np.void], NDArray[np.float64]]] = {}

    def run(option: int, motion: int, sample: int) -> None:
        draw, place = drawn[motion][sample], (option, motion, sample)
        shaking = drawn_shaking(floors.motions[motion], float(floors.scales[motion]), draw, gravity)
        traced = trace_draw(scenes[option], draw, shaking, gravity)
        trace = traced.trace
        results[place] = results_of(traced, shaking.times)
        devices[place] = trace.devices, utilisation(trace.springs, trace.devices)

    with Pool(threads) as pool:
        for _ in pool.as_completed(partial(run, *place) for place in np.ndindex(*shape)):
            if progress is not None:
                progress(1)
    return [
        _runs(results[option], [devices[option, *place] for place in np.ndindex(*shape[1:])], counted)
        for option in range(len(scenes))
    ]


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


def trace_draw(
    scene: Scene,
    draw: DrawOfSeveral,
    shaking: SpaceShaking,
    gravity: float,
    step: float = STEP,
) -> Trace:
    """Run a scene under one draw and its `drawn_shaking`."""
    return trace_scene(
        drawn_scene(scene, draw),
        shaking,
        gravity,
        step,
        draw.room.strength,
        partial(drawn_floor, draw=draw.room),
    )


def replay(scene: Scene, draw: DrawOfSeveral, motion: Motion, scale: float, gravity: float) -> Run:
    """Run a scene under one draw again, with its histories.

    Parameters
    ----------
    scene, draw, gravity
        As for `run_several`.
    motion, scale
        The floor's motion, and the factor on it.
    """
    traced = trace_draw(scene, draw, drawn_shaking(motion, scale, draw, gravity), gravity)
    shown = motion.scaled(scale).pointing(draw.direction)
    run = run_of_trace(traced, scene.joints, drawn_scene(scene, draw).room, shown)
    return replace(run, names=scene.names, plan=scene.plan)


def _runs(
    results: NDArray[np.void],
    each: Sequence[tuple[NDArray[np.void], NDArray[np.float64]]],
    counted: Sequence[int],
) -> Runs:
    """Return the runs of an option, of which each has its devices with their utilisation."""
    shape = (*results.shape[:2], -1)
    devices = np.array([row for row, _ in each], DEVICE).reshape(shape)
    used = np.array([row for _, row in each], np.float64).reshape(shape)
    counted_results = results[..., list(counted)]
    return Runs(
        overturned=(counted_results["outcome"] == OVERTURNED_OUTCOME).any(axis=-1),
        missing=(results["outcome"] == FAILED_OUTCOME).any(axis=-1),
        hit_wall=np.any(counted_results["wall_impacts"] > 0, axis=-1),
        device_failed=(devices["failure"] != HOLDS).any(axis=-1),
        slide=counted_results["peak_slide"].max(axis=-1),
        tilt=counted_results["peak_tilt"].max(axis=-1),
        devices=devices,
        used=used,
        masses=np.ones(results.shape[:2]),
        results=results,
    )

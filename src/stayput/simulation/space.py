"""Bodies in space under one motion: scenes, and a piece of furniture with measures."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.catalogue.names import PIECES_OF_RUNS
from stayput.errors import InputWarning, warn
from stayput.measures.element import DeviceResult, device_results
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.space.columns import HISTORY, ON_FLOOR, ON_ROOM
from stayput.mechanics.space.touching import ROOM
from stayput.model.flat_fields import from_flat_fields
from stayput.model.parameters import GRAVITY
from stayput.simulation.case import scene_of
from stayput.simulation.groups import Group, Track, groups_at_first, joined_traces, run_in_groups, tracks_of
from stayput.simulation.outcome import OUTCOMES, Hit, Outcome, case_results
from stayput.simulation.placement import ORIGIN, Placement
from stayput.simulation.placing import Placed, joint_results, joint_springs, placed, set_fields
from stayput.simulation.run import PieceRun, Run, default_names
from stayput.simulation.space_engine import STEP, TOUCHES, Gaps, SpaceShaking, SpaceTrace, run_world
from stayput.simulation.space_fate import Fate, fates_of, slides, unrolled, upright_yaws
from stayput.simulation.space_records import (
    APART,
    Path,
    frames_of,
    matrices,
    planes_of,
    product,
    surface_of,
    world_of,
)
from stayput.wording import joined, name_within

if TYPE_CHECKING:
    from stayput.measures.measure import Measure
    from stayput.model.room import Floor, Room
    from stayput.model.state import State
    from stayput.motion.record import Motion
    from stayput.simulation.piece import Piece
    from stayput.simulation.scene import Joint, Scene

IMPACTS = ("floor_impacts", "wall_impacts", "body_impacts")
"""What the hits of a body are counted by."""

ON_FLOOR_WITHIN = 1e-6
"""Height up to which the lowest point of a body is on the floor [m]."""


def warn_of_settlement(scene: Scene) -> None:
    """Warn where bodies of another shape stand on a floor that settles: only boxes have the base for that."""
    shaped = [
        name_within(name, PIECES_OF_RUNS)
        for piece, name in zip(scene.pieces, scene.names, strict=True)
        if piece.body.shape is not None and piece.reach((0.0, 0.0, 1.0))[0] <= ON_FLOOR_WITHIN
    ]
    if scene.room.floor.settlement and shaped:
        depth = 1e3 * scene.room.floor.settlement
        warn(InputWarning("simulation.settles", value=depth, pieces=joined(shaped)))


def simulate_scene(
    scene: Scene, motion: Motion, gravity: float, step: float | None = None, initial: State | None = None
) -> Run:
    """Simulate a scene in space, with the initial state of a lone piece; see `stayput.simulate`.

    The floor's settlement is a law of boxes: for bodies of another shape on the floor it is left out, and
    warned of.
    """
    scene.refuse_wrong_places()
    scene = scene.in_room_of_measures()
    warn_of_settlement(scene)
    traced = trace_scene(scene, SpaceShaking.of(motion), GRAVITY.check(gravity), step or STEP, initial)
    run = run_of_trace(traced, scene.joints, scene.around, motion)
    return replace(run, names=scene.names, plan=scene.plan)


@dataclass(frozen=True, eq=False)
class Trace:
    """Bodies as the engine ran them: bodies, room, what became of them and what holds them, and g [m/s²].

    They are in axes of their own, which stand in the room at a `Placement`.
    """

    bodies: tuple[Placed, ...]
    planes: NDArray[np.void]
    trace: SpaceTrace
    gravity: float
    axes: Placement = ORIGIN

    @cached_property
    def pieces(self) -> list[Piece]:
        """The bodies as they stood at first."""
        return [body.piece for body in self.bodies]

    @cached_property
    def frames(self) -> NDArray[np.float64]:
        """The attitudes of the bodies' frames, shape (bodies, samples, 4)."""
        return frames_of(self.pieces, self.trace.attitude)

    @cached_property
    def turns(self) -> NDArray[np.float64]:
        """The rotations of the bodies' frames, shape (bodies, samples, 3, 3)."""
        return matrices(self.frames)

    @cached_property
    def path(self) -> Path:
        """Their poses where they move."""
        return Path.of(self.trace.place, self.trace.attitude, self.pieces)

    def fates(self) -> list[Fate]:
        """Return what became of the bodies, along their `path`."""
        return fates_of(self.pieces, *self.path[2:], self.trace.gaps, self.trace.given_up)

    def fates_over_time(self) -> list[Fate]:
        """Return the same at all samples."""
        return [fate.at_all(self.path.sample, self.path.repeats) for fate in self.fates()]

    def tracks(self, dt: float) -> list[Track]:
        """Return where in the room the bodies were; see `stayput.simulation.groups`."""
        return [track.placed(self.axes) for track in tracks_of(self.pieces, self.trace, dt, self.path)]

    def in_room(self) -> Trace:
        """Return the same in the axes of the room."""
        axes = self.axes
        if axes == ORIGIN:
            return self
        half = 0.5 * axes.heading
        turn = np.array([math.cos(half), 0.0, 0.0, math.sin(half)])
        bodies = list[Any]()
        for body in self.bodies:
            pose = body.pose.copy()
            set_fields(pose, "xyz", axes.points(_vectors(pose, "xyz")))
            for names in (("vx", "vy", "vz"), ("lx", "ly", "lz")):
                set_fields(pose, names, axes.directions(_vectors(pose, names)))
            set_fields(pose, QUATERNION, product(turn, _vectors(pose, QUATERNION)))
            bodies.append(body._replace(piece=_piece_in_room(body.piece, axes), pose=pose))
        planes, springs, hits = self.planes.copy(), self.trace.springs.copy(), self.trace.hits.copy()
        normals = axes.directions(_vectors(planes, ("nx", "ny", "nz"))) + 0.0  # of −0 comes 0
        set_fields(planes, ("nx", "ny", "nz"), normals)
        planes["offset"] += planes["nx"] * axes.x + planes["ny"] * axes.y
        to_room = springs["other"] == ROOM
        anchors, normals = _vectors(springs, ("ax", "ay", "az")), _vectors(springs, ("nx", "ny", "nz"))
        set_fields(springs, ("ax", "ay", "az"), np.where(to_room[:, None], axes.points(anchors), anchors))
        set_fields(springs, ("nx", "ny", "nz"), np.where(to_room[:, None], axes.directions(normals), normals))
        set_fields(hits, HISTORY[:3], axes.points(_vectors(hits, HISTORY[:3])))
        set_fields(hits, HISTORY[3:7], product(turn, _vectors(hits, HISTORY[3:7])))
        trace = self.trace._replace(
            place=axes.points(self.trace.place),
            attitude=product(turn, self.trace.attitude),
            velocity=axes.directions(self.trace.velocity),
            rotation_rate=axes.directions(self.trace.rotation_rate),
            pressing=axes.directions(self.trace.pressing),
            springs=springs,
            hits=hits,
        )
        return Trace(tuple(bodies), planes, trace, self.gravity)

    def among(self, planes: NDArray[np.void]) -> Trace:
        """Return the same among all planes of a room, of which it may have run with some."""
        if len(planes) == len(self.planes):
            return self
        names = [*map(surface_of, planes)]
        places = np.array([names.index(surface_of(plane)) for plane in self.planes])
        gaps = list[Gaps]()
        for each in self.trace.gaps:
            room = np.full((len(each.room), len(planes)), np.inf)
            room[:, places] = each.room
            gaps.append(each._replace(room=room))
        hits = self.trace.hits.copy()
        hits["plane"] = np.append(places, -1)[hits["plane"]]
        trace = self.trace._replace(gaps=(gaps[0], gaps[1]), hits=hits)
        return Trace(self.bodies, planes, trace, self.gravity)


QUATERNION = ("qw", "qx", "qy", "qz")


def _vectors(rows: NDArray[np.void], names: Sequence[str]) -> NDArray[np.float64]:
    """Return fields of rows as vectors, shape (..., fields)."""
    return np.stack([rows[name] for name in names], axis=-1)


def _piece_in_room(piece: Piece, axes: Placement) -> Piece:
    """Return a piece in the room in which its axes stand."""
    at, velocity, rotation_rate = (np.array(each) for each in (piece.at, piece.velocity, piece.rotation_rate))
    return replace(
        piece,
        at=tuple(axes.points(at).tolist()),
        heading=math.remainder(piece.heading + axes.heading, 2.0 * math.pi),
        velocity=tuple(axes.directions(velocity).tolist()),
        rotation_rate=tuple(axes.directions(rotation_rate).tolist()),
    )


def trace_scene(
    scene: Scene, shaking: SpaceShaking, gravity: float, step: float = STEP, initial: State | None = None
) -> Trace:
    """Run the pieces of a scene with their measures in place, those together that meet.

    Parameters
    ----------
    scene : Scene
        The pieces, and where they stand.
    shaking : SpaceShaking
        Of the floor.
    gravity, step : float
        g [m/s²], and the longest step [s].
    initial : State, optional
        The initial state of furniture; at rest by default.

    Raises
    ------
    InputError
        Measures that cannot be put in place, or bodies that begin inside each other or the room.
    """

    def run(group: Group) -> Trace:
        part = scene.part(group)
        names = names_of(scene, group)
        return trace_together(part, shaking, gravity, step, names=names, initial=initial).in_room()

    traces = run_in_groups(groups_at_first(scene), run, lambda traced: traced.tracks(shaking.dt))
    return joined_groups(scene, traces)


def names_of(scene: Scene, numbers: Sequence[int]) -> list[str | Phrase]:
    """Return how refusals call some pieces of a scene: "the piece" where it is alone and has no name."""
    alone = len(scene.pieces) == 1 and not scene.pieces[0].name
    return [phrase("simulation.the_piece") if alone else scene.called(number) for number in numbers]


def joined_groups(scene: Scene, traces: Mapping[Group, Trace]) -> Trace:
    """Return the runs of the groups of pieces of a scene as one.

    Parameters
    ----------
    scene : Scene
        The pieces, and where they stand.
    traces : mapping
        The run of each group, `Trace.in_room`.
    """
    planes = planes_of(scene.pieces, scene.around)
    traces = {group: traced.among(planes) for group, traced in traces.items()}
    if len(traces) == 1:
        return next(iter(traces.values()))
    numbered = {n: body for group in traces for n, body in zip(group, traces[group].bodies, strict=True)}
    bodies = tuple(numbered[number] for number in sorted(numbered))
    ends = np.cumsum([0, *(len(body.springs) for body in bodies)]).tolist()
    springs_of = [
        [
            *(place for number in group for place in range(ends[number], ends[number + 1])),
            *(ends[-1] + place for place, joint in enumerate(scene.joints) if joint.first in group),
        ]
        for group in traces
    ]
    trace = joined_traces({group: traced.trace for group, traced in traces.items()}, springs_of)
    gravity = next(iter(traces.values())).gravity
    return Trace(bodies, planes, trace, gravity)


def trace_together(
    scene: Scene,
    shaking: SpaceShaking,
    gravity: float,
    step: float = STEP,
    strength: float = 1.0,
    drawn_floor: Callable[[Floor], Floor] = lambda floor: floor,
    names: Sequence[str | Phrase] = (),
    initial: State | None = None,
    stop_after_rest: float = math.inf,
    *,
    make_room: bool = False,
) -> Trace:
    """Run the pieces of a scene as one group, from where the leftmost stands: its bits do not depend on that.

    Parameters
    ----------
    scene, shaking, gravity, step
        As for `trace_scene`, which raises the same.
    strength : float
        Factor on the strengths of all devices but joints.
    drawn_floor : callable
        Draws what measures put between a piece and the floor.
    names : sequence of str
        How refusals call the pieces; by default as `names_of`.
    initial : State, optional
        The initial state of furniture; at rest by default.
    stop_after_rest : float
        How long all pieces lie before the run ends [s].
    make_room : bool
        Whether walls give way to what leans into them as it stands: in draws, which lean other than stated.
    """
    called = names or names_of(scene, range(len(scene.pieces)))
    axes = Placement(*min(piece.at for piece in scene.pieces)[:2])
    scene = scene.along(axes) if axes != ORIGIN else scene
    planes = planes_of(scene.pieces, scene.around)
    bodies = placed(scene, strength, drawn_floor, called, initial, planes)
    pieces, floors = [body.piece for body in bodies], [body.floor for body in bodies]
    if make_room:
        for plane in planes:
            if plane["nz"] != 0.0:  # neither the floor nor the ceiling
                continue
            normal = (float(plane["nx"]), float(plane["ny"]), float(plane["nz"]))
            plane["offset"] = min(plane["offset"], *(piece.reach(normal)[0] - APART for piece in pieces))
    world = world_of([piece.solid for piece in pieces], floors, planes, scene.friction)
    springs = np.concatenate([*(body.springs for body in bodies), joint_springs(pieces, scene.joints)])
    poses, moved = np.array([body.pose for body in bodies]), (shaking.acceleration, shaking.dt)
    trace = run_world(world, poses, springs, *moved, step, gravity, stop_after_rest, called)
    return Trace(bodies, planes, trace, gravity, axes)


def results_of(traced: Trace, dt: float) -> NDArray[np.void]:
    """Return what became of bodies: RESULT, shape (bodies,). Slides are distances in plan, of any direction.

    Parameters
    ----------
    traced : Trace
        What the engine returned.
    dt : float
        Time between samples [s].
    """
    results = np.zeros(len(traced.bodies), RESULT)
    last = traced.trace.place.shape[1] - 1
    for body, (result, fate) in enumerate(zip(results, traced.fates(), strict=True)):
        # the mechanics know of no body that another bears
        fell_off = fate.outcome is Outcome.FELL_OFF
        result["outcome"] = OVERTURNED_OUTCOME if fell_off else OUTCOMES.index(fate.outcome)
        result["end"] = end = dt * float(last if fate.fell is None else traced.path.sample[fate.fell])
        for name, value in _until_it_fell(fate, traced.trace, body, traced.bodies[body].piece, end).items():
            result[name] = value
        result["floor_impacts"], result["wall_impacts"] = traced.trace.hit_numbers[body, [ON_FLOOR, ON_ROOM]]
        result["events"], result["steps"] = traced.trace.hit_numbers[-1, 0], traced.trace.steps
    return results


def _until_it_fell(fate: Fate, trace: SpaceTrace, body: int, piece: Piece, until: float) -> dict[str, float]:
    """Return the largest and the last slide and tilt of a body, until it overturned or fell off [s]."""
    end = None if fate.fell is None else fate.fell + 1
    tilt, way = fate.tilt[:end], fate.way[:end]
    # the engine's tilt is that at any step, but counts what a body on its round side has rolled
    seen = fate.fell is not None or piece.round_side is not None
    return {
        "peak_slide": max(float(way.max()), _slide_at_hits(trace, body, piece, until)),
        "residual_slide": float(way[-1]),
        "peak_tilt": float(tilt.max() if seen else trace.peak_tilt[body]),
        "residual_tilt": float(tilt[-1]),
    }


def _slide_at_hits(trace: SpaceTrace, body: int, piece: Piece, until: float) -> float:
    """Return the largest slide of a body as it hits the room [m]: between samples it turns back there.

    What stands on another slides over that, which moves too: only its samples are looked at.
    """
    hits = trace.hits[(trace.hits["a"] == body) & (trace.hits["b"] == ROOM) & (trace.hits["time"] <= until)]
    if len(hits) == 0 or piece.round_side is not None or trace.gaps[0].room[body, 0] > TOUCHES:
        return 0.0
    pose = np.stack([hits[name] for name in HISTORY[:7]], axis=1)
    turn = matrices(frames_of([piece], pose[np.newaxis, :, 3:])[0])
    return float(np.linalg.norm(slides(piece, pose[:, :3], turn), axis=1).max())


ENDS = 0.5
"""How long a piece lies in a run of which only results are asked for [s]: nothing of them comes after."""


def run_case(
    numbers: Mapping[str, float], measures: Sequence[Measure], shaking: SpaceShaking
) -> NDArray[np.void]:
    """Return what became of a body with measures: CASE_RESULT, shape (1,).

    Parameters
    ----------
    numbers : mapping
        The numbers of its case by path.
    measures : sequence of Measure
        What holds it.
    shaking : SpaceShaking
        Of the floor, before the factor of the case.
    """
    body, room, start = from_flat_fields(numbers)
    shaken = SpaceShaking(numbers["motion.scale"] * shaking.acceleration, shaking.dt)
    scene = scene_of(body, room, measures)
    traced = trace_together(scene, shaken, numbers["gravity"], initial=start, stop_after_rest=ENDS)
    springs, devices = traced.trace.springs[np.newaxis], traced.trace.devices[np.newaxis]
    return case_results(springs, results_of(traced, shaken.dt), devices)


def run_of_trace(traced: Trace, joints: Sequence[Joint], room: Room, motion: Motion) -> Run:
    """Return the run of bodies, with the names of their devices and joints.

    Parameters
    ----------
    traced : Trace
        What the engine returned.
    joints : sequence of Joint
        The joints.
    room, motion
        Where the bodies stood, and how the floor moved.
    """
    trace, planes = traced.trace, traced.planes
    devices, first = list[DeviceResult](), 0
    for number, body in enumerate(traced.bodies):
        rows, first = slice(first, first + len(body.springs)), first + len(body.springs)
        if body.held is not None:
            records = trace.springs[rows], trace.devices[rows], trace.forces[:, rows]
            devices += device_results(body.held, *records, mass=1.0, member=number)
    between = slice(len(trace.springs) - len(joints), None)
    devices += joint_results(joints, trace.springs[between], trace.devices[between], trace.forces[:, between])
    surfaces = [surface_of(plane) for plane in planes]
    hits = tuple(
        Hit(
            float(hit["time"]),
            int(hit["a"]),
            None if hit["b"] < 0 else int(hit["b"]),
            "" if hit["plane"] < 0 else surfaces[int(hit["plane"])],
            float(hit["speed"]),
            float(hit["impulse"]),
        )
        for hit in trace.hits
    )
    time = motion.dt * np.arange(len(motion.x), dtype=np.float64)
    return Run(
        "space",
        default_names(len(traced.pieces)),
        piece_runs(traced, time),
        room,
        motion,
        time,
        trace.place,
        traced.frames,
        trace.velocity,
        trace.rotation_rate,
        tuple(devices),
        gravity=traced.gravity,
        standing=tuple(traced.pieces),
        planes=planes,
        force=trace.pressing,
        hits=hits,
        gaps=trace.gaps,
        springs=trace.springs,
        steps=trace.steps,
        unconverged=trace.unconverged,
        given_up=trace.given_up,
    )


def piece_runs(traced: Trace, time: NDArray[np.float64]) -> tuple[PieceRun, ...]:
    """Return what bodies did; see `results_of`."""
    turns, fates, trace, runs = traced.turns, traced.fates_over_time(), traced.trace, list[PieceRun]()
    for b, (body, fate) in enumerate(zip(traced.bodies, fates, strict=True)):
        piece = body.piece
        overturned, fell_off = (
            math.nan if sample is None else float(time[sample]) for sample in (fate.overturned, fate.fell_off)
        )
        end = float(time[-1 if fate.fell is None else fate.fell])
        runs.append(
            PieceRun(
                fate.outcome,
                overturned,
                fell_off,
                **_until_it_fell(fate, trace, b, piece, end),
                **dict(zip(IMPACTS, trace.hit_numbers[b].tolist(), strict=True)),
                tilt=fate.tilt,
                slide=fate.way,
                slide_in_plan=fate.slide,
                yaw=upright_yaws(piece.rest, unrolled(piece, turns[b])),
                held=body.held,
            )
        )
    return tuple(runs)

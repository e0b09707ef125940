"""Pieces where they stand, with what holds or joins them, as the engine in space reads it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError
from stayput.measures.element import DeviceResult, damper, device_result, utilisation
from stayput.measures.measure import Held, Measure, element_rows, hold
from stayput.measures.wall import WallDevice
from stayput.mechanics.devices.columns import AXIAL, NONE, PLANAR
from stayput.mechanics.space.columns import LAW_OF_ELEMENT, SPRING
from stayput.mechanics.space.touching import ROOM
from stayput.model.body import Body
from stayput.model.flat_fields import case_columns, room_row
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import WALLS_AROUND, Floor, Room, Wall
from stayput.model.solid import Solid
from stayput.model.state import State
from stayput.simulation.piece import Piece, rotation_by
from stayput.simulation.space_records import NORMALS, planes_of, pose_of, surface_of

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.simulation.scene import Joint, Scene


JOINT = "joint"
"""Kind of a joint among the devices."""

JOINT_LABEL = ("Joint", "接合部")


def _springs_of(
    elements: NDArray[np.void],
    resting: _Pose,
    base: NDArray[np.float64],
    facing: NDArray[np.float64],
    body: int,
) -> NDArray[np.void]:
    """Return what holds a body to the room, per unit mass; see `held_body`."""
    elements = elements[elements["kind"] != NONE]
    springs = np.zeros(len(elements), SPRING)
    if not len(elements):
        return springs
    springs["body"], springs["other"], springs["kind"] = body, ROOM, elements["kind"]
    points = np.stack([elements["u"], elements["y"], elements["v"]], 1)
    anchors = np.stack([elements["x"], elements["y"], elements["z"]], 1)
    anchors = np.where(np.isnan(elements["x"])[:, None], resting.place + points @ resting.turn.T, anchors)
    normals = np.stack([-elements["sin"], np.zeros(len(elements)), elements["cos"]], 1)
    axes = resting.solid.principal[1]
    # of −0 comes 0
    _set_vectors(springs, p=points @ axes, a=anchors @ facing.T + base, n=normals @ facing.T + 0.0)
    springs["length"] = elements["length"]
    for name in LAW_OF_ELEMENT:
        springs[name] = elements[name]
    return springs


def _set_vectors(springs: NDArray[np.void] | np.void, **vectors: NDArray[np.float64]) -> None:
    """Set vectors of springs, shape (..., 3), by the letters that their components begin with."""
    for name, values in vectors.items():
        set_fields(springs, [f"{name}{axis}" for axis in "xyz"], values)


def set_fields(rows: NDArray[np.void] | np.void, names: Sequence[str], vectors: NDArray[np.float64]) -> None:
    """Set fields of rows to the components of vectors, shape (..., fields)."""
    for number, name in enumerate(names):
        rows[name] = vectors[..., number]


def joint_springs(pieces: Sequence[Piece], joints: Sequence[Joint]) -> NDArray[np.void]:
    """Return what joins the pieces of a scene, as they stand at first, in newtons."""
    springs = np.zeros(len(joints), SPRING)
    for spring, joint in zip(springs, joints, strict=True):
        first, second = pieces[joint.first], pieces[joint.second]
        at = np.asarray(joint.at)
        to = at if joint.to is None else np.asarray(joint.to)
        spring["body"], spring["other"] = joint.first, joint.second
        spring["kind"] = PLANAR if joint.to is None else AXIAL
        axes = second.turn @ second.solid.principal[1]
        upwards = 1.0 if first.place[2] >= second.place[2] else -1.0
        point = (at - first.place) @ first.turn @ first.solid.principal[1]
        _set_vectors(spring, p=point, a=(to - second.place) @ axes, n=[0.0, 0.0, upwards] @ axes)
        spring["length"] = float(np.linalg.norm(to - at))
        damping = damper(joint.damping, joint.stiffness, min(first.solid.mass, second.solid.mass))
        spring["stiffness"], spring["damping"] = joint.stiffness, damping
        spring["slack_plus"], spring["limit_plus"] = joint.slack, (joint.strength, joint.shear)
        spring["slack_minus"] = 0.0 if joint.to is None else math.inf
        spring["limit_minus"] = math.inf, joint.shear
        spring["friction"], spring["interaction"] = math.nan, int(joint.to is None)
    return springs


def joint_results(
    joints: Sequence[Joint], springs: NDArray[np.void], devices: NDArray[np.void], forces: NDArray[np.float64]
) -> tuple[DeviceResult, ...]:
    """Return what became of the joints of a scene, by the devices and forces of its run."""
    used = utilisation(springs, devices)
    each = zip(joints, _places(joints), devices, strict=True)
    return tuple(
        device_result(
            (JOINT, JOINT_LABEL, place), device, used[n], forces[:, n], between=(joint.first, joint.second)
        )
        for n, (joint, place, device) in enumerate(each)
    )


def _places(joints: Sequence[Joint]) -> list[str]:
    """Return what the joints are called: by the pieces they join, and numbered where these have several."""
    pairs = [f"{joint.first}-{joint.second}" for joint in joints]
    return [
        f"{pair}, {pairs[: number + 1].count(pair)}" if pairs.count(pair) > 1 else pair
        for number, pair in enumerate(pairs)
    ]


ALONG = 1e-6
"""1 less the cosine of the angle up to which a side faces a wall that it is parallel to."""

IN_NEWTONS = ("stiffness", "damping", "limit_plus", "limit_minus")
"""Fields of a device that are per unit mass in an `ELEMENT`."""


class Placed(NamedTuple):
    """A body in a room as the engine in space reads it.

    Parameters
    ----------
    piece : Piece
        The body, with what its measures change of it: one that is held as it rests.
    pose : ndarray of POSE, shape ()
        Where it is and how it moves at first.
    floor : CASE
        The floor under it, with what its measures change of that.
    springs : ndarray of SPRING
        Its devices, in newtons.
    held : Held or None
        Its measures in place; None of a body that is no piece of furniture.
    """

    piece: Piece
    pose: NDArray[np.void]
    floor: np.void
    springs: NDArray[np.void]
    held: Held | None = None


class _Pose(NamedTuple):
    """A piece that faces x, the middle of its base at the origin at rest: attitude, G, and their rates."""

    solid: Solid
    turn: NDArray[np.float64]
    place: NDArray[np.float64]
    velocity: NDArray[np.float64]
    rotation_rate: NDArray[np.float64]

    @classmethod
    def of(cls, case: np.void, tilt: float, tilt_rate: float, slide: float, slide_rate: float) -> _Pose:
        """Return that of a case in a state; see `State`."""
        u, v = case["u"], case["v"]
        fulcrum = 1 if tilt > 0.0 or (tilt == 0.0 and tilt_rate > 0.0) else 0
        half = 0.5 * math.hypot(u[1] - u[0], v[1] - v[0])
        turn = rotation_by(np.array([0.0, _lean(case) + tilt, 0.0]))
        foot = turn @ [u[fulcrum], 0.0, v[fulcrum]]
        place = np.array([(half if fulcrum else -half) + slide, 0.0, 0.0]) - foot
        spin = np.array([0.0, tilt_rate, 0.0])
        return cls(
            Solid.of_case(case), turn, place, np.array([slide_rate, 0.0, 0.0]) - np.cross(spin, foot), spin
        )


def _lean(case: np.void) -> float:
    """Return the tilt at which a piece rests on feet of unequal height [rad]."""
    return math.atan2(case["v"][1] - case["v"][0], case["u"][1] - case["u"][0])


def held_body(
    case: np.void,
    elements: NDArray[np.void],
    at: tuple[float, float, float] = (0.0, 0.0, 0.0),
    heading: float = 0.0,
    number: int = 0,
    held: Held | None = None,
) -> Placed:
    """Return a piece with its measures in place.

    Parameters
    ----------
    case : CASE
        The piece and the floor under it, with what the measures change of both.
    elements : ndarray of ELEMENT, shape (n,)
        What holds it, each device by itself: of `stayput.measures.hold` with three dimensions.
    at : tuple of float
        Where the middle of its outline is [m]. What makes it lean leaves its back edge there.
    heading : float
        By what it is turned about the vertical, from x towards y [rad].
    number : int
        Its number among the bodies.
    held : Held, optional
        The measures.

    Raises
    ------
    InputError
        A piece without a length.
    """
    facing = rotation_by(np.array([0.0, 0.0, heading]))
    resting = _Pose.of(case, 0.0, 0.0, 0.0, 0.0)
    begins = [float(case[name]) for name in ("tilt", "tilt_rate", "slide", "slide_rate")]
    first = _Pose.of(case, *begins) if any(begins) else resting
    solid = resting.solid
    u, v = case["u"], case["v"]
    # the back edge of the outline, in the plane of feet that are inset
    back = resting.turn @ [u[2], 0.0, v[0] + (u[2] - u[0]) * (v[1] - v[0]) / (u[1] - u[0])]
    base = np.asarray(at) + facing @ [0.5 * (u[2] - u[3]) - resting.place[0] - back[0], 0.0, 0.0]
    x, y, z = (base + facing @ (resting.place - resting.turn @ solid.centre_of_gravity)).tolist()
    moves = facing @ first.velocity, facing @ first.rotation_rate
    springs = _springs_of(elements, resting, base, facing, number)
    for name in IN_NEWTONS:
        springs[name] *= case["mass"]
    return Placed(
        Piece(Body.of_shape(solid), (x, y, z), heading, tilt=(0.0, _lean(case), 0.0)),
        pose_of(solid, facing @ first.turn, base + facing @ first.place, *moves),
        case,
        springs,
        held,
    )


def placed(
    scene: Scene,
    strength: float = 1.0,
    drawn_floor: Callable[[Floor], Floor] = lambda floor: floor,
    names: Sequence[str | Phrase] = (),
    initial: State | None = None,
    planes: NDArray[np.void] | None = None,
) -> tuple[Placed, ...]:
    """Return the bodies of a scene with their measures in place.

    Parameters
    ----------
    scene : Scene
        The pieces, and where they stand.
    strength : float
        Factor on the strengths of all devices.
    drawn_floor : callable
        Draws what measures put between a piece and the floor; the room's floor has been drawn.
    names : sequence of str
        How refusals call the pieces; by default as `Scene.called`.
    initial : State, optional
        The initial state of furniture; at rest by default.
    planes : ndarray of PLANE, optional
        The room as `planes_of` gives it, where that is known.

    Raises
    ------
    InputError
        Measures that cannot be put in place.
    """
    room = scene.around
    planes = planes_of(scene.pieces, room) if planes is None else planes
    bodies: list[Placed] = []
    for number, member in enumerate(scene.pieces):
        if member.body.shape is not None and not member.measures:
            bodies.append(Placed(member, _first_pose(member), room_row(room), np.zeros(0, SPRING)))
            continue
        try:
            held = hold_piece(member, room, planes)
        except InputError as error:
            raise error.at(names[number] if names else scene.called(number)) from None
        under = _drawn(held.room.floor, room.floor, drawn_floor)
        held = replace(held, room=replace(held.room, floor=under))
        # what stands higher stands on another piece, which does not give way as a soft floor does
        around = replace(held.room, floor=replace(under, settlement=0.0)) if member.at[2] > 0.0 else held.room
        case = case_columns(held.body, around, initial or State(), STANDARD_GRAVITY)[0]
        body = held_body(case, element_rows(held, strength), member.at, member.heading, number, held)
        if any((*member.tilt, *member.velocity, *member.rotation_rate)):
            tilted = replace(member, body=body.piece.body, measures=())
            body = body._replace(piece=tilted, pose=_first_pose(tilted))
        bodies.append(body)
    return tuple(bodies)


def _first_pose(piece: Piece) -> NDArray[np.void]:
    """Return where a piece is and how it moves at first: a POSE."""
    return pose_of(piece.solid, piece.turn, piece.place, piece.velocity, piece.rotation_rate)


def _drawn(floor: Floor, stated: Floor, drawn_floor: Callable[[Floor], Floor]) -> Floor:
    """Return a floor of which only what a measure changed is drawn."""
    if floor is stated:
        return floor
    drawn, names = drawn_floor(floor), (field.name for field in fields(floor))
    changed = (name for name in names if getattr(floor, name) != getattr(stated, name))
    return replace(floor, **{name: getattr(drawn, name) for name in changed})


def hold_piece(piece: Piece, room: Room, planes: NDArray[np.void]) -> Held:
    """Return a piece of a scene with its measures in place; see `placed`.

    A piece that stands on another is held to walls and ceiling as one of the same back and top that reaches
    down to the floor: so heights on the wall, and what bends there, are those of the room.

    Raises
    ------
    InputError
        Measures that cannot be put in place, that change the room, or that belong on a floor where the piece
        stands on another.
    """
    body, height, seen = piece.body, piece.at[2], room_seen(piece, room, planes)
    for measure in piece.measures:
        if measure.acts_on == "the room":
            raise InputError("measures.room_of_several", "measures", measure=measure.label)
        if measure.acts_on == "the base" and height > 0.0:
            raise InputError("measures.base_on_another", "measures", measure=measure.label, height=height)
    if height == 0.0:
        held = hold(body, seen, piece.measures, dimensions=3)
    else:
        on_body = hold(body, seen, [m for m in piece.measures if m.acts_on == "the body"], dimensions=3)
        tall = Body(body.width, height + body.height, on_body.body.mass, length=body.length)
        ties = [_raised(tie, height, body) for tie in piece.measures if tie.acts_on == "the tie"]
        tied = hold(tall, seen, ties, dimensions=3)
        elements = tuple(
            replace(element, point=(element.point[0], element.point[1] - height)) for element in tied.elements
        )
        held = Held(on_body.body, tied.room, elements, tuple(piece.measures))
    if held.room.ceiling != seen.ceiling:
        pole = next(tie for tie in piece.measures if tie.acts_on == "the tie")
        raise InputError("measures.no_ceiling", "room.ceiling", measure=pole.label)
    return held


def _raised(measure: Measure, height: float, body: Body) -> Measure:
    """Return a measure at the same place on a piece that reaches down to the floor."""
    if not isinstance(measure, WallDevice):
        return measure
    return replace(measure, height=(height + measure.height * body.height) / (height + body.height))


def room_seen(piece: Piece, room: Room, planes: NDArray[np.void]) -> Room:
    """Return the room as a piece in it sees it: the wall behind its back is the left one.

    A wall that none of its sides faces is left out.
    """
    seen: dict[str, Wall | None] = dict.fromkeys(WALLS_AROUND)
    for plane in planes[1:]:
        name = surface_of(plane)
        normal = piece.turn.T @ NORMALS[name]
        for side in WALLS_AROUND:
            if np.dot(normal, NORMALS[side]) > 1.0 - ALONG:
                # to a picometre, so that a gap is to the bit what it is for a piece alone
                gap = round(piece.reach(NORMALS[name])[0] - float(plane["offset"]), 12)
                seen[side] = replace(getattr(room, name), gap=max(0.0, gap))
    return replace(room, **seen)  # pyright: ignore[reportArgumentType]

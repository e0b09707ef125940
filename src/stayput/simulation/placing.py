"""Pieces and solids where they stand, with what holds or joins them, as the engine in space reads it."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.errors import InputError
from stayput.measures.element import DeviceResult, at_rest, damper, device_result, utilisation
from stayput.measures.measure import Held, element_rows, hold
from stayput.measures.wall import WallDevice
from stayput.mechanics.devices.columns import AXIAL, NONE, PLANAR
from stayput.mechanics.space.columns import LAW_OF_ELEMENT, SPRING
from stayput.mechanics.space.touching import ROOM
from stayput.model.body import Body
from stayput.model.room import WALLS_AROUND, Room
from stayput.model.solid import Solid
from stayput.simulation.flat_fields import room_row
from stayput.simulation.space_records import NORMALS, planes_of, surface_of
from stayput.simulation.standing import Piece, Standing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.measures.measure import Measure
    from stayput.model.room import Wall
    from stayput.simulation.standing import Joint


JOINT = "joint"
"""Kind of a joint among the devices."""

JOINT_LABEL = ("Joint", "接合部")


def springs_of(
    elements: NDArray[np.void],
    turn: NDArray[np.float64],
    place: NDArray[np.float64],
    axes: NDArray[np.float64],
    body: int = 0,
) -> NDArray[np.void]:
    """Return what holds a body to the room, per unit mass.

    Parameters
    ----------
    elements : ndarray of ELEMENT, shape (n,)
        The devices, per unit mass.
    turn : ndarray, shape (3, 3)
        The rotation of its frame into the room's as it rests, tilted about y alone.
    place : ndarray, shape (3,)
        Where its centre of gravity is as it rests, from the middle of its base [m].
    axes : ndarray, shape (3, 3)
        Its principal axes in its frame, as columns.
    body : int
        Its number.
    """
    elements = elements[elements["kind"] != NONE]
    springs = np.zeros(len(elements), SPRING)
    springs["body"], springs["other"], springs["kind"] = body, ROOM, elements["kind"]
    points = np.stack([elements["u"], elements["y"], elements["v"]], 1)
    at_point = place + points @ turn.T
    anchors = np.stack([elements["x"], elements["y"], elements["z"]], 1)
    anchors = np.where(np.isnan(elements["x"])[:, None], at_point, anchors)
    normals = np.stack([-elements["sin"], np.zeros(len(elements)), elements["cos"]], 1)
    _set_vectors(springs, p=points @ axes, a=anchors, n=normals)
    springs["length"] = elements["length"]
    for name in LAW_OF_ELEMENT:
        springs[name] = elements[name]
    return springs


def _set_vectors(springs: NDArray[np.void] | np.void, **vectors: NDArray[np.float64]) -> None:
    """Set vectors of springs, shape (..., 3), by the letters that their components begin with."""
    for name, values in vectors.items():
        for number, axis in enumerate("xyz"):
            springs[f"{name}{axis}"] = values[..., number]


def joint_springs(standing: Sequence[Standing], joints: Sequence[Joint]) -> NDArray[np.void]:
    """Return what joins the members of an assembly, as they stand at first, in newtons."""
    springs = np.zeros(len(joints), SPRING)
    for spring, joint in zip(springs, joints, strict=True):
        first, second = standing[joint.first], standing[joint.second]
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
    """Return what became of the joints of an assembly, by the devices and forces of its run."""
    used = utilisation(springs, devices)
    each = zip(joints, _places(joints), devices, strict=True)
    return tuple(
        device_result(
            (JOINT, JOINT_LABEL, place), device, used[n], forces[:, n], between=(joint.first, joint.second)
        )
        for n, (joint, place, device) in enumerate(each)
    )


def _places(joints: Sequence[Joint]) -> list[str]:
    """Return what the joints are called: by the members they join, and numbered where these have several."""
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
    """A body of an assembly as it stands in its room.

    Parameters
    ----------
    standing : Standing
        The body, with what its measures change of it.
    held : Held or None
        Its measures in place; None of a body that is no piece of furniture.
    springs : ndarray of SPRING
        Its devices, in newtons.
    """

    standing: Standing
    held: Held | None
    springs: NDArray[np.void]


def bare(member: Standing | Piece) -> Standing:
    """Return a member without its measures."""
    return member.standing if isinstance(member, Piece) else member


def planes_around(members: Sequence[Standing | Piece], room: Room) -> NDArray[np.void]:
    """Return the room of an assembly as the engine reads it: PLANE; see `planes_of`."""
    return planes_of([bare(member) for member in members], room_row(room))


def placed(members: Sequence[Standing | Piece], room: Room, strength: float = 1.0) -> tuple[Placed, ...]:
    """Return the bodies of an assembly with their measures in place.

    Parameters
    ----------
    members : sequence of Standing or Piece
        The members.
    room : Room
        Where they stand.
    strength : float
        Factor on the strengths of all devices.

    Raises
    ------
    InputError
        Measures that cannot be put in place.
    """
    planes = planes_around(members, room)
    return tuple(
        _placed(number, member, room, planes, strength)
        if isinstance(member, Piece)
        else Placed(member, None, np.zeros(0, SPRING))
        for number, member in enumerate(members)
    )


def _placed(number: int, piece: Piece, room: Room, planes: NDArray[np.void], strength: float) -> Placed:
    try:
        held = hold_piece(piece, room, planes)
    except InputError as error:
        raise error.at(f"members[{number}]") from None
    body, standing = held.body, standing_of(piece, held)
    base, facing = _base_of(piece, held), Standing(standing.solid, heading=piece.heading).turn
    upright = Standing(standing.solid, tilt=standing.tilt)
    x, z = at_rest(body, body.centre_of_gravity)
    place = np.array([x, 0.0, z])
    rows = element_rows(held, strength)
    springs = springs_of(rows, upright.turn, place, upright.solid.principal[1], number)
    anchors, normals = (np.stack([springs[f"{name}{axis}"] for axis in "xyz"], axis=1) for name in "an")
    _set_vectors(springs, a=anchors @ facing.T + base, n=normals @ facing.T + 0.0)  # of −0 comes 0
    for name in IN_NEWTONS:
        springs[name] *= body.mass
    return Placed(standing, held, springs)


def standing_of(piece: Piece, held: Held) -> Standing:
    """Return a piece as it stands, with what its measures and the floor change of it.

    What stands higher stands on another piece, which does not give way as a soft floor does.
    """
    body, settlement = held.body, held.room.floor.settlement if piece.at[2] == 0.0 else 0.0
    same = body == piece.body and settlement == 0.0
    solid = piece.standing.solid if same else Solid.of(body, settlement=settlement)
    upright = Standing(solid, tilt=(0.0, body.resting_tilt, 0.0))
    facing = Standing(solid, heading=piece.heading)
    x, z = at_rest(body, body.centre_of_gravity)
    place = np.array([x, 0.0, z]) - upright.turn @ solid.centre_of_gravity
    origin = _base_of(piece, held) + facing.turn @ place
    return Standing(solid, (origin[0], origin[1], origin[2]), piece.heading, upright.tilt)


def _base_of(piece: Piece, held: Held) -> NDArray[np.float64]:
    """Return where the middle of a piece's base is: what makes it lean leaves its back edge where it is.

    The middle of the outline is at the piece's place; unequal insets put that of the base aside.
    """
    back, front = piece.body.base_insets
    moved = 0.5 * (back - front) + _back_edge(piece.body) - _back_edge(held.body)
    return np.asarray(piece.at) + moved * np.array([math.cos(piece.heading), math.sin(piece.heading), 0.0])


def _back_edge(body: Body) -> float:
    """Return where the back edge of a body's base is at rest [m]."""
    return at_rest(body, (body.base_insets[0] - body.width / 2, body.base_heights[0]))[0]


def hold_piece(piece: Piece, room: Room, planes: NDArray[np.void]) -> Held:
    """Return a piece of an assembly with its measures in place; see `placed`.

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
        own = hold(body, seen, [one for one in piece.measures if one.acts_on == "the body"], dimensions=3)
        tall = Body(body.width, height + body.height, own.body.mass, length=body.length)
        ties = [_raised(one, height, body) for one in piece.measures if one.acts_on == "the tie"]
        tied = hold(tall, seen, ties, dimensions=3)
        elements = tuple(
            replace(element, point=(element.point[0], element.point[1] - height)) for element in tied.elements
        )
        held = Held(own.body, tied.room, elements, tuple(piece.measures))
    if held.room.ceiling != seen.ceiling:
        pole = next(one for one in piece.measures if one.acts_on == "the tie")
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
    standing = piece.standing
    seen: dict[str, Wall | None] = dict.fromkeys(WALLS_AROUND)
    for plane in planes[1:]:
        name = surface_of(plane)
        own = standing.turn.T @ NORMALS[name]
        for side in WALLS_AROUND:
            if np.dot(own, NORMALS[side]) > 1.0 - ALONG:
                gap = standing.along(NORMALS[name])[0] - float(plane["offset"])
                seen[side] = replace(getattr(room, name), gap=max(0.0, gap))
    return replace(room, **seen)  # pyright: ignore[reportArgumentType]

"""`Scene`: a room with pieces, on, beside or joined to one another."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.catalogue.names import PIECES_OF_RUNS
from stayput.errors import (
    InputError,
    instance_of,
    list_of,
    not_allowed,
    numbers,
    refuse_same_names,
    whole_within,
    within,
)
from stayput.measures.measure import hold
from stayput.model.floor_plan import FACING, PLACE_NAMES, FloorPlan, PersonPlace
from stayput.model.room import FRICTION_RANGE, WALLS_AROUND, Room, Wall
from stayput.simulation.piece import BEHIND, Piece, inside_each_other, vector_of
from stayput.simulation.placement import Placement, turned, wall_after
from stayput.simulation.run import default_names
from stayput.simulation.space_engine import DEEPEST
from stayput.wording import name_quoted


@dataclass(frozen=True, slots=True)
class Joint:
    """What joins two pieces of a scene.

    Without ``to`` it is a connector: a point of the one body is held to where it is on the other, in all
    directions. With ``to`` it is a belt or a chain from the one point to the other, which only pulls.

    Parameters
    ----------
    first, second : int
        The numbers of the two pieces, from 0.
    at : tuple of float
        The point of the first, in the room as they stand at first [m].
    to : tuple of float, optional
        The point of the second, in the same way; default the same point.
    stiffness : float
        [N/m].
    strength : float
        Pull that it bears, for a connector along the vertical [N]; inf: any.
    shear : float
        Force that a connector bears across the vertical [N]; inf: any. Pull and shear act together:
        it breaks where (pull/strength)² + (shear/shear strength)² reaches 1.
    slack : float
        How much longer a belt is than the straight way [m].
    damping : float
        Ratio of the critical damping of the lighter body on it.

    Raises
    ------
    InputError
        A number out of range.

    Examples
    --------
    >>> import stayput as sp
    >>> lower = sp.Piece(sp.Body.box(0.4, 0.8, 0.9, mass=40.0))
    >>> upper = sp.Piece(sp.Body.box(0.4, 0.8, 0.9, mass=30.0), at=(0.0, 0.0, 0.9))
    >>> screws = [sp.Joint(0, 1, at=(x, 0.0, 0.9), strength=2e3) for x in (-0.15, 0.15)]  # N
    >>> for joints in ([], screws):  # the upper one falls off, or takes all with it
    ...     both = sp.Scene([lower, upper], joints=joints)
    ...     print(*(piece.outcome for piece in sp.simulate(both, sp.near_fault()).pieces))
    rocked fell off
    overturned overturned
    """

    first: int
    second: int
    at: tuple[float, float, float]
    to: tuple[float, float, float] | None = None
    stiffness: float = 1e6
    strength: float = math.inf
    shear: float = math.inf
    slack: float = 0.0
    damping: float = 0.1

    def __post_init__(self) -> None:
        for name in ("first", "second"):
            whole_within(f"simulation.joint_{name}", getattr(self, name), 0, MOST_BODIES - 1, "", name)
        if self.first == self.second:
            raise InputError("simulation.joins_itself", "second", piece=f"pieces[{self.first}]")
        object.__setattr__(self, "at", vector_of("at", self.at, 100.0, "m"))
        if self.to is not None:
            object.__setattr__(self, "to", vector_of("to", self.to, 100.0, "m"))
        within("simulation.joint_stiffness", self.stiffness, 1.0, 1e9, "N/m", "stiffness")
        for name in ("strength", "shear"):
            value = getattr(self, name)
            if not (isinstance(value, float) and value == math.inf):
                within(f"simulation.joint_{name}", value, *STRENGTH_RANGE, "N", name)
        within("simulation.joint_slack", self.slack, 0.0, 10.0, "m", "slack")
        within("simulation.joint_damping", self.damping, 0.0, 2.0, "", "damping")
        if self.slack > 0.0 and self.to is None:
            raise InputError("simulation.slack_without_to", "slack", value=self.slack)


STRENGTH_RANGE = (1e-3, 1e9)
"""Smallest and largest strength of a joint but inf [N]."""

JOINT_REACH = 0.3
"""How far the point of a joint may be from a piece, as the plates and straps that are sold reach [m]."""

MOST_BODIES = 100
"""Most bodies of a scene."""


def refuse_places(
    stated: Iterable[tuple[str | None, str | None]], names: Sequence[str], *, in_plan: bool
) -> None:
    """Raise `InputError` where a piece stands on none before it, or against a wall of no plan.

    Parameters
    ----------
    stated : iterable of tuple
        Fields ``on`` and ``against`` of each `Piece`.
    names : sequence of str
        What they are called.
    in_plan : bool
        Whether the room has a plan.
    """
    for number, (on, against) in enumerate(stated):
        key = f"pieces[{number}]"
        if on is not None and on not in names[:number]:
            raise not_allowed(f"{key}.on", repr(on), "scenario.given_before", f"{key}.on")
        if against is not None and not in_plan:
            where = phrase("rooms.against_without_plan")
            raise InputError("common.left_out", f"{key}.against", where=where)


@dataclass(frozen=True, slots=True)
class Scene:
    """A room with pieces, on, beside or joined to one another.

    Parameters
    ----------
    pieces : sequence of Piece
        What stands there, not inside each other. What stands on another piece or against a wall is moved to
        its place: it has ``at`` and ``heading`` then.
    room : Room
        Floor, walls and ceiling. The gaps of its walls are from the outermost of all pieces; where there is a
        plan, that says where the walls are.
    plan : FloorPlan, optional
        The room seen from above.
    joints : sequence of Joint
        What joins the pieces.
    friction : tuple of float
        Static and kinetic coefficients of friction between them.

    Attributes
    ----------
    names : tuple of str
        What the pieces are called.
    around : Room
        The room with the walls of its plan.

    Raises
    ------
    InputError
        No pieces or too many, a coefficient out of range, a joint of a piece that there is not, a piece on
        none before it or beside it, or walls beside those of a plan.

    Examples
    --------
    >>> import stayput as sp
    >>> chest, case = sp.Body.box(0.45, 0.9, 1.0, 60.0), sp.Body.box(0.35, 0.9, 0.9, 30.0)
    >>> pieces = [sp.Piece(chest, name="chest"), sp.Piece(case, (-0.05, 0.0, 0.0), name="case", on="chest")]
    >>> run = sp.simulate(sp.Scene(pieces), sp.near_fault().scaled(0.5))
    >>> print(f"{run['case'].peak_slide:.2f}")  # m
    0.08

    In a room with a plan:

    >>> body = sp.Body(width=0.3, height=1.8, mass=80.0, length=0.9)
    >>> bookcase = sp.Piece(body, against="left_wall", along=1.5)
    >>> scene = sp.Scene([bookcase], plan=sp.FloorPlan(width=3.6, length=2.7))
    >>> print(f"{scene.pieces[0].at[0]:.2f}, {scene.around.right_wall.gap:.2f}")  # m
    0.17, 3.28
    """

    pieces: Sequence[Piece]
    room: Room = field(default_factory=Room)
    plan: FloorPlan | None = None
    joints: Sequence[Joint] = ()
    friction: tuple[float, float] = (0.4, 0.3)
    names: tuple[str, ...] = field(init=False, repr=False, compare=False)
    around: Room = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        pieces = list_of("pieces", self.pieces, Piece)
        whole_within("simulation.pieces", len(pieces), 1, MOST_BODIES, "", "pieces")
        instance_of("room", self.room, Room)
        if self.plan is not None:
            instance_of("plan", self.plan, FloorPlan)
        names = [piece.name or usual for piece, usual in zip(pieces, default_names(len(pieces)), strict=True)]
        refuse_same_names("pieces", names)
        refuse_places([(piece.on, piece.against) for piece in pieces], names, in_plan=self.plan is not None)
        put = list[Piece]()
        for number, piece in enumerate(pieces):
            below = None if piece.on is None else put[names.index(piece.on)]
            put.append(_in_its_place(piece, f"pieces[{number}].at", below, self.plan))
        object.__setattr__(self, "pieces", put)
        object.__setattr__(self, "names", tuple(names))
        object.__setattr__(self, "around", _around(put, self.room, self.plan))
        object.__setattr__(self, "friction", friction_between(self.friction))
        object.__setattr__(self, "joints", list_of("joints", self.joints, Joint))
        self._refuse_joints()

    def _refuse_joints(self) -> None:
        for number, joint in enumerate(self.joints):
            last = max(joint.first, joint.second)
            if last >= len(self.pieces):
                key = f"joints[{number}]"
                raise InputError("simulation.joint_piece", key, number=last, last=len(self.pieces) - 1)
            for body, at in ((joint.first, joint.at), (joint.second, joint.to or joint.at)):
                piece = self.pieces[body]
                point = piece.turn.T @ (np.asarray(at) - np.asarray(piece.at))
                low, high = piece.solid.vertices.min(axis=0), piece.solid.vertices.max(axis=0)
                apart = float(np.linalg.norm(point - np.clip(point, low, high)))
                if apart > JOINT_REACH:
                    name, owner = f"joints[{number}]", self.called(body)
                    raise InputError(
                        "simulation.joint_in_the_air", name, piece=owner, apart=apart, most=JOINT_REACH
                    )

    def called(self, number: int) -> str:
        """Return how sentences call a piece."""
        return repr(self.names[number]) if self.pieces[number].name else f"pieces[{number}]"

    def part(self, numbers: Sequence[int]) -> Scene:
        """Return the scene of some of the pieces, with the joints between them; the walls stay in place."""
        pieces, room = [self.pieces[number] for number in numbers], self.room
        if self.plan is None:
            walls = {name: wall for name in WALLS_AROUND if (wall := getattr(room, name)) is not None}
            moved = {name: _outermost(self.pieces, name) - _outermost(pieces, name) for name in walls}
            # to a picometre, so that a gap is to the bit what it is for pieces alone
            gaps = {name: round(wall.gap + moved[name], 12) for name, wall in walls.items() if moved[name]}
            room = replace(room, **{name: replace(walls[name], gap=gap) for name, gap in gaps.items()})
        joints = [
            replace(joint, first=numbers.index(joint.first), second=numbers.index(joint.second))
            for joint in self.joints
            if joint.first in numbers and joint.second in numbers
        ]
        return replace(self, pieces=pieces, room=room, joints=joints)

    def in_room_of_measures(self) -> Scene:
        """Return the scene of a lone piece with what its measures say of the room: wall behind, ceiling."""
        piece = self.pieces[0]
        of_room = [measure for measure in piece.measures if measure.acts_on == "the room"]
        poles = [measure for measure in piece.measures if measure.needs == "ceiling"]
        lone = len(self.pieces) == 1 and self.plan is None and piece.heading == 0.0
        if not lone or piece.body.shape is not None or not (of_room or poles):
            return self
        measures = [measure for measure in piece.measures if measure not in of_room]
        room = hold(piece.body, self.room, [*of_room, *poles]).room
        return replace(self, pieces=[replace(piece, measures=measures)], room=room)

    def along(self, axes: Placement) -> Scene:
        """Return the scene in axes that stand in it: positions from their origin, walls as they are there.

        Positions are rounded to a picometre, and 0 is added, which makes 0 of −0, so that copies of a piece
        are the same to the bit.
        """
        turns = -axes.quarter_turns

        def point(at: tuple[float, float, float]) -> tuple[float, float, float]:
            x, y, z = (
                turned(np.array([at[0] - axes.x, at[1] - axes.y, at[2]]), turns).round(12) + 0.0
            ).tolist()
            return x, y, z

        def vector(of_piece: tuple[float, float, float]) -> tuple[float, float, float]:
            x, y, z = (turned(np.array(of_piece), turns) + 0.0).tolist()
            return x, y, z

        pieces = [
            replace(
                piece,
                at=point(piece.at),
                heading=math.remainder(piece.heading - axes.heading, 2.0 * math.pi) + 0.0,
                velocity=vector(piece.velocity),
                rotation_rate=vector(piece.rotation_rate),
            )
            for piece in self.pieces
        ]
        joints = [
            replace(joint, at=point(joint.at), to=None if joint.to is None else point(joint.to))
            for joint in self.joints
        ]
        walls = {wall_after(name, turns): getattr(self.around, name) for name in WALLS_AROUND}
        return replace(self, pieces=pieces, room=replace(self.around, **walls), plan=None, joints=joints)

    def moved(self, moves: Iterable[tuple[str, tuple[float, float], float]]) -> Scene:
        """Return the scene with pieces and places of people elsewhere: their middles, and what they face."""
        pieces, plan = [*self.pieces], self.plan
        for what, at, heading in moves:
            if what in self.names:
                number = self.names.index(what)
                piece = pieces[number]
                pieces[number] = replace(piece, at=(*at, piece.at[2]), heading=heading)
            elif plan is not None:
                number = [place.name for place in plan.places].index(what)
                plan = plan.with_places({number: replace(plan.places[number], at=at, heading=heading)})
        return replace(self, pieces=pieces, plan=plan)

    def refuse_wrong_places(self) -> None:
        """Raise `InputError` where a piece stands in floor, wall, ceiling, another, or where a person is.

        Without a plan nothing is refused here: what begins inside something is, as it is simulated.
        """
        plan, ceiling = self.plan, self.room.ceiling
        if plan is None:
            return
        sides = np.array([plan.width, plan.length])
        names = [name_quoted(name, PIECES_OF_RUNS) for name in self.names]
        reach: list[NDArray[np.float64]] = []
        for number, piece in enumerate(self.pieces):
            corners = piece.solid.vertices @ piece.turn.T + np.asarray(piece.at)
            low, high = corners.min(axis=0), corners.max(axis=0)
            place, name = f"pieces[{number}]", names[number]
            key = f"{place}.at"
            values: dict[str, Any] = {"name": place}
            if piece.name:
                values["name"] = tuple(f"{place} ({text})" for text in name)
            if (low[:2] < -1e-6).any() or (high[:2] > sides + 1e-6).any():
                values |= {"width": plan.width, "length": plan.length}
                for axis, letter in enumerate("xy"):
                    values |= {f"low_{letter}": float(low[axis]), f"high_{letter}": float(high[axis])}
                raise InputError("rooms.in_a_wall", key, **values)
            if low[2] < -DEEPEST:
                values |= {"piece": name, "depth": -float(low[2]), "surface": phrase("simulation.floor")}
                raise InputError("simulation.begins_inside", key, **values)
            if ceiling is not None and high[2] > ceiling.height + 1e-6:
                values |= {"high": float(high[2]), "height": ceiling.height}
                raise InputError("rooms.in_the_ceiling", key, **values)
            reach.append(np.stack([low, high]))
            others: list[tuple[Piece | PersonPlace, Phrase]] = [
                (other, names[before])
                for before, other in enumerate(self.pieces[:number])
                if (reach[before][0] < high).all() and (low < reach[before][1]).all()  # else they are apart
            ]
            others += [(place, name_quoted(place.name, PLACE_NAMES)) for place in plan.places]
            for other, what in others:
                depth = inside_each_other(piece, other)
                if depth > DEEPEST:
                    raise InputError("rooms.in_another", key, name=name, other=what, depth=depth)


def _in_its_place(piece: Piece, key: str, below: Piece | None, plan: FloorPlan | None) -> Piece:
    """Return a piece where it stands in its scene: on another, or with its back to a wall of the plan."""
    if plan is not None and piece.against is not None and piece.along is not None:
        behind = -Piece(piece.body).reach((1.0, 0.0, 0.0))[0]
        x, y = plan.on_wall(piece.against, piece.along, piece.gap + behind)
        stands: dict[str, Any] = {"at": (x, y, 0.0), "heading": FACING[piece.against]}
        return replace(piece, **stands, against=None, along=None, gap=BEHIND)
    if below is None:
        return piece
    level = replace(below, at=(0.0, 0.0, 0.0))
    (low_x, high_x), (low_y, high_y) = level.reach((1.0, 0.0, 0.0)), level.reach((0.0, 1.0, 0.0))
    x, y, _ = piece.at
    if not (low_x <= x <= high_x and low_y <= y <= high_y):
        ends: dict[str, Any] = {"low_x": low_x, "high_x": high_x, "low_y": low_y, "high_y": high_y}
        raise InputError("scenario.beside_support", key, value=[x, y], other=repr(piece.on), **ends)
    top = float(level.solid.vertices[:, 2].max())
    return replace(piece, at=(x + below.at[0], y + below.at[1], below.at[2] + top), on=None)


def _around(pieces: Sequence[Piece], room: Room, plan: FloorPlan | None) -> Room:
    """Return a room with the walls of its plan, from which the outermost of pieces are so far away."""
    if plan is None:
        return room
    for name in WALLS_AROUND:
        if getattr(room, name) is not None:
            raise InputError("scenario.only_one", f"room.{name}", other="plan")
    x, y = (np.array([piece.reach(axis) for piece in pieces]) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
    low, high = np.array([x[:, 0].min(), y[:, 0].min()]), np.array([x[:, 1].max(), y[:, 1].max()])
    walls = {
        name: Wall(max(0.0, round(distance, 12)), construction=plan.walls)  # as of a part
        for name, distance in plan.distances(low, high).items()
    }
    return replace(room, **walls)


def _outermost(pieces: Sequence[Piece], wall: str) -> float:
    """Return how far the outermost of pieces reaches towards a wall [m]."""
    x, y = math.cos(FACING[wall]), math.sin(FACING[wall])
    return max(piece.reach((-round(x), -round(y), 0.0))[1] for piece in pieces)


def friction_between(friction: object) -> tuple[float, float]:
    """Return the coefficients of friction between bodies, or raise `InputError`."""
    called = phrase("simulation.friction")
    values = numbers(called, friction, "friction", count=2)
    static, kinetic = (within(called, value, *FRICTION_RANGE, "", "friction") for value in values)
    return static, within("simulation.kinetic_friction", kinetic, 0.0, static, field="friction")

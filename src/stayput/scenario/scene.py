"""What stands where, as a file says it: its pieces, the room or the plan around them, and what they make."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, Self

import numpy as np
from pydantic import Discriminator, Field, Tag, model_validator

from stayput.catalogue import phrase
from stayput.errors import InputError, no_length
from stayput.model.floor_plan import FACING, MOST_PLACES, Door, FloorPlan, PersonPlace, Window
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import WALLS_AROUND, Room, Wall
from stayput.scenario.fields import TABLE, between, checked, refuse_same_names
from stayput.scenario.origin import FromFile
from stayput.scenario.pieces import AssemblyOption, JointTable, PieceTable, in_place
from stayput.scenario.plan import (  # noqa: TC001 - pydantic reads the annotations
    DoorTable,
    PlaceTable,
    PlanTable,
    WindowTable,
)
from stayput.scenario.tables import RoomTable, floor_of
from stayput.simulation.convex import inside_each_other
from stayput.simulation.space_engine import DEEPEST
from stayput.simulation.standing import MOST_BODIES, Assembly, Piece, friction_between

if TYPE_CHECKING:
    from collections.abc import Generator, Sequence

    from numpy.typing import NDArray

    from stayput.model.body import Body
    from stayput.simulation.standing import Joint


def _several_or_one(value: object) -> str:
    return "<list>" if isinstance(value, list) else TABLE


if TYPE_CHECKING:
    Furniture = PieceTable | list[PieceTable]
else:
    Furniture = Annotated[
        Annotated[PieceTable, Tag(TABLE)]
        | Annotated[Annotated[list[PieceTable], Field(min_length=1, max_length=MOST_BODIES)], Tag("<list>")],
        Discriminator(_several_or_one),
    ]
"""A piece, or a list of them."""


class SceneTables(FromFile):
    """What stands where: the part of a scenario that shaking, measures and draws do not change."""

    furniture: Furniture = Field(description="What stands: a table, or a list of them.")
    joints: Annotated[list[JointTable], Field(min_length=0, max_length=10 * MOST_BODIES)] = Field(
        default=[], description="What joins the pieces."
    )
    static_friction: Annotated[float, between(0.0, 10.0)] = Field(
        default=0.4, description="Static friction between the pieces."
    )
    kinetic_friction: Annotated[float, between(0.0, 10.0)] = Field(
        default=0.3, description="Kinetic friction between the pieces."
    )
    plan: PlanTable | None = Field(default=None, description="The size of the room.")
    doors: Annotated[list[DoorTable], Field(min_length=0, max_length=MOST_PLACES)] = Field(
        default=[], description="Its doors."
    )
    windows: Annotated[list[WindowTable], Field(min_length=0, max_length=MOST_PLACES)] = Field(
        default=[], description="Its windows."
    )
    places: Annotated[list[PlaceTable], Field(min_length=0, max_length=MOST_PLACES)] = Field(
        default=[], description="Where people are."
    )
    room: RoomTable = Field(
        default_factory=RoomTable,
        description="Floor, walls and ceiling; the gaps of walls are from the outermost of all pieces.",
    )
    gravity: Annotated[float, between(0.1, 100.0, "m/s²")] = Field(
        default=STANDARD_GRAVITY, description="Acceleration of gravity."
    )

    @model_validator(mode="after")
    def _named_apart(self) -> Self:
        names = self.names
        refuse_same_names("furniture", names)
        for number, piece in enumerate(self.pieces):
            if piece.on is not None and piece.on not in names[:number]:
                raise InputError("scenario.stands_on", f"{self.key_of(number)}.on", value=repr(piece.on))
            if piece.is_furniture and piece.body().length is None and not self.alone:
                raise no_length(f"{self.key_of(number)}.length")
        try:
            friction_between((self.static_friction, self.kinetic_friction))
        except InputError as error:
            raise error.about("kinetic_friction") from None
        for number, joint in enumerate(self.joints):
            for key in ("first", "second"):
                if getattr(joint, key) not in names:
                    value = repr(getattr(joint, key))
                    raise InputError("scenario.no_such_piece", f"joints[{number}].{key}", value=value)
        self._joints()
        return self

    @model_validator(mode="after")
    def _in_the_room(self) -> Self:
        of_a_plan, of_walls = {"doors", "windows", "places"}, {*WALLS_AROUND, "back_wall"}
        if self.plan is None:
            stated = [*filter(self.says, sorted(of_a_plan)), *["room.walls"] * self.room.says("walls")]
            if stated:
                raise InputError("scenario.needs_both", stated[0], other="plan")
        elif stated := [*filter(self.room.says, sorted(of_walls))]:
            raise InputError("scenario.only_one", f"room.{stated[0]}", other="plan")
        else:
            try:
                self.floor_plan()
            except InputError as error:
                raise error.at(error.field or "plan", error.field) from None
        for number, piece in enumerate(self.pieces):
            if piece.against is not None and self.plan is None:
                where = phrase("rooms.against_without_plan")
                raise InputError("common.left_out", f"{self.key_of(number)}.against", where=where)
            if piece.against is not None and piece.along is None:
                allowed = phrase("rooms.against_without_along", wall=piece.against)
                raise InputError("scenario.missing", f"{self.key_of(number)}.along", allowed=allowed)
        return self

    def key_of(self, number: int) -> str:
        """Return the key of a piece in the file."""
        return f"furniture[{number}]" if isinstance(self.furniture, list) else "furniture"

    @property
    def pieces(self) -> tuple[PieceTable, ...]:
        """The tables of the pieces."""
        return tuple(self.furniture) if isinstance(self.furniture, list) else (self.furniture,)

    @property
    def piece(self) -> PieceTable:
        """The table of the first piece: of the only one where it stands `alone`."""
        return self.pieces[0]

    @property
    def alone(self) -> bool:
        """Whether it is a single piece of furniture without a plan, not written as a list."""
        return not isinstance(self.furniture, list) and self.plan is None and self.furniture.is_furniture

    @property
    def names(self) -> tuple[str, ...]:
        """What the pieces are called."""
        return tuple(piece.title for piece in self.pieces)

    @property
    def counted(self) -> tuple[int, ...]:
        """The pieces of furniture, by whose falls a verification ranks: all pieces where there is none."""
        furniture = tuple(number for number, piece in enumerate(self.pieces) if piece.is_furniture)
        return furniture or tuple(range(len(self.pieces)))

    @property
    def stated(self) -> AssemblyOption:
        """The pieces as the file states them: with its joints, and with the measures of its pieces."""
        measures = tuple(in_place(piece.measures) for piece in self.pieces)
        return AssemblyOption("as stated", bool(self.joints), measures)

    def floor_plan(self) -> FloorPlan:
        """Make the plan: sides, doors, windows, places.

        Raises
        ------
        InputError
            The file has no plan, or one that is not possible.
        """
        if self.plan is None:
            raise InputError("scenario.missing", "plan", allowed=phrase("rooms.no_plan"))
        doors = [Door(**door.model_dump()) for door in self.doors]
        windows = [Window(**window.model_dump()) for window in self.windows]
        places = [table.place() for table in self.places]
        return FloorPlan(self.plan.width, self.plan.length, doors, windows, places)

    def assembly(self, option: AssemblyOption | None = None) -> Assembly:
        """Make the assembly.

        Parameters
        ----------
        option : AssemblyOption, optional
            What is in place; default what the file states.

        Raises
        ------
        InputError
            A body that is not possible, or a mesh that cannot be read.
        """
        chosen = self.stated if option is None else option
        with self.naming_pieces():
            members = [
                replace(piece, measures=measures)
                for piece, measures in zip(self._placed(), chosen.measures, strict=True)
            ]
            joints = self._joints() if chosen.joined else []
            return Assembly(members, (self.static_friction, self.kinetic_friction), joints)

    def by_names(self, error: InputError) -> InputError:
        """Return a refusal of its assembly with the names of the pieces in place of the members' numbers."""
        for number, name in enumerate(self.names):
            error = error.renamed(f"members[{number}]", repr(name))
        return error

    @contextmanager
    def naming_pieces(self) -> Generator[None]:
        """Refuse what is wrong with its assembly by the names of the pieces, and with the file's name."""
        with self.naming_file():
            try:
                yield
            except InputError as error:
                raise self.by_names(error) from None

    def _stands(self, piece: PieceTable, body: Body) -> tuple[tuple[float, float, float], float]:
        """Return where a piece stands by its own table, and what it faces: away from the wall at its back."""
        if piece.against is None or piece.along is None:
            x, y, *up = piece.at
            return (x, y, up[0] if up else 0.0), piece.heading
        behind = -Piece(body).along((1.0, 0.0, 0.0))[0]
        x, y = self.floor_plan().on_wall(piece.against, piece.along, piece.gap + behind)
        return (x, y, 0.0), FACING[piece.against]

    def _placed(self) -> list[Piece]:
        placed: dict[str, Piece] = {}
        for number, piece in enumerate(self.pieces):
            key = self.key_of(number)
            body = checked(key, partial(piece.body_in, self._folder))
            (x, y, z), heading = self._stands(piece, body)
            if piece.on is not None:
                below = placed[piece.on]
                plan = replace(below, at=(0.0, 0.0, 0.0))
                (low_x, high_x), (low_y, high_y) = plan.along((1.0, 0.0, 0.0)), plan.along((0.0, 1.0, 0.0))
                if not (low_x <= x <= high_x and low_y <= y <= high_y):
                    raise InputError(
                        "scenario.beside_support",
                        f"{key}.at",
                        name=f"{key}.at",
                        value=piece.at,
                        other=repr(piece.on),
                        low_x=low_x,
                        high_x=high_x,
                        low_y=low_y,
                        high_y=high_y,
                    )
                top = float(plan.solid.vertices[:, 2].max())
                x, y, z = x + below.at[0], y + below.at[1], below.at[2] + top
            placed[piece.title] = Piece(body, (x, y, z), heading)
        return list(placed.values())

    def _joints(self) -> list[Joint]:
        try:
            return [
                checked(f"joints[{number}]", partial(table.joint, self.names))
                for number, table in enumerate(self.joints)
            ]
        except InputError as error:
            raise self.by_names(error) from None

    def surroundings(self) -> Room:
        """Make the room around all pieces; the gaps of its walls are from the outermost of them."""
        if self.plan is None:
            return self.room.room()
        return self.around(self.assembly().members)

    def around(self, pieces: Sequence[Piece]) -> Room:
        """Make the room as some of the pieces see it: the gaps of its walls are from the outermost of them.

        Parameters
        ----------
        pieces : sequence of Piece
            The pieces.

        Raises
        ------
        InputError
            A piece that stands in a wall.
        """
        if self.plan is None:
            return self.room.room()
        x, y = (
            np.array([piece.along(axis) for piece in pieces]) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
        )
        low, high = np.array([x[:, 0].min(), y[:, 0].min()]), np.array([x[:, 1].max(), y[:, 1].max()])
        gaps = self.floor_plan().distances(low, high)
        walls = {name: Wall(max(0.0, gap), construction=self.room.walls) for name, gap in gaps.items()}
        ceiling = self.room.ceiling and self.room.ceiling.ceiling()
        return Room(floor_of(self.room.floor), ceiling=ceiling, **walls)


def refuse_what_stands_wrong(scenario: SceneTables, plan: FloorPlan, whole: Assembly) -> None:
    """Raise `InputError` where a piece stands in floor, wall, ceiling, another, or where a person is."""
    names = scenario.names
    sides = np.array([plan.width, plan.length])
    reach: list[NDArray[np.float64]] = []
    for number, piece in enumerate(whole.members):
        corners = piece.solid.vertices @ piece.turn.T + np.asarray(piece.at)
        low, high = corners.min(axis=0), corners.max(axis=0)
        name = f"{scenario.key_of(number)}.at"
        called = repr(names[number])
        if (low[:2] < -1e-6).any() or (high[:2] > sides + 1e-6).any():
            values: dict[str, Any] = {"width": plan.width, "length": plan.length}
            for axis, letter in enumerate("xy"):
                values |= {f"low_{letter}": float(low[axis]), f"high_{letter}": float(high[axis])}
            raise InputError("rooms.in_a_wall", name, name=called, **values)
        if low[2] < -DEEPEST:
            values = {"body": called, "depth": -float(low[2]), "surface": phrase("simulation.floor")}
            raise InputError("simulation.begins_inside", name, **values)
        ceiling = scenario.room.ceiling
        if ceiling is not None and high[2] > ceiling.height + 1e-6:
            values = {"high": float(high[2]), "height": ceiling.height}
            raise InputError("rooms.in_the_ceiling", scenario.key_of(number), name=called, **values)
        reach.append(np.stack([low, high]))
        others: list[tuple[Piece | PersonPlace, str]] = [
            (other, repr(names[before]))
            for before, other in enumerate(whole.members[:number])
            if (reach[before][0] < high).all() and (low < reach[before][1]).all()  # else they are apart
        ]
        others += [(place, repr(place.name)) for place in plan.places]
        for other, what in others:
            depth = inside_each_other(piece, other)
            if depth > DEEPEST:
                raise InputError("rooms.in_another", name, name=called, other=what, depth=depth)

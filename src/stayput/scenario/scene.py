"""What stands where, as a file says it: its pieces, the room or the plan around them, and what they make."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Self

from pydantic import Discriminator, Field, Tag, model_validator

from stayput.errors import InputError, no_length, refuse_same_names, within, word_of
from stayput.measures import hold
from stayput.model.floor_plan import MOST_PLACES, Door, FloorPlan, Window
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import WALLS_AROUND, Room
from stayput.scenario.fields import TABLE, between, checked
from stayput.scenario.option import AS_STATED, Option
from stayput.scenario.origin import FromFile
from stayput.scenario.pieces import JointTable, PieceTable, in_place
from stayput.scenario.plan import (  # noqa: TC001 - pydantic reads the annotations
    DoorTable,
    PlaceTable,
    PlanTable,
    WindowTable,
)
from stayput.scenario.tables import RoomTable
from stayput.simulation.scene import MOST_BODIES, Scene, refuse_places

if TYPE_CHECKING:
    from collections.abc import Generator, Sequence
    from contextlib import AbstractContextManager

    from stayput.simulation.piece import Piece
    from stayput.simulation.scene import Joint


@contextmanager
def _calling(pieces: Sequence[str]) -> Generator[None]:
    """Refuse what is wrong with a scene by what its pieces are called here."""
    try:
        yield
    except InputError as error:
        for number, name in enumerate(pieces):
            error = error.renamed(f"pieces[{number}]", name)
        raise error from None


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


def _alone(piece: Piece, room: Room) -> tuple[list[Piece], Room]:
    """Return a lone piece in its own axes, along which its motions are, and its room with its measures.

    Some say where its walls are, and poles may know of a ceiling; those of the base are of the piece.
    """
    around = [measure for measure in piece.measures if measure.acts_on in ("the room", "the tie")]
    measures = [measure for measure in piece.measures if measure.acts_on != "the room"]
    return [replace(piece, heading=0.0, measures=measures)], hold(piece.body, room, around).room


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
            if piece.is_furniture and piece.body().length is None and not self.alone:
                raise no_length(f"{self.key_of(number)}.length")
        name = "kinetic_friction"
        within(name, self.kinetic_friction, 0.0, self.static_friction, field=name)
        for number, joint in enumerate(self.joints):
            for key in ("first", "second"):
                name = f"joints[{number}].{key}"
                word_of(name, getattr(joint, key), names, name)
        self._joints()
        return self

    @model_validator(mode="after")
    def _in_the_room(self) -> Self:
        of_a_plan = "doors", "places", "windows"
        if self.plan is None:
            stated = [*filter(self.says, of_a_plan), *["room.walls"] * self.room.says("walls")]
            if stated:
                raise InputError("scenario.needs_both", stated[0], other="plan")
        elif stated := [*filter(self.room.says, sorted(WALLS_AROUND))]:
            raise InputError("scenario.only_one", f"room.{stated[0]}", other="plan")
        else:
            try:
                self._plan()
            except InputError as error:
                raise error.at(error.field or "plan", error.field) from None
        with self._keys():
            places = [(piece.on, piece.against) for piece in self.pieces]
            refuse_places(places, self.names, in_plan=self.plan is not None)
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
    def stated(self) -> Option:
        """The pieces as the file states them: with its joints, and with the measures of its pieces."""
        measures = tuple(in_place(piece.measures) for piece in self.pieces)
        return Option(AS_STATED, measures, bool(self.joints))

    def scene(self, option: Option | None = None) -> Scene:
        """Make the room with its pieces.

        Parameters
        ----------
        option : Option, optional
            What is in place; default what the file states.

        Raises
        ------
        InputError
            A body that is not possible, a mesh that cannot be read, or a piece in none of its places.
        """
        chosen = self.stated if option is None else option
        with self.naming_keys():
            pieces = [
                piece.standing(checked(self.key_of(number), partial(piece.body_in, self._folder)), measures)
                for number, (piece, measures) in enumerate(zip(self.pieces, chosen.on, strict=True))
            ]
            joints = self._joints() if chosen.joined else []
            friction = self.static_friction, self.kinetic_friction
            room = self.room.room()
            if self.alone:
                pieces, room = _alone(pieces[0], room)
            scene = Scene(pieces, room, self._plan(), joints, friction)
            return scene.moved(chosen.moved) if chosen.moved else scene

    def _keys(self) -> AbstractContextManager[None]:
        """Refuse what is wrong with a scene by the keys of its pieces in the file."""
        return _calling([self.key_of(number) for number in range(len(self.pieces))])

    @contextmanager
    def naming_keys(self) -> Generator[None]:
        """Refuse what is wrong with its scene with the file's name and its keys."""
        with self.naming_file(), self._keys():
            yield

    def _plan(self) -> FloorPlan | None:
        if self.plan is None:
            return None
        doors = [Door(**door.model_dump()) for door in self.doors]
        windows = [Window(**window.model_dump()) for window in self.windows]
        places, walls = [table.place() for table in self.places], self.room.walls
        return FloorPlan(self.plan.width, self.plan.length, doors, windows, places, walls)

    def surroundings(self) -> Room:
        """Make the room around all pieces; the gaps of its walls are from the outermost of them."""
        return self.room.room() if self.plan is None else self.scene().around

    def _joints(self) -> list[Joint]:
        with _calling([*map(repr, self.names)]):
            return [
                checked(f"joints[{number}]", partial(table.joint, self.names))
                for number, table in enumerate(self.joints)
            ]

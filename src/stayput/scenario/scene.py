"""What stands where, as a file says it and is read: pieces, the room or its plan around them, and a scene."""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self

import tomli_w
from pydantic import Discriminator, Field, PrivateAttr, Tag, ValidationError, model_validator
from pydantic.json_schema import DEFAULT_REF_TEMPLATE

from stayput.catalogue import phrase
from stayput.errors import InputError, no_length, refuse_same_names, within, word_of
from stayput.model.floor_plan import MOST_PLACES, PLACES, Door, FloorPlan, PersonPlace, Window
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import WALLS_AROUND, Room
from stayput.scenario.fields import TABLE, Table, Text, ValueTable, between, checked, fields_of, named, one_of
from stayput.scenario.measures import AS_STATED, Option
from stayput.scenario.pieces import Coordinate, JointTable, PieceTable
from stayput.scenario.tables import RoomTable
from stayput.scenario.toml import refusal_of
from stayput.simulation.scene import MOST_BODIES, Joint, Scene, refuse_places

PointInPlan = Annotated[list[Coordinate], Field(min_length=2, max_length=2)]


@fields_of(FloorPlan, but=("walls",))
class PlanTable(ValueTable):
    """The size of a room, which goes from the left wall to the right one and from the near to the far one."""


@fields_of(Door, defaults={"width": 0.8})
class DoorTable(ValueTable):
    """A door."""

    name: Text = Field(default="door", description="What it is called.")
    way_out: bool = Field(default=True, description="Whether it leads out.")


@fields_of(Window, defaults={"width": 1.6})
class WindowTable(ValueTable):
    """A window: nothing that is higher than its sill is moved in front of it."""


@fields_of(PersonPlace, optional=("width", "length", "low", "high", "day", "night"))
class PlaceTable(ValueTable):
    """Where a person is: a bed, a desk, or a box of one's own."""

    name: Text | None = Field(default=None, description="What it is called; default its kind.")
    kind: Annotated[str, one_of(PLACES), named(PLACES)] = Field(
        default="bed", description="What gives the sizes, heights and shares that are not given."
    )
    at: PointInPlan = Field(description="Its middle, along x and y.")

    def place(self) -> PersonPlace:
        """Make the place."""
        stated = self.model_dump(exclude={"name", "kind", "at", "heading"}, exclude_none=True)
        made = PersonPlace.of(self.kind, (self.at[0], self.at[1]), self.heading, self.name)
        return replace(made, **stated)


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


class SceneTables(Table):
    """What stands where: the part of a scenario that shaking, measures and draws do not change."""

    title: Text | None = Field(default=None, description="What the scenario is about.")
    furniture: Furniture = Field(description="What stands: a table, or a list of them.")
    joints: list[JointTable] = Field(
        default=[], max_length=10 * MOST_BODIES, description="What joins the pieces."
    )
    static_friction: float = between(
        0.0, 10.0, default=0.4, description="Static friction between the pieces."
    )
    kinetic_friction: float = between(
        0.0, 10.0, default=0.3, description="Kinetic friction between the pieces."
    )
    plan: PlanTable | None = Field(default=None, description="The size of the room.")
    doors: list[DoorTable] = Field(default=[], max_length=MOST_PLACES, description="Its doors.")
    windows: list[WindowTable] = Field(default=[], max_length=MOST_PLACES, description="Its windows.")
    places: list[PlaceTable] = Field(default=[], max_length=MOST_PLACES, description="Where people are.")
    room: RoomTable = Field(
        default_factory=RoomTable,
        description="Floor, walls and ceiling; the gaps of walls are from the outermost of all pieces.",
    )
    gravity: float = between(
        0.1, 100.0, "m/s²", default=STANDARD_GRAVITY, description="Acceleration of gravity."
    )

    _folder: Path = PrivateAttr(default=Path())
    _file: str = PrivateAttr(default="")

    @classmethod
    def parse(cls, data: Mapping[str, Any], folder: Path = Path(), file: str = "") -> Self:
        """Make a scenario from the keys and values of its file.

        Parameters
        ----------
        data : mapping
            As a TOML reader returns it.
        folder : Path
            Where the relative path of a record begins.
        file : str
            The file's name, for what is refused later: a record that cannot be read.

        Raises
        ------
        InputError
            The first thing that is wrong: the key's dotted name, its value, and what is allowed.
        """
        try:
            scenario = cls.model_validate(dict(data))
        except ValidationError as error:
            raise refusal_of(error.errors(), _schema(cls)) from None
        scenario._folder, scenario._file = folder, file
        return scenario

    @classmethod
    def schema(cls, by_alias: bool = True, ref_template: str = DEFAULT_REF_TEMPLATE) -> dict[str, Any]:
        """Return the JSON Schema of a scenario file, for editors and other programs."""
        return cls.model_json_schema(by_alias=by_alias, ref_template=ref_template)

    def stated_keys(self) -> dict[str, Any]:
        """Return the keys and values of its file: what was said, and nothing that was left to its default."""
        return self.model_dump(mode="json", exclude_unset=True, exclude_none=True, by_alias=True)

    def to_toml(self) -> str:
        """Return the scenario as a file's text: what was said, and nothing that was left to its default.

        `Scenario.parse` reads it back as the same scenario.

        Examples
        --------
        >>> from stayput import Scenario
        >>> print(Scenario.parse({"furniture": {"preset": "chest"}}).to_toml(), end="")
        [furniture]
        preset = "chest"
        """
        return tomli_w.dumps(self.stated_keys())

    @property
    def folder(self) -> Path:
        """Where the relative path of a record or a mesh begins."""
        return self._folder

    @contextmanager
    def naming_file(self, table: str = "") -> Generator[None]:
        """Refuse what is wrong with the file's name, once, and with that of a table of the file."""
        try:
            yield
        except InputError as error:
            if not self._file or error.context[:1] == ((self._file, self._file),):
                raise
            in_table = error.at(phrase("scenario.in_table", table=table)) if table else error
            raise in_table.at(self._file) from None

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
            pieces = {name: self.key_of(number) for number, name in enumerate(self.names)}
            try:
                self._plan()
                refuse_same_names("places", [table.place().name for table in self.places], pieces)
            except InputError as error:
                field = error.field or "plan"
                raise error if str(error).startswith(field) else error.at(field, error.field) from None
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
        measures = tuple(piece.own_measures for piece in self.pieces)
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
            if self.alone:  # in its own axes, along which its motions are
                pieces = [replace(pieces[0], heading=0.0)]
            scene = Scene(pieces, self.room.room(), self._plan(), joints, friction).in_room_of_measures()
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


@cache
def _schema(kind: type[SceneTables]) -> dict[str, Any]:
    """Return the JSON Schema that sentences about errors are made from; it takes its time."""
    return kind.schema()

"""The tables of a scenario: furniture, room, initial state; their keys, ranges, and what they make."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Self

from pydantic import Discriminator, Field, Tag, model_validator

from stayput.errors import InputError
from stayput.model.body import Body
from stayput.model.furniture import FURNITURE
from stayput.model.room import SURFACES, Ceiling, Floor, Room, Wall
from stayput.model.state import State
from stayput.scenario.fields import (
    NAME,
    TABLE,
    Distance,
    Friction,
    Load,
    Mass,
    Pair,
    Restitution,
    Size,
    Table,
    Text,
    between,
    checked,
    kind_of,
    named,
    one_of,
)

Surface = Annotated[str, one_of(SURFACES), named(SURFACES)]
Kind = Annotated[str, one_of(FURNITURE), named(FURNITURE)]


class FurnitureTable(Table):
    """What stands: a preset, any field of which may be overridden, or a body of one's own."""

    name: Text | None = Field(default=None, description="What the piece is called.")
    preset: Kind | None = Field(
        default=None, description="A common piece of furniture; a default, not a citation."
    )
    width: Size | None = Field(default=None, description="Depth of the piece, which lies along the shaking.")
    height: Size | None = Field(default=None, description="Height.")
    mass: Mass | None = Field(default=None, description="Mass; with shelves, that of the empty carcass.")
    cg_offset: Pair | None = Field(
        default=None, description="Offset of the centre of gravity from the centroid, to the right and up."
    )
    inertia: Annotated[float, between(1e-12, 1e12, "kg m²")] | None = Field(
        default=None,
        description="Moment of inertia about the centre of gravity; default the uniform rectangle's.",
    )
    base_heights: Pair | None = Field(
        default=None, description="Height of the left and the right base corner."
    )
    shelves: Annotated[list[Load], Field(min_length=1, max_length=100)] | None = Field(
        default=None, description="Load on each shelf from the lowest up; mass, centre and inertia follow."
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.preset is None:
            for key in ("width", "height", "mass"):
                if getattr(self, key) is None:
                    name = f"furniture.{key}"
                    raise InputError("scenario.no_preset", name, name=name)
        if self.shelves is not None:
            for key in ("cg_offset", "inertia"):
                if getattr(self, key) is not None:
                    name = f"furniture.{key}"
                    raise InputError("scenario.follows_from_shelves", name, name=name)
            if self._mass is None:
                raise InputError("scenario.no_carcass", "furniture.mass")
        checked("furniture", self.body)
        return self

    @property
    def title(self) -> str:
        """What the piece is called."""
        return self.name or self.preset or "body"

    @property
    def _mass(self) -> float | None:
        if self.mass is not None or self.preset is None:
            return self.mass
        preset = FURNITURE[self.preset]
        return preset.mass if self.shelves is None else preset.carcass_mass

    def body(self) -> Body:
        """Make the body."""
        preset = None if self.preset is None else FURNITURE[self.preset]
        width = self.width if self.width is not None or preset is None else preset.width
        height = self.height if self.height is not None or preset is None else preset.height
        assert width is not None
        assert height is not None
        assert self._mass is not None
        base = _pair(self.base_heights)
        if self.shelves is not None:
            return replace(Body.bookcase(width, height, self._mass, self.shelves), base_heights=base)
        return Body(width, height, self._mass, _pair(self.cg_offset), self.inertia, base)


class FloorTable(Table):
    """The floor: a surface preset, coefficients of one's own, or both, the latter overriding."""

    surface: Surface | None = Field(default=None, description="A surface preset; a default, not a citation.")
    static_friction: Friction | None = Field(default=None, description="Static friction of the flat base.")
    kinetic_friction: Friction | None = Field(default=None, description="Kinetic friction of the flat base.")
    edge_static_friction: Friction | None = Field(
        default=None, description="Static friction of a single corner."
    )
    edge_kinetic_friction: Friction | None = Field(
        default=None, description="Kinetic friction of a single corner."
    )
    left_edge_static_friction: Friction | None = Field(
        default=None, description="Static friction of the left base corner alone, as of a strip of rubber."
    )
    left_edge_kinetic_friction: Friction | None = Field(
        default=None, description="Kinetic friction of the left base corner alone."
    )
    right_edge_static_friction: Friction | None = Field(
        default=None, description="Static friction of the right base corner alone."
    )
    right_edge_kinetic_friction: Friction | None = Field(
        default=None, description="Kinetic friction of the right base corner alone."
    )
    restitution: Restitution = Field(
        default=1.0, description="Factor on the rotation rate at a change of fulcrum; 1: Housner."
    )
    normal_restitution: Restitution = Field(
        default=0.0, description="Newton's restitution of a landing corner."
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("room.floor", self.floor)
        return self

    def floor(self) -> Floor:
        """Make the floor."""
        given = self.model_dump(exclude={"surface"}, exclude_none=True)
        return replace(Floor() if self.surface is None else Floor.of(self.surface), **given)


class WallTable(Table):
    """A wall beside the body."""

    gap: Distance = Field(description="Clear distance from the body's side to the wall.")
    restitution: Restitution = Field(default=0.3, description="Wall collision factor.")
    friction: Friction = Field(default=0.3, description="Friction of a corner on the wall.")


class CeilingTable(Table):
    """A ceiling above the body."""

    height: Annotated[float, between(1e-3, 1e4, "m")] = Field(description="Height above the floor.")
    restitution: Restitution = Field(default=0.3, description="Collision factor.")
    friction: Friction = Field(default=0.3, description="Friction of a corner on the ceiling.")


FloorChoice = Annotated[
    Annotated[Surface, Tag(NAME)] | Annotated[FloorTable, Tag(TABLE)], Discriminator(kind_of)
]


class RoomTable(Table):
    """Floor, walls and ceiling."""

    floor: FloorChoice = Field(
        default="wood flooring", description="A surface preset or a table of coefficients."
    )
    left_wall: WallTable | None = Field(default=None, description="The wall at the back.")
    back_wall: WallTable | None = Field(default=None, description="Another name for left_wall.")
    right_wall: WallTable | None = Field(default=None, description="The wall at the front.")
    ceiling: CeilingTable | None = Field(default=None, description="The ceiling.")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.left_wall is not None and self.back_wall is not None:
            raise InputError("scenario.two_back_walls", "room.back_wall")
        return self

    def room(self) -> Room:
        """Make the room."""
        floor = Floor.of(self.floor) if isinstance(self.floor, str) else self.floor.floor()
        left = self.left_wall or self.back_wall
        return Room(
            floor,
            None if left is None else Wall(**left.model_dump()),
            None if self.right_wall is None else Wall(**self.right_wall.model_dump()),
            None if self.ceiling is None else Ceiling(**self.ceiling.model_dump()),
        )


class InitialTable(Table):
    """How the body stands and moves at the beginning."""

    tilt: Annotated[float, between(-1.57, 1.57, "rad")] = Field(default=0.0, description="Tilt, + right.")
    tilt_rate: Annotated[float, between(-1e3, 1e3, "rad/s")] = Field(default=0.0, description="Tilt rate.")
    slide: Annotated[float, between(-1e3, 1e3, "m")] = Field(default=0.0, description="Slide, + right.")
    slide_rate: Annotated[float, between(-1e3, 1e3, "m/s")] = Field(default=0.0, description="Slide rate.")

    def state(self) -> State:
        """Make the initial state."""
        return State(**self.model_dump())


def _pair(values: list[float] | None) -> tuple[float, float]:
    return (0.0, 0.0) if values is None else (values[0], values[1])

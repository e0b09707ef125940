"""The tables of a scenario: furniture, room, initial state; their keys, ranges, and what they make."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Annotated, Self

from pydantic import Discriminator, Field, Tag, model_validator

from stayput.errors import InputError
from stayput.everyday import CARPET, PRESET_DRAWERS, Everyday
from stayput.model.body import FURNITURE, Body, Part
from stayput.model.room import CEILINGS, SURFACES, WALLS, WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.model.state import State
from stayput.scenario.fields import (
    NAME,
    TABLE,
    Pair,
    Table,
    Text,
    between,
    checked,
    each,
    kind_of,
    named,
    of,
    one_of,
)

Surface = Annotated[str, one_of(SURFACES, "floor"), named(SURFACES)]
WallConstruction = Annotated[str, one_of(WALLS), named(WALLS)]
CeilingConstruction = Annotated[str, one_of(CEILINGS), named(CEILINGS)]
Loads = Annotated[list[Annotated[float, each(Part, "mass")]], Field(min_length=1, max_length=100)]
Kind = Annotated[str, one_of(FURNITURE, "preset"), named(FURNITURE)]


class FurnitureTable(Table):
    """What stands: a preset, any field of which may be overridden, or a body of one's own."""

    name: Text | None = Field(default=None, description="What the piece is called.")
    preset: Kind | None = Field(
        default=None, description="A common piece of furniture; a default, not a citation."
    )
    width: float | None = of(Body, "width", default=None)
    height: float | None = of(Body, "height", default=None)
    length: float | None = of(Body, "length")
    heading: Annotated[float, between(-2.0 * math.pi, 2.0 * math.pi, "rad")] = Field(
        default=0.0,
        description="Direction in which it faces: from the motion's x towards its y.",
    )
    mass: float | None = of(
        Body, "mass", default=None, description="Mass; with shelves, that of the empty carcass."
    )
    cg_offset: Pair | None = of(Body, "cg_offset", listed=True, default=None)
    inertia: float | None = of(Body, "inertia")
    base_heights: Pair | None = of(Body, "base_heights", listed=True, default=None)
    base_insets: Pair | None = of(Body, "base_insets", listed=True, default=None)
    shelves: Loads | None = Field(
        default=None, description="Load on each shelf from the lowest up; mass, centre and inertia follow."
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.preset is None:
            for key in ("width", "height", "mass"):
                if getattr(self, key) is None:
                    name = f"furniture.{key}"
                    raise InputError("scenario.no_preset", name, name=name, preset="preset")
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
        length = self.length if self.length is not None or preset is None else preset.length
        assert width is not None
        assert height is not None
        assert self._mass is not None
        base, insets = _pair(self.base_heights), _pair(self.base_insets)
        if self.shelves is not None:
            loaded = Body.bookcase(width, height, self._mass, self.shelves)
            return replace(loaded, base_heights=base, base_insets=insets, length=length)
        return Body(width, height, self._mass, _pair(self.cg_offset), self.inertia, base, insets, length)


class FloorTable(Table):
    """The floor: a surface preset, coefficients of one's own, or both, the latter overriding."""

    surface: Surface | None = Field(default=None, description="A surface preset; a default, not a citation.")
    static_friction: float | None = of(Floor, "static_friction", default=None)
    kinetic_friction: float | None = of(Floor, "kinetic_friction", default=None)
    edge_static_friction: float | None = of(Floor, "edge_static_friction")
    edge_kinetic_friction: float | None = of(Floor, "edge_kinetic_friction")
    left_edge_static_friction: float | None = of(Floor, "left_edge_static_friction")
    left_edge_kinetic_friction: float | None = of(Floor, "left_edge_kinetic_friction")
    right_edge_static_friction: float | None = of(Floor, "right_edge_static_friction")
    right_edge_kinetic_friction: float | None = of(Floor, "right_edge_kinetic_friction")
    restitution: float = of(Floor, "restitution")
    normal_restitution: float = of(Floor, "normal_restitution")
    landing_place: float = of(Floor, "landing_place")
    settlement: float | None = of(Floor, "settlement", default=None)

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("room.floor", self.floor)
        return self

    def floor(self) -> Floor:
        """Make the floor."""
        given = self.model_dump(exclude={"surface"}, exclude_none=True)
        return replace(Floor() if self.surface is None else Floor.of(self.surface), **given)


def floor_of(given: str | FloorTable) -> Floor:
    """Make the floor of a surface preset or of a table."""
    return Floor.of(given) if isinstance(given, str) else given.floor()


class WallTable(Table):
    """A wall beside the body."""

    gap: float = of(Wall, "gap")
    restitution: float = of(Wall, "restitution")
    friction: float = of(Wall, "friction")
    construction: WallConstruction = of(Wall, "construction", listed=True)


class CeilingTable(Table):
    """A ceiling above the body."""

    height: float = of(Ceiling, "height")
    restitution: float = of(Ceiling, "restitution")
    friction: float = of(Ceiling, "friction")
    construction: CeilingConstruction = of(Ceiling, "construction", listed=True)


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
    near_side_wall: WallTable | None = Field(
        default=None, description="The wall at the near side, at −y; in space alone."
    )
    far_side_wall: WallTable | None = Field(
        default=None, description="The wall at the far side, at +y; in space alone."
    )
    ceiling: CeilingTable | None = Field(default=None, description="The ceiling.")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.left_wall is not None and self.back_wall is not None:
            raise InputError("scenario.two_back_walls", "room.back_wall")
        return self

    def room(self) -> Room:
        """Make the room."""
        floor = floor_of(self.floor)
        walls = {name: getattr(self, name) for name in WALLS_AROUND}
        walls["left_wall"] = self.left_wall or self.back_wall
        made = {name: Wall(**wall.model_dump()) for name, wall in walls.items() if wall is not None}
        return Room(
            floor, ceiling=None if self.ceiling is None else Ceiling(**self.ceiling.model_dump()), **made
        )


class EverydayTable(Table):
    """What people do to the piece without an earthquake."""

    drawers: int | None = of(
        Everyday,
        "drawers",
        default=None,
        description="Drawers that can be open at once; default the preset's.",
    )
    drawer_share: float = of(Everyday, "drawer_share")
    drawer_extension: float = of(Everyday, "drawer_extension")
    load: float = of(Everyday, "load")
    pull: float = of(Everyday, "pull")
    pull_height: float = of(Everyday, "pull_height")
    carpet: float | None = of(
        Everyday,
        "carpet",
        default=None,
        description="By how much the back stands higher than the front; default 11 mm on carpet, else 0.",
    )

    def everyday(self, preset: str | None, surface: str = "") -> Everyday:
        """Make the value for a piece of a preset, or of none, on a floor of a surface."""
        drawers = PRESET_DRAWERS.get(preset or "", 0) if self.drawers is None else self.drawers
        lifted = CARPET if surface == "carpet" else 0.0
        carpet = lifted if self.carpet is None else self.carpet
        given = self.model_dump(exclude={"drawers", "carpet"})
        return Everyday(drawers=drawers, carpet=carpet, **given)


class InitialTable(Table):
    """How the body stands and moves at the beginning."""

    tilt: float = of(State, "tilt")
    tilt_rate: float = of(State, "tilt_rate")
    slide: float = of(State, "slide")
    slide_rate: float = of(State, "slide_rate")

    def state(self) -> State:
        """Make the initial state."""
        return State(**self.model_dump())


def _pair(values: list[float] | None) -> tuple[float, float]:
    return (0.0, 0.0) if values is None else (values[0], values[1])

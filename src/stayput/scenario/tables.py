"""The tables of a scenario: furniture, contents, room, initial state, building; what they accept and make."""

from __future__ import annotations

import math
from dataclasses import asdict, replace
from typing import Annotated, Any, Self

from pydantic import Discriminator, Field, ModelWrapValidatorHandler, PrivateAttr, Tag, model_validator

from stayput.building.building import STRUCTURES, Building
from stayput.building.model import MOST_STOREYS, ShearModel
from stayput.catalogue import phrase
from stayput.contents.contents import CONTENTS, Contents
from stayput.errors import InputError
from stayput.estimates import CARPET, PRESET_DRAWERS, Everyday
from stayput.model.body import FURNITURE, Part
from stayput.model.parameters import parameter_of
from stayput.model.room import SURFACES, WALLS, WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.model.state import State
from stayput.scenario import fields as field

Surface = Annotated[str, field.one_of(SURFACES, "floor"), field.named(SURFACES)]
WallConstruction = Annotated[str, field.one_of(WALLS), field.named(WALLS)]
Loads = Annotated[list[Annotated[float, field.each(Part, "mass")]], Field(min_length=1, max_length=100)]
Kind = Annotated[str, field.one_of(FURNITURE, "preset"), field.named(FURNITURE)]
Heading = Annotated[float, field.between(-2.0 * math.pi, 2.0 * math.pi, "rad")]


class PythonTable(field.Table):
    """A table in whose place Python objects may stand that a file cannot state."""

    _in_python: Any = PrivateAttr(default=None)

    @property
    def in_python(self) -> Any:
        """What was given as Python objects and a file cannot state; None where nothing was."""
        return self._in_python

    def with_python(self, objects: Any) -> Self:
        """Return the same with Python objects in its place, or in that of some of its fields."""
        copy = self.model_copy()
        copy._in_python = objects
        return copy


def usual_of(preset: str | None, *, loaded: bool = True) -> dict[str, Any]:
    """Return sizes, mass and base of a preset, loaded or as an empty carcass; nothing of none."""
    usual: dict[str, Any] = {} if preset is None else asdict(FURNITURE[preset])
    carcass = usual.pop("carcass_mass", None)
    usual.pop("base_confidence", None)
    return usual if loaded else usual | {"mass": carcass}


@field.fields_of(
    Contents,
    mass_share="Without loads: mass of the contents, of the furniture's.",
    width="Depth of an item.",
    height="Height of an item.",
    static_friction="Static friction on the shelf; of drawers on their runners.",
    kinetic_friction="The same while it slides.",
    setback="Distance from the front edge of the shelf to the items.",
    catch="Force at which a catch lets go; default: by kind.",
)
class ContentsTable(field.ValueTable):
    """What is in the furniture, and what keeps it there: a kind, any number of which may be overridden."""

    kind: Annotated[str, field.one_of(CONTENTS, "contents"), field.named(CONTENTS)] = Field(
        default="books", description="Kind of contents; a default, not a citation."
    )
    loads: Loads | None = Field(
        default=None, description="Mass on each shelf from the lowest up; default the furniture's shelves."
    )
    back: bool = Field(default=True, description="Whether a board or a wall is behind the items.")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        field.checked("contents", self.contents)
        return self

    def contents(self, shelves: list[float] | None = None) -> Contents:
        """Make the contents; loads that are not given are those of the furniture's shelves [kg]."""
        loads = self.loads
        if loads is None and not {"shelves", "mass_share"} & self.model_fields_set:
            loads = shelves
        stated = self.model_dump(exclude={"loads"})
        return Contents(**stated, loads=None if loads is None else tuple(loads))


@field.fields_of(Floor, optional=("static_friction", "kinetic_friction", "settlement"))
class FloorTable(field.ValueTable):
    """The floor: a surface preset, coefficients of one's own, or both, the latter overriding."""

    surface: Surface | None = Field(default=None, description="A surface preset; a default, not a citation.")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        field.checked("room.floor", self.floor)
        return self

    def floor(self) -> Floor:
        """Make the floor."""
        stated = self.model_dump(exclude={"surface"}, exclude_none=True)
        return replace(Floor() if self.surface is None else Floor.of(self.surface), **stated)


def floor_of(floor: str | FloorTable) -> Floor:
    """Make the floor of a surface preset or of a table."""
    return Floor.of(floor) if isinstance(floor, str) else floor.floor()


@field.fields_of(Wall)
class WallTable(field.ValueTable):
    """A wall beside the body."""


@field.fields_of(Ceiling)
class CeilingTable(field.ValueTable):
    """A ceiling above the body."""


FloorChoice = Annotated[
    Annotated[Surface, Tag(field.NAME)] | Annotated[FloorTable, Tag(field.TABLE)],
    Discriminator(field.kind_of),
]


class RoomTable(field.Table):
    """Floor, walls and ceiling; where the walls of a room with a plan are is said by the plan."""

    floor: FloorChoice = Field(
        default="wood flooring", description="A surface preset or a table of coefficients."
    )
    left_wall: WallTable | None = Field(default=None, description="The wall at the back.")
    right_wall: WallTable | None = Field(default=None, description="The wall at the front.")
    near_side_wall: WallTable | None = Field(
        default=None, description="The wall at the near side, at −y; in space alone."
    )
    far_side_wall: WallTable | None = Field(
        default=None, description="The wall at the far side, at +y; in space alone."
    )
    walls: WallConstruction = Field(
        default="stud", description="In a room with a plan: what devices on the walls are fixed to."
    )
    ceiling: CeilingTable | None = Field(default=None, description="The ceiling.")

    def room(self) -> Room:
        """Make the room."""
        kinds: dict[str, Any] = dict.fromkeys(WALLS_AROUND, Wall) | {"ceiling": Ceiling}
        stated = {name: table for name in kinds if (table := getattr(self, name)) is not None}
        around = {name: kinds[name](**table.model_dump()) for name, table in stated.items()}
        return Room(floor_of(self.floor), **around)


@field.fields_of(
    Everyday,
    optional=("drawers", "carpet"),
    drawers="Drawers that can be open at once; default the preset's.",
    carpet="By how much the back stands higher than the front; default 11 mm on carpet, else 0.",
)
class EverydayTable(field.ValueTable):
    """What people do to the piece without an earthquake."""

    def everyday(self, preset: str | None, surface: str = "") -> Everyday:
        """Make the value for a piece of a preset, or of none, on a floor of a surface."""
        usual: dict[str, Any] = {
            "drawers": PRESET_DRAWERS.get(preset or "", 0),
            "carpet": CARPET if surface == "carpet" else 0.0,
        }
        return Everyday(**usual | self.model_dump(exclude_none=True))


@field.fields_of(State)
class InitialTable(field.ValueTable):
    """How the body stands and moves at the beginning."""

    def state(self) -> State:
        """Make the initial state."""
        return State(**self.model_dump())


StructureName = Annotated[str, field.one_of(STRUCTURES, "structure"), field.named(STRUCTURES)]
Masses = Annotated[
    list[Annotated[float, field.each(ShearModel, "masses")]], Field(min_length=1, max_length=MOST_STOREYS)
]
Stiffnesses = Annotated[
    list[Annotated[float, field.each(ShearModel, "stiffnesses")]],
    Field(min_length=1, max_length=MOST_STOREYS),
]
REGULAR = ["storeys", "structure", "period", "storey_height", "nonlinear", "yield_coefficient", "post_yield"]


@field.fields_of(Building)
class BuildingTable(PythonTable, field.ValueTable):
    """The building: what people know of it, or masses and stiffnesses of one's own."""

    storeys: int | None = field.of(Building, "storeys", default=None)
    structure: StructureName | None = Field(default=None, description='Structure; "RC" where it is not said.')
    nonlinear: bool = Field(
        default=True,
        description="Whether the storeys yield under strong shaking; below that nothing changes.",
    )
    masses: Masses | None = Field(
        default=None, description="Masses of the floors, bottom to top: a model of one's own."
    )
    stiffnesses: Stiffnesses | None = Field(
        default=None, description="Shear stiffness of the storey below each."
    )

    @model_validator(mode="wrap")
    @classmethod
    def _of_python(cls, value: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        return cls.of(value) if isinstance(value, Building | ShearModel) else handler(value)

    @classmethod
    def of(cls, building: Building | ShearModel) -> Self:
        """Return the table of a building, which makes it again; of one that no file can say, it is kept."""
        fields: dict[str, Any] = {name: getattr(building, name, None) for name in cls.model_fields}
        if isinstance(building, ShearModel):
            fields = {name: [*getattr(building, name)] for name in ("masses", "stiffnesses", "damping")}
            fields |= {
                "damping": fields["damping"][0],
                "vertical_amplification": building.vertical_amplification,
            }
        usual = {name: about.default for name, about in cls.model_fields.items()}
        table = cls.model_validate({key: value for key, value in fields.items() if value != usual[key]})
        return table if table.building() == building else table.with_python(building)

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        in_detail = self.masses is not None or self.stiffnesses is not None
        self.refuse_single("shaking.building", "masses", "stiffnesses")
        for key in REGULAR if in_detail else ():
            if key in self.model_fields_set and getattr(self, key) not in (None, False):
                name = f"shaking.building.{key}"
                raise InputError("scenario.only_one", name, other="shaking.building.masses")
        if not in_detail and self.storeys is None:
            name, allowed = "shaking.building.storeys", parameter_of(Building, "storeys")
            words = phrase("scenario.whole_number", low=allowed.low, high=allowed.high, unit="")
            raise InputError("scenario.missing", name, allowed=words)
        field.checked("shaking.building", self.building)
        return self

    def building(self) -> Building | ShearModel:
        """Make the building."""
        if self._in_python is not None:
            return self._in_python
        if self.masses is not None and self.stiffnesses is not None:
            return ShearModel(
                self.masses,
                self.stiffnesses,
                0.05 if self.damping is None else self.damping,
                vertical_amplification=self.vertical_amplification,
                name=f"{len(self.masses)}-mass building",
            )
        stated = self.model_dump(exclude={"masses", "stiffnesses"}, exclude_none=True)
        return Building(**stated)

    @property
    def yields(self) -> bool:
        """Whether the floors' motion does not scale with the ground's."""
        return self.building().model.yields

    def highest(self) -> int:
        """Return the number of the highest floor: the roof's."""
        return 1 + self.building().storeys

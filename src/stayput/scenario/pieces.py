"""The tables of a file of several pieces: where each stands, what joins two, and what may hold them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path  # noqa: TC003 - pydantic reads the annotations
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import Field, field_validator, model_validator

from stayput.errors import InputError
from stayput.measures.measure import refuse_conflicts
from stayput.model.body import BASES, MASS_RANGE, SIZE_RANGE, Body
from stayput.model.parameters import parameter_of
from stayput.model.room import WALLS_AROUND
from stayput.model.solid import Solid
from stayput.scenario.fields import Table, Text, between, checked, named, one_of
from stayput.scenario.measures import Samples, SingleChoice, UncertaintyTable, refuse_wrong_type
from stayput.scenario.tables import Heading, Kind, usual_of
from stayput.simulation.standing import STRENGTH_RANGE, Joint

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.measures import Measure

NOTHING = "none"
"""Name of the option without joints and measures, which every verification has."""

if TYPE_CHECKING:
    MeasuresInPlace = list[SingleChoice]
else:
    MeasuresInPlace = Annotated[list[SingleChoice], Field(min_length=1, max_length=20)]
"""Measures that are in place together."""

_SIZES = ("width", "length", "height", "diameter", "bottom", "top")
_SHAPES = {
    "box": {"width", "length", "height"},
    "cylinder": {"diameter", "height"},
    "cone": {"bottom", "top", "height"},
}
"""Sizes of each shape."""

BEHIND = 0.02
"""Usual gap between a piece and the wall at its back [m]."""

Size = Annotated[float, between(*SIZE_RANGE, "m")]
PlaceInPlan = Annotated[
    list[Annotated[float, between(-100.0, 100.0, "m")]], Field(min_length=2, max_length=3)
]
PointOfRoom = Annotated[
    list[Annotated[float, between(-100.0, 100.0, "m")]], Field(min_length=3, max_length=3)
]


def in_place(tables: Sequence[SingleChoice] | None) -> tuple[Measure, ...]:
    """Make the measures that are in place together."""
    return tuple(one.measure() for one in tables or ())


class StandingTable(Table):
    """A piece and where it stands: a preset, a box, a cylinder, a cone or a mesh."""

    name: Text = Field(description="What the piece is called; others stand on it by this name.")
    preset: Kind | None = Field(default=None, description="A common piece of furniture.")
    width: Size | None = Field(default=None, description="Depth of a box.")
    length: Size | None = Field(default=None, description="Length of a box, across its depth.")
    height: Size | None = Field(default=None, description="Height of a box, a cylinder or a cone.")
    diameter: Size | None = Field(default=None, description="Diameter of a cylinder.")
    bottom: Size | None = Field(default=None, description="Lower diameter of a cone.")
    top: Size | None = Field(default=None, description="Upper diameter of a cone.")
    mesh: Text | None = Field(default=None, description="A mesh's file (STL, OBJ), relative to this one.")
    unit: Text | None = Field(default=None, description="Unit of the mesh's numbers: mm, cm, m, in or ft.")
    mass: Annotated[float, between(*MASS_RANGE, "kg")] | None = Field(default=None, description="Mass.")
    base: Annotated[str, one_of(BASES), named(BASES)] | None = Field(
        default=None, description=parameter_of(Body, "base").meaning
    )
    at: PlaceInPlan = Field(
        default=[0.0, 0.0],
        description="Where the middle of its base is, along x and y of the room, or of the piece that it "
        "stands on; and how high it stands above the floor.",
    )
    on: Text | None = Field(default=None, description="The piece on whose top it stands.")
    heading: Heading = Field(default=0.0, description="Direction in which it faces: from x towards y.")
    against: Annotated[str, one_of(WALLS_AROUND), named(WALLS_AROUND)] | None = Field(
        default=None, description="In a room with a plan: the wall to which its back stands."
    )
    along: Annotated[float, between(0.0, 100.0, "m")] | None = Field(
        default=None, description="Where its middle is along that wall, from the lower x or y."
    )
    gap: Annotated[float, between(0.0, 100.0, "m")] = Field(
        default=BEHIND, description="Between its back and that wall."
    )
    measures: MeasuresInPlace | None = Field(
        default=None,
        description="Measures that hold it, each a table with its type: those of a preset or a box.",
    )

    @field_validator("measures", mode="before")
    @classmethod
    def _typed(cls, given: object) -> object:
        refuse_wrong_type(given, "furniture.measures", nested=True)
        return given

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        given = self._sizes.keys()
        ways = [self.preset is not None, self.mesh is not None, bool(given)]
        if sum(ways) != 1 or (given and given not in _SHAPES.values()):
            raise InputError("scenario.one_shape", "furniture", name=self.name)
        if self.mass is None and self.preset is None:
            raise InputError("scenario.no_preset", "furniture.mass", preset="preset")
        if (self.mesh is None) != (self.unit is None):
            name, other = "furniture.unit", "furniture.mesh"
            name, other = (name, other) if self.mesh is None else (other, name)
            raise InputError("scenario.needs_both", name, other=other)
        if self.on is not None and len(self.at) == 3:
            raise InputError("scenario.on_and_height", "furniture.at", name=self.name)
        if self.measures is not None and not self.is_furniture:
            raise InputError("scenario.measures_on_solid", "furniture.measures", name=self.name)
        checked("furniture", lambda: refuse_conflicts(in_place(self.measures)))
        return self

    @property
    def is_furniture(self) -> bool:
        """Whether measures can hold it: a preset or a box."""
        return self.preset is not None or self._sizes.keys() == _SHAPES["box"]

    def body(self) -> Body:
        """Make a preset or a box as a body that measures can hold."""
        return Body(**self._shape)

    @property
    def _sizes(self) -> dict[str, float]:
        return {size: getattr(self, size) for size in _SIZES if getattr(self, size) is not None}

    @property
    def _shape(self) -> dict[str, Any]:
        own = {name: value for name in ("mass", "base") if (value := getattr(self, name)) is not None}
        return usual_of(self.preset) | self._sizes | own

    def solid(self, folder: Path) -> Solid:
        """Make the body.

        Raises
        ------
        InputError
            A body that is not possible, or a mesh that cannot be read.
        """
        shape = self._shape
        if self.mesh is not None:
            return Solid.from_mesh(folder / self.mesh, unit=self.unit or "", **shape)
        kind = next(kind for kind, sizes in _SHAPES.items() if sizes == shape.keys() - {"mass", "base"})
        return getattr(Solid, kind)(**shape)


class JointTable(Table):
    """What joins two pieces: a connector at a point, or a belt between two."""

    first: Text = Field(description="The one piece.")
    second: Text = Field(description="The other piece.")
    at: PointOfRoom = Field(description="The point, in the room as the pieces stand.")
    to: PointOfRoom | None = Field(default=None, description="For a belt: its end on the other piece.")
    stiffness: Annotated[float, between(1.0, 1e9, "N/m")] = Field(default=1e6, description="Stiffness.")
    strength: Annotated[float, between(*STRENGTH_RANGE, "N")] | None = Field(
        default=None, description="Pull that it bears; without it any."
    )
    shear: Annotated[float, between(*STRENGTH_RANGE, "N")] | None = Field(
        default=None, description="Force across that it bears; without it any."
    )
    slack: Annotated[float, between(0.0, 10.0, "m")] = Field(default=0.0, description="Slack of a belt.")
    damping: Annotated[float, between(0.0, 2.0)] = Field(default=0.1, description="Damping ratio.")

    def joint(self, names: Sequence[str]) -> Joint:
        """Make the joint of two of the pieces that are called so.

        Raises
        ------
        InputError
            One that is not possible.
        """
        given = self.model_dump(exclude={"first", "second"}, exclude_none=True)
        return Joint(names.index(self.first), names.index(self.second), **given)


@dataclass(frozen=True, slots=True)
class AssemblyOption:
    """What may hold several pieces: their joints, and measures on each.

    Parameters
    ----------
    name : str
        What it is called; unique.
    joined : bool
        Whether the joints are in place.
    measures : tuple of tuple of Measure
        Of each piece.
    """

    name: str
    joined: bool
    measures: tuple[tuple[Measure, ...], ...]

    @property
    def count(self) -> int:
        """How many things are put in place: measures, and the joints together."""
        return sum(map(len, self.measures)) + self.joined


class HeldPieceTable(Table):
    """Measures on one of the pieces."""

    name: Text = Field(description="The piece.")
    measures: MeasuresInPlace = Field(description="The measures on it, each a table with its type.")

    @field_validator("measures", mode="before")
    @classmethod
    def _typed(cls, given: object) -> object:
        refuse_wrong_type(given, "options.pieces.measures", nested=True)
        return given

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("options.pieces", lambda: refuse_conflicts(in_place(self.measures)))
        return self


class OptionTable(Table):
    """One way to hold the pieces, which a verification compares with the others."""

    name: Text = Field(description="What it is called.")
    joined: bool = Field(default=True, description="Whether the joints of the file are in place.")
    pieces: Annotated[list[HeldPieceTable], Field(min_length=0, max_length=100)] = Field(
        default=[], description="The pieces that measures hold."
    )

    def on(self, name: str) -> tuple[Measure, ...]:
        """Make the measures on a piece."""
        return tuple(one for held in self.pieces if held.name == name for one in in_place(held.measures))


class AssemblyUncertaintyTable(UncertaintyTable):
    """How much of what is not known is tried out; runs of several pieces take long."""

    samples: Samples = Field(default=20, description="Most samples of each option.")

    @model_validator(mode="after")
    def _well_installed(self) -> Self:
        if self.badly(1.0) > 0.0:
            raise InputError("scenario.installed_well", "uncertainty.installation")
        return self

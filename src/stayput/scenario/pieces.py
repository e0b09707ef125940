"""The tables of a file of several pieces: a piece and where it stands, and what joins two."""

from __future__ import annotations

import math
from pathlib import Path  # noqa: TC003 - pydantic reads the annotations
from typing import TYPE_CHECKING, Annotated, Self

from pydantic import Field, field_validator, model_validator

from stayput.errors import InputError
from stayput.measures.measure import refuse_conflicts
from stayput.model.body import FURNITURE, MASS_RANGE, SIZE_RANGE, Body
from stayput.model.room import WALLS_AROUND
from stayput.model.solid import Solid
from stayput.scenario.assembly_options import MeasuresInPlace, in_place
from stayput.scenario.fields import Table, Text, between, checked, named, one_of
from stayput.scenario.measures import refuse_wrong_type
from stayput.scenario.tables import Kind  # noqa: TC001 - pydantic reads the annotations
from stayput.simulation.standing import Joint

if TYPE_CHECKING:
    from collections.abc import Sequence

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
    at: PlaceInPlan = Field(
        default=[0.0, 0.0],
        description="Where the middle of its base is, along x and y of the room, or of the piece that it "
        "stands on; and how high it stands above the floor.",
    )
    on: Text | None = Field(default=None, description="The piece on whose top it stands.")
    heading: Annotated[float, between(-2.0 * math.pi, 2.0 * math.pi, "rad")] = Field(
        default=0.0, description="Direction in which it faces: from x towards y."
    )
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
            raise InputError("scenario.no_mass", "furniture.mass", name=self.name)
        if (self.mesh is None) != (self.unit is None):
            raise InputError("scenario.mesh_and_unit", "furniture.unit", name=self.name)
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
        if self.preset is not None:
            piece = FURNITURE[self.preset]
            mass = piece.mass if self.mass is None else self.mass
            return Body(piece.width, piece.height, mass, length=piece.length)
        assert self.mass is not None
        sizes = self._sizes
        return Body(sizes["width"], sizes["height"], self.mass, length=sizes["length"])

    @property
    def _sizes(self) -> dict[str, float]:
        return {size: getattr(self, size) for size in _SIZES if getattr(self, size) is not None}

    def solid(self, folder: Path) -> Solid:
        """Make the body.

        Raises
        ------
        InputError
            A body that is not possible, or a mesh that cannot be read.
        """
        if self.preset is not None:
            piece = FURNITURE[self.preset]
            mass = piece.mass if self.mass is None else self.mass
            return Solid.box(piece.width, piece.length, piece.height, mass)
        assert self.mass is not None
        if self.mesh is not None:
            return Solid.from_mesh(folder / self.mesh, unit=self.unit or "", mass=self.mass)
        sizes = self._sizes
        shape = next(shape for shape, names in _SHAPES.items() if names == sizes.keys())
        return getattr(Solid, shape)(**sizes, mass=self.mass)


class JointTable(Table):
    """What joins two pieces: a connector at a point, or a belt between two."""

    first: Text = Field(description="The one piece.")
    second: Text = Field(description="The other piece.")
    at: PointOfRoom = Field(description="The point, in the room as the pieces stand.")
    to: PointOfRoom | None = Field(default=None, description="For a belt: its end on the other piece.")
    stiffness: Annotated[float, between(1.0, 1e9, "N/m")] = Field(default=1e6, description="Stiffness.")
    strength: Annotated[float, between(1e-3, 1e9, "N")] | None = Field(
        default=None, description="Pull that it bears; without it any."
    )
    shear: Annotated[float, between(1e-3, 1e9, "N")] | None = Field(
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
        x, y, z = self.at
        return Joint(
            names.index(self.first),
            names.index(self.second),
            (x, y, z),
            None if self.to is None else (self.to[0], self.to[1], self.to[2]),
            self.stiffness,
            math.inf if self.strength is None else self.strength,
            math.inf if self.shear is None else self.shear,
            self.slack,
            self.damping,
        )

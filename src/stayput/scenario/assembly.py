"""A scenario of several pieces: a file whose ``[[furniture]]`` is a list, and the assembly that it makes."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import Field, PrivateAttr, ValidationError, model_validator

from stayput.errors import InputError
from stayput.model.furniture import FURNITURE
from stayput.model.solid import Solid
from stayput.motion.units import STANDARD_GRAVITY
from stayput.scenario.fields import Table, Text, between, checked
from stayput.scenario.messages import refusal_of
from stayput.scenario.shaking import ShakingTable
from stayput.scenario.tables import Kind, RoomTable
from stayput.scenario.toml import read_toml
from stayput.simulation.run import simulate
from stayput.simulation.standing import MOST_BODIES, Assembly, Joint, Standing

if TYPE_CHECKING:
    from collections.abc import Mapping
    from os import PathLike

    from stayput.motion import Motion
    from stayput.simulation.space_run import SpaceRun

_SIZES = ("width", "length", "height", "diameter", "bottom", "top")
_SHAPES = {
    "box": {"width", "length", "height"},
    "cylinder": {"diameter", "height"},
    "cone": {"bottom", "top", "height"},
}
"""Sizes of each shape."""

Size = Annotated[float, between(1e-3, 100.0, "m")]
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
    mass: Annotated[float, between(1e-3, 1e7, "kg")] | None = Field(default=None, description="Mass.")
    at: PlaceInPlan = Field(
        default=[0.0, 0.0],
        description="Where the middle of its base is, along x and y of the room, or of the piece that it "
        "stands on; and how high it stands above the floor.",
    )
    on: Text | None = Field(default=None, description="The piece on whose top it stands.")
    heading: Annotated[float, between(-2.0 * math.pi, 2.0 * math.pi, "rad")] = Field(
        default=0.0, description="Direction in which it faces: from x towards y."
    )

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
        return self

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


class AssemblyScenario(Table):
    """Several pieces on, beside or joined to one another, and how they are shaken: in space.

    Make one with `read_assembly` or `AssemblyScenario.parse`.
    """

    title: Text | None = Field(default=None, description="What the scenario is about.")
    furniture: Annotated[list[StandingTable], Field(min_length=1, max_length=MOST_BODIES)] = Field(
        description="What stands."
    )
    joints: Annotated[list[JointTable], Field(max_length=10 * MOST_BODIES)] = Field(
        default=[], description="What joins the pieces."
    )
    static_friction: Annotated[float, between(0.0, 10.0)] = Field(
        default=0.4, description="Static friction between the pieces."
    )
    kinetic_friction: Annotated[float, between(0.0, 10.0)] = Field(
        default=0.3, description="Kinetic friction between the pieces."
    )
    room: RoomTable = Field(
        default_factory=lambda: RoomTable.model_validate({"floor": {}}),
        description="Where they stand; the gaps of the walls are from the outermost of all pieces.",
    )
    shaking: ShakingTable = Field(default_factory=ShakingTable, description="How the floor is shaken.")
    gravity: Annotated[float, between(0.1, 100.0, "m/s²")] = Field(
        default=STANDARD_GRAVITY, description="Acceleration of gravity."
    )

    _folder: Path = PrivateAttr(default=Path())

    @model_validator(mode="after")
    def _named_apart(self) -> Self:
        names = self.names
        for number, piece in enumerate(self.furniture):
            if piece.name in names[:number]:
                name, other = f"furniture[{number}].name", f"furniture[{names.index(piece.name)}]"
                raise InputError("scenario.same_name", name, name=name, value=repr(piece.name), other=other)
            if piece.on is not None and piece.on not in names[:number]:
                name = f"furniture[{number}].on"
                raise InputError("scenario.stands_on", name, name=name, value=repr(piece.on))
        for number, joint in enumerate(self.joints):
            for key in ("first", "second"):
                if getattr(joint, key) not in names:
                    name = f"joints[{number}].{key}"
                    value = repr(getattr(joint, key))
                    raise InputError("scenario.no_such_piece", name, name=name, value=value)
        checked("joints", self._joints)
        return self

    @classmethod
    def parse(cls, data: Mapping[str, Any], folder: Path = Path()) -> AssemblyScenario:
        """Make a scenario from the keys and values of its file; see `Scenario.parse`."""
        try:
            scenario = cls.model_validate(dict(data))
        except ValidationError as error:
            raise refusal_of(error.errors(), _schema()) from None
        scenario._folder = folder
        return scenario

    @property
    def names(self) -> tuple[str, ...]:
        """What the pieces are called."""
        return tuple(piece.name for piece in self.furniture)

    def assembly(self) -> Assembly:
        """Make the assembly.

        Raises
        ------
        InputError
            A body that is not possible, or a mesh that cannot be read.
        """
        placed: dict[str, tuple[float, float, float]] = {}
        tops: dict[str, float] = {}
        members: list[Standing] = []
        for piece in self.furniture:
            solid = piece.solid(self._folder)
            x, y, *up = piece.at
            z = up[0] if up else 0.0
            if piece.on is not None:
                x, y, z = x + placed[piece.on][0], y + placed[piece.on][1], tops[piece.on]
            placed[piece.name] = x, y, z
            tops[piece.name] = z + float(solid.vertices[:, 2].max())
            members.append(Standing(solid, (x, y, z), piece.heading))
        return Assembly(members, (self.static_friction, self.kinetic_friction), self._joints())

    def _joints(self) -> list[Joint]:
        names = self.names
        return [
            Joint(
                names.index(one.first),
                names.index(one.second),
                (one.at[0], one.at[1], one.at[2]),
                None if one.to is None else (one.to[0], one.to[1], one.to[2]),
                one.stiffness,
                math.inf if one.strength is None else one.strength,
                math.inf if one.shear is None else one.shear,
                one.slack,
                one.damping,
            )
            for one in self.joints
        ]

    def motion(self) -> Motion:
        """Make the motion of the floor: of a suite, that of its ``member``."""
        return self.shaking.motion(self._folder)

    def run(self) -> SpaceRun:
        """Simulate the pieces."""
        return simulate(self.assembly(), self.room.room(), self.motion(), gravity=self.gravity)


@cache
def _schema() -> dict[str, Any]:
    return AssemblyScenario.model_json_schema()


def read_assembly(path: str | PathLike[str]) -> AssemblyScenario:
    """Read a scenario file of several pieces.

    Parameters
    ----------
    path : str or Path
        The file, in TOML, with ``[[furniture]]``.

    Raises
    ------
    InputError
        The file cannot be read, is not TOML, or says something that is not allowed.
    """
    file = Path(path)
    try:
        return AssemblyScenario.parse(read_toml(file), file.parent)
    except InputError as error:
        raise error.at(file.name) from None

"""The tables of the pieces: what each is and where it stands, what joins two, and what may hold them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import Field, PrivateAttr, model_validator

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.model.body import Body, check_density
from stayput.model.parameters import SIZE_RANGE, parameters
from stayput.model.room import WALLS_AROUND
from stayput.scenario.fields import Table, Text, ValueTable, between, checked, fields_of, named, one_of
from stayput.scenario.measures import SingleChoice
from stayput.scenario.tables import Heading, Kind, Loads, PythonTable, usual_of
from stayput.simulation.piece import BEHIND, Piece
from stayput.simulation.scene import STRENGTH_RANGE, Joint

if TYPE_CHECKING:
    from stayput.measures import Measure

    MeasuresInPlace = list[SingleChoice]
else:
    MeasuresInPlace = Annotated[list[SingleChoice], Field(max_length=20)]
"""Measures that are in place together."""

_ROUND = ("diameter", "bottom", "top")
_SHAPES = ({"mesh"}, {"diameter", "height"}, {"bottom", "top", "height"})
"""What gives the shape of a piece that is neither a preset nor a box."""

Size = Annotated[float, between(*SIZE_RANGE, "m")]
Coordinate = Annotated[float, between(-100.0, 100.0, "m")]
PlaceInPlan = Annotated[list[Coordinate], Field(min_length=2, max_length=3)]
PointOfRoom = Annotated[list[Coordinate], Field(min_length=3, max_length=3)]


def in_place(tables: Sequence[SingleChoice] | None) -> tuple[Measure, ...]:
    """Make the measures that are in place together."""
    return tuple(table.measure() for table in tables or ())


@cache
def _stand_in() -> Body:
    """Return the body with which a piece's place and measures are checked: a mesh is read in its folder."""
    return Body.box(1.0, 1.0, 1.0, 1.0)


@fields_of(
    Body, optional=("width", "height", "mass", "base"), mass="Mass; with shelves, that of the empty carcass."
)
class PieceTable(PythonTable, ValueTable):
    """A piece and where it stands: a preset with other fields or not, a box, a cylinder, a cone or a mesh."""

    name: Text | None = Field(
        default=None,
        description="What the piece is called, default its preset; others stand on it by this name.",
    )
    preset: Kind | None = Field(
        default=None, description="A common piece of furniture; a default, not a citation."
    )
    shelves: Loads | None = Field(
        default=None, description="Load on each shelf from the lowest up; mass, centre and inertia follow."
    )
    heading: Heading = Field(
        default=0.0,
        description="Direction in which it faces, from x towards y; of a lone piece it matters where the "
        "direction of the motion is not drawn.",
    )
    diameter: Size | None = Field(default=None, description="Diameter of a cylinder.")
    bottom: Size | None = Field(default=None, description="Lower diameter of a cone.")
    top: Size | None = Field(default=None, description="Upper diameter of a cone.")
    mesh: Text | None = Field(default=None, description="A mesh's file (STL, OBJ), relative to this one.")
    unit: Text | None = Field(default=None, description="Unit of the mesh's numbers: mm, cm, m, in or ft.")
    at: PlaceInPlan = Field(
        default=[0.0, 0.0],
        description="Where the middle of its base is, along x and y of the room, or of the piece that it "
        "stands on; and how high it stands above the floor.",
    )
    on: Text | None = Field(default=None, description="The piece on whose top it stands.")
    against: Annotated[str, one_of(WALLS_AROUND), named(WALLS_AROUND)] | None = Field(
        default=None, description="In a room with a plan: the wall to which its back stands."
    )
    along: Annotated[float, between(0.0, 100.0, "m")] | None = Field(
        default=None, description="Where its middle is along that wall, from the lower x or y."
    )
    gap: float = between(0.0, 100.0, "m", default=BEHIND, description="Between its back and that wall.")
    measures: MeasuresInPlace | None = Field(
        default=None,
        description="Measures that hold it, each a table with its type: those of a preset or a box. They "
        "are in place in every option that does not name the piece.",
    )

    _in_python: Mapping[str, Any] = PrivateAttr(default_factory=dict[str, Any])

    @property
    def own_measures(self) -> tuple[Measure, ...]:
        """The measures that it states itself."""
        return self._in_python.get("measures") or in_place(self.measures)

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        self._check_shape()
        self.refuse_single("furniture", "mesh", "unit")
        if self.measures is not None and not self.is_furniture:
            where = phrase("scenario.of_a_solid")
            raise InputError("common.left_out", "furniture.measures", where=where)
        checked("furniture", lambda: self.standing(_stand_in(), self.own_measures))
        return self

    def _check_shape(self) -> None:
        """Raise `InputError` where it has no shape, or two."""
        shape = {*(about.name for about in parameters(Body)), *_ROUND, "mesh", "preset", "shelves"}
        stated = {key for key in shape - {"mass", "base"} if getattr(self, key) is not None}
        if not self.is_furniture and stated not in _SHAPES:
            raise InputError("scenario.one_shape", "furniture", name=self.title)
        for key in () if self.preset else ("width", "height", "mass"):
            if getattr(self, key) is None and (self.is_furniture or key == "mass"):
                allowed = phrase("scenario.without_preset")
                raise InputError("scenario.missing", f"furniture.{key}", allowed=allowed)
        if not self.is_furniture:
            return
        for key in ("cg_offset", "inertia") if self.shelves else ():
            if getattr(self, key) is not None:
                raise InputError("scenario.only_one", f"furniture.{key}", other="furniture.shelves")
        if self.shelves and self.mass is None and usual_of(self.preset, loaded=False)["mass"] is None:
            raise InputError("scenario.missing", "furniture.mass", allowed=phrase("scenario.no_carcass"))
        checked("furniture", self.body)

    @property
    def title(self) -> str:
        """What the piece is called."""
        return self.name or self.preset or "piece"

    @property
    def is_furniture(self) -> bool:
        """Whether measures can hold it: a preset or a box."""
        return self.mesh is None and all(getattr(self, size) is None for size in _ROUND)

    def body(self) -> Body:
        """Make the body of a preset or a box."""
        values = usual_of(self.preset, loaded=not self.shelves)
        values |= self.model_dump(include={about.name for about in parameters(Body)}, exclude_none=True)
        for key in ("cg_offset", "base_heights", "base_insets"):
            if key in values:
                values[key] = tuple(values[key])
        if self.shelves is None:
            return check_density(Body(**values))
        width, height, mass = (values.pop(key) for key in ("width", "height", "mass"))
        return check_density(replace(Body.bookcase(width, height, mass, self.shelves), **values))

    def body_in(self, folder: Path) -> Body:
        """Make the body, of a mesh in a folder.

        Raises
        ------
        InputError
            A body that is not possible, or a mesh that cannot be read.
        """
        if self.is_furniture or "body" in self._in_python:
            return self._in_python.get("body") or self.body()
        known = {"mass": self.mass} | ({} if self.base is None else {"base": self.base})
        if self.mesh is not None:
            body = Body.mesh(folder / self.mesh, unit=self.unit or "", **known)
        elif self.diameter is not None:
            body = Body.cylinder(self.diameter, self.height, **known)
        else:
            body = Body.cone(self.bottom or 0.0, self.top or 0.0, self.height, **known)
        return check_density(body)

    def standing(self, body: Body, measures: tuple[Measure, ...]) -> Piece:
        """Make the piece of its body, with measures in place."""
        x, y, *up = self.at
        stated = self.model_dump(include={"heading", "on", "against", "along", "gap"})
        stated |= {**self._in_python, "body": body, "measures": measures}
        return Piece(at=(x, y, up[0] if up else 0.0), name=self.title, **stated)


class JointTable(Table):
    """What joins two pieces: a connector at a point, or a belt between two."""

    first: Text = Field(description="The one piece.")
    second: Text = Field(description="The other piece.")
    at: PointOfRoom = Field(description="The point, in the room as the pieces stand.")
    to: PointOfRoom | None = Field(default=None, description="For a belt: its end on the other piece.")
    stiffness: float = between(1.0, 1e9, "N/m", default=1e6, description="Stiffness.")
    strength: float | None = between(
        *STRENGTH_RANGE, "N", default=None, description="Pull that it bears; without it any."
    )
    shear: float | None = between(
        *STRENGTH_RANGE, "N", default=None, description="Force across that it bears; without it any."
    )
    slack: float = between(0.0, 10.0, "m", default=0.0, description="Slack of a belt.")
    damping: float = between(0.0, 2.0, default=0.1, description="Damping ratio.")

    def joint(self, names: Sequence[str]) -> Joint:
        """Make the joint of two of the pieces that are called so.

        Raises
        ------
        InputError
            One that is not possible.
        """
        stated = self.model_dump(exclude={"first", "second"}, exclude_none=True)
        return Joint(names.index(self.first), names.index(self.second), **stated)


class OptionTable(Table):
    """One way to hold the pieces, which a verification compares with the others."""

    name: Text = Field(description="What it is called.")
    joined: bool = Field(default=True, description="Whether the joints of the file are in place.")
    measures: dict[str, MeasuresInPlace] = Field(
        default={},
        description="The measures on each piece, by its name: tables with their types. They replace all "
        "measures that the piece itself states, [] removes these; pieces that are not named keep theirs.",
    )

    def on(self, piece: PieceTable) -> tuple[Measure, ...]:
        """Make the measures on a piece."""
        named = piece.title in self.measures
        return in_place(self.measures[piece.title]) if named else piece.own_measures

"""The tables of a room's plan: its size, doors, windows, and places where people are."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

from pydantic import Field

from stayput.model.floor_plan import PLACES, Door, FloorPlan, PersonPlace, Window
from stayput.scenario.fields import Text, ValueTable, fields_of, named, one_of
from stayput.scenario.pieces import Coordinate

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

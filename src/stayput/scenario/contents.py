"""The table of a scenario that says what is in the furniture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Self

from pydantic import Field, model_validator

from stayput.contents.contents import DOORS, DRAWERS, Contents
from stayput.contents.kinds import CONTENTS
from stayput.scenario.fields import Table, checked, each, named, of, one_of

if TYPE_CHECKING:
    from stayput.scenario.tables import FurnitureTable

KindOfContents = Annotated[str, one_of(CONTENTS, "contents"), named(CONTENTS)]
KindOfDoors = Annotated[str, one_of(DOORS), named(DOORS)]
KindOfDrawers = Annotated[str, one_of(DRAWERS), named(DRAWERS)]
ShelfLoads = Annotated[list[Annotated[float, each(Contents, "loads")]], Field(min_length=1, max_length=100)]


class ContentsTable(Table):
    """What is in the furniture, and what keeps it there: a kind, any number of which may be overridden."""

    kind: KindOfContents = Field(default="books", description="Kind of contents; a default, not a citation.")
    shelves: int | None = of(Contents, "shelves")
    loads: ShelfLoads | None = of(
        Contents,
        "loads",
        listed=True,
        description="Mass on each shelf from the lowest up; default the furniture's shelves.",
    )
    mass_share: float | None = of(
        Contents, "mass_share", description="Without loads: mass of the contents, of the furniture's."
    )
    width: float | None = of(Contents, "width", description="Depth of an item.")
    height: float | None = of(Contents, "height", description="Height of an item.")
    static_friction: float | None = of(
        Contents,
        "static_friction",
        description="Static friction on the shelf; of drawers on their runners.",
    )
    kinetic_friction: float | None = of(Contents, "kinetic_friction", description="The same while it slides.")
    setback: float | None = of(
        Contents, "setback", description="Distance from the front edge of the shelf to the items."
    )
    lip: float = of(Contents, "lip")
    slope: float = of(Contents, "slope")
    back: bool = Field(default=True, description="Whether a board or a wall is behind the items.")
    doors: KindOfDoors = Field(default="none", description="What is in front of the shelves.")
    drawers: KindOfDrawers = Field(default="none", description="Which drawers the contents are in, if any.")
    catch: float | None = of(
        Contents, "catch", description="Force at which a catch lets go; default: by kind."
    )
    door_mass: float = of(Contents, "door_mass")
    leaf: float = of(Contents, "leaf")
    restitution: float = of(Contents, "restitution")
    items: int = of(Contents, "items")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("contents", self.contents)
        return self

    def contents(self, furniture: FurnitureTable | None = None) -> Contents:
        """Make the contents; loads that are not given are those of the furniture's shelves."""
        given = self.model_dump(exclude={"loads"})
        loads = self.loads
        if loads is None and furniture is not None and not {"shelves", "mass_share"} & self.model_fields_set:
            loads = furniture.shelves
        return Contents(**given, loads=None if loads is None else tuple(loads))

"""A scenario of a room: a file with a ``[plan]``, pieces, doors, windows, and places where people are."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any, Self

import numpy as np
from pydantic import Field, model_validator

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.model.floor_plan import (
    FACING,
    HINGES,
    MOST_PLACES,
    OPENS,
    PLACES,
    Door,
    FloorPlan,
    PersonPlace,
    Window,
)
from stayput.model.room import WALLS_AROUND, Room, Wall
from stayput.scenario.assembly import AssemblyScenario
from stayput.scenario.fields import Table, Text, ValueTable, fields_of, named, of, one_of
from stayput.scenario.measures import Samples  # noqa: TC001 - pydantic reads the annotations
from stayput.scenario.pieces import AssemblyUncertaintyTable, Coordinate
from stayput.scenario.tables import (
    CeilingTable,
    FloorChoice,
    Heading,
    WallConstruction,
    floor_of,
)
from stayput.simulation.convex import inside_each_other
from stayput.simulation.placing import bare
from stayput.simulation.space_engine import DEEPEST
from stayput.simulation.standing import Standing

if TYPE_CHECKING:
    from collections.abc import Sequence
    from os import PathLike

    from stayput.model.solid import Solid
    from stayput.motion import Motion
    from stayput.scenario.pieces import StandingTable
    from stayput.simulation.run import Run
    from stayput.simulation.standing import Assembly

WallName = Annotated[str, one_of(WALLS_AROUND), named(WALLS_AROUND)]
PointInPlan = Annotated[list[Coordinate], Field(min_length=2, max_length=2)]


@fields_of(FloorPlan)
class PlanTable(ValueTable):
    """The size of a room, which goes from the left wall to the right one and from the near to the far one."""


class DoorTable(Table):
    """A door."""

    name: Text = Field(default="door", description="What it is called.")
    wall: WallName = Field(description="The wall that it is in.")
    start: float = of(Door, "start")
    width: float = of(Door, "width", default=0.8)
    hinge: Annotated[str, one_of(HINGES), named(HINGES)] = Field(
        default="start", description="At which end of it, along the wall, the hinge is."
    )
    opens: Annotated[str, one_of(OPENS), named(OPENS)] = Field(default="inwards", description="How it opens.")
    way_out: bool = Field(default=True, description="Whether it leads out.")


class WindowTable(Table):
    """A window: nothing that is higher than its sill is moved in front of it."""

    wall: WallName = Field(description="The wall that it is in.")
    start: float = of(Window, "start")
    width: float = of(Window, "width", default=1.6)
    sill: float = of(Window, "sill")


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
        given = self.model_dump(exclude={"name", "kind", "at", "heading"}, exclude_none=True)
        made = PersonPlace.of(self.kind, (self.at[0], self.at[1]), self.heading, self.name)
        return replace(made, **given)


class RoomSurfacesTable(Table):
    """Floor, walls and ceiling of a room with a plan, which says where its walls are."""

    floor: FloorChoice = Field(
        default="wood flooring", description="A surface preset or a table of coefficients."
    )
    walls: WallConstruction = Field(default="stud", description="What devices on the walls are fixed to.")
    ceiling: CeilingTable | None = Field(default=None, description="The ceiling.")


class RoomUncertaintyTable(AssemblyUncertaintyTable):
    """How much of what is not known is tried out."""

    samples: Samples = Field(default=60, description="Runs of the room.")


class RoomScenario(AssemblyScenario):
    """A room with furniture and people: `stayput.verify_room` says who is hit, and which door stays shut.

    Make one with `read_room` or `RoomScenario.parse`. Places are from the corner of the left and the near
    wall.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.read_room("examples/bedroom.toml")
    >>> isinstance(scenario, sp.RoomScenario), scenario.title
    (True, 'Bedroom')
    """

    plan: PlanTable = Field(description="The size of the room.")
    doors: Annotated[list[DoorTable], Field(max_length=MOST_PLACES)] = Field(
        default=[], description="Its doors."
    )
    windows: Annotated[list[WindowTable], Field(max_length=MOST_PLACES)] = Field(
        default=[], description="Its windows."
    )
    places: Annotated[list[PlaceTable], Field(max_length=MOST_PLACES)] = Field(
        default=[], description="Where people are."
    )
    direction: Heading | None = Field(
        default=None,
        description="Where the motion's x points in plan, from x towards y; by default it is drawn.",
    )
    room: RoomSurfacesTable = Field(  # pyright: ignore[reportIncompatibleVariableOverride]
        default_factory=RoomSurfacesTable, description="Floor, walls and ceiling."
    )
    uncertainty: RoomUncertaintyTable = Field(  # pyright: ignore[reportIncompatibleVariableOverride]
        default_factory=RoomUncertaintyTable, description="How much of what is not known is tried out."
    )

    @model_validator(mode="after")
    def _in_the_room(self) -> Self:
        try:
            self.floor_plan()
        except InputError as error:
            raise error.at(error.field or "plan", error.field) from None
        if self.option_tables is not None:
            raise InputError("rooms.options_in_a_room", "options")
        for number, piece in enumerate(self.furniture):
            if piece.against is not None and piece.along is None:
                raise InputError(
                    "rooms.against_without_along", f"furniture[{number}].along", wall=piece.against
                )
        return self

    def floor_plan(self) -> FloorPlan:
        """Make the plan: sides, doors, windows, places."""
        doors = [Door(**door.model_dump()) for door in self.doors]
        windows = [Window(**window.model_dump()) for window in self.windows]
        places = [table.place() for table in self.places]
        return FloorPlan(self.plan.width, self.plan.length, doors, windows, places)

    def stands(self, piece: StandingTable, solid: Solid) -> tuple[tuple[float, float, float], float]:
        """Return where a piece stands and what it faces: with its back to a wall where it says so."""
        if piece.against is None or piece.along is None:
            return super().stands(piece, solid)
        heading = FACING[piece.against]
        behind = -Standing(solid).along((1.0, 0.0, 0.0))[0]
        x, y = self.floor_plan().on_wall(piece.against, piece.along, piece.gap + behind)
        return (x, y, 0.0), heading

    def motion(self) -> Motion:
        """Make the motion of the floor as `AssemblyScenario.motion`, turned to its direction."""
        motion = super().motion()
        if not self.direction:
            return motion
        y = np.zeros_like(motion.x) if motion.y is None else motion.y
        return replace(motion, y=y).rotated(-self.direction)

    def run(self) -> Run:
        """Simulate the pieces as the file states them, in a room with its places, doors and windows."""
        plan = self.floor_plan()
        with self.naming_file():
            refuse_what_stands_wrong(self, plan, self.assembly())
        return replace(super().run(), plan=plan)

    def surroundings(self) -> Room:
        """Make the room around all pieces; the gaps of its walls are from the outermost of them."""
        return self.around([bare(one) for one in self.assembly().members])

    def around(self, standing: Sequence[Standing]) -> Room:
        """Make the room as some of the pieces see it: the gaps of its walls are from the outermost of them.

        Parameters
        ----------
        standing : sequence of Standing
            The pieces.

        Raises
        ------
        InputError
            A piece that stands in a wall.
        """
        ceiling = self.room.ceiling and self.room.ceiling.ceiling()
        x, y = (
            np.array([one.along(axis) for one in standing]) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
        )
        low, high = np.array([x[:, 0].min(), y[:, 0].min()]), np.array([x[:, 1].max(), y[:, 1].max()])
        gaps = self.floor_plan().distances(low, high)
        walls = {name: Wall(max(0.0, gap), construction=self.room.walls) for name, gap in gaps.items()}
        return Room(floor_of(self.room.floor), ceiling=ceiling, **walls)


def refuse_what_stands_wrong(scenario: RoomScenario, plan: FloorPlan, whole: Assembly) -> None:
    """Raise `InputError` where a piece stands in floor, wall, ceiling, another, or where a person is."""
    names, standing_all = scenario.names, [bare(member) for member in whole.members]
    sides = np.array([plan.width, plan.length])
    for number, standing in enumerate(standing_all):
        corners = standing.solid.vertices @ standing.turn.T + np.asarray(standing.at)
        low, high = corners.min(axis=0), corners.max(axis=0)
        name = f"furniture[{number}].at"
        called = repr(names[number])
        if (low[:2] < -1e-6).any() or (high[:2] > sides + 1e-6).any():
            values: dict[str, Any] = {"width": plan.width, "length": plan.length}
            for axis, one in enumerate("xy"):
                values |= {f"low_{one}": float(low[axis]), f"high_{one}": float(high[axis])}
            raise InputError("rooms.in_a_wall", name, name=called, **values)
        if low[2] < -DEEPEST:
            values = {"body": called, "depth": -float(low[2]), "surface": phrase("simulation.floor")}
            raise InputError("simulation.begins_inside", name, **values)
        ceiling = scenario.room.ceiling
        if ceiling is not None and high[2] > ceiling.height + 1e-6:
            values = {"high": float(high[2]), "height": ceiling.height}
            raise InputError("rooms.in_the_ceiling", f"furniture[{number}]", name=called, **values)
        others: list[tuple[Standing | PersonPlace, str]] = [
            (other, repr(names[before])) for before, other in enumerate(standing_all[:number])
        ]
        others += [(place, repr(place.name)) for place in plan.places]
        for other, what in others:
            depth = inside_each_other(standing, other)
            if depth > DEEPEST:
                raise InputError("rooms.in_another", name, name=called, other=what, depth=depth)


def read_room(path: str | PathLike[str]) -> RoomScenario:
    """Read the scenario file of a room.

    Parameters
    ----------
    path : str or Path
        The file, in TOML, with ``[plan]``.

    Raises
    ------
    InputError
        The file cannot be read, is not TOML, or says something that is not allowed.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.read_room("examples/bedroom.toml")
    >>> plan = scenario.floor_plan()
    >>> plan.width, plan.length, [place.name for place in plan.places]  # m
    (3.6, 2.7, ['bed'])
    >>> {piece.name: piece.against for piece in scenario.furniture}
    {'bookcase': 'left_wall', 'wardrobe': 'far_side_wall', 'chest': 'near_side_wall'}
    """
    return RoomScenario.read(path)

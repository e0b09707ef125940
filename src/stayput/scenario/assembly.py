"""A scenario of several pieces: a file whose ``[[furniture]]`` is a list, and the assembly that it makes."""

from __future__ import annotations

from contextlib import contextmanager
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import tomli_w
from pydantic import Field, ValidationError, model_validator

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.measures.measure import refuse_conflicts
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.scenario.assembly_options import (
    NOTHING,
    AssemblyOption,
    AssemblyUncertaintyTable,
    OptionTable,
    in_place,
)
from stayput.scenario.fields import Text, between, checked
from stayput.scenario.messages import refusal_of
from stayput.scenario.origin import FromFile
from stayput.scenario.pieces import (
    JointTable,  # noqa: TC001 - pydantic reads the annotations
    StandingTable,  # noqa: TC001 - pydantic reads the annotations
)
from stayput.scenario.shaking import ShakingTable
from stayput.scenario.tables import RoomTable, floor_of
from stayput.scenario.toml import read_toml
from stayput.simulation.case import simulate
from stayput.simulation.standing import MOST_BODIES, Assembly, Piece, Standing, friction_between

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping
    from os import PathLike

    import xarray as xr

    from stayput.model.room import Floor, Room
    from stayput.model.solid import Solid
    from stayput.motion import Motion
    from stayput.motion.suites import Suite
    from stayput.simulation.space_run import SpaceRun
    from stayput.simulation.standing import Joint


class AssemblyScenario(FromFile):
    """Several pieces on, beside or joined to one another, and how they are shaken: in space.

    Make one with `read_assembly` or `AssemblyScenario.parse`.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.read_assembly("examples/television.toml")
    >>> print(scenario.title, *zip(scenario.names, map(str, scenario.run().outcomes)))
    Television on a stand ('stand', 'rocked') ('television', 'fell off')
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
    dimensions: Literal[3] = Field(default=3, description="Several pieces are always in space.")
    room: RoomTable = Field(
        default_factory=lambda: RoomTable.model_validate({"floor": {}}),
        description="Where they stand; the gaps of the walls are from the outermost of all pieces.",
    )
    shaking: ShakingTable = Field(default_factory=ShakingTable, description="How the floor is shaken.")
    gravity: Annotated[float, between(0.1, 100.0, "m/s²")] = Field(
        default=STANDARD_GRAVITY, description="Acceleration of gravity."
    )
    option_tables: Annotated[list[OptionTable], Field(min_length=1, max_length=100)] | None = Field(
        default=None, alias="options", description="What a verification compares; by default the usual."
    )
    uncertainty: AssemblyUncertaintyTable = Field(
        default_factory=AssemblyUncertaintyTable, description="How much of what is not known is tried out."
    )

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
        try:
            friction_between((self.static_friction, self.kinetic_friction))
        except InputError as error:
            raise error.about("kinetic_friction") from None
        for number, joint in enumerate(self.joints):
            for key in ("first", "second"):
                if getattr(joint, key) not in names:
                    name = f"joints[{number}].{key}"
                    value = repr(getattr(joint, key))
                    raise InputError("scenario.no_such_piece", name, name=name, value=value)
        self._joints()
        self._check_options()
        return self

    def _check_options(self) -> None:
        names = self.names
        taken = [NOTHING, *(option.name for option in self.option_tables or ())]
        for number, option in enumerate(self.option_tables or ()):
            if option.name in taken[: number + 1]:
                name = f"options[{number}].name"
                first = taken.index(option.name) - 1
                other = f"options[{first}]" if first >= 0 else phrase("scenario.option_of_nothing")
                raise InputError("scenario.same_name", name, name=name, value=repr(option.name), other=other)
            for place, piece in enumerate(option.pieces):
                name = f"options[{number}].pieces[{place}].name"
                if piece.name not in names:
                    raise InputError("scenario.no_such_piece", name, name=name, value=repr(piece.name))
                if not self.furniture[names.index(piece.name)].is_furniture:
                    raise InputError("scenario.measures_on_solid", name, name=piece.name)
            for name in names:
                checked(f"options[{number}]", partial(refuse_conflicts, option.on(name)))

    @classmethod
    def parse(cls, data: Mapping[str, Any], folder: Path = Path(), file: str = "") -> Self:
        """Make a scenario from the keys and values of its file; see `Scenario.parse`."""
        try:
            scenario = cls.model_validate(dict(data))
        except ValidationError as error:
            raise refusal_of(error.errors(), _schema(cls)) from None
        scenario._folder, scenario._file = folder, file
        return scenario

    @property
    def names(self) -> tuple[str, ...]:
        """What the pieces are called."""
        return tuple(piece.name for piece in self.furniture)

    @property
    def counted(self) -> tuple[int, ...]:
        """The pieces of furniture, by whose falls a verification ranks: all pieces where there is none."""
        furniture = tuple(number for number, piece in enumerate(self.furniture) if piece.is_furniture)
        return furniture or tuple(range(len(self.furniture)))

    @property
    def stated(self) -> AssemblyOption:
        """The pieces as the file states them: with its joints, and with the measures of its pieces."""
        measures = tuple(in_place(piece.measures) for piece in self.furniture)
        return AssemblyOption("as stated", bool(self.joints), measures)

    @property
    def options(self) -> tuple[AssemblyOption, ...]:
        """What a verification compares; empty where the file says nothing."""
        return tuple(
            AssemblyOption(
                table.name,
                table.joined and bool(self.joints),
                tuple(table.on(name) for name in self.names),
            )
            for table in self.option_tables or ()
        )

    def assembly(self, option: AssemblyOption | None = None) -> Assembly:
        """Make the assembly.

        Parameters
        ----------
        option : AssemblyOption, optional
            What is in place; default what the file states.

        Raises
        ------
        InputError
            A body that is not possible, or a mesh that cannot be read.
        """
        chosen = self.stated if option is None else option
        # furniture sinks into a floor that settles as a Piece alone
        as_pieces = option is not None or self.floor.settlement > 0.0
        with self.naming_pieces():
            members = [
                Piece(piece.body(), at, heading, measures)
                if measures or (as_pieces and piece.is_furniture)
                else Standing(solid, at, heading)
                for piece, (solid, at, heading), measures in zip(
                    self.furniture, self._placed(), chosen.measures, strict=True
                )
            ]
            joints = self._joints() if chosen.joined else []
            return Assembly(members, (self.static_friction, self.kinetic_friction), joints)

    def by_names(self, error: InputError) -> InputError:
        """Return a refusal of its assembly with the names of the pieces in place of the members' numbers."""
        for number, name in enumerate(self.names):
            error = error.renamed(f"members[{number}]", repr(name))
        return error

    @contextmanager
    def naming_pieces(self) -> Generator[None]:
        """Refuse what is wrong with its assembly by the names of the pieces, and with the file's name."""
        with self.naming_file():
            try:
                yield
            except InputError as error:
                raise self.by_names(error) from None

    def stands(self, piece: StandingTable, solid: Solid) -> tuple[tuple[float, float, float], float]:
        """Return where a piece stands, by its own table, and what it faces.

        Parameters
        ----------
        piece : StandingTable
            The piece.
        solid : Solid
            Its body.
        """
        if piece.against is not None:
            name = f"furniture[{self.names.index(piece.name)}].against"
            raise InputError("rooms.against_without_plan", name, name=name, value=repr(piece.against))
        x, y, *up = piece.at
        return (x, y, up[0] if up else 0.0), piece.heading

    def _placed(self) -> list[tuple[Solid, tuple[float, float, float], float]]:
        """Return each body, where the middle of its base is [m], and what it faces."""
        placed: dict[str, tuple[Solid, tuple[float, float, float], float]] = {}
        for number, piece in enumerate(self.furniture):
            solid = checked(f"furniture[{number}]", partial(piece.solid, self._folder))
            (x, y, z), heading = self.stands(piece, solid)
            if piece.on is not None:
                below, (x_below, y_below, z_below), faces = placed[piece.on]
                plan = Standing(below, heading=faces)
                (low_x, high_x), (low_y, high_y) = plan.along((1.0, 0.0, 0.0)), plan.along((0.0, 1.0, 0.0))
                if not (low_x <= x <= high_x and low_y <= y <= high_y):
                    raise InputError(
                        "scenario.beside_support",
                        f"furniture[{number}].at",
                        name=f"furniture[{number}].at",
                        value=piece.at,
                        other=repr(piece.on),
                        low_x=low_x,
                        high_x=high_x,
                        low_y=low_y,
                        high_y=high_y,
                    )
                x, y, z = x + x_below, y + y_below, z_below + float(below.vertices[:, 2].max())
            placed[piece.name] = solid, (x, y, z), heading
        return list(placed.values())

    def _joints(self) -> list[Joint]:
        try:
            return [
                checked(f"joints[{number}]", partial(table.joint, self.names))
                for number, table in enumerate(self.joints)
            ]
        except InputError as error:
            raise self.by_names(error) from None

    @property
    def floor(self) -> Floor:
        """What the pieces stand on."""
        return floor_of(self.room.floor)

    def surroundings(self) -> Room:
        """Make the room; the gaps of its walls are from the outermost of all pieces."""
        return self.room.room()

    def motion(self) -> Motion:
        """Make the motion of the floor: of a suite, that of its ``member``."""
        with self.naming_file("shaking"):
            return self.shaking.motion(self._folder)

    def ground(self) -> Suite:
        """Make the motions of the ground, not scaled, with all components."""
        with self.naming_file("shaking"):
            return self.shaking.ground(self._folder)

    def to_toml(self) -> str:
        """Return the scenario as a file's text; see `Scenario.to_toml`."""
        return tomli_w.dumps(
            self.model_dump(mode="json", exclude_unset=True, exclude_none=True, by_alias=True)
        )

    def run(self) -> SpaceRun:
        """Simulate the pieces as the file states them."""
        assembly, motion = self.assembly(), self.motion()
        with self.naming_pieces():
            return simulate(assembly, self.surroundings(), motion, gravity=self.gravity)

    def sweep(
        self, axes: Mapping[str, Any], *, threads: int | None = None, progress: bool | None = None
    ) -> xr.Dataset:
        """Simulate the pieces along axes; the result has a dimension for each, and one for the pieces.

        Parameters
        ----------
        axes : mapping
            Keys of the file and their values: ``{"static_friction": [...], "shaking.scale": [...]}``. The
            cases are all combinations. ``joints.strength`` changes all joints, ``joints[0].strength`` one.
        threads : int, optional
            As many as there are cores by default. The bits do not depend on them.
        progress : bool, optional
            Whether to draw a bar on standard error; default on a terminal.

        Raises
        ------
        InputError
            A key that there is not, or a value that the file may not have.
        """
        from stayput.scenario.assembly_sweep import sweep_assembly

        return sweep_assembly(self, axes, threads=threads, progress=progress)


@cache
def _schema(kind: type[AssemblyScenario]) -> dict[str, Any]:
    return kind.model_json_schema()


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

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.read_assembly("examples/dresser.toml")
    >>> scenario.title
    'Dresser with a joined upper part'
    """
    file = Path(path)
    try:
        return AssemblyScenario.parse(read_toml(file), file.parent, file.name)
    except InputError as error:
        raise error.at(file.name) from None

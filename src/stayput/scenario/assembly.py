"""A scenario of several pieces: a file whose ``[[furniture]]`` is a list, and the assembly that it makes."""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextlib import contextmanager
from functools import partial
from itertools import product
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self, cast

import numpy as np
from pydantic import Field, model_validator

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of
from stayput.execution import Pool
from stayput.measures.element import utilisation
from stayput.measures.measure import refuse_conflicts
from stayput.mechanics.columns import RESULT
from stayput.mechanics.devices.columns import HOLDS
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.progress import bar
from stayput.scenario.fields import between, checked, refuse_same_names
from stayput.scenario.origin import FromFile, Gravity, Title
from stayput.scenario.pieces import (
    NOTHING,
    AssemblyOption,
    AssemblyUncertaintyTable,
    JointTable,
    OptionTable,
    StandingTable,
    in_place,
)
from stayput.scenario.shaking import ShakingTable
from stayput.scenario.tables import RoomTable
from stayput.simulation.case import simulate
from stayput.simulation.outcome import QUANTITIES, fill_columns
from stayput.simulation.space import results_of, trace_assembly
from stayput.simulation.space_engine import SpaceShaking
from stayput.simulation.standing import MOST_BODIES, Assembly, Piece, Standing, friction_between

if TYPE_CHECKING:
    from collections.abc import Generator
    from os import PathLike

    import xarray as xr
    from numpy.typing import NDArray

    from stayput.model.room import Room
    from stayput.model.solid import Solid
    from stayput.simulation.run import Run
    from stayput.simulation.standing import Joint


_PART = re.compile(r"([^\[\]]+)(?:\[(\d+)\])?")
"""A part of a path: a key, and which item of its list; without that, all items."""

ABOUT = {column.name: column for column in QUANTITIES}
COLUMNS = {
    name: ABOUT[name]
    for name in (
        *("outcome", "overturned", "overturn_time", "peak_slide", "residual_slide"),
        *("peak_tilt", "residual_tilt", "floor_impacts", "wall_impacts"),
    )
}
"""Results of each piece."""


class AssemblyScenario(FromFile):
    """Several pieces on, beside or joined to one another, and how they are shaken: in space.

    Make one with `read_assembly` or `AssemblyScenario.parse`.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.read_assembly("examples/television.toml")
    >>> print(scenario.title, *zip(scenario.names, [str(piece.outcome) for piece in scenario.run().pieces]))
    Television on a stand ('stand', 'rocked') ('television', 'rocked')
    """

    title: Title = None
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
    gravity: Gravity = STANDARD_GRAVITY
    option_tables: Annotated[list[OptionTable], Field(min_length=1, max_length=100)] | None = Field(
        default=None, alias="options", description="What a verification compares; by default the usual."
    )
    uncertainty: AssemblyUncertaintyTable = Field(
        default_factory=AssemblyUncertaintyTable, description="How much of what is not known is tried out."
    )

    @model_validator(mode="after")
    def _named_apart(self) -> Self:
        names = self.names
        refuse_same_names("furniture", names)
        for number, piece in enumerate(self.furniture):
            if piece.on is not None and piece.on not in names[:number]:
                raise InputError("scenario.stands_on", f"furniture[{number}].on", value=repr(piece.on))
        try:
            friction_between((self.static_friction, self.kinetic_friction))
        except InputError as error:
            raise error.about("kinetic_friction") from None
        for number, joint in enumerate(self.joints):
            for key in ("first", "second"):
                if getattr(joint, key) not in names:
                    name = f"joints[{number}].{key}"
                    value = repr(getattr(joint, key))
                    raise InputError("scenario.no_such_piece", name, value=value)
        self._joints()
        self._check_options()
        return self

    def _check_options(self) -> None:
        names, options = self.names, self.option_tables or []
        taken = {NOTHING: phrase("scenario.option_of_nothing")}
        refuse_same_names("options", [option.name for option in options], taken)
        for number, option in enumerate(options):
            for place, piece in enumerate(option.pieces):
                name = f"options[{number}].pieces[{place}].name"
                if piece.name not in names:
                    raise InputError("scenario.no_such_piece", name, value=repr(piece.name))
                if not self.furniture[names.index(piece.name)].is_furniture:
                    raise InputError("scenario.measures_on_solid", name, name=piece.name)
            for name in names:
                checked(f"options[{number}]", partial(refuse_conflicts, option.on(name)))

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
                table.name, table.joined and bool(self.joints), tuple(table.on(name) for name in self.names)
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
        with self.naming_pieces():
            each = zip(self.furniture, self._placed(), chosen.measures, strict=True)
            members = [
                Piece(piece.body(), at, faces, measures) if piece.is_furniture else Standing(solid, at, faces)
                for piece, (solid, at, faces), measures in each
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
            raise InputError(
                "rooms.against_without_plan",
                f"furniture[{self.names.index(piece.name)}].against",
                value=repr(piece.against),
            )
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

    def surroundings(self) -> Room:
        """Make the room; the gaps of its walls are from the outermost of all pieces."""
        return self.room.room()

    def run(self) -> Run:
        """Simulate the pieces as the file states them."""
        assembly, motion = self.assembly(), self.motion()
        with self.naming_pieces():
            run = simulate(assembly, self.surroundings(), motion, gravity=self.gravity)
        return run.named(self.names)

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
        import xarray as xr

        instance_of("axes", axes, Mapping)
        lists = {path: list_of(path, values) for path, values in axes.items()}
        for path, values in lists.items():
            if not values:
                raise InputError("simulation.no_values", path, path=path)
        stated = self.stated_keys()
        cases = [
            _changed(self, stated, dict(zip(lists, values, strict=True)))
            for values in product(*lists.values())
        ]
        results = np.zeros((len(cases), len(self.names)), RESULT)
        devices = {
            "device_failures": np.zeros(len(cases), np.int32),
            "device_utilisation": np.zeros(len(cases)),
        }

        def run(number: int) -> None:
            results[number], *of_devices = _run(cases[number])
            for values, value in zip(devices.values(), of_devices, strict=True):
                values[number] = value

        with bar(len(cases), "progress.simulating", progress) as advance, Pool(threads) as pool:
            for _ in pool.as_completed(partial(run, number) for number in range(len(cases))):
                advance(1)
        pieces = {name: np.zeros(results.size, about.dtype) for name, about in COLUMNS.items()}
        fill_columns(pieces, 0, results.ravel())
        data = xr.Dataset(
            coords={**{path: [*values] for path, values in lists.items()}, "piece": [*self.names]}
        )
        shape = tuple(map(len, lists.values()))
        for name, values in {**pieces, **devices}.items():
            dims = (*lists, "piece") if name in pieces else tuple(lists)
            data[name] = (dims, values.reshape(*shape, *(-1,) * (name in pieces)), ABOUT[name].attributes)
        return data


def _changed(scenario: AssemblyScenario, stated: dict[str, Any], values: dict[str, Any]) -> AssemblyScenario:
    """Return a scenario with other values at paths."""
    data = stated
    for path, value in values.items():
        data = _with(data, path.split("."), value, path)
    return type(scenario).parse(data, scenario.folder)


def _with(node: Any, parts: list[str], value: Any, path: str) -> Any:
    """Return a node with another value at a path below it; the node itself stays as it is."""
    if not parts:
        return value
    found = _PART.fullmatch(parts[0])
    if found is None or not isinstance(node, dict):
        raise InputError("scenario.no_such_path", path, path=path)
    table, (key, place) = cast("dict[str, Any]", node), found.groups()
    below: Any = table.get(key, {} if len(parts) > 1 else None)
    if isinstance(below, list) and (place is not None or len(parts) > 1):
        items = cast("list[Any]", below)
        if place is not None and int(place) >= len(items):
            raise InputError("scenario.no_such_path", path, path=path)
        chosen = range(len(items)) if place is None else (int(place),)
        return {
            **table,
            key: [
                _with(item, parts[1:], value, path) if number in chosen else item
                for number, item in enumerate(items)
            ],
        }
    return {**table, key: _with(below, parts[1:], value, path)}


def _run(scenario: AssemblyScenario) -> tuple[NDArray[np.void], int, float]:
    """Return what became of each piece, how many devices failed, and the largest utilisation."""
    motion = scenario.motion()
    shaking = SpaceShaking.of(motion)
    assembly = scenario.assembly()
    with scenario.naming_pieces():
        traced = trace_assembly(assembly, scenario.surroundings(), shaking, scenario.gravity)
    devices = traced.trace.devices
    failed = int((devices["failure"] != HOLDS).sum())
    results = results_of(traced, shaking.times)
    return results, failed, float(utilisation(traced.trace.springs, devices).max(initial=0.0))


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
    return AssemblyScenario.read(path)

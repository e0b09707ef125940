"""`Scenario`: the content of a file as a value, and the case, the scene and the run that it makes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property, partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self, cast

from pydantic import Field, PrivateAttr, model_validator

from stayput.catalogue import phrase, say
from stayput.contents.contents import Contents, emptied
from stayput.errors import InputError, instance_of, no_length, not_allowed, refuse_same_names, word_of
from stayput.measures.measure import refuse_conflicts
from stayput.motion.suites.suite import Suite
from stayput.scenario.fields import between, checked
from stayput.scenario.measures import AS_STATED, NOTHING, MeasureChoice, Option, UncertaintyTable
from stayput.scenario.pieces import OptionTable  # noqa: TC001 - pydantic reads the annotations
from stayput.scenario.scene import SceneTables
from stayput.scenario.shaking import ShakingTable
from stayput.scenario.tables import ContentsTable, EverydayTable, Heading, InitialTable
from stayput.scenario.toml import read_toml
from stayput.simulation.case import Case, needs_space, simulate
from stayput.uncertainty import QUANTITIES, Uncertainty

if TYPE_CHECKING:
    from stayput.measures import Measure
    from stayput.motion.record import Motion
    from stayput.simulation.run import Dimensions, Run

OF_A_LONE_PIECE = ("initial", "everyday", "measures", "contents")
"""Keys of a piece that stands alone."""

ACROSS = 1e-6
"""Sine of the angle up to which a motion is along the depth of a piece: rounding."""

OF_PIECES = ("joints", "static_friction", "kinetic_friction", "options")
"""Keys of several pieces."""


class Scenario(SceneTables):
    """What stands where, how it is shaken and what is compared: the content of a scenario file.

    Make one with `stayput.read` or `Scenario.parse`; both refuse what is wrong with one sentence.

    Examples
    --------
    >>> import stayput as sp
    >>> tables = {"furniture": {"preset": "bookcase"}, "room": {"left_wall": {"gap": 0.02}}}
    >>> for scale in (0.2, 1.0):
    ...     shaking = {"builtin": "near-fault", "scale": scale}
    ...     print(scale, sp.Scenario.parse({**tables, "shaking": shaking}).run().outcome)
    0.2 rested
    1.0 overturned

    Several pieces, and a room with a plan:

    >>> scenario = sp.read("examples/television.toml")
    >>> run = scenario.run()
    >>> print(scenario.title, *((piece, str(run[piece].outcome)) for piece in run.names))
    Television on a stand ('stand', 'rocked') ('television', 'rocked')
    >>> plan = sp.read("examples/bedroom.toml").scene().plan
    >>> plan.width, plan.length, [place.name for place in plan.places]  # m
    (3.6, 2.7, ['bed'])
    """

    shaking: ShakingTable = Field(default_factory=ShakingTable, description="How the floor is shaken.")
    direction: Heading | None = Field(
        default=None,
        description="Where the motion's x points in plan, from x towards y; a verification draws it by "
        "default, but of one horizontal component without a plan.",
    )
    stated_dimensions: Annotated[int, between(2, 3)] | None = Field(
        default=None,
        alias="dimensions",
        description="2: a lone piece in the plane of its depth, under the component along it, by default "
        "where it has no length, or nothing holds it or shakes it across; 3: in space, under all components, "
        "as several pieces always are.",
    )
    initial: InitialTable = Field(default_factory=InitialTable, description="The initial state.")
    everyday: EverydayTable = Field(
        default_factory=EverydayTable, description="What people do to it without an earthquake."
    )
    measure_tables: Annotated[list[MeasureChoice], Field(min_length=1, max_length=100)] | None = Field(
        default=None, alias="measures", description="What may hold the furniture; each is verified by itself."
    )
    option_tables: Annotated[list[OptionTable], Field(min_length=1, max_length=100)] | None = Field(
        default=None, alias="options", description="What a verification compares; by default the usual."
    )
    contents_table: ContentsTable | None = Field(
        default=None,
        alias="contents",
        description="What is in the furniture: a verification then tells how much of it comes out.",
    )
    uncertainty: UncertaintyTable = Field(
        default_factory=UncertaintyTable, description="How much of what is not known is tried out."
    )

    @model_validator(mode="after")
    def _possible(self) -> Self:
        for name, field in Scenario.model_fields.items():
            key = field.alias or name
            if key in (OF_PIECES if self.alone else OF_A_LONE_PIECE) and self.says(name):
                where = phrase("scenario.of_pieces" if self.alone else "scenario.of_a_lone_piece")
                raise InputError("common.left_out", key, where=where)
        if self.alone:
            self._check_lone_piece()
        else:
            self._check_pieces()
        self._refuse_same_names(self.options, "measures" if self.alone else "options")
        return self

    def _refuse_same_names(self, options: Sequence[Option], key: str = "measures") -> None:
        taken = {NOTHING: phrase("scenario.option_of_nothing")}
        if any(self.stated.on):
            taken[AS_STATED] = phrase("scenario.option_as_stated")
        refuse_same_names(key, [option.name for option in options], taken)

    def _check_lone_piece(self) -> None:
        for key in filter(self.piece.says, ("at", "along", "gap")):
            raise InputError("common.left_out", f"furniture.{key}", where=phrase("scenario.of_pieces"))
        if self.stated_dimensions == 2:
            self.room.room().refuse_side_walls()
        elif self.piece.body().length is None and (self.stated_dimensions or self.room.room().has_side_walls):
            raise no_length("furniture.length")
        if self.contents is not None:
            emptied(self.piece.body(), self.contents)

    def _check_pieces(self) -> None:
        if self.stated_dimensions == 2:
            raise not_allowed("dimensions", "2", "scenario.pieces_in_the_plane", "dimensions")
        names = self.names
        for number, option in enumerate(self.option_tables or []):
            key = f"options[{number}].measures"
            for piece in option.measures:
                if not self.pieces[names.index(word_of(key, piece, names, key))].is_furniture:
                    where = phrase("scenario.of_a_solid")
                    raise InputError("common.left_out", f"{key}.{piece}", where=where)
            for piece in self.pieces:
                checked(f"options[{number}]", partial(refuse_conflicts, option.on(piece)))

    @property
    def dimensions(self) -> int:
        """2 where a lone piece is run in the plane, 3 in space: as stated, or as it moves.

        Raises
        ------
        InputError
            A record cannot be read.
        """
        if self.stated_dimensions is not None or not self.alone:
            return self.stated_dimensions or 3
        body = self.piece.body()
        across = body.length is not None and self.shakes_across
        in_python = self._own_options
        options = (self.stated, *(in_python or ()))
        held = in_python is None or any(each.measures for each in options)  # by default the usual ones
        return 3 if needs_space(body, self.room.room(), across=across, held=held) else 2

    @cached_property
    def ground_components(self) -> frozenset[str]:
        """Components that any of the motions of the ground has: of "x", "y", "z"."""
        with self.naming_file("shaking"):
            motions = self.shaking.ground(self._folder, first=1)  # all synthetic ones have the same
        return frozenset(name for motion in motions for name in motion.components)

    @property
    def has_two_components(self) -> bool:
        """Whether any of the motions of the ground has two horizontal components."""
        return "y" in self.ground_components

    @property
    def components(self) -> tuple[str, ...]:
        """Components of the motions that act in a verification: some of "x", "y", "z"."""
        acts = {"x": True, "y": self.dimensions == 3, "z": bool(self.shaking.vertical)}
        return tuple(name for name in acts if acts[name] and name in self.ground_components)

    @property
    def shakes_across(self) -> bool:
        """Whether the floor shakes a lone piece along its length too."""
        turned = (self.direction or 0.0) - self.facing
        return self.has_two_components or abs(math.sin(turned)) > ACROSS

    @property
    def points(self) -> float | None:
        """Where the motions' x points in plan [rad]; None where a verification draws it.

        One component alone acts along x, where nothing else is stated and there is no plan.
        """
        drawn = self.plan is not None or self.has_two_components
        return None if self.direction is None and drawn else self.direction or 0.0

    @property
    def samples(self) -> int:
        """Most samples of each set of measures, or runs of a room."""
        if self.uncertainty.samples is not None:
            return self.uncertainty.samples
        in_plane = self.alone and self.dimensions == 2
        return 400 if in_plane or self.uncertainty.precision is not None else 60

    def to_toml(self) -> str:
        """Return the scenario as a file's text; what was given in Python is named in a comment."""
        what = ", ".join(key for key, value in self.in_python.items() if value is not None)
        comment = f"# {say('scenario.in_python', what=what)}\n" if what else ""
        return super().to_toml() + comment

    _own_options: tuple[Option, ...] | None = PrivateAttr(default=None)

    @property
    def in_python(self) -> dict[str, Any]:
        """What was given as Python objects and a file does not say; None each where it was not."""
        quantities, stated = self.uncertainty.quantities, self.uncertainty.as_stated
        pieces = [piece.in_python for piece in self.pieces]
        drawn = {name: marginal for name, marginal in quantities.marginals.items() if name not in stated}
        return {
            "motions": self.shaking.in_python,
            "building": self.shaking.building and self.shaking.building.in_python,
            "pieces": pieces if any(pieces) else None,
            "measures": self._own_options,
            "quantities": None if quantities is QUANTITIES else Uncertainty(drawn),
        }

    def with_python(
        self,
        motions: Suite | None = None,
        measures: Sequence[Option] | None = None,
        quantities: Uncertainty | None = None,
        pieces: Sequence[Mapping[str, Any]] | None = None,
    ) -> Self:
        """Return the same with Python objects in the place of its own tables, where they are given.

        ``pieces``: of each the fields of a `Piece` that a file cannot state.

        Raises
        ------
        InputError
            Two measures of one name, or a quantity that there is not.
        """
        changed: dict[str, Any] = {}
        if motions is not None:
            changed["shaking"] = self.shaking.with_python(motions)
        if quantities is not None:
            changed["uncertainty"] = self.uncertainty.with_quantities(quantities)
        if pieces is not None:
            tables = [table.with_python(fields) for table, fields in zip(self.pieces, pieces, strict=True)]
            changed["furniture"] = tables if isinstance(self.furniture, list) else tables[0]
        copy = self.model_copy(update=changed)
        vars(copy).pop("ground_components", None)  # which a copy takes along
        if measures is not None:
            copy._refuse_same_names(measures)
            copy._own_options = tuple(measures)
        return copy

    def kept(self) -> dict[str, Any]:
        """Return what a file of a result holds of the scenario, with what was given in Python."""
        of_file = {"data": self.stated_keys(), "folder": self._folder.resolve(), "file": self._file}
        return of_file | self.in_python

    @classmethod
    def of_kept(cls, parts: Mapping[str, Any]) -> Scenario:
        """Make a scenario of what `kept` returned."""
        data = parts["data"]
        if parts.get("building") is not None:
            data = {**data, "shaking": {**data["shaking"], "building": parts["building"]}}
        scenario = cls.parse(data, parts["folder"], parts["file"])
        names = ("motions", "measures", "quantities", "pieces")
        return scenario.with_python(**{name: parts.get(name) for name in names})

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self).of_kept, (self.kept(),)  # the tables of measures are made by a function

    @property
    def contents(self) -> Contents | None:
        """What is in the furniture; None where the file says nothing."""
        table = self.contents_table
        return None if table is None else table.contents(self.piece.shelves)

    @property
    def options(self) -> tuple[Option, ...]:
        """What a verification compares, each under its name; empty where the file says nothing."""
        if self._own_options is not None:
            return self._own_options
        of_a_piece = (Option(table.title, (table.measures(),)) for table in self.measure_tables or ())
        of_several = (
            Option(table.name, tuple(map(table.on, self.pieces)), table.joined and bool(self.joints))
            for table in self.option_tables or ()
        )
        return *of_a_piece, *of_several

    def motion(self) -> Motion:
        """Make the motion of the floor: of a suite, that of its ``member``.

        It is along the axes of a lone piece, or turned to its direction in plan.

        Raises
        ------
        InputError
            The record cannot be read, or the suite has no such member.
        """
        with self.naming_file("shaking"):
            return self.shaking.motion(self._folder).pointing((self.direction or 0.0) - self.facing)

    def ground(self, first: int | None = None) -> Suite:
        """Make the motions of the ground, not scaled, with all components.

        In the plane they are along the axes of the piece; in space they are turned as they are drawn. Where
        the ``first`` so many are asked for, of a synthetic suite only these are made.

        Raises
        ------
        InputError
            A record cannot be read.
        """
        with self.naming_file("shaking"):
            ground = self.shaking.ground(self._folder, first)
        if self.dimensions == 3:
            return ground
        turned = (self.direction or 0.0) - self.facing
        return Suite(tuple(motion.pointing(turned) for motion in ground), ground.name)

    @property
    def facing(self) -> float:
        """Where the axes point along which what stands is run [rad]: those of a lone piece, or the plan's."""
        return self.piece.heading if self.alone else 0.0

    def case(self, measures: Sequence[Measure] | None = None) -> Case:
        """Make the case of a lone piece: body, room, motion, initial state and gravity.

        Parameters
        ----------
        measures : sequence of Measure, optional
            What is in place; by default what the piece itself states. Those that are compared are not.

        Raises
        ------
        InputError
            The record cannot be read, or there are several pieces.
        """
        if not self.alone:
            raise InputError("scenario.of_several", "furniture")
        return Case(
            self.piece.body(),
            self.room.room(),
            self.motion(),
            initial=self.initial.state(),
            gravity=self.gravity,
            measures=self.piece.own_measures if measures is None else tuple(measures),
            dimensions=cast("Dimensions | None", self.stated_dimensions),
        )

    def run(self, measures: Sequence[Measure] | None = None) -> Run:
        """Simulate what stands, as the file states it.

        Parameters
        ----------
        measures : sequence of Measure, optional
            What is in place on a lone piece; by default what it states itself.

        Raises
        ------
        InputError
            Measures beside several pieces, whose own say what holds them; what cannot be simulated.
        """
        if measures and not self.alone:
            raise InputError("common.left_out", "measures", where=phrase("scenario.of_a_lone_piece"))
        if self.alone:
            with self.naming_file():
                return self.case(measures).run().named(self.names)
        scene, motion = self.scene(), self.motion()
        with self.naming_keys():
            return simulate(scene, motion, gravity=self.gravity)


def read(path: str | Path) -> Scenario:
    """Read a scenario file: of one piece, of several, or of a room with a plan.

    Parameters
    ----------
    path : str or Path
        The file, in TOML.

    Raises
    ------
    InputError
        The file cannot be read, is not TOML, or says something that is not allowed.

    Examples
    --------
    >>> import stayput as sp
    >>> scenario = sp.read("examples/verify.toml")
    >>> [option.name for option in scenario.options]
    ['felt_glides', 'belt', 'l_bracket', 'stopper and poles']
    >>> print(scenario.run().outcome)
    overturned
    """
    instance_of("path", path, (str, PathLike))
    file = Path(path)
    try:
        return Scenario.parse(read_toml(file), file.parent, file.name)
    except InputError as error:
        raise error.at(file.name) from None

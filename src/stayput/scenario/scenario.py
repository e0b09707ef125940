"""`Scenario`: the whole file as a value, the case it makes, and `read_scenario`."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import Field, PrivateAttr, model_validator

from stayput.catalogue import phrase, say
from stayput.contents.contents import emptied
from stayput.errors import InputError
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.scenario.fields import between, refuse_same_names
from stayput.scenario.measures import MeasureChoice, NamedMeasures, UncertaintyTable, of_known_type
from stayput.scenario.origin import FromFile, Gravity, Title
from stayput.scenario.pieces import NOTHING
from stayput.scenario.shaking import ShakingTable
from stayput.scenario.tables import ContentsTable, EverydayTable, FurnitureTable, InitialTable, RoomTable
from stayput.simulation.case import Case
from stayput.uncertainty import QUANTITIES, Uncertainty

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.contents import Contents
    from stayput.measures import Measure
    from stayput.motion import Motion
    from stayput.motion.suites import Suite


class Scenario(FromFile):
    """What stands where, and how it is shaken: the content of a scenario file.

    Make one with `read_scenario` or `Scenario.parse`; both refuse what is wrong with one sentence.

    Examples
    --------
    >>> import stayput as sp
    >>> tables = {"furniture": {"preset": "bookcase"}, "room": {"back_wall": {"gap": 0.02}}}
    >>> for scale in (0.2, 1.0):
    ...     shaking = {"builtin": "near-fault", "scale": scale}
    ...     print(scale, sp.Scenario.parse({**tables, "shaking": shaking}).case().run().outcome)
    0.2 rested
    1.0 overturned
    """

    title: Title = None
    furniture: FurnitureTable = Field(description="What stands.")
    room: RoomTable = Field(default_factory=RoomTable, description="Where it stands.")
    shaking: ShakingTable = Field(default_factory=ShakingTable, description="How the floor is shaken.")
    dimensions: Annotated[int, between(2, 3)] = Field(
        default=2,
        description="2: in the plane of the piece's depth, under the component along it; 3: in space, under "
        "all components.",
    )
    gravity: Gravity = STANDARD_GRAVITY
    initial: InitialTable = Field(default_factory=InitialTable, description="The initial state.")
    everyday: EverydayTable = Field(
        default_factory=EverydayTable, description="What people do to it without an earthquake."
    )
    measure_tables: Annotated[
        Annotated[list[MeasureChoice], Field(min_length=1, max_length=100)] | None, of_known_type()
    ] = Field(
        default=None, alias="measures", description="What may hold the furniture; each is verified by itself."
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
    def _possible_in_space(self) -> Self:
        if self.dimensions == 2:
            self.room.room().refuse_side_walls()
        elif self.furniture.body().length is None:
            raise InputError("scenario.no_length", "furniture.length", other="dimensions")
        return self

    @model_validator(mode="after")
    def _possible(self) -> Self:
        if self.contents is not None:
            emptied(self.furniture.body(), self.contents)
        _refuse_same_names(self.measures)
        return self

    @classmethod
    def parse(cls, data: Mapping[str, Any], folder: Path = Path(), file: str = "") -> Self:
        """Make a scenario from the keys and values of its file; see `FromFile.parse`."""
        if isinstance(data.get("furniture"), list):
            raise InputError("scenario.of_several", "furniture")
        return super().parse(data, folder, file)

    def to_toml(self) -> str:
        """Return the scenario as a file's text; what was given in Python is named in a comment."""
        what = ", ".join(key for key, value in self.in_python.items() if value is not None)
        comment = f"# {say('scenario.in_python', what=what)}\n" if what else ""
        return super().to_toml() + comment

    _own_measures: tuple[NamedMeasures, ...] | None = PrivateAttr(default=None)

    @property
    def in_python(self) -> dict[str, Any]:
        """What was given as Python objects and a file does not say; None each where it was not."""
        quantities, stated = self.uncertainty.quantities, self.uncertainty.as_stated
        drawn = {name: one for name, one in quantities.marginals.items() if name not in stated}
        return {
            "motions": self.shaking.in_python,
            "building": self.shaking.building and self.shaking.building.in_python,
            "measures": self._own_measures,
            "quantities": None if quantities is QUANTITIES else Uncertainty(drawn),
        }

    def with_python(
        self,
        motions: Suite | None = None,
        measures: Sequence[NamedMeasures] | None = None,
        quantities: Uncertainty | None = None,
    ) -> Self:
        """Return the same with Python objects in the place of its own tables, where they are given.

        Raises
        ------
        InputError
            Two measures of one name, or a quantity that there is not.
        """
        changed: dict[str, Any] = {}
        if motions is not None:
            changed["shaking"] = self.shaking.with_motions(motions)
        if quantities is not None:
            changed["uncertainty"] = self.uncertainty.with_quantities(quantities)
        copy = self.model_copy(update=changed)
        if measures is not None:
            _refuse_same_names(measures)
            copy._own_measures = tuple(measures)
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
        return scenario.with_python(parts["motions"], parts["measures"], parts["quantities"])

    @property
    def contents(self) -> Contents | None:
        """What is in the furniture; None where the file says nothing."""
        table = self.contents_table
        return None if table is None else table.contents(self.furniture)

    @property
    def measures(self) -> tuple[NamedMeasures, ...]:
        """What may hold the furniture, each under its name; empty where the file says nothing."""
        if self._own_measures is not None:
            return self._own_measures
        return tuple(NamedMeasures(one.title, one.measures()) for one in self.measure_tables or ())

    @property
    def without_measures(self) -> bool:
        """Whether it was said in Python that no measures are compared, the usual ones neither."""
        return self._own_measures == ()

    def case(self, measures: Sequence[Measure] = ()) -> Case:
        """Make the case: body, room, motion, initial state and gravity.

        Parameters
        ----------
        measures : sequence of Measure
            What is in place; those of the file are not, unless they are given here.

        Raises
        ------
        InputError
            The record cannot be read.
        """
        return Case(
            self.furniture.body(),
            self.room.room(),
            self.motion(),
            initial=self.initial.state(),
            gravity=self.gravity,
            measures=tuple(measures),
            dimensions=3 if self.dimensions == 3 else 2,
        )

    def _turned(self, motion: Motion) -> Motion:
        """Return a motion as the piece feels it: its depth along x, wherever it faces."""
        heading = self.furniture.heading
        if heading == 0.0:
            return motion
        both = motion if motion.y is not None else replace(motion, y=0.0 * motion.x)
        return both.rotated(heading)


def _refuse_same_names(measures: Sequence[NamedMeasures]) -> None:
    taken = {NOTHING: phrase("scenario.option_of_nothing")}
    refuse_same_names("measures", [one.name for one in measures], taken)


def read_scenario(path: str | Path) -> Scenario:
    """Read a scenario file.

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
    >>> scenario = sp.read_scenario("examples/verify.toml")
    >>> for option in scenario.measures:
    ...     run = scenario.case(option.measures).run()
    ...     print(f"{option.name}: {run.outcome}")
    felt_glides: overturned
    belt: rocked
    l_bracket: rocked
    stopper and poles: rocked
    """
    return Scenario.read(path)

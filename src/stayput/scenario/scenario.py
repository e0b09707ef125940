"""`Scenario`: the whole file as a value, and the case it makes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, PrivateAttr, ValidationError
from pydantic.json_schema import DEFAULT_REF_TEMPLATE

from stayput.errors import InputError
from stayput.motion.units import STANDARD_GRAVITY
from stayput.scenario.fields import Table, Text, between
from stayput.scenario.messages import sentence_of
from stayput.scenario.shaking import ShakingTable
from stayput.scenario.tables import FurnitureTable, InitialTable, RoomTable
from stayput.simulation import Case

if TYPE_CHECKING:
    from collections.abc import Mapping


class Scenario(Table):
    """What stands where, and how it is shaken: the content of a scenario file.

    Make one with `read_scenario` or `Scenario.parse`; both refuse what is wrong with one sentence.
    """

    title: Text | None = Field(default=None, description="What the scenario is about.")
    furniture: FurnitureTable = Field(description="What stands.")
    room: RoomTable = Field(default_factory=RoomTable, description="Where it stands.")
    shaking: ShakingTable = Field(default_factory=ShakingTable, description="How the floor is shaken.")
    contact: Literal["coulomb", "paper"] = Field(
        default="coulomb", description="The contact law; see the theory page."
    )
    gravity: Annotated[float, between(0.1, 100.0, "m/s²")] = Field(
        default=STANDARD_GRAVITY, description="Acceleration of gravity."
    )
    initial: InitialTable = Field(default_factory=InitialTable, description="The initial state.")

    _folder: Path = PrivateAttr(default=Path())

    @classmethod
    def parse(cls, data: Mapping[str, Any], folder: Path = Path()) -> Scenario:
        """Make a scenario from the keys and values of its file.

        Parameters
        ----------
        data : mapping
            As a TOML reader returns it.
        folder : Path
            Where the relative path of a record begins.

        Raises
        ------
        InputError
            The first thing that is wrong: the key's dotted name, its value, and what is allowed.
        """
        try:
            scenario = cls.model_validate(dict(data))
        except ValidationError as error:
            raise InputError(sentence_of(error.errors(), cls.schema())) from None
        scenario._folder = folder
        return scenario

    @classmethod
    def schema(cls, by_alias: bool = True, ref_template: str = DEFAULT_REF_TEMPLATE) -> dict[str, Any]:
        """Return the JSON Schema of a scenario file, for editors and other programs."""
        return cls.model_json_schema(by_alias=by_alias, ref_template=ref_template)

    def case(self) -> Case:
        """Make the case: body, room, motion, contact law, initial state and gravity.

        Raises
        ------
        InputError
            The record cannot be read.
        """
        return Case(
            self.furniture.body(),
            self.room.room(),
            self.shaking.motion(self._folder),
            contact=self.contact,
            initial=self.initial.state(),
            gravity=self.gravity,
        )

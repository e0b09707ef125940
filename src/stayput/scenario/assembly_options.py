"""What may hold several pieces: the options of a file that a verification compares."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Self

from pydantic import Field, field_validator, model_validator

from stayput.errors import InputError
from stayput.measures.measure import refuse_conflicts
from stayput.scenario.fields import Table, Text, between, checked
from stayput.scenario.measures import SingleChoice, UncertaintyTable, refuse_wrong_type

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.measures import Measure

NOTHING = "none"
"""Name of the option without joints and measures, which every verification has."""

if TYPE_CHECKING:
    MeasuresInPlace = list[SingleChoice]
else:
    MeasuresInPlace = Annotated[list[SingleChoice], Field(min_length=1, max_length=20)]
"""Measures that are in place together."""


@dataclass(frozen=True, slots=True)
class AssemblyOption:
    """What may hold several pieces: their joints, and measures on each.

    Parameters
    ----------
    name : str
        What it is called; unique.
    joined : bool
        Whether the joints are in place.
    measures : tuple of tuple of Measure
        Of each piece.
    """

    name: str
    joined: bool
    measures: tuple[tuple[Measure, ...], ...]

    @property
    def count(self) -> int:
        """How many things are put in place: measures, and the joints together."""
        return sum(map(len, self.measures)) + self.joined


class HeldPieceTable(Table):
    """Measures on one of the pieces."""

    name: Text = Field(description="The piece.")
    measures: MeasuresInPlace = Field(description="The measures on it, each a table with its type.")

    @field_validator("measures", mode="before")
    @classmethod
    def _typed(cls, given: object) -> object:
        refuse_wrong_type(given, "options.pieces.measures", nested=True)
        return given

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("options.pieces", lambda: refuse_conflicts(in_place(self.measures)))
        return self


class OptionTable(Table):
    """One way to hold the pieces, which a verification compares with the others."""

    name: Text = Field(description="What it is called.")
    joined: bool = Field(default=True, description="Whether the joints of the file are in place.")
    pieces: Annotated[list[HeldPieceTable], Field(min_length=0, max_length=100)] = Field(
        default=[], description="The pieces that measures hold."
    )

    def on(self, name: str) -> tuple[Measure, ...]:
        """Make the measures on a piece."""
        return tuple(one for held in self.pieces if held.name == name for one in in_place(held.measures))


class AssemblyUncertaintyTable(UncertaintyTable):
    """How much of what is not known is tried out; runs of several pieces take long."""

    samples: Annotated[int, between(1, 1_000_000)] = Field(
        default=20, description="Most samples of each option."
    )

    @model_validator(mode="after")
    def _well_installed(self) -> Self:
        if self.badly(1.0) > 0.0:
            raise InputError("scenario.installed_well", "uncertainty.installation")
        return self


def in_place(tables: Sequence[SingleChoice] | None) -> tuple[Measure, ...]:
    """Make the measures that are in place together."""
    return tuple(one.measure() for one in tables or ())

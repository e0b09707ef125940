"""What may hold the pieces of a scene: `Option`, and the tables of a scenario that say it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, Self, cast

from pydantic import BaseModel, Discriminator, Field, PrivateAttr, Tag, create_model, model_validator

from stayput.catalogue import Phrase, phrase
from stayput.errors import unknown
from stayput.measures import MEASURES, BadlyInstalled, Measure, parameters
from stayput.measures.measure import refuse_conflicts
from stayput.scenario.fields import (
    NAME,
    NUMBER,
    Table,
    Text,
    between,
    checked,
    name_or_number,
    named,
    one_of,
    typed_field,
)
from stayput.uncertainty import QUANTITIES, USUAL, Uncertainty
from stayput.wording import joined

if TYPE_CHECKING:
    from stayput.model.room import Room


NOTHING, AS_STATED = "none", "as stated"
"""Names of the option with nothing in place, which every verification has, and of what a file states."""

YOURS = "yours"
"""Name of the set that is put together on the app's page; the user has not chosen it."""


class Moved(NamedTuple):
    """What stands elsewhere with an option.

    Parameters
    ----------
    what : str
        The piece, or the place of a person.
    at : tuple of float
        Its middle in plan [m].
    heading : float
        What it faces there [rad].
    """

    what: str
    at: tuple[float, float]
    heading: float


@dataclass(frozen=True, slots=True)
class Option:
    """What may hold the pieces of a scene: measures on each, and their joints; and what stands elsewhere.

    Parameters
    ----------
    name : str
        What it is called; unique.
    on : tuple of tuple of Measure
        The measures on each piece; none of the option with nothing in place.
    joined : bool
        Whether the joints are in place.
    moved : tuple of Moved
        What stands elsewhere than as the scenario states it.
    """

    name: str
    on: tuple[tuple[Measure, ...], ...] = ((),)
    joined: bool = False
    moved: tuple[Moved, ...] = ()

    @property
    def measures(self) -> tuple[Measure, ...]:
        """The measures on all pieces."""
        return tuple(measure for measures in self.on for measure in measures)

    @property
    def count(self) -> int:
        """How many things are put in place or moved: measures, the joints together, pieces and places."""
        return len(self.measures) + self.joined + len(self.moved)

    @property
    def generated_name(self) -> str:
        """Its name where the user gives none: what is in place, by the types of a scenario file."""
        kinds = dict.fromkeys(measure.kind for measure in self.measures)
        if len(self.on) == 1:
            kinds = [measure.kind for measure in self.measures]
        return " + ".join([*["joined"] * self.joined, *kinds]) or NOTHING

    @property
    def own_name(self) -> bool:
        """Whether the name is the user's own, and not made of what is in place."""
        usual = self.generated_name
        return self.name not in (usual, usual.replace(" + ", "+"), YOURS, AS_STATED)

    def badly_installed(self, room: Room) -> tuple[Self, tuple[BadlyInstalled, ...]] | None:
        """Return the measures as one installs them who does it badly, and what is wrong; None if nothing is.

        All that can be badly installed is, since the same person does it.
        """
        wrong: list[BadlyInstalled] = []

        def installed(measure: Measure) -> Measure:
            bad = measure.badly_installed(room)
            if bad is None:
                return measure
            wrong.append(bad)
            return bad.measure

        on = tuple(tuple(installed(measure) for measure in measures) for measures in self.on)
        return (replace(self, on=on), tuple(wrong)) if wrong else None

    def label(self, names: Sequence[str] = ()) -> Phrase:
        """Return what it consists of: "Joints + Belts on upper part"; no "on" of one piece."""
        if not self.count:
            return phrase("common.without" if len(self.on) == 1 else "several.nothing")
        held: dict[Phrase, list[str]] = {}
        named = names if len(self.on) > 1 else ()
        for number, measures in enumerate(self.on):
            for measure in measures:
                held.setdefault(measure.label, []).extend(named[number : number + 1])
        parts = [phrase("several.joined")] if self.joined else []
        for what, on in held.items():
            pieces = " and ".join(on), "と".join(on)
            parts.append(phrase("several.on", measure=what, pieces=pieces) if on else what)
        label = joined(parts, "action_plan.plus")
        return phrase("several.as_stated", what=label) if self.name == AS_STATED else label


COMBINE = "combine"


class MeasureTable(Table):
    """One measure with its parameters."""

    name: Text | None = Field(default=None, description="What it is called; default its type.")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("measures", self.measure)
        return self

    @property
    def title(self) -> str:
        """What it is called."""
        return self.name or self.type_name

    @property
    def type_name(self) -> str:
        """The kind of measure."""
        return str(self.__dict__["type"])

    def measure(self) -> Measure:
        """Make the measure."""
        return MEASURES[self.type_name](**self.model_dump(exclude={"name", "type"}))

    def measures(self) -> tuple[Measure, ...]:
        """Make what is in place together: one measure."""
        return (self.measure(),)


def _table_of(kind: str, measure: type[Measure]) -> type[MeasureTable]:
    """Return the table of one kind of measure."""
    fields: dict[str, Any] = {"type": (Literal[kind], Field(description=measure.label[0] + "."))}
    for about in parameters(measure):
        text = about.label[0]
        words = f"{text[0].upper()}{text[1:]} (default, {about.confidence} confidence)."
        fields[about.name] = typed_field(about, words)
    name = f"{measure.__name__}Table"
    return create_model(name, __base__=MeasureTable, __doc__=measure.about[0], **fields)


TABLES: dict[str, type[MeasureTable]] = {kind: _table_of(kind, measure) for kind, measure in MEASURES.items()}
"""The table of each kind of measure."""


def table_of(measure: Measure) -> dict[str, Any]:
    """Return a measure as a table of a scenario: its type, and parameters that differ from their defaults."""
    usual = MEASURES[measure.kind]()
    names = measure.__dataclass_fields__
    changed = {n: getattr(measure, n) for n in names if getattr(measure, n) != getattr(usual, n)}
    return {"type": measure.kind, **changed}


def _type_of(value: object) -> str | None:
    """Return the tag of a measure's table; None of what is no table."""
    table = value.__dict__ if isinstance(value, BaseModel) else value
    return f"<{cast('dict[str, Any]', table).get('type')}>" if isinstance(table, dict) else None


def _type_or_combined(value: object) -> str | None:
    """Return the tag of the table of a measure, or of several together."""
    keys: Any = value.__dict__ if isinstance(value, BaseModel) else value
    return f"<{COMBINE}>" if isinstance(keys, dict) and COMBINE in keys else _type_of(value)


_TAGGED: list[Any] = [Annotated[table, Tag(f"<{kind}>")] for kind, table in TABLES.items()]

if TYPE_CHECKING:
    SingleChoice = MeasureTable
else:
    SingleChoice = Annotated[reduce(lambda a, b: a | b, _TAGGED), Discriminator(_type_of)]


class CombinedTable(Table):
    """Several measures together."""

    name: Text | None = Field(default=None, description="What they are called; default their types.")
    combine: Annotated[list[SingleChoice], Field(min_length=1, max_length=20)] = Field(
        description="The measures, each a table with its type."
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("measures", lambda: refuse_conflicts(self.measures()))
        return self

    @property
    def title(self) -> str:
        """What they are called."""
        return self.name or " + ".join(table.type_name for table in self.combine)

    def measures(self) -> tuple[Measure, ...]:
        """Make what is in place together."""
        return tuple(table.measure() for table in self.combine)


if TYPE_CHECKING:
    MeasureChoice = MeasureTable | CombinedTable
else:
    _COMBINED = Annotated[CombinedTable, Tag(f"<{COMBINE}>")]
    MeasureChoice = Annotated[
        reduce(lambda a, b: a | b, _TAGGED, _COMBINED), Discriminator(_type_or_combined)
    ]
"""A measure, or several together."""


WELL, USUALLY = "well", "as people install it"

Installation = Annotated[
    Annotated[str, one_of((WELL, USUALLY)), named((WELL, USUALLY)), Tag(NAME)]
    | Annotated[float, between(0.0, 1.0), Tag(NUMBER)],
    Discriminator(name_or_number),
]
"""A word, or the share of all measures that is badly installed."""


DrawnQuantity = Annotated[str, one_of(USUAL), named(USUAL)]


class UncertaintyTable(Table):
    """How much of what is not known is tried out."""

    samples: Annotated[int, between(1, 1_000_000)] | None = Field(
        default=None,
        description="Most runs with each option, spread evenly over the motions, with one of each motion at "
        "least: by default 400 in the plane and where a precision is stated, else 60.",
    )
    seed: int = between(0, 2**53, default=1, description="Seed of the draws.")
    precision: Annotated[float, between(0.001, 0.5)] | None = Field(
        default=None,
        description="Half-width of the 95 % interval of the probability of overturning that is enough.",
    )
    as_stated: list[DrawnQuantity] = Field(
        default=[],
        max_length=len(USUAL),
        description="Quantities that were measured: they are as stated in every sample, and not drawn.",
    )
    installation: Installation = Field(
        default=WELL,
        description="How measures are installed: well, as people install them, or the share badly installed.",
    )

    _quantities: Uncertainty | None = PrivateAttr(default=None)

    @property
    def quantities(self) -> Uncertainty:
        """The distributions of what is drawn; a file leaves them as they are usually."""
        return self._quantities or QUANTITIES

    def with_quantities(self, quantities: Uncertainty) -> Self:
        """Return the same with other distributions of some quantities; the rest is as stated.

        Raises
        ------
        InputError
            A name that is not one of `stayput.uncertainty.USUAL`.
        """
        for name in quantities.marginals:
            if name not in USUAL:
                raise unknown("uncertainty", name, USUAL, "uncertainty")
        stated = [name for name in USUAL if name not in quantities.marginals]
        copy = self.model_copy(update={"as_stated": stated})
        copy._quantities = Uncertainty({**USUAL, **quantities.marginals})
        return copy

    def badly(self, share: float) -> float:
        """Return the share of a measure that is badly installed, given that which is so usually."""
        if isinstance(self.installation, str):
            return share if self.installation == USUALLY else 0.0
        return self.installation

"""The table of a scenario that says how the floor is shaken."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal, Self, cast

from pydantic import AfterValidator, Discriminator, Field, Tag, model_validator

from stayput.building.model import MOST_STOREYS, Shaken
from stayput.catalogue import phrase
from stayput.errors import InputError, not_allowed, within
from stayput.motion.floors import of_the_ground
from stayput.motion.ground_shaking import (
    EarthquakeSource,
    GroundStrength,
    strength_of_earthquake,
    strength_of_intensity,
    strength_of_mercalli,
    strength_of_pga,
    strength_of_pgv,
    strength_of_sa,
)
from stayput.motion.intensity import CLASSES, INTENSITY_RANGE, intensity_of_class, possible_intensity
from stayput.motion.readers import read_shaking
from stayput.motion.readers.columns import MOST_SKIPPED, OPTIONS, ReadingOptions, chosen_columns
from stayput.motion.record import Motion
from stayput.motion.suites.families import FAMILIES
from stayput.motion.suites.suite import Suite, read_suite
from stayput.motion.suites.synthesis import MIXED, synthetic_suite
from stayput.motion.synthetic import near_fault, sine
from stayput.scenario import fields
from stayput.scenario.tables import BuildingTable, PythonTable


@fields.fields_of(sine)
class SineTable(fields.ValueTable):
    """A harmonic motion."""

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        fields.checked("shaking.sine", self.motion)
        return self

    def motion(self) -> Motion:
        """Make the motion."""
        return sine(**self.model_dump())


def _kind_of_vertical(value: object) -> str:
    return fields.NAME if isinstance(value, str) else "<switch>"


Vertical = Annotated[
    Annotated[bool, Tag("<switch>")] | Annotated[fields.Text, Tag(fields.NAME)],
    Discriminator(_kind_of_vertical),
]


CLASS_NAMES = tuple(name for name, _ in CLASSES)
FAMILY_NAMES = (MIXED, *FAMILIES)

ClassName = Annotated[str, fields.one_of(CLASS_NAMES, "intensity"), fields.named(CLASS_NAMES)]
FamilyName = Annotated[str, fields.one_of(FAMILY_NAMES), fields.named(FAMILY_NAMES)]


Intensity = Annotated[
    Annotated[float, fields.between(*INTENSITY_RANGE), AfterValidator(possible_intensity), Tag(fields.NUMBER)]
    | Annotated[ClassName, Tag(fields.NAME)],
    Discriminator(fields.name_or_number),
]


@fields.fields_of(strength_of_sa)
class SpectralTable(fields.ValueTable):
    """A spectral acceleration, to which every motion is scaled."""


@fields.fields_of(EarthquakeSource)
class EarthquakeTable(fields.ValueTable):
    """An earthquake and the ground where it is felt; a ground-motion model gives how strongly it shakes."""


@fields.fields_of(synthetic_suite)
class SuiteTable(fields.ValueTable):
    """A suite of synthetic motions."""

    family: FamilyName = Field(default=MIXED, description="Kind of earthquake.")


SuiteOrFolder = Annotated[
    Annotated[SuiteTable, Tag(fields.TABLE)] | Annotated[fields.Text, Tag(fields.NAME)],
    Discriminator(fields.kind_of),
]
SOURCES = ("record", "sine", "builtin", "suite")
RECORD_FILES = ("record", "across", "vertical")
"""Keys that may name a file of a record."""

STRENGTHS = ("intensity", "pga", "pgv", "sa", "mmi", "earthquake")
"""Ways to say how strongly the ground shakes."""


class ShakingTable(PythonTable):
    """How the floor is shaken: a record, a sine, a built-in motion or a suite, and the building between."""

    record: fields.Text | None = Field(
        default=None, description="A record's file, relative to the scenario's file."
    )
    across: fields.Text | None = Field(
        default=None, description="The file that holds the component across the shaking, for a record."
    )
    component: fields.Text | None = Field(
        default=None, description="Which of the record's horizontal channels is along the shaking."
    )
    unit: fields.Text | None = Field(
        default=None, description="The unit of a record whose file does not state it."
    )
    dt: float | None = fields.of(
        sine, "dt", default=None, description="The time step of a record whose file does not state it."
    )
    remove_mean: bool = Field(
        default=False,
        description="Whether the mean of each component of a record is taken off: an instrument's offset, "
        "or gravity in the vertical one.",
    )
    columns: fields.Text | None = Field(
        default=None,
        description="Which columns of the record's file are the time and the components, by their headings "
        "or their places: t=1,x=2,y=3,z=4; or rows, where each row has several samples of one series.",
    )
    skip_lines: Annotated[int, fields.between(0, MOST_SKIPPED)] | None = Field(
        default=None, description="How many lines at the beginning of the record's file are passed over."
    )
    decimal_comma: bool = Field(
        default=False, description="Whether the record's numbers have a comma in the place of the point."
    )
    location: fields.Text | None = Field(
        default=None,
        description="Of a SAC or miniSEED record, the code of the sensor where a station has several; "
        "-- of none.",
    )
    sine: SineTable | None = Field(default=None, description="A harmonic motion.")
    builtin: Literal["near-fault"] | None = Field(default=None, description="A built-in, synthetic motion.")
    suite: SuiteOrFolder | None = Field(
        default=None, description="A suite of synthetic motions, or a folder of records."
    )
    member: int | None = fields.of(
        synthetic_suite,
        "count",
        default=None,
        description="Which motion of a suite `simulate` takes; 1 where it is not said.",
    )
    scale: float | None = fields.between(-1e3, 1e3, default=None, description="Factor on the whole motion.")
    intensity: Intensity | None = Field(
        default=None,
        description="JMA intensity of the ground that every motion is scaled to; a class is its middle. "
        "Where no motion is given, those of the built-in suite.",
    )
    pga: float | None = fields.of(strength_of_pga, "pga", default=None)
    pgv: float | None = fields.of(strength_of_pgv, "pgv", default=None)
    sa: SpectralTable | None = Field(
        default=None,
        description="A spectral acceleration at 5 % damping, in the place of an intensity: the geometric "
        "mean of the horizontal components, that every motion is scaled to.",
    )
    mmi: float | None = fields.of(strength_of_mercalli, "mmi", default=None)
    earthquake: EarthquakeTable | None = Field(
        default=None,
        description="An earthquake and its distance, in the place of an intensity: motions are scaled to the "
        "peak velocity and its scatter of Si and Midorikawa (1999).",
    )
    vertical: Vertical = Field(
        default=True,
        description="Whether the vertical component acts; or the file that holds it, for a record: "
        "its vertical channel, or its only one where that has no direction.",
    )
    building: BuildingTable | None = Field(
        default=None, description="The building between the ground and the furniture."
    )
    storey: Annotated[int, fields.between(1, MOST_STOREYS)] | None = Field(
        default=None, description="The storey where the furniture stands: 1 is the ground floor."
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        self.refuse_several("shaking", SOURCES)
        if self.record is None:
            without = phrase("scenario.without_record")
            of_folders = () if isinstance(self.suite, str) else ("component", "unit", *sorted(OPTIONS))
            for key in (*of_folders, "across"):
                if getattr(self, key) not in (None, False):
                    raise InputError("common.left_out", f"shaking.{key}", where=without)
            if isinstance(self.vertical, str):
                name, value = "shaking.vertical", repr(self.vertical)
                raise not_allowed(name, value, "scenario.vertical_without_record", name)
        chosen_columns(self.columns, "shaking.columns")
        self.refuse_several("shaking", (*STRENGTHS, "scale"))
        if self.member is not None and not self.of_a_suite:
            raise InputError("common.left_out", "shaking.member", where=phrase("scenario.member_of_one"))
        self.refuse_single("shaking", "building", "storey")
        if self.building is not None and self.storey is not None and self.storey > self.building.highest():
            allowed = phrase("scenario.roof", roof=self.building.highest())
            raise not_allowed("shaking.storey", str(self.storey), allowed, "shaking.storey")
        return self

    @property
    def of_a_suite(self) -> bool:
        """Whether the shaking is a suite: one that is named, or the built-in one to an intensity."""
        if self._in_python is not None:
            return len(self._in_python) > 1
        single = (self.record, self.sine, self.builtin)
        return self.suite is not None or (self.strength is not None and all(key is None for key in single))

    def motion(self, folder: Path) -> Motion:
        """Make the motion under the furniture; of a suite, that of its ``member``.

        Parameters
        ----------
        folder : Path
            Where a record's relative path begins.

        Raises
        ------
        InputError
            A record cannot be read, or the suite has no such member.
        """
        ground = self._scaled(self._given(folder)[(self.member or 1) - 1])
        return self._with_vertical(self._on_floor(ground))

    def motions(self, folder: Path) -> Suite:
        """Make all motions under the furniture: the suite's, or the one motion.

        Raises
        ------
        InputError
            A record cannot be read.
        """
        suite = self._given(folder)
        floor = self._on_floor(Suite(tuple(map(self._scaled, suite)), suite.name))
        return Suite(tuple(map(self._with_vertical, floor)), floor.name)

    @property
    def synthetic_suite(self) -> SuiteTable | None:
        """The suite of synthetic motions; None where the motions are given, or there is one."""
        if self._in_python is not None or isinstance(self.suite, str) or not self.of_a_suite:
            return None
        return self.suite or SuiteTable()

    def ground(self, folder: Path, first: int | None = None) -> Suite:
        """Make the motions of the ground with all their components, not scaled.

        Where a peak or a spectral acceleration is stated, each has one of 1 m/s² or 1 m/s: a piece that faces
        another way has other components, of which neither may be the larger one as stated.

        Parameters
        ----------
        folder : Path
            Where records are.
        first : int, optional
            Of a synthetic suite only so many motions, which are the first ones of the whole suite.

        Raises
        ------
        InputError
            A record cannot be read, or is of an upper floor where the strength of the ground is stated, or
            others are of the ground.
        """
        suite, strength = self._given(folder, first), self.strength
        if strength is not None or not all(motion.floor for motion in suite):
            for motion in suite:
                of_the_ground(motion, "suite" if strength is None else "strength")
        if strength is None or strength.measure == "JMA":
            return suite
        unit = (motion.scaled(1.0 / strength.peak(motion)) for motion in suite)
        return Suite(tuple(unit), suite.name)

    @property
    def stated(self) -> str | None:
        """Which of `STRENGTHS` says how strongly the ground shakes."""
        return next((key for key in STRENGTHS if getattr(self, key) is not None), None)

    @property
    def strength(self) -> GroundStrength | None:
        """What the ground is scaled to; None where the motions keep their own strength."""
        if self.intensity is not None:
            stated = self.intensity
            return strength_of_intensity(intensity_of_class(stated) if isinstance(stated, str) else stated)
        if self.sa is not None:
            return strength_of_sa(self.sa.period, self.sa.value)
        if self.earthquake is not None:
            return strength_of_earthquake(EarthquakeSource(**self.earthquake.model_dump()))
        makers = {"pga": strength_of_pga, "pgv": strength_of_pgv, "mmi": strength_of_mercalli}
        return makers[self.stated](getattr(self, self.stated)) if self.stated else None

    def _given(self, folder: Path, first: int | None = None) -> Suite:
        return self._suite(folder, first) if self.of_a_suite else Suite((self._single(folder),))

    def _single(self, folder: Path) -> Motion:
        if self._in_python is not None:
            return self._in_python[0]
        if self.record is not None:
            return self._recorded(self.record, folder)
        return self.sine.motion() if self.sine is not None else near_fault()

    def _scaled(self, motion: Motion) -> Motion:
        if self.intensity is not None:
            return motion.to_intensity(self.intensity)
        if self.strength is not None:
            return motion.scaled(self.strength.factor(motion))
        return motion if self.scale is None or self.scale == 1.0 else motion.scaled(self.scale)

    def _on_floor(self, ground: Shaken) -> Shaken:
        if self.building is None or self.storey is None:
            return ground
        return self.building.building().floor_motion(ground, self.storey)

    def _with_vertical(self, motion: Motion) -> Motion:
        return motion if self.vertical else replace(motion, z=None)

    def _suite(self, folder: Path, first: int | None) -> Suite:
        if (table := self.synthetic_suite) is not None:
            count = table.count
            suite = synthetic_suite(table.family, min(first or count, count), table.seed)
        else:
            suite = self._in_python
            if suite is None:
                suite = read_suite(folder / str(self.suite), self.component, self.unit, **self._reading)
            count = len(suite)
        within("shaking.member", self.member or 1, 1, count, "", "shaking.member")
        return suite

    @property
    def _reading(self) -> ReadingOptions:
        return cast("ReadingOptions", self.model_dump(include=OPTIONS, exclude_none=True))

    def _recorded(self, record: str, folder: Path) -> Motion:
        several = self.across is not None or isinstance(self.vertical, str)
        motion = read_shaking(folder / record, self.component, self.unit, several=several, **self._reading)
        if not several:
            return motion
        _refuse_vertical(motion, "record", record)
        parts = {name: motion.component(name) for name in motion.components if name != "x"}
        if self.across is not None:
            parts["y"] = read_shaking(folder / self.across, unit=self.unit, several=True, **self._reading)
            _refuse_vertical(parts["y"], "across", self.across)
        if isinstance(self.vertical, str):
            parts["z"] = read_shaking(
                folder / self.vertical, unit=self.unit, several=True, vertical=True, **self._reading
            )
        return Motion.combine(motion, parts.get("y"), parts.get("z"), motion.name)


def _refuse_vertical(motion: Motion, key: str, file: str) -> None:
    """Refuse a vertical record beside others: each of them says which component it is of."""
    listing = motion.listing
    if listing is not None and listing.vertical[listing.used]:
        hint = phrase("common.aside", content=repr(listing.names[listing.used]))
        name, allowed = f"shaking.{key}", phrase("scenario.horizontal")
        raise InputError("common.not_allowed", name, value=repr(file), hint=hint, allowed=allowed)

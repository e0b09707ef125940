"""The table of a scenario that says how the floor is shaken."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Literal, Self

from pydantic import Discriminator, Field, Tag, model_validator

from stayput.motion import Motion, near_fault, read_motion, sine
from stayput.scenario.fields import NAME, Table, Text, between, checked

if TYPE_CHECKING:
    from pathlib import Path


class SineTable(Table):
    """A harmonic motion."""

    amplitude: Annotated[float, between(-1e4, 1e4, "m/s²")] = Field(description="Amplitude.")
    frequency: Annotated[float, between(1e-3, 1e3, "Hz")] = Field(description="Frequency.")
    duration: Annotated[float, between(1e-3, 1e5, "s")] = Field(default=30.0, description="Time of shaking.")
    phase: Annotated[float, between(-1e3, 1e3, "rad")] = Field(
        default=0.0, description="Phase; π/2 is a cosine."
    )
    dt: Annotated[float, between(1e-6, 1.0, "s")] = Field(default=0.005, description="Largest time step.")
    quiet: Annotated[float, between(0.0, 1e5, "s")] = Field(
        default=0.0, description="Still floor after the shaking."
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        checked("shaking.sine", self.motion)
        return self

    def motion(self) -> Motion:
        """Make the motion."""
        return sine(**self.model_dump())


def _kind_of_vertical(value: object) -> str:
    return NAME if isinstance(value, str) else "<switch>"


Vertical = Annotated[
    Annotated[bool, Tag("<switch>")] | Annotated[Text, Tag(NAME)], Discriminator(_kind_of_vertical)
]


class ShakingTable(Table):
    """How the floor is shaken: by a record, a sine, or a built-in motion."""

    record: Text | None = Field(default=None, description="A record's file, relative to the scenario's file.")
    component: Text | None = Field(
        default=None, description="Which of the record's channels is along the shaking."
    )
    unit: Text | None = Field(
        default=None, description="The record's unit, where its file does not state it."
    )
    dt: Annotated[float, between(1e-6, 1.0, "s")] | None = Field(
        default=None, description="The record's time step, where its file does not state it."
    )
    sine: SineTable | None = Field(default=None, description="A harmonic motion.")
    builtin: Literal["near-fault"] | None = Field(default=None, description="A built-in, synthetic motion.")
    scale: Annotated[float, between(-1e3, 1e3)] = Field(
        default=1.0, description="Factor on the whole motion."
    )
    vertical: Vertical = Field(
        default=True,
        description="Whether the vertical component acts; or the file that holds it, for a record.",
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        given = [key for key in ("record", "sine", "builtin") if getattr(self, key) is not None]
        if len(given) > 1:
            raise ValueError(f"shaking.{given[1]} is given beside shaking.{given[0]}; it must be only one.")
        if self.record is None:
            for key in ("component", "unit", "dt"):
                if getattr(self, key) is not None:
                    raise ValueError(
                        f"shaking.{key} is given without shaking.record; it belongs to a record only."
                    )
            if isinstance(self.vertical, str):
                told = f"shaking.vertical is {self.vertical!r} without shaking.record"
                raise ValueError(f"{told}; it must be true or false there.")
        return self

    def motion(self, folder: Path) -> Motion:
        """Make the motion.

        Parameters
        ----------
        folder : Path
            Where a record's relative path begins.

        Raises
        ------
        InputError
            The record cannot be read.
        """
        if self.record is not None:
            motion = self._recorded(self.record, folder)
        elif self.sine is not None:
            motion = self.sine.motion()
        else:
            motion = near_fault()
        if not self.vertical:
            motion = replace(motion, z=None)
        return motion if self.scale == 1.0 else motion.scaled(self.scale)

    def _recorded(self, record: str, folder: Path) -> Motion:
        motion = read_motion(folder / record, self.component, self.unit, dt=self.dt)
        if not isinstance(self.vertical, str):
            return motion
        up = read_motion(folder / self.vertical, None, self.unit, dt=self.dt)
        across = None if motion.y is None else motion.component("y")
        return Motion.combine(motion, across, up, motion.name)

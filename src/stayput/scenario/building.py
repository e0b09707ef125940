"""The table of a scenario that says which building stands between the ground and the furniture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Self

from pydantic import Field, model_validator

from stayput.building import STRUCTURES, Building, ShearModel
from stayput.building.model import MOST_STOREYS
from stayput.errors import InputError
from stayput.scenario.fields import Table, checked, each, named, of, one_of

if TYPE_CHECKING:
    from stayput.motion import Motion

StructureName = Annotated[str, one_of(STRUCTURES, "structure"), named(STRUCTURES)]
Masses = Annotated[
    list[Annotated[float, each(ShearModel, "masses")]], Field(min_length=1, max_length=MOST_STOREYS)
]
Stiffnesses = Annotated[
    list[Annotated[float, each(ShearModel, "stiffnesses")]], Field(min_length=1, max_length=MOST_STOREYS)
]
OF_A_REGULAR_ONE = ("storeys", "structure", "period", "storey_height", "yield_coefficient", "post_yield")


class BuildingTable(Table):
    """The building: what people know of it, or masses and stiffnesses of one's own."""

    storeys: int | None = of(Building, "storeys", default=None)
    structure: StructureName | None = Field(default=None, description='Structure; "RC" where it is not said.')
    period: float | None = of(Building, "period")
    damping: float | None = of(Building, "damping")
    storey_height: float | None = of(Building, "storey_height")
    nonlinear: bool = Field(
        default=True,
        description="Whether the storeys yield under strong shaking; below that nothing changes.",
    )
    yield_coefficient: float | None = of(Building, "yield_coefficient")
    post_yield: float | None = of(Building, "post_yield")
    vertical_amplification: float = of(Building, "vertical_amplification")
    masses: Masses | None = Field(
        default=None, description="Masses of the floors, bottom to top: a model of one's own."
    )
    stiffnesses: Stiffnesses | None = Field(
        default=None, description="Shear stiffness of the storey below each."
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        own = self.masses is not None or self.stiffnesses is not None
        if own and (self.masses is None or self.stiffnesses is None):
            given, missing = ("masses", "stiffnesses") if self.masses else ("stiffnesses", "masses")
            name, other = f"shaking.building.{given}", f"shaking.building.{missing}"
            raise InputError("scenario.needs_both", name, name=name, other=other)
        if own:
            for key in OF_A_REGULAR_ONE:
                if getattr(self, key) is not None:
                    name = f"shaking.building.{key}"
                    raise InputError("scenario.beside", name, name=name, other="shaking.building.masses")
            if self.nonlinear and "nonlinear" in self.model_fields_set:
                name, other = "shaking.building.nonlinear", "shaking.building.masses"
                raise InputError("scenario.nonlinear_masses", name, name=name, other=other)
        elif self.storeys is None:
            raise InputError("scenario.no_storeys", "shaking.building.storeys")
        checked("shaking.building", self.building)
        return self

    def building(self) -> Building | ShearModel:
        """Make the building."""
        if self.masses is not None and self.stiffnesses is not None:
            return ShearModel(
                self.masses,
                self.stiffnesses,
                0.05 if self.damping is None else self.damping,
                vertical_amplification=self.vertical_amplification,
                name=f"{len(self.masses)}-mass building",
            )
        given = self.model_dump(exclude={"masses", "stiffnesses"}, exclude_none=True)
        return Building(**given)

    @property
    def yields(self) -> bool:
        """Whether the floors' motion does not scale with the ground's."""
        return self.nonlinear and self.masses is None

    def highest(self) -> int:
        """Return the number of the highest floor: the roof's."""
        return 1 + (self.storeys if self.storeys is not None else len(self.masses or ()))

    def floor_motion(self, ground: Motion, storey: int) -> Motion:
        """Return the motion under the furniture of a storey."""
        return self.building().floor_motion(ground, storey)

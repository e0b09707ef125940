"""The table of a scenario that says which building stands between the ground and the furniture."""

from __future__ import annotations

from typing import Annotated, Any, Self

from pydantic import Field, ModelWrapValidatorHandler, PrivateAttr, model_validator

from stayput.building import STRUCTURES, Building, ShearModel
from stayput.building.model import MOST_STOREYS
from stayput.errors import InputError
from stayput.scenario.fields import ValueTable, checked, each, fields_of, named, of, one_of

StructureName = Annotated[str, one_of(STRUCTURES, "structure"), named(STRUCTURES)]
Masses = Annotated[
    list[Annotated[float, each(ShearModel, "masses")]], Field(min_length=1, max_length=MOST_STOREYS)
]
Stiffnesses = Annotated[
    list[Annotated[float, each(ShearModel, "stiffnesses")]], Field(min_length=1, max_length=MOST_STOREYS)
]
OF_A_REGULAR_ONE = ("storeys", "structure", "period", "storey_height", "yield_coefficient", "post_yield")


@fields_of(Building)
class BuildingTable(ValueTable):
    """The building: what people know of it, or masses and stiffnesses of one's own."""

    storeys: int | None = of(Building, "storeys", default=None)
    structure: StructureName | None = Field(default=None, description='Structure; "RC" where it is not said.')
    nonlinear: bool = Field(
        default=True,
        description="Whether the storeys yield under strong shaking; below that nothing changes.",
    )
    masses: Masses | None = Field(
        default=None, description="Masses of the floors, bottom to top: a model of one's own."
    )
    stiffnesses: Stiffnesses | None = Field(
        default=None, description="Shear stiffness of the storey below each."
    )

    _in_python: Building | ShearModel | None = PrivateAttr(default=None)

    @model_validator(mode="wrap")
    @classmethod
    def _of_python(cls, value: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        return cls.of(value) if isinstance(value, Building | ShearModel) else handler(value)

    @classmethod
    def of(cls, building: Building | ShearModel) -> Self:
        """Return the table of a building, which makes it again; of one that no file can say, it is kept."""
        fields: dict[str, Any] = {name: getattr(building, name, None) for name in cls.model_fields}
        if isinstance(building, ShearModel):
            fields = {name: [*getattr(building, name)] for name in ("masses", "stiffnesses", "damping")}
            fields |= {
                "damping": fields["damping"][0],
                "vertical_amplification": building.vertical_amplification,
            }
        usual = {name: about.default for name, about in cls.model_fields.items()}
        table = cls.model_validate({key: value for key, value in fields.items() if value != usual[key]})
        if table.building() != building:
            table._in_python = building
        return table

    @property
    def in_python(self) -> Building | ShearModel | None:
        """The building that was given as a Python object and that a file cannot say."""
        return self._in_python

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
        if self._in_python is not None:
            return self._in_python
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
        building = self.building()
        return building.yields if isinstance(building, ShearModel) else building.nonlinear

    def highest(self) -> int:
        """Return the number of the highest floor: the roof's."""
        return 1 + self.building().storeys

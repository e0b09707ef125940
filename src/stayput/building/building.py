"""`Building`: a shear model from what people know of their building, and what is assumed of the rest."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from stayput.building import model as shear_model
from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of
from stayput.model.parameters import STANDARD_GRAVITY, check_fields, parameter, quantity
from stayput.vocabulary import preset_meant
from stayput.wording import Brief

_DAMPING = ("", 0.0, 0.5, ("Building damping", "建物の減衰定数"))
_YIELD = ("", 1e-3, 10.0, ("Building yield_coefficient", "建物の降伏せん断力係数"))
_POST_YIELD = ("", 0.0, 0.95, ("Building post_yield", "建物の降伏後の剛性比"))


@dataclass(frozen=True, slots=True)
class Structure:
    """Values assumed of a building of one kind of structure (defaults, low confidence).

    Parameters
    ----------
    period_per_height : float
        First natural period over height [s/m].
    damping : float
        Damping ratio of every mode.
    yield_coefficient : float
        Shear of the lowest storey at yielding over the weight above, for a fast building.
    post_yield : float
        Ratio of a storey's stiffness after yielding to that before it.
    """

    period_per_height: float = field(
        metadata=quantity("s/m", 1e-3, 1.0, ("First period over height", "建物の高さに対する固有周期"))
    )
    damping: float = field(metadata=quantity(*_DAMPING))
    yield_coefficient: float = field(metadata=quantity(*_YIELD))
    post_yield: float = field(metadata=quantity(*_POST_YIELD))


ISOLATED = "base-isolated"
"""Name of the structure that stands on isolators."""

STRUCTURES: dict[str, Structure] = {
    "RC": Structure(0.02, 0.03, 0.45, 0.05),
    "steel": Structure(0.03, 0.02, 0.35, 0.05),
    "wood": Structure(0.03, 0.05, 0.40, 0.05),
    ISOLATED: Structure(0.02, 0.03, 0.45, 0.05),
}
"""Values by structure; those of a base-isolated building are for the RC building above the isolators."""

STOREY_HEIGHT = 3.0
"""Height of a storey (default, low confidence) [m]."""

FLOOR_MASS = 5e5
"""Mass of every floor [kg]; it has no influence on any motion, and scales forces and energies."""


@dataclass(frozen=True, slots=True)
class Isolation:
    """Isolators between the ground and the slab of storey 1 (every value is a default of low confidence).

    Parameters
    ----------
    period : float
        Effective period of the building, taken as rigid, on the isolators [s].
    damping : float
        Effective damping ratio of the layer.
    displacement : float
        Displacement of the layer at which the nonlinear isolators have that period and damping [m].
    post_yield : float
        Ratio of the nonlinear isolators' stiffness after yielding to that before it.

    Raises
    ------
    InputError
        A value out of range, or a damping that no bilinear law of that ratio has.

    Examples
    --------
    >>> import stayput as sp
    >>> building = sp.Building(5, "base-isolated", isolation=sp.Isolation(period=3.0))
    >>> building.floor_motion(sp.near_fault(), 5).pga < sp.near_fault().pga
    True
    """

    period: float = parameter(4.0, "s", 0.5, 20.0, ("Isolation period", "免震層の周期"))
    damping: float = parameter(0.20, "", 0.01, 0.6, ("Isolation damping", "免震層の減衰定数"))
    displacement: float = parameter(0.25, "m", 0.01, 2.0, ("Isolation displacement", "免震層の変位"))
    post_yield: float = parameter(0.1, "", 0.01, 0.9, ("Isolation post_yield", "免震層の降伏後の剛性比"))

    def __post_init__(self) -> None:
        check_fields(self, place="isolation.")
        root = math.sqrt(self.post_yield)
        most = 2.0 / math.pi * (1.0 - root) / (1.0 + root)
        if self.damping >= most:
            about: dict[str, Any] = {"damping": self.damping, "most": most, "post_yield": self.post_yield}
            raise InputError("building.isolation_too_damped", "isolation.damping", **about)

    def stiffness(self, mass: float) -> float:
        """Return the effective stiffness under a mass [kg], m(2π/T)² [N/m]."""
        return mass * (2.0 * math.pi / self.period) ** 2

    def bilinear(self, mass: float) -> tuple[float, float]:
        """Return the stiffness before yielding [N/m] and the yield force [N] under a mass [kg].

        ζ = (2/π)(1 − r)(μ − 1)/(μ(1 + r(μ − 1))) holds at two μ, the displacement over that at yielding; the
        larger is a layer that has yielded well.
        """
        r = self.post_yield
        z = 0.5 * math.pi * self.damping / (1.0 - r)
        b = 1.0 - z * (1.0 - r)  # z r μ² − b μ + 1 = 0
        mu = (b + math.sqrt(b * b - 4.0 * z * r)) / (2.0 * z * r)
        first = self.stiffness(mass) * mu / (1.0 + r * (mu - 1.0))
        return first, first * self.displacement / mu


@dataclass(frozen=True, repr=False)
class Building(shear_model.ShakenFloors, Brief):
    """A regular building: storeys of one height and one mass, stiffnesses from the Ai distribution.

    Furniture of storey 1 stands on the ground (of a base-isolated building: on the slab above the
    isolators), that of storey n on slab n; the roof is storey ``storeys`` + 1. Defaults that depend on the
    structure are in `STRUCTURES`, and are of low confidence.

    Parameters
    ----------
    storeys : int
        Number of storeys.
    structure : str
        "RC", "steel", "wood" or "base-isolated", or what people call them: "S造", "木造".
    period : float, optional
        First natural period [s]; of a base-isolated building, that of the building on fixed ground.
        Default: by height, 0.02 s/m (RC) or 0.03 s/m (steel, wood).
    damping : float, optional
        Damping ratio of every mode; of a base-isolated building, of its storeys.
    storey_height : float, optional
        Height of a storey [m]; default 3 m. It acts through the default period alone.
    nonlinear : bool
        Whether the storeys yield; below that it makes no difference.
    yield_coefficient : float, optional
        Shear of the lowest storey at yielding over the weight above; those of the others follow Ai.
        Default: the structure's times the spectral factor Rt of the period.
    post_yield : float, optional
        Ratio of a storey's stiffness after yielding to that before it.
    isolation : Isolation
        The isolators of a base-isolated building.
    vertical_amplification : float
        Factor on the vertical motion at the roof; it grows linearly from 1 at storey 1. The default 1
        passes it through.

    Raises
    ------
    InputError
        An unknown structure, or a value out of range.

    Examples
    --------
    >>> import stayput as sp
    >>> tower = sp.Building(storeys=10, structure="RC")
    >>> round(tower.fixed_period, 2)  # s
    0.6
    >>> [round(tower.floor_motion(sp.near_fault(), storey).pga, 1) for storey in (1, 5, 10)]  # m/s²
    [7.3, 7.5, 10.7]
    """

    storeys: int = parameter(10, "", 1, shear_model.MOST_STOREYS - 1, ("Number of storeys", "建物の階数"))
    structure: str = "RC"
    period: float | None = parameter(None, "s", 0.02, 20.0, ("Building period", "建物の固有周期"))
    damping: float | None = parameter(None, *_DAMPING)
    storey_height: float | None = parameter(None, "m", 1.5, 20.0, ("Building storey_height", "建物の階高"))
    nonlinear: bool = True
    yield_coefficient: float | None = parameter(None, *_YIELD)
    post_yield: float | None = parameter(None, *_POST_YIELD)
    isolation: Isolation = field(default_factory=Isolation)
    vertical_amplification: float = parameter(
        1.0, "", *shear_model.AMPLIFICATION_RANGE, ("Building vertical_amplification", "建物の上下動の増幅率")
    )

    def __post_init__(self) -> None:
        structure = preset_meant("structure", "building.structure", self.structure, STRUCTURES, "structure")
        object.__setattr__(self, "structure", structure)
        instance_of("nonlinear", self.nonlinear, bool)
        instance_of("isolation", self.isolation, Isolation)
        for name in ("yield_coefficient", "post_yield"):
            if not self.nonlinear and getattr(self, name) is not None:
                raise InputError("common.left_out", name, where=phrase("building.of_linear"))
        check_fields(self)
        object.__setattr__(self, "storeys", int(self.storeys))
        if self.structure == ISOLATED and self.fixed_period >= self.isolation.period:
            fixed, isolators = self.fixed_period, self.isolation.period
            raise InputError("building.period_of_isolated", "period", period=fixed, isolators=isolators)

    def _repr_html_(self) -> str:
        from stayput.report.notebook import building_html

        return building_html(self)

    @property
    def name(self) -> str:
        """What the building is called: "10-storey RC building"."""
        return f"{self.storeys}-storey {self.structure} building"

    @property
    def height(self) -> float:
        """Height H [m]."""
        return self.storeys * (STOREY_HEIGHT if self.storey_height is None else self.storey_height)

    @property
    def fixed_period(self) -> float:
        """First natural period on fixed ground [s]: the given one, or by height."""
        by_height = STRUCTURES[self.structure].period_per_height * self.height
        return by_height if self.period is None else float(self.period)

    @cached_property
    def model(self) -> shear_model.ShearModel:
        """The building as masses and stiffnesses."""
        values, period, isolated = STRUCTURES[self.structure], self.fixed_period, self.structure == ISOLATED
        masses = np.full(self.storeys, FLOOR_MASS)
        stiffnesses = shear_model.storey_stiffnesses(masses, period)
        zeta = values.damping if self.damping is None else self.damping
        ratio = np.full(self.storeys, values.post_yield if self.post_yield is None else self.post_yield)
        coefficient = self.yield_coefficient
        if coefficient is None:
            coefficient = values.yield_coefficient * shear_model.spectral_factor(period)
        shears = (
            coefficient
            * shear_model.ai_distribution(masses, period)
            * (STANDARD_GRAVITY * shear_model.weight_above(masses))
        )
        damping = np.full(self.storeys, zeta)
        if isolated:  # the isolators are one more storey below, and the slab on them one more mass
            total = float(masses.sum()) + FLOOR_MASS
            layer, force = self.isolation.stiffness(total), float("inf")
            layer_damping = self.isolation.damping
            if self.nonlinear:  # the isolators' hysteresis dissipates the energy, so they need no damping
                (layer, force), layer_damping = self.isolation.bilinear(total), 0.0
            masses = np.append(FLOOR_MASS, masses)
            stiffnesses = np.append(layer, stiffnesses)
            shears, ratio = np.append(force, shears), np.append(self.isolation.post_yield, ratio)
            modes = shear_model.natural_modes(masses, stiffnesses)
            damping = shear_model.strain_energy_damping(modes, stiffnesses, np.append(layer_damping, damping))
        return shear_model.ShearModel(
            masses.tolist(),
            stiffnesses.tolist(),
            damping.tolist(),
            shears.tolist() if self.nonlinear else None,
            ratio.tolist(),
            isolated,
            self.vertical_amplification,
            self.name,
        )

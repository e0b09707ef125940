"""The layer of isolators below storey 1: its effective linear values, and the bilinear law that has them."""

from __future__ import annotations

import math
from dataclasses import dataclass

from stayput.errors import InputError
from stayput.model.parameters import check_fields, parameter


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
        most = 2.0 / math.pi * (1.0 - math.sqrt(self.post_yield)) / (1.0 + math.sqrt(self.post_yield))
        if self.damping >= most:
            raise InputError(
                "building.isolation_too_damped",
                "isolation.damping",
                damping=self.damping,
                most=most,
                post_yield=self.post_yield,
            )

    def stiffness(self, mass: float) -> float:
        """Return the effective stiffness under a mass [kg], m(2π/T)² [N/m]."""
        return mass * (2.0 * math.pi / self.period) ** 2

    @property
    def ductility(self) -> float:
        """Displacement over the yield displacement, μ, at which the bilinear law has the damping.

        ζ = (2/π)(1 − r)(μ − 1)/(μ(1 + r(μ − 1))) holds at two μ; the larger is a layer that has yielded well.
        """
        r = self.post_yield
        z = 0.5 * math.pi * self.damping / (1.0 - r)
        b = 1.0 - z * (1.0 - r)  # z r μ² − b μ + 1 = 0
        return (b + math.sqrt(b * b - 4.0 * z * r)) / (2.0 * z * r)

    def bilinear(self, mass: float) -> tuple[float, float]:
        """Return the stiffness before yielding [N/m] and the yield force [N] under a mass [kg]."""
        mu = self.ductility
        first = self.stiffness(mass) * mu / (1.0 + self.post_yield * (mu - 1.0))
        return first, first * self.displacement / mu

"""Intensity measures, over which fragility curves are drawn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, numbers
from stayput.motion.units import STANDARD_GRAVITY

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, slots=True)
class IntensityMeasure:
    """A measure of how strong a motion is.

    Parameters
    ----------
    key : str
        Short name, as in files.
    name : str
        Full name.
    unit : str
        Unit that values are shown in; "" for none. Inside they are SI.
    shown : float
        The shown number over the SI number.
    is_logarithm : bool
        Whether it is a logarithm of the shaking already, as an intensity is. A curve is then normal in it;
        otherwise it is lognormal.
    period : float, optional
        Period of a spectral acceleration [s]; none of another measure.
    """

    key: str
    name: str
    unit: str
    shown: float = 1.0
    is_logarithm: bool = False
    period: float | None = None

    @property
    def label(self) -> str:
        """Name and unit, as for an axis."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    @property
    def least(self) -> float:
        """Lower bound of the values: 0 of a peak, −∞ of an intensity."""
        return -np.inf if self.is_logarithm else 0.0

    def coordinate(self, im: ArrayLike) -> NDArray[np.float64]:
        """Return the coordinate u in which a curve is normal: the intensity I, or ln of a peak."""
        values = np.asarray(im, np.float64)
        return values if self.is_logarithm else np.log(values)

    def value(self, u: ArrayLike) -> NDArray[np.float64]:
        """Return the value [SI] at a coordinate u."""
        values = np.asarray(u, np.float64)
        return values if self.is_logarithm else np.exp(values)

    def text(self, im: float, *, unit: bool = True) -> str:
        """Return a value [SI] as it is shown: "6.12", "41.3 cm/s"."""
        if self.is_logarithm:
            return f"{im:.2f}"
        return f"{im * self.shown:.3g} {self.unit if unit else ''}".rstrip()

    def checked(self, im: ArrayLike) -> NDArray[np.float64]:
        """Return values [SI] as a new array.

        Raises
        ------
        InputError
            A value that is not finite or, of a peak, not larger than 0.
        """
        values = numbers("im", im, "im")
        good = np.isfinite(values) & (self.is_logarithm | (values > 0.0))
        if not good.all():
            allowed = phrase("fragility.finite_number" if self.is_logarithm else "fragility.above_zero")
            raise InputError(
                "fragility.bad_intensity", measure=self.key, value=values[~good][0], allowed=allowed
            )
        return values


JMA_INTENSITY = IntensityMeasure("JMA", "JMA instrumental intensity", "", is_logarithm=True)
"""JMA's instrumental intensity, not rounded."""

PGA = IntensityMeasure("PGA", "peak ground acceleration", "m/s²")
"""Peak acceleration of the ground [m/s²]."""

PGV = IntensityMeasure("PGV", "peak ground velocity", "cm/s", 100.0)
"""Peak velocity of the ground [m/s], shown in cm/s."""

PFA = IntensityMeasure("PFA", "peak floor acceleration", "m/s²")
"""Peak acceleration of the floor that the body stands on [m/s²]."""

PFV = IntensityMeasure("PFV", "peak floor velocity", "cm/s", 100.0)
"""Peak velocity of the floor that the body stands on [m/s], shown in cm/s."""


def spectral_acceleration(period: float) -> IntensityMeasure:
    """Return Sa at a period [s]: 5 % damping, geometric mean of the horizontal components, shown in g."""
    name = f"spectral acceleration at {period:g} s"
    return IntensityMeasure(f"Sa_{period:g}", name, "g", 1.0 / STANDARD_GRAVITY, period=period)


INTENSITY_MEASURES = {measure.key: measure for measure in (JMA_INTENSITY, PGA, PGV, PFA, PFV)}
"""The measures that fragility curves are drawn against, by key."""

"""What a fragility curve is drawn against."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError

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
    """

    key: str
    name: str
    unit: str
    shown: float = 1.0
    is_logarithm: bool = False

    @property
    def label(self) -> str:
        """Name and unit, as for an axis."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

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
        values = np.array(im, np.float64)
        good = np.isfinite(values) & (self.is_logarithm | (values > 0.0))
        if not good.all():
            allowed = "a finite number" if self.is_logarithm else "larger than 0"
            raise InputError(f"A value of {self.key} is {values[~good][0]:g}; it must be {allowed}.")
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

INTENSITY_MEASURES = {measure.key: measure for measure in (JMA_INTENSITY, PGA, PGV, PFA, PFV)}
"""All of them by key."""

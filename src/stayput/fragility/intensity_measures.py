"""Intensity measures, over which fragility curves are drawn."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import not_allowed, numbers, unknown, within
from stayput.model.parameters import STANDARD_GRAVITY


@dataclass(frozen=True, slots=True)
class IntensityMeasure:
    """A measure of how strong a motion is.

    Parameters
    ----------
    key : str
        Short name, as in files.
    names : Phrase
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
    source : Phrase
        By whom a measure is got from others.

    Examples
    --------
    >>> from stayput.fragility.intensity_measures import PGV, IntensityMeasure
    >>> PGV.labels[0], PGV.text(0.413)  # values are SI
    ('Peak ground velocity [cm/s]', '41.3 cm/s')
    >>> rotation = IntensityMeasure("PGR", ("peak ground rotation", "地面の最大回転"), "mrad", 1000.0)
    >>> rotation.text(0.0021)
    '2.1 mrad'
    """

    key: str
    names: Phrase
    unit: str
    shown: float = 1.0
    is_logarithm: bool = False
    period: float | None = None
    source: Phrase = ("", "")

    @property
    def name(self) -> str:
        """Full name in English."""
        return self.names[0]

    @property
    def labels(self) -> Phrase:
        """Name, unit and source, as for an axis."""
        english, japanese = (f"{name} [{self.unit}]" if self.unit else name for name in self.names)
        of, by = self.source
        return english[0].upper() + english[1:] + (of and f" ({of})"), japanese + (by and f"（{by}）")

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
            allowed = "common.finite_number" if self.is_logarithm else "common.above_zero"
            raise not_allowed(self.key, f"{values[~good][0]:g}", allowed)
        return values


JMA_INTENSITY = IntensityMeasure("JMA", phrase("fragility.jma"), "", is_logarithm=True)
"""JMA's instrumental intensity, not rounded."""

FLOOR_JMA = IntensityMeasure("floor_JMA", phrase("fragility.floor_jma"), "", is_logarithm=True)
"""The number that JMA's formula gives for the motion of an upper floor: not the intensity of a place."""

PGA = IntensityMeasure("PGA", phrase("fragility.pga"), "m/s²")
"""Peak acceleration of the ground [m/s²]."""

PGV = IntensityMeasure("PGV", phrase("fragility.pgv"), "cm/s", 100.0)
"""Peak velocity of the ground [m/s], shown in cm/s."""

PFA = IntensityMeasure("PFA", phrase("fragility.pfa"), "m/s²")
"""Peak acceleration of the floor that the body stands on [m/s²]."""

PFV = IntensityMeasure("PFV", phrase("fragility.pfv"), "cm/s", 100.0)
"""Peak velocity of the floor that the body stands on [m/s], shown in cm/s."""

MMI = IntensityMeasure(
    "MMI", phrase("fragility.mmi"), "", is_logarithm=True, source=phrase("ground_shaking.mmi_source")
)
"""Modified Mercalli intensity by Worden et al. (2012), from the ground's PGA and PGV; not cut off at 10."""

PERIODS = (0.01, 10.0)
"""Shortest and longest period of a spectral acceleration [s]."""

_SPECTRAL = re.compile(r"SA\( *([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:e[+-]?[0-9]+)?) *\)", re.IGNORECASE)


def spectral_acceleration(period: float) -> IntensityMeasure:
    """Return Sa at a period [s]: 5 % damping, geometric mean of the horizontal components, shown in g."""
    names = phrase("fragility.sa", period=period)
    return IntensityMeasure(f"SA({period:g})", names, "g", 1.0 / STANDARD_GRAVITY, period=period)


INTENSITY_MEASURES = {measure.key: measure for measure in (JMA_INTENSITY, PGA, PGV, PFA, PFV)}
"""The measures that fragility curves are always drawn against, by key."""


def intensity_measure(text: str, name: str = "im") -> IntensityMeasure:
    """Return the measure of a text: a key of `INTENSITY_MEASURES`, MMI, or SA(T) with the period T [s].

    Parameters
    ----------
    text : str
        The text.
    name : str
        What it is called in a refusal.

    Raises
    ------
    InputError
        Another text, or a period out of range.

    Examples
    --------
    >>> intensity_measure("SA(0.3)").labels[0]
    'Spectral acceleration at 0.3 s [g]'
    """
    known = {**INTENSITY_MEASURES, MMI.key: MMI}
    if text in known:
        return known[text]
    spectral = _SPECTRAL.fullmatch(text)
    if spectral is None:
        listed = phrase("fragility.measures", known=", ".join(map(repr, known)))
        raise unknown(name, text, known, name, listed=listed)
    return spectral_acceleration(within(name, float(spectral[1]), *PERIODS, "s", name))

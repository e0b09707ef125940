"""What shake maps say of each place, and the levels that motions are scaled to by it."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.errors import InputError
from stayput.fragility import JMA_INTENSITY, PGA, PGV, spectral_acceleration
from stayput.fragility.intensity_measures import PERIODS
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.ground_shaking import MERCALLI_SCATTER
from stayput.motion.intensity import mercalli_rise, pgv_of_mercalli
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from stayput.fragility import IntensityMeasure

MERCALLI = (2.0, 10.0)
"""Modified Mercalli intensities that a peak velocity is known for; lower ones are taken for the lowest."""

_SA = re.compile(r"sa_(\d{1,2}(?:\.\d{1,4})?)", re.ASCII)
_PEAK = re.compile(r"(pga|pgv)[ _]?(?:\[([^\]]+)\]|\(([^)]+)\)|([^\[( ].*))")
_PSA = re.compile(r"psa(\d)(\d)", re.ASCII)

_VELOCITIES = {"cm/s": 0.01, "cms": 0.01, "kine": 0.01, "m/s": 1.0}


class MapField(NamedTuple):
    """One thing that a map says of each place.

    Parameters
    ----------
    name : str
        What the map calls it.
    measure : IntensityMeasure
        What the motions are scaled to.
    factor : float
        What its numbers are multiplied by to be in the unit of which the level is the logarithm.
    low, high : float
        Smallest and largest number.
    unit : str
        Unit of its numbers.
    mercalli : bool
        Whether it is a modified Mercalli intensity, which becomes a peak velocity.
    """

    name: str
    measure: IntensityMeasure
    factor: float
    low: float
    high: float
    unit: str
    mercalli: bool = False

    def levels(self, values: ArrayLike) -> NDArray[np.float64]:
        """Return the levels of values; those of places that do not shake are as low as can be."""
        given = np.asarray(values, np.float64)
        if self.mercalli:
            each, places = np.unique(np.clip(given, *MERCALLI), return_inverse=True)
            peaks = [math.log10(pgv_of_mercalli(one)) for one in each.tolist()]
            return np.array(peaks)[places].reshape(given.shape)
        if self.measure.is_logarithm:
            return given
        return np.log10(np.maximum(self.factor * given, self.factor * self.low))

    def scatters(self, values: ArrayLike, deviations: ArrayLike | None) -> NDArray[np.float64] | None:
        """Return the standard deviations of the levels.

        Parameters
        ----------
        values : array_like
            The values.
        deviations : array_like, optional
            Their standard deviations: of an intensity itself, else of the natural logarithm.
        """
        given = None if deviations is None else np.asarray(deviations, np.float64)
        if self.mercalli:
            rise = mercalli_rise(np.clip(np.asarray(values, np.float64), *MERCALLI))
            return np.hypot(MERCALLI_SCATTER, (0.0 * rise if given is None else given) / rise)
        if given is None or self.measure.is_logarithm:
            return given
        return given / math.log(10.0)


def field_of(column: str) -> MapField | None:
    """Return what a column of a CSV maps: "intensity", "sa_0.3", "pga[%g]", "pgv[cm/s]", "mmi"; else None.

    Raises
    ------
    InputError
        A period out of range, or a peak without a unit that is known.
    """
    if column == "intensity":
        return MapField(column, JMA_INTENSITY, 1.0, -3.0, 9.0, "")
    if column == "mmi":
        return mercalli_field(column)
    if matched := _SA.fullmatch(column):
        return sa_field(column, float(matched[1]), 1.0, "g")
    if matched := _PEAK.fullmatch(column):
        return peak_field(column, matched[1], next(filter(None, matched.groups()[1:])))
    return None


def field_of_grid(name: str, unit: str) -> MapField | None:
    """Return what a field of a ShakeMap grid maps: MMI, PGA, PGV, PSA03 and the like; else None.

    Raises
    ------
    InputError
        A unit that is not known.
    """
    plain = name.lower()
    if plain == "mmi":
        return mercalli_field(name)
    if plain in ("pga", "pgv"):
        return peak_field(name, plain, unit)
    if matched := _PSA.fullmatch(plain):
        period = int(matched[1] + matched[2]) / 10.0
        return sa_field(name, period, _acceleration(name, unit) / STANDARD_GRAVITY, unit)
    return None


def mercalli_field(name: str) -> MapField:
    """Return the field of a modified Mercalli intensity."""
    return MapField(name, PGV, 1.0, 0.0, MERCALLI[1], "", mercalli=True)


def sa_field(name: str, period: float, factor: float, unit: str) -> MapField:
    """Return the field of a spectral acceleration whose numbers times a factor are in g."""
    low, high = PERIODS
    if not low <= period <= high:
        raise InputError("inventory.period", column=repr(name), period=period, low=low, high=high)
    return MapField(name, spectral_acceleration(period), factor, 1e-6 / factor, 10.0 / factor, unit)


def peak_field(name: str, peak: str, unit: str) -> MapField:
    """Return the field of a peak acceleration or velocity in a unit."""
    if peak == "pga":
        factor = _acceleration(name, unit)
        return MapField(name, PGA, factor, 1e-5 / factor, 100.0 / factor, unit)
    plain = unit.strip().lower()
    if plain not in _VELOCITIES:
        raise InputError("inventory_tables.map_unit", column=repr(name), known="cm/s, m/s")
    factor = _VELOCITIES[plain]
    return MapField(name, PGV, factor, 1e-6 / factor, 10.0 / factor, unit)


def _acceleration(name: str, unit: str) -> float:
    """Return the size of a unit [m/s²], per cent of g among them."""
    try:
        return unit_factor("%g" if unit.strip() == "%" else unit)
    except InputError:
        known = "%g, g, gal, cm/s², m/s²"
        raise InputError("inventory_tables.map_unit", column=repr(name), known=known) from None

"""Shake maps: what they say of each place, the levels that motions are scaled to by it, and their places."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, unknown, within
from stayput.fragility.intensity_measures import JMA_INTENSITY, PERIODS, PGA, PGV, spectral_acceleration
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.ground_shaking import MERCALLI_SCATTER
from stayput.motion.intensity import INTENSITY_RANGE, mercalli_rise, pgv_of_mercalli
from stayput.motion.response import DAMPING
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    from stayput.fragility.intensity_measures import IntensityMeasure

SCATTER_STEPS = 100
"""Into how many steps maps round the scatter of a level."""

MERCALLI = (2.0, 10.0)
"""Modified Mercalli intensities that a peak velocity is known for; lower ones are taken for the lowest."""

_SA = re.compile(r"sa_(\d{1,2}(?:\.\d{1,4})?)", re.ASCII)
_PEAK = re.compile(r"(pga|pgv)[ _]?(?:\[([^\]]+)\]|\(([^)]+)\)|([^\[( ].*))")
_PSA = re.compile(r"psa(\d)(\d)", re.ASCII)

_VELOCITIES = {"cm/s": 0.01, "cms": 0.01, "kine": 0.01, "m/s": 1.0}


class GroundLevel(NamedTuple):
    """How strong the ground shakes at a place by a map.

    Parameters
    ----------
    level : float
        The median level; see `stayput.montecarlo.scaled_motions`.
    scatter : float
        Its standard deviation.
    """

    level: float
    scatter: float = 0.0


def steps_of(measure: IntensityMeasure) -> int:
    """Return into how many steps maps round a level: 0.1 of intensity, 1/40 of a decade of anything else."""
    return 10 if measure.is_logarithm else 40


def distances(lat: float, lon: float, lats: ArrayLike, lons: ArrayLike) -> NDArray[np.float64]:
    """Return the angles between a place and others on a sphere [rad] (haversine formula).

    Parameters
    ----------
    lat, lon : float
        The place [°].
    lats, lons : array_like
        The others [°].
    """
    phi, others = np.radians(lat), np.radians(np.asarray(lats, np.float64))
    east = np.radians(np.asarray(lons, np.float64) - lon)
    a = np.sin(0.5 * (others - phi)) ** 2 + np.cos(phi) * np.cos(others) * np.sin(0.5 * east) ** 2
    return 2.0 * np.arcsin(np.sqrt(np.clip(a, 0.0, 1.0)))


def unwrapped(lons: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return longitudes in the turn in which their span is smallest: across the antimeridian, say [°]."""
    each = np.unique(lons % 360.0)
    if len(each) < len(np.unique(lons)):
        return lons
    gaps = np.diff(each, append=each[0] + 360.0)
    widest = int(np.argmax(gaps))
    if not 360.0 - gaps[widest] < np.ptp(lons) - 1e-9:
        return lons
    west = each[(widest + 1) % len(each)]
    start = west - 360.0 if west >= 180.0 else west
    return start + (lons - west) % 360.0


@dataclass(frozen=True, slots=True, eq=False)
class ShakeMap:
    """A shake map: levels of the ground's shaking at places.

    Parameters
    ----------
    measure : IntensityMeasure
        What it maps: JMA's intensity, a spectral acceleration, or a peak.
    lats, lons : ndarray
        Of a grid its latitudes and longitudes, both increasing; else of each place [°].
    levels : ndarray
        Its levels (see `stayput.montecarlo.scaled_motions`); shape (lats, lons) on a grid, else (places,).
        NaN where the map says nothing.
    scatters : ndarray, optional
        Their standard deviations, of the same shape, NaN where the map says nothing; none where they are
        not known.
    """

    measure: IntensityMeasure
    lats: NDArray[np.float64]
    lons: NDArray[np.float64]
    levels: NDArray[np.float64]
    scatters: NDArray[np.float64] | None = None

    @property
    def about(self) -> Phrase:
        """Description of what it maps."""
        if self.measure.is_logarithm:
            about = phrase("inventory_report.map_of_intensity")
        elif self.measure.period is None:
            about = phrase("inventory_report.map_of_peak", measure=self.measure.names)
        else:
            period, damping = f"{self.measure.period:g}", f"{100.0 * DAMPING:g}"
            about = phrase("inventory_report.map_of_sa", period=period, damping=damping)
        return about if self.scatters is None else phrase("inventory_report.with_scatter", about=about)

    def at(self, lat: float, lon: float) -> GroundLevel:
        """Return the level at a place, rounded: bilinear on a grid, else of the nearest place.

        Raises
        ------
        InputError
            The place lies outside the map, or where it says nothing.
        """
        west, east = float(self.lons.min()), float(self.lons.max())
        lon = next((turn for turn in (lon, lon - 360.0, lon + 360.0) if west <= turn <= east), lon)
        for name, value, values in (("lat", lat, self.lats), ("lon", lon, self.lons)):
            called = phrase("inventory.on_the_map", name=name)
            within(called, value, float(values.min()), float(values.max()), "°", name)
        level = self._value(self.levels, lat, lon)
        scatter = 0.0 if self.scatters is None else self._value(self.scatters, lat, lon)
        if math.isnan(level) or math.isnan(scatter):
            raise InputError("inventory_tables.map_is_silent", "lat", lat=lat, lon=lon)
        steps = steps_of(self.measure)
        return GroundLevel(round(level * steps) / steps, round(scatter * SCATTER_STEPS) / SCATTER_STEPS)

    def _value(self, values: NDArray[np.float64], lat: float, lon: float) -> float:
        if values.ndim == 1:
            return float(values[np.argmin(distances(lat, lon, self.lats, self.lons))])
        (i, u), (j, v) = _cell(self.lats, lat), _cell(self.lons, lon)
        corners = values[i : i + 2, j : j + 2]
        if np.isnan(corners[np.outer((1 - u, u), (1 - v, v)) > 0.0]).any():
            return math.nan
        (a, b), (c, d) = np.nan_to_num(corners)
        return float((1 - u) * ((1 - v) * a + v * b) + u * ((1 - v) * c + v * d))


def _cell(values: NDArray[np.float64], at: float) -> tuple[int, float]:
    place = int(np.clip(np.searchsorted(values, at, side="right") - 1, 0, len(values) - 2))
    return place, float((at - values[place]) / (values[place + 1] - values[place]))


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
        array = np.asarray(values, np.float64)
        if self.mercalli:
            each, places = np.unique(np.clip(array, *MERCALLI), return_inverse=True)
            peaks = [math.log10(pgv_of_mercalli(intensity)) for intensity in each.tolist()]
            return np.array(peaks)[places].reshape(array.shape)
        if self.measure.is_logarithm:
            return array
        return np.log10(np.maximum(self.factor * array, self.factor * self.low))

    def scatters(self, values: ArrayLike, deviations: ArrayLike | None) -> NDArray[np.float64] | None:
        """Return the standard deviations of the levels.

        Parameters
        ----------
        values : array_like
            The values.
        deviations : array_like, optional
            Their standard deviations: of an intensity itself, else of the natural logarithm.
        """
        array = None if deviations is None else np.asarray(deviations, np.float64)
        if self.mercalli:
            rise = mercalli_rise(np.clip(np.asarray(values, np.float64), *MERCALLI))
            return np.hypot(MERCALLI_SCATTER, (0.0 * rise if array is None else array) / rise)
        if array is None or self.measure.is_logarithm:
            return array
        return array / math.log(10.0)


def field_of(column: str) -> MapField | None:
    """Return what a column of a CSV maps: "intensity", "sa_0.3", "pga[%g]", "pgv[cm/s]", "mmi"; else None.

    Raises
    ------
    InputError
        A period out of range, or a peak without a unit that is known.
    """
    if column in ("intensity", "mmi"):
        return _field(column, column, "")
    if matched := _SA.fullmatch(column):
        return _field(column, "sa", "g", float(matched[1]))
    if matched := _PEAK.fullmatch(column):
        return _field(column, matched[1], next(filter(None, matched.groups()[1:])))
    return None


def field_of_grid(name: str, unit: str) -> MapField | None:
    """Return what a field of a ShakeMap grid maps: MMI, PGA, PGV, PSA03 and the like; else None.

    Raises
    ------
    InputError
        A unit that is not known.
    """
    if name.lower() in ("mmi", "pga", "pgv"):
        return _field(name, name.lower(), unit)
    matched = _PSA.fullmatch(name.lower())
    return None if matched is None else _field(name, "sa", unit, int(matched[1] + matched[2]) / 10.0)


def _field(name: str, kind: str, unit: str, period: float = 0.0) -> MapField:
    """Return a field of an intensity, a peak or a spectral acceleration, whose numbers have a unit."""
    if kind == "intensity":
        return MapField(name, JMA_INTENSITY, 1.0, *INTENSITY_RANGE, "")
    if kind == "mmi":
        return MapField(name, PGV, 1.0, 0.0, MERCALLI[1], "", mercalli=True)
    known = ("cm/s", "m/s") if kind == "pgv" else ("%g", "g", "gal", "cm/s²", "m/s²")
    try:
        if kind == "pgv":
            factor = _VELOCITIES[unit.strip().lower()]
        else:
            factor = unit_factor("%g" if unit.strip() == "%" else unit)
    except (InputError, KeyError):
        raise unknown(phrase("inventory_tables.unit_of", name=name), unit, known) from None
    measure, low, high = (PGA, 1e-5, 100.0) if kind == "pga" else (PGV, 1e-6, 10.0)
    if kind == "sa":
        within(phrase("inventory.period", column=repr(name)), period, *PERIODS, "s")
        measure, factor = spectral_acceleration(period), factor / STANDARD_GRAVITY
    return MapField(name, measure, factor, low / factor, high / factor, unit)

"""Places of an inventory: the nearest station, and shake maps."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, within
from stayput.motion.spectrum import DAMPING

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from stayput.catalogue import Phrase
    from stayput.fragility import IntensityMeasure

PLACE = ("lat", "lon")
LIMITS = ((-90.0, 90.0, "°"), (-180.0, 360.0, "°"))

SCATTER_STEPS = 100
"""Into how many steps maps round the scatter of a level."""


class GroundLevel(NamedTuple):
    """How strong the ground shakes at a place by a map.

    Parameters
    ----------
    level : float
        The median level; see `stayput.montecarlo.hazard`.
    scatter : float
        Its standard deviation.
    """

    level: float
    scatter: float = 0.0


def steps_of(measure: IntensityMeasure) -> int:
    """Return into how many steps maps round a level: 0.1 of intensity, 1/40 of a decade of anything else."""
    return 10 if measure.is_logarithm else 40


def measure_about(measure: IntensityMeasure) -> Phrase:
    """Return a description of a map's measure."""
    if measure.is_logarithm:
        return phrase("inventory_report.map_of_intensity")
    if measure.period is None:
        return phrase("inventory_report.map_of_peak", measure=measure.names)
    damping = f"{100.0 * DAMPING:g}"
    return phrase("inventory_report.map_of_sa", period=f"{measure.period:g}", damping=damping)


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
        Its levels (see `stayput.montecarlo.hazard`); shape (lats, lons) on a grid, else (places,). NaN where
        the map says nothing.
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
        about = measure_about(self.measure)
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
        return GroundLevel(
            round(level * steps) / steps,
            round(scatter * SCATTER_STEPS) / SCATTER_STEPS,
        )

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

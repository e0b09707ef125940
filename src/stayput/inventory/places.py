"""Places of an inventory: the nearest station, and shake maps."""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase, say
from stayput.errors import InputError, reason_of, within
from stayput.fragility import JMA_INTENSITY, spectral_acceleration
from stayput.fragility.intensity_measures import PERIODS
from stayput.montecarlo.hazard import level_of
from stayput.motion.spectrum import DAMPING

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import ArrayLike, NDArray

    from stayput.fragility import IntensityMeasure

PLACE = ("lat", "lon")
LIMITS = ((-90.0, 90.0, "°"), (-180.0, 360.0, "°"))

_SA = re.compile(r"sa_(\d{1,2}(?:\.\d{1,4})?)", re.ASCII)


def measure_of(column: str) -> IntensityMeasure | None:
    """Return the measure of a map's column, "intensity" or "sa_0.3", or None where it is another column.

    Raises
    ------
    InputError
        A period out of range.
    """
    if column == "intensity":
        return JMA_INTENSITY
    matched = _SA.fullmatch(column)
    if matched is None:
        return None
    period = float(matched[1])
    if not PERIODS[0] <= period <= PERIODS[1]:
        low, high = PERIODS
        raise InputError("inventory.period", column=repr(column), period=period, low=low, high=high)
    return spectral_acceleration(period)


def _value_limits(measure: IntensityMeasure) -> tuple[float, float, str]:
    """Return the smallest and the largest value of a measure in a map, and their unit."""
    return (-3.0, 9.0, "") if measure.period is None else (1e-6, 10.0, "g")


def steps_of(measure: IntensityMeasure) -> int:
    """Return into how many steps maps round a level: 0.1 of intensity, 1/40 of a decade of Sa."""
    return 10 if measure.period is None else 40


def measure_about(measure: IntensityMeasure) -> str:
    """Return a description of a map's measure."""
    if measure.period is None:
        return say("inventory_report.map_of_intensity")
    damping = f"{100.0 * DAMPING:g}"
    return say("inventory_report.map_of_sa", period=f"{measure.period:g}", damping=damping)


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


@dataclass(frozen=True, slots=True, eq=False)
class ShakeMap:
    """A shake map: levels of the ground's shaking at places.

    Parameters
    ----------
    measure : IntensityMeasure
        What it maps: JMA's intensity or a spectral acceleration.
    lats, lons : ndarray
        Of a grid its latitudes and longitudes, both increasing; else of each place [°].
    levels : ndarray
        Its levels (see `stayput.montecarlo.hazard`); shape (lats, lons) on a grid, else (places,).
    """

    measure: IntensityMeasure
    lats: NDArray[np.float64]
    lons: NDArray[np.float64]
    levels: NDArray[np.float64]

    def at(self, lat: float, lon: float) -> float:
        """Return the level at a place, rounded: bilinear on a grid, else of the nearest place.

        Raises
        ------
        InputError
            The place lies outside the map.
        """
        for name, value, values in (("lat", lat, self.lats), ("lon", lon, self.lons)):
            called = phrase("inventory.on_the_map", name=name)
            within(called, value, float(values.min()), float(values.max()), "°", name)
        if self.levels.ndim == 1:
            level = float(self.levels[np.argmin(distances(lat, lon, self.lats, self.lons))])
        else:
            level = self._bilinear(lat, lon)
        steps = steps_of(self.measure)
        return round(level * steps) / steps

    def _bilinear(self, lat: float, lon: float) -> float:
        (i, u), (j, v) = _cell(self.lats, lat), _cell(self.lons, lon)
        (a, b), (c, d) = self.levels[i : i + 2, j : j + 2]
        return float((1 - u) * ((1 - v) * a + v * b) + u * ((1 - v) * c + v * d))


def _cell(values: NDArray[np.float64], at: float) -> tuple[int, float]:
    place = int(np.clip(np.searchsorted(values, at, side="right") - 1, 0, len(values) - 2))
    return place, float((at - values[place]) / (values[place + 1] - values[place]))


def read_shakemap(path: Path) -> ShakeMap:
    """Read a shake map: CSV of lat, lon and intensity or Sa, on a regular grid or at any places.

    Raises
    ------
    InputError
        A file that cannot be read, another header, a value out of range, a place twice, or no row.
    """
    rows: dict[tuple[float, float], tuple[int, float]] = {}
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            reader: Any = csv.reader(file)
            nothing: list[str] = []
            first: list[str] = next(reader, nothing)
            header = [name.strip().lower() for name in first]
            measure, column = _measure(header)
            columns = [header.index(name) for name in (*PLACE, column)]
            for number, row in enumerate(reader, 2):
                if any(cell.strip() for cell in row):
                    lat, lon, value = _checked(number, row, columns, column, measure)
                    before, _ = rows.setdefault((lat, lon), (number, level_of(measure, value)))
                    if before != number:
                        raise InputError(
                            "inventory.map_place_twice", row=number, lat=lat, lon=lon, before=before
                        )
    except OSError as error:
        reason = reason_of(error)
        file = phrase("inventory.the_shake_map")
        raise InputError("inventory.unreadable", file=file, path=repr(str(path)), reason=reason) from None
    except (UnicodeDecodeError, csv.Error):
        raise InputError("inventory.map_not_csv", "shakemap", path=repr(str(path))) from None
    if not rows:
        raise InputError("inventory.map_empty", "shakemap", path=repr(str(path)))
    lat, lon = np.array(list(rows)).T
    levels = np.array([level for _, level in rows.values()])
    lats, lons = np.unique(lat), np.unique(lon)
    if min(len(lats), len(lons)) < 2 or len(lats) * len(lons) != len(rows):
        return ShakeMap(measure, lat, lon, levels)
    grid = np.empty((len(lats), len(lons)))
    grid[np.searchsorted(lats, lat), np.searchsorted(lons, lon)] = levels
    return ShakeMap(measure, lats, lons, grid)


def _measure(header: list[str]) -> tuple[IntensityMeasure, str]:
    measures = [(measure, name) for name in header if (measure := measure_of(name)) is not None]
    if len(measures) != 1 or sorted(header) != sorted((*PLACE, measures[0][1])):
        columns = ", ".join(header) or phrase("inventory.of_an_empty_file")
        raise InputError("inventory.map_columns", "shakemap", columns=columns)
    return measures[0]


def _read(cell: str) -> Any:
    """Return the number in a cell; a text that is none, as it is, which is refused then."""
    try:
        return float(cell)
    except ValueError:
        return cell


def _checked(
    number: int, row: list[str], columns: list[int], name: str, measure: IntensityMeasure
) -> tuple[float, ...]:
    if len(row) != len(columns):
        raise InputError("inventory.map_cells", row=number, cells=len(row), columns=len(columns))
    limits = (*LIMITS, _value_limits(measure))
    return tuple(
        within(phrase("inventory.in_row_of_the_map", name=column, row=number), _read(row[place]), *limit)
        for column, place, limit in zip((*PLACE, name), columns, limits, strict=True)
    )

"""Where pieces stand: the nearest station, and the intensity of a map."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError, within

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import ArrayLike, NDArray

STEP = 0.1
"""Step to which intensities from a map are rounded: that in which JMA announces them."""

NAMES = ("lat", "lon", "intensity")


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
    """JMA intensities of the ground at places.

    Parameters
    ----------
    lats, lons : ndarray
        Of a grid its latitudes and longitudes, both increasing; else of each place [°].
    intensities : ndarray
        Shape (lats, lons) on a grid, else (places,).
    """

    lats: NDArray[np.float64]
    lons: NDArray[np.float64]
    intensities: NDArray[np.float64]

    def at(self, lat: float, lon: float) -> float:
        """Return the intensity at a place, rounded to `STEP`: bilinear on a grid, else of the nearest place.

        Raises
        ------
        InputError
            The place lies outside the map.
        """
        for name, value, of in (("lat", lat, self.lats), ("lon", lon, self.lons)):
            within(f"{name} on the shake map", value, float(of.min()), float(of.max()), "°")
        if self.intensities.ndim == 1:
            found = float(self.intensities[np.argmin(distances(lat, lon, self.lats, self.lons))])
        else:
            found = self._bilinear(lat, lon)
        return round(round(found / STEP) * STEP, 1)

    def _bilinear(self, lat: float, lon: float) -> float:
        (i, u), (j, v) = _cell(self.lats, lat), _cell(self.lons, lon)
        (a, b), (c, d) = self.intensities[i : i + 2, j : j + 2]
        return float((1 - u) * ((1 - v) * a + v * b) + u * ((1 - v) * c + v * d))


def _cell(values: NDArray[np.float64], at: float) -> tuple[int, float]:
    place = int(np.clip(np.searchsorted(values, at, side="right") - 1, 0, len(values) - 2))
    return place, float((at - values[place]) / (values[place + 1] - values[place]))


def read_shakemap(path: Path) -> ShakeMap:
    """Read a shake map: a CSV file of lat, lon and intensity, on a regular grid or at any places.

    Raises
    ------
    InputError
        A file that cannot be read, another header, a value out of range, or no row.
    """
    rows: list[tuple[float, ...]] = []
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            reader: Any = csv.reader(file)
            nothing: list[str] = []
            first: list[str] = next(reader, nothing)
            header = [name.strip().lower() for name in first]
            if sorted(header) != sorted(NAMES):
                raise InputError(f"The shake map has the columns {header}; they must be lat, lon, intensity.")
            places = [header.index(name) for name in NAMES]
            for number, row in enumerate(reader, 2):
                if any(cell.strip() for cell in row):
                    rows.append(_checked(number, row, places))
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"The shake map is {str(path)!r}; it could not be read: {reason}.") from None
    except (UnicodeDecodeError, csv.Error):
        raise InputError(f"The shake map is {str(path)!r}; it must be CSV, a text in UTF-8.") from None
    if not rows:
        raise InputError(f"The shake map is {str(path)!r}; it must have at least one place.")
    lat, lon, values = np.array(rows).T
    lats, lons = np.unique(lat), np.unique(lon)
    if min(len(lats), len(lons)) < 2 or len(lats) * len(lons) != len(rows):
        return ShakeMap(lat, lon, values)
    grid = np.full((len(lats), len(lons)), np.nan)
    grid[np.searchsorted(lats, lat), np.searchsorted(lons, lon)] = values
    return ShakeMap(lat, lon, values) if np.isnan(grid).any() else ShakeMap(lats, lons, grid)


def _checked(number: int, row: list[str], places: list[int]) -> tuple[float, ...]:
    limits = ((-90.0, 90.0), (-180.0, 360.0), (-3.0, 9.0))
    if len(row) != len(NAMES):
        raise InputError(f"Row {number} of the shake map has {len(row)} cells; it must have {len(NAMES)}.")
    return tuple(
        within(f"{name} in row {number} of the shake map", row[place], *limit)  # type: ignore[arg-type]
        for name, place, limit in zip(NAMES, places, limits, strict=True)
    )

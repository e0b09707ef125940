"""Where pieces stand: the nearest station, and how strong a shake map says that the ground shakes there."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError, within
from stayput.inventory.strength import Strength

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import ArrayLike, NDArray

PLACE = ("lat", "lon")
LIMITS = ((-90.0, 90.0, "°"), (-180.0, 360.0, "°"))


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
    """How strongly the ground shakes at places.

    Parameters
    ----------
    strength : Strength
        What is told.
    lats, lons : ndarray
        Of a grid its latitudes and longitudes, both increasing; else of each place [°].
    levels : ndarray
        Its levels; shape (lats, lons) on a grid, else (places,).
    """

    strength: Strength
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
        for name, value, of in (("lat", lat, self.lats), ("lon", lon, self.lons)):
            within(f"{name} on the shake map", value, float(of.min()), float(of.max()), "°")
        if self.levels.ndim == 1:
            found = float(self.levels[np.argmin(distances(lat, lon, self.lats, self.lons))])
        else:
            found = self._bilinear(lat, lon)
        return self.strength.rounded(found)

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
            strength, column = _strength(header)
            columns = [header.index(name) for name in (*PLACE, column)]
            for number, row in enumerate(reader, 2):
                if any(cell.strip() for cell in row):
                    lat, lon, value = _checked(number, row, columns, column, strength)
                    before, _ = rows.setdefault((lat, lon), (number, strength.level(value)))
                    if before != number:
                        raise InputError(
                            f"Row {number} of the shake map is at {lat:g}°, {lon:g}°, as row {before} is; "
                            "each place must be there once."
                        )
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"The shake map is {str(path)!r}; it could not be read: {reason}.") from None
    except (UnicodeDecodeError, csv.Error):
        raise InputError(f"The shake map is {str(path)!r}; it must be CSV, a text in UTF-8.") from None
    if not rows:
        raise InputError(f"The shake map is {str(path)!r}; it must have at least one place.")
    lat, lon = np.array(list(rows)).T
    levels = np.array([level for _, level in rows.values()])
    lats, lons = np.unique(lat), np.unique(lon)
    if min(len(lats), len(lons)) < 2 or len(lats) * len(lons) != len(rows):
        return ShakeMap(strength, lat, lon, levels)
    grid = np.empty((len(lats), len(lons)))
    grid[np.searchsorted(lats, lat), np.searchsorted(lons, lon)] = levels
    return ShakeMap(strength, lats, lons, grid)


def _strength(header: list[str]) -> tuple[Strength, str]:
    told = [(found, name) for name in header if (found := Strength.of(name)) is not None]
    if len(told) != 1 or sorted(header) != sorted((*PLACE, told[0][1])):
        raise InputError(
            f"The shake map has the columns {', '.join(header) or 'of an empty file'}; they must be lat, lon "
            "and one of intensity (JMA's) and sa_T, Sa [g] at 5 % damping at a period T [s], such as sa_0.3."
        )
    return told[0]


def _checked(
    number: int, row: list[str], columns: list[int], name: str, strength: Strength
) -> tuple[float, ...]:
    if len(row) != len(columns):
        raise InputError(f"Row {number} of the shake map has {len(row)} cells; it must have {len(columns)}.")
    return tuple(
        within(f"{told} in row {number} of the shake map", row[place], *limits)  # type: ignore[arg-type]
        for told, place, limits in zip((*PLACE, name), columns, (*LIMITS, strength.limits), strict=True)
    )

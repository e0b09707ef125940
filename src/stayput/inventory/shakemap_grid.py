"""Reading the grids of USGS ShakeMap: grid.xml and uncertainty.xml.

The file is read as a stream with bounds on its size. A document type, by which XML names entities that grow
or lie in other files, is refused before anything of it is looked at.
"""

from __future__ import annotations

import re
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any
from xml.parsers import expat

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, quoted
from stayput.inventory.cells import number_or_none
from stayput.inventory.places import unwrapped

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

LARGEST_FILE = 2**30
"""Most bytes of a map."""

MOST_POINTS = 10_000_000
"""Most places of a grid."""

MOST_FIELDS = 60
"""Most fields of a grid."""

COMPRESSED = (b"\x1f\x8b", b"PK\x03\x04", b"BZh", b"\xfd7zXZ\x00")
"""How files of gzip, ZIP, bzip2 and xz begin."""

_CHUNK = 2**20


@dataclass(frozen=True, slots=True, eq=False)
class MapGrid:
    """A grid of places.

    Parameters
    ----------
    lats, lons : ndarray
        Its latitudes and longitudes, both increasing [°].
    values : dict
        Each field, shape (lats, lons).
    units : dict
        The unit of each field, as it is stated.
    event : str
        The earthquake and the version of its map, as they are stated; "" where they are not.
    """

    lats: NDArray[np.float64]
    lons: NDArray[np.float64]
    values: dict[str, NDArray[np.float64]]
    units: dict[str, str]
    event: str = ""


class _Reader:
    """Takes in a grid as a parser gives it."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.size: dict[str, int] = {}
        self.fields: dict[int, tuple[str, str]] = {}
        self.parts: list[NDArray[np.float64]] = []
        self.count = 0
        self.in_data = self.is_grid = False
        self.text = self.event = ""

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Take in that an element starts."""
        match tag.rpartition(":")[2]:
            case "shakemap_grid":
                self.is_grid = True
                parts = (attributes.get(name, "").strip() for name in ("event_id", "shakemap_version"))
                self.event = ", version ".join(part for part in parts if part)
            case "grid_specification":
                if self.size:
                    raise self.refused("twice")
                for axis in ("lon", "lat"):
                    self._spacing(attributes, f"nominal_{axis}_spacing")
                self.size = {name: self._whole(attributes, name) for name in ("nlon", "nlat")}
                if min(self.size.values()) < 2 or self.size["nlon"] * self.size["nlat"] > MOST_POINTS:
                    raise self.refused("size", **self.size, most=MOST_POINTS)
            case "grid_field":
                name, unit = (attributes.get(key, "") for key in ("name", "units"))
                self.fields[self._whole(attributes, "index")] = name, unit
                if len(self.fields) > MOST_FIELDS:
                    raise self.refused("fields", most=MOST_FIELDS)
            case "grid_data":
                self.in_data = True
            case _:
                pass

    def end(self, tag: str) -> None:
        """Take in that an element ends."""
        if tag.rpartition(":")[2] == "grid_data":
            self._take(self.text)
            self.text, self.in_data = "", False

    def data(self, text: str) -> None:
        """Take in text: numbers with blanks between them."""
        if not self.in_data:
            return
        self.text += text
        if len(self.text) > _CHUNK:
            whole, blank, self.text = self.text.rpartition("\n")
            if not blank:
                raise self.refused("line")
            self._take(whole)

    def _take(self, text: str) -> None:
        try:
            numbers = np.array(list(map(float, text.replace("_", "?").split())))  # Python takes 5_0 for 50
        except ValueError:
            raise self.refused("numbers") from None
        self.count += len(numbers)
        if self.count > self.size.get("nlon", 0) * self.size.get("nlat", 0) * len(self.fields):
            raise self.refused("more" if self.size else "kind")
        self.parts.append(numbers)

    def _whole(self, attributes: dict[str, str], name: str) -> int:
        value = attributes.get(name, "")
        if re.fullmatch(r"-?\d{1,9}", value, re.ASCII) is None:
            raise self.refused("whole", name=name, value=quoted(value))
        return int(value)

    def _spacing(self, attributes: dict[str, str], name: str) -> None:
        value = attributes.get(name)
        if value is not None and not (number_or_none(value) or 0.0) > 0.0:
            raise self.refused("spacing", name=name, value=quoted(value))

    def refused(self, key: str, **values: object) -> InputError:
        """Return the refusal of the file."""
        reason = phrase(f"inventory_tables.grid_{key}", **values)
        return InputError("inventory_tables.grid", "shakemap", path=repr(str(self.path)), reason=reason)

    def grid(self) -> MapGrid:
        """Return the grid."""
        names = [name.strip().upper() for _, (name, _) in sorted(self.fields.items())]
        named = {"LAT", "LON"} <= set(names) and len(set(names)) == len(names)
        if not (self.is_grid and self.size and named):
            raise self.refused("kind")
        rows, columns = self.size["nlat"], self.size["nlon"]
        if self.count != rows * columns * len(names):
            raise self.refused("count", count=self.count, due=rows * columns * len(names))
        values = np.concatenate(self.parts).reshape(rows, columns, len(names))
        fields = {name: values[:, :, n] for n, name in enumerate(names)}
        lat, lon = fields.pop("LAT"), fields.pop("LON")
        lats, lons = lat[:, 0], lon[0]
        if not (np.abs(lats).max() <= 90.0 and np.abs(lons).max() <= 360.0):
            raise self.refused("degrees")
        if not (np.all(lat == lats[:, None]) and np.all(lon == lons)):
            raise self.refused("irregular")
        lons = unwrapped(lons)
        down, left = (-1 if axis[-1] < axis[0] else 1 for axis in (lats, lons))
        lats, lons = lats[::down], lons[::left]
        if not (np.all(np.diff(lats) > 0.0) and np.all(np.diff(lons) > 0.0)):
            raise self.refused("irregular")
        units = {name.strip().upper(): unit for name, unit in self.fields.values()}
        turned = {name: np.ascontiguousarray(field[::down, ::left]) for name, field in fields.items()}
        return MapGrid(lats, lons, turned, units, self.event)


def is_xml(path: Path) -> bool:
    """Return whether a file begins as XML does, in UTF-8 or, after a byte order mark, UTF-16."""
    with path.open("rb") as file:
        start = file.read(64)
    encoding = "utf-16" if start.startswith((BOM_UTF16_LE, BOM_UTF16_BE)) else "utf-8-sig"
    return start.decode(encoding, "ignore").lstrip().startswith("<")


def check_file(path: Path) -> None:
    """Refuse a file that is too large, or compressed, such as grid.xml.gz."""
    if (size := path.stat().st_size) > LARGEST_FILE:
        raise InputError(
            "inventory_tables.large_map", "shakemap", path=repr(str(path)), size=size, most=LARGEST_FILE
        )
    with path.open("rb") as file:
        start = file.read(8)
    if start.startswith(COMPRESSED):
        raise InputError("inventory_tables.compressed", "shakemap", path=repr(str(path)))


def read_grid(path: Path) -> MapGrid:
    """Read a grid of ShakeMap.

    Raises
    ------
    InputError
        No such grid, a broken one, or one with a document type.
    """
    reader = _Reader(path)

    def refused(*_: object) -> None:
        raise reader.refused("doctype")

    parser: Any = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = reader.start, reader.end
    parser.CharacterDataHandler = reader.data
    parser.StartDoctypeDeclHandler = refused
    parser.buffer_text, parser.buffer_size = True, _CHUNK
    try:
        with path.open("rb") as file:
            while chunk := file.read(_CHUNK):
                parser.Parse(chunk, False)
        parser.Parse(b"", True)
        return reader.grid()
    except InputError:
        raise
    except (ValueError, LookupError):
        raise reader.refused("encoding") from None
    except expat.ExpatError as error:
        raise reader.refused("broken", said=str(error)[:200]) from None

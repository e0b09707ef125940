"""Reading the grids of USGS ShakeMap: grid.xml and uncertainty.xml.

The file is read as a stream with bounds on its size. A document type, by which XML names entities that grow
or lie in other files, is refused before anything of it is looked at.
"""

from __future__ import annotations

from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any
from xml.parsers import expat

import numpy as np

from stayput.errors import InputError
from stayput.inventory.places import unwrapped

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

LARGEST_FILE = 2**30
"""Most bytes of a grid."""

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

    def __init__(self) -> None:
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
                self.size = {name: int(attributes[name]) for name in ("nlon", "nlat")}
                if min(self.size.values()) < 2 or self.size["nlon"] * self.size["nlat"] > MOST_POINTS:
                    raise ValueError(
                        f"it has {self.size['nlon']} by {self.size['nlat']} places; they must be 2 by 2 at "
                        f"least, and {MOST_POINTS:,} at most"
                    )
            case "grid_field":
                self.fields[int(attributes["index"])] = attributes["name"], attributes.get("units", "")
                if len(self.fields) > MOST_FIELDS:
                    raise ValueError(f"it has more than {MOST_FIELDS} fields")
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
                raise ValueError("it has a line that does not end")
            self._take(whole)

    def _take(self, text: str) -> None:
        if "_" in text:  # which Python takes between digits
            raise ValueError("it has a number with an underscore")
        numbers = np.array(list(map(float, text.split())))
        self.count += len(numbers)
        if self.count > self.size.get("nlon", 0) * self.size.get("nlat", 0) * len(self.fields):
            raise ValueError("it has more numbers than places")
        self.parts.append(numbers)

    def grid(self) -> MapGrid:
        """Return the grid."""
        names = [name.strip().upper() for _, (name, _) in sorted(self.fields.items())]
        rows, columns = self.size.get("nlat", 0), self.size.get("nlon", 0)
        if not self.is_grid or not {"LAT", "LON"} <= set(names) or len(set(names)) < len(names):
            raise ValueError("it must be a shakemap_grid with the fields LON and LAT, each field once")
        if self.count != rows * columns * len(names):
            raise ValueError(f"it has {self.count} numbers; it must have {rows * columns * len(names)}")
        values = np.concatenate(self.parts).reshape(rows, columns, len(names))
        fields = {name: values[:, :, n] for n, name in enumerate(names)}
        lat, lon = fields.pop("LAT"), fields.pop("LON")
        lats, lons = lat[:, 0], lon[0]
        if not (np.abs(lats).max() <= 90.0 and np.abs(lons).max() <= 360.0):
            raise ValueError("its places are no latitudes and longitudes")
        if not (np.all(lat == lats[:, None]) and np.all(lon == lons)):
            raise ValueError("its places are no regular grid")
        lons = unwrapped(lons)
        down, left = (-1 if axis[-1] < axis[0] else 1 for axis in (lats, lons))
        lats, lons = lats[::down], lons[::left]
        if not (np.all(np.diff(lats) > 0.0) and np.all(np.diff(lons) > 0.0)):
            raise ValueError("its places are no regular grid")
        units = {name.strip().upper(): unit for name, unit in self.fields.values()}
        turned = {name: np.ascontiguousarray(field[::down, ::left]) for name, field in fields.items()}
        return MapGrid(lats, lons, turned, units, self.event)


def is_xml(path: Path) -> bool:
    """Return whether a file begins as XML does, in UTF-8 or, after a byte order mark, UTF-16."""
    with path.open("rb") as file:
        start = file.read(64)
    encoding = "utf-16" if start.startswith((BOM_UTF16_LE, BOM_UTF16_BE)) else "utf-8-sig"
    return start.decode(encoding, "ignore").lstrip().startswith("<")


def refuse_compressed(path: Path) -> None:
    """Refuse a file that is compressed, such as grid.xml.gz."""
    with path.open("rb") as file:
        start = file.read(8)
    if start.startswith(COMPRESSED):
        raise InputError("inventory_tables.compressed", "shakemap", path=repr(str(path)))


def read_grid(path: Path) -> MapGrid:
    """Read a grid of ShakeMap.

    Raises
    ------
    InputError
        A file that is too large, no such grid, broken, or with a document type.
    """
    reader = _Reader()

    def refused(*_: object) -> None:
        raise ValueError("it declares a document type, which may hold anything")

    parser: Any = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = reader.start, reader.end
    parser.CharacterDataHandler = reader.data
    parser.StartDoctypeDeclHandler = refused
    parser.buffer_text, parser.buffer_size = True, _CHUNK
    try:
        size = path.stat().st_size
        if size > LARGEST_FILE:
            raise ValueError(f"it has {size:,} bytes; it must have {LARGEST_FILE:,} at most")
        with path.open("rb") as file:
            while chunk := file.read(_CHUNK):
                parser.Parse(chunk, False)
        parser.Parse(b"", True)
        return reader.grid()
    except (ValueError, KeyError, expat.ExpatError) as error:
        reason = f"it lacks {error}" if isinstance(error, KeyError) else str(error)[:300]
        raise InputError("inventory_tables.grid", "shakemap", path=repr(str(path)), reason=reason) from None

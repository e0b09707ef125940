"""The columns of an inventory: what tables in use call them, the units of their numbers, and ``--columns``.

Furniture is measured in width, depth and height, as it is seen from the front; a piece falls to its front.
So the column ``width``, the size along the shaking, is what an inventory calls the depth (奥行), and
``length`` is what an inventory calls the width (幅), the size along the wall.
"""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, cast

from stayput.catalogue import phrase
from stayput.errors import InputError, not_allowed, quoted, shown, unknown
from stayput.files import named_columns
from stayput.inventory.folder import unreadable
from stayput.scenario.toml import read_toml


class NumberUnit(NamedTuple):
    """A unit of a column: a number in it times ``times`` and over ``over`` is in the column's own.

    Of money, ``currency`` says which.
    """

    name: str
    times: float = 1.0
    over: float = 1.0
    currency: str = ""


class Column(NamedTuple):
    """A column: the unit of its numbers, and what else it is called, each as `plain_name` gives it."""

    unit: str = ""
    aliases: tuple[str, ...] = ()


TOTAL_MASSES = ("total weight", "total mass", "gross weight", "gross mass", "総重量", "総質量")
"""Masses that may be with what is inside, or of all pieces of a row."""

# fmt: off
COLUMNS: dict[str, Column] = {
    "id": Column("", (
        "no", "asset id", "asset no", "asset number", "asset tag", "asset tag no", "tag", "tag no",
        "item id", "item no", "item number", "inventory no",
        "番号", "管理番号", "資産番号", "備品番号", "固定資産番号", "通し番号", "連番",
    )),
    "name": Column("", (
        "item", "item name", "furniture", "furniture type", "description", "type", "kind",
        "品名", "名称", "物品名", "家具", "家具名", "備品名", "什器名", "種類", "種別", "家具の種類",
    )),
    "preset": Column("", ("プリセット",)),
    "width": Column("m", ("depth", "d", "outer depth", "奥行", "奥行き", "奥行寸法")),
    "length": Column("m"),
    "height": Column("m", ("h", "outer height", "高さ", "高", "全高", "高さ寸法")),
    "mass": Column("kg", ("weight", "wt", "重量", "質量", "重さ", "製品重量", "本体重量", *TOTAL_MASSES)),
    "cg_offset": Column("m"),
    "load": Column("kg"),
    "contents": Column("", ("収納物", "内容物")),
    "doors": Column(),
    "drawers": Column(),
    "lip": Column("m"),
    "floor": Column("", ("surface", "flooring", "floor surface", "floor finish", "床", "床材", "床仕上げ")),
    "gap": Column("m", (
        "gap to wall", "wall gap", "distance to wall",
        "すき間", "隙間", "壁との距離", "壁からの距離", "壁との隙間",
    )),
    "wall": Column("", ("wall type", "壁", "壁の下地", "壁下地")),
    "building": Column("", (
        "building name", "bldg", "建物", "建物名", "建物名称", "建屋", "棟", "棟名", "校舎", "校舎名",
    )),
    "storey": Column("", (
        "story", "level", "lvl", "floor level", "floor no", "floor number", "階", "設置階", "フロア", "階層",
    )),
    "fixed": Column("", (
        "anchored", "anchorage", "secured", "fixing",
        "固定", "固定状況", "固定の有無", "固定方法", "耐震固定", "転倒防止", "転倒防止対策", "耐震対策",
    )),
    "measures": Column(),
    "costs": Column("currency"),
    "count": Column("", (
        "qty", "q'ty", "quantity", "pcs", "pieces", "units", "no of units", "no of pieces", "number of units",
        "number of pieces", "数量", "個数", "台数", "員数", "本数", "点数", "数",
    )),
    "value": Column("currency", (
        "price", "unit price", "total price", "total value",
        "価格", "単価", "価額", "取得価額", "取得価格", "金額", "取得金額", "合計金額", "総額",
    )),
    "lat": Column("°", ("latitude", "緯度")),
    "lon": Column("°", ("lng", "long", "longitude", "経度")),
}
"""Columns of an inventory."""
# fmt: on

LISTS = ("cg_offset", "load", "costs", "floor")
"""Columns whose cells hold numbers with semicolons between them."""

WIDTHS = ("width", "w", "outer width", "幅", "巾", "横幅", "間口", "幅寸法")
"""What inventories call the size along the wall, beside a depth."""

ALONG_THE_WALL = (*WIDTHS, "length", "l", "長さ")
"""What inventories call the size along the wall, which is across the shaking."""

TOTALS = ("total price", "total value", "金額", "取得金額", "合計金額", "総額")
"""Columns that may hold the value of all pieces of a row."""

RACK_UNITS = ("u height", "height u", "rack units", "rack height", "u数", "ユニット数")
"""What tables of racks call a height in rack units."""

OPEN_EXPOSURE_DATA = ("accnumber", "locnumber", "buildingtiv", "contentstiv", "occupancycode")
"""Columns of a table of buildings in Open Exposure Data."""

LOOKS_LIKE_COUNT = re.compile(
    r"(?:.*\b)?(?:qty|quant\w*|counts?|pcs|pieces|(?<!desc )units|number of \w+|no of \w+|how many)\b.*"
    r"|number|amount|(?:grand )?total|qn?t|qnty|cnt|amt|nb|items|sets|(?:.*\b)?on hand|multiplier|repli\w+"
    r"|(?:.*\b)?(?:copies|ea|each|nos|q'?ty)|num(?: .*)?|(?:(?:in|current|total) )?stock(?: on hand)?"
    r"|anzahl|menge|stück(?:zahl)?|stk|nombre|cantidad"
    r"|.*(?:数量|個数|台数|員数|本数|点数|総数|在庫数|設置数|保有数|脚数).*"
    r"|.*(?<![年月日階段人回係指])[数數]|在庫|[台個脚本点基組架面]|セット|合計|計|小計|b?\d+[f階]|地下\d*階?"
)
"""Columns that seem to say how many pieces a row stands for; years of use (耐用年数), storeys (階数), shelves
(段数) and people (人数) are none."""

TOTAL_ROW = re.compile(r"(?:grand |sub ?)?totals?|sum|gesamt|summe|[合小総]?計")
"""What a row is called that is the sum of others."""

LOOKS_LIKE_SIZE = re.compile(
    r"縦|横|丈|長辺|短辺|厚[さみ]|直?径"
    r"|sizes?|dimensions?|dims?|measurements|.*寸法|サイズ|.*(?:w|幅) ?[x×*] ?(?:d|奥行き?|h|高さ?).*"
)
"""Columns that seem to be a size, and do not say whether along the wall, from front to back or upwards, or
that hold several in a cell."""

UNITS: dict[str, dict[str, NumberUnit]] = {
    kind: {name: unit for names, unit in units.items() for name in names}
    for kind, units in {
        "m": {
            ("mm", "millimetre", "millimetres", "millimeters", "ミリ"): NumberUnit("mm", over=1000.0),
            ("cm", "centimetre", "centimetres", "centimeters", "センチ"): NumberUnit("cm", over=100.0),
            ("m", "metre", "metres", "meter", "meters", "メートル"): NumberUnit("m"),
            ("in", "inch", "inches", '"', "インチ"): NumberUnit("in", 254.0, 10_000.0),
            ("ft", "foot", "feet"): NumberUnit("ft", 3048.0, 10_000.0),
            ("u", "ru"): NumberUnit("U", 4445.0, 100_000.0),  # of racks (IEC 60297)
        },
        "kg": {
            ("kg", "kgs", "キロ", "キログラム"): NumberUnit("kg"),
            ("g", "グラム"): NumberUnit("g", over=1000.0),
            ("t", "トン"): NumberUnit("t", 1000.0),
            ("lb", "lbs", "pound", "pounds", "ポンド"): NumberUnit("lb", 45_359_237.0, 100_000_000.0),
        },
        "currency": {
            ("円", "yen", "jpy", "¥"): NumberUnit("JPY", currency="JPY"),
            ("usd", "$", "us$", "dollars"): NumberUnit("USD", currency="USD"),
            ("eur", "€", "euro"): NumberUnit("EUR", currency="EUR"),
            ("千円",): NumberUnit("千円", 1000.0, currency="JPY"),
            ("万円",): NumberUnit("万円", 10_000.0, currency="JPY"),
        },
        "°": {("°", "deg", "degrees", "度"): NumberUnit("°")},
    }.items()
}
"""Units by their names, for each unit that a column may have."""

HARMLESS_NOTES = ("税込", "税抜", "税別", "概算", "推定", "approx", "estimated")
"""What may stand in brackets behind a name without changing what the column holds."""

LONGEST_HEADING = 100
"""Letters of a cell that may be the name of a column."""

_ALIASES = {
    alias: name for name, column in COLUMNS.items() for alias in (name.replace("_", " "), *column.aliases)
}
JAPANESE = {
    name: alias
    for name, column in COLUMNS.items()
    for alias in reversed(column.aliases)
    if not alias.isascii()
}
"""What Japanese sentences call columns that the table does not call as stayput does."""

_ALL_UNITS = {name for units in UNITS.values() for name in units}
_ENDING = re.compile(r"(?:(?<=[^\x00-\x7f])|(?<=\))|[ ,/]+(?:in +)?)([a-z円]+|[千万]円)")
_BRACKETS = re.compile(r"(.+?) *[(\[]([^()\[\]]*)[)\]]")


_BETWEEN_LETTERS = re.compile(r"(?<=[々぀-ヿ㐀-鿿]) (?=[々぀-ヿ㐀-鿿])")
"""A blank with which a Japanese word is spread, as in 数　量."""


class HeaderName(NamedTuple):
    """The name of a table's column, taken apart.

    Parameters
    ----------
    base : str
        The name alone.
    unit : str
        Its unit, as it is written there; "" without one.
    note : str
        What else stands in brackets behind it.
    """

    base: str
    unit: str
    note: str

    @property
    def column(self) -> str | None:
        """The column that is called so."""
        return _ALIASES.get(self.base)


def plain_name(text: str) -> str:
    """Return a name in one spelling: of width, case, blanks and marks between words."""
    plain = (
        unicodedata.normalize("NFKC", text).lower().replace("№", "no").replace("#", " no ").replace("’", "'")
    )
    return _BETWEEN_LETTERS.sub("", re.sub(r"[\s_.・:*-]+", " ", plain).strip())


def is_heading(text: str) -> bool:
    """Return whether a cell seems to be the name of a column, or a unit below one."""
    if len(text) > LONGEST_HEADING:
        return False
    part = header_name(text)
    named = part.column is not None or part.base in ALONG_THE_WALL
    return named or part.base.strip("()[]") in _ALL_UNITS


def header_name(text: str) -> HeaderName:
    """Take the name of a column apart, such as "高さ（H）[mm]", "Height (in)" or "mass_kg"."""
    base, unit, notes = plain_name(text), "", list[str]()
    while True:
        if matched := _BRACKETS.fullmatch(base):
            base, inner = matched[1].strip(), matched[2].strip()
        elif _ALIASES.get(base) is None and (matched := _split_ending(base)) is not None:
            base, inner = matched
        else:
            break
        if inner in _ALL_UNITS and not unit:
            unit = inner
        else:
            notes.append(inner)
    meant = _ALIASES.get(base)
    across = base in ALONG_THE_WALL
    telling = [
        note
        for note in notes
        if note not in HARMLESS_NOTES
        and not (meant is not None and _ALIASES.get(note) == meant)
        and not (across and note in ALONG_THE_WALL)
    ]
    return HeaderName(base, unit, " ".join(telling))


def _split_ending(base: str) -> tuple[str, str] | None:
    for matched in _ENDING.finditer(base):
        if matched.end() == len(base) and matched[1] in _ALL_UNITS and matched.start() > 0:
            return base[: matched.start()], matched[1]
    return None


IGNORE = "ignore"
"""Name under which columns are listed that are not to be used."""

FILES = (".toml", ".json")

LARGEST_FILE = 2**20
"""Most bytes of a file with a mapping."""

_UNIT = re.compile(r"(.+?)\s*\[([^\[\]]*)\]", re.DOTALL)


@dataclass(frozen=True, slots=True)
class ColumnMapping:
    """Which columns of a table hold what.

    Parameters
    ----------
    pairs : tuple of (str, str)
        Names of `COLUMNS`, each with the table's name of it, which may have a unit behind it in brackets.
    ignored : tuple of str
        The table's names of columns that are not to be used.
    """

    pairs: tuple[tuple[str, str], ...] = ()
    ignored: tuple[str, ...] = ()

    def places(self, names: Sequence[str]) -> tuple[dict[str, tuple[int, NumberUnit | None]], set[int]]:
        """Return the place of each mapped column with the unit that is stated, and the places not to use.

        Raises
        ------
        InputError
            A name that the table does not have, or a unit that is none.
        """
        places: dict[str, tuple[int, NumberUnit | None]] = {}
        for name, header in self.pairs:
            place, unit = _find(name, header, names)
            if place in {other for other, _ in places.values()}:
                raise InputError("common.twice", "columns", name=quoted(header))
            places[name] = place, unit
        ignored = {_find(IGNORE, header, names)[0] for header in self.ignored}
        return places, ignored - {place for place, _ in places.values()}


def _find(name: str, header: str, names: Sequence[str]) -> tuple[int, NumberUnit | None]:
    """Return the place of the column of a header, which may have its unit behind it in brackets."""
    units = UNITS.get(COLUMNS[name].unit, {}) if name in COLUMNS else {}
    place = _place(header, names)
    if place is not None:
        return place, units.get(header_name(names[place]).unit)
    matched = _UNIT.fullmatch(header.strip())
    place = None if matched is None else _place(matched[1], names)
    if matched is None or place is None:
        raise unknown("inventory_tables.column_name", header, filter(None, names), "columns")
    stated, written = units.get(plain_name(matched[2])), units.get(header_name(names[place]).unit)
    if stated is None or written not in (None, stated):
        known = dict.fromkeys(unit.name for unit in ([written] if written else units.values()))
        raise unknown(phrase("inventory_tables.unit_of", name=name), matched[2], known or "-", "columns")
    return place, stated


def _place(header: str, names: Sequence[str]) -> int | None:
    """Return the place of the column of a name: as it is written, else the only one but for a unit."""
    wanted = plain_name(header)
    if not wanted:
        return None
    same = [place for place, name in enumerate(names) if plain_name(name) == wanted]
    same = same or [place for place, name in enumerate(names) if name and header_name(name).base == wanted]
    if len(same) > 1:
        raise InputError("inventory_tables.mapped_unclear", "columns", header=quoted(header))
    return same[0] if same else None


def read_columns(columns: str | Path | Mapping[str, Any] | None) -> ColumnMapping:
    """Return the mapping of a text such as "width=奥行,height=高さ[cm]", a TOML or JSON file, or a mapping.

    Raises
    ------
    InputError
        A file that cannot be read, a column that is none, or something else than names.
    """
    if columns is None:
        return ColumnMapping()
    if isinstance(columns, Mapping):
        return _mapping(list(columns.items()))
    if str(columns).lower().endswith(FILES):
        return _mapping(list(_file(Path(columns)).items()))
    return _mapping(named_columns(str(columns), "inventory_tables.mapping"))


def _file(path: Path) -> dict[str, Any]:
    if path.suffix.lower() == ".toml":
        return dict(read_toml(path))
    try:
        with path.open("rb") as file:
            content: Any = json.loads(file.read(LARGEST_FILE).decode("utf-8-sig"))
    except OSError as error:
        raise unreadable(path, error) from None
    except (ValueError, RecursionError):
        content = None
    if not isinstance(content, dict):
        raise not_allowed("columns", path, "inventory_tables.mapping_file", "columns")
    return cast("dict[str, Any]", content)


def _mapping(items: Sequence[tuple[str, object]]) -> ColumnMapping:
    pairs: dict[str, str] = {}
    ignored: list[str] = []
    for name, header in items:
        headers = cast("list[object]", header) if isinstance(header, list | tuple) else [header]
        for each in headers:
            if not isinstance(each, str) or not each.strip() or (name != IGNORE and len(headers) > 1):
                raise InputError("inventory_tables.mapping", "columns", value=shown(each))
            if name == IGNORE:
                ignored.append(each)
            elif name not in COLUMNS:
                known = (*COLUMNS, IGNORE)
                raise unknown("inventory_tables.column_name", name, known, field="columns")
            elif name in pairs:
                raise InputError("common.twice", "columns", name=shown(name))
            else:
                pairs[name] = each
    return ColumnMapping(tuple(pairs.items()), tuple(ignored))

"""Strong-motion files of Japan: of the Japan Meteorological Agency, and of NIED's K-NET and KiK-net.

JMA CSV: seven header lines, then NS, EW, UD in gal.

K-NET ASCII: 17 lines of a header, then counts, 8 a line; one channel a file. KiK-net's too.

K-NET CSV: "#" header lines, then date and time, seconds, and NS, EW, UD with their offset.

Sources: https://www.data.jma.go.jp/eqev/data/kyoshin/jishin/, coded in cp932 or UTF-8, times in JST;
https://www.kyoshin.bosai.go.jp/kyoshin/man/knetform_en.html. K-NET's acceleration is (count − mean of all
counts) × scale factor, which gives the header's own "Max. Acc."; Dir. 1–3 is KiK-net's borehole and 4–6 its
surface sensor. The line "#Offset" of its CSV states what is to be subtracted from each component.
"""

from __future__ import annotations

import re
from itertools import islice

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt, unknown, word_of
from stayput.motion.channels import Channel, in_borehole
from stayput.motion.readers.text import Reader, lacks, lines, not_as_stated, numbers, quantity, rows_of, words
from stayput.motion.units import acceleration_unit, regular_step, time_step

_JMA_SITE = re.compile(r"\s*SITE +CODE", re.IGNORECASE)
_JMA_RATE = re.compile(r"SAMPLING +(?:RATE|FREQ)", re.IGNORECASE)
_JMA_START = re.compile("INITIAL TIME", re.IGNORECASE)
_JMA_UNIT = re.compile("UNIT$", re.IGNORECASE)
_JMA_HEADER_LINES = 12

_KNET_HEADER_LINES = 17
_KNET_DIRECTIONS = {"1": "NS1", "2": "EW1", "3": "UD1", "4": "NS2", "5": "EW2", "6": "UD2"} | {
    name: name for name in ("NS", "EW", "UD")
}
_KNET_SCALE = re.compile(
    r"([0-9]{1,9}(?:\.[0-9]{0,9})?) *\(gal\) */ *([0-9]{1,12}(?:\.[0-9]{0,9})?)", re.IGNORECASE
)

_CSV_LABEL = re.compile(r"(?<![A-Z])(NS|EW|UD|N-S|E-W|U-D)([12]?)(?![A-Z])", re.IGNORECASE)
_CSV_DATE = re.compile(r" *[0-9]{4}[-/][0-9]{1,2}[-/][0-9]{1,2}[ T]+[0-9]{1,2}:")
_CSV_ASIDE = re.compile(r"\([^()]{0,40}\)|\[[^\[\]]{0,40}\]")
_CSV_HEADER = re.compile("^#.*", re.MULTILINE)


def _is_jma(text: str) -> bool:
    """Return whether the file begins with its site code and states a sampling rate."""
    return _JMA_SITE.match(text) is not None and "SAMPLING" in text[:2000].upper()


def _jma_header(text: str) -> tuple[list[str], list[str], int]:
    """Return the lines above the component names, the names, and where the rows begin."""
    header: list[str] = []
    for start, line in islice(lines(text), _JMA_HEADER_LINES):
        names = [name.strip().upper() for name in line.rstrip(", \t").split(",")]
        if len(names) > 1 and all(len(name) == 2 and name.isalpha() for name in names):
            return header, names, start + len(line) + 1
        header.append(line)
    raise lacks("line_of_names")


def _jma_entry(header: list[str], key: re.Pattern[str]) -> str:
    """Return what stands behind "=" in the header line of a key; "" where there is none."""
    entries = (line.partition("=") for line in header)
    values = (value for name, equals, value in entries if equals and key.match(name.strip()))
    return next(values, "").strip(" ,\t")


def _read_jma(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the channels of JMA's CSV.

    Raises
    ------
    InputError
        No sampling rate, unit or line of names; a row with too few or too many values.
    """
    header, labels, start = _jma_header(text)
    rate = quantity(_jma_entry(header, _JMA_RATE), ("HZ",), "sampling_frequency")
    factor = acceleration_unit(_jma_entry(header, _JMA_UNIT) or None, unit)
    for name in labels:
        word_of("motion.the_component", name, ("NS", "EW", "UD"))
        if labels.count(name) > 1:
            raise InputError("common.twice", name=name)
    # Lines without a value may stand only at the end of the file.
    samples = factor * rows_of(
        text.rstrip(", \t\n"), start, len(labels), lambda line: line.rstrip(", \t").split(",")
    )
    site = header[0].partition("=")[2].split(",")[0].strip() if header else ""
    step, origin = time_step(1.0 / rate, dt), f"{site}, {_jma_entry(header, _JMA_START)}"
    return [
        Channel(name, samples[:, i], step, site, location=site, origin=origin)
        for i, name in enumerate(labels)
    ]


def _is_knet(text: str) -> bool:
    """Return whether the file begins with "Origin Time" and has a scale factor."""
    head = text[:2000].lower()
    return head.startswith("origin time") and "scale factor" in head


def _read_knet(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the one channel of a file of K-NET or KiK-net.

    Raises
    ------
    InputError
        The header or a count is damaged, or the samples are not as long as stated.
    """
    top = list(islice(lines(text), _KNET_HEADER_LINES + 1))
    # A key is known by its letters: some files leave out points and blanks.
    keyed = (("".join(filter(str.isalpha, line[:18].lower())), line[18:].strip()) for _, line in top)
    header = dict(islice(keyed, _KNET_HEADER_LINES))
    if len(top) <= _KNET_HEADER_LINES or "memo" not in header:
        raise lacks("knet_memo")
    factor = acceleration_unit("gal", unit)
    counts = numbers(words(text, top[_KNET_HEADER_LINES][0]), "the_counts")
    rate = quantity(header.get("samplingfreqhz", ""), ("HZ",), "sampling_frequency")
    seconds = quantity(header.get("durationtimes", ""), ("S",), "duration")
    peak = quantity(header.get("maxaccgal", ""), ("GAL",), "the_peak")
    scale = _KNET_SCALE.fullmatch(header.get("scalefactor", ""))
    if scale is None or not (float(scale[1]) > 0.0 and float(scale[2]) > 0.0):
        raise lacks("scale_factor")
    if abs(len(counts) - rate * seconds) >= 1.0 - 1e-6:
        raise not_as_stated("duration", seconds, len(counts) / rate, " s")
    counts -= counts.mean()
    counts *= 0.01 * float(scale[1]) / float(scale[2])  # m/s² a count
    direction = header.get("dir", "")
    label = _KNET_DIRECTIONS.get(direction.replace("-", "").upper())
    if label is None:
        raise unknown("motion.direction", direction, ("N-S", "E-W", "U-D", *"123456"))
    sensor = {"1": ", borehole", "2": ", surface"}.get(label[-1], "")
    station, step = header.get("stationcode", ""), time_step(1.0 / rate, dt)
    origin, note = f"{station}{sensor}, {header.get('origintime', '')}", ", offset removed"
    below = in_borehole(label)
    return [Channel(label, counts, step, station, peak * factor, note, origin=origin, borehole=below)]


def _is_knet_csv(text: str) -> bool:
    """Return whether the file begins with "#" lines and has "#Offset" among them or dates below them."""
    head = text[:10000].split("\n")
    return text.startswith("#") and any(_key(line) == "offset" or _CSV_DATE.match(line) for line in head)


def _key(line: str) -> str:
    """Return the first word of a header line, in small letters."""
    match = re.match(r"# *([A-Za-z]+)", line)
    return match[1].lower() if match else ""


def _labels(line: str) -> list[str]:
    """Return the directions that a line names, where it names three or more."""
    labels = [m[1].replace("-", "").upper() + m[2] for m in _CSV_LABEL.finditer(line)]
    return labels if len(labels) >= 3 else []


def _offsets(line: str, count: int) -> list[float]:
    """Return what is to be subtracted from each component, in the samples' unit."""
    fields = re.split(r"[\s,:=]+", _CSV_ASIDE.sub(" ", line.lstrip("# ")).strip(" ,\t"))[1:]
    if len(fields) > count:  # names or units stand between the numbers
        fields = [text for text in fields if any(map(str.isdecimal, text))]
    if len(fields) != count:
        wanted = phrase("motion.so_many_numbers", count=count)
        raise InputError("motion.header_line", line=excerpt(line), wanted=wanted)
    return numbers(fields, "the_offsets").tolist()


def _csv_rate(line: str) -> float | None:
    """Return the sampling frequency that a header line states [Hz]."""
    value = re.split("freq", _CSV_ASIDE.sub(" ", line), flags=re.IGNORECASE)[-1].strip(" ,:=\t")
    return quantity(value, ("HZ",), "sampling_frequency") if value else None


def _read_knet_csv(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the channels of K-NET's CSV.

    Raises
    ------
    InputError
        The offsets or the unit are not stated, a row is incomplete, or the sampling is not regular.
    """

    def values_of(line: str) -> list[str] | None:
        if line.startswith("#") or not line.strip():
            return None
        if not _CSV_DATE.match(line):
            raise InputError("motion.header_line", line=excerpt(line), wanted=phrase("motion.date_and_time"))
        return line.rstrip(", \t").split(",")

    begin, first = next(
        ((start, line) for start, line in lines(text) if line.strip() and not line.startswith("#")),
        (len(text), ""),
    )
    header = _CSV_HEADER.findall(text)
    above = _CSV_HEADER.findall(text, 0, begin)
    names = _labels(first)
    labels = names or (_labels(above[-1]) if above else []) or ["NS", "EW", "UD"]
    begin += len(first) + 1 if names else 0
    table = rows_of(text, begin, len(labels) + 1, values_of, aside=1)
    by_key = {_key(line): line for line in reversed(header)}
    if "offset" not in by_key:
        raise lacks("knet_offset")
    offsets = _offsets(by_key["offset"], len(labels))
    stated = "gal" if re.search(r"\bgal\b", "\n".join(header), re.IGNORECASE) else None
    factor = acceleration_unit(stated, unit)
    if len(table) < 2:
        raise InputError("motion.few_rows", rows=len(table))
    step = regular_step(table[:, 0], varying=dt is not None)
    rate = _csv_rate(by_key["sampling"]) if "sampling" in by_key else None
    if rate is not None and abs(step * rate - 1.0) > 1e-3:
        raise not_as_stated("sampling_frequency", rate, 1.0 / step, " Hz")
    step = time_step(step, dt)
    station = re.split(r"[,:=]", by_key.get("station", ""), maxsplit=1)[-1].strip(" ,")
    return [
        Channel(
            name,
            factor * (table[:, i] - shift),
            step,
            station,
            note=", offset removed",
            location=station,
            borehole=in_borehole(name),
        )
        for i, (name, shift) in enumerate(zip(labels, offsets, strict=True), start=1)
    ]


READERS = (
    Reader("JMA CSV", _is_jma, _read_jma),
    Reader("K-NET ASCII", _is_knet, _read_knet),
    Reader("K-NET CSV", _is_knet_csv, _read_knet_csv),
)

"""K-NET CSV: "#" header lines, then date and time, seconds, and NS, EW, UD with their offset.

Source: NIED K-NET and KiK-net, https://www.kyoshin.bosai.go.jp. The line "#Offset" states what is to be
subtracted from each component.
"""

from __future__ import annotations

import re

from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel, in_borehole
from stayput.motion.readers.fields import Numbers, numbers, quantity
from stayput.motion.readers.header import acceleration_unit, regular_step, time_step
from stayput.motion.readers.text import chunks

FORMAT = "K-NET CSV"

_DEFAULT_LABELS = ["NS", "EW", "UD"]
_LABEL = re.compile(r"(?<![A-Z])(NS|EW|UD|N-S|E-W|U-D)([12]?)(?![A-Z])", re.IGNORECASE)
_DATE = re.compile(r" *[0-9]{4}[-/][0-9]{1,2}[-/][0-9]{1,2}[ T]+[0-9]{1,2}:")
_ASIDE = re.compile(r"\([^()]{0,40}\)|\[[^\[\]]{0,40}\]")
_PARTS = re.compile(r"[\s,:=]+")
_HEADER_LINES = 200


def recognise(text: str) -> bool:
    """Return whether the file begins with "#" lines and has "#Offset" among them or dates below them."""
    lines = text[:10000].split("\n")
    return text.startswith("#") and any(_key(line) == "offset" or _DATE.match(line) for line in lines)


def _key(line: str) -> str:
    """Return the first word of a header line, in small letters."""
    match = re.match(r"# *([A-Za-z]+)", line)
    return match[1].lower() if match else ""


def _labels(line: str) -> list[str]:
    """Return the directions that a line names, where it names three or more."""
    labels = [m[1].replace("-", "").upper() + m[2] for m in _LABEL.finditer(line)]
    return labels if len(labels) >= 3 else []


def _offsets(line: str, count: int) -> list[float]:
    """Return what is to be subtracted from each component, in the samples' unit."""
    fields = _PARTS.split(_ASIDE.sub(" ", line.lstrip("# ")).strip(" ,\t"))[1:]
    if len(fields) > count:  # names or units stand between the numbers
        fields = [text for text in fields if any(map(str.isdecimal, text))]
    if len(fields) != count:
        raise InputError("motion.knet_offset_count", line=excerpt(line), count=len(fields), columns=count)
    return numbers(fields, "the_offsets").tolist()


def _rate(header: list[str]) -> float | None:
    """Return the sampling frequency that the header states [Hz]."""
    line = next((line for line in header if _key(line) == "sampling"), None)
    value = re.split("freq", _ASIDE.sub(" ", line), flags=re.IGNORECASE)[-1].strip(" ,:=\t") if line else ""
    return quantity(value, ("HZ",), "sampling_frequency") if value else None


def read(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the file's channels.

    Raises
    ------
    InputError
        The offsets or the unit are not stated, a row is incomplete, or the sampling is not regular.
    """
    header: list[str] = []
    first: str | None = None  # row
    samples = Numbers("the_samples")
    labels: list[str] = []
    row = 0
    for chunk in chunks(text):
        tokens: list[str] = []
        for line in chunk.split("\n"):
            if line.startswith("#"):
                if len(header) < _HEADER_LINES:
                    header.append(line)
                continue
            if not line.strip():
                continue
            if first is None:
                first = line
                names = _labels(line)
                labels = names or (_labels(header[-1]) if header else []) or _DEFAULT_LABELS
                if names:
                    continue
            row += 1
            if not _DATE.match(line):
                raise InputError("motion.knet_no_date", line=excerpt(line))
            values = line.rstrip(", \t").split(",")
            if len(values) != len(labels) + 2:
                columns = len(labels) + 2
                raise InputError("motion.row_width", row=row, value=excerpt(line), columns=columns)
            tokens += values[1:]
        samples.add(tokens)
    labels = labels or _DEFAULT_LABELS
    offset = next((line for line in header if _key(line) == "offset"), None)
    if offset is None:
        raise InputError("motion.knet_no_offset")
    offsets = _offsets(offset, len(labels))
    stated = "gal" if re.search(r"\bgal\b", "\n".join(header), re.IGNORECASE) else None
    factor = acceleration_unit(stated, unit)
    table = samples.array().reshape(-1, len(labels) + 1)
    if len(table) < 2:
        raise InputError("motion.few_rows", rows=len(table))
    step = regular_step(table[:, 0])
    rate = _rate(header)
    if rate is not None and abs(step * rate - 1.0) > 1e-3:
        raise InputError("motion.knet_rate", rate=rate, step=step)
    step = time_step(step, dt)
    station = next(
        (re.split(r"[,:=]", line, maxsplit=1)[-1].strip(" ,") for line in header if _key(line) == "station"),
        "",
    )
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

"""Files of other kinds, which are not read: by what they are known, so that a refusal says what they are."""

from __future__ import annotations

import re

_ARCHIVES = (b"PK\x03\x04", b"\x1f\x8b", b"BZh", b"\xfd7zXZ", b"7z\xbc\xaf", b"Rar!")
_OLD_SPREADSHEET = b"\xd0\xcf\x11\xe0"
_IN_SPREADSHEETS = (b"xl/workbook", b"opendocument.spreadsheet")  # names of parts: Excel's, LibreOffice's

_FORMATS = {
    "USGS SMC": r"\s*[0-6] (?:(?:UN)?CORRECTED ACCELEROGRAM|VELOCITY|DISPLACEMENT|RESPONSE|FOURIER)",
    "RENADIC": r"[^#%/][^#%]*\bRENADIC\b",
    "GeoNet V1A/V2A": r"\s*(?:UN)?CORRECTED ACCELEROGRAM[^\n]* GNS\b",
    "CSMIP V1": r"\s*UNCORRECTED ACCELEROGRAM\b",
    "BRI .ac": r"\s*[0-9]{4}/[0-9]{2}/[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2} +[0-9]+ +[0-9]+ +[0-9]+ ",
    "HTML": r"\s*<(?:!doctype|html|\?xml)\b",
}
_HEAD = 2000  # characters at the beginning in which the format is looked for


def kind_of_binary(data: bytes) -> str:
    """Return what the data of a file are that are no text: "archive", "spreadsheet" or "binary"."""
    if data.startswith(_OLD_SPREADSHEET) or any(part in data for part in _IN_SPREADSHEETS):
        return "spreadsheet"
    return "archive" if data.startswith(_ARCHIVES) else "binary"


def other_format(text: str) -> str | None:
    """Return the name of the format of a text that is known but not read, or None."""
    head = text[:_HEAD]
    return next((name for name, begin in _FORMATS.items() if re.match(begin, head, re.IGNORECASE)), None)

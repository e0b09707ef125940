"""Strong-motion files of Mexico: the standard file of accelerations of UNAM's Institute of Engineering.

ASA 2.0: "KEY : /value/value" lines in Spanish, a value for each channel, then the channels as columns.

Source: Mexican database of strong earthquakes (BMSF), https://aplicaciones.iingen.unam.mx/AcelerogramasRSM. A
channel's direction is a bearing, "N90E" or "S00W", or "V"; behind a semicolon stands "+" or "-".
"""

from __future__ import annotations

import re

from stayput.errors import InputError, excerpt
from stayput.motion.channels import Channel
from stayput.motion.readers.text import Reader, check_count, is_decimal, lacks, lines, numbers, rows_of
from stayput.motion.units import acceleration_unit, time_step

_TITLE = re.compile(r"ARCHIVO EST[AÁ]NDAR DE ACELERACI[OÓ]N", re.IGNORECASE)
_DATA = re.compile(r"^ *DATOS DE ACELERACI[OÓ]N\b", re.IGNORECASE | re.MULTILINE)
_BEARING = re.compile(r"([NS]) ?([0-9]{1,2}) ?([EW])", re.IGNORECASE)


def _is_asa(text: str) -> bool:
    """Return whether the title stands in the first lines, and the samples are announced."""
    return _TITLE.search(text, 0, 2000) is not None and _DATA.search(text) is not None


def _azimuth(orientation: str) -> str:
    """Return a channel's direction as an azimuth, or as it stands where it is no bearing."""
    direction, _, sign = orientation.partition(";")
    if sign.strip() == "-":
        raise InputError("motion.other_sign", said=excerpt(orientation))
    bearing = _BEARING.fullmatch(direction.strip())
    if bearing is None:
        return direction.strip()
    angle = int(bearing[2]) if bearing[1].upper() == "N" else 180 - int(bearing[2])
    return str((angle if bearing[3].upper() == "E" else -angle) % 360)


def _read_asa(text: str, unit: str | None, dt: float | None) -> list[Channel]:
    """Return the channels of UNAM's file.

    Raises
    ------
    InputError
        A direction, a time step or the unit is missing, or there are not as many samples as stated.
    """
    data = _DATA.search(text)
    assert data is not None  # as it was recognised by it
    header = [line.partition(":") for line in text[: data.start()].split("\n")]

    def entry(key: str) -> str:
        return next((value.strip() for name, _, value in header if name.strip().upper().startswith(key)), "")

    def of_channels(key: str) -> list[str]:
        return [part.strip() for part in entry(key).split("/") if part.strip()]

    labels = list(map(_azimuth, of_channels("ORIENTACION C1")))
    steps = numbers(of_channels("INTERVALO DE MUESTREO, C1"), "the_time_step").tolist()
    if not labels or len(steps) != len(labels):
        raise lacks("the_time_step" if labels else "direction")
    below = lines(text, data.end())
    begin = next((at for at, line in below if line.split() and all(map(is_decimal, line.split()))), len(text))
    samples = rows_of(text, begin, len(labels), lambda line: line.split() or None)
    for count in numbers(of_channels("NUM. TOTAL DE MUESTRAS, C1"), "number_of_samples"):
        check_count(len(samples), count)
    factor = acceleration_unit(entry("UNIDADES DE LOS DATOS") or None, unit)
    name = entry("NOMBRE DE LA ESTACION")
    return [
        Channel(label, factor * samples[:, i], time_step(steps[i], dt), name, location=name)
        for i, label in enumerate(labels)
    ]


ASA = Reader("ASA 2.0", _is_asa, _read_asa)

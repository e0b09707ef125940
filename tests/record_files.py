"""Texts of records in each format that is read, made of one wave."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import stayput as sp

VALUES = [0.1, -0.25, 0.5, -0.125, 0.0625, 0.01, -0.02]  # g
ROWS = [(0.5, -0.001, 1.25), (-3.0, 2.0, 0.0), (1.0, -0.5, -0.75), (0.25, 0.0, 0.5)]  # gal
WAVE = np.round(150.0 * np.sin(np.arange(21) * 0.9), 3)  # gal
COUNTS = np.round(20000 * np.sin(np.arange(200) * 0.7) + 5000).astype(int)
SCALE = 2000 / 8388608  # gal a count


def block(values, form="%10.3f", per_line=8):
    rows = (values[i : i + per_line] for i in range(0, len(values), per_line))
    return "".join("".join(form % v for v in row) + "\n" for row in rows)


def at2(
    size="NPTS=     7, DT= .01000 SEC",
    title="VALLEY 1/2/99 0304, STATION NINE, 090 (USGS 1)",
    unit="IN UNITS OF G",
    values=VALUES,
):
    rows = re.sub(r" (-?)0\.", r"  \1.", block(values, "%15.7f", 5))
    return f"PEER STRONG MOTION DATABASE RECORD\n{title}\nACCELERATION TIME HISTORY {unit}\n{size}\n{rows}"


def jma(
    rate=" SAMPLING RATE= 100Hz",
    unit=" UNIT  = gal(cm/s/s)",
    names=" NS,EW,UD",
    tail="",
    initial="INITIAL TIME = 2016 04 14 21 26 20",
    rows=ROWS,
):
    head = [
        "SITE CODE= 123試験町   ,32.7,130.8",
        " LAT.=   0.0000",
        " LON.=  130.6842",
        rate,
        unit,
        initial,
        names,
    ]
    return "\r\n".join([*head, *(",".join(f"{v:.3f}" for v in row) + tail for row in rows)]) + "\r\n"


def knet(direction="N-S", peak=None, seconds=2, counts=COUNTS, scale="2000(gal)/8388608"):
    entries = {
        "Origin Time": "2006/01/18 23:25:00",
        **dict.fromkeys(("Lat.", "Long.", "Depth. (km)", "Mag."), "1.0"),
        "Station Code": "TST001",
        **dict.fromkeys(("Station Lat.", "Station Long.", "Station Height(m)"), "1.0"),
        "Record Time": "2006/01/18 23:25:46",
        "Sampling Freq(Hz)": "100Hz",
        "Duration Time(s)": str(seconds),
        "Dir.": direction,
        "Scale Factor": scale,
        "Max. Acc. (gal)": f"{np.abs(counts - counts.mean()).max() * SCALE if peak is None else peak:.3f}",
        "Last Correction": "2006/01/18 23:25:31",
        "Memo.": "",
    }
    return "".join(f"{key:<18}{value}\n" for key, value in entries.items()) + block(counts, "%9d")


def knet_csv(offset="#Offset(gal),10.5,-2.25,100.0", names="#Datetime,Relative Time(s),NS,EW,UD", rows=ROWS):
    lines = [
        f"2024/01/01 16:10:{0.01 * i:06.3f},{0.01 * i:.2f},"
        + ",".join(f"{v + shift:.6f}" for v, shift in zip(row, (10.5, -2.25, 100.0), strict=True))
        for i, row in enumerate(rows)
    ]
    head = ["#Station Code,TST001", "#Sampling Freq(Hz),100", offset, names]
    return "\n".join(line for line in [*head, *lines] if line) + "\n"


def esm(values=WAVE, **changes):
    entries = {
        "EVENT_NAME": "NOWHERE",
        "EVENT_ID": "TEST-1",
        "NETWORK": "XX",
        "STATION_CODE": "ABC",
        "LOCATION": "",
        "SAMPLING_INTERVAL_S": "0.005000",
        "NDATA": str(len(values)),
        "STREAM": "HNE",
        "UNITS": "cm/s^2",
        "PGA_CM/S^2": f"{np.abs(values).max():.6f}",
        "DATA_TYPE": "ACCELERATION",
        "USER5": "a path: /with colons: in it",
        **changes,
    }
    return "".join(f"{key}: {value}\n" for key, value in entries.items()) + block(values, "%.6f", 1)


def csmip_channel(
    number,
    direction,
    values=WAVE,
    *,
    count=None,
    peak=None,
    unit="  (UNITS: CM/SEC/SEC)",
    integers="",
    layout=(),
):
    n = len(values) if count is None else count
    peak = np.abs(values).max() if peak is None else peak
    return (
        f"CORRECTED ACCELEROGRAM   12345-S1-2.01       CHAN  {number}: {direction}     FROM\n"
        "UNCORRECTED ACCELEROGRAM DATA\nNOWHERE EARTHQUAKE\nMAY 2, 1983\n12345   TRIGGER TIME\n"
        f"STATION NO. 12345\nFAULT ZONE 14\nCHAN  {number}: {direction}\n{integers}"
        f"PEAK ACCELERATION =  {peak:.3f}    CM/SEC/SEC  AT   10.940   SEC.\n"
        f" {n} POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.{unit}\n{block(values, *layout)}"
        f" {n} POINTS OF VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)\n{block(values)}"
        f" {n} POINTS OF DISPL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM)\n{block(values)}"
        f"/&  ----------  END OF DATA FOR CHANNEL  {number}  ----------\n"
    )


def cosmos(
    values=WAVE,
    *,
    count=None,
    interval=5.0,
    peak=None,
    label="1: 360 Deg",
    kind="acceleration",
    unit="cm/sec2(04)",
    fmt="8F10.3",
    reals=100,
    end="End-of-data for Chan 1 acceleration\n",
):
    count = len(values) if count is None else count
    real = np.full(100, -999.0)
    real[61], real[63] = interval, (values[np.abs(values).argmax()] if peak is None else peak)
    text_lines = [
        "Corrected acceleration    (Format v01.20 with 13 text lines)",
        "Record of Nowhere Earthquake of Fri Nov 30, 2018",
        *["Hypocenter: ..."] * 6,
        f"Sta Chan   {label} (Rcrdr Chan  1) Location:",
        *["Processed: ..."] * 3,
        "Values used when parameter or data value is unknown/unspecified:   -999, -999.00",
        " 100 Integer-header values follow on  10 lines, Format= (10I8)",
        *["    -999" * 10] * 10,
        f" {reals} Real-header values follow on  {-(-reals // 5)} lines, Format= (5F15.6)",
    ]
    return (
        "\n".join([*text_lines, block(real[:reals], "%15.6f", 5)])
        + '   1 Comment line(s) follow, each starting with a "|":\n| comment\n'
        + f"   {count} {kind} pts, approx  1 secs, units={unit},Format=({fmt})\n"
        + f"{block(values)}{end}"
    )


def asa(rows=ROWS, count=None, orientation="/N90E;/N00E;/V;+", unit="Gal (cm/s/s)", steps="/0.01/0.01/0.01"):
    count = len(rows) if count is None else count
    return (
        "ARCHIVO ESTANDAR DE ACELERACION:\nNOMBRE DE LA ESTACION                  : PRUEBA\n"
        f"ORIENTACION C1-C6 (rumbo;orientacion)  : {orientation}\n"
        f"INTERVALO DE MUESTREO, C1-C6, (s)      : {steps}\n"
        f"NUM. TOTAL DE MUESTRAS, C1-C6          : /{count}/{count}/{count}\n"
        f"UNIDADES DE LOS DATOS                  : {unit}\nCOMENTARIOS: 2001/01/01 00:00\n"
        "DATOS DE ACELERACION:\n   CANAL-1   CANAL-2   CANAL-3\n     N90E;     N00E;       V;+\n"
        + "".join("".join(f"{v:12.3f}" for v in row) + "\n" for row in rows)
    )


SIZES = (10.0, 30.0, 20.0, 5.0, 2.0, 7.0)  # of the columns behind the time; peaks in gal


def table(head: str, columns: int | None = None) -> str:
    """Return a head and, parted as its last line, rows of a time and sines; one column is a sine alone."""
    last = head.rpartition("\n")[2]
    mark = next((mark for mark in "\t;," if mark in last), ",")
    count = columns or last.count(mark) + 1
    rows = ([f"{0.02 * i:.2f}", *(f"{k * math.sin(0.12 * i):.3f}" for k in SIZES)] for i in range(60))
    lines = [mark.join(row[1:2] if count == 1 else row[:count]) for row in rows]
    return "\n".join([*([head] if head else []), *lines, ""])


def peaks(motion: sp.Motion) -> dict[str, float]:
    return {name: round(float(np.abs(a).max()), 3) for name, a in motion.components.items()}


UP_FIRST = {"x": 0.3, "y": 0.2, "z": 0.1}
UP_LAST = {"x": 0.1, "y": 0.3, "z": 0.2}

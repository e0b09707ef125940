"""Files made to keep a reader busy: its work grows with the size of the file, and not with the square."""

import time
import tracemalloc
from contextlib import suppress

import pytest

from stayput.errors import InputError
from stayput.motion.readers import read_motion

PEER = "PEER STRONG MOTION DATABASE RECORD\nQ, S, 090\nACCELERATION IN UNITS OF G\n"
CSMIP = " 3 POINTS OF ACCEL DATA EQUALLY SPACED AT .01 SEC. (UNITS: G)\n"
CSMIP_CHANNEL = CSMIP + "      .001      .002      .003\n/&\n"
ESM = "EVENT_ID: T\nNDATA: 3\nSAMPLING_INTERVAL_S: 0.01\nDATA_TYPE: ACCELERATION\n"
JMA = "SITE CODE= 1\nSAMPLING RATE= 100Hz\n"
KNET = "".join(f"{key:<18}1\n" for key in ("Origin Time", *["Lat."] * 12, "Scale Factor"))
FIRST = "Corrected acceleration (Format v01.20 with 1 text lines)\n"
INTEGERS = "1 Integer-header values follow on 1 lines, Format= (10I8)\n       1\n"
REALS = "64 Real-header values follow on 64 lines, Format= (1F9.3)\n" + "   10.000\n" * 64
COSMOS = FIRST + INTEGERS + REALS

LINES = {  # a part of one line that is repeated up to the longest line that is read
    "peer blanks after NPTS": (PEER + "NPTS=1", " ", "x\n"),
    "peer blanks before DT": (PEER + "NPTS=1 ,", " ", "x DT\n"),
    "peer NPTS": (PEER, "NPTS= ", "DT\n"),
    "peer digits": (PEER, "1", " NPTS, DT\n"),
    "peer units": (PEER, "UNITS OF ", "\nNPTS= 2, DT= .01\n1 2\n"),
    "cosmos blanks after a count": (COSMOS + "3", " ", "x\n1\n"),
    "cosmos units": (COSMOS + "3 acceleration pts, units=", "a", "\n1\n"),
    "cosmos units again": (COSMOS + "3 acceleration pts, ", "units=", "\n1\n"),
    "cosmos formats": (COSMOS + "3 acceleration pts, units=g, ", "Format= (", "\n1\n"),
    "cosmos words": (COSMOS + "3", " acceleration", "\n1\n"),
    "cosmos real header": (FIRST + INTEGERS + "64 Real-header values follow on 64 lines", "Format=", "\n"),
    "cosmos channels": (FIRST + "Chan ", "Chan 1 :", "\n"),
    "csmip blanks": (CSMIP_CHANNEL + "CHAN 1: a", " ", "x\n"),
    "csmip channels": ("", "CHAN ", "\n" + CSMIP_CHANNEL),
    "csmip peaks": ("", "PEAK ACCELERATION = ", "\n" + CSMIP_CHANNEL),
    "csmip digits": ("", "1", "\n" + CSMIP_CHANNEL),
    "jma names": (JMA + "NS,EW", " ,", "x\n"),
    "jma blanks": (JMA + "NS", " ", "x\n"),
    "jma rate": ("SITE CODE= 1\nSAMPLING RATE= 1", " ", "x\nNS,EW,UD\n1,2,3\n"),
    "esm entries": (ESM, "A", "\n1\n2\n3\n"),
    "knet rate": (KNET + "Sampling Freq(Hz)", " ", "x\n"),
    "knet csv brackets": ("#Offset", "(", "\n2024/01/01 00:00:00,0,1,2,3\n"),
    "knet csv dates": ("#Offset,1,2,3\n2024/01/01", " T", "x\n"),
    "columns unit": ("# ", "unit: ", "\n1 2\n3 4\n"),
    "columns blanks in an order": ("# columns: t", " ", "x\n1 2\n3 4\n"),
    "columns order": ("# columns: t", " (", "\n1 2\n3 4\n"),
    "columns numbered": ("# ", "column 1: ", "\n1 2\n3 4\n"),
    "columns components": ("# component: ", "acc_", "\n1 2\n3 4\n"),
    "columns title": ("a: ", "1 ", "\n1 2\n3 4\n"),
    "columns quotes": ("1 ", '"', "\n1 2\n"),
    "columns brackets": ("t,acc ", "(", "\n1,2\n"),
    "columns accelerogram": ("UNCORRECTED ", "ACCELEROGRAM ", "\n1 2\n3 4 5\n"),
    "columns units of acceleration": ("# ", "cm/s", "\n1 2\n3 4\n"),
    "columns floors": ("# unit: g ", "floor ", "\n0 2\n1 4\n"),
    "columns factors": ("t,acc ", "1*", "\n1,2\n3,4\n"),
    "columns steps": ("# dt = ", "1", "\n1\n2\n"),
    "columns counts": ("# ", "no. of data ", "4000\n1\n2\n"),
    "columns velocities": ("# ", "velocity ", "\n1\n2\n"),
    "columns touching": ("# npts = 4000\n", "1-", "\n1\n2\n"),
    "columns roofs": ("# unit: g ", "1", "\n0 2\n1 4\n"),
    "columns blanks": ("# unit: g\n0 1", " ", "\n1 2\n"),
    "columns points": ("# unit: g\n1 2\n3 ", ".1", ""),
    "columns semicolons": ("1", ";", "x\n"),
}

FILES = {  # a part of the file that is repeated as often as is asked
    "csmip channels": (CSMIP_CHANNEL, ""),
    "csmip announcements": (CSMIP, ""),
    "cosmos blocks": (
        COSMOS + "1 velocity pts, units=g,Format=(1F9.3)\n   10.000\nEnd-of-data for Chan 1 velocity\n",
        "",
    ),
    "cosmos ends": ("End-of-data for Chan 1 velocity\n", ""),
    "esm entries": ("NDATA: 3\nSAMPLING_INTERVAL_S: 0.01\n", ""),
    "empty lines": ("\n", "1\n"),
    "names": ("#Offset\n", "1 2\n"),
    "peer": ("1 ", "\nNPTS= 3, DT= .01\n"),
}


def seconds(file, text) -> float:
    """Return the shortest of three times of the processor in which a file is read or refused."""
    file.write_text(text)
    times = []
    for _ in range(3):
        start = time.process_time()
        with suppress(InputError):
            read_motion(file, unit="g")
        times.append(time.process_time() - start)
    return min(times)


@pytest.mark.parametrize("name", LINES)
@pytest.mark.filterwarnings("ignore::stayput.InputWarning")
def test_a_long_line_is_read_at_once(name, tmp_path):
    before, part, after = LINES[name]
    small, large = (
        seconds(tmp_path / "record", before + part * (length // len(part)) + after) for length in (2400, 9600)
    )
    assert large < 8.0 * small + 0.1  # what grows with the square is 16 times as long, and seconds


@pytest.mark.parametrize("name", FILES)
@pytest.mark.filterwarnings("ignore::stayput.InputWarning")
def test_a_long_file_is_read_in_a_time_that_grows_as_it_does(name, tmp_path):
    part, after = FILES[name]
    many = 250_000 // len(part)
    head = COSMOS if name == "cosmos ends" else ESM if name == "esm entries" else CSMIP * ("csmip" in name)
    small, large = (seconds(tmp_path / "record", head + part * count + after) for count in (many, 4 * many))
    assert large < 9.0 * small + 0.1


ROWS = 60_000
LARGE = {
    "columns": "# t, x, y, z\n"
    + "".join(f"{i / 100:.2f} {i % 97 - 48}.125 {i % 89 - 44}.25 1.5\n" for i in range(ROWS)),
    "jma": JMA
    + "UNIT = gal\nNS,EW,UD\n"
    + "".join(f"{i % 97 - 48}.125,{i % 89 - 44}.250,1.500\n" for i in range(ROWS)),
    "peer": PEER
    + f"NPTS= {ROWS}, DT= .01\n"
    + "".join(f"  {(i % 97 - 48) / 100:.7f}E-01\n" for i in range(ROWS)),
}


@pytest.mark.parametrize("name", LARGE)
@pytest.mark.filterwarnings("ignore::stayput.InputWarning")
def test_memory_is_a_few_times_the_file(name, tmp_path):
    file = tmp_path / "record"
    file.write_text(LARGE[name])
    unit = "gal" if name == "columns" else None
    read_motion(file, unit=unit)
    tracemalloc.start()
    motion = read_motion(file, unit=unit)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(motion) == ROWS
    assert peak < 8 * len(LARGE[name])  # lists of words took eleven to forty times

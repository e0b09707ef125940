"""PEER AT2: the variants of its header, and what is refused."""

import re

import pytest

from stayput.errors import InputError
from stayput.motion import Motion, read_motion

VALUES = [0.1, -0.25, 0.5, -0.125, 0.0625, 0.01, -0.02]
SIZES = {
    "old": "NPTS=     7, DT= .01000 SEC",
    "ngawest2": "NPTS =      7 , DT =   .010 SEC ,                                      ",
    "tight": "NPTS=7,DT=.01",
    "bare": "7    0.0100    NPTS, DT",
}


def at2(
    size=SIZES["old"],
    title="VALLEY 1/2/99 0304, STATION NINE, 090 (USGS 1)",
    unit="IN UNITS OF G",
    values=VALUES,
):
    fields = [re.sub(r"(?<![0-9])0\.", ".", f"{v:.7f}").rjust(15) for v in values]
    rows = "\n".join("".join(fields[i : i + 5]) for i in range(0, len(fields), 5))
    return f"PEER STRONG MOTION DATABASE RECORD\n{title}\nACCELERATION TIME HISTORY {unit}\n{size}\n{rows}\n"


@pytest.fixture
def read(tmp_path):
    def reader(text, **kwargs):
        file = tmp_path / "any.name"
        file.write_bytes(text.encode("latin-1"))
        return read_motion(file, **kwargs)

    return reader


@pytest.mark.parametrize("ends", ["\n", "\r\n", "\r\r\n", "\r"])
@pytest.mark.parametrize("size", SIZES)
def test_header_variants_and_line_ends(read, size, ends):
    motion = read(at2(SIZES[size]).replace("\n", ends))
    assert motion.dt == pytest.approx(0.01)
    assert motion.x == pytest.approx([9.80665 * v for v in VALUES])
    assert motion.name == "VALLEY 1/2/99 0304, STATION NINE, 090"
    assert "PEER AT2" in motion.source


@pytest.mark.parametrize(
    ("title", "name"),
    [
        ("Kobe Japan, 1/16/1995, KJMA, UP", "Kobe Japan, 1/16/1995, KJMA, UP"),
        ("QUAKE 1/2/99, N PALM SPRINGS", "QUAKE 1/2/99, N PALM SPRINGS"),
        ("no commas here", "no commas here"),
    ],
)
def test_direction_is_read_only_where_it_stands(read, title, name):
    assert read(at2(title=title)).name == name


def test_downward_vertical_is_turned(read):
    assert read(at2(title="Q, S, DWN")).x == pytest.approx([-9.80665 * v for v in VALUES])


def test_unit_of_a_header_without_one(read):
    with pytest.raises(InputError, match="no unit"):
        read(at2(unit=""))
    assert read(at2(unit=""), unit="gal").x == pytest.approx([0.01 * v for v in VALUES])
    assert read(at2(unit="IN UNITS OF CM/S/S")).x == pytest.approx([0.01 * v for v in VALUES])


def test_unit_and_step_that_contradict_the_header(read):
    assert read(at2(), unit="g", dt=0.01).dt == 0.01
    with pytest.raises(InputError, match="the file states, 'G'"):
        read(at2(), unit="gal")
    with pytest.raises(InputError, match=r"the file states, 0\.01 s"):
        read(at2(), dt=0.02)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (at2(values=VALUES[:-1]), "number of samples 7 and the file has 6"),
        (at2(values=[*VALUES, 1.0]), "number of samples 7 and the file has 8"),
        (at2()[:-16], "number of samples 7 and the file has 6"),
        (at2(values=[]), "has 0"),
        (at2(size="NPTS= 7, DT= 0.0"), "time step"),
        (at2(size="NPTS= 7, DT= 1.2.3"), "'1.2.3'"),
        (at2(size="NPTS= 6.5, DT= 0.01"), "samples"),
        (at2().replace("-.", "***"), "decimal number"),
        (at2().replace("ACCELERATION", "VELOCITY").replace("OF G", "OF CM/S"), "is of velocity"),
        (at2().replace("ACCELERATION", "DISPLACEMENT").replace("OF G", "OF CM"), "is of displacement"),
        (at2(unit="IN UNITS OF FURLONGS"), "'FURLONGS'"),
    ],
)
def test_files_that_are_refused(read, text, message):
    with pytest.raises(InputError, match=message):
        read(text)


def test_a_triple_is_combined(read):
    ns, ew, ud = (
        read(at2(title=f"Q, S, {d}", values=[k * v for v in VALUES]))
        for k, d in ((1, "000"), (2, "090"), (3, "UP"))
    )
    motion = Motion.combine(ns, ew, ud)
    assert motion.z == pytest.approx(3 * motion.x)
    assert motion.y == pytest.approx(2 * motion.x)


def test_a_file_that_ends_within_a_number_is_refused_and_one_without_a_last_line_end_is_not(read):
    whole = at2(values=VALUES * 20, size="NPTS= 140, DT= .01")
    assert read(whole.rstrip("\n")).x[-1] == pytest.approx(-0.02 * 9.80665)
    for cut in (2, 4, 6):
        with pytest.raises(InputError, match="ends within a number"):
            read(whole[:-cut])


@pytest.mark.parametrize("count", [3, 5, 6, 7, 11, 30, 60])
def test_short_files_that_end_within_a_number_are_refused_too(read, count):
    values = (VALUES * 10)[:count]
    whole = at2(values=values, size=f"NPTS= {count}, DT= .01").rstrip("\n")
    assert len(read(whole)) == count
    for cut in (1, 3, 5):
        with pytest.raises(InputError, match="ends within a number"):
            read(whole[:-cut])


@pytest.mark.parametrize(
    "size", ["NPTS= 7, DT= .5 MSEC", "NPTS= 7, DT= 0,01", "NPTS= 1,007, DT= .01", "NPTS= 7 DT= 100 Hz"]
)
def test_numbers_of_the_header_are_matched_in_full(read, size):
    with pytest.raises(InputError, match=r"it must state NPTS|must be"):
        read(at2(size=size))

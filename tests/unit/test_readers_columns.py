"""Columns of numbers: what counts as a record, and what is refused."""

import re

import numpy as np
import pytest

from stayput.errors import InputError, InputWarning
from stayput.motion import read_motion


@pytest.fixture
def read(tmp_path):
    def reader(text, **kwargs):
        file = tmp_path / "record.txt"
        file.write_bytes(text.encode() if isinstance(text, str) else text)
        return read_motion(file, **kwargs)

    return reader


@pytest.mark.parametrize(
    "text", ["0\n1.5\n-2\n", " 0.\r\n+1.5e0\r\n-.2E+1\r\n", "# gal\n\n0\n1.5\n-2", "\ufeff0\n1.5\n-2\n\x1a"]
)
def test_one_column(read, text):
    motion = read(text, unit="gal", dt=0.01)
    assert motion.x == pytest.approx([0.0, 0.015, -0.02])
    assert motion.dt == 0.01
    assert motion.name == "record"


@pytest.mark.parametrize("mark", [" ", "\t", ",", ", ", ";", "; "])
def test_two_columns_are_time_and_x(read, mark):
    motion = read("".join(f"{0.02 * i:.2f}{mark}{i}\n" for i in range(5)), unit="m/s²")
    assert motion.dt == pytest.approx(0.02)
    assert motion.x.tolist() == [0.0, 1.0, 2.0, 3.0, 4.0]


def test_time_may_begin_anywhere_and_be_rounded(read):
    motion = read("".join(f"{12.0 + i / 128:.3f} {i}\n" for i in range(129)), unit="gal")
    assert motion.dt == pytest.approx(1 / 128, rel=1e-5)
    motion = read("".join(f"{1e-5 * round(1999.9999 * (i + 1)):.5f} {i}\n" for i in range(500)), unit="gal")
    assert motion.dt == pytest.approx(0.02, rel=1e-6)


def test_four_columns_are_time_x_y_z(read):
    motion = read("0.00 1 2 3\n0.01 4 5 6\n0.02 7 8 9\n", unit="g")
    assert motion.x == pytest.approx(9.80665 * np.array([1, 4, 7]))
    assert motion.y == pytest.approx(9.80665 * np.array([2, 5, 8]))
    assert motion.z == pytest.approx(9.80665 * np.array([3, 6, 9]))


@pytest.mark.parametrize(
    "names", ["time,UD,EW,NS", "# t [s], UD [m/s²], EW [m/s²], NS [m/s²]", '"Time","UD","EW","NS"']
)
def test_named_columns_are_taken_by_name(read, names):
    text = f"{names}\n0.00,1,2,3\n0.01,4,5,6\n0.02,7,8,9\n"
    assert read(text, unit="m/s2", component="NS").x.tolist() == [3.0, 6.0, 9.0]
    assert read(text, unit="m/s2", component="NS").z.tolist() == [1.0, 4.0, 7.0]
    assert read(text, unit="m/s2").x.tolist() == [2.0, 5.0, 8.0]


def test_component_of_unnamed_columns(read):
    text = "0.00 1 2 3\n0.01 4 5 6\n"
    assert read(text, unit="m/s2", component="y").x.tolist() == [2.0, 5.0]
    with pytest.raises(InputError, match="'NS' is no channel"):
        read(text, unit="m/s2", component="NS")


def test_dt_that_agrees_with_the_time_column(read):
    text = "".join(f"{0.02 * i:.2f} {i}\n" for i in range(50))
    assert read(text, unit="gal", dt=0.02).dt == 0.02
    with pytest.raises(InputError, match=r"file states, 0\.02 s"):
        read(text, unit="gal", dt=0.01)


@pytest.mark.parametrize(
    ("text", "kwargs", "message"),
    [
        ("0\n1\n", {"dt": 0.01}, "no unit"),
        ("0\n1\n", {"unit": "gal"}, "no time step"),
        ("0 1\n0.01 2\n", {}, "no unit"),
        ("0\n", {"unit": "gal", "dt": 0.01}, "at least 2"),
        ("0 1 2\n0.01 2 3\n", {"unit": "gal"}, "3 columns"),
        ("0 1 2 3 4\n0.01 2 3 4 5\n", {"unit": "gal"}, "5 columns"),
        ("0 1\n0.01 2 3\n0.02 3\n", {"unit": "gal"}, "Row 2 has 3 values"),
        ("0,1\n0.01,\n0.02,3\n", {"unit": "gal"}, "Row 2 has 1 values"),
        ("0,1,2,3\n0.01,4,,6\n", {"unit": "gal"}, "''"),
        ("0 1\n0.01 nan\n0.02 3\n", {"unit": "gal"}, "'nan'"),
        ("0 1\n0.01 inf\n0.02 3\n", {"unit": "gal"}, "'inf'"),
        ("0 1\n0.01 1_0\n0.02 3\n", {"unit": "gal"}, "'1_0'"),
        ("0 1\n0.01 ٣\n0.02 3\n", {"unit": "gal"}, "'٣'"),
        ("0 1\n0.01 1.0D+01\n0.02 3\n", {"unit": "gal"}, "'1.0D"),
        ("0 1\n0.01 1e999\n0.02 3\n", {"unit": "gal"}, "'1e999'"),
        ("0 1\n0.01 0x10\n0.02 3\n", {"unit": "gal"}, "'0x10'"),
        ("0;1\n0,01;2\n0,02;3\n", {"unit": "gal"}, "'0,01'"),
        ("0 1\n0.01 2\n0.03 3\n0.04 4\n", {"unit": "gal"}, "irregular"),
        ("0 1\n0.01 2\n0.01 3\n0.02 4\n", {"unit": "gal"}, "irregular"),
        ("0.02 1\n0.01 2\n0.00 3\n", {"unit": "gal"}, "must grow"),
        ("0 1\n0 2\n", {"unit": "gal"}, "must grow"),
        ("0 1\n5 2\n10 3\n", {"unit": "gal"}, "time step"),
        ("20\n" + "0.1\n" * 20, {"unit": "gal", "dt": 0.01}, "looks like a count"),
        ("0\n9e6\n", {"unit": "gal", "dt": 0.01}, "10000"),
        ("time,acc\nthen,words\n0,1\n", {"unit": "gal"}, "line 'then,words' stands between the headings"),
    ],
)
def test_columns_that_are_refused(read, text, kwargs, message):
    with pytest.raises(InputError, match=message):
        read(text, **kwargs)


@pytest.mark.parametrize("place", [1, 50, 98])
def test_a_missing_row_is_noticed_wherever_it_is(read, place):
    rows = [f"{0.01 * i:.2f} {i}\n" for i in range(100)]
    del rows[place]
    with pytest.raises(InputError, match="irregular"):
        read("".join(rows), unit="gal")


@pytest.mark.parametrize(
    ("names", "size"),
    [
        ("Time (s),NS (gal),EW (gal),UD (gal)", 0.01),
        ("# t [s]; NS [cm/s²]; EW [gal]; UD [cm/s/s]", 0.01),
        ('"time_s","ax_g","ay_g","az_g"', 9.80665),
        ("t\tNS_gal\tEW_gal\tUD_gal", 0.01),
    ],
)
def test_the_unit_is_that_of_the_columns_names_where_all_have_the_same(read, names, size):
    mark = next(mark for mark in ",;\t" if mark in names)
    rows = "".join(f"{mark.join(map(str, row))}\n" for row in ((0.0, 1, 2, 3), (0.01, 4, 5, 6)))
    motion = read(f"{names}\n{rows}")
    assert motion.x == pytest.approx(size * np.array([1, 4]))
    assert motion.z == pytest.approx(size * np.array([3, 6]))
    with pytest.raises(InputError, match="must be the one that the file states"):
        read(f"{names}\n{rows}", unit="mm/s²")


@pytest.mark.parametrize(
    "names",
    ["t,NS (gal),EW (gal),UD", "t,NS,EW,UD", "# no,NS (gal),EW (gal),UD (gal)"],
)
def test_the_unit_must_be_given_where_the_columns_names_leave_it_open(read, names):
    rows = "0.00,1,2,3\n0.01,4,5,6\n"
    with pytest.raises(InputError, match="unit must be given"):
        read(f"{names}\n{rows}")
    assert read(f"{names}\n{rows}", unit="gal").x == pytest.approx([0.01, 0.04])


def test_unit_and_step_are_asked_for_together_where_both_are_missing(read):
    with pytest.raises(InputError, match=r"no unit and no time step; .*, and dt \[s\]") as caught:
        read("0\n1\n0\n")
    assert caught.value.code == "motion.no_unit_nor_step"
    with pytest.raises(InputError, match=r"no unit; "):
        read("0\n1\n0\n", dt=0.01)


ROWS = "".join(f"{0.01 * i:.2f},{i},{2 * i},{3 * i}\n" for i in range(4))


@pytest.mark.parametrize("names", ["time [s],NS [m/s2],EW [gal],UD [g]", "# t; NS_m/s/s; EW_gal; UD_g"])
def test_each_column_has_the_unit_of_its_own_heading(read, names):
    text = f"{names}\n{ROWS}".replace(",", ";" if ";" in names else ",")
    motion = read(text, component="NS")
    assert motion.x == pytest.approx([0.0, 1.0, 2.0, 3.0])
    assert motion.y == pytest.approx([0.0, 0.02, 0.04, 0.06])
    assert motion.z == pytest.approx(9.80665 * np.array([0, 3, 6, 9]))
    assert read(text, component="EW").x == pytest.approx([0.0, 0.02, 0.04, 0.06])
    with pytest.raises(InputError, match=r"'m/s2'; it must be the one that the file states, 'EW") as caught:
        read(text, unit="m/s2", component="EW")
    assert caught.value.field == "unit"


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ("t,NS (gal),EW (g),UD", "'UD' states no unit, and the other columns have different ones"),
        ("# unit: m/s²\nt,NS (gal),EW (gal),UD (gal)", r"units 'm/s²' and 'NS \(gal\)'"),
        ("no,NS (gal),EW (gal),UD (gal)", "first column is headed 'no'"),
        ("NS [gal],EW [gal],UD [gal],UP [gal]", r"first column is headed 'NS \[gal\]'"),
        ("NS,EW,UD,clock", "first column is headed 'NS'"),
        ("time,time 2,NS,EW", "'time', 'time 2' are all headed as the time"),
        ("time [min],NS [gal],EW [gal],UD [gal]", r"headed 'time \[min\]'; it must be in s or ms"),
    ],
)
def test_headings_that_are_refused(read, names, message):
    with pytest.raises(InputError, match=message):
        read(f"{names}\n{ROWS}")


@pytest.mark.parametrize("unit", [None, "m/s2"])
@pytest.mark.parametrize(
    ("heading", "quantity"),
    [
        ("NS [m/s]", "velocity"),
        ("NS (cm/sec)", "velocity"),
        ("NS_kine", "velocity"),
        ("vel_NS", "velocity"),
        ("NS [mm]", "displacement"),
        ("NS_cm", "displacement"),
        ("Displacement NS", "displacement"),
    ],
)
def test_velocity_and_displacement_are_never_read_as_acceleration(read, heading, quantity, unit):
    with pytest.raises(InputError, match=f"is of {quantity}, by"):
        read("\n".join([f"t,{heading}", *(row.rsplit(",", 2)[0] for row in ROWS.splitlines())]), unit=unit)
    with pytest.warns(InputWarning, match="left out"):
        motion = read(f"t,{heading},EW [m/s2],UD [m/s2]\n{ROWS}", unit=unit)
    assert list(motion.components) == ["x", "z"]


@pytest.mark.parametrize(
    "names",
    [
        "time,acceleration,velocity,displacement",
        "Time (s);Vel (cm/s);Accel;Disp (cm)",
        "t\ta\tv\td",
        "# t [s], v, a, d",
        "時間(秒),加速度,速度(kine),変位(cm)",
    ],
)
def test_velocity_and_displacement_beside_the_acceleration_are_left_out_and_told(read, names):
    mark = next(mark for mark in ";\t," if mark in names)
    place = [re.match("a|加", name.strip(), re.IGNORECASE) is not None for name in names.split(mark)].index(
        True
    )
    rows = "".join(f"{mark.join(row)}\n" for row in (["0.00", *"123"], ["0.01", *"456"], ["0.02", *"789"]))
    with pytest.warns(InputWarning, match="velocities, displacements or magnitudes and are left out") as told:
        motion = read(f"{names}\n{rows}", unit="m/s²")
    assert motion.x.tolist() == [place, place + 3, place + 6]
    assert list(motion.components) == ["x"]
    (warning,) = (one.message for one in told if one.message.code == "motion.columns_left_out")
    others = [name.strip(" #") for i, name in enumerate(names.split(mark)) if i not in (0, place)]
    assert names.isascii() is all(name in str(warning) for name in others)
    assert "速度、変位、大きさの列" in warning.told("ja")


@pytest.mark.parametrize("heading", ["time [ms]", "t (msec)", "time_ms", "Zeit [ms]"])
def test_time_in_milliseconds(read, heading):
    motion = read(f"{heading},NS [gal],EW [gal],UD [gal]\n0,0,0,0\n10,1,2,3\n20,2,4,6\n")
    assert motion.dt == 0.01


@pytest.mark.parametrize("comment", ["", "# "])
def test_the_time_is_the_column_that_is_headed_so(read, comment):
    rows = "".join(f"{-i},{2 * i},{3 * i},{0.01 * i:.2f}\n" for i in range(4))
    motion = read(f"{comment}NS [gal],EW [gal],UD [gal],time [s]\n{rows}", component="EW")
    assert motion.dt == 0.01
    assert motion.x == pytest.approx([0.0, 0.02, 0.04, 0.06])
    assert motion.y == pytest.approx([0.0, -0.01, -0.02, -0.03])


@pytest.mark.parametrize(
    "names", ["UD,UD2,UD3", "acceleration_UD,acceleration_UD2,acceleration_UD3", "a 1 (x),a 2 (x),a 3 (x)"]
)
def test_columns_have_names_of_their_own(read, names):
    motion = read(f"time,{names}\n{ROWS}", unit="m/s2", component=names.split(",")[1].split(" (")[0])
    assert motion.x.tolist() == [0.0, 2.0, 4.0, 6.0]
    assert motion.listing is not None
    assert len(set(motion.listing.names)) == 3


@pytest.mark.parametrize("mark", ["\ufeff\ufeff", "\u202e", "\u200b"])
@pytest.mark.parametrize("head", ["{}time [s],{}NS [gal],EW [gal],UD [gal]", "{}# unit: gal"])
def test_characters_that_are_not_seen_before_a_heading(read, head, mark):
    motion = read(f"{head.replace('{}', mark)}\n{ROWS}")
    assert motion.dt == 0.01
    assert motion.x == pytest.approx([0.0, 0.01, 0.02, 0.03])


def test_headings_parted_by_blanks_keep_their_units(read):
    motion = read("t [s]  NS [gal]  EW [g]  UD [gal]\n" + ROWS.replace(",", " "), component="EW")
    assert motion.x == pytest.approx(9.80665 * np.array([0, 2, 4, 6]))


def test_the_heading_of_a_single_column(read):
    assert read("NS [gal]\n0\n1\n2\n", dt=0.01).x == pytest.approx([0.0, 0.01, 0.02])


@pytest.mark.parametrize(
    "names",
    [
        "時間(s),上下(gal),東西(gal),南北(gal)",
        "時刻［秒］，上下動（gal），東西動（gal），南北動（gal）".replace("，", ","),
        "経過時間（秒）,UD成分加速度（ガル）,EW成分加速度（ガル）,NS成分加速度（ガル）",
        "秒,加速度UD[gal],加速度EW[gal],加速度NS[gal]",
        "時間　上下方向(gal)　東西方向(gal)　南北方向(gal)",
        '"時間(ミリ秒)","上下(cm/s²)","東西(cm/s²)","南北(cm/s²)"',
    ],
)
@pytest.mark.parametrize("coding", ["utf-8", "utf-8-sig", "cp932"])
def test_japanese_headings_are_read(read, names, coding):
    step = 10.0 if "ミリ" in names else 0.01
    if coding == "cp932":
        names = names.replace("²", "2")
    text = f"{names}\n" + "".join(f"{step * i:.2f},{i},{2 * i},{3 * i}\n" for i in range(4))
    if "　" in names:
        text = text.replace(",", " ")
    content = text.encode(coding)
    motion = read(content)
    assert motion.dt == pytest.approx(0.01)
    assert read(content, component="NS").x == pytest.approx([0.0, 0.03, 0.06, 0.09])
    assert read(content, component="EW").x == pytest.approx([0.0, 0.02, 0.04, 0.06])
    assert motion.z == pytest.approx([0.0, 0.01, 0.02, 0.03])


def test_a_japanese_comment_states_the_unit(read):
    assert read("# 単位：gal\n時間,加速度\n0,1\n0.01,2\n0.02,3\n").x == pytest.approx([0.01, 0.02, 0.03])


@pytest.mark.parametrize("heading", ["速度(kine)", "南北速度(cm/s)", "変位(cm)"])
def test_japanese_headings_of_other_quantities_are_refused(read, heading):
    with pytest.raises(InputError, match=r"velocity|displacement"):
        read(f"時間(秒),{heading}\n0,1\n0.01,2\n0.02,3\n", unit="gal")

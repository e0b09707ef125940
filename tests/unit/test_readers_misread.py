"""What a table, a comment or a title says of sensors, order, unit, factor and step is read or refused."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import stayput as sp

TIME = 0.02 * np.arange(200)
WAVE = np.sin(6.0 * TIME)
SIZES = [1.0, 10.0, 30.0, 20.0, 5.0, 2.0, 7.0]


def table(tmp_path, *above, columns=None):
    count = columns or above[-1].count(",") + 1
    rows = (
        ",".join(f"{t if i == 0 else SIZES[i] * a:.3f}" for i in range(count))
        for t, a in zip(TIME, WAVE, strict=True)
    )
    path = tmp_path / "it.csv"
    path.write_text("\n".join([*above, *rows]) + "\n", encoding="utf-8")
    return path


def at2(tmp_path, title, kind="ACCELERATION TIME SERIES IN UNITS OF G"):
    path = tmp_path / "it.AT2"
    samples = (f"{0.1 * a:.6E}" for a in WAVE)
    head = ["PEER STRONG MOTION DATABASE RECORD", title, kind, "NPTS=  200, DT= .02000 SEC"]
    path.write_text("\n".join([*head, *samples]) + "\n", encoding="utf-8")
    return path


def refused(path, **options):
    with pytest.raises(sp.InputError) as caught:
        sp.read_motion(path, **options)
    return caught.value


def codes(path, **options):
    """Return the motion, and the ids of what is warned of."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        motion = sp.read_motion(path, **options)
    return motion, [warning.message.code for warning in told]


@pytest.mark.parametrize(
    "headings",
    [
        "t,STA1_NS,STA2_EW,STA1_UD",
        "t,ground NS,roof NS,roof UD",
        "t,roof NS,ground EW,roof UD",
        "t,NS,NS,UD",
        "t,N,S,UD",
        "t,NS,HNN,UD",
        "t,NS raw,NS corrected,UD",
        "t,sensor1 x,sensor2 y,sensor1 z",
        "t,NS1,EW2,UD2",
        "t,NS_1,EW_2,UD_1",
        "t,NS 1F,EW 5F,UD 1F",
        "t,NS (roof),EW (base),UD (roof)",
    ],
)
def test_channels_of_two_sensors_or_one_direction_make_no_motion(tmp_path, headings):
    path = table(tmp_path, headings)
    error = refused(path, unit="gal")
    assert (error.code, error.field) == ("motion.two_sensors", "component")
    assert "columns, in columns of numbers, those of one sensor" in str(error)
    assert "複数の地震計" in error.told("ja")
    alone, _ = codes(path, unit="gal", component="channel 2")
    assert alone.y is None
    assert alone.z is None
    assert alone.pga == pytest.approx(0.3, rel=1e-3)
    chosen, _ = codes(path, unit="gal", columns="t=1,x=2,z=4")
    assert np.abs(chosen.z).max() == pytest.approx(0.2, rel=1e-3)


@pytest.mark.parametrize(
    "headings",
    [
        "t,NS,EW,UD",
        "t,N-S,E-W,U-D",
        "t,Sta N-S,Sta E-W,Sta U-D",
        "t,acc NS (gal),acc EW (gal),acc UD (gal)",
        "t,CH1 NS,CH2 EW,CH3 UD",
        "t,S1 NS,S1 EW,S1 UD",
        "t,HNN,HNE,HNZ",
        "t,NS_1,EW_2,UD_3",
        "t,No.1 NS,No.2 EW,No.3 UD",
        "t,N (0 deg),E (90 deg),Z",
        "t,H1-000,H2-090,UP",
        "t,NS_gal,EW_gal,UD_gal",
        "t,NS (No.1),EW (No.1),UD (No.1)",
        "t,ax,ay,az",
        "t,NS2,EW2,UD2",
    ],
)
def test_components_of_one_sensor_make_one(tmp_path, headings):
    motion, told = codes(table(tmp_path, headings), unit="gal")
    peaks = [np.abs(samples).max() for samples in (motion.x, motion.y, motion.z)]
    assert peaks == pytest.approx([0.1, 0.3, 0.2], rel=1e-3)
    assert "motion.borehole" not in told


def test_a_csv_of_k_net_with_one_direction_twice_is_refused(tmp_path):
    rows = [
        f"2024/01/01 00:00:00,{t:.2f},{a:.3f},{2 * a:.3f},{a:.3f}" for t, a in zip(TIME, WAVE, strict=True)
    ]
    path = tmp_path / "knet.csv"
    path.write_text("\n".join(["#Unit,gal", "#Offset,0,0,0", "#Date,Time,NS,NS,UD", *rows]) + "\n")
    assert refused(path).code == "motion.two_sensors"


@pytest.mark.parametrize(
    "above",
    [
        ["t,NS1,EW1,UD1"],
        ["# borehole -100 m", "t,NS,EW,UD"],
        ["# downhole sensor", "t,NS,EW,UD"],
        ["# 地中 GL-100m", "t,NS,EW,UD"],
        ["# Borehole array", "t,acc"],
    ],
)
def test_a_borehole_is_warned_of(tmp_path, above):
    assert "motion.borehole" in codes(table(tmp_path, *above), unit="gal")[1]
    assert (
        "motion.borehole"
        not in codes(table(tmp_path, "# surface sensor of a borehole array", "t,acc"), unit="gal")[1]
    )


def test_of_both_sensors_of_kik_net_the_surface_is_taken(tmp_path):
    motion, told = codes(table(tmp_path, "t,NS1,EW1,UD1,NS2,EW2,UD2"), unit="gal")
    assert motion.pga == pytest.approx(0.05, rel=1e-2)
    assert "motion.borehole_left_out" in told


@pytest.mark.parametrize(
    "end",
    [
        "KJMA UP",
        "KJMA, COMP UP",
        "KJMA, Comp=UP",
        "KJMA, -UP",
        "KJMA, (UP)",
        "KJMA, UP-COMP",
        "KJMA, Vertical comp",
        "KJMA, VERT. COMP.",
        "KJMA, Z component",
        "KJMA, V1",
        "KJMA, HNZ--",
        "KJMA, HNZ 00",
        "KJMA, UP (CUE)",
        "Mt. X VERT",
    ],
)
@pytest.mark.parametrize("event", ["Kobe, ", "Kobe 1/16/1995 "])
def test_an_at2_whose_title_ends_in_the_vertical_is_vertical(tmp_path, event, end):
    motion, told = codes(at2(tmp_path, event + end))
    assert told == ["motion.vertical_alone"]
    assert motion.listing.vertical == (True,)


@pytest.mark.parametrize(
    "title",
    ["Kobe, KJMA, 090", "Kobe KJMA 90", "Kobe, SALTON SEA", "Kobe, Station V", "Kobe, Building UP the Hill"],
)
def test_other_titles_are_not(tmp_path, title):
    assert codes(at2(tmp_path, title))[1] == []


@pytest.mark.parametrize(
    "comment", ["ZNE", "tZNE", "t_ZNE", "UNE order", "components: ZNE", "UEN", "zxy", "column order: t Z N E"]
)
def test_an_order_in_letters_is_read(tmp_path, comment):
    motion, _ = codes(table(tmp_path, f"# {comment}", columns=4), unit="gal")
    assert np.abs(motion.z).max() == pytest.approx(0.1, rel=1e-3)


@pytest.mark.parametrize(
    "comment",
    [
        "z first, then x, y",
        "Vertical component first",
        "Dir: 3 1 2",
        "channels: 3 1 2",
        "Data ZNE of A",
        "third: vertical",
    ],
)
def test_another_order_is_refused(tmp_path, comment):
    error = refused(table(tmp_path, f"# {comment}", columns=4), unit="gal")
    assert error.code == "motion.column_order_unread"
    assert "列の順序" in error.told("ja")


@pytest.mark.parametrize(
    "comment",
    [
        "NEZ",
        "XYZ",
        "channels: 1 2 3",
        "x, y and z in gal",
        "Record of the first floor, up to 30 s",
        "Station ONE",
    ],
)
def test_what_names_the_usual_order_or_none_changes_nothing(tmp_path, comment):
    motion, _ = codes(table(tmp_path, f"# {comment}", columns=4), unit="gal")
    assert np.abs(motion.z).max() == pytest.approx(0.2, rel=1e-3)


@pytest.mark.parametrize(
    "unit", ["\N{GREEK SMALL LETTER MU}m/s²", "\N{MICRO SIGN}m/s^2", "\N{GREEK SMALL LETTER MU}gal"]
)
@pytest.mark.parametrize("above", ["t,acc ({})", "t,acc [{}]", "t,acc_{}", "t,acc {}", "# unit: {}"])
def test_millionths_are_no_unit_that_is_known(tmp_path, above, unit):
    error = refused(table(tmp_path, above.format(unit), columns=2))
    assert error.field == "unit"
    assert error.code in ("motion.column_unknown_unit", "motion.unknown_stated_unit", "motion.no_unit")


@pytest.mark.parametrize(
    ("headings", "code"),
    [
        *(
            (f"{first},acc (gal)", "motion.column_no_time")
            for first in ("Frequency (Hz)", "f (Hz)", "freq", "Period (s)")
        ),
        *(
            (f"{first},x (gal)", "motion.column_no_time")
            for first in ("distance (km)", "Frame", "周期(秒)", "周波数(Hz)")
        ),
        *(
            (f"T (s),{value}", "motion.not_acceleration")
            for value in ("Sa (g)", "PSA [gal]", "SA(gal)", "PGA (gal)")
        ),
        *(
            (f"time,{value}", "motion.not_acceleration")
            for value in (
                "Fourier amplitude (gal)",
                "Max acc (gal)",
                "最大加速度 (gal)",
                "Spectral acceleration (g)",
            )
        ),
        ("# Period (s), acc (g)", "motion.column_no_time"),
    ],
)
def test_spectra_and_other_tables_are_no_motions(tmp_path, headings, code):
    error = refused(table(tmp_path, headings))
    assert error.code == code
    if code == "motion.not_acceleration":
        assert "is of a peak or a spectrum" in str(error)
        assert "最大値やスペクトル" in error.told("ja")


@pytest.mark.parametrize("heading", ["Frame time (s)", "Periodic time (s)", "time (s)"])
def test_a_time_of_any_name_is_one(tmp_path, heading):
    assert sp.read_motion(table(tmp_path, f"{heading},acc (gal)")).dt == pytest.approx(0.02)


@pytest.mark.parametrize(
    "heading",
    [
        "acc (gal)x10",
        "acc x 1000 (gal)",
        "acc (cm/s²·10)",
        "acc*10 (gal)",
        "acc (gal) / 10",
        "acc ×10 gal",
        "acc_x100 (gal)",
        "acc 100x (gal)",
        "acc (gal) 1e-3",
    ],
)
def test_a_factor_anywhere_in_a_heading_is_refused(tmp_path, heading):
    error = refused(table(tmp_path, f"t,{heading}"))
    assert error.code == "motion.column_unit_factor"
    assert "states a factor, '" in str(error)
    assert "に倍率「" in error.told("ja")


@pytest.mark.parametrize(
    "heading",
    [
        "time [s*10]",
        "time x 10",
        "time*100 (s)",
        "time (10 ms)",
        "Time (1/100 s)",
        "time (0.01 s)",
        "t (s/100)",
        "time (ds)",
    ],
)
def test_a_factor_of_the_time_is_refused(tmp_path, heading):
    assert refused(table(tmp_path, f"{heading},acc (gal)")).code == "motion.column_time_unit"


@pytest.mark.parametrize(
    "heading",
    [
        "acc (ch 1) [gal]",
        "acc x (gal)",
        "acc2 (gal)",
        "acc 2011/3/10 (gal)",
        "acc x2 [gal]",
        "acc (cm s**-2)",
    ],
)
def test_other_figures_of_a_heading_are_none(tmp_path, heading):
    assert sp.read_motion(table(tmp_path, f"t,{heading}")).pga == pytest.approx(0.1, rel=1e-3)


@pytest.mark.parametrize(
    ("place", "floor"),
    [("FOURTH FLOOR", "floor 4"), ("second floor", "floor 2"), ("LEVEL 4", "floor 4"), ("3/F", "floor 3")]
    + [("Fl. 3", "floor 3"), ("top floor", "upper floor"), ("upper floor", "upper floor"), ("Roof", "roof")]
    + [
        (ground, "")
        for ground in (
            "first floor",
            "ground floor",
            "LEVEL 1",
            "Sea level",
            "basement level 2",
            "level 2 data",
            "level 2 earthquake",
        )
    ],
)
def test_upper_floors_in_titles(tmp_path, place, floor):
    motion, told = codes(at2(tmp_path, f"Kobe, Bldg {place}, 090"))
    assert motion.floor == floor
    assert ("motion.upper_floor" in told) is bool(floor)


@pytest.mark.parametrize("place", ["DOWNHOLE 83 m", "borehole", "Down-hole"])
def test_boreholes_in_titles(tmp_path, place):
    assert codes(at2(tmp_path, f"Kobe, Array {place}, 090"))[1] == ["motion.borehole"]


def test_an_upper_floor_without_a_number_is_said_in_japanese(tmp_path):
    with pytest.warns(sp.InputWarning) as told:
        sp.read_motion(at2(tmp_path, "Kobe, top floor, 090"))
    assert "上の階" in told[0].message.told("ja")


@pytest.mark.parametrize(
    "line",
    [
        "fs = 100",
        "SPS: 100",
        "100 sps",
        "100 samples per second",
        "delta 0.01",
        "interval = 0.01",
        "dt [ms] = 10",
        "dt = 1/100",
        "dt 10 milliseconds",
        "Fs (Hz): 100",
        "sampling period 1/100 s",
    ],
)
def test_a_plain_step_is_read(tmp_path, line):
    path = tmp_path / "one.txt"
    path.write_text("\n".join([f"# {line}", *(f"{a:.3f}" for a in WAVE)]) + "\n")
    assert sp.read_motion(path, unit="gal").dt == pytest.approx(0.01)


@pytest.mark.parametrize(
    "line",
    [
        "dt: 0,01",
        "sampling interval 0.01 min",
        "dt (min) = 0.01",
        "dt = 10 us",
        "sampling rate 0.1 kHz",
        "dt = 0.01 h",
        "dt = 1/0",
        "0 sps",
        "interval 5",
        "Epicentral delta = 30",
    ],
)
def test_any_other_step_is_asked_for(tmp_path, line):
    path = tmp_path / "one.txt"
    path.write_text("\n".join([f"# {line}", *(f"{a:.3f}" for a in WAVE)]) + "\n")
    assert refused(path, unit="gal").code == "motion.no_time_step"
    assert sp.read_motion(path, unit="gal", dt=0.02).dt == 0.02


def test_units_that_contradict_each_other_are_refused(tmp_path):
    error = refused(table(tmp_path, "# unit: gal", "# unit: g", columns=2))
    assert "states the units 'gal' and 'g'; they must agree" in str(error)
    assert "異なる単位" in error.told("ja")
    assert sp.read_motion(table(tmp_path, "# unit: gal", "# unit: cm/s2", columns=2)).pga == pytest.approx(
        0.1
    )


@pytest.mark.parametrize(
    "kind", ["VEL TIME SERIES", "VELOCITY TIME SERIES", "DISP TIME SERIES", "DIS. TIME HISTORY"]
)
def test_an_at2_of_another_quantity_is_refused_whatever_its_unit(tmp_path, kind):
    error = refused(at2(tmp_path, "Kobe, KJMA, 090", f"{kind} IN UNITS OF G"))
    assert error.code == "motion.not_acceleration"


@pytest.mark.parametrize(
    "last", ["Absolute acceleration (m/s^2)", "total (gal)", "magnitude", "aT (m/s^2)", "合成 (gal)"]
)
def test_the_magnitude_beside_the_axes_is_left_out(tmp_path, last):
    unit = "m/s^2" if "m/s" in last else "gal"
    axes = ",".join(f"Linear Acceleration {axis} ({unit})" for axis in "xyz")
    motion, told = codes(table(tmp_path, f"Time (s),{axes},{last}"), remove_mean=True)
    assert "motion.columns_left_out" in told
    assert motion.z is not None


def test_a_refusal_of_columns_proposes_which_to_take(tmp_path):
    path = table(tmp_path, "t,z (gal),x (gal),y (gal),foo (gal)")
    error = refused(path)
    assert "as in t=1,x=3,y=4,z=2." in str(error)
    assert "例：「t=1,x=3,y=4,z=2」" in error.told("ja")
    assert sp.read_motion(path, columns="t=1,x=3,y=4,z=2").pga == pytest.approx(0.3, rel=1e-3)
    assert "as in t=1,x=2." in str(refused(table(tmp_path, "t,foo (gal),bar (gal)")))

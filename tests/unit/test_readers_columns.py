"""Columns of numbers: what stands above them of time, order, unit, factor and step is read or refused."""

from __future__ import annotations

import pytest

from record_files import UP_FIRST, UP_LAST, peaks, table

OF_UP_FIRST = [
    "#DATASEQUENCE: TIME U(+); N(+); E(+)",
    "# columns: t, UD, NS, EW",
    "# Data columns = Time; Vertical; N-S; E-W",
    "# Fields: time UP NORTH EAST",
    "# column 1: Time (s)\n# column 2: UD\n# column 3: NS\n# column 4: EW",
    "% col 1 = t | col 2 = Z (gal) | col 3 = N (gal) | col 4 = E (gal)",
    "# t [s]  UD  NS  EW\n# event of magnitude 7, unit: gal",
    "A record\nColumns: time, UD, NS, EW",
    "# ch1: UD, ch2: NS, ch3: EW",
    "# UP NORTH EAST",
    "# Channels: UD, NS, EW",
    "# x: UD, y: NS, z: EW",
    "! time | UD | NS | EW",
    "t UD NS EW\n---- ---- ---- ----",
    "# t UD NS EW\n# s gal gal gal",
    "t,UD,NS,EW\ns,gal,gal,gal",
    "# tZNE",
    "# UNE order",
    "# components: ZNE",
    "# column order: t Z N E",
    "# Order: Z N E",
    "t,V,L,T",
    "Time (s),U,N,E",
    "時刻［秒］,上下動（gal）,東西動（gal）,南北動（gal）",
    "経過時間（秒）,UD成分加速度（ガル）,EW成分加速度（ガル）,NS成分加速度（ガル）",
    "秒,加速度UD[gal],加速度EW[gal],加速度NS[gal]",
    "時間[s],縦揺れ[gal],横揺れ1[gal],横揺れ2[gal]",
    "时间[s],垂直[gal],南北[gal],东西[gal]",
]
OF_UP_LAST = [
    "# NEZ",
    "# channels: 1 2 3",
    "# x, y and z in gal",
    "# Record of the first floor, up to 30 s",
    "# Lat 35.1 N, Lon 139.2 E, Version V2",
    "Quake of 2020\nTime (s),NS (gal),EW (gal),UD (gal)",
    "1968 quake of May\nStation: PLACE, 34.5 N 135.5 E\n\nDT = 0.02\nt,NS (gal),EW (gal),UD (gal)",
    "Time,N-S,E-W,U-D\n[s],[cm/s/s],[cm/s/s],[cm/s/s]",
    '"Time","NS","EW","UD"\n"(sec)","(Gal)","(Gal)","(Gal)"',
    "地震の記録\n時間,南北,東西,上下\n秒,ガル,ガル,ガル",
    "Time,L (gal),T (gal),V (gal)",
    "time,BHN00,BHE00,BHZ00",
    '"Time (s)","Linear Acceleration x (gal)","Linear Acceleration y (gal)","Linear Acceleration z (gal)"',
    "time\tgFx\tgFy\tgFz",
    "Time (s)\tAcc NS (gal)\tAcc EW (gal)\tAcc UD (gal)",
    "t,Sta N-S,Sta E-W,Sta U-D",
    "t,CH1 NS,CH2 EW,CH3 UD",
    "t,S1 NS,S1 EW,S1 UD",
    "t,NS_1,EW_2,UD_3",
    "t,No.1 NS,No.2 EW,No.3 UD",
    "t,N (0 deg),E (90 deg),Z",
    "t,H1-000,H2-090,UP",
    "t,NS (No.1),EW (No.1),UD (No.1)",
    "t,ax,ay,az",
    "t,NS2,EW2,UD2",
    *(f"{mark}time [s],NS [gal],EW [gal],UD [gal]" for mark in ("\ufeff\ufeff", "\u202e", "\u200b")),
]
OF_OTHERS = [
    ("t,y,x,z", {"x": 0.3, "y": 0.1, "z": 0.2}),
    ("t,acc_y,acc_x,z", {"x": 0.3, "y": 0.1, "z": 0.2}),
    ("t,NS1,EW1,UD1,NS2,EW2,UD2", {"x": 0.05, "y": 0.02, "z": 0.07}),  # of KiK-net the sensor at the surface
    ("t,NS [m/s],EW [gal],UD [gal]", {"x": 0.3, "z": 0.2}),
    ("time,acceleration,velocity,displacement", {"x": 0.1}),
    ("Time (s);Vel (cm/s);Accel;Disp (cm)", {"x": 0.3}),
    ("# t [s], v, a, d", {"x": 0.3}),
    ("時間(秒),加速度,速度(kine),変位(cm)", {"x": 0.1}),
    *(
        (f"t,ax (gal),ay (gal),az (gal),{last}", UP_LAST)
        for last in ("Absolute acceleration (gal)", "total (gal)", "magnitude", "aT (gal)", "合成 (gal)")
    ),
]


@pytest.mark.parametrize(
    ("head", "expected"),
    [*((head, UP_FIRST) for head in OF_UP_FIRST), *((head, UP_LAST) for head in OF_UP_LAST), *OF_OTHERS],
)
def test_what_a_head_says_of_the_columns_is_followed(read, head, expected):
    count = 4 if head.rpartition("\n")[2].startswith(("#", "%", "!", "A ", "Col", "---")) else None
    motion, warned = read(table(head, count), unit="gal")
    assert peaks(motion) == expected
    left_out = "borehole" if "NS1,EW1" in head else "columns" if (head, expected) in OF_OTHERS[3:] else ""
    codes = {warning.code for warning in warned} - {"motion.x_chosen", "motion.unit_mentioned"}
    assert codes == ({f"motion.{left_out}_left_out"} if left_out else set())


REFUSED = {
    ("column_order", 4): ["# columns: t, A, B, C", "#DataSequence: Time U(+); N(+)"],
    ("column_order", 2): ["# t, UD, NS, EW\n# from 2020", "t,UD,NS,EW", "# column 1: time\n# column 3: UD"],
    ("column_order", None): ["time,time 2,NS,EW", "time [s],αβγ[gal],δεζ[gal],ηθι[gal]"],
    ("column_order_unread", 4): [
        "# z first, then x, y",
        "# Vertical component first",
        "# Dir: 3 1 2",
        "# Data ZNE of A",
        "# third: vertical",
        "# time -> UD -> NS -> EW",
        "# 1) time\n# 2) UD\n# 3) NS\n# 4) EW",
        "Station ABC  Channels V NS EW",
    ],
    ("header_line", 2): ["time,acc\nof the north"],
    ("other_sign", 4): [
        "#DataSequence: Time U(-); N(+); E(+)",
        "# z positive down",
        "# UD: + down",
        "# 上下動は下向きが正",
        "# Positive downwards\nt,NS,EW,UD",
    ],
    ("other_sign", None): [
        "t,NS,EW,-Z",
        "t,NS,EW,\N{MINUS SIGN}UD",
        "t,NS,EW,UD-",
        "t,NS,EW,UD(-)",
        "t,NS,EW,Z (positive down)",
        "t,NS,EW,az_down",
        "t,NS,EW,上下（下向き）",
    ],
    ("common.not_allowed", None): [
        "time [min],NS [gal]",
        "time [s*10],acc",
        "time x 10,acc",
        "time (10 ms),acc",
        "Time (1/100 s),acc",
        "t (s/100),acc",
        "time (ds),acc",
    ],
    ("column_no_time", None): [
        "no,L,V,T",
        "NS,EW,UD,clock",
        "NS [gal],EW [gal],UD [gal],UP [gal]",
        "X,Y",
        "L,T,V,R",
        "distance (km),x (gal)",
        "Frame,x (gal)",
    ],
    ("not_acceleration", None): [
        "T (s),Sa (g)",
        "f (Hz),acc (gal)",
        "Period (s),acc (gal)",
        "period_s,sa_x_m_s2",
        "周期(秒),x (gal)",
        "# Period (s), acc (gal)",
        "T (s),PSA [gal]",
        "T (s),PGA (gal)",
        "time,Fourier amplitude (gal)",
        "time,Max acc (gal)",
        "time,最大加速度 (gal)",
        "t,NS (cm/sec)",
        "t,NS_kine",
        "t,vel_NS",
        "t,NS [mm]",
        "t,NS_cm",
        "t,Displacement NS",
        "t,Gyroscope x (rad/s)",
        "t,vel\ns,in/s",
        "時間(秒),南北速度(cm/s)",
        "時間(秒),変位(cm)",
        "time,acc [counts]",
    ],
    ("not_acceleration", 2): [
        "# unit: counts",
        "# UNITS: cm/s",
        "# number of velocity points: 60, dt: 0.02",
        "Corrected velocity time history",
        "# quantity: displacement",
        "# 速度波形",
        *(
            f"{mark}{line}"
            for mark in ("# ", "% record of 1995\n# ")
            for line in (
                "ground velocity, m/s",
                "Kobe NS vel cm/s",
                "Kobe 1995 NS (cm/sec)",
                "速度 kine",
                "変位 cm",
                "NS成分、mm",
                "Bodengeschwindigkeit (m/s)",
                "Verschiebung",
                "vitesse",
                "velocidad cm s-1",
                "displacements [m]",
                "kine",
            )
        ),
        "Acceleration response spectrum, damping 5 %",
        "加速度応答スペクトル（減衰5%）",
    ],
    ("column_unit_factor", None): [
        "t,acc (gal)x10",
        "t,acc x 1000 (gal)",
        "t,acc (cm/s²·10)",
        "t,acc*10 (gal)",
        "t,acc (gal) / 10",
        "t,acc 100x (gal)",
        "t,acc (gal) 1e-3",
        "t,加速度(0.1gal)",
        "t,acc [g x1000]",
        "t,acc [10-3 g]",
        "t,acc (x10^-2 m/s2)",
        "t,acc [G (X 1000)]",
    ],
    ("column_factor", 2): ["# scale factor: 0.1", "# multiply by 0.001", "# factor = 2", "# 倍率：10"],
    ("stated_twice", 2): ["# unit: gal\n# unit: g"],
    ("many_channels", None): [
        "t,STA1_NS,STA2_EW,STA1_UD",
        "t,roof NS,ground EW,roof UD",
        "t,NS,NS,UD",
        "t,N,S,UD",
        "t,NS,HNN,UD",
        "t,NS raw,NS corrected,UD",
        "t,NS1,EW2,UD2",
        "t,NS_1,EW_2,UD_1",
        "t,NS 1F,EW 5F,UD 1F",
        "t,NS (roof),EW (base),UD (roof)",
    ],
    ("column_count", None): ["t,foo (gal),bar (gal)", "t,z (gal),x (gal),y (gal),foo (gal)"],
    ("no_time_step", 1): [
        "# dt: 0,01",
        "# sampling interval 0.01 min",
        "# dt = 10 us",
        "# sampling rate 0.1 kHz",
        "# dt = 1/0",
        "# 0 sps",
        "# interval 5",
        "# Epicentral delta = 30",
    ],
}
UNIT_OPEN = {
    ("column_no_unit", None): ["t,NS (gal),EW (g),UD"],
    ("stated_twice", None): ["# unit: m/s²\nt,NS (gal),EW (gal),UD (gal)"],
    ("no_unit", None): ["t,acc (filtered)", "t,acc (NS)", "t,acc_µgal"],
    ("no_unit", 2): ["", "# recorder unit (S/N 3)", "Taken from RENADIC\nt,acc"],
    ("no_unit_nor_step", 1): [""],
    ("no_unit_but_mentioned", 2): ["# acc_gal (band-passed)", "# acceleration [cm/s²]", "# no,acc(gal)"],
    ("no_unit_but_mentioned", None): ["t,NS (gal),EW (gal),UD"],
    ("unknown_stated_unit", None): ["time [s],acc [km/h2]", "Time,Acc\n(s),(kip)", "t,acc (μm/s²)"],
    ("unknown_stated_unit", 2): [
        "# UNITS OF G * 10",
        "# unit: G (X 1000)",
        "# units = 0.01 g",
        "# unit: g/10",
    ],
}
FIELDS = {
    "unit": (
        "no_unit",
        "no_unit_nor_step",
        "no_unit_but_mentioned",
        "unknown_stated_unit",
        "column_unit_factor",
    ),
    "columns": ("column_no_time",),
    "skip_lines": ("column_factor",),
    "component": ("many_channels",),
    "dt": ("no_time_step",),
}


@pytest.mark.parametrize(
    ("code", "head", "columns", "given"),
    [
        (code, head, columns, given)
        for cases, given in ((REFUSED, {"unit": "gal"}), (UNIT_OPEN, {}))
        for (code, columns), heads in cases.items()
        for head in heads
    ],
)
def test_a_head_that_is_not_understood_or_forbids_it_is_refused(refusal, code, head, columns, given):
    error = refusal(table(head, columns), **given)
    assert error.code == (code if "." in code else f"motion.{code}")
    assert error.field == next((field for field, codes in FIELDS.items() if code in codes), None)


@pytest.mark.parametrize(
    ("head", "factor"),
    [
        ("t,acc (mG)", 9.80665e-3),
        ("t,acc_mg", 9.80665e-3),
        ("t,acc [%g]", 9.80665e-2),
        ("t,acc [in/s2]", 0.0254),
        ("t,acc (in/sec/sec)", 0.0254),
        ("t,acc [ft/s^2]", 0.3048),
        ("t,acc_x_m_s2", 1.0),
        ("t,ax_mps2", 1.0),
        ("t,Acceleration (m·s⁻²)", 1.0),
        ("t,acc [cm/sec**2]", 0.01),
        ("Time [S],NS (Gal)", 0.01),
        ("t,g", 9.80665),
        ('"time_s","ax_g"', 9.80665),
        ("t,acc (ch 1) [gal]", 0.01),
        ("t,acc 2011/3/10 (gal)", 0.01),
        ("t,acc x2 [gal]", 0.01),
        ("# Unit = gal", 0.01),
        ("#AmplitudeUnit:  gal. DCoffset(corr)", 0.01),
        ("# unit of measurement: gal, filtered below 50 Hz", 0.01),
        ("# time unit: s, unit: gal", 0.01),
        ("# Unit of time: s\n# unit of acceleration: gal", 0.01),
        ("# unit: gal\n# unit: cm/s2", 0.01),
        ("# 単位：gal", 0.01),
        ("# unit: gal\n# station at x: 135.2 E, y: 35.1 N", 0.01),
        ("# unit: gal\n# scaled record, large scale test 2 of 3, scale factor: 1.0", 0.01),
    ],
)
def test_a_unit_that_is_stated_is_used(read, refusal, head, factor):
    motion, warned = read(table(head, 2))
    assert motion.pga == pytest.approx(10.0 * factor, rel=1e-3)
    assert {warning.code for warning in warned} <= {"motion.large_peak"}
    error = refusal(table(head, 2), unit="mm/s²")
    assert (error.code, error.field) == ("motion.not_the_files_own", "unit")


def test_each_column_has_the_unit_of_its_own_heading(read):
    spaced = table("t [s]  NS [m/s2]  EW [gal]  UD [%g]", 4).replace(",", " ")
    for text in (table("time [s],NS [m/s2],EW [gal],UD [%g]"), table("# t; NS_m/s/s; EW_gal; UD_%g"), spaced):
        motion, _ = read(text, component="NS")
        assert peaks(motion) == pytest.approx({"x": 10.0, "y": 0.3, "z": 0.2 * 9.80665}, rel=1e-3)


@pytest.mark.parametrize(
    "head", [head for heads in UNIT_OPEN.values() for head in heads if "G" in head or "k" in head]
)
def test_a_unit_that_is_not_known_may_be_given(read, head):
    motion, warned = read(table(head, 2), unit="gal")
    assert motion.pga == pytest.approx(0.1, rel=1e-3)
    assert {warning.code for warning in warned} <= {"motion.unit_mentioned"}


OF_STEP = [
    "dt = 0.005",
    "DT=.005 s",
    "dt: 5 ms",
    "dt [s]: 0.005",
    "Sampling interval (sec) = 5e-3",
    "sampling rate: 200 Hz",
    "Sampling frequency [Hz] 200",
    "時間刻み：0.005秒",
    "サンプリング周波数 200Hz",
    "fs = 200",
    "SPS: 200",
    "200 samples per second",
    "delta = 0.005",
    "dt = 1/200",
    "dt 5 milliseconds",
]


@pytest.mark.parametrize("mark", ["# ", ""])
@pytest.mark.parametrize("line", OF_STEP)
def test_a_time_step_that_is_stated_is_used_or_contradicted(read, refusal, line, mark):
    head = f"{mark}{line}"
    for dt in (None, 0.005):
        assert read(table(head, 1), unit="gal", dt=dt)[0].dt == pytest.approx(0.005)
    assert refusal(table(head, 1), unit="gal", dt=0.02).code == "motion.not_the_files_own"
    error = refusal(table(head, 2), unit="gal")
    assert "states the time step 0.005 s and the file has 0.02 s" in str(error)


@pytest.mark.parametrize(
    "line",
    [
        "# dt = 0.02",
        "# 50 Hz",
        "# duration 1.2 s",
        "# dt unknown",
        "# No. 5",
        "# shear wave velocity (m/s) 300",
        "# acceleration, from velocity data",
        "# accelerogram that matches a response spectrum",
        *(
            f"# velocity of the truck\n# {line}"
            for line in (
                "NS, m/s2",
                "NS cm/s/s",
                "gal",
                "cm s-2",
                "Beschleunigung",
                "PGA (m/s^2)",
                "unit: gal",
            )
        ),
        "# S波速度 300 m/s",
        "# peak ground velocity: 30 cm/s",
        "# sensor depth (m): 30; plate of 5 cm",
    ],
)
def test_lines_that_contradict_nothing_are_read_over(read, line):
    assert read(table(line, 2), unit="gal")[0].dt == 0.02


@pytest.mark.parametrize(
    ("head", "dt"),
    [("time [ms],x", 2e-5), ("t (msec),x", 2e-5), ("time_ms,x", 2e-5), ("Zeit [ms],x", 2e-5)]
    + [(f"{name},x", 0.02) for name in ("T", "Frame time (s)", "Periodic time (s)", "sec")],
)
def test_a_time_of_any_name_is_one(read, head, dt):
    assert read(table(head), unit="gal")[0].dt == pytest.approx(dt)


def test_the_time_is_the_column_that_is_headed_so(read):
    rows = "".join(f"{-i},{2 * i},{3 * i},{0.01 * i:.2f}\n" for i in range(4))
    for comment in ("", "# "):
        motion, _ = read(f"{comment}NS [gal],EW [gal],UD [gal],time [s]\n{rows}", component="EW")
        assert motion.dt == 0.01
        assert peaks(motion) == {"x": 0.06, "y": 0.03, "z": 0.09}


@pytest.mark.parametrize(
    ("head", "columns", "codes"),
    [
        *(
            (f"{line}\n# unit: gal", columns, ["vertical_alone"])
            for columns in (1, 2)
            for line in ("# Component: UD", "# channel = HNZ", "Direction: Up", "# 成分：上下")
        ),
        ("# component: NS\n# unit: gal", 2, []),
        ("time,Linear Acceleration z (gal)", None, ["vertical_alone"]),
        ("time,Acceleration UD", None, ["vertical_alone"]),
        ("time,V", None, ["vertical_alone"]),
        ("# borehole -100 m\nt,NS,EW,UD", None, ["x_chosen", "borehole"]),
        ("t,NS1,EW1,UD1", None, ["x_chosen", "borehole"]),
        ("# 地中 GL-100m\nt,acc", None, ["borehole"]),
        ("# surface sensor of a borehole array\nt,acc", None, []),
        ("# 42nd floor\nt,acc", None, ["upper_floor"]),
        ("# seismogram of a large gallery\nt,acc", None, []),
        ("# Station: TST, component 3 of 3", 2, []),
    ],
)
def test_what_is_doubtful_is_told(read, head, columns, codes):
    motion, warned = read(table(head, columns), unit="gal", dt=0.02)
    assert motion.pga == pytest.approx(0.1, rel=1e-3)
    assert [warning.code for warning in warned] == [f"motion.{code}" for code in codes]


def test_a_sensor_that_is_chosen_is_read_alone(read):
    text = table("t,STA1_NS,STA2_EW,STA1_UD")
    assert peaks(read(text, unit="gal", component="channel 2")[0]) == {"x": 0.3}
    assert peaks(read(text, unit="gal", columns="t=1,x=2,z=4")[0]) == {"x": 0.1, "z": 0.2}


@pytest.mark.parametrize("name", ["Down", "DN", "acc_down"])
def test_a_channel_that_is_called_down_is_turned(read, name):
    motion, _ = read(table(f"# positive down\nt,NS,EW,{name}"), component="NS", unit="gal")
    assert motion.z == pytest.approx(-2.0 * motion.x, abs=2e-5)


@pytest.mark.parametrize(
    "names", ["UD,UD2,UD3", "acceleration_UD,acceleration_UD2,acceleration_UD3", "a 1 (x),a 2 (x),a 3 (x)"]
)
def test_columns_have_names_of_their_own(read, names):
    motion, _ = read(table(f"time,{names}"), unit="gal", component=names.split(",")[1].split(" (")[0])
    assert motion.pga == pytest.approx(0.3, rel=1e-3)
    assert len(set(motion.listing.names)) == 3

"""Records in the formats of agencies: the variants of their headers, and what is refused."""

from __future__ import annotations

import re
from contextlib import suppress

import numpy as np
import pytest

import stayput as sp
from record_files import (
    COUNTS,
    ROWS,
    SCALE,
    VALUES,
    WAVE,
    asa,
    at2,
    cosmos,
    csmip_channel,
    esm,
    jma,
    knet,
    knet_csv,
)

IN_G = [9.80665 * v for v in VALUES]
SIZES = {
    "old": "NPTS=     7, DT= .01000 SEC",
    "ngawest2": "NPTS =      7 , DT =   .010 SEC ,                                      ",
    "tight": "NPTS=7,DT=.01",
    "bare": "7    0.0100    NPTS, DT",
    "small letters": "npts= 7, dt= .01 sec",
    "colons": "NPTS: 7, DT: 0.01",
}
THREE = csmip_channel(1, " 90 DEG") + csmip_channel(2, "UP", 2 * WAVE) + csmip_channel(3, "360 DEG", 3 * WAVE)
THREE_COSMOS = cosmos() + cosmos(2 * WAVE, label="2: Up") + cosmos(3 * WAVE, label="3:  90 Deg")
VELOCITY = cosmos(kind="velocity", end="End-of-data for Chan 1 velocity\n")
END = "/&  ----------  End of data for channel  1  ----------\n"


@pytest.mark.parametrize("ends", ["\n", "\r\n", "\r\r\n", "\r"])
@pytest.mark.parametrize("size", SIZES)
def test_peer_headers_and_line_ends(read, size, ends):
    motion, _ = read(at2(SIZES[size]).replace("\n", ends))
    assert motion.dt == pytest.approx(0.01)
    assert motion.x == pytest.approx(IN_G)
    assert motion.name == "VALLEY 1/2/99 0304, STATION NINE, 090"
    assert "PEER AT2" in motion.source


def test_peer_units_and_steps(read, refusal):
    for unit, given in (("", "gal"), ("IN UNITS OF CM/S/S", None)):
        assert read(at2(unit=unit), unit=given)[0].x == pytest.approx([0.01 * v for v in VALUES])
    assert read(at2(), unit="g", dt=0.01)[0].dt == 0.01
    for unit in ("UNITS: GAL", "UNITS = GAL", "IN UNITS OF GAL"):
        assert "the file states, 'GAL'" in str(refusal(at2(unit=unit), unit="g"))
    assert "the file states, 0.01 s" in str(refusal(at2(), dt=0.02))


@pytest.mark.parametrize("event", ["Kobe, ", "Kobe 1/16/1995 "])
@pytest.mark.parametrize(
    "end",
    [
        "KJMA UP",
        "KJMA, Comp=UP",
        "KJMA, (UP)",
        "KJMA, UP-COMP",
        "KJMA, VERT. COMP.",
        "KJMA, Z component",
        "KJMA, V1",
        "KJMA, BHZ 00",
        "KJMA, UP (CUE)",
        "KJMA, DWN",
    ],
)
def test_a_title_that_ends_in_the_vertical(read, event, end):
    motion, warned = read(at2(title=event + end))
    assert [warning.code for warning in warned] == ["motion.vertical_alone"]
    assert motion.listing.vertical == (True,)
    assert motion.x == pytest.approx([(-1.0 if "DWN" in end else 1.0) * a for a in IN_G])


@pytest.mark.parametrize(
    ("title", "name", "codes"),
    [
        ("Kobe, KJMA, 090", "a.at2", []),
        ("Kobe KJMA 90", "a.at2", []),
        ("Kobe, SALTON SEA", "a.at2", []),
        ("Kobe, Station V", "a.at2", []),
        ("Kobe, Building UP the Hill", "a.at2", []),
        ("QUAKE 1/2/99, N PALM SPRINGS", "a.at2", []),
        ("QUAKE, PLACE, BHN00", "RSN1_BHN00.AT2", []),
        ("no direction", "backup.at2", []),
        ("no direction", "RSN1_QUAKE_BHZ00.AT2", ["vertical_by_name"]),
        ("no direction", "A-PLCDWN.AT2", ["vertical_by_name"]),
        ("no direction", "station_ud.at2", ["vertical_by_name"]),
        ("Kobe, Array DOWNHOLE 83 m, 090", "a.at2", ["borehole"]),
        ("Kobe, Array Down-hole, 090", "a.at2", ["borehole"]),
        ("Kobe, 42ND FLOOR, 090", "a.at2", ["upper_floor"]),
    ],
)
def test_other_titles_and_names(read, title, name, codes):
    motion, warned = read(at2(title=title), name)
    assert [warning.code for warning in warned] == [f"motion.{code}" for code in codes]
    assert motion.name == title


@pytest.mark.parametrize("count", [3, 6, 11, 60])
def test_a_file_that_ends_within_a_number_is_refused_and_without_a_last_line_end_is_not(read, refusal, count):
    whole = at2(values=(VALUES * 10)[:count], size=f"NPTS= {count}, DT= .01").rstrip("\n")
    assert len(read(whole)[0]) == count
    for cut in (1, 3, 5):
        assert refusal(whole[:-cut]).code == "motion.file_cut"


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"tail": ",,"},
        {"rate": " SAMPLING RATE= 1e2Hz ", "names": " NS,EW,UD,,"},
        {"rate": " Sampling Freq= 100.0 Hz,,"},
        {"rate": " Sampling Freq(Hz)= 100"},
        {"initial": "INITIAL TIME = 16 04 14 21 26 20"},
    ],
)
def test_jma_headers_in_any_coding(read, changes):
    for coding in ("cp932", "utf-8", "utf-8-sig"):
        motion, _ = read(jma(**changes).encode(coding))
        assert motion.dt == 0.01
        assert np.stack([motion.x, motion.y, motion.z], axis=1) == pytest.approx(0.01 * np.array(ROWS))
        assert motion.name == "123試験町, NS"
    small = "Site  Code= 1\nsampling rate= 50Hz\nunit = gal\nud,ew,ns\n1,2,3\n-1,2,3\n"
    motion, _ = read(small, component="EW")
    assert (motion.dt, motion.x[0], motion.y[0], motion.z[0]) == pytest.approx((0.02, 0.02, 0.03, 0.01))


@pytest.mark.parametrize(
    "spell", [str.lower, str.upper, lambda key: key.replace("Max. ", "Max ").replace("Long", "Lon")]
)
def test_knet_is_calibrated_once_and_freed_of_its_offset(read, spell):
    lines = knet().split("\n")
    motion, _ = read(
        "\n".join([*(spell(line[:18]).ljust(18) + line[18:] for line in lines[:17]), *lines[17:]])
    )
    assert motion.x == pytest.approx(0.01 * SCALE * (COUNTS - COUNTS.mean()), rel=1e-12)
    assert motion.dt == pytest.approx(0.01)
    assert motion.name == "TST001, NS"
    assert "offset removed" in motion.source


@pytest.mark.parametrize(
    ("direction", "name"), [("1", "NS1"), ("3", "UD1"), ("5", "EW2"), ("6", "UD2"), ("U-D", "UD")]
)
def test_kiknet_directions(read, direction, name):
    assert read(knet(direction))[0].name == f"TST001, {name}"


def test_knet_csv_is_freed_of_its_offset(read):
    motion, _ = read(knet_csv())
    assert np.stack([motion.x, motion.y, motion.z], axis=1) == pytest.approx(0.01 * np.array(ROWS), abs=1e-9)
    assert (motion.dt, motion.name) == (pytest.approx(0.01), "TST001, NS")
    swapped = knet_csv(names="#Datetime,Relative Time(s),E-W (gal),N-S (gal),U-D (gal)").replace(
        "#Off", "#off"
    )
    assert read(swapped, component="NS")[0].x == pytest.approx([0.01 * row[1] for row in ROWS], abs=1e-9)


@pytest.mark.parametrize(
    "spell",
    [
        str,
        str.lower,
        lambda text: text.replace(": ", " : "),
        lambda text: text.replace(": ", ":"),
        lambda text: "".join(f"  {line}\n" for line in text.splitlines()),
    ],
)
def test_esm_headers_in_any_case_and_spacing(read, spell):
    motion, warned = read(spell(esm(DURATION_S="0.105")))
    assert motion.x == pytest.approx(0.01 * WAVE)
    assert (motion.dt, warned) == (0.005, [])
    assert motion.name.upper() == "XX.ABC, TEST-1, HNE"
    assert [warning.code for warning in read(spell(esm(STREAM="U")))[1]] == ["motion.vertical_alone"]


def test_csmip_channels_in_any_case_and_layout(read):
    motion, _ = read(THREE)
    for name, size in (("x", 0.01), ("y", 0.03), ("z", 0.02)):
        assert motion.components[name] == pytest.approx(size * WAVE)
    assert (motion.dt, motion.name) == (0.02, "FAULT ZONE 14, NOWHERE EARTHQUAKE, 90 DEG")
    assert read(THREE, component="NS")[0].x == pytest.approx(0.03 * WAVE)
    touching = np.array([-12345.678, -99999.999, 1234.5, -54321.123, 10.0])
    assert read(csmip_channel(1, "90 DEG", touching))[0].x == pytest.approx(0.01 * touching)
    other = csmip_channel(1, "90 DEG", unit=", in cm/sec2. (5f12.4)", layout=("%12.4f", 5))
    spaced = (
        csmip_channel(1, "90 DEG").replace("EQUALLY SPACED AT", "EQUALLY-SPACED  AT").replace("/&", " /&")
    )
    for text in (other, csmip_channel(1, "90 DEG").lower(), spaced):
        assert read(text)[0].x == pytest.approx(0.01 * WAVE)


@pytest.mark.parametrize(
    "end",
    [
        END,
        END.upper(),
        "End of data for channel 1\n",
        "End-of-data for Chan HNE acceleration\n",
        "End-of-data for 1111.HNE.XX.-- acceleration\n",
    ],
)
@pytest.mark.parametrize("kind", ["acceleration", "accel.", "uncor. accel.", "corrected acceleration"])
def test_cosmos_blocks_and_their_ends_in_the_spellings_in_use(read, end, kind):
    labels = enumerate(("1: 360 Deg", "2: 90 Deg", "3: HNZ00"), 1)
    motion, _ = read("".join(cosmos(i * WAVE, label=label, kind=kind, end=end) for i, label in labels))
    assert motion.dt == 0.005
    assert motion.name == "Nowhere Earthquake of Fri Nov 30, 2018, 360"
    for name, size in (("x", 0.01), ("y", 0.02), ("z", 0.03)):
        assert motion.components[name] == pytest.approx(size * WAVE)
    assert read(THREE_COSMOS, component="EW")[0].z == pytest.approx(0.02 * WAVE)


def test_cosmos_has_the_direction_of_the_last_line_where_no_other_states_one(read, refusal):
    text = cosmos(label="", end="End-of-data for 1111.HNE.XX.-- acceleration\n")
    assert read(text)[0].source == "COSMOS V1.20: x = HNE"
    assert "raw counts" in str(refusal(text.replace("cm/sec2(04)", "counts (50)")))


def test_cosmos_velocities_are_passed_over_and_a_missing_interval_is_given(read):
    for velocity in (VELOCITY, VELOCITY[VELOCITY.index(f"   {len(WAVE)} velocity") :]):
        assert read(cosmos() + velocity)[0].x == pytest.approx(0.01 * WAVE)
    assert read(cosmos(interval=-999.0), dt=0.01)[0].dt == 0.01


def test_asa_directions_are_bearings(read):
    for orientation, names in (("/N90E;/N00E;/V;+", ("90", "0")), ("/N30W/S60W/V", ("330", "240"))):
        motion, _ = read(asa(orientation=orientation))
        assert np.stack([*motion.components.values()], axis=1) == pytest.approx(0.01 * np.array(ROWS))
        assert (motion.dt, motion.listing.names) == (0.01, (*names, "V"))


REFUSED = {
    "asa": [
        (asa(count=5), "number of samples 5 and the file has 4"),
        (asa(orientation=""), "no direction"),
        (asa(orientation="/N90E;/N00E;/V;-"), "positive the other way"),
        (asa(orientation="/N90E;/N00E"), "no time step"),
        (asa(unit=""), "no unit"),
        (asa(steps="/0.01/0.01/0.02"), "dt of z is 0.02 s"),
        (asa(rows=[*ROWS, (1.0, 2.0)]), "it must have 3 values"),
    ],
    "peer": [
        (at2(unit=""), "no unit"),
        (at2(unit="IN UNITS OF FURLONGS"), "'FURLONGS'"),
        (at2(unit="IN UNITS OF G * 10"), r"states the unit 'G \* 10'"),
        (at2(values=VALUES[:-1]), "number of samples 7 and the file has 6"),
        (at2(values=[*VALUES, 1.0]), "number of samples 7 and the file has 8"),
        (at2(values=[]), "has 0"),
        (at2(size="NPTS= 7, DT= 0.0"), "time step"),
        (at2(size="NPTS= 7, DT= 1.2.3"), "'1.2.3'"),
        (at2(size="NPTS= 7, DT= .5 MSEC"), "must be"),
        (at2(size="NPTS= 1,007, DT= .01"), "it must state NPTS"),
        (at2(size="NPTS= 7 DT= 100 Hz"), "must be"),
        (at2(size="NPTS= 6.5, DT= 0.01"), "samples"),
        (at2().replace("-.", "***"), "decimal number"),
        (at2().replace("ACCELERATION", "VEL").replace("OF G", "OF CM/S"), "is of velocity"),
        (at2().replace("ACCELERATION", "DIS."), "is of displacement"),
    ],
    "jma": [
        (jma(unit=""), "no unit"),
        (jma(unit=" UNIT = kine"), "'kine'"),
        (jma(rate=" SAMPLING RATE="), "sampling frequency"),
        *(
            (jma(rate=f" SAMPLING RATE= {rate}"), "it must be one number")
            for rate in ("0Hz", "1,000Hz", "1/100 sec", "100 kHz", "100Hz 50Hz", "1_00", "nan")
        ),
        (jma(names=""), "component names"),
        (jma(names=" NS,NS,UD"), "NS is given twice"),
        (jma(names=" NS,EW,ND"), "component is 'ND'; it must be one of 'NS', 'EW', 'UD'"),
        (jma(rows=[]), "between 2 and"),
        (jma(rows=[*ROWS, (1.0, 2.0)]), "Row 5 is '1.000,2.000'; it must have 3 values"),
        (jma().replace("-3.000", "-3.00x"), "'-3.00x'"),
        (jma().replace("-3.000", ""), "''"),
    ],
    "knet": [
        (knet(peak=160.0), "peak acceleration"),
        (knet(counts=COUNTS[:-1]), "must agree"),
        (knet(seconds=3), "must agree"),
        (knet(scale="2000(V)/8388608"), "scale factor such as"),
        (knet(scale="2000(gal)/0"), "header"),
        (knet(direction=""), "direction"),
        (knet(direction="N45E"), "must be one of 'N-S', 'E-W', 'U-D', '1'"),
        (knet().replace("Max. Acc. (gal)   ", "Max. Acc. (gal)   ca. "), "peak"),
        (knet().replace("Memo.", "Note."), "line Memo"),
        (knet().replace("Sampling Freq(Hz) 100Hz", "Sampling Freq(Hz) ?"), "sampling frequency"),
        (knet().replace(f"{COUNTS[5]:9d}", "     nan "), "'nan'"),
    ],
    "knet csv": [
        (knet_csv(offset="#Offset,10.5,-2.25,100.0"), "no unit"),
        (knet_csv(offset="#Offset(gal),10.5,-2.25"), "components, 3"),
        (knet_csv(offset="#Offset(gal),10.5x,-2.25,100.0"), r"'10\.5x'"),
        (knet_csv(offset=""), "no line #Offset"),
        (knet_csv().replace("Freq(Hz),100", "Freq(Hz),200"), "sampling frequency 200 Hz"),
        (knet_csv().replace(",0.02,", ",0.05,", 1), "irregular"),
        (knet_csv(rows=ROWS[:1]), "at least 2"),
        (knet_csv()[:-14], "ends within a number"),
        (knet_csv().replace("7.500000", "x"), "'x'"),
        (knet_csv(names="#Datetime,Relative Time(s),NS,NS,UD"), "3 channels are not those of one sensor"),
    ],
    "esm": [
        (esm(DATA_TYPE="VELOCITY"), "'VELOCITY'"),
        (esm(UNITS=""), "no unit"),
        (esm(UNITS="cm/s"), "'cm/s'"),
        (esm(NDATA="20"), "number of samples 20 and the file has 21"),
        (esm(NDATA=""), "Value 1 of the entries NDATA"),
        (esm(SAMPLING_INTERVAL_S="0"), "time step"),
        (esm(DURATION_S="0.210"), "must agree"),
        (esm(**{"PGA_CM/S^2": "300.0"}), "peak acceleration"),
        (esm() + "nan\n", "'nan'"),
    ],
    "csmip": [
        (csmip_channel(1, "90 DEG", count=16), "number of samples 16 and the file has 21"),
        (csmip_channel(1, "90 DEG", count=0), "how many samples follow"),
        (csmip_channel(1, "90 DEG", peak=200.0), "peak acceleration"),
        (csmip_channel(1, "90 DEG", unit=""), "no unit"),
        (csmip_channel(1, "90 DEG", unit="  (UNITS: G/10)"), "'G/10'"),
        (csmip_channel(1, "90 DEG").split("/&")[0], "must be complete"),
        (csmip_channel(1, "90 DEG").replace("FOR CHANNEL  1", "FOR CHANNEL  2"), "number both 1 and 2"),
        (csmip_channel(2, "Tran (Sta Chn: 25)").replace("FOR CHANNEL  2", "FOR CHANNEL  5"), "both 2 and 5"),
        (csmip_channel(1, "90 DEG").replace("AT  .020", "AT  .030", 1), "they must last as long"),
        (
            csmip_channel(1, "90 DEG") + csmip_channel(2, "90 DEG") + csmip_channel(3, "UP") * 2,
            "one of 90 DEG .channel 1.",
        ),
    ],
    "cosmos": [
        (VELOCITY, "names of its blocks"),
        (cosmos(kind="velocity"), "is not as the format has it; it must state 'veloc'"),
        (cosmos(kind="raw accel. ", unit=" counts (50)", end=END), "raw counts or volts of a recorder"),
        (cosmos(kind="temperature", end=END), "how many samples follow"),
        (cosmos(count=20), "samples 20"),
        (cosmos(count=0), "how many samples follow"),
        (cosmos(interval=-999.0), "no time step"),
        (cosmos(peak=300.0), "peak acceleration"),
        (cosmos(reals=50), "≥ 64"),
        (cosmos(end=""), "End-of-data"),
        (cosmos(fmt="0F10.3"), "how many samples follow"),
        (cosmos().replace("Real-header", "Some-header"), "no real header"),
        (cosmos()[:1200], "integer header has 93 values"),
        (THREE_COSMOS.replace("acceleration pts", "acceleratoon pts", 1), "how many samples follow"),
        (THREE_COSMOS.replace("acceleration pts", "acceleration ptx", 1), "how many samples follow"),
    ],
}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        pytest.param(*case, id=f"{name} {place}")
        for name, cases in REFUSED.items()
        for place, case in enumerate(cases)
    ],
)
def test_files_that_are_refused(refusal, text, message):
    assert re.search(message, str(refusal(text)))


def test_csmip_a_byte_changed_in_a_line_that_announces_never_drops_or_swaps_a_component(read):
    whole, _ = read(THREE)
    for found in re.finditer(r".*POINTS OF.*|/&.*CHANNEL.*", THREE):
        for place in range(found.start(), found.end(), 2):
            for other in "X 1":
                with suppress(sp.InputError):
                    motion, _ = read(THREE[:place] + other + THREE[place + 1 :])
                    assert motion.dt == whole.dt
                    assert motion.components.keys() == whole.components.keys()
                    assert all(np.array_equal(motion.components[k], a) for k, a in whole.components.items())


def test_csmip_channels_that_are_missing_or_of_two_directions_are_told(read):
    integers = "".join(f"{i:5d}" for i in (1, 1, 1, 3, 3, *[0] * 11)) + "\n"
    motion, warned = read(csmip_channel(1, "90 DEG", integers=integers))
    assert motion.x == pytest.approx(0.01 * WAVE)
    assert "The header counts 3 channels and the file has 1" in str(warned[0])
    of_station = csmip_channel(2, "Tran (Sta Chn: 25)").replace("FOR CHANNEL  2", "FOR CHANNEL 25")
    assert read(of_station)[0].source == "CSMIP V2: x = Tran"
    _, warned = read("UP DEG".join(csmip_channel(1, "90 DEG").rsplit("90 DEG", 1)))
    assert "the directions '90 DEG', 'UP DEG'; '90 DEG' is taken" in str(warned[0])

"""JMA CSV, K-NET ASCII (through ObsPy) and K-NET CSV."""

import numpy as np
import pytest

from stayput.errors import InputError
from stayput.motion import read_motion

ROWS = [(0.5, -0.001, 1.25), (-3.0, 2.0, 0.0), (1.0, -0.5, -0.75), (0.25, 0.0, 0.5)]


@pytest.fixture
def read(tmp_path):
    def reader(text, coding="utf-8", **kwargs):
        file = tmp_path / "record"
        file.write_bytes(text.encode(coding))
        return read_motion(file, **kwargs)

    return reader


def jma(
    rate=" SAMPLING RATE= 100Hz",
    unit=" UNIT  = gal(cm/s/s)",
    names=" NS,EW,UD",
    tail="",
    initial="INITIAL TIME = 2016 04 14 21 26 20",
    rows=ROWS,
):
    header = [
        "SITE CODE= 123試験町   ,32.7,130.8",
        " LAT.=   0.0000",
        " LON.=  130.6842",
        rate,
        unit,
        initial,
        names,
    ]
    return "\r\n".join([*header, *(",".join(f"{v:.3f}" for v in row) + tail for row in rows)]) + "\r\n"


@pytest.mark.parametrize("coding", ["cp932", "utf-8", "utf-8-sig"])
@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"tail": ",,"},
        {"rate": " SAMPLING RATE= 100Hz ", "names": " NS,EW,UD,,"},
        {"rate": " Sampling Freq= 100Hz"},
        {"rate": " Sampling Freq(Hz)= 100"},
        {"initial": "INITIAL TIME = 16 04 14 21 26 20"},
    ],
)
def test_jma_variants(read, coding, changes):
    motion = read(jma(**changes), coding)
    assert motion.dt == pytest.approx(0.01)
    assert np.stack([motion.x, motion.y, motion.z], axis=1) == pytest.approx(0.01 * np.array(ROWS))
    assert motion.name == "123試験町, NS"
    assert "JMA CSV" in motion.source


def test_jma_at_50_hz_and_another_component(read):
    motion = read(jma(rate=" SAMPLING RATE= 50Hz"), "cp932", component="EW")
    assert motion.dt == pytest.approx(0.02)
    assert motion.x == pytest.approx([-1e-5, 0.02, -0.005, 0.0])
    assert motion.z[0] == pytest.approx(0.0125)


def test_jma_names_in_another_order(read):
    assert read(jma(names=" UD,EW,NS")).z[0] == pytest.approx(0.005)


def test_jma_offset_is_left_alone(read):
    rows = [(a + 10.0, b, c) for a, b, c in ROWS]
    assert read(jma(rows=rows)).x[0] == pytest.approx(0.105)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (jma(unit=""), "no unit"),
        (jma(unit=" UNIT = kine"), "'kine'"),
        (jma(rate=" SAMPLING RATE="), "sampling frequency"),
        (jma(rate=" SAMPLING RATE= 0Hz"), "0Hz"),
        (jma(names=""), "component names"),
        (jma(names=" NS,NS,UD"), "each once"),
        (jma(rows=[]), "2 to"),
        (jma(rows=[*ROWS, (1.0, 2.0)]), "Row 5 is '1.000,2.000'; it must have 3 values"),
        (jma(rows=[*ROWS, (1.0, 2.0, 3.0, 4.0)]), "must have 3 values"),
        (jma().replace("-3.000", "-3.00x"), "'-3.00x'"),
        (jma().replace("-3.000", "nan"), "'nan'"),
        (jma().replace("-3.000", ""), "''"),
    ],
)
def test_jma_files_that_are_refused(read, text, message):
    with pytest.raises(InputError, match=message):
        read(text)


COUNTS = np.round(20000 * np.sin(np.arange(200) * 0.7) + 5000).astype(int)
SCALE = 2000 / 8388608  # gal a count
PEAK = np.abs(COUNTS - COUNTS.mean()).max() * SCALE


def knet(
    direction="N-S",
    lon="Station Long.",
    peak_key="Max. Acc. (gal)",
    peak=PEAK,
    seconds=2,
    counts=COUNTS,
    scale="2000(gal)/8388608",
):
    header = {
        "Origin Time": "2006/01/18 23:25:00",
        "Lat.": "37.798",
        "Long.": "142.200",
        "Depth. (km)": "36",
        "Mag.": "5.7",
        "Station Code": "TST001",
        "Station Lat.": "38.7262",
        lon: "141.5109",
        "Station Height(m)": "79",
        "Record Time": "2006/01/18 23:25:46",
        "Sampling Freq(Hz)": "100Hz",
        "Duration Time(s)": str(seconds),
        "Dir.": direction,
        "Scale Factor": scale,
        peak_key: f"{peak:.3f}",
        "Last Correction": "2006/01/18 23:25:31",
        "Memo.": "",
    }
    lines = [f"{key:<18}{value}" for key, value in header.items()]
    rows = ["".join(f"{c:9d}" for c in counts[i : i + 8]) for i in range(0, len(counts), 8)]
    return "\n".join([*lines, *rows]) + "\n"


@pytest.mark.parametrize("direction", ["D-U", "7", "N45E"])
def test_knet_of_an_unknown_direction_is_refused(read, direction):
    with pytest.raises(InputError, match="must be N-S, E-W, U-D or 1 to 6") as refused:
        read(knet(direction=direction))
    assert f"方向が「{direction}」" in refused.value.told("ja")


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"lon": "Station Lon."},
        {"peak_key": "Max Acc. (gal)"},
        {"lon": "Station Lon.", "peak_key": "Max Acc. (gal)"},
    ],
)
def test_knet_is_calibrated_once_and_freed_of_its_offset(read, changes):
    motion = read(knet(**changes))
    assert motion.x == pytest.approx(0.01 * SCALE * (COUNTS - COUNTS.mean()), rel=1e-12)
    assert motion.pga == pytest.approx(0.01 * PEAK, rel=1e-3)
    assert motion.dt == pytest.approx(0.01)
    assert motion.name == "TST001, NS"
    assert "offset removed" in motion.source


@pytest.mark.parametrize(
    ("direction", "name"), [("1", "NS1"), ("3", "UD1"), ("5", "EW2"), ("6", "UD2"), ("U-D", "UD")]
)
def test_kiknet_directions(read, direction, name):
    assert read(knet(direction)).name == f"TST001, {name}"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (knet(peak=1.05 * PEAK), "peak acceleration"),
        (knet(counts=COUNTS[:-1]), "must agree"),
        (knet(counts=COUNTS[:-8]), "must agree"),
        (knet(seconds=3), "must agree"),
        (knet(scale="2000(V)/8388608"), "scale factor in gal"),
        (knet(scale="2000(gal)/0"), "header"),
        (knet(direction=""), "direction"),
        (knet().replace("Max. Acc. (gal)   ", "Max. Acc. (gal)   ca. "), "peak"),
        (knet().replace("Memo.", "Note."), "line Memo"),
        (knet().replace("Sampling Freq(Hz) 100Hz", "Sampling Freq(Hz) ?"), "sampling frequency"),
        (knet().replace(f"{COUNTS[5]:9d}", "     nan "), "'nan'"),
        ("\n".join(knet().split("\n")[:12]), "17 lines|no known format"),
    ],
)
def test_knet_files_that_are_refused(read, text, message):
    with pytest.raises(InputError, match=message):
        read(text)


def knet_csv(offset="#Offset(gal),10.5,-2.25,100.0", names="#Datetime,Relative Time(s),NS,EW,UD", rows=ROWS):
    header = ["#Station Code,TST001", "#Sampling Freq(Hz),100", offset, names]
    o = (10.5, -2.25, 100.0)
    lines = [
        f"2024/01/01 16:10:{0.01 * i:06.3f},{0.01 * i:.2f},"
        + ",".join(f"{v + s:.6f}" for v, s in zip(row, o, strict=True))
        for i, row in enumerate(rows)
    ]
    return "\n".join(line for line in [*header, *lines] if line) + "\n"


def test_knet_csv_is_freed_of_its_offset(read):
    motion = read(knet_csv())
    assert np.stack([motion.x, motion.y, motion.z], axis=1) == pytest.approx(0.01 * np.array(ROWS), abs=1e-9)
    assert motion.dt == pytest.approx(0.01)
    assert motion.name == "TST001, NS"
    assert "offset removed" in motion.source


def test_knet_csv_with_names_in_another_order(read):
    motion = read(knet_csv(names="#Datetime,Relative Time(s),E-W (gal),N-S (gal),U-D (gal)"), component="NS")
    assert motion.x == pytest.approx([0.01 * row[1] for row in ROWS], abs=1e-9)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (knet_csv(offset="#Offset,10.5,-2.25,100.0"), "no unit"),
        (knet_csv(offset="#Offset(gal),10.5,-2.25"), "components, 3"),
        (knet_csv(offset=""), "no line #Offset"),
        (knet_csv().replace("0.02,", "0.05,", 1), "irregular|decimal|values"),
        (knet_csv(rows=ROWS[:1]), "at least 2"),
        (knet_csv()[:-14], "ends within a number"),
        (knet_csv()[:-17], "ends within a number"),
        (knet_csv().replace("7.500000", "x"), "'x'"),
    ],
)
def test_knet_csv_files_that_are_refused(read, text, message):
    with pytest.raises(InputError, match=message):
        read(text)


@pytest.mark.parametrize("rate", ["1,000Hz", "1/100 sec", "100 kHz", "100Hz 50Hz", "0x64", "1_00", "nan"])
def test_jma_sampling_rates_that_are_not_one_number_are_refused(read, rate):
    with pytest.raises(InputError, match=r"sampling frequency is '.*'; it must be one number .* \[Hz\]"):
        read(jma(rate=f" SAMPLING RATE= {rate}"))


def test_jma_sampling_rates_are_matched_in_full(read):
    assert read(jma(rate=" SAMPLING RATE= 1e2Hz")).dt == 0.01
    assert read(jma(rate=" SAMPLING RATE=  100.0 Hz,,")).dt == 0.01


def test_jma_a_vertical_component_cannot_become_a_horizontal_one(read):
    with pytest.raises(InputError, match="NS, EW, ND; they must be among NS, EW, UD"):
        read(jma(names=" NS,EW,ND"))


def test_knet_csv_numbers_are_matched_in_full(read):
    with pytest.raises(InputError, match=r"'10\.5x'"):
        read(knet_csv(offset="#Offset(gal),10.5x,-2.25,100.0"))
    with pytest.raises(InputError, match="sampling frequency 200 Hz"):
        read(knet_csv().replace("Freq(Hz),100", "Freq(Hz),200"))

"""ESM, CSMIP V2 and COSMOS V1.20."""

import re

import numpy as np
import pytest

from stayput.errors import InputError, InputWarning
from stayput.motion import read_motion

WAVE = np.round(150.0 * np.sin(np.arange(21) * 0.9), 3)


@pytest.fixture
def read(tmp_path):
    def reader(text, **kwargs):
        file = tmp_path / "record"
        file.write_text(text)
        return read_motion(file, **kwargs)

    return reader


def esm(**changes):
    header = {
        "EVENT_NAME": "NOWHERE",
        "EVENT_ID": "TEST-1",
        "NETWORK": "XX",
        "STATION_CODE": "ABC",
        "LOCATION": "",
        "SAMPLING_INTERVAL_S": "0.005000",
        "NDATA": str(len(WAVE)),
        "STREAM": "HNE",
        "UNITS": "cm/s^2",
        "PGA_CM/S^2": f"{np.abs(WAVE).max():.6f}",
        "DATA_TYPE": "ACCELERATION",
        "USER5": "a path: /with colons: in it",
        **changes,
    }
    return "".join(f"{k}: {v}\n" for k, v in header.items()) + "".join(f"{v:.6f}\n" for v in WAVE)


def test_esm(read):
    motion = read(esm())
    assert motion.x == pytest.approx(0.01 * WAVE)
    assert motion.dt == 0.005
    assert motion.name == "XX.ABC, TEST-1, HNE"
    assert np.array_equal(read(esm(), component="EW").x, motion.x)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (esm(DATA_TYPE="VELOCITY"), "'VELOCITY'"),
        (esm(UNITS=""), "no unit"),
        (esm(UNITS="cm/s"), "'cm/s'"),
        (esm(NDATA="20"), "number of samples 20 and the file has 21"),
        (esm(NDATA=""), "no NDATA"),
        (esm(SAMPLING_INTERVAL_S="0"), "time step"),
        (esm(**{"PGA_CM/S^2": "300.0"}), "peak acceleration"),
        (esm().rsplit("\n", 3)[0], "number of samples 21"),
        (esm() + "nan\n", "'nan'"),
    ],
)
def test_esm_files_that_are_refused(read, text, message):
    with pytest.raises(InputError, match=message):
        read(text)


def block(values, width=10, decimals=3, per_line=8):
    return "\n".join(
        "".join(f"{v:{width}.{decimals}f}" for v in values[i : i + per_line])
        for i in range(0, len(values), per_line)
    )


def csmip_channel(
    number,
    direction,
    values,
    *,
    count=None,
    peak=None,
    announce="POINTS OF ACCEL DATA EQUALLY SPACED AT",
    unit="  (UNITS: CM/SEC/SEC)",
    **layout,
):
    n = len(values) if count is None else count
    peak = np.abs(values).max() if peak is None else peak
    return (
        f"CORRECTED ACCELEROGRAM   12345-S1-2.01       CHAN  {number}: {direction}     FROM\n"
        "UNCORRECTED ACCELEROGRAM DATA\nNOWHERE EARTHQUAKE\nMAY 2, 1983\n12345   TRIGGER TIME\n"
        f"STATION NO. 12345\nFAULT ZONE 14\nCHAN  {number}: {direction}\n"
        f"PEAK ACCELERATION =  {peak:.3f}    CM/SEC/SEC  AT   10.940   SEC.\n"
        f" {n} {announce}  .020 SEC.{unit}\n{block(values, **layout)}\n"
        f" {n} POINTS OF VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)\n{block(values)}\n"
        f" {n} POINTS OF DISPL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM)\n{block(values)}\n"
        f"/&  ----------  END OF DATA FOR CHANNEL  {number}  ----------\n"
    )


def test_csmip_three_channels(read):
    text = (
        csmip_channel(1, " 90 DEG", WAVE)
        + csmip_channel(2, "UP", 2 * WAVE)
        + csmip_channel(3, "360 DEG", 3 * WAVE)
    )
    motion = read(text)
    assert motion.x == pytest.approx(0.01 * WAVE)
    assert motion.y == pytest.approx(0.03 * WAVE)
    assert motion.z == pytest.approx(0.02 * WAVE)
    assert motion.dt == 0.02
    assert motion.name == "FAULT ZONE 14, NOWHERE EARTHQUAKE, 90 DEG"
    assert read(text, component="NS").x == pytest.approx(0.03 * WAVE)


def test_csmip_touching_fields_another_layout_and_lower_case(read):
    touching = np.array([-12345.678, -99999.999, 1234.5, -54321.123, 10.0])
    assert read(csmip_channel(1, "90 DEG", touching)).x == pytest.approx(0.01 * touching)
    text = csmip_channel(1, "90 DEG", WAVE, unit=", in cm/sec2. (5f12.4)", width=12, decimals=4, per_line=5)
    assert read(text).x == pytest.approx(0.01 * WAVE)
    assert read(csmip_channel(1, "90 DEG", WAVE).lower()).x == pytest.approx(0.01 * WAVE)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (csmip_channel(1, "90 DEG", WAVE, count=20), "number of samples 20|More numbers"),
        (csmip_channel(1, "90 DEG", WAVE, count=16), "number of samples 16 and the file has 21"),
        (csmip_channel(1, "90 DEG", WAVE, count=40), "decimal number|samples 40"),
        (csmip_channel(1, "90 DEG", WAVE, count=0), "how many samples follow"),
        (csmip_channel(1, "90 DEG", WAVE, peak=200.0), "peak acceleration"),
        (csmip_channel(1, "90 DEG", WAVE, unit=""), "no unit"),
        (csmip_channel(1, "90 DEG", WAVE).split("/&")[0], "must be complete"),
        (csmip_channel(1, "90 DEG", WAVE)[:700], "states|complete|decimal"),
    ],
)
def test_csmip_files_that_are_refused(read, text, message):
    with pytest.raises(InputError, match=message):
        read(text)


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
    real = np.full(100, -999.0)
    real[61], real[63] = interval, (values[np.abs(values).argmax()] if peak is None else peak)
    count = len(values) if count is None else count
    text_lines = [
        "Corrected acceleration    (Format v01.20 with 13 text lines)",
        "Record of Nowhere Earthquake of Fri Nov 30, 2018",
        *["Hypocenter: ..."] * 6,
        f"Sta Chan   {label} (Rcrdr Chan  1) Location:",
        *["Processed: ..."] * 3,
        "Values used when parameter or data value is unknown/unspecified:   -999, -999.00",
    ]
    return (
        "\n".join(text_lines)
        + "\n 100 Integer-header values follow on  10 lines, Format= (10I8)\n"
        + "\n".join(["    -999" * 10] * 10)
        + f"\n {reals} Real-header values follow on  {-(-reals // 5)} lines, Format= (5F15.6)\n"
        + block(real[:reals], 15, 6, 5)
        + '\n   1 Comment line(s) follow, each starting with a "|":\n| comment\n'
        + f"   {count} {kind} pts, approx  1 secs, units={unit},Format=({fmt})\n{block(values)}\n{end}"
    )


def test_cosmos(read):
    motion = read(cosmos())
    assert motion.x == pytest.approx(0.01 * WAVE)
    assert motion.dt == 0.005
    assert motion.name == "Nowhere Earthquake of Fri Nov 30, 2018, 360"
    three = cosmos() + cosmos(2 * WAVE, label="2: Up") + cosmos(3 * WAVE, label="3:  90 Deg")
    motion = read(three, component="EW")
    assert motion.x == pytest.approx(0.03 * WAVE)
    assert motion.y == pytest.approx(0.01 * WAVE)
    assert motion.z == pytest.approx(0.02 * WAVE)


def test_cosmos_without_an_interval_needs_dt(read):
    with pytest.raises(InputError, match="no time step"):
        read(cosmos(interval=-999.0))
    assert read(cosmos(interval=-999.0), dt=0.01).dt == 0.01


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (cosmos(kind="velocity", end="End-of-data for Chan 1 velocity\n"), "names of its blocks"),
        (cosmos(kind="velocity"), "A block of velocity ends as one of acceleration"),
        (cosmos(unit="counts"), "'counts'"),
        (cosmos(count=20), "samples 20|More numbers"),
        (cosmos(count=30), "decimal number|samples 30"),
        (cosmos(count=0), "how many samples follow"),
        (cosmos(peak=300.0), "peak acceleration"),
        (cosmos(reals=50), "≥ 64"),
        (cosmos(end=""), "End-of-data"),
        (cosmos().replace("Real-header", "Some-header"), "no real header"),
        (cosmos(fmt="0F10.3"), "how many samples follow"),
        (cosmos()[:1200], "integer header has 93 values"),
    ],
)
def test_cosmos_files_that_are_refused(read, text, message):
    with pytest.raises(InputError, match=message):
        read(text)


THREE = (
    csmip_channel(1, " 90 DEG", WAVE)
    + csmip_channel(2, "UP", 2 * WAVE)
    + csmip_channel(3, "360 DEG", 3 * WAVE)
)


def test_csmip_a_byte_changed_in_a_line_that_announces_never_drops_or_swaps_a_component(read):
    whole = read(THREE)
    for found in re.finditer(r".*POINTS OF.*|/&.*CHANNEL.*", THREE):
        for place in range(found.start(), found.end()):
            for other in "X 1":
                text = THREE[:place] + other + THREE[place + 1 :]
                try:
                    motion = read(text)
                except InputError:
                    continue
                assert motion.dt == whole.dt
                assert motion.components.keys() == whole.components.keys()
                assert all(np.array_equal(motion.components[k], a) for k, a in whole.components.items()), (
                    place
                )


def test_csmip_a_file_cut_after_a_channel_is_told_where_its_header_counts_them(read):
    integers = "".join(f"{i:5d}" for i in (1, 1, 1, 3, 3, *[0] * 11)) + "\n"
    one = csmip_channel(1, "90 DEG", WAVE).replace("PEAK ACC", integers + "PEAK ACC")
    with pytest.warns(InputWarning, match="The header counts 3 channels and the file has 1"):
        assert read(one).x == pytest.approx(0.01 * WAVE)


def test_csmip_a_header_that_contradicts_itself(read):
    one = csmip_channel(1, "90 DEG", WAVE)
    with pytest.raises(InputError, match="numbered 1 and 2"):
        read(one.replace("FOR CHANNEL  1", "FOR CHANNEL  2"))
    with pytest.raises(InputError, match="they must last as long"):
        read(one.replace("AT  .020", "AT  .030", 1))
    with pytest.warns(InputWarning, match="the directions '90 DEG', 'UP DEG'; '90 DEG' is taken"):
        read("UP DEG".join(one.rsplit("90 DEG", 1)))


def test_cosmos_a_damaged_block_is_not_passed_over(read):
    three = cosmos() + cosmos(2 * WAVE, label="2: Up") + cosmos(3 * WAVE, label="3:  90 Deg")
    for damaged in ("acceleratoon pts", "acceleration ptx", "acceleration"):
        with pytest.raises(InputError):
            read(damaged.join(three.split("acceleration pts", 1)))
    velocity = cosmos(kind="velocity", end="End-of-data for Chan 1 velocity\n")
    assert read(cosmos() + velocity).x == pytest.approx(0.01 * WAVE)
    bare = velocity[velocity.index(f"   {len(WAVE)} velocity") :]
    assert read(cosmos() + bare).x == pytest.approx(0.01 * WAVE)


def test_esm_a_duration_unlike_the_samples_is_refused(read):
    assert read(esm(DURATION_S="0.105")).dt == 0.005
    with pytest.raises(InputError, match="they must agree"):
        read(esm(DURATION_S="0.210"))

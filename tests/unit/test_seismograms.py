"""SAC and miniSEED by ObsPy: the unit and the sensor are said, and all traces are of one station."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from typer.testing import CliRunner

import stayput as sp
from stayput.cli import app

obspy = pytest.importorskip("obspy", reason="ObsPy is not installed")

WAVE = np.round(100.0 * np.random.default_rng(5).normal(size=300), 3).astype(np.float32)
CHANNELS = ("HNE", "HNN", "HNZ")


def trace(channel="HNE", size=1.0, station="AAA", location="00"):
    about = {"network": "XX", "station": station, "location": location, "channel": channel, "delta": 0.01}
    start = obspy.UTCDateTime(2011, 3, 11)
    return obspy.Trace((size * WAVE).astype(np.float32), {**about, "starttime": start})


def stream(stations=("AAA",), locations=("00",)):
    return obspy.Stream(
        [trace(c, k, s, where) for s in stations for where in locations for k, c in enumerate(CHANNELS, 1)]
    )


@pytest.fixture
def written(tmp_path):
    def write(traces, form="MSEED"):
        file = tmp_path / "record.dat"
        traces.write(str(file), format=form)
        return file

    return write


def test_miniseed_has_the_channels_of_a_station(written):
    motion = sp.read_motion(written(stream()), "HNN", "gal")
    assert motion.source == "miniSEED: x = HNN, y = HNE, z = HNZ"
    assert motion.name == "XX.AAA, HNN"
    assert motion.dt == 0.01
    assert motion.x == pytest.approx(0.02 * WAVE)
    assert not motion.synthetic


@pytest.mark.parametrize("code", ["BHZ", "HHN", "EHE", "BDF", "LKO", "HH1"])
def test_a_channel_of_another_instrument_is_no_acceleration(written, code):
    for form in ("MSEED", "SAC"):
        with pytest.raises(sp.InputError, match=f"Channel {code} is of no accelerometer") as caught:
            sp.read_motion(written(obspy.Stream([trace(code)]), form))  # before it asks for a unit
        assert f"計器の文字が{code[1]}" in caught.value.told("ja")
    with pytest.warns(sp.InputWarning, match=f"Channel {code} is of no accelerometer"):  # may be made one
        sp.Motion.from_obspy([trace(code)], "m/s²")


@pytest.mark.parametrize("code", ["HNE", "BLN", "HGE", "EN1", "EW", "NS2", "EW1", "UD1"])
def test_a_channel_of_an_accelerometer_is_one(written, recwarn, code):
    sp.read_motion(written(obspy.Stream([trace(code)])), "channel 1", unit="gal")
    assert not [one for one in recwarn if one.message.code == "motion.other_instrument"]


def test_sac_that_states_an_acceleration_is_one(tmp_path):
    changed = trace("BHE")
    changed.stats.sac = {"idep": 8}
    changed.write(str(tmp_path / "it.sac"), format="SAC")
    assert sp.read_motion(tmp_path / "it.sac", unit="gal").pga > 0.0


def test_sac_has_one_and_others_belong_to_it(tmp_path):
    for k, channel in enumerate(CHANNELS, 1):
        trace(channel, k).write(str(tmp_path / f"{channel}.sac"), format="SAC")
        trace(channel, k, "BBB").write(str(tmp_path / f"b{channel}.sac"), format="SAC")
    x, y, z = (sp.read_motion(tmp_path / f"{c}.sac", "channel 1", "gal") for c in CHANNELS)
    assert sp.Motion.combine(x, y, z).z == pytest.approx(0.03 * WAVE)
    other = sp.read_motion(tmp_path / "bHNN.sac", unit="gal")
    with pytest.raises(sp.InputError, match=r"'XX\.AAA 00, 2011-03-11T.*'XX\.BBB 00, 2011-03-11T"):
        sp.Motion.combine(x, other)
    suite = sp.read_suite(tmp_path, unit="gal")
    assert [list(motion.components) for motion in suite] == [["x", "y", "z"]] * 2


@pytest.mark.parametrize("form", ["MSEED", "SAC"])
def test_the_unit_must_be_given_and_the_step_agree(written, form):
    file = written(obspy.Stream([trace()]), form)
    with pytest.raises(sp.InputError, match="unit must be given") as refused:
        sp.read_motion(file)
    assert refused.value.field == "unit"
    with pytest.raises(sp.InputError, match=r"the one that the file states, 0\.01 s"):
        sp.read_motion(file, unit="gal", dt=0.02)
    with pytest.raises(
        sp.InputError, match=r"columns is given for a file of (SAC|miniSEED), which has no use"
    ):
        sp.read_motion(file, unit="gal", columns="x=1")
    assert sp.read_motion(file, unit="gal", dt=0.01).x == pytest.approx(0.01 * WAVE)


@pytest.mark.parametrize(("idep", "quantity"), [(6, "displacement"), (7, "velocity")])
def test_sac_of_another_quantity_is_refused(written, idep, quantity):
    one = trace()
    one.stats.sac = {"idep": idep}
    with pytest.raises(sp.InputError, match=f"is of {quantity}"):
        sp.read_motion(written(obspy.Stream([one]), "SAC"), unit="gal")


def refusal(traces, unit="gal", **options):
    with pytest.raises(sp.InputError) as refused:
        sp.Motion.from_obspy(traces, unit, **options)
    return refused.value


def test_two_sensors_of_a_station_must_be_chosen(written):
    both = stream(locations=("", "10"))
    error = refusal(both)
    assert str(error) == (
        "The station has 2 sensors, with the locations --, 10; location must name one of them."
    )
    assert "使うものをlocationで" in error.told("ja")
    for location, code in (("10", "10"), ("--", ""), ("", "")):
        motion = sp.Motion.from_obspy(both, "gal", location=location, component="HNE")
        assert motion.listing.origin.startswith(f"XX.AAA {code or '--'}, ")
        assert sp.read_motion(written(both), "HNE", "gal", location=location) is not None
    error = refusal(both, location="20")
    assert "The location is '20'; it must be one of '--', '10'." in str(error)
    assert "ロケーションが'20'" in error.told("ja")


def test_two_stations_are_refused_by_both_names():
    error = refusal(stream(("AAA", "BBB")))
    assert str(error) == "The traces are of the stations XX.AAA and XX.BBB; they must be of one."
    assert "XX.AAAとXX.BBB" in error.told("ja")


@pytest.mark.parametrize("lang", ["en", "ja"])
def test_the_command_line_chooses_unit_and_sensor(written, lang):
    file = written(stream(locations=("00", "10")))

    def told(*words):
        return CliRunner().invoke(app, ["motion", "info", str(file), *words, "--lang", lang])

    assert "--unit" in told().stderr
    assert "--set shaking.location" in told("--set", "shaking.unit=gal").stderr
    done = told("--set", "shaking.unit=gal", "--set", "shaking.location=10", "--set", "shaking.component=HNN")
    assert done.exit_code == 0
    assert "component" not in done.stderr
    assert told("--set", "shaking.unit=gal", "--set", "shaking.location=7").exit_code == 2


def test_without_obspy_it_is_said_what_to_install(written, monkeypatch):
    file = written(stream())
    monkeypatch.setitem(sys.modules, "obspy", None)
    with pytest.raises(sp.InputError, match="miniSEED needs ObsPy, which is not installed") as refused:
        sp.read_motion(file, unit="gal")
    assert "miniSEEDにはObsPyが必要" in refused.value.told("ja")


@pytest.mark.parametrize("form", ["MSEED", "SAC"])
def test_a_file_that_is_cut_is_refused(written, form):
    file = written(stream() if form == "MSEED" else obspy.Stream([trace()]), form)
    whole = file.read_bytes()
    for length in (len(whole) - 5, len(whole) // 2 + 100, 640):
        file.write_bytes(whole[:length])
        with pytest.raises(sp.InputError):
            sp.read_motion(file, "channel 1", "gal")

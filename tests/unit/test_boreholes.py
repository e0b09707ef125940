"""A sensor in a borehole is below the ground: it is warned of, and the one at the surface comes first."""

from __future__ import annotations

import numpy as np
import pytest

import stayput as sp
from record_files import knet
from stayput.errors import warnings_to

NAMES = ("NS1", "EW1", "UD1", "NS2", "EW2", "UD2")
ROWS = "".join(
    f"2024/01/01 16:10:{0.01 * i:06.3f},{0.01 * i:.2f},{','.join(str(k * (-1) ** i) for k in range(1, 7))}\n"
    for i in range(50)
)
BOTH = f"#Station Code,TST001\n#Offset(gal),0,0,0,0,0,0\n#Datetime,Relative Time(s),{','.join(NAMES)}\n{ROWS}"
BELOW = "is in the borehole, below the ground"


def told(path, **options):
    heard: list[sp.InputWarning] = []
    with warnings_to(heard.append):
        return sp.read_motion(path, **options), heard


@pytest.mark.parametrize("direction", "123456")
def test_a_file_of_one_channel_says_which_sensor_it_is_of(tmp_path, direction):
    file = tmp_path / "record"
    file.write_text(knet(direction), encoding="utf-8")
    motion, heard = told(file, component="channel 1")
    sensor = "borehole" if direction in "123" else "surface"
    assert motion.listing.origin == f"TST001, {sensor}, 2006/01/18 23:25:00"
    assert [BELOW in str(warning) for warning in heard] == ([True] if sensor == "borehole" else [])
    assert all("地中" in warning.told("ja") for warning in heard)


def test_of_a_file_with_both_the_surface_is_taken(tmp_path):
    file = tmp_path / "both.csv"
    file.write_text(BOTH, encoding="utf-8")
    motion, heard = told(file)
    assert {name: abs(a[0]) for name, a in motion.components.items()} == {"x": 0.04, "y": 0.05, "z": 0.06}
    (left_out,) = (warning for warning in heard if warning.code == "motion.borehole_left_out")
    assert "The channels NS1, EW1, UD1 are of the borehole" in str(left_out)
    assert "「NS1、EW1、UD1」は使いません" in left_out.told("ja")


def test_a_channel_that_is_named_brings_those_of_its_sensor(tmp_path):
    file = tmp_path / "both.csv"
    file.write_text(BOTH, encoding="utf-8")
    surface, heard = told(file, component="EW2")
    assert {name: abs(a[0]) for name, a in surface.components.items()} == {"x": 0.05, "y": 0.04, "z": 0.06}
    assert heard == []
    below, heard = told(file, component="NS1")
    assert {name: abs(a[0]) for name, a in below.components.items()} == {"x": 0.01, "y": 0.02, "z": 0.03}
    assert [BELOW in str(warning) for warning in heard] == [True]
    with pytest.raises(sp.InputError, match="is 'NS'; it must be one of NS1"):
        told(file, component="NS")


def test_traces_of_both_sensors_are_of_the_surface(tmp_path, recwarn):
    obspy = pytest.importorskip("obspy", reason="ObsPy is not installed")
    stream = obspy.Stream()
    for k in range(6):
        (tmp_path / "one").write_text(knet(str(k + 1)), encoding="utf-8")
        stream += obspy.read(str(tmp_path / "one"))
        stream[-1].data = stream[-1].data * (k + 1)
    motion = sp.Motion.from_obspy(stream, "mm/s²", remove_mean=True)
    assert "x = NS2, y = EW2, z = UD2; mean removed" in motion.source
    assert any("of the borehole" in str(one.message) for one in recwarn)


def test_surface_and_borehole_are_two_records(tmp_path):
    parts = []
    for k, direction in enumerate("42"):
        file = tmp_path / direction
        counts = np.round((k + 1) * 1000 * np.sin(np.arange(200))).astype(int)
        peak = np.abs(counts - counts.mean()).max() * 2000 / 8388608
        file.write_text(knet(direction, counts=counts, peak=peak), encoding="utf-8")
        parts.append(told(file)[0])
    with pytest.raises(sp.InputError, match=r"'TST001, surface, .*'TST001, borehole, ") as refused:
        sp.Motion.combine(*parts)
    assert "地震計" in refused.value.told("ja")


def test_what_is_told_of_a_borehole_is_not_told_of_the_ground(tmp_path):
    from stayput.report.summary import rows

    file = tmp_path / "record"
    file.write_text(knet("1"), encoding="utf-8")
    motion, heard = told(file)
    assert motion.floor == "borehole"
    assert [warning.code for warning in heard].count("motion.upper_floor") == 0
    run = sp.simulate(sp.Body(0.9, 1.8, 50), sp.Room(), motion)
    assert rows(run)[0][1].count("recorded on the bottom of a borehole, below the ground") == 1
    assert "地中（ボアホールの底）の記録" in rows(run, "ja")[0][1]
    with pytest.raises(sp.InputError, match="below the ground, not of the ground"):
        motion.to_intensity(5.0)

"""Peaks of real records against their files' own headers and against published values, to 0.1 %.

The records are not part of the project; where their folder is absent the tests are skipped.
Published: JMA, strong-motion records of 1995-01-17, 2000-10-06 and 2016-04-14; PEER and USGS for the others.
"""

import re
import time
from pathlib import Path

import numpy as np
import pytest

from real_records import MOTIONS, recorded
from stayput.motion.readers import read_motion
from stayput.motion.record import Motion

pytestmark = recorded

G = 980.665  # gal
PUBLISHED = {  # file: (peaks of x, y, z [gal], dt [s], number of samples, what the file does not state)
    "jma_kobe_1995_ns.AT2": ([818.1], 0.02, 7500, {}),
    "jma_kobe_1995_ew.AT2": ([617.5], 0.02, 7500, {}),
    "jma_kobe_1995_ud.AT2": ([332.4], 0.02, 7500, {}),
    "jma_uki_2016.csv": ([327.1, 280.9, 220.9], 0.01, 30000, {}),
    "elcentro_1940_180.AT2": ([0.3129 * G], 0.01, 4000, {}),
    "nishi_akashi_1995_090.AT2": ([0.5027 * G], 0.01, 4096, {}),
    "arleta_1994_360.at2": ([0.3081 * G], 0.02, 2000, {}),
    "hachinohe_1968_ns_gal_dt0.01.txt": ([224.8], 0.01, 3601, {"unit": "gal", "dt": 0.01}),
    "mexico_sct_1985_t_ns_ew_ud_g.txt": ([97.6, 167.9, 36.6], 0.02, 8171, {"unit": "g"}),
    "market575_1989_floor42_gal_dt0.01.csv": ([214.6], 0.01, 4855, {"unit": "gal"}),
    "market575_1989_ground_gal_dt0.01.csv": ([131.2], 0.01, 4854, {"unit": "gal"}),
}


def read(name: str, **kwargs) -> Motion:
    return read_motion(MOTIONS / name, **kwargs)


@pytest.mark.parametrize("name", PUBLISHED)
def test_peaks_are_the_published_ones(name):
    peaks, dt, n, given = PUBLISHED[name]
    motion = read(name, **given)
    assert [100.0 * p.pga for p in motion.peaks().values()] == pytest.approx(peaks, rel=1e-3)
    assert motion.dt == pytest.approx(dt, rel=1e-12)
    assert len(motion) == n


def test_every_record_of_the_folder_is_read_and_quickly():
    for file in sorted(MOTIONS.iterdir()):
        if file.suffix == ".md":
            continue
        given = PUBLISHED.get(file.name, (None, None, None, {}))[3]
        times = []
        for _ in range(3):
            start = time.process_time()
            motion = read(file.name, **given)
            times.append(time.process_time() - start)
        assert motion.pga > 1e-3, file.name
        assert min(times) < 1.0, file.name  # of the processor, on a slow machine; aim: 0.05 s


def test_csmip_against_its_own_header():
    text = (MOTIONS / "csmip_ce36456.V2").read_text()
    acceleration = [abs(float(v)) for v in re.findall(r"PEAK ACCELERATION = +(\S+)", text)]
    velocity = [abs(float(v)) for v in re.findall(r"PEAK +VELOCITY +=  *(\S+)", text)]
    start = [float(v) for v in re.findall(r"INITIAL VELOCITY  = +(\S+)", text)]
    for number, (pga, pgv, v0) in enumerate(zip(acceleration, velocity, start, strict=True), 1):
        motion = read("csmip_ce36456.V2", component=f"channel {number}")
        assert 100.0 * motion.pga == pytest.approx(pga, rel=1e-3)
        assert 100.0 * np.abs(motion.velocity + 0.01 * v0).max() == pytest.approx(
            pgv, rel=0.02
        )  # theirs is filtered once more
    motion = read("csmip_ce36456.V2")
    assert [100.0 * p.pga for p in motion.peaks().values()] == pytest.approx(
        [267.957, 256.231, 94.805], rel=1e-3
    )
    assert "90 DEG" in motion.name


def test_cosmos_against_its_own_header():
    text = (MOTIONS / "cosmos_akbmr.V2c").read_text()
    stated = re.search(r"Max = +(\S+) cm/sec2 at +(\S+) sec", text)
    motion = read("cosmos_akbmr.V2c")
    assert 100.0 * motion.x[np.abs(motion.x).argmax()] == pytest.approx(float(stated[1]), rel=1e-3)
    assert motion.time[np.abs(motion.x).argmax()] == pytest.approx(float(stated[2]))
    assert (motion.dt, len(motion)) == (0.005, 42000)


def test_esm_against_its_own_header():
    text = (MOTIONS / "esm_hi_ars1_hne.ASC").read_text()
    motion = read("esm_hi_ars1_hne.ASC")
    assert 100.0 * motion.pga == pytest.approx(float(re.search(r"PGA_CM/S\^2: (\S+)", text)[1]), rel=1e-3)
    at = float(re.search(r"TIME_PGA_S: (\S+)", text)[1])
    assert motion.time[np.abs(motion.x).argmax()] == pytest.approx(at, abs=0.006)


def test_knet_against_its_own_header():
    nied = pytest.importorskip("obspy.io.nied", reason="ObsPy is not installed")
    file = Path(nied.__file__).parent / "tests" / "data" / "test.knet"
    motion = read_motion(file)
    assert 100.0 * motion.pga == pytest.approx(4.383, rel=1e-4)
    assert (motion.dt, len(motion)) == (0.01, 5900)
    assert motion.name == "AKT013, EW"


def test_yonago_reads_without_a_station_position():
    motion = read("jma_yonago_2000.csv")
    assert list(motion.components) == ["x", "y", "z"]
    assert motion.name == "EA0米子市博労町（旧）, NS"
    assert len(motion) == 30000


def test_kobe_as_three_files():
    motion = Motion.combine(*(read(f"jma_kobe_1995_{d}.AT2") for d in ("ns", "ew", "ud")))
    assert list(motion.components) == ["x", "y", "z"]
    assert motion.pgv == pytest.approx(0.905, rel=0.02)
    assert motion.significant_duration == pytest.approx(8.4, abs=0.2)
    assert motion.arias == pytest.approx(8.27, rel=0.01)


def test_file_ending_does_not_matter(tmp_path):
    copy = tmp_path / "kobe.csv"
    copy.symlink_to(MOTIONS / "jma_kobe_1995_ns.AT2")
    assert read_motion(copy) == read("jma_kobe_1995_ns.AT2")


def test_unit_that_only_the_caller_knows_is_asked_for():
    with pytest.raises(ValueError, match="no unit"):
        read("mexico_sct_1985_t_ns_ew_ud_g.txt")
    with pytest.raises(ValueError, match="no time step"):
        read("hachinohe_1968_ns_gal_dt0.01.txt", unit="gal")

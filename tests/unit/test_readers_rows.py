"""Rows of several samples of one series, their number stated above them or not; columns without a time."""

from __future__ import annotations

import numpy as np
import pytest

import stayput as sp
from real_records import MOTIONS, recorded
from record_files import block, peaks, table

N = 397
WAVE = np.round(200.0 * np.sin(0.08 * np.arange(N)) * np.exp(-(((np.arange(N) - 200) / 70.0) ** 2)), 3)
TOUCHING = "%14.7E"  # as wide as a negative number


def china(count: int = N) -> str:
    """Return a header as China's strong-motion network writes it: its first lines look like numbers."""
    return (
        "001XYZ\n0010101 2001-01-01 00:00:00 BTM\nSTATION: 001XYZ 39.000N 77.000E\nCOMP. UD\n"
        "UNCORRECTED ACCELERATION          UNIT: CM/SEC/SEC\n"
        f"NO. OF POINTS:  {count}  EQUALLY SPACED INTERVALS OF:  0.01  SEC\nPEAK VALUE: 200 AT 2 SEC\n\n"
    )


def named(count: int = N) -> str:
    return (
        f"Time Increment (s)            : 0.01\nNumber of Data                : {count}\n"
        "Acceleration time series in gal\n"
    )


def cited(count: int = N) -> str:
    return f"# unit: gal\n# npts = {count}\n# dt = 0.01\n"


@pytest.mark.parametrize("head", [china, named, cited])
@pytest.mark.parametrize("per_line", [2, 4, 5, 8])
@pytest.mark.parametrize("form", [TOUCHING, "%10.3f", "%.6E "])
def test_rows_below_a_stated_number_are_one_series(read, head, per_line, form):
    motion, warned = read(head() + block(WAVE, form, per_line), component="channel 1")
    assert motion.x == pytest.approx(0.01 * WAVE, abs=1e-6)
    assert (motion.dt, warned) == (0.01, [])


@pytest.mark.parametrize("head", [china, named, cited])
@pytest.mark.parametrize("per_line", [1, 5, 8])
def test_what_does_not_fit_the_stated_number_is_refused(refusal, head, per_line):
    for stated, values in ((N + 1, WAVE), (N, WAVE[:-per_line]), (N, np.append(WAVE, 0.0))):
        for given in ({}, {"columns": "x=1"}):
            assert refusal(head(stated) + block(values, "%10.3f", per_line), **given).code == (
                "motion.not_as_stated"
            )


@pytest.mark.parametrize("per_line", [3, 5, 8])
def test_a_series_that_goes_on_from_row_to_row_is_known(read, refusal, per_line):
    rows = block(WAVE, TOUCHING, per_line)
    motion, warned = read(rows, unit="gal", dt=0.01)
    assert motion.x == pytest.approx(0.01 * WAVE, abs=1e-6)
    assert [warning.code for warning in warned] == ["motion.rows_taken_as_samples"]
    assert refusal(rows).code == "motion.no_unit_nor_step"
    assert refusal(rows.replace("\n", " 0.0\n", 1), unit="gal", dt=0.01)


@recorded
@pytest.mark.parametrize("name", ["jma_kobe_1995_ud.AT2", "esm_hi_ars1_hne.ASC", "elcentro_1940_180.AT2"])
@pytest.mark.parametrize("per_line", [5, 8])
def test_real_records_in_rows_are_known_as_one_series(read, refusal, name, per_line):
    motion = sp.read_motion(MOTIONS / name, component="channel 1")
    rows = block(motion.x, TOUCHING, per_line)
    assert read(rows, unit="m/s²", dt=motion.dt)[0].x == pytest.approx(motion.x, rel=1e-6)
    assert refusal(rows, unit="m/s²", dt=motion.dt, columns="x=1").code == "motion.rows_of_one_series"


@pytest.mark.parametrize("per_line", [2, 3, 4, 5, 8])
@pytest.mark.parametrize("head", ["", china()])
def test_no_column_is_taken_out_of_a_series(refusal, per_line, head):
    for columns in ("x=1", "x=2,y=1"):
        error = refusal(head + block(WAVE, "%10.3f", per_line), columns=columns, unit="gal", dt=0.01)
        assert (error.code, error.field) == ("motion.rows_of_one_series", "columns")


NOISE = np.round(np.random.default_rng(7).normal(0.0, 80.0, 4000), 4)


@pytest.mark.parametrize("per_line", [3, 4, 5, 8])
@pytest.mark.parametrize("head", ["cm/s2, dt = 0.01\n", "# gal\n# dt=0.01\n", ""])
def test_rows_of_noise_are_one_series_where_the_caller_says_so(read, refusal, head, per_line):
    rows = head + block(NOISE[:3997], "%10.4f ", per_line)
    given = {"unit": "gal", "dt": 0.01}
    motion, warned = read(rows, columns="rows", **given)
    assert motion.x == pytest.approx(0.01 * NOISE[:3997])
    assert (motion.dt, warned) == (0.01, [])
    full = head + block(NOISE[: 480 * per_line], "%10.4f ", per_line)
    (warning,) = read(full, columns="x=2", **given)[1]
    assert "must be rows" in warning.told("en")
    assert "「rows」" in warning.told("ja")
    if per_line != 4:
        error = refusal(full, **given)
        assert "(rows)" in error.told("en")
        assert "「rows」" in error.told("ja")


def test_rows_are_counted_and_one_column_with_a_heading_is_meant(read, refusal):
    assert refusal(cited(N + 1) + block(WAVE, "%10.3f", 5), columns="rows").code == "motion.not_as_stated"
    headed = "a,b,c\n" + "".join(f"{i}.5,{i}.25,{-i}.5\n" for i in (3, 1, 2, 5))
    assert read(headed, columns="x=b", unit="gal", dt=0.01)[1] == []


@pytest.mark.parametrize("lag", [0, 1, 30])
def test_channels_beside_one_another_are_columns(read, lag):
    rows = "".join(" ".join(f"{np.roll(WAVE, k * lag)[i]:.3f}" for k in range(5)) + "\n" for i in range(N))
    motion, warned = read(rows, columns="x=2,y=5", unit="gal", dt=0.01)
    assert motion.x == pytest.approx(0.01 * np.roll(WAVE, lag))
    assert {warning.code for warning in warned} <= {"motion.x_chosen"}


HEADERS = [
    (
        "STRONG GROUND MOTION RECORDS OF TURKIYE\nEARTHQUAKE DATE : 17/08/1999 00:01:39.07 (GMT)\n"
        "NUMBER OF DATA          : 60\nSAMPLING INTERVAL (sec) : 0.02\n"
        "RAW PGA VALUES (gal)    : (N-S) 10 (E-W) 30 (U-D) 20\n\n       N-S          E-W          U-D"
    ),
    "dt = 0.02, unit: gal\nNS,EW,UD",
    "# unit: gal\n# 50 sps\n# NS EW UD",
]


@pytest.mark.parametrize("head", HEADERS)
def test_directions_alone_below_a_time_step_have_no_time(read, head):
    rows = "\n".join(" ".join(line.split(",")[1:4]) for line in table("", 4).splitlines())
    rows = rows.replace(" ", ",") if "NS,EW" in head else rows
    motion, _ = read(f"{head}\n{rows}\n")
    assert peaks(motion) == {"x": 0.1, "y": 0.3, "z": 0.2}
    assert (motion.dt, len(motion)) == (0.02, 60)

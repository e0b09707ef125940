"""What stands above columns of numbers: time step, factor, sign, order, count. It is used or refused."""

from __future__ import annotations

import numpy as np
import pytest

import stayput as sp

TIME = 0.02 * np.arange(60)
WAVE = 300.0 * np.sin(6.0 * TIME)
OF_STEP = [
    "dt = 0.005",
    "DT=.005 s",
    "dt: 5 ms",
    "dt [s]: 0.005",
    "Time step 0.005 s",
    "Sampling interval (sec) = 5e-3",
    "sampling rate: 200 Hz",
    "Sampling frequency [Hz] 200",
    "時間刻み：0.005秒",
    "サンプリング周波数 200Hz",
]
OF_FACTOR = [
    "scale factor: 0.1",
    "Scale = 9.81",
    "multiply by 0.001",
    "conversion factor 2.5e-3",
    "factor = 2",
    "倍率：10",
]


def file_of(path, above, *columns):
    lines = (",".join(f"{value:.4f}" for value in row) for row in zip(*columns, strict=True))
    path.write_text("\n".join([*above, *lines]) + "\n", encoding="utf-8")
    return path


def refused(path, **options):
    with pytest.raises(sp.InputError) as caught:
        sp.read_motion(path, unit="gal", **options)
    return caught.value


@pytest.mark.parametrize("mark", ["# ", "// ", ""])
@pytest.mark.parametrize("line", OF_STEP)
def test_a_time_step_that_is_stated_is_used_or_contradicted(tmp_path, line, mark):
    file = file_of(tmp_path / "it.csv", [f"{mark}{line}"], WAVE)
    assert sp.read_motion(file, unit="gal").dt == pytest.approx(0.005)
    assert sp.read_motion(file, unit="gal", dt=0.005).dt == pytest.approx(0.005)
    error = refused(file, dt=0.02)
    assert "0.02 s; it must be the one that the file states, 0.005 s" in str(error)
    error = refused(file_of(tmp_path / "two.csv", [f"{mark}{line}"], TIME, WAVE))
    assert "states the time step 0.005 s and the file has 0.02 s" in str(error)
    assert "時間刻みは0.005 sですが" in error.told("ja")


@pytest.mark.parametrize(
    "line", ["dt = 0.02", "50 Hz", "sampling rate 50 Hz", "duration 1.2 s", "dt unknown"]
)
def test_lines_that_contradict_nothing_are_read_over(tmp_path, line):
    assert sp.read_motion(file_of(tmp_path / "it.csv", [f"# {line}"], TIME, WAVE), unit="gal").dt == 0.02


@pytest.mark.parametrize("line", OF_FACTOR)
def test_a_factor_that_is_stated_is_refused(tmp_path, line):
    file = file_of(tmp_path / "it.csv", [f"# {line}"], TIME, WAVE)
    error = refused(file)
    assert f"The line '{line}' states a factor" in str(error)
    assert "skip_lines passes the line over" in str(error)
    assert f"「{line}」の行に倍率" in error.told("ja")
    assert sp.read_motion(file, unit="gal", skip_lines=1).pga == pytest.approx(3.0, rel=1e-3)


@pytest.mark.parametrize("line", ["scale factor: 1.0", "scaled record", "large scale test 2 of 3", "No. 5"])
def test_other_figures_are_no_factor(tmp_path, line):
    assert sp.read_motion(file_of(tmp_path / "it.csv", [f"# {line}"], TIME, WAVE), unit="gal").dt == 0.02


def test_a_motion_that_was_changed_reads_as_it_was_written(tmp_path):
    motion = sp.sine(amplitude=4.0, frequency=1.0, duration=2.0).scaled(2.0).resampled(0.005)
    assert sp.read_motion(motion.write(tmp_path / "it.csv")).dt == 0.005
    assert sp.read_motion(motion.write(tmp_path / "it.at2")).dt == 0.005


@pytest.mark.parametrize(
    "name",
    [
        "Z (down)",
        "-Z",
        "\N{MINUS SIGN}UD",
        "UD-",
        "UD(-)",
        "Z down",
        "UD (+ down)",
        "Z (positive down)",
        "az_down",
        "上下（下向き）",
    ],
)
def test_a_vertical_that_is_positive_downward_is_refused(tmp_path, name):
    error = refused(file_of(tmp_path / "it.csv", [f"t,NS,EW,{name}"], TIME, WAVE, WAVE, WAVE))
    assert error.code == "motion.column_negative"
    assert "numbers must change sign" in str(error)
    assert "正負の向きが逆" in error.told("ja")


@pytest.mark.parametrize(
    "line", ["z positive down", "UD: + down", "Positive downwards", "上下動は下向きが正"]
)
@pytest.mark.parametrize("headings", [["t,NS,EW,UD"], []])
def test_a_line_that_says_so_is_refused(tmp_path, line, headings):
    error = refused(file_of(tmp_path / "it.csv", [f"# {line}", *headings], TIME, WAVE, WAVE, WAVE))
    assert f"The line '{line}' says that the vertical is positive downward" in str(error)
    assert "下向きが正です" in error.told("ja")


@pytest.mark.parametrize("name", ["Down", "DN", "acc_down"])
def test_a_channel_that_is_called_down_is_turned(tmp_path, name):
    above = ["# positive down", f"t,NS,EW,{name}"]
    motion = sp.read_motion(file_of(tmp_path / "it.csv", above, TIME, WAVE, WAVE, WAVE), "NS", unit="gal")
    assert motion.z == pytest.approx(-0.01 * WAVE, abs=1e-5)


@pytest.mark.parametrize("names", [("acc_y", "acc_x"), ("Y", "X"), ("y", "x")])
def test_x_and_y_are_what_their_headings_say(tmp_path, names):
    file = file_of(tmp_path / "it.csv", [",".join(("t", *names, "z"))], TIME, WAVE, 2.0 * WAVE, 0.5 * WAVE)
    motion = sp.read_motion(file, unit="gal")
    assert motion.x == pytest.approx(0.02 * WAVE, abs=1e-5)
    assert motion.y == pytest.approx(0.01 * WAVE, abs=1e-5)


@pytest.mark.parametrize("each", [1, 3, 5, 8])
def test_the_number_of_samples_and_the_step_may_stand_above_rows_of_any_length(tmp_path, each):
    rows = [" ".join(f"{a:.4f}" for a in WAVE[i : i + each]) for i in range(0, len(WAVE), each)]
    file = tmp_path / "it.txt"
    file.write_text("\n".join(["60 0.02", *rows]) + "\n", encoding="utf-8")
    motion = sp.read_motion(file, unit="gal")
    assert (len(motion), motion.dt) == (60, 0.02)
    assert motion.x == pytest.approx(0.01 * WAVE, abs=1e-5)
    file.write_text("\n".join(["61 0.02", *rows]) + "\n", encoding="utf-8")
    assert refused(file).code == "motion.not_as_stated"


@pytest.mark.parametrize("heading", ["no,L,V,T", "no,NS,EW,UD", "NS,EW,UD", "L,V,T", "X,Y"])
def test_without_a_column_of_time_the_way_out_is_named(tmp_path, heading):
    columns = [WAVE] * (heading.count(",") + 1)
    error = refused(file_of(tmp_path / "it.csv", [heading], *columns))
    assert (error.code, error.field) == ("motion.column_no_time", "columns")
    assert "unless columns says which to read and the time step is given" in str(error)
    assert "「columns」で" in error.told("ja")


def test_a_line_of_the_count_alone_may_be_passed_over(tmp_path):
    for columns in ((WAVE,), (TIME, WAVE)):
        file = file_of(tmp_path / "it.csv", ["60"], *columns)
        dt = 0.02 if len(columns) == 1 else None
        error = refused(file, dt=dt)
        assert "skip_lines passes" in str(error)
        assert "「skip_lines」で読み飛ばして" in error.told("ja")
        assert len(sp.read_motion(file, unit="gal", dt=dt, skip_lines=1)) == 60

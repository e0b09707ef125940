"""The command line: what it prints, writes and refuses, in this process and in real ones."""

import json
import os
import signal
import subprocess
import sys
from threading import Thread

import numpy as np
import pytest
from commands import cli
from interrupts import hears_interrupts

import stayput
from stayput.compiling import entry
from stayput.simulation.case import Case
from waiting import PATIENCE, wait_until

PROGRAM = [sys.executable, "-c", "from stayput.cli import main; main()"]
RECORD = "\n".join(f"{k * 0.01:.2f} {300 * ((k // 40) % 2 * 2 - 1)}" for k in range(400))


def process(*arguments, **options):
    return subprocess.run(
        [*PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False, **options
    )


@pytest.fixture
def record(tmp_path):
    file = tmp_path / "record.txt"
    file.write_text(RECORD)
    return file


def test_nothing_said_is_the_built_in_example():
    result = cli("simulate")
    assert result.exit_code == 0
    assert result.stdout.startswith("The bookcase ")
    for row in ("Motion", "Outcome", "Peak tilt", "Peak slide", "Wall and ceiling impacts"):
        assert row in result.stdout


def test_json_is_one_object_with_units():
    result = cli("simulate", "--body", "0.4x1.8x100", "--motion", "sine:5,0.8,5", "--json")
    data = json.loads(result.stdout)
    (piece,) = data["pieces"]
    assert {"outcome", "peak_slide_m", "overturn_time_s", "peak_tilt_rad", "residual_slide_m"} <= set(piece)
    assert {"floor_impacts", "wall_impacts"} <= set(piece)
    assert {"outcome", "engine", "events"} <= set(data)
    assert data["motion"]["duration_s"] == 5.0
    room = stayput.Room(stayput.Floor.of("wood flooring"))
    run = stayput.simulate(stayput.Body(0.4, 1.8, 100.0), room, stayput.sine(5.0, 0.8, 5.0))
    assert piece["peak_slide_m"] == run.peak_slide
    assert data["outcome"] == run.outcome
    assert (piece["overturn_time_s"] is None) == (not run.overturned)


def test_a_body_that_rests_has_null_for_its_overturning():
    data = json.loads(cli("simulate", "--body", "1x1x100", "--motion", "sine:0.1,1,1", "--json").stdout)
    assert (data["outcome"], data["pieces"][0]["overturn_time_s"], data["events"]) == ("rested", None, [])


def test_flags_override_the_scenario_file(tmp_path):
    file = tmp_path / "room.toml"
    file.write_text('[furniture]\npreset = "chest"\n[room]\nleft_wall = { gap = 0.5 }\n')
    floor = "room.floor={ static_friction = 0.2, kinetic_friction = 0.1 }"
    settings = ("shaking.scale=2", floor, "room.left_wall.gap=0.1", "room.right_wall.gap=0.3")
    flags = ["--motion", "sine:1,1,1", *(f"--set={setting}" for setting in settings)]
    seen = []
    original = stayput.Case.run

    def look(case):
        seen.append(case)
        return original(case)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(stayput.Case, "run", look)
        result = cli("simulate", file, *flags, "--json")
    assert result.exit_code == 0, result.stderr
    (case,) = seen
    assert (case.body.height, case.motion.pga) == (1.365, 2.0)
    assert case.room.floor == stayput.Floor(0.2, 0.1)
    assert (case.room.left_wall.gap, case.room.right_wall.gap) == (0.1, 0.3)


def test_a_record_relative_to_the_working_folder_and_to_the_scenario(tmp_path, record, monkeypatch):
    (tmp_path / "room.toml").write_text(
        '[furniture]\npreset = "chest"\n[shaking]\nrecord = "record.txt"\nunit = "gal"\n'
    )
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    by_file = json.loads(cli("simulate", "../room.toml", "--json").stdout)
    by_flag = json.loads(
        cli("simulate", "../room.toml", "--motion", record, "--set", "shaking.unit=gal", "--json").stdout
    )
    assert by_file == by_flag
    assert by_file["motion"]["pga_m_s2"] == pytest.approx(3.0)


def test_plot_and_animation_are_written(tmp_path):
    picture, film = tmp_path / "a.svg", tmp_path / "a.html"
    result = cli("simulate", "--motion", "sine:3,1,2", "--plot", picture, "--animate", film, "--speed", "0.5")
    assert result.exit_code == 0
    assert f"Wrote {picture}" in result.stdout
    assert "<svg" in picture.read_text()
    assert '"speed":0.5' in film.read_text()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["simulate", "--body", "0.4xnanx100"], "furniture.height is NaN"),
        (["simulate", "--motion", "nowhere.txt"], "nowhere.txt"),
        (["simulate", "nowhere.toml"], "could not be read"),
        (["simulate", "."], "could not be read"),
        (["simulate", "--plot", "nowhere/a.png"], "in a folder that exists"),
        (["simulate", "--plot", "a.txt"], "ends in .png, .svg, .pdf"),
        (["simulate", "--animate", "a.png"], "ends in .gif, .mp4, .html"),
        (["simulate", "--animate", "a.gif", "--fps", "0"], "fps is 0"),
        (["motion", "info", "."], "'.'"),
        (["motion", "plot", "near-fault", "a.txt"], "ends in .png, .svg, .pdf"),
        (["motion", "spectrum", "near-fault", "--damping", "1"], "Damping ratio is 1"),
        (["motion", "spectrum", "near-fault", "--out", "a.txt"], "ends in .csv"),
        (["motion", "spectrum", "near-fault", "--plot", "a.txt"], "ends in .png"),
        (["motion", "convert", "near-fault", "a.txt"], "ends in .csv, .at2"),
        (["motion", "convert", "near-fault", "a.at2"], "an AT2 file holds one component"),
        (["motion", "convert", "near-fault", "a.csv", "--step", "0.003"], "whole part or a multiple"),
    ],
)
def test_what_is_wrong_is_one_sentence_on_standard_error(tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    result = cli(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert message in result.stderr
    assert result.stderr.count("\n") == 1
    assert result.stderr.endswith(".\n")
    assert not list(tmp_path.iterdir())


def test_motion_info(record, tmp_path):
    data = json.loads(cli("motion", "info", record, "--set", "shaking.unit=gal", "--json").stdout)
    assert (data["samples"], data["dt_s"], data["synthetic"]) == (400, 0.01, False)
    assert data["components"]["x"]["pga_m_s2"] == pytest.approx(3.0)
    result = cli("motion", "info", "near-fault")
    assert "synthetic" in result.stdout
    assert "PGV [cm/s]" in result.stdout
    assert "JMA intensity 6.3, class 6-upper" in result.stdout
    refused = cli("motion", "info", record)
    assert refused.exit_code == 2
    assert "--unit must be given as one of" in refused.stderr


def test_motion_info_of_a_still_floor(tmp_path):
    file = tmp_path / "still.txt"
    file.write_text("0\n" * 500)
    words = ("motion", "info", file, "--unit", "gal", "--dt", "0.01")
    data = json.loads(cli(*words, "--json").stdout)
    assert data["jma_intensity"] is None
    assert data["jma_class"] == "0"
    assert data["components"]["x"]["mean_period_s"] is None
    assert "JMA intensity 0.0" in cli(*words).stdout


def test_motion_spectrum(tmp_path):
    files = tmp_path / "s.csv", tmp_path / "s.png"
    result = cli(
        "motion", "spectrum", "near-fault", "--damping", "0.02", "--out", files[0], "--plot", files[1]
    )
    assert result.exit_code == 0
    assert "2 % damping" in result.stdout
    table = np.genfromtxt(files[0], delimiter=",", names=True)
    spectrum = stayput.near_fault().spectrum(damping=0.02, component="y")
    assert np.array_equal(table["sa_y_m_s2"], spectrum.sa)
    assert np.array_equal(table["period_s"], spectrum.periods)
    assert files[1].read_bytes().startswith(b"\x89PNG")


def test_motion_convert(tmp_path):
    out = tmp_path / "a.at2"
    result = cli(
        "motion", "convert", "near-fault", out, "--intensity", "5-upper", "--only", "y", "--step", "0.02"
    )
    assert result.exit_code == 0
    back = stayput.read_motion(out)
    wanted = stayput.near_fault().to_intensity(5.25).resampled(0.02).component("y")
    assert back.x == pytest.approx(wanted.x, rel=1e-12, abs=1e-12)
    assert (back.dt, back.synthetic) == (0.02, True)
    assert (
        cli("motion", "convert", "near-fault", tmp_path / "b.csv", "--set", "shaking.scale=2").exit_code == 0
    )
    assert stayput.read_motion(tmp_path / "b.csv").pga == pytest.approx(2.0 * stayput.near_fault().pga)


@pytest.fixture
def compiling(monkeypatch, tmp_path):
    """A case that compiles something, in a thread of its own as the runs of `verify` do."""
    run = Case.run

    @entry
    def never_compiled_before(result):
        result[0] = 1.0

    def compiling(case):
        thread = Thread(target=never_compiled_before, args=(np.zeros(1),))
        thread.start()
        thread.join()
        return run(case)

    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(Case, "run", compiling)


@pytest.mark.parametrize(
    ("lang", "said"),
    [("en", "Compiling the mechanics once, which"), ("ja", "計算プログラムを準備しています")],
)
def test_compiling_is_announced_on_standard_error(compiling, lang, said):
    result = cli("simulate", "--motion", "sine:1,1,1", "--json", "--lang", lang)
    assert result.stderr.startswith(said)
    json.loads(result.stdout)


def test_help_loads_nothing_heavy():
    look = "import sys; from stayput.cli import main\ntry: main()\nexcept SystemExit: pass\n"
    heavy = {"numba", "numpy", "obspy", "matplotlib", "pydantic", "xarray"}
    line = [sys.executable, "-c", f"{look}print({heavy} & set(sys.modules))", "--help"]
    shown = subprocess.run(line, capture_output=True, text=True, check=True).stdout
    assert "simulate" in shown
    assert shown.rstrip().endswith("set()")


def test_a_real_process_refuses_with_2_and_leaves_nothing(tmp_path):
    file = tmp_path / "room.toml"
    file.write_text('[furniture]\npreset = "bokcase"\n')
    result = process("simulate", "room.toml", "--plot", "a.png", "--animate", "a.gif", cwd=tmp_path)
    assert result.returncode == 2
    assert result.stdout == ""
    assert result.stderr.startswith("room.toml: furniture.preset is 'bokcase' (did you mean 'bookcase'?)")
    assert "Traceback" not in result.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["room.toml"]


@pytest.mark.processes
@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
def test_ctrl_c_exits_with_130_and_leaves_nothing(tmp_path):
    file = tmp_path / "a.gif"
    running = subprocess.Popen(
        [*PROGRAM, "simulate", "--animate", str(file), "--speed", "0.02"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=hears_interrupts,
    )  # fmt: skip
    wait_until(lambda: list(tmp_path.iterdir()))
    assert [path.name.startswith(".a-") for path in tmp_path.iterdir()] == [True]  # the draft, being written
    running.send_signal(signal.SIGINT)
    _, said = running.communicate(timeout=PATIENCE)
    assert running.returncode == 130
    assert said.endswith("Interrupted.\n")
    assert "Traceback" not in said
    assert not list(tmp_path.iterdir())


def test_motion_suite_made_and_read_again(tmp_path):
    words = "motion suite --family crustal --count 3 --intensity 5-upper --out"
    made = cli(*words.split(), tmp_path / "a")
    assert made.exit_code == 0, made.output
    assert "3 synthetic motions: JMA intensity 5.2 to 5.2" in made.stdout
    suite = stayput.read_suite(tmp_path / "a" / "motions")
    assert suite.intensities == pytest.approx([5.25] * 3, abs=1e-9)
    assert suite.synthetic
    table = (tmp_path / "a" / "suite.csv").read_text("utf-8-sig").splitlines()
    assert len(table) == 4
    assert table[0].startswith("file,name,synthetic")
    assert (tmp_path / "a" / "suite.png").read_bytes().startswith(b"\x89PNG")
    read = cli(
        *("motion", "suite", "--records", tmp_path / "a" / "motions", "--target", "asce7:1.0,0.6"),
        *("--select", "2", "--band", "0.2,2", "--out", tmp_path / "b"),
    )
    assert read.exit_code == 0, read.output
    assert "2 synthetic motions" in read.stdout
    assert "Median spectrum against ASCE 7" in read.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--family", "tsunami"], "shaking.suite.family is 'tsunami'"),
        (["--count", "0"], "shaking.suite.count is 0"),
        (["--target", "japan:often"], "often"),
        (["--target", "japan", "--intensity", "6"], "--target is given beside --intensity"),
        (["--target", "asce7:1"], "--target is 'asce7:1'"),
        (["--select", "3"], "--select is given without --target"),
        (["--fit", "guess"], "--fit is 'guess'"),
        (["--band", "5"], "--band is '5'"),
        (["--records", "nowhere"], "it must be a folder"),
        (["--intensity", "12"], "shaking.intensity is 12"),
    ],
)
def test_motion_suite_refuses_before_it_writes(tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    result = cli("motion", "suite", "--out", "out", *arguments)
    assert result.exit_code == 2
    assert message in result.stderr
    assert not list(tmp_path.iterdir())

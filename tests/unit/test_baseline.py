"""Records with an offset, with gravity in them, or with a count of samples in the place of the time."""

from __future__ import annotations

import json
import warnings
from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

import stayput as sp
from stayput.cli import app
from stayput.motion.processing import oscillates_about_offset

if TYPE_CHECKING:
    from pathlib import Path

TIME = 0.02 * np.arange(500)
WAVE = np.sin(6.0 * TIME)
SCENARIO = """
[furniture]
width = 0.3
height = 1.8
mass = 90.0
[shaking]
record = "{record}"
unit = "m/s²"
{more}
[uncertainty]
samples = 2
"""


def record(file: Path, **components: np.ndarray) -> Path:
    """Write columns of t and the components, with headings that give no unit."""
    rows = np.column_stack((TIME, *components.values()))
    heading = ",".join(("t", *components))
    np.savetxt(file, rows, delimiter=",", header=heading, comments="")
    return file


def counted(file: Path, start: int) -> Path:
    np.savetxt(file, np.column_stack((start + np.arange(500), WAVE)), fmt="%.6g")
    return file


def cli(*arguments: object) -> tuple[int, str]:
    done = CliRunner().invoke(app, [str(argument) for argument in arguments])
    return done.exit_code, done.output


def told(call) -> list[str]:
    """Return the codes of what a call warns of."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    return [one.message.code for one in caught if isinstance(one.message, sp.InputWarning)]


@pytest.mark.parametrize("start", [0, 1, 2001])
def test_a_count_of_samples_is_no_time(tmp_path, start):
    file = counted(tmp_path / "counted.txt", start)
    with pytest.raises(
        sp.InputError, match=f"counts {start}, {start + 1}, …, .* dt must be given"
    ) as refused:
        sp.read_motion(file, unit="m/s²")
    assert "1ずつ増えています" in refused.value.told("ja")
    motion = sp.read_motion(file, unit="m/s²", dt=0.02)
    assert (motion.dt, len(motion)) == (0.02, 500)
    np.testing.assert_allclose(motion.x, WAVE, atol=1e-5)
    code, output = cli("simulate", "--motion", file, "--set", "shaking.unit=m/s²")
    assert code == 2
    assert "--dt must be given" in output


def test_seconds_that_are_called_so_are_times_of_an_unusual_step(tmp_path):
    file = counted(tmp_path / "counted.txt", 0)
    file.write_text("t (s) x\n" + file.read_text())
    with pytest.warns(
        sp.InputWarning, match=r"time step is 1 s, by which nothing faster than 0\.5 Hz"
    ) as caught:
        assert sp.read_motion(file, unit="m/s²").dt == 1.0
    assert "0.5 Hzより速い揺れ" in caught[0].message.told("ja")
    file.write_text(file.read_text().replace("t (s)", "t[ms]"))
    assert told(lambda: sp.read_motion(file, unit="m/s²")) == []


@pytest.mark.parametrize("g", [-9.81, 9.80665, -9.7])
def test_gravity_in_a_component_is_refused_and_taken_off_where_that_is_asked_for(tmp_path, g):
    for up in (np.full(500, g), g + 0.3 * WAVE):
        file = record(tmp_path / "gravity.csv", x=WAVE, y=0.5 * WAVE, z=up)
        with pytest.raises(sp.InputError, match=r"mean acceleration of z is .* which is gravity") as refused:
            sp.read_motion(file, unit="m/s²")
        assert refused.value.field == "remove_mean"
        assert "重力加速度が含まれています" in refused.value.told("ja")
        motion = sp.read_motion(file, unit="m/s²", remove_mean=True)
        np.testing.assert_allclose(motion.z, up - up.mean(), atol=1e-12)
        assert "mean removed [m/s²]: x 0.03281, y 0.0164, z " in motion.source
        saved = motion.write(tmp_path / "saved.csv").read_text(encoding="utf-8")
        assert "mean removed [m/s²]" in saved.splitlines()[0]


def test_an_offset_is_warned_of_wherever_the_record_is_used(tmp_path):
    offset, clean = tmp_path / "offset.csv", record(tmp_path / "clean.csv", x=WAVE)
    record(offset, x=WAVE + 0.3)
    scenario = tmp_path / "scene.toml"
    scenario.write_text(SCENARIO.format(record=offset.name, more=""), encoding="utf-8")
    english, japanese = "x oscillates about 0.3328 m/s²", "x成分の加速度が0.3328 m/s²を中心に振動し"
    of_motion = ("--motion", offset, "--unit", "m/s²")
    for command in (
        ("simulate", *of_motion),
        ("motion", "info", offset, "--unit", "m/s²"),
        ("verify", scenario),
    ):
        code, output = cli(*command)
        assert (code, english in output, "(--set shaking.remove_mean)" in output) == (0, True, True), output
        assert japanese in cli(*command, "--lang", "ja")[1]
        assert "oscillates" not in cli(*command, "--set", "shaking.remove_mean=true")[1]
    with pytest.warns(sp.InputWarning, match=english):
        sp.verify(sp.read(scenario), progress=False)
    assert told(lambda: sp.read_motion(offset, unit="m/s²", remove_mean=True)) == []
    assert told(lambda: sp.read_motion(clean, unit="m/s²")) == []
    with pytest.warns(sp.InputWarning, match=english):
        sp.read_suite([clean, offset], unit="m/s²")


@pytest.mark.parametrize(("share", "least"), [(0.5, 4.9), (0.3, 6.9), (0.13, 8.6)])
def test_an_offset_that_begins_within_the_record_is_warned_of(tmp_path, share, least):
    late = np.where(TIME[-1] * (1.0 - share) < TIME, 0.4, 0.0)
    file = record(tmp_path / "late.csv", x=np.sin(40.0 * TIME) * np.exp(-0.3 * TIME) + late, y=WAVE)
    with pytest.warns(sp.InputWarning) as heard:
        sp.read_motion(file, unit="m/s²")
    warning = next(one.message for one in heard if one.message.code == "motion.late_offset")
    assert warning.values["begin"] >= least
    assert "x oscillates about 0." in str(warning)
    assert "秒付近から" in warning.told("ja")
    assert sum(one.message.code == "motion.late_offset" for one in heard) == 1  # x alone


def test_that_the_mean_was_taken_off_is_told_and_written(tmp_path):
    offset = record(tmp_path / "offset.csv", x=WAVE + 2.0)
    of_motion = ("--motion", offset, "--unit", "m/s²", "--set", "shaking.remove_mean=true")
    assert "the mean of each component taken off" in cli("simulate", *of_motion)[1]
    assert "各成分の平均を除去" in cli("simulate", *of_motion, "--lang", "ja")[1]
    shown = cli("simulate", *of_motion, "--json")[1]
    assert "mean removed [m/s²]: x 2.0" in json.loads(shown[shown.index("{") :])["motion"]["source"]
    motion = sp.read_motion(offset, unit="m/s²", remove_mean=True)
    file = motion.write(tmp_path / "written.at2")
    assert "mean removed [m/s²]: x 2.0" in file.read_text(encoding="utf-8").splitlines()[0]
    np.testing.assert_allclose(sp.read_motion(file).x, motion.x, atol=1e-14)


def test_an_assessment_warns_too(tmp_path):
    record(tmp_path / "offset.csv", x=WAVE + 0.3)
    for more, warned in (("", True), ("remove_mean = true", False)):
        (tmp_path / "scene.toml").write_text(
            SCENARIO.format(record="offset.csv", more=more), encoding="utf-8"
        )
        (tmp_path / "pieces.csv").write_text("id,depth [m],height [m],mass [kg]\na,0.3,1.8,90\n")
        out = tmp_path / f"out {warned}"
        code, output = cli(
            "assess", tmp_path / "pieces.csv", "--scenario", tmp_path / "scene.toml", "--out", out
        )
        assert (code, "oscillates about" in output, "(--set shaking.remove_mean)" in output) == (
            0,
            warned,
            warned,
        ), output


def test_the_report_says_that_the_mean_was_taken_off_and_how_to_do_so_again(tmp_path):
    record(tmp_path / "offset.csv", x=WAVE + 2.0)
    text = SCENARIO.format(record="offset.csv", more="remove_mean = true")
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    verdict = sp.verify(sp.read(tmp_path / "scene.toml"), levels=[], progress=False)
    for language, said in (("en", "less the mean of each component"), ("ja", "各成分の平均を除去")):
        markdown = verdict.to_markdown(language)
        assert said in markdown
        assert "remove_mean = true" in markdown


def test_only_a_record_has_a_mean_to_take_off():
    with pytest.raises(sp.InputError, match=r"shaking\.remove_mean is given without"):
        sp.Scenario.parse({"furniture": {"preset": "chest"}, "shaking": {"remove_mean": True}})


def test_motions_of_arrays_are_warned_of_in_python():
    body, room = sp.Body(0.4, 1.8, 100.0), sp.Room()
    for motion, code in (
        (sp.Motion(0.02, WAVE + 2.0), "motion.offset"),
        (sp.Motion(0.02, WAVE, z=np.full(500, -9.81)), "motion.gravity"),
        (sp.Motion(0.02, WAVE, z=0.1 * WAVE + 9.81), "motion.gravity"),
    ):
        assert code in told(lambda motion=motion: sp.simulate(body, room, motion))
        assert code in told(
            lambda motion=motion: sp.verify(body, shaking=motion, samples=1, levels=[], measures=[])
        )
    with pytest.warns(sp.InputWarning, match=r"\(baseline_corrected\)"):
        sp.simulate(body, room, sp.Motion(0.02, WAVE + 2.0))


STEPS = st.sampled_from([0.001, 0.01, 0.02])
SIZES = st.floats(0.1, 30.0)


@settings(max_examples=50, deadline=None)
@given(STEPS, SIZES, st.floats(0.1, 2.0), st.floats(0.0, 2.0), st.floats(0.2, 5.0))
def test_test_inputs_with_a_mean_are_none_that_are_warned_of(dt, size, duration, quiet, frequency):
    n, still = round(duration / dt), np.zeros(round(quiet / dt))
    t = dt * np.arange(n)
    for a in (
        np.full(n, size),
        size * np.sin(np.pi * t / duration),
        size * t / duration,
        size * np.sin(2.0 * np.pi * frequency * t),
        size * np.cos(2.0 * np.pi * frequency * t),
        size * np.sign(np.sin(2.0 * np.pi * frequency * t)),
    ):
        assert not oscillates_about_offset(np.concatenate((a, still)), dt)


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 10**6), SIZES)
def test_noise_is_none_and_is_one_with_an_offset(seed, size):
    noise = np.random.default_rng(seed).normal(size=3000)
    noise -= noise.mean()
    assert not oscillates_about_offset(size * noise, 0.01)
    assert oscillates_about_offset(size * (noise + 0.5), 0.01)
    assert oscillates_about_offset(size * (noise - 0.5), 0.01)


def test_the_mean_and_the_unit_of_several_files(tmp_path):
    bare, stated = record(tmp_path / "bare.csv", x=WAVE), record(tmp_path / "stated.csv", y=-100.0 * WAVE)
    stated.write_text(stated.read_text().replace("t,y", "t,y (gal)"), encoding="utf-8")
    suite = sp.read_suite([bare, stated], unit="m/s²", remove_mean=True)
    np.testing.assert_allclose(suite[0].x, -suite[1].x, atol=1e-12)
    one = tmp_path / "one.txt"
    np.savetxt(one, WAVE)
    assert [motion.dt for motion in sp.read_suite([one, stated], unit="m/s²", dt=0.005)] == [0.005, 0.02]
    shown = cli(
        "motion", "info", bare, "--set", f"shaking.across={stated}", "--set", "shaking.unit=m/s²", "--json"
    )[1]
    peaks = json.loads(shown[shown.index("{") :])["components"]
    assert peaks["x"] == pytest.approx(peaks["y"])
    scene = sp.Scenario.parse(
        {
            "furniture": {"preset": "chest"},
            "shaking": {"record": "stated.csv", "across": "bare.csv", "unit": "m/s²"},
        },
        tmp_path,
    )
    motion = scene.motion()
    np.testing.assert_allclose(motion.x, -motion.y, atol=1e-12)
    with pytest.raises(sp.InputError, match="must be the one that the file states"):
        sp.read_motion(stated, unit="m/s²")
    with pytest.raises(sp.InputError, match="must be one of"):
        sp.read_suite([bare, stated], unit="furlong")


@pytest.mark.parametrize(
    ("columns", "english", "japanese"),
    [
        (
            {"x": WAVE, "y": WAVE + 6.9, "z": WAVE + 6.9},
            "x, y, z together is",
            "x, y, zを合わせた成分の加速度の平均が",
        ),
        ({"x": WAVE + 5.66, "y": WAVE, "z": WAVE - 8.0}, "x, y, z together is", "を合わせた成分"),
        ({"x": WAVE + 2.0}, "of its peak, which leaves the floor moving", "最後に床が"),
    ],
)
def test_gravity_on_a_tilted_instrument_and_a_large_offset_are_refused(tmp_path, columns, english, japanese):
    file = record(tmp_path / "tilted.csv", **columns)
    with pytest.raises(sp.InputError) as refused:
        sp.read_motion(file, unit="m/s²")
    assert refused.value.field == "remove_mean"
    assert english in str(refused.value)
    assert "(remove_mean)" in str(refused.value)
    assert japanese in refused.value.told("ja")
    assert sp.read_motion(file, unit="m/s²", remove_mean=True)

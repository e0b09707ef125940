"""Three files, one component each; vertical records in a horizontal's place; displacements that drift."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from commands import cli

import stayput as sp


def at2(file: Path, direction: str, amplitude: float) -> Path:
    """Write a PEER file of a sine whose title ends in a direction."""
    motion = sp.sine(amplitude, 1.0, 10.0, phase=np.pi / 2)
    lines = motion.text(".at2").splitlines()
    lines[1] = f"Somewhere, 1/1/2020, Station, {direction}".removesuffix(", ")
    file.write_text("\n".join([*lines, ""]), encoding="utf-8")
    return file


@pytest.fixture
def records(tmp_path: Path) -> list[Path]:
    named = (("a.at2", "090", 3.0), ("b.at2", "000", 2.0), ("c.at2", "UP", 1.0))
    return [at2(tmp_path / name, direction, amplitude) for name, direction, amplitude in named]


def peaks(*arguments: object) -> dict[str, float]:
    done = cli("motion", "info", *arguments, "--json")
    assert done.exit_code == 0, done.output
    return {name: round(one["pga_m_s2"], 6) for name, one in json.loads(done.stdout)["components"].items()}


def beside(y: object, z: object) -> tuple[str, ...]:
    """Return what names the files of the components across and up."""
    return "--set", f"shaking.across={y}", "--set", f"shaking.vertical={z}"


def test_three_files_are_one_motion(records: list[Path], tmp_path: Path) -> None:
    x, y, z = records
    assert peaks(x, *beside(y, z)) == {"x": 3.0, "y": 2.0, "z": 1.0}
    assert peaks(x, "--set", f"shaking.vertical={z}") == {"x": 3.0, "z": 1.0}
    out = tmp_path / "joined.csv"
    done = cli("motion", "convert", x, out, *beside(y, z))
    assert done.exit_code == 0, done.output
    combined = sp.Motion.combine(*(sp.read_motion(file, component="channel 1") for file in records))
    read = sp.read_motion(out)
    assert all(np.array_equal(read.components[name], a) for name, a in combined.components.items())


@pytest.mark.parametrize("of_file", [True, False])
@pytest.mark.parametrize("key", ["record", "across"])
def test_a_vertical_record_is_named_by_the_key_that_it_is_given_for(
    records: list[Path], monkeypatch: pytest.MonkeyPatch, key: str, of_file: bool
) -> None:
    x, y, z = records
    files = {"record": x.name, "across": y.name, key: z.name}
    monkeypatch.chdir(x.parent)
    Path("scene.toml").write_text(f'[furniture]\npreset = "chest"\n[shaking]\nrecord = "{files["record"]}"\n')
    words = ("scene.toml",) if of_file else ("--motion", files["record"])
    done = cli("simulate", *words, "--set", f"shaking.across={files['across']}")
    assert done.exit_code == 2
    refusal = f"shaking.{key} is '{z.name}' ('UP'); it must be a horizontal record."
    assert done.stderr.splitlines()[-1].endswith(refusal)


@pytest.mark.parametrize("direction", ["UP", "HNZ"])
@pytest.mark.parametrize("command", [("simulate", "--motion"), ("motion", "info")])
def test_a_vertical_record_alone_is_warned_of(
    tmp_path: Path, direction: str, command: tuple[str, ...]
) -> None:
    done = cli(*command, at2(tmp_path / "record.at2", direction, 1.0))
    assert done.exit_code == 0
    assert f"a vertical channel alone, '{direction}'" in done.stderr


def test_a_record_with_an_offset_drifts_and_says_so(tmp_path: Path) -> None:
    still = sp.near_fault()
    off = sp.Motion(still.dt, still.x + 0.02)
    assert not still.peaks()["x"].displacement_drifts
    assert off.peaks()["x"].displacement_drifts
    file = off.write(tmp_path / "off.csv")
    done = cli("motion", "info", file)
    assert done.stderr.startswith("Warning: The displacement of x drifts with the record's baseline")
    (line,) = (line for line in done.stdout.splitlines() if line.startswith("PGD"))
    assert line.split()[-1] == "–"
    said = json.loads(cli("motion", "info", file, "--json").stdout)["components"]["x"]
    assert said["displacement_drifts"]
    assert said["pgd_baseline_corrected_m"] < 0.8 * said["pgd_m"]
    done = cli("motion", "plot", file, tmp_path / "plot.png")
    assert "drifts" in done.stderr
    assert cli("motion", "info", "near-fault").stderr == ""


@pytest.fixture
def plain_columns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Columns of numbers of which one lacks a unit and a time step, and one is vertical alone."""
    monkeypatch.chdir(tmp_path)
    values = [f"{0.5 * (-1) ** (i // 20):.2f}" for i in range(400)]
    (tmp_path / "bare.txt").write_text("\n".join(values), encoding="utf-8")
    rows = [f"{0.01 * i:.2f},{value}" for i, value in enumerate(values)]
    (tmp_path / "up.csv").write_text("\n".join(["time,UD[gal]", *rows]), encoding="utf-8")


@pytest.mark.parametrize("lang", ["en", "ja"])
@pytest.mark.parametrize("command", [("motion", "info"), ("simulate", "--motion")], ids=" ".join)
@pytest.mark.usefixtures("plain_columns")
def test_what_a_record_lacks_is_asked_for_by_its_flags(command: tuple[str, ...], lang: str) -> None:
    def told(*arguments: str) -> str:
        return cli(*command, *arguments, "--lang", lang).stderr

    both, step = told("bare.txt"), told("bare.txt", "--set", "shaking.unit=gal")
    assert "--unit" in both
    assert "--dt" in both
    assert "shaking.unit" not in step
    assert "--dt" in step
    assert "--set shaking.component" in told("up.csv")
    assert "shaking.component" not in told("up.csv", "--set", "shaking.component=UD")


def test_a_vertical_record_that_is_named_is_meant(tmp_path: Path, recwarn: pytest.WarningsRecorder) -> None:
    level = sp.read_motion(at2(tmp_path / "KJM-000.at2", "", 1.0))
    for name, label in (("KJM-UP.at2", ""), ("up.at2", "UP")):
        up = sp.read_motion(at2(tmp_path / name, label, 1.0), component="channel 1")
        assert sp.Motion.combine(level, z=up).z is not None
    assert not recwarn.list

"""A folder as PEER or NIED delivers it: what belongs together is one motion, and other files are left out."""

from __future__ import annotations

import json

import numpy as np
import pytest
from typer.testing import CliRunner

import stayput as sp
from record_files import knet
from stayput.cli import app
from stayput.errors import warnings_to

N = 200
PEER = {
    "RSN6_IMPVALL.I_I-ELC": ("Imperial Valley-02, 5/19/1940, El Centro Array #9", ("180", "270", "-UP")),
    "RSN1106_KOBE_KJM": ("Kobe_ Japan, 1/16/1995, KJMA", ("000", "090", "-DWN")),
}
KINDS = {"AT2": ("ACCELERATION", "G"), "VT2": ("VELOCITY", "CM/S"), "DT2": ("DISPLACEMENT", "CM")}


def peer_file(title: str, size: float, kind: str = "AT2") -> str:
    quantity, unit = KINDS[kind]
    head = f"PEER NGA RECORD\n{title}\n{quantity} TIME SERIES IN UNITS OF {unit}\nNPTS= {N}, DT= .01 SEC\n"
    return head + "".join(f"{size * 0.01 * np.sin(i * 0.3):.7E}\n" for i in range(N))


def nied_file(station: str, direction: str, size: int) -> str:
    counts = np.round(size * 20000 * np.sin(np.arange(N) * 0.7)).astype(int)
    peak = np.abs(counts - counts.mean()).max() * 2000 / 8388608
    return knet(direction, counts=counts, peak=peak).replace("TST001", station)


@pytest.fixture
def peer(tmp_path):
    folder = tmp_path / "peer"
    folder.mkdir()
    for name, (title, directions) in PEER.items():
        for size, direction in enumerate(directions, 1):
            for kind in KINDS:
                text = peer_file(f"{title}, {direction.strip('-')}", size, kind)
                (folder / f"{name}{direction}.{kind}").write_text(text, encoding="utf-8")
    (folder / "_SearchResults.csv").write_text(
        "PEER Ground Motion Database\n-- Summary --\n", encoding="utf-8"
    )
    return folder


@pytest.fixture
def nied(tmp_path):
    folder = tmp_path / "nied"
    folder.mkdir()
    for station in ("MYG004", "IWT010"):
        for size, (ending, direction) in enumerate((("NS", "N-S"), ("EW", "E-W"), ("UD", "U-D")), 1):
            file = folder / f"{station}1103111446.{ending}"
            file.write_text(nied_file(station, direction, size), encoding="utf-8")
    for number, ending in enumerate(("NS1", "EW1", "UD1", "NS2", "EW2", "UD2"), 1):
        text = nied_file("MYGH10", str(number), number)
        (folder / f"MYGH101103111446.{ending}").write_text(text, encoding="utf-8")
    (folder / "MYG0041103111446.ps.gz").write_bytes(b"\x1f\x8b\0")
    return folder


def read(folder, *arguments, **options):
    heard: list[sp.InputWarning] = []
    with warnings_to(heard.append):
        return sp.read_suite(folder, *arguments, **options), heard


def sizes(motion: sp.Motion) -> list[int]:
    unit = 0.01 * 20000 * 2000 / 8388608  # of a file of size 1
    return [round(float(np.abs(a).max()) / unit) for a in motion.components.values()]


def test_a_folder_of_peer_is_a_motion_a_record_number(peer):
    suite, (left_out,) = read(peer)
    assert [motion.name for motion in suite] == [
        "Kobe_ Japan, 1/16/1995, KJMA, 000",
        "Imperial Valley-02, 5/19/1940, El Centro Array #9, 180",
    ]
    for motion in suite:
        assert list(motion.components) == ["x", "y", "z"]
    assert suite[0].z[5] == pytest.approx(-3 * suite[0].x[5])  # the one that points down
    assert suite[1].z[5] == pytest.approx(3 * suite[1].x[5])
    assert str(left_out) == (
        "Of the folder 'peer' these files are left out: RSN1106_KOBE_KJM-DWN.DT2, RSN1106_KOBE_KJM-DWN.VT2, "
        "RSN1106_KOBE_KJM000.DT2 and 9 more (no acceleration); _SearchResults.csv (no record)."
    )
    assert "など（ほか9件）（加速度ではない）、_SearchResults.csv（記録ではない）。" in left_out.told("ja")


def test_titles_without_directions_are_joined_by_the_number_too(peer):
    for file in peer.glob("*.AT2"):
        text = file.read_text(encoding="utf-8")
        title = text.splitlines()[1]
        file.write_text(text.replace(title, title.replace(", ", " ")), encoding="utf-8")
    assert [list(motion.components) for motion in read(peer)[0]] == [["x", "y", "z"]] * 2
    for file in peer.glob("*.AT2"):
        text = file.read_text(encoding="utf-8")
        title = text.splitlines()[1]
        file.write_text(text.replace(title, title.rpartition(" ")[0]), encoding="utf-8")
    with pytest.raises(
        sp.InputError,
        match=r"RSN1106_KOBE_KJM-DWN.AT2 .*3 channels are not those of one sensor; component must name",
    ):
        read(peer)
    for file in peer.glob("*-*.AT2"):
        if file.name.endswith(("-UP.AT2", "-DWN.AT2")):
            file.unlink()
    suite, _ = read(peer)
    assert [list(motion.components) for motion in suite] == [["x", "y"], ["x", "y"]]


def test_a_folder_of_nied_is_a_motion_a_station_at_the_surface(nied):
    suite, (left_out,) = read(nied)
    assert [motion.name for motion in suite] == ["IWT010, EW", "MYG004, EW", "MYGH10, EW2"]
    assert [sizes(motion) for motion in suite[:2]] == [[2, 1, 3], [2, 1, 3]]
    assert sizes(suite[2]) == [5, 4, 6]
    said = str(left_out)
    assert "MYG0041103111446.ps.gz (no record); " in said
    assert "MYGH101103111446.EW1, MYGH101103111446.NS1, MYGH101103111446.UD1 (borehole)." in said
    assert "（地中の記録）" in left_out.told("ja")
    along, _ = read(nied, "NS")
    assert [motion.name for motion in along] == ["IWT010, NS", "MYG004, NS", "MYGH10, NS2"]


def test_texts_beside_the_records_are_left_out_with_a_line(nied):
    (nied / "readme.txt").write_text("1 Terms\n2 Use of the data\n", encoding="utf-8")
    (nied / "お読みください.txt").write_text("強震記録のご利用について\n", encoding="utf-8")
    suite, heard = read(nied)
    assert len(suite) == 3
    told = next(warning for warning in heard if warning.code == "motion.suite_left_out")
    assert "readme.txt, お読みください.txt (no record)" in str(told)
    assert "readme.txt、お読みください.txt（記録ではない）" in told.told("ja")


def test_other_records_in_one_folder_stay_apart(tmp_path):
    titles = ("QUAKE 1, PLACE, 000", "QUAKE 2, PLACE, 090", "QUAKE 1, ELSEWHERE, 090", "no direction here")
    for number, title in enumerate(titles):
        (tmp_path / f"{number}.at2").write_text(peer_file(title, number + 1), encoding="utf-8")
    suite, heard = read(tmp_path)
    assert [list(motion.components) for motion in suite] == [["x"]] * 4
    assert heard == []


@pytest.mark.parametrize("copies", [("RSN6_a.at2", "RSN6_b.at2", "RSN6_c.at2"), ("a.at2", "b.at2", "c.at2")])
def test_three_horizontal_files_of_one_record_are_refused(tmp_path, copies):
    for name, direction in zip(copies, ("000", "090", "000"), strict=True):
        (tmp_path / name).write_text(peer_file(f"QUAKE, PLACE, {direction}", 1.0), encoding="utf-8")
    with pytest.raises(
        sp.InputError,
        match=f"{copies[0]}.*3 channels are not those of one sensor; component must name one of 000",
    ):
        read(tmp_path)


def test_a_list_of_files_is_a_motion_a_file(peer):
    files = sorted(peer.glob("RSN6*.AT2"))[:2]
    suite, _ = read(files, "channel 1")
    assert [list(motion.components) for motion in suite] == [["x"], ["x"]]


def test_a_folder_of_velocities_alone_has_no_record(peer):
    for file in peer.glob("*.AT2"):
        file.unlink()
    with pytest.raises(sp.InputError, match="'peer' is empty"):
        read(peer)


def test_a_damaged_record_is_no_file_to_leave_out(peer):
    file = peer / "RSN6_IMPVALL.I_I-ELC270.AT2"
    file.write_text(file.read_text(encoding="utf-8")[:-40], encoding="utf-8")
    with pytest.raises(sp.InputError, match=r"RSN6_IMPVALL\.I_I-ELC270\.AT2"):
        read(peer)


def test_the_command_line_and_a_scenario_take_such_a_folder(peer, tmp_path):
    done = CliRunner().invoke(
        app, ["motion", "suite", "--records", str(peer), "--out", str(tmp_path / "out")]
    )
    assert done.exit_code == 0, done.output
    assert "left out" in done.stderr
    rows = (tmp_path / "out" / "suite.csv").read_text(encoding="utf-8-sig").splitlines()
    assert len(rows) == 3
    body = "[furniture]\npreset = 'chest'\n[shaking]\nsuite = 'peer'\nmember = 2\n"
    (tmp_path / "scene.toml").write_text(body, encoding="utf-8")
    told = CliRunner().invoke(app, ["simulate", str(tmp_path / "scene.toml"), "--json"])
    assert json.loads(told.stdout)["motion"]["name"].endswith("El Centro Array #9, 180")


@pytest.mark.parametrize(
    ("lang", "said"), [("en", "shaking.columns has 'x'; it must"), ("ja", "shaking.columnsに「x」が")]
)
def test_the_suite_s_flags_are_refused_by_their_keys(peer, tmp_path, lang, said):
    words = [
        "motion",
        "suite",
        "--records",
        str(peer),
        "--out",
        str(tmp_path / "out"),
        "--set",
        "shaking.columns=x",
    ]
    done = CliRunner().invoke(app, [*words, "--lang", lang])
    assert done.exit_code == 2
    assert said in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_vertical_record_alone_is_no_motion_of_a_suite(tmp_path):
    for name, direction in (("a", "UP"), ("b", "090")):
        (tmp_path / f"{name}.at2").write_text(peer_file(f"QUAKE, {name}, {direction}", 1.0), encoding="utf-8")
    suite, (left_out,) = read(tmp_path)
    assert [list(motion.components) for motion in suite] == [["x"]]
    assert "a.at2 (vertical alone)" in str(left_out)

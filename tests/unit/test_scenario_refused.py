"""Refusals of scenario files: each says the file and the key, and of several pieces their names."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
import tomli_w
from commands import cli

import stayput as sp

EXAMPLES = Path(__file__).parents[2] / "examples"
BOX = {"width": 0.4, "length": 0.6, "height": 0.5, "mass": 20.0}
STILL = {"sine": {"amplitude": 0.1, "frequency": 1.0, "duration": 1.0}}
PIECES: dict[str, Any] = {
    "furniture": [
        {"name": "chest", **BOX},
        {"name": "shelf", **BOX, "on": "chest"},
        {"name": "vase", "diameter": 0.1, "height": 0.3, "mass": 1.0, "at": [2.0, 0.0]},
    ],
    "room": {"floor": {}},
    "shaking": STILL,
}
ONE: dict[str, Any] = {"furniture": {"preset": "chest"}, "shaking": STILL}


def joint(**given: Any) -> dict[str, Any]:
    return {"joints": [{"first": "chest", "second": "shelf", "at": [0.0, 0.0, 0.5], **given}]}


def piece(number: int, **given: Any) -> dict[str, Any]:
    pieces = [dict(each) for each in PIECES["furniture"]]
    pieces[number] |= given
    return {"furniture": pieces}


def written(folder: Path, data: dict[str, Any]) -> Path:
    file = folder / "room.toml"
    file.write_text(tomli_w.dumps(data), encoding="utf-8")
    return file


def printed(file: Path, *flags: str, command: str = "simulate") -> str:
    found = cli(command, file, *flags)
    assert found.exit_code == 2, found.output
    return found.stderr


def both_print(file: Path) -> str:
    """Return what a simulation and a verification refuse, with the same sentence."""
    first, second = printed(file), printed(file, command="verify")
    assert first == second
    return first


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (piece(1, on="chest", at=[0.3, 0.0]), "furniture[1].at = [0.3, 0.0] must be a place on 'chest'"),
        (piece(0, mass=2e6), "furniture[0].mass is 2000000.0; it must be a number between 0.001 and 1e+06"),
        (piece(2, measures=[{"type": "belt"}]), "furniture[2].measures is given for a piece that is neither"),
        (piece(1, measures=[{"type": "glue"}]), "furniture[1].measures[0].type is 'glue'"),
        (piece(1, measures=[{"type": "belt"}, {"type": "belt"}]), "In [furniture[1]]: Belts is given twice"),
        (
            {"options": [{"name": "x", "measures": {"chest": [{"type": "belt"}] * 2}}]},
            "In [options[0]]: Belts is given twice",
        ),
        (
            {"options": [{"name": "x", "measures": {"cupboard": [{"type": "belt"}]}}]},
            "options[0].measures is 'cupboard'; it must be one of",
        ),
        (
            {"options": [{"name": "x", "measures": {"chest": [{"type": "glue"}]}}]},
            "options[0].measures.chest[0].type is 'glue'",
        ),
        (
            {"options": [{"name": "x", "measures": {"chest": [{"type": "belt", "height": -1.0}]}}]},
            "options[0].measures.chest[0].height is -1.0; it must be",
        ),
        (
            {"options": [{"name": "x", "measures": {"chest": {"type": "belt"}}}]},
            "options[0].measures.chest is a table; it must be a list",
        ),
        ({"options": [{"name": "x", "measures": [{"type": "belt"}]}]}, "options[0].measures is"),
        (
            {"furniture": [{"name": "stone", "mesh": "stone.stl", "unit": "furlong", "mass": 5.0}]},
            "In [furniture[0]]: The unit is 'furlong'; it must be one of",
        ),
        ({"furniture": 3}, "furniture is 3; it must be a table of name, preset,"),
        (piece(2, width=0.1), "The piece 'vase' needs one shape"),
        (piece(2, cg_offset=[0.0, 0.01]), "The piece 'vase' needs one shape"),
        (piece(0, preset="chest", diameter=0.3), "The piece 'chest' needs one shape"),
        (piece(0, shelves=[5.0], cg_offset=[0.0, 0.1]), "furniture[0].cg_offset"),
        (piece(0, cg_offset=[0.0, 3.0]), "In [furniture[0]]: Body cg_offset"),
        (
            {"furniture": [{"name": "box", "width": 0.4, "length": 0.4, "height": 0.4}]},
            "furniture[0].mass is missing",
        ),
        (piece(0, on="shelf"), "furniture[0].on is 'shelf'; it must be the name of a piece given before it"),
        (piece(1, name="chest"), "furniture[1].name is 'chest'"),
        ({"joints": 1}, "joints is 1; it must be a list"),
        (joint(second="door"), "joints[0].second is 'door'"),
        (joint(slack=0.1), "In [joints[0]]: A joint at one point has a slack of 0.1 m"),
        (joint(second="chest"), "In [joints[0]]: A joint joins 'chest' to itself"),
        (joint(at=[0.0, 0.0, 9.0]), "joints[0] holds 'chest' at a point 8.5 m outside of it"),
        ({"static_friction": 0.1}, "kinetic_friction is 0.3; it must be between 0 and 0.1"),
        ({"shaking": {"record": "none.csv"}}, "In [shaking]: '"),
        (piece(2, at=[0.1, 0.0]), "'chest' and 'vase' begin 0.15 m inside each other"),
        (piece(2, at=[2.0, 0.0, -0.1]), "'vase' begins 0.1 m inside the floor"),
        ({"room": {"floor": {}, "ceiling": {"height": 0.9}}}, "'shelf' begins 0.1 m inside the ceiling"),
        (piece(1, measures=[{"type": "gel_mats"}]), "'shelf': Adhesive gel mats belong on the floor"),
    ],
)
def test_a_file_of_several_pieces(tmp_path: Path, changed: dict[str, Any], said: str) -> None:
    assert both_print(written(tmp_path, PIECES | changed)).startswith(f"room.toml: {said}")


def test_a_sweep_names_the_pieces_too(tmp_path: Path) -> None:
    file = written(tmp_path, PIECES | piece(2, at=[0.1, 0.0]) | joint())
    with pytest.raises(sp.InputError, match="'chest' and 'vase' begin") as caught:
        sp.sweep(sp.read(file), {"gravity": [9.8]}, progress=False)
    assert "「" not in caught.value.told("ja")
    assert "'chest'と'vase'" in caught.value.told("ja")


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"room": {"floor": {"static_friction": 0.1}}}, "In [room.floor]: Floor kinetic friction is 0.3"),
        (
            {"furniture": {"preset": "chest", "unit": "furlong"}},
            "furniture.unit is given without furniture.mesh",
        ),
        ({"shaking": {"record": "none.csv", "unit": "furlong"}}, "In [shaking]: The unit of acceleration"),
        ({"shaking": {"suite": "none"}}, "In [shaking]: The suite"),
        ({"room": {"ceiling": {"height": 0.5}}}, "The body stands"),
        ({"room": {"ceiling": {"height": 0.5}}, "dimensions": 3}, "The body stands"),
        ({"shaking": {"suite": {"count": 2}, "member": 3}}, "In [shaking]: shaking.member is 3"),
        (
            {"shaking": {"intensity": 5.0, "sine": {"amplitude": 0.0, "frequency": 1.0, "duration": 1.0}}},
            "In [shaking]: The motion is a still floor",
        ),
        ({"measures": [{"name": "none", "combine": [{"type": "belt"}]}]}, "measures[0].name is 'none'"),
    ],
)
def test_a_file_of_one_piece(tmp_path: Path, changed: dict[str, Any], said: str) -> None:
    assert both_print(written(tmp_path, ONE | changed)).startswith(f"room.toml: {said}")


def test_what_a_flag_gets_wrong_is_not_the_files(tmp_path: Path) -> None:
    file = written(tmp_path, ONE)
    assert printed(file, "--set", "room.left_wall.gap=-1").startswith("room.left_wall.gap is -1;")
    damaged = written(tmp_path, ONE | {"gravity": 0.0})
    assert printed(damaged, "--set", "shaking.scale=2").startswith("room.toml: gravity is 0.0")


BESIDE_A_LONE_PIECE: list[tuple[dict[str, Any], str]] = [
    ({"joints": [{"first": "chest", "second": "it", "at": [0.0, 0.0, 0.5]}]}, "joints"),
    ({"static_friction": 0.5}, "static_friction is given for one piece"),
    ({"furniture": {"preset": "chest", "at": [1.0, 1.0, 0.5]}}, "furniture.at is given for one piece"),
    ({"options": [{"name": "x"}]}, "options is given for one piece"),
    ({"doors": [{"wall": "right_wall", "start": 0.5}]}, "doors is given without plan"),
    ({"room": {"walls": "concrete"}}, "room.walls is given without plan"),
]
BESIDE_PIECES: list[tuple[dict[str, Any], str]] = [
    ({"initial": {"tilt": 0.1}}, "initial is given where furniture is not one preset or box"),
    ({"everyday": {"drawers": 1}}, "everyday is given where furniture is not one preset or box"),
    ({"contents": {}}, "contents is given where furniture is not one preset or box"),
    ({"measures": [{"type": "belt"}]}, "measures is given where furniture is not one preset or box"),
    ({"dimensions": 2}, "dimensions is 2; it must be 3"),
    ({"plan": {"width": 3.0, "length": 3.0}, "room": {"left_wall": {"gap": 0.1}}}, "room.left_wall is given"),
]


@pytest.mark.parametrize(
    ("given", "changed", "said"),
    [*((ONE, *case) for case in BESIDE_A_LONE_PIECE), *((PIECES, *case) for case in BESIDE_PIECES)],
)
def test_what_a_scene_has_no_use_for(given: dict[str, Any], changed: dict[str, Any], said: str) -> None:
    with pytest.raises(sp.InputError, match=f"^{said}"):
        sp.Scenario.parse(given | changed)


def test_one_reader_takes_every_file(tmp_path: Path) -> None:
    assert [sp.read(EXAMPLES / f"{name}.toml").alone for name in ("verify", "television", "bedroom")] == [
        True,
        False,
        False,
    ]
    with pytest.raises(sp.InputError, match="furniture must here be one preset or box"):
        sp.read(EXAMPLES / "television.toml").case()
    drum = tmp_path / "drum.toml"
    drum.write_text("[furniture]\ndiameter = 0.5\nheight = 1.6\nmass = 250.0\n")
    refused = cli("verify", drum, "--measure", "belt").stderr
    assert refused.startswith("--measure is given where furniture is not")


def test_a_table_in_a_room_is_a_list_of_one() -> None:
    table = {"preset": "chest", "against": "left_wall", "along": 1.0}
    room: dict[str, Any] = {"plan": {"width": 3.0, "length": 3.0}, "shaking": STILL}
    runs = [sp.Scenario.parse({"furniture": stated, **room}).run() for stated in (table, [table])]
    assert runs[0].place.tobytes() == runs[1].place.tobytes()


CUBE = "".join(f"v {n >> 2 & 1} {n >> 1 & 1} {n & 1}\n" for n in range(8)) + (
    "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"
)
WINDOW = {"wall": "right_wall", "start": 0.5, "width": 0.8}
OPENINGS = {"plan": {"width": 3.6, "length": 2.7}, "doors": [{**WINDOW, "start": 0.2}]}


@pytest.mark.parametrize(
    ("changed", "english", "japanese"),
    [
        (
            {"furniture": {"preset": "bookcase", "mass": 80_000.0}},
            "a mean density of 1.85e+05 kg/m³",
            "平均密度",
        ),
        ({"furniture": {"preset": "wardrobe", "mass": 0.001}}, "between 1 and 25,000 kg/m³", "平均密度"),
        ({"furniture": {"preset": "chest", "width": 100.0}}, "between 0.001 and 30", "0.001～30"),
        (
            {"furniture": {"diameter": 0.4, "height": 1.8, "mass": 0.001}},
            "a mean density of 0.00445 kg/m³",
            "平均密度",
        ),
        (
            {"furniture": {"bottom": 0.1, "top": 0.2, "height": 0.3, "mass": 80_000.0}},
            "between 1 and 25,000 kg/m³",
            "平均密度",
        ),
        (
            {"furniture": [{"mesh": "cube.obj", "unit": "m", "mass": 800_000.0}]},
            "a mean density of 8e+05 kg/m³",
            "平均密度",
        ),
        ({"shaking": {"pga": 2937.0}}, "between 0.001 and 1000", "0.001～1000"),
        (
            {**OPENINGS, "windows": [WINDOW]},
            "windows[0] overlaps doors[0] by 0.5 m of the same wall",
            "重なって",
        ),
    ],
)
def test_what_no_room_has(tmp_path: Path, changed: dict[str, Any], english: str, japanese: str) -> None:
    (tmp_path / "cube.obj").write_text(CUBE)
    file = written(tmp_path, ONE | changed)
    assert english in printed(file)
    assert japanese in printed(file, "--lang", "ja")


def test_a_window_may_be_above_a_door() -> None:
    assert sp.FloorPlan(
        3.6, 2.7, [sp.Door("right_wall", 0.2, 0.8)], [sp.Window("right_wall", 0.5, 0.8, sill=1.9)]
    )


@pytest.mark.skipif(os.name != "posix", reason="pipes with names are those of POSIX")
def test_a_pipe_that_nobody_writes_to_is_not_waited_for(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.toml"
    os.mkfifo(pipe)
    assert both_print(pipe).split(";")[1:] == [" it could not be read: a device or a pipe.\n"]
    assert printed(pipe, "--lang", "ja").endswith("：読み込めませんでした（デバイスまたはパイプ）。\n")

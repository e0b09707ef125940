"""Scenario: every key wrong in turn, and what right keys make."""

import dataclasses
import datetime
import math
import re

import pytest

import stayput as sp
from stayput.errors import InputError
from stayput.model.body import FURNITURE
from stayput.scenario import Scenario, read
from stayput.scenario.toml import kinds

SCHEMA = Scenario.schema()
LEAST = {"furniture": {"preset": "bookcase"}}
NEEDED = {  # what must stand beside a key so that only that key is wrong
    "room.left_wall": {"gap": 0.1},
    "room.right_wall": {"gap": 0.1},
    "room.near_side_wall": {"gap": 0.1},
    "room.far_side_wall": {"gap": 0.1},
    "room.ceiling": {"height": 2.4},
    "shaking.sine": {"amplitude": 1.0, "frequency": 1.0},
    "shaking.earthquake": {"magnitude": 7.0, "distance": 20.0},
    "shaking.sa": {"period": 0.3, "value": 8.0},
    "furniture": {"preset": "bookcase"},
    "plan": {"width": 3.0, "length": 3.0},
}


def keys(node=SCHEMA, place=()):
    for kind in kinds(node, SCHEMA):
        for name, child in kind.get("properties", {}).items():
            yield ".".join((*place, name)), kinds(child, SCHEMA)
            yield from keys(child, (*place, name))


def with_key(dotted, value):
    data = {name: dict(table) for name, table in LEAST.items()}
    table, place = data, []
    for name in dotted.split(".")[:-1]:
        place.append(name)
        table[name] = {**NEEDED.get(".".join(place), {}), **table.get(name, {})}
        table = table[name]
    table[dotted.split(".")[-1]] = value
    return data


def wrong_values(allowed):
    types = {kind.get("type") for kind in allowed}
    yield datetime.date(2011, 3, 11)
    yield "" if "string" in types else "0.4"
    others = {"number": 3.5, "boolean": True, "object": {"value": 1}, "array": [1.0, 2.0, 3.0]}
    yield from (value for kind, value in others.items() if kind not in types)
    if "array" in types:
        yield [1.0, "a"]
        if any(kind.get("minItems") for kind in allowed):
            yield []
    for kind in allowed:
        if kind.get("type") == "number":
            yield from (math.nan, math.inf, kind["minimum"] - 1.0, 2.0 * kind["maximum"] + 1.0)
        if "enum" in kind:
            yield "no such name"


ALL_KEYS = dict(keys())


def test_the_walk_finds_the_keys():
    assert {"gravity", "furniture.cg_offset", "room.floor.restitution", "shaking.sine.dt"} <= set(ALL_KEYS)
    assert len(ALL_KEYS) > 100


@pytest.mark.parametrize("dotted", ALL_KEYS)
def test_a_wrong_value_is_refused_with_its_key_in_one_sentence(dotted):
    values = list(wrong_values(ALL_KEYS[dotted]))
    assert len(values) > 2
    for value in values:
        with pytest.raises(InputError) as refused:
            Scenario.parse(with_key(dotted, value))
        assert re.fullmatch(rf"{re.escape(dotted)}.* must be .*\.", str(refused.value)), value


@pytest.mark.parametrize("dotted", [d for d, allowed in ALL_KEYS.items() if len(d.split(".")[-1]) > 3])
def test_a_misspelt_key_is_refused_with_the_right_one(dotted):
    head, _, last = dotted.rpartition(".")
    misspelt = ".".join(filter(None, (head, last[:-2] + last[-1] + last[-2] + "x")))
    with pytest.raises(InputError, match=rf"^{misspelt} is unknown \(did you mean '\w+'\?\)"):
        Scenario.parse(with_key(misspelt, 1.0))


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ({}, "^furniture is missing"),
        ({"furniture": {"width": 0.4, "mass": 10.0}}, "^furniture.height is missing"),
        (
            {"furniture": {"preset": "bookcase", "cg_offset": [0.2, 0.0]}},
            r"^In \[furniture\]: .*inside the section",
        ),
        ({"furniture": {"preset": "chest", "shelves": [1.0]}}, "^furniture.mass is missing"),
        (
            {"furniture": {"preset": "bookcase", "shelves": [1.0], "inertia": 3.0}},
            "^furniture.inertia is given beside furniture.shelves",
        ),
        (
            {**LEAST, "room": {"floor": {"static_friction": 0.1}}},
            r"^In \[room.floor\]: .*kinetic friction is 0.3",
        ),
        ({**LEAST, "room": {"left_wall": {}}}, "^room.left_wall.gap is missing"),
        (
            {**LEAST, "dimensions": 2, "room": {"far_side_wall": {"gap": 0.1}}},
            "^dimensions is 2; it must be 3 for a wall at the side, room.far_side_wall",
        ),
        ({**LEAST, "shaking": {"builtin": "near-fault", "record": "a"}}, "^shaking.builtin is given beside"),
        ({**LEAST, "shaking": {"unit": "gal"}}, "^shaking.unit is given without"),
        (
            {**LEAST, "shaking": {"vertical": "up.txt"}},
            "^shaking.vertical is 'up.txt'; it must be true or false without",
        ),
        ({**LEAST, "shaking": {"sine": {"amplitude": 1.0, "frequency": 90.0}}}, r"^In \[shaking.sine\]: "),
        ({"furniture": {"preset": "book case"}}, "did you mean 'bookcase'"),
    ],
)
def test_what_contradicts_itself_is_refused(data, message):
    with pytest.raises(InputError, match=message):
        Scenario.parse(data)


def test_a_preset_and_its_overrides():
    chest, own = FURNITURE["chest"], {"mass": 50, "cg_offset": [0.0, -0.1], "base": "feet"}
    case = Scenario.parse({"furniture": {"preset": "chest", **own}}).case()
    sizes = chest.width, chest.height, 50.0
    assert case.body == sp.Body(*sizes, (0.0, -0.1), length=chest.length, base="feet")
    assert case.room == sp.Room(sp.Floor.of("wood flooring"))
    assert case.motion == sp.near_fault()
    assert (case.contact, case.initial, case.gravity) == ("coulomb", sp.State(), 9.80665)


def test_shelves_make_the_bookcase_of_their_loads():
    scenario = Scenario.parse(
        {"furniture": {"preset": "bookcase", "shelves": [30, 20, 10], "base_heights": [0, 0]}}
    )
    loaded = sp.Body.bookcase(0.30, 1.80, 35.0, [30.0, 20.0, 10.0])
    assert scenario.case().body == dataclasses.replace(loaded, length=0.80, base="edges")


def test_the_length_across_the_shaking_is_the_preset_s_or_one_s_own():
    furniture = {"width": 0.3, "height": 1.8, "mass": 100.0}
    assert Scenario.parse({"furniture": furniture}).case().body.length is None
    assert Scenario.parse({"furniture": {**furniture, "length": 0.9}}).case().body.length == 0.9
    assert Scenario.parse({"furniture": {"preset": "bookcase", "length": 0.9}}).case().body.length == 0.9


def test_every_table_arrives_in_the_case():
    data = {
        "furniture": {"width": 0.5, "height": 1.5, "mass": 80, "inertia": 20, "base_heights": [0, -0.005]},
        "room": {
            "floor": {"surface": "carpet", "restitution": 0.9, "edge_static_friction": 0.6},
            "left_wall": {"gap": 0.1, "restitution": 0.2, "friction": 0.1},
            "right_wall": {"gap": 0.2},
            "ceiling": {"height": 2.4},
        },
        "shaking": {"sine": {"amplitude": 2, "frequency": 1, "duration": 5, "phase": 0.5}, "scale": -2.0},
        "gravity": 9.81,
        "initial": {"tilt": 0.01, "tilt_rate": 0.1, "slide": 0.02, "slide_rate": 0.2},
    }
    case = Scenario.parse(data).case()
    assert case.body == sp.Body(0.5, 1.5, 80.0, inertia=20.0, base_heights=(0.0, -0.005))
    assert case.room.floor == sp.Floor(0.55, 0.45, edge_static_friction=0.6, restitution=0.9, settlement=1e-3)
    assert case.room.left_wall == sp.Wall(0.1, 0.2, 0.1)
    assert case.room.right_wall == sp.Wall(0.2)
    assert case.room.ceiling == sp.Ceiling(2.4)
    assert case.motion == sp.sine(2.0, 1.0, 5.0, 0.5).scaled(-2.0)
    assert (case.contact, case.gravity) == ("coulomb", 9.81)
    assert case.initial == sp.State(0.01, 0.1, 0.02, 0.2)


def test_a_record_stands_beside_its_scenario(tmp_path, monkeypatch):
    folder = tmp_path / "somewhere"
    folder.mkdir()
    (folder / "record.txt").write_text("\n".join(f"{k * 0.01:.2f} {k % 3}" for k in range(50)))
    (folder / "up.txt").write_text("\n".join(f"{k * 0.01:.2f} {k % 5}" for k in range(50)))
    file = folder / "scenario.toml"
    text = '[furniture]\npreset = "chest"\n[shaking]\nrecord = "record.txt"\nunit = "gal"\n'
    monkeypatch.chdir(tmp_path)
    file.write_text(text)
    plain = read(file).case().motion
    assert plain.x[:4] == pytest.approx([0.0, 0.01, 0.02, 0.0])
    assert plain.z is None
    file.write_text(text + 'vertical = "up.txt"\nscale = 2.0\n')
    both = read(file).case().motion
    assert both.x[1] == pytest.approx(0.02)
    assert both.z[4] == pytest.approx(0.08)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"title = ", "must be TOML"),
        (b"title = '\xff'", "UTF-8"),
        (b"[furniture]\nwidth = -1\n", r"^s\.toml: furniture.width is -1"),
    ],
)
def test_a_file_that_is_refused(tmp_path, content, message):
    file = tmp_path / "s.toml"
    file.write_bytes(content)
    with pytest.raises(InputError, match=message):
        read(file)


def test_a_file_with_a_byte_order_mark_is_read(tmp_path):
    file = tmp_path / "s.toml"
    file.write_bytes(b"\xef\xbb\xbf[furniture]\npreset = 'chest'\n")
    assert read(file).piece.title == "chest"

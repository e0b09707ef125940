"""Floors, structures, furniture and contents by what people call them, wherever they are named."""

import json

import pytest
from typer.testing import CliRunner

import stayput as sp
from stayput.building.building import STRUCTURES
from stayput.catalogue import names
from stayput.cli import app
from stayput.contents.contents import CONTENTS, Contents
from stayput.inventory.scenarios import stated_building
from stayput.model.body import FURNITURE
from stayput.model.room import SURFACES
from stayput.vocabulary import OTHER_NAMES, TATAMI, WORDS, meant, plain_word

KINDS = {
    "preset": (FURNITURE, names.FURNITURE),
    "floor": (SURFACES, names.SURFACES),
    "contents": (CONTENTS, names.CONTENTS),
    "structure": (STRUCTURES, names.STRUCTURES),
    "intensity": (names.INTENSITIES, names.INTENSITIES),
}


@pytest.mark.parametrize("kind", KINDS)
def test_every_preset_is_meant_by_its_names_and_no_word_by_two(kind):
    presets, labels = KINDS[kind]
    assert set(WORDS[kind].values()) == set(presets)
    for preset in presets:
        assert meant(kind, preset) == preset
        assert meant(kind, labels[preset][1]) == preset
    for word, preset in OTHER_NAMES[kind].items():
        assert WORDS[kind][plain_word(word)] == preset


@pytest.mark.parametrize(
    ("word", "surface"),
    [
        ("フローリング", "wood flooring"),
        ("Carpet", "carpet"),
        ("畳", TATAMI),
        ("畳(目に直交する方向)", "tatami, across the weave"),
    ],
)
def test_a_floor_by_what_people_call_it(word, surface):
    assert sp.Floor.of(word) == sp.Floor.of(surface)
    assert sp.Floor.of(word).surface == surface
    for floor in (word, {"surface": word}):
        scenario = sp.Scenario.parse({"furniture": {"preset": "本棚"}, "room": {"floor": floor}})
        assert scenario.room.room().floor.surface == surface
    assert scenario.piece.preset == "bookcase"


@pytest.mark.parametrize(
    ("word", "structure"), [("木造", "wood"), ("Ｓ造", "steel"), ("rc造", "RC"), ("鉄筋コンクリート造", "RC")]
)
def test_a_structure_by_what_people_call_it(word, structure):
    assert sp.Building(5, word) == sp.Building(5, structure)
    assert sp.Building(5, word).name == f"5-storey {structure} building"
    for text in (f"5 {word}", f"5階建て{word}", f"{word}5階建て", f"5,{word}"):
        building = stated_building(text)
        assert building is not None
        assert building.building() == sp.Building(5, structure)


def test_other_names_of_buildings_are_no_structures():
    assert [stated_building(name) for name in ("3号館", "10 本館", "2S", "SRC造5階建て")] == [None] * 4
    with pytest.raises(sp.InputError, match=r"structure is 'SRC'.* it must be one of 'RC', 'steel'"):
        stated_building("10 SRC")


def test_contents_by_what_people_call_them():
    assert Contents("食器").kind == "dishes"
    with pytest.raises(sp.InputError, match="did you mean 'books'"):
        Contents("boks")


def test_the_command_line_takes_what_people_say_in_any_language():
    def simulated(*flags):
        done = CliRunner().invoke(app, ["simulate", "--motion", "sine:3,1,2", "--json", *flags])
        assert done.exit_code == 0, done.output
        return done.stdout

    assert simulated("--floor", "畳") == simulated("--floor", TATAMI, "--lang", "ja")
    storey = ("--storey", "3", "--building")
    assert simulated(*storey, "5,木造") == simulated(*storey, "5,wood")
    done = CliRunner().invoke(app, ["motion", "info", "sine:1,1,2", "--building", "3,鉄骨造", "--json"])
    assert json.loads(done.stdout)["building"] == "3-storey steel building"


@pytest.mark.parametrize(("word", "near"), [("tatam", "tatami"), ("カーペト", "カーペット")])
def test_a_floor_that_is_not_known_is_refused_with_what_is_like_it(word, near):
    with pytest.raises(
        sp.InputError, match=rf"'{word}' \(did you mean '{near}'\?\); it must be one of 'wood"
    ):
        sp.Floor.of(word)
    done = CliRunner().invoke(app, ["simulate", "--floor", word])
    assert done.stderr.startswith(f"room.floor is '{word}' (did you mean '{near}'?); it must be one of 'wood")
    assert done.stderr.endswith("'locked caster'.\n")
    done = CliRunner().invoke(app, ["simulate", "--floor", word, "--lang", "ja"])
    assert f"'{near}'ではありませんか" in done.stderr


@pytest.mark.parametrize(
    ("part", "value", "example"),
    [
        ("floor", "mud", r"Floor.of\('wood flooring'\)"),
        ("left_wall", 0.05, r"Wall\(gap=0.02\)"),
        ("far_side_wall", "brick", r"Wall\(gap=0.02\)"),
        ("ceiling", 2.5, r"Ceiling\(height=2.4\)"),
    ],
)
def test_a_part_of_a_room_of_another_type_is_refused_with_what_to_write(part, value, example):
    with pytest.raises(
        sp.InputError, match=rf"{part} is {value!r}; it must be a value such as {example}\."
    ) as caught:
        sp.Room(**{part: value})
    assert "のような" in caught.value.told("ja")

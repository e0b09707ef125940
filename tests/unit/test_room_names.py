"""What pieces, places and doors of a room are called, in the language of the reader."""

from __future__ import annotations

import pytest

import stayput as sp
from stayput.rooms.words import door_name, piece_name, piece_within, place_name


@pytest.mark.parametrize("name", ["chest 2", "Chest of drawers 2", "整理だんす 2"])
def test_default_names_with_numbers_are_translated(name: str):
    assert piece_name(name) == ("chest of drawers 2", "整理だんす2")
    assert piece_within(name) == ("chest of drawers 2", "「整理だんす2」")


@pytest.mark.parametrize("name", ["Dad's chest 2", "chest two", "chest ２", "2", "chest2", "Chest"])
def test_names_of_the_user_s_own_stay_as_they_are(name: str):
    assert piece_name(name) == (name, name)


def test_places_and_doors_with_numbers_are_translated():
    assert place_name(sp.PersonPlace.of("desk", (1.0, 1.0), name="desk 2")) == ("desk 2", "机2")
    assert door_name(sp.Door("left_wall", 0.5, 0.8, name="door 2")) == ("door 2", "ドア2")

"""A verdict on a room as rows of texts and probabilities."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from stayput.catalogue import say
from stayput.montecarlo.counting import OVERTURNED, SLID
from stayput.report.verdict import numbers
from stayput.rooms.words import change_label, door_name, piece_name, place_name, tags

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.fragility import Probability
    from stayput.montecarlo.counting import Quantiles
    from stayput.rooms.verdict import ChangeVerdict, RoomVerdict


KINDS = ("better", "chance", "worse")
"""What can be said of a change: that it clearly helps, nothing, or that something clearly gets worse."""


class PlaceRow(NamedTuple):
    """A place of a person as it is read.

    Parameters
    ----------
    name : str
        What it is called.
    hit : Probability
        That any piece hits who is there.
    times : tuple of (str, str)
        By day and at night: how often somebody is there and hit, and how often somebody is there.
    shut_in : Probability
        That no way leads out from there.
    """

    name: str
    hit: Probability
    times: tuple[tuple[str, str], ...]
    shut_in: Probability


class HitRow(NamedTuple):
    """What hits a place, as it is read: the median and the 90 % quantile of its speed and energy."""

    place: str
    piece: str
    chance: Probability
    speed: tuple[str, str]
    energy: tuple[str, str]
    mass: str


class DoorRow(NamedTuple):
    """A door as it is read."""

    name: str
    wall: str
    opens: str
    leads_out: str
    blocked: Probability
    at_rest: bool


class PieceRow(NamedTuple):
    """A piece as it is read: its slide is the median and the 90 % quantile of the peak."""

    name: str
    overturned: Probability
    slid: Probability
    slide: tuple[str, str]
    risk: str
    engine: str


class ChangeRow(NamedTuple):
    """A single change as it is read.

    Parameters
    ----------
    label : str
        What it consists of.
    kind : str
        What can be said of it, of `KINDS`.
    tags : tuple of str
        What is clearly better or worse with it.
    hit, shut_in : Probability
        That a place is hit, and that no way leads out from one.
    hit_change, shut_in_change : str
        Their differences from the room as it is.
    overturned : Probability or None
        That the piece overturns; None of a place.
    overturned_change : str
        Its difference from the room as it is.
    risk : str
        How often somebody is hit, by the hours that people are at each place.
    """

    label: str
    kind: str
    tags: tuple[str, ...]
    hit: Probability
    hit_change: str
    shut_in: Probability
    shut_in_change: str
    overturned: Probability | None
    overturned_change: str
    risk: str


def place_rows(verdict: RoomVerdict, language: str) -> list[PlaceRow]:
    """Return the places in the order of the file."""
    return [
        PlaceRow(
            say(place_name(one.place), language),
            one.hit,
            tuple(
                (numbers.share(chance, language), _own("presence", language, numbers.share(there, language)))
                for chance, there in ((one.by_day, one.place.day), (one.by_night, one.place.night))
            ),
            one.shut_in,
        )
        for one in verdict.places
    ]


def _own(key: str, language: str, share: str) -> str:
    return say(f"room_report.{key}", language, share=share)


def hit_rows(verdict: RoomVerdict, language: str) -> list[HitRow]:
    """Return what hits each place, the most frequent first."""
    return [
        HitRow(
            say(place_name(place.place), language),
            say(piece_name(hit.piece), language),
            hit.probability,
            _two(hit.speed, numbers.speed),
            _two(hit.energy, numbers.energy),
            numbers.mass(hit.mass),
        )
        for place in verdict.places
        for hit in place.by
    ]


def _two(quantiles: Quantiles, show: Callable[[float], str]) -> tuple[str, str]:
    return show(quantiles.median), show(quantiles.p90)


def door_rows(verdict: RoomVerdict, language: str) -> list[DoorRow]:
    """Return the doors in the order of the file."""
    return [
        DoorRow(
            say(door_name(one.door), language),
            say(f"rooms.{one.door.wall}", language),
            say(f"room_report.{one.door.opens}", language),
            say(f"room_report.{'yes' if one.door.way_out else 'no'}", language),
            one.blocked,
            one.at_rest,
        )
        for one in verdict.doors
    ]


def piece_rows(verdict: RoomVerdict, language: str) -> list[PieceRow]:
    """Return the pieces, those that contribute most first."""
    room = verdict.scenario.surroundings()
    return [
        PieceRow(
            say(piece_name(one.name), language),
            one.probabilities[OVERTURNED],
            one.probabilities[SLID],
            numbers.slides(one.slide, room, language),
            numbers.share(one.risk, language) if verdict.places else numbers.NO_NUMBER,
            say(f"room_report.{'in_plane' if one.in_plane else 'in_space'}", language),
        )
        for one in verdict.pieces
    ]


def collision_rows(verdict: RoomVerdict, language: str) -> list[tuple[str, str, Probability]]:
    """Return the pairs of pieces that meet, the most frequent first."""
    rows = [
        (say(piece_name(first), language), say(piece_name(second), language), chance)
        for (first, second), chance in verdict.collisions.items()
        if chance.fell
    ]
    return sorted(rows, key=lambda row: -row[2].estimate)


def change_rows(verdict: RoomVerdict, language: str) -> list[ChangeRow]:
    """Return the single changes: those that clearly help, the best first, then the others."""
    rows: list[ChangeRow] = []
    for one in verdict.changes:
        own, change = verdict.piece_changed(one) or (None, None)
        rows.append(
            ChangeRow(
                change_label(one.change, verdict, language),
                _kind(one),
                tuple(say(tag, language) for tag in tags(one)),
                one.hit,
                numbers.change(one.hit_change, language),
                one.shut_in,
                numbers.change(one.shut_in_change, language),
                own,
                "" if change is None else numbers.change(change, language),
                numbers.share(one.risk, language),
            )
        )
    return sorted(rows, key=lambda row: KINDS.index(row.kind))


def _kind(one: ChangeVerdict) -> str:
    if one.helps:
        return "better"
    return "worse" if one.worse else "chance"
